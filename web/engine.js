// The engine of the page: the layers as WebAssembly, in a worker of a browser or under node.
//   await start(); call({call: "version"}) → {durero: …}
// The module itself stands behind this text, as module_text: gzip, in base 64 (cmake/wasm/engine.sh).
// Its system has no files, no arguments and no randomness, but a clock.

const wasi_errno = { badf: 8, noent: 44, nosys: 52 };

// system: what the module imports. `memory` gives its memory as it is now, which grows.
function system(memory) {
  const view = () => new DataView(memory().buffer);
  const write_64 = (at, value) => view().setBigUint64(at, value, true);
  const nothing = counts => { for (const at of counts) view().setUint32(at, 0, true); return 0; };
  return {
    args_get: () => 0,
    args_sizes_get: (count, size) => nothing([count, size]),
    environ_get: () => 0,
    environ_sizes_get: (count, size) => nothing([count, size]),
    clock_res_get: (_clock, at) => { write_64(at, 1000000n); return 0; },
    clock_time_get: (_clock, _precision, at) => { write_64(at, BigInt(Date.now()) * 1000000n); return 0; },
    fd_write: (file, pieces, count, written) => {
      if (file !== 1 && file !== 2) return wasi_errno.badf;
      let size = 0, text = "";
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(pieces + 8 * i, true), length = view().getUint32(pieces + 8 * i + 4, true);
        text += new TextDecoder().decode(new Uint8Array(memory().buffer, at, length));
        size += length;
      }
      console.error(text);
      view().setUint32(written, size, true);
      return 0;
    },
    path_open: () => wasi_errno.noent,
    path_filestat_get: () => wasi_errno.noent,
    proc_exit: status => { throw new Error("the module ended with status " + status); },
  };
}

// imports: what the module asks for; what the list above has not says that it is not there.
function imports(module, memory) {
  const known = system(memory);
  const named = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    named[from] ??= {};
    named[from][name] = known[name] ?? (name.startsWith("fd_") ? () => wasi_errno.badf : () => wasi_errno.nosys);
  }
  return named;
}

async function bytes_of(text) {
  const packed = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}

let compiled = null;
let instance = null;

function begin() {
  instance = new WebAssembly.Instance(compiled, imports(compiled, () => instance.exports.memory));
  instance.exports._initialize();
}

// start makes the module ready; it is called once.
async function start() {
  compiled = await WebAssembly.compile(await bytes_of(module_text));
  begin();
}

// call_text asks by a text, and answers by one. Where the machine stops the module (its stack or its memory is at an end),
// it starts anew: calls know nothing of each other.
function call_text(request) {
  const bytes = new TextEncoder().encode(request);
  try {
    const { room, call, length, memory } = instance.exports;
    const at = room(bytes.length) >>> 0;
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    const answer = call() >>> 0;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, answer, length() >>> 0));
  } catch (trouble) {
    begin();
    return JSON.stringify({ error: `call:1:1: the engine stopped, ${trouble.message}; expected less of it`,
      source: "call", line: 1, column: 1 });
  }
}

// call asks by an object, and answers by one.
function call(request) {
  return JSON.parse(call_text(JSON.stringify(request)));
}

if (typeof module === "object") module.exports = { start, call, call_text };  // of node
