import { mount } from 'svelte';
import App from './App.svelte';
import { Address } from './keep/address';
import { Lab } from './state/lab.svelte';
import { turn } from './state/turn';
import { language } from './strings';
import './styles/tokens.css';
import './styles/base.css';

/** By then the page has opened, milliseconds. */
const AT_EASE = 3000;

const target = document.getElementById('app');
const address = new Address(location);
await language.begin(address.language);
await turn();
const lab = new Lab(address);
await turn();
if (target) mount(App, { target, props: { address, lab } });

if (import.meta.env.PROD && 'serviceWorker' in navigator) {
  // Keeps the page's own files, so that it opens without a network from the second visit on; it fetches them all,
  // which can wait until the page has opened.
  setTimeout(() => void navigator.serviceWorker.register('./sw.js'), AT_EASE);
}
