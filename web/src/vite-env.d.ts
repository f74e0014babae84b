/// <reference types="svelte" />
/// <reference types="vite/client" />

/** What wasm-bindgen puts between the engine and the page, without the engine. */
declare module '*/cogmap_wasm_bg.js' {
  export function __wbg_set_wasm(engine: WebAssembly.Exports): void;
}
