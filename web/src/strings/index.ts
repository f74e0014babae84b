export { ENGINE_LANGUAGE, language, LANGUAGES, strings, type Language } from './spoken.svelte';
