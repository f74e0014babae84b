import { chromium } from '@playwright/test';
const url = process.argv[2] ?? 'http://127.0.0.1:9301/';
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const p0 = await browser.newPage(); await p0.waitForTimeout(3000);
for (let k=0;k<(+process.argv[3]||3);k++) {
const context = await browser.newContext();
const page = await context.newPage();
await browser.startTracing(page, { categories: ['toplevel','__metadata','devtools.timeline','disabled-by-default-devtools.timeline','v8','blink'] });
await page.goto(url);
await page.waitForFunction(() => /[1-9]\d* surfaces?/.test(document.body.innerText));
await page.waitForTimeout(1500);
const ev = JSON.parse((await browser.stopTracing()).toString()).traceEvents;
const main = new Map(ev.filter(e=>e.name==='thread_name').map(e=>[e.pid+':'+e.tid,e.args.name]));
const mains=[...main].filter(([,n])=>n==='CrRendererMain').map(([k])=>k);
const busy = mains.map(k=>[k,ev.filter(e=>e.ph==='X'&&e.pid+':'+e.tid===k&&/RunTask$/.test(e.name)).reduce((s,e)=>s+e.dur,0)]).sort((a,b)=>b[1]-a[1])[0][0];
const mine = ev.filter(e=>e.ph==='X'&&e.pid+':'+e.tid===busy).sort((a,b)=>a.ts-b.ts);
const t0=mine[0].ts;
console.log('=== opening',k);
for (const t of mine.filter(e=>/RunTask$/.test(e.name)&&(e.dur>25000||e.tdur>9000))) {
  console.log(`at ${((t.ts-t0)/1e3).toFixed(0)} wall ${(t.dur/1e3).toFixed(0)} own ${(t.tdur/1e3).toFixed(0)}`);
  const kids=mine.filter(e=>e!==t&&e.ts>=t.ts&&e.ts+e.dur<=t.ts+t.dur&&e.dur>4000&&!/RunTask$/.test(e.name));
  for (const c of kids.slice(0,14)) console.log('    ',c.name,(c.dur/1e3).toFixed(1),'own',((c.tdur??0)/1e3).toFixed(1),JSON.stringify(c.args?.data?.url??c.args?.data?.functionName??c.args?.beginData?.stackTrace?.[0]?.functionName??c.args?.fileName??'').slice(-50));
  // who else ran in that window
  const win=[t.ts,t.ts+t.dur]; const other=new Map();
  for (const e of ev) if (e.ph==='X'&&/RunTask$|ThreadPool_RunTask|BackgroundJob|Compile/.test(e.name)&&e.pid+':'+e.tid!==busy&&e.ts<win[1]&&e.ts+e.dur>win[0]) { const key=(main.get(e.pid+':'+e.tid)??'?')+' '+e.name; other.set(key,(other.get(key)??0)+(e.tdur??0)/1e3); }
  console.log('       others:',[...other].sort((a,b)=>b[1]-a[1]).slice(0,7).map(([n,d])=>`${n} ${d.toFixed(0)}`).join(' | '));
}
await context.close(); }
await browser.close();
