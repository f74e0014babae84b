import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';
import { headers } from './policy.ts';

const description = 'A robot-mapping laboratory: drive a robot through a building and watch its memory grow.';

/** The development server writes scripts and styles into the page, which the policy forbids. */
const policyOnlyWhenBuilt: Plugin = {
  name: 'policy-only-when-built',
  apply: 'serve',
  transformIndexHtml: (html) => html.replace(/<meta\s+http-equiv="Content-Security-Policy"[^>]*>/, ''),
};

export default defineConfig({
  // Relative addresses: the built page runs from any folder of any static server.
  base: './',
  // What is not there is said to be missing.
  appType: 'mpa',
  preview: { headers: headers() },
  plugins: [
    // All of its options are the defaults.
    svelte({ configFile: false }),
    policyOnlyWhenBuilt,
    VitePWA({
      injectRegister: false,
      includeAssets: ['icon.svg'],
      workbox: {
        globPatterns: ['**/*.{html,js,css,wasm,svg,png,webmanifest}'],
        maximumFileSizeToCacheInBytes: 16 * 1024 * 1024,
        clientsClaim: true,
        skipWaiting: true,
        // Every address of this folder is the one page, whatever it asks for; other versions of the page, in
        // folders below this one, look after themselves.
        navigateFallback: null,
        ignoreURLParametersMatching: [/./],
        cleanupOutdatedCaches: true,
      },
      manifest: {
        name: 'Cogmap',
        short_name: 'Cogmap',
        description,
        display: 'standalone',
        background_color: '#f4f5f3',
        theme_color: '#f4f5f3',
        icons: [
          { src: 'icon.svg', sizes: 'any', type: 'image/svg+xml' },
          { src: 'icon-192.png', sizes: '192x192', type: 'image/png' },
          { src: 'icon-512.png', sizes: '512x512', type: 'image/png', purpose: 'any maskable' },
        ],
      },
    }),
  ],
  worker: { format: 'es' },
  build: {
    target: 'es2022',
    // The policy of the page allows nothing inline.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
});
