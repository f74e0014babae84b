// Parts the engine in two: `first.wasm` has what the page needs until somebody drives, `rest.wasm` all else.
// Both use one memory, one table and the same globals. A function that is in the rest is an import of the first
// part, and the page's loader (`src/worker/engine.ts`) fetches the rest when one is called.
//
// node engine/split.mjs FOLDER: reads FOLDER/engine.wasm, with names; `first.txt` says what goes into the first part.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import binaryen from 'binaryen';
import { listed, plain } from './names.mjs';
import { DATA, DATA_COUNT, without } from './sections.mjs';

const folder = process.argv[2];
const whole = readFileSync(join(folder, 'engine.wasm'));
const wanted = listed(join(import.meta.dirname, 'first.txt'));

const original = binaryen.readBinary(whole);
const functions = defined(original);
const slots = slotsOf(original);
const globals = each(original.getNumGlobals(), (k) => binaryen.getGlobalInfo(original.getGlobalByIndex(k)));
const tables = each(original.getNumTables(), (k) => binaryen.getTableInfo(original.getTableByIndex(k)).name);
const memory = exportedMemory(original);
original.dispose();

const short = new Map([...functions.keys()].map((name, k) => [name, `f${k}`]));
const first = firstOf();
// What only the rest calls is not in the first part, wanted or not.
const kept = defined(first);
const rest = restOf(imported(first, 'rest'));
for (const name of imported(rest, 'first')) first.addFunctionExport(name, short.get(name));

write('first.wasm', first, []);
// The memory has its contents already.
write('rest.wasm', rest, [DATA, DATA_COUNT]);

/** The functions of a module that are not imported, by name. */
function defined(module) {
  const all = each(module.getNumFunctions(), (k) => binaryen.getFunctionInfo(module.getFunctionByIndex(k)));
  return new Map(all.filter((info) => info.module === '').map((info) => [info.name, info]));
}

/** The names of the functions that a module imports from another. */
function imported(module, from) {
  const all = each(module.getNumFunctions(), (k) => binaryen.getFunctionInfo(module.getFunctionByIndex(k)));
  return all.filter((info) => info.module === from).map((info) => info.name);
}

function exports(module) {
  return each(module.getNumExports(), (k) => binaryen.getExportInfo(module.getExportByIndex(k)));
}

/** What the module calls its memory, which it exports as `memory`. */
function exportedMemory(module) {
  return exports(module).find(({ name }) => name === 'memory').value;
}

/** The table of functions, and the segment that fills it: names, the first entry, and the functions in it. */
function slotsOf(module) {
  const segments = each(module.getNumElementSegments(), (k) => binaryen.getElementSegmentInfo(module.getElementSegmentByIndex(k)));
  if (segments.length !== 1) throw new Error(`expected one segment of the table, found ${segments.length}`);
  const [{ name: segment, table, offset, data }] = segments;
  return { segment, table, begin: binaryen.getExpressionInfo(offset).value, names: data };
}

/** The whole module, whose functions that `away` tells of have become imports from the other part. */
function parted(away, other) {
  const module = binaryen.readBinary(whole);
  for (const [name, { params, results }] of functions) {
    if (!away(name)) continue;
    module.removeFunction(name);
    module.addFunctionImport(name, other, short.get(name), params, results);
  }
  module.removeElementSegment(slots.segment);
  return module;
}

/** The first part: it has the table's entries, of which those of the rest are stand-ins at first. */
function firstOf() {
  const module = parted((name) => !wanted.has(plain(name)), 'rest');
  module.addActiveElementSegment(slots.table, 'all', slots.names, module.i32.const(slots.begin));
  tables.forEach((name, k) => module.addTableExport(name, `t${k}`));
  globals.forEach(({ name }, k) => module.addGlobalExport(name, `g${k}`));
  module.runPasses(['remove-unused-module-elements']);
  return module;
}

/** The second part: it exports the functions that the first calls, and enters its own into the table. */
function restOf(called) {
  const module = parted((name) => kept.has(name), 'first');
  for (const { name } of exports(module)) module.removeExport(name);
  module.addMemoryImport(memory, 'first', 'memory', false);
  tables.forEach((name, k) => module.addTableImport(name, 'first', `t${k}`));
  globals.forEach(({ name, type, mutable }, k) => module.addGlobalImport(name, 'first', `g${k}`, type, mutable));
  for (const name of called) module.addFunctionExport(name, short.get(name));
  enter(module);
  module.runPasses(['remove-unused-module-elements']);
  return module;
}

/** Puts runs of functions of the second part into the table. */
function enter(module) {
  let run = [];
  slots.names.forEach((name, k) => {
    if (!kept.has(name)) run.push(name);
    const ends = kept.has(name) || k + 1 === slots.names.length;
    if (!ends || run.length === 0) return;
    const begin = slots.begin + k + (kept.has(name) ? 0 : 1) - run.length;
    module.addActiveElementSegment(slots.table, `run${k}`, run, module.i32.const(begin));
    run = [];
  });
}

function write(name, module, left) {
  if (!module.validate()) throw new Error(`${name} is no valid module`);
  binaryen.setDebugInfo(false);
  writeFileSync(join(folder, name), without(module.emitBinary(), left));
}

function each(count, get) {
  return Array.from({ length: count }, (_, k) => get(k));
}
