// Python for the exercise cells, in a worker. The page sends {kind: "boot"} once, then {kind: "run"};
// python.js is the other end. This script comes from a blob, as a classic worker: a module worker
// cannot be started on a page that is opened from a file.
// biome-ignore lint/suspicious/noRedundantUseStrict: a script, although Biome takes it for a module
"use strict";

const SITE_PACKAGES = "/lib/python3.14/site-packages";
const TABLES = `${SITE_PACKAGES}/labutils/checks/tables`;
const HOME = "/home/pyodide";
const INDEX = "https://book.invalid/"; // never asked: fetch below answers in its place

/** @type {Pyodide} */
let pyodide;
/** @type {(code: string, exercise: string, progress: string) => string} */
let runCode;

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
 * Load the wheels that the page could not bring with it; each has to be the file that is meant.
 * @param {RemoteWheel[]} remote
 * @param {typeof fetch} download
 */
async function loadWheels(remote, download) {
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

async function boot(/** @type {BootOrder} */ { assets, remote, lock }) {
  const download = self.fetch.bind(self);
  serveFiles(assets);
  const [{ loadPyodide }, module] = await Promise.all([
    importAsset(assets["vendor/pyodide.mjs"]),
    importAsset(assets["vendor/pyodide.asm.mjs"]),
  ]);
  // inflated while Pyodide compiles
  const archives = Object.keys(assets).filter(
    (name) => name.endsWith(".zip") && !name.includes("stdlib"),
  );
  const unpacked = archives.map((name) => inflateBytes(assets[name]));
  const runner = inflateBytes(assets["page_runner.py"]);
  pyodide = await loadPyodide({
    indexURL: INDEX,
    createPyodideModule: module.default,
    lockFileContents: JSON.stringify(lock),
  });
  if (remote.length) await loadWheels(remote, download);
  for (const bytes of await Promise.all(unpacked)) {
    pyodide.unpackArchive(bytes, "zip", { extractDir: SITE_PACKAGES });
  }
  pyodide.FS.writeFile(`${SITE_PACKAGES}/page_runner.py`, await runner);
  pyodide.FS.chdir(HOME);
  runCode = pyodide.pyimport("page_runner").run;
}

async function run(/** @type {RunOrder} */ { code, exercise, progress, table }) {
  if (table) pyodide.FS.writeFile(`${TABLES}/${exercise}.npz`, await inflateBytes(table));
  return JSON.parse(runCode(code, exercise, progress));
}

self.onmessage = async ({ data }) => {
  try {
    if (data.kind === "boot") {
      await boot(data);
      self.postMessage({ kind: "ready" });
    } else {
      self.postMessage({ kind: "done", said: await run(data) });
    }
  } catch (error) {
    // what Python itself could not catch: out of memory, a stack that is too deep
    self.postMessage({
      kind: "fatal",
      message: String(/** @type {any} */ (error)?.message ?? error),
    });
  }
};
