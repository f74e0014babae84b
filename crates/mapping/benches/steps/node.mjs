// Times the wasm module given as the first argument. The second is a log, or `-`; the others are
// task:rounds. Each gives a line `steps microseconds sum`, the time being that of a step in the best round.
import { readFile } from "node:fs/promises";

const [path, log, ...rows] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(await readFile(path), {});
const { feed, prepare, rewind, run } = instance.exports;

if (log !== "-") {
  for (const byte of await readFile(log)) feed(byte);
}
for (const row of rows) {
  const [task, rounds] = row.split(":").map(Number);
  const steps = prepare(task);
  let best = Infinity;
  let sum = 0;
  for (let round = 0; round < rounds; round += 1) {
    rewind();
    const start = performance.now();
    sum = run();
    best = Math.min(best, performance.now() - start);
  }
  console.log(steps, (best * 1000) / Math.max(steps, 1), sum);
}
