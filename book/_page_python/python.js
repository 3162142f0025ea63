// The one Python of a page: loads it on the first click, runs one piece of code after the other,
// and ends it where code does not end. worker.js is the other end.
(() => {
  const data = JSON.parse(document.getElementById("exercise-data").textContent);
  const base = new URL(data.base, document.baseURI).href;
  const AGAIN = "The next check starts it anew.";
  const options = { limitMs: 20_000 }; // of the reader's code; loading does not count

  const blobs = new Map(); // name of an asset: a promise of its content, gzipped
  const waiting = {}; // "name/piece": what to do when its script has come
  const queue = [];
  let current = null; // the job that has the worker
  let worker = null;
  let booting = null; // a promise while Python loads, and after
  let loadingText = ""; // how far that is
  let givenTables = new Set();
  let timer = 0;

  /** Every script of an asset calls this. */
  window.cameraLabAsset = (name, piece, text) => waiting[`${name}/${piece}`]?.(text);

  async function loadScript(file) {
    const script = document.createElement("script");
    script.src = `${base}${file}?v=${data.version}`;
    const loaded = new Promise((resolve, reject) => {
      script.onload = resolve;
      script.onerror = () => reject(new Error(`a file of this page could not be loaded: ${file}`));
    });
    document.head.append(script);
    await loaded.finally(() => script.remove());
  }

  async function loadPiece(name, file, piece) {
    let text;
    waiting[`${name}/${piece}`] = (given) => (text = given);
    await loadScript(file);
    delete waiting[`${name}/${piece}`];
    return (await fetch(`data:application/octet-stream;base64,${text}`)).blob();
  }

  /** Load an asset once; what failed is tried again the next time. */
  function loadAsset(asset, onLoaded = () => {}) {
    if (!blobs.has(asset.name)) {
      const pieces = asset.files.map(async (file, piece) => {
        const blob = await loadPiece(asset.name, file, piece);
        onLoaded(blob.size);
        return blob;
      });
      const whole = Promise.all(pieces).then((parts) => new Blob(parts));
      whole.catch(() => blobs.delete(asset.name));
      blobs.set(asset.name, whole);
    }
    return blobs.get(asset.name);
  }

  async function inflateText(blob) {
    return new Response(blob.stream().pipeThrough(new DecompressionStream("gzip"))).text();
  }

  /** Load everything and start the worker. */
  async function boot(say) {
    let loaded = 0;
    const count = (bytes) => {
      loaded += bytes;
      say(`Loading Python: ${megabytes(loaded)} of ${megabytes(data.bytes)} MB`);
    };
    say("Loading Python");
    const contents = await Promise.all(data.assets.map((asset) => loadAsset(asset, count)));
    const assets = Object.fromEntries(data.assets.map((asset, i) => [asset.name, contents[i]]));
    say(data.remote.length ? "Loading NumPy and OpenCV from the network" : "Starting Python");
    const script = await inflateText(assets["worker.js"]);
    const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    worker = new Worker(url);
    URL.revokeObjectURL(url);
    givenTables = new Set();
    await new Promise((resolve, reject) => {
      worker.onerror = (event) => reject(new Error(event.message || "the worker did not start"));
      worker.onmessage = ({ data: message }) =>
        message.kind === "ready" ? resolve() : reject(new Error(message.message));
      worker.postMessage({ kind: "boot", assets, remote: data.remote, lock: data.lock });
    });
    worker.onmessage = ({ data: message }) => hear(message);
    worker.onerror = (event) =>
      finish({ result: "stopped", error: `Python failed: ${event.message}` });
  }

  const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

  function end() {
    worker?.terminate();
    worker = null;
    booting = null;
  }

  function hear(message) {
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
  function finish(said) {
    clearTimeout(timer);
    const job = current;
    current = null;
    job?.resolve(said);
    next();
  }

  async function next() {
    if (current || !queue.length) return;
    const job = queue.shift();
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
      worker.postMessage({ kind: "run", code, exercise, progress, table: isNew ? content : null });
    } catch (error) {
      end();
      if (current === job)
        finish({ result: "stopped", error: `Python did not start: ${error.message}.` });
    }
  }

  /**
   * Run code and check the function in it; resolves to what page_runner.py says, or to
   * {result: "stopped", error}.
   */
  function check(exercise, code, say) {
    return new Promise((resolve) => {
      queue.push({ exercise, code, say, resolve });
      say(current ? "Waiting for the check before" : "Loading Python");
      next();
    });
  }

  /** Stop the check of an exercise, whether it waits, loads or runs. */
  function stop(exercise) {
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
