// The one Python of a page: loads it on the first click, runs one piece of code after the other,
// and ends it where code does not end. worker.js is the other end.
(() => {
  /** @type {ExerciseData} */
  const data = JSON.parse(document.getElementById("exercise-data")?.textContent ?? "");
  const base = new URL(data.base, document.baseURI).href;
  const AGAIN = "The next check starts it anew.";
  const options = { limitMs: 20_000 }; // of the reader's code; loading does not count

  /** @type {Map<string, Promise<Blob>>} */
  const blobs = new Map(); // name of an asset: a promise of its content, gzipped
  /** @type {Record<string, (text: string) => void>} */
  const waiting = {}; // "name/piece": what to do when its script has come
  /** @type {Job[]} */
  const queue = [];
  /** @type {Job | null} */
  let current = null; // the job that has the worker
  /** @type {Worker | null} */
  let worker = null;
  /** @type {Promise<void> | null} */
  let booting = null; // a promise while Python loads, and after
  let loadingText = ""; // how far that is
  let givenTables = new Set();
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;

  /** Every script of an asset calls this. */
  window.cameraLabAsset = (name, piece, text) => waiting[`${name}/${piece}`]?.(text);

  async function loadScript(/** @type {string} */ file) {
    const script = document.createElement("script");
    script.src = `${base}${file}?v=${data.version}`;
    /** @type {Promise<unknown>} */
    const loaded = new Promise((resolve, reject) => {
      script.onload = resolve;
      script.onerror = () => reject(new Error(`a file of this page could not be loaded: ${file}`));
    });
    document.head.append(script);
    await loaded.finally(() => script.remove());
  }

  /**
   * @param {string} name
   * @param {string} file
   * @param {number} piece
   */
  async function loadPiece(name, file, piece) {
    let text = "";
    waiting[`${name}/${piece}`] = (given) => {
      text = given;
    };
    await loadScript(file);
    delete waiting[`${name}/${piece}`];
    return (await fetch(`data:application/octet-stream;base64,${text}`)).blob();
  }

  /**
   * Load an asset once; what failed is tried again the next time.
   * @param {Asset} asset
   * @param {(bytes: number) => void} onLoaded
   */
  function loadAsset(asset, onLoaded = () => {}) {
    let whole = blobs.get(asset.name);
    if (!whole) {
      const pieces = asset.files.map(async (file, piece) => {
        const blob = await loadPiece(asset.name, file, piece);
        onLoaded(blob.size);
        return blob;
      });
      whole = Promise.all(pieces).then((parts) => new Blob(parts));
      whole.catch(() => blobs.delete(asset.name));
      blobs.set(asset.name, whole);
    }
    return whole;
  }

  async function inflateText(/** @type {Blob} */ blob) {
    return new Response(blob.stream().pipeThrough(new DecompressionStream("gzip"))).text();
  }

  /**
   * Load everything and start the worker.
   * @param {Say} say
   */
  async function boot(say) {
    let loaded = 0;
    const count = (/** @type {number} */ bytes) => {
      loaded += bytes;
      say(`Loading Python: ${megabytes(loaded)} of ${megabytes(data.bytes)} MB`);
    };
    say("Loading Python");
    const contents = await Promise.all(data.assets.map((asset) => loadAsset(asset, count)));
    const assets = Object.fromEntries(data.assets.map((asset, i) => [asset.name, contents[i]]));
    say(data.remote.length ? "Loading NumPy and OpenCV from the network" : "Starting Python");
    const script = await inflateText(assets["worker.js"]);
    const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    const booted = new Worker(url);
    worker = booted;
    URL.revokeObjectURL(url);
    givenTables = new Set();
    /** @type {Promise<void>} */
    const ready = new Promise((resolve, reject) => {
      booted.onerror = (event) => reject(new Error(event.message || "the worker did not start"));
      booted.onmessage = ({ data: message }) =>
        message.kind === "ready" ? resolve() : reject(new Error(message.message));
      booted.postMessage({ kind: "boot", assets, remote: data.remote, lock: data.lock });
    });
    await ready;
    booted.onmessage = ({ data: message }) => hear(message);
    booted.onerror = (event) =>
      finish({ result: "stopped", error: `Python failed: ${event.message}` });
  }

  const megabytes = (/** @type {number} */ bytes) => (bytes / 1e6).toFixed(1);

  function end() {
    worker?.terminate();
    worker = null;
    booting = null;
  }

  function hear(/** @type {Exclude<WorkerAnswer, { kind: "ready" }>} */ message) {
    if (message.kind === "done") {
      finish(message.said);
    } else {
      end();
      finish({ result: "stopped", error: `Python stopped: ${message.message}. ${AGAIN}` });
    }
  }

  function stopLate() {
    const seconds = options.limitMs / 1000;
    end();
    finish({
      result: "stopped",
      error: `Stopped after ${seconds} seconds: is there a loop that never ends? ${AGAIN}`,
    });
  }

  /** Give the current job its result, and begin the next. */
  function finish(/** @type {Said} */ said) {
    clearTimeout(timer);
    const job = current;
    current = null;
    job?.resolve(said);
    next();
  }

  async function next() {
    if (current) return;
    const job = queue.shift();
    if (!job) return;
    current = job;
    try {
      if (booting) job.say(loadingText);
      booting ??= boot((text) => {
        loadingText = text;
        current?.say(text);
      });
      const table = loadAsset(data.tables[job.exercise]);
      await booting;
      const content = await table;
      if (current !== job) return; // stopped meanwhile
      const isNew = !givenTables.has(job.exercise);
      givenTables.add(job.exercise);
      const { code, exercise } = job;
      const progress = window.cameraLab.progress.text();
      job.say("Running");
      job.isRunning = true;
      timer = setTimeout(stopLate, options.limitMs);
      worker?.postMessage({ kind: "run", code, exercise, progress, table: isNew ? content : null });
    } catch (thrown) {
      const error = /** @type {Error} */ (thrown);
      end();
      if (current === job)
        finish({ result: "stopped", error: `Python did not start: ${error.message}.` });
    }
  }

  /**
   * Run code and check the function in it; resolves to what page_runner.py says, or to
   * {result: "stopped", error}.
   * @param {string} exercise
   * @param {string} code
   * @param {Say} say
   * @returns {Promise<Said>}
   */
  function check(exercise, code, say) {
    return new Promise((resolve) => {
      queue.push({ exercise, code, say, resolve });
      say(current ? "Waiting for the check before" : "Loading Python");
      next();
    });
  }

  /** Stop the check of an exercise, whether it waits, loads or runs. */
  function stop(/** @type {string} */ exercise) {
    const place = queue.findIndex((job) => job.exercise === exercise);
    if (place >= 0) {
      const [job] = queue.splice(place, 1);
      job.resolve({ result: "stopped", error: "Stopped before it began." });
    } else if (current?.exercise === exercise) {
      const { isRunning } = current;
      if (isRunning) end();
      finish({
        result: "stopped",
        error: isRunning ? `Stopped. ${AGAIN}` : "Stopped before it began.",
      });
    }
  }

  window.cameraLab = { ...window.cameraLab, python: { check, stop, options, data } };
})();
