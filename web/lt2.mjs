import { chromium } from '@playwright/test';
const url = process.argv[2] ?? 'http://127.0.0.1:9301/';
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const p0 = await browser.newPage(); await p0.waitForTimeout(3000);
for (let k=0;k<7;k++) {
const context = await browser.newContext();
const page = await context.newPage();
await browser.startTracing(page, { categories: ['toplevel','__metadata'].concat(process.argv[3]?['devtools.timeline','v8']:[]) });
await page.goto(url);
await page.waitForTimeout(2500);
const ev = JSON.parse((await browser.stopTracing()).toString()).traceEvents;
const main = new Map(ev.filter(e=>e.name==='thread_name').map(e=>[e.pid+':'+e.tid,e.args.name]));
const mains=[...main].filter(([,n])=>n==='CrRendererMain').map(([k])=>k);
console.log('=== opening',k);
const t0=Math.min(...ev.filter(e=>e.ts).map(e=>e.ts));
for (const m of mains) { const mine=ev.filter(e=>e.ph==='X'&&e.pid+':'+e.tid===m).sort((a,b)=>a.ts-b.ts);
 for (const t of mine.filter(e=>/RunTask$/.test(e.name)&&(e.dur>25000||e.tdur>10000))) {
  console.log(`  ${m} at ${((t.ts-t0)/1e3).toFixed(0)} wall ${(t.dur/1e3).toFixed(0)} own ${(t.tdur/1e3).toFixed(0)} ${JSON.stringify(t.args).slice(0,140)}`);
  for (const c of mine.filter(e=>e!==t&&e.ts>=t.ts&&e.ts+e.dur<=t.ts+t.dur&&e.dur>6000&&!/RunTask$/.test(e.name)).slice(0,6)) console.log('       ',c.name,(c.dur/1e3).toFixed(0),((c.tdur??0)/1e3).toFixed(0));
 } }
await context.close(); }
await browser.close();
