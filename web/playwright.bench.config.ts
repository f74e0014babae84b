import { defineConfig } from '@playwright/test';
import tests from './playwright.config';

/** What is measured rather than tested: it prints numbers and fails only if it cannot. */
export default defineConfig({
  ...tests,
  testMatch: '*.bench.ts',
  timeout: 300_000,
  retries: 0,
  // As whoever opens the page has it.
  use: { ...tests.use, serviceWorkers: 'allow' },
});
