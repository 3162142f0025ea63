// Runs the functions of Python files in the page's Python, under Node, and prints what they return:
// node _python.mjs ASSETS OUT FILE...   ASSETS is a folder as tests/helpers/page.py makes it.
// Arrays go to the folder /out of the page, which is OUT. The answer is JSON: {file: {function:
// {value, error, seconds}}}, and the times of the start in milliseconds.
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
    import json, time, traceback, types
    module = types.ModuleType("inside")
    said = {}
    def call(label, function):
        start = time.perf_counter()
        value, error = None, ""
        try:
            value = function()
        except BaseException:
            error = traceback.format_exc()
        seconds = round(time.perf_counter() - start, 3)
        said[label] = {"value": value, "error": error, "seconds": seconds}
    call("import", lambda: exec(compile(source, name, "exec"), vars(module)))
    for label, function in list(vars(module).items()):
        is_own = isinstance(function, types.FunctionType) and function.__module__ == "inside"
        if is_own and not label.startswith("_") and not function.__code__.co_argcount:
            call(label, function)
    return json.dumps(said)
run
`;

// Node shows the line of Pyodide that threw, and that is its whole source
process.on("uncaughtException", (error) => {
  console.error(String(error.stack ?? error).slice(-3000));
  process.exitCode = 1;
});

const pyodide = await boot();
const run = pyodide.runPython(RUN);
const said = { times };
for (const file of files) {
  said[path.basename(file, ".py")] = JSON.parse(run(readFileSync(file, "utf8"), file));
}
console.log(JSON.stringify(said));
