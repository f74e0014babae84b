// Times the wasm module given as the first argument. The others are rows of
// size:method:batches:rounds:scans of a batch; each gives a line
// `segments microseconds sum`, the time being that of a scan, from each batch's
// best round.
import { readFile } from "node:fs/promises";

const [path, ...rows] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(await readFile(path), {});
const { prepare, run } = instance.exports;

let built = -1;
let segments = 0;
for (const row of rows) {
  const [size, method, batches, rounds, scans] = row.split(":").map(Number);
  if (size !== built) {
    segments = prepare(size);
    built = size;
  }
  const best = new Float64Array(batches).fill(Infinity);
  const sums = new Float64Array(batches);
  for (let round = 0; round < rounds; round += 1) {
    for (let batch = 0; batch < batches; batch += 1) {
      const start = performance.now();
      sums[batch] = run(method, batch * scans);
      best[batch] = Math.min(best[batch], performance.now() - start);
    }
  }
  const total = (numbers) => numbers.reduce((sum, number) => sum + number, 0);
  console.log(segments, (total(best) * 1000) / (batches * scans), total(sums));
}
