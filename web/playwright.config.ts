import { defineConfig } from '@playwright/test';

/** Where the page is served already; without it, the built page is served from `web/dist`. */
const served = process.env['COGMAP_URL'] || undefined;
const port = process.env['COGMAP_PORT'] ?? '4179';

/** Switches that keep the browser itself from talking to anybody. */
const silence = [
  '--no-sandbox',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-default-apps',
  '--disable-domain-reliability',
  '--disable-features=OptimizationHints,MediaRouter,Translate,AutofillServerCommunication',
  '--disable-sync',
  '--metrics-recording-only',
  '--no-first-run',
  '--no-pings',
];

export default defineConfig({
  testDir: '../tests/browser',
  outputDir: '../tests/browser/test-results',
  timeout: 60_000,
  expect: { timeout: 20_000 },
  forbidOnly: true,
  workers: 2,
  reporter: 'list',
  use: {
    // All of the page's files are fetched once more for it, beside every test: those about it ask for it.
    serviceWorkers: 'block',
    baseURL: served ?? `http://127.0.0.1:${port}`,
    launchOptions: {
      executablePath: process.env['CHROMIUM_PATH'] ?? '/usr/bin/chromium',
      args: silence,
    },
    // A trace takes two thirds as long as the test itself: `--trace on` makes one of a test that fails.
    trace: 'off',
  },
  ...(served
    ? {}
    : {
        webServer: {
          command: `npm run preview -- --host 127.0.0.1 --port ${port} --strictPort`,
          url: `http://127.0.0.1:${port}`,
        },
      }),
});
