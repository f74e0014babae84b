import { mount } from 'svelte';
import App from './App.svelte';
import { Address } from './keep/address';
import { Lab } from './state/lab.svelte';
import { turn } from './state/turn';
import { language } from './strings';
import './styles/tokens.css';
import './styles/base.css';
import './styles/parts.css';

const target = document.getElementById('app');
const address = new Address(location);
await language.begin(address.language);
await turn();
const lab = new Lab(address);
await turn();
if (target) mount(App, { target, props: { address, lab } });
