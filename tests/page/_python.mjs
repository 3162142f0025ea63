// Runs files of Python in the page's Python, under Node, and prints what they answer as JSON:
// node _python.mjs ASSETS OUT FILE...   ASSETS is a folder as tests/helpers/page.py makes it.
// A file leaves its answer in a variable `answer`, and arrays in the folder /out, which is OUT.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [assets, out, ...files] = process.argv.slice(2);
const SITE_PACKAGES = "/lib/python3.14/site-packages";
const times = {};
let last = performance.now();

function lap(name) {
  times[name] = Math.round(performance.now() - last);
  last = performance.now();
}

/** Pyodide knows no Buffer. */
const read = (name) => new Uint8Array(readFileSync(path.join(assets, name)));
const load = (name) => import(pathToFileURL(path.resolve(assets, name)).href);

async function boot() {
  const { loadPyodide } = await load("vendor/pyodide.mjs");
  const pyodide = await loadPyodide({ indexURL: `${path.resolve(assets, "vendor")}/` });
  lap("pyodide");
  for (const name of readdirSync(assets)) {
    if (name.endsWith(".zip"))
      pyodide.unpackArchive(read(name), "zip", { extractDir: SITE_PACKAGES });
  }
  lap("unpack");
  const [{ default: loadEngine }, { loadBridge }] = await Promise.all([
    load("vendor/mujoco.mjs"),
    load("simulator.mjs"),
  ]);
  const bridge = await loadBridge(loadEngine, read("vendor/mujoco.wasm"));
  pyodide.registerJsModule("_mujoco_wasm", bridge);
  lap("engine");
  pyodide.FS.mkdirTree("/out");
  pyodide.FS.mount(pyodide.FS.filesystems.NODEFS, { root: path.resolve(out) }, "/out");
  return pyodide;
}

const RUN = `
def run(source, name):
    import json, time, traceback
    namespace = {"__name__": "__main__", "answer": None}
    start = time.perf_counter()
    try:
        exec(compile(source, name, "exec"), namespace)
        said = {"answer": namespace["answer"]}
    except BaseException:
        said = {"error": traceback.format_exc()}
    said["seconds"] = round(time.perf_counter() - start, 3)
    return json.dumps(said)
run
`;

const pyodide = await boot();
const run = pyodide.runPython(RUN);
const said = { times };
for (const file of files) {
  said[path.basename(file, ".py")] = JSON.parse(run(readFileSync(file, "utf8"), file));
}
console.log(JSON.stringify(said));
