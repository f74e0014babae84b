// Runs the wasm module given as the first argument; the second is a log, or `-`. Each line of the input
// asks for something: `prepare TASK` gives the units of a run, `run` its milliseconds and its sum.
import { readFile } from "node:fs/promises";
import { createInterface } from "node:readline";

const [path, log] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(await readFile(path), {});
const { feed, prepare, rewind, run } = instance.exports;

if (log !== "-") {
  for (const byte of await readFile(log)) feed(byte);
}
for await (const line of createInterface({ input: process.stdin })) {
  const [what, task] = line.split(" ");
  if (what === "prepare") {
    console.log(prepare(Number(task)));
  } else {
    rewind();
    const start = performance.now();
    const sum = run();
    console.log(performance.now() - start, sum);
  }
}
