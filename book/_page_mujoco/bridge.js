// Loads the WebAssembly build of MuJoCo and gives Python what it needs of it: the package beside
// this file is the other end, and knows it as the module `_mujoco_wasm`. Nothing here is of a
// browser: it works in a page, in a worker and in Node, because the caller brings the bytes.

/** @typedef {import("@mujoco/mujoco").MainModule} Engine */
/** @typedef {(options: object) => Promise<Engine>} LoadEngine */
/** @typedef {{ memory: WebAssembly.Memory } & Record<string, (...given: number[]) => number>} Exports */
/** @typedef {(type: number, handle: number) => unknown} TakeValue */

/**
 * Start the engine.
 * @param {LoadEngine} loadEngine - what `mujoco.js` exports by default
 * @param {BufferSource} wasm - the content of `mujoco.wasm`
 */
export async function loadBridge(loadEngine, wasm) {
  let parts = /** @type {Exports} */ ({}); // put there while the engine loads
  const engine = await loadEngine({
    /**
     * @param {any} imports
     * @param {(instance: WebAssembly.Instance, module: WebAssembly.Module) => void} done
     */
    instantiateWasm(imports, done) {
      teachBooleans(imports.env);
      WebAssembly.instantiate(wasm, imports).then(({ instance, module }) => {
        parts = /** @type {any} */ (instance.exports);
        done(instance, module);
      });
      return {};
    },
  });

  /**
   * A stretch of the engine's memory, made anew each time: growth detaches older ones.
   * @param {number} address
   * @param {number} length
   */
  const getBytes = (address, length) => new Uint8Array(parts.memory.buffer, address, length);

  const countBytes = () => parts.memory.buffer.byteLength;

  /** @type {{ HEAPU8: Uint8Array }} */
  let python;

  /**
   * Learn where Python's memory is: two copies of numbers are then one call apart.
   * @param {{ HEAPU8: Uint8Array }} module - Pyodide's own, whose HEAPU8 is new after a growth
   */
  const setPython = (module) => {
    python = module;
  };

  /**
   * Copy stretches of memory between the engine and Python.
   * @param {Float64Array} table - of each stretch: address in the engine, in Python, and length
   * @param {boolean} isPush - to the engine
   */
  function copyStretches(table, isPush) {
    const mine = new Uint8Array(parts.memory.buffer);
    const theirs = python.HEAPU8;
    for (let i = 0; i < table.length; i += 3) {
      const [at, place, length] = table.subarray(i, i + 3);
      if (isPush) mine.set(theirs.subarray(place, place + length), at);
      else theirs.set(mine.subarray(at, at + length), place);
    }
  }

  const idleStack = parts.emscripten_stack_get_current();

  /**
   * To be called after every error. The engine leaves by an exception of JavaScript, which unwinds
   * everything but its own stack: a few dozen errors later that would have run into other memory.
   */
  const resetStack = () => parts._emscripten_stack_restore(idleStack);

  return {
    engine,
    getBytes,
    countBytes,
    resetStack,
    setPython,
    copyStretches,
    listArrays,
    findArray,
    step: makeStep(engine),
    ...makeRays(engine),
  };
}

/**
 * Reading an array of booleans throws in 3.14.0, because its type is not registered.
 * @param {{ _emval_take_value: TakeValue, _embind_register_memory_view: Function }} env
 */
function teachBooleans(env) {
  const take = env._emval_take_value;
  env._emval_take_value = (type, handle) => {
    try {
      return take(type, handle);
    } catch (error) {
      if (!(error instanceof Error && error.message.includes("memory_viewIbE"))) throw error;
      const unsignedBytes = 1; // the place of Uint8Array in embind's list of views
      env._embind_register_memory_view(type, unsignedBytes, 0);
      return take(type, handle);
    }
  };
}

/** Views of a wrong length, or of another kind. */
const NO_ARRAYS = ["buffer", "arena", "contact"];

/**
 * Say where the arrays of a model or a state lie: JSON of {name: [address, bytes, kind]}.
 * @param {any} object
 */
function listArrays(object) {
  /** @type {Record<string, [number, number, string]>} */
  const found = {};
  for (
    let kind = Object.getPrototypeOf(object);
    kind !== Object.prototype;
    kind = Object.getPrototypeOf(kind)
  ) {
    for (const name of Object.getOwnPropertyNames(kind)) {
      if (NO_ARRAYS.includes(name) || !Object.getOwnPropertyDescriptor(kind, name)?.get) continue;
      const value = object[name];
      if (ArrayBuffer.isView(value)) found[name] = describe(value);
    }
  }
  return JSON.stringify(found);
}

/**
 * Say where one array lies now: JSON of [address, bytes, kind].
 * @param {any} object
 * @param {string} name
 */
function findArray(object, name) {
  return JSON.stringify(describe(object[name]));
}

/**
 * @param {ArrayBufferView} view
 * @returns {[number, number, string]}
 */
function describe(view) {
  return [view.byteOffset, view.byteLength, view.constructor.name];
}

/** @param {Engine} engine */
function makeStep(engine) {
  /**
   * Many steps, without a way to Python and back for each.
   * @param {import("@mujoco/mujoco").MjModel} model
   * @param {import("@mujoco/mujoco").MjData} data
   * @param {number} count
   */
  return (model, data, count) => {
    for (let i = 0; i < count; i++) engine.mj_step(model, data);
  };
}

/**
 * Rays, many at a time: their answers stay in the engine's memory until Python has copied them.
 * @param {Engine} engine
 */
function makeRays(engine) {
  let size = 0;
  let ids = new engine.IntBuffer(1);
  let distances = new engine.DoubleBuffer(1);
  let normals = new engine.DoubleBuffer(3);

  /** @param {number} count */
  function resize(count) {
    if (count === size) return;
    for (const buffer of [ids, distances, normals]) buffer.delete();
    size = count;
    ids = new engine.IntBuffer(count);
    distances = new engine.DoubleBuffer(count);
    normals = new engine.DoubleBuffer(3 * count);
  }

  const getAnswers = () => [ids.GetView(), distances.GetView(), normals.GetView()];

  /**
   * `mj_multiRay`; the views it returns hold until the next call.
   * @param {import("@mujoco/mujoco").MjModel} model
   * @param {import("@mujoco/mujoco").MjData} data
   * @param {number[]} point
   * @param {number[]} rays
   * @param {number[]} groups
   * @param {boolean} seesStatic
   * @param {number} body
   * @param {number} count
   * @param {number} cutoff
   */
  function castRays(model, data, point, rays, groups, seesStatic, body, count, cutoff) {
    resize(count);
    engine.mj_multiRay(
      model,
      data,
      point,
      rays,
      groups,
      seesStatic,
      body,
      ids,
      distances,
      normals,
      count,
      cutoff,
    );
    return getAnswers();
  }

  /**
   * `mj_ray`; its answers are views of one ray.
   * @param {import("@mujoco/mujoco").MjModel} model
   * @param {import("@mujoco/mujoco").MjData} data
   * @param {number[]} point
   * @param {number[]} ray
   * @param {number[]} groups
   * @param {boolean} seesStatic
   * @param {number} body
   */
  function castRay(model, data, point, ray, groups, seesStatic, body) {
    resize(1);
    distances.GetView()[0] = engine.mj_ray(
      model,
      data,
      point,
      ray,
      groups,
      seesStatic,
      body,
      ids,
      normals,
    );
    return getAnswers();
  }

  return { castRays, castRay };
}
