import { readFileSync } from 'node:fs';

/**
 * The headers that everything of the page is served with: the policy that `index.html` declares for itself.
 *
 * A tag binds the page but not its workers, and cannot carry `frame-ancestors`, which is added: lessons may embed the
 * page anywhere.
 */
export function headers(): Record<string, string> {
  const page = readFileSync(new URL('./index.html', import.meta.url), 'utf8');
  const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(page)?.[1];
  if (!policy) throw new Error('web/index.html declares no Content-Security-Policy: every page needs one');
  return {
    'Content-Security-Policy': `${policy.replace(/\s+/g, ' ')}; frame-ancestors *`,
    'Cache-Control': 'no-cache',
    'X-Content-Type-Options': 'nosniff',
  };
}
