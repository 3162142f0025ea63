// Python for the cells of a page, in a worker. The page sends {kind: "boot"} once, {kind: "add"} for
// a part that comes later, then {kind: "check"}, {kind: "cell"} and {kind: "comm"}; python.js is the
// other end. This script comes from a blob, as a classic worker: a module worker cannot be started on
// a page that is opened from a file.
// biome-ignore lint/suspicious/noRedundantUseStrict: a script, although Biome takes it for a module
"use strict";

const SITE_PACKAGES = "/lib/python3.14/site-packages";
const TABLES = `${SITE_PACKAGES}/labutils/checks/tables`;
const HOME = "/home/pyodide";
const INDEX = "https://book.invalid/"; // never asked: fetch below answers in its place
// The ray caster draws: a page has no OpenGL.
const ENVIRONMENT = {
  HOME,
  MUJOCO_GL: "disable",
  LABUTILS_GL_MISSING: "a web page has none",
  MPLBACKEND: "agg", // where a reader imports Matplotlib: page_cells.py shows its figures
};

const TOO_LITTLE =
  "this device has too little memory for Python in a page: close other tabs, or run the notebook";

/** @type {Pyodide} */
let pyodide;
/** @type {PageModules} */
let modules;
/** @type {typeof fetch} */
let download;
/** @type {Record<string, RemoteWheel[]>} */
let optional = {}; // name of a package: the wheels it needs
/** @type {Promise<object>} */
let engine;
let finished = Promise.resolve(); // one order after the other

/** The content of an asset: a Blob of gzip. */
function inflate(/** @type {Blob} */ blob) {
  return new Response(blob.stream().pipeThrough(new DecompressionStream("gzip")));
}

async function inflateBytes(/** @type {Blob} */ blob) {
  return new Uint8Array(await inflate(blob).arrayBuffer());
}

/** Import a module whose text is an asset. */
async function importAsset(/** @type {Blob} */ blob) {
  const text = await inflate(blob).text();
  const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  try {
    return await import(url);
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** Let Pyodide find its own files among the assets, and nothing else. */
function serveFiles(/** @type {Record<string, Blob>} */ assets) {
  // Pyodide asks in this way whether it runs in a module worker, which it needs for import().
  /** @type {any} */ (self).importScripts = () => {
    throw new TypeError("not in a module worker");
  };
  self.fetch = async (asked) => {
    const request = /** @type {Request} */ (asked);
    const name =
      String(request.url ?? asked)
        .split("/")
        .pop() ?? "";
    const blob = assets[`vendor/${name}`];
    if (!blob) throw new TypeError(`Python in the page asks for nothing else: ${name}`);
    const type = name.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
    return new Response(inflate(blob).body, { headers: { "Content-Type": type } });
  };
}

/**
 * Load wheels that the page could not bring with it; each has to be the file that is meant.
 * @param {RemoteWheel[]} remote
 */
async function loadWheels(remote) {
  // not crypto.subtle: a page that comes by plain http has none
  const getSha256 = pyodide.runPython(
    "import hashlib\nlambda content: hashlib.sha256(content.to_bytes()).hexdigest()",
  );
  for (const { name, url, sha256 } of remote) {
    let content;
    try {
      const answer = await download(url);
      if (!answer.ok) throw new TypeError(`status ${answer.status}`);
      content = new Uint8Array(await answer.arrayBuffer());
    } catch (thrown) {
      const error = /** @type {Error} */ (thrown);
      throw new Error(`${name} could not be loaded from ${new URL(url).host} (${error.message})`);
    }
    if (getSha256(content) !== sha256) {
      throw new Error(`${name} from ${new URL(url).host} is not the file it should be`);
    }
    pyodide.unpackArchive(content, "wheel", { extractDir: SITE_PACKAGES });
  }
}

/** Unpack the archives among the assets, and write the modules of the page's own Python. */
async function unpack(/** @type {Record<string, Blob>} */ assets) {
  const names = Object.keys(assets);
  const archives = names.filter((name) => name.endsWith(".zip") && !name.includes("stdlib"));
  for (const bytes of await Promise.all(archives.map((name) => inflateBytes(assets[name])))) {
    pyodide.unpackArchive(bytes, "zip", { extractDir: SITE_PACKAGES });
  }
}

async function boot(/** @type {BootOrder} */ order) {
  const { assets, remote, lock } = order;
  optional = order.optional;
  download = self.fetch.bind(self);
  serveFiles(assets);
  const [{ loadPyodide }, module] = await Promise.all([
    importAsset(assets["vendor/pyodide.mjs"]),
    importAsset(assets["vendor/pyodide.asm.mjs"]),
  ]);
  pyodide = await loadPyodide({
    indexURL: INDEX,
    createPyodideModule: module.default,
    lockFileContents: JSON.stringify(lock),
    env: ENVIRONMENT,
  });
  if (remote.length) await loadWheels(remote);
  await unpack(assets);
  pyodide.FS.chdir(HOME);
  modules = {
    runner: pyodide.pyimport("page_runner"),
    cells: pyodide.pyimport("page_cells"),
    comms: null,
  };
  modules.cells.prepare();
}

/** What went wrong, in words: the engine's own, but for the one fault that a reader can mend. */
function explain(/** @type {any} */ error) {
  const message = String(error?.message ?? error);
  const isMemory = /out of memory|memory access|could not allocate|allocation failed/i;
  return isMemory.test(message) ? `${TOO_LITTLE} (${message})` : message;
}

/** Start the engine of the simulator; it needs no Python, so it compiles beside it. */
async function startEngine(/** @type {Record<string, Blob>} */ assets) {
  const [bridge, mujoco, wasm] = await Promise.all([
    importAsset(assets["simulator.js"]),
    importAsset(assets["vendor/mujoco.js"]),
    inflateBytes(assets["vendor/mujoco.wasm"]),
  ]);
  return bridge.loadBridge(mujoco.default, wasm);
}

/** Add a part: its files, and what it has to be told. */
async function add(/** @type {AddOrder} */ { part, assets }) {
  if (part === "simulator") pyodide.registerJsModule("_mujoco_wasm", await engine);
  await unpack(assets);
  pyodide.runPython("import importlib; importlib.invalidate_caches()");
  if (part === "widgets") {
    const comms = pyodide.pyimport("page_comms");
    comms.connect(sendComm);
    modules.comms = comms;
  }
}

/**
 * Python's widgets say something: one message, as JSON, and its buffers.
 * @param {string} text
 * @param {PyProxy} buffers
 */
function sendComm(text, buffers) {
  const copies = buffers.toJs().map((one) => one.slice().buffer);
  buffers.destroy();
  const message = { ...JSON.parse(text), buffers: copies };
  self.postMessage({ kind: "comm", message }, { transfer: copies });
}

async function check(/** @type {CheckOrder} */ { code, exercise, progress, table }) {
  if (table) pyodide.FS.writeFile(`${TABLES}/${exercise}.npz`, await inflateBytes(table));
  await loadOptional(code);
  return JSON.parse(modules.runner.run(code, exercise, progress, sendPrinted));
}

async function runCell(/** @type {CellOrder} */ { code, name, isSetup }) {
  await loadOptional(code);
  const outputs = JSON.parse(modules.cells.run(code, name, sendPrinted, isSetup));
  const last = outputs.at(-1);
  return { result: last?.output_type === "error" ? "error" : "ran", outputs, line: last?.line };
}

/** What code prints is told at once: it may be stopped before its end. */
function sendPrinted(/** @type {string} */ text) {
  self.postMessage({ kind: "printed", text });
}

/** Load packages that code imports, and that pages do not bring with them. */
async function loadOptional(/** @type {string} */ code) {
  for (const wanted of JSON.parse(modules.cells.list_missing(code, JSON.stringify(optional)))) {
    self.postMessage({ kind: "say", text: `Loading ${wanted} from the network` });
    try {
      await loadWheels(optional[wanted]);
      delete optional[wanted];
    } catch (error) {
      modules.cells.note_missing(wanted, /** @type {Error} */ (error).message);
    }
  }
}

async function serve(/** @type {MessageEvent<Order>} */ { data: order, ports }) {
  if (order.kind === "boot" || order.kind === "add") {
    const [port] = ports;
    try {
      await (order.kind === "boot" ? boot(order) : add(order));
      port.postMessage("");
    } catch (error) {
      port.postMessage(explain(error));
    }
  } else if (order.kind === "comm") {
    const { buffers, ...message } = order.message;
    const bytes = buffers.map((one) => new Uint8Array(one));
    modules.comms?.deliver(JSON.stringify(message), bytes);
  } else {
    const said = await (order.kind === "cell" ? runCell(order) : check(order));
    self.postMessage({ kind: "done", said });
  }
}

self.onmessage = (event) => {
  if (event.data.kind === "add" && event.data.part === "simulator") {
    engine = startEngine(event.data.assets);
    engine.catch(() => {}); // whoever waits for it hears of it
  }
  finished = finished
    .then(() => serve(event))
    .catch((error) => {
      // what Python itself could not catch: out of memory, a stack that is too deep
      self.postMessage({ kind: "fatal", message: explain(error) });
    });
};
