import { expose } from 'comlink';
import { Bench } from './bench';

expose(new Bench());
