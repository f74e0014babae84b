// Times the wasm module given as the first argument. The others are rows of
// size:method:scans:rounds; each gives a line `segments microseconds sum`, the
// time being that of a scan in the best round.
import { readFile } from "node:fs/promises";

const [path, ...rows] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(await readFile(path), {});
const { prepare, run } = instance.exports;

let built = -1;
let segments = 0;
for (const row of rows) {
  const [size, method, scans, rounds] = row.split(":").map(Number);
  if (size !== built) {
    segments = prepare(size);
    built = size;
  }
  let best = Infinity;
  let sum = 0;
  for (let round = 0; round < rounds; round += 1) {
    const start = performance.now();
    sum = run(method, scans);
    best = Math.min(best, performance.now() - start);
  }
  console.log(segments, (best * 1000) / scans, sum);
}
