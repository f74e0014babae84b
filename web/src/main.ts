import { mount } from 'svelte';
import App from './App.svelte';
import { Address } from './keep/address';
import { turn } from './state/turn';
import { language } from './strings';
import { number } from './strings/words';
import './styles/tokens.css';
import './styles/base.css';

const target = document.getElementById('app');
await language.begin(new Address(location).language);
await turn();
// The first number takes the browser as long as a part of the page.
number(0, 1);
await turn();
if (target) mount(App, { target });

if (import.meta.env.PROD && 'serviceWorker' in navigator) {
  // Keeps the page's own files, so that it opens without a network from the second visit on.
  void navigator.serviceWorker.register('./sw.js');
}
