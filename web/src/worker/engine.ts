import * as glue from '../wasm/cogmap_wasm_bg.js';
import firstPart from '../wasm/first.wasm?url';
import theRest from '../wasm/rest.wasm?url';

/**
 * The engine comes in two parts. The first is all that the page needs until somebody drives; it calls functions of
 * the rest through stand-ins, the first of which fetches the rest if it has not come by then.
 */
let first: WebAssembly.Exports = {};
let rest: WebAssembly.Exports | undefined;

/** Loads the first part; until then nothing of the engine may be called. */
export async function begin(): Promise<void> {
  const module = await compiled(firstPart);
  ({ exports: first } = await WebAssembly.instantiate(module, { './cogmap_wasm_bg.js': glue, rest: standIns(module) }));
  glue.__wbg_set_wasm(first);
  called(first['__wbindgen_start'])();
}

/** Loads the rest beside whatever else happens. What fails here is tried again when the rest is called. */
export async function complete(): Promise<void> {
  const module = await compiled(theRest).catch(() => undefined);
  if (module) rest ??= joined(module);
}

/** For each function of the rest that the first part calls, one that calls it there. */
function standIns(module: WebAssembly.Module): WebAssembly.ModuleImports {
  const names = WebAssembly.Module.imports(module).flatMap((it) => (it.module === 'rest' ? [it.name] : []));
  const standIn = (name: string) => (...given: unknown[]) => called(restNow()[name])(...given);
  return Object.fromEntries(names.map((name) => [name, standIn(name)]));
}

/** The rest, waited for by all of this worker: what is called cannot be put off. */
function restNow(): WebAssembly.Exports {
  if (rest) return rest;
  const request = new XMLHttpRequest();
  request.open('GET', theRest, false);
  request.responseType = 'arraybuffer';
  try {
    request.send();
  } catch {
    throw new Error('the rest of the engine did not come: is the network there?');
  }
  if (request.status !== 200) throw new Error(`${request.status} ${request.statusText}: ${theRest}`);
  rest = joined(new WebAssembly.Module(request.response as ArrayBuffer));
  return rest;
}

function joined(module: WebAssembly.Module): WebAssembly.Exports {
  return new WebAssembly.Instance(module, { './cogmap_wasm_bg.js': glue, first }).exports;
}

/** A part, compiled while it comes where its server calls it WebAssembly. */
async function compiled(address: string): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}: ${address}`);
  if (response.headers.get('Content-Type') === 'application/wasm') return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

function called(value: WebAssembly.ExportValue | undefined): (...given: unknown[]) => unknown {
  if (typeof value !== 'function') throw new Error('the two parts of the engine are not of one build: reload the page');
  return value as (...given: unknown[]) => unknown;
}
