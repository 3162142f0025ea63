// The one Python of a page: loads it on the first click, runs one piece of code after the other,
// and ends it where code does not end. worker.js is the other end.
(() => {
  const { assets } = window.cameraLab;
  const { data } = assets;
  const AGAIN = "The next run starts it anew.";
  const options = { limitMs: 20_000 }; // of the reader's code; loading does not count
  const BASE = "python";

  /** @type {Job[]} */
  const queue = [];
  /** @type {Job | null} */
  let current = null; // the job that has the worker
  /** @type {Worker | null} */
  let worker = null;
  /** @type {ReturnType<typeof start> | null} */
  let started = null;
  /** @type {Map<string, Promise<void>>} */
  let ready = new Map(); // part: a promise that the worker has it
  let loadingText = ""; // how far loading is
  let loadedBytes = 0;
  let wantedBytes = 0;
  /** @type {Set<string>} */
  let givenTables = new Set();
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;
  /** @type {ReturnType<typeof setTimeout>} */
  let commTimer;
  /** @type {(() => void)[]} */
  const onEnd = []; // who has to know that everything Python knew is gone
  /** @type {(message: CommMessage) => void} */
  let onComm = () => {};

  const megabytes = (/** @type {number} */ bytes) => (bytes / 1e6).toFixed(1);

  function sayLoading(/** @type {string} */ text) {
    loadingText = text;
    current?.say(text);
  }

  /**
   * Load a part, saying how far it is.
   * @param {string} part
   */
  function load(part) {
    wantedBytes += assets.countBytes(part);
    return assets.loadPart(part, (bytes) => {
      loadedBytes += bytes;
      const share = `${megabytes(loadedBytes)} of ${megabytes(wantedBytes)} MB`;
      sayLoading(loadedBytes < wantedBytes ? `Loading Python: ${share}` : "Starting Python");
    });
  }

  /**
   * Ask the worker for something that is not code, and wait until it is done.
   * @param {Worker} asked
   * @param {BootOrder | AddOrder} order
   * @returns {Promise<void>}
   */
  function ask(asked, order) {
    return new Promise((resolve, reject) => {
      const { port1, port2 } = new MessageChannel();
      asked.addEventListener("error", (event) =>
        reject(new Error(event.message || "the worker did not start")),
      );
      port1.onmessage = ({ data: problem }) => (problem ? reject(new Error(problem)) : resolve());
      asked.postMessage(order, [port2]);
    });
  }

  /** Load what Python needs, and start the worker. */
  async function start() {
    sayLoading("Loading Python");
    const contents = await load(BASE);
    sayLoading(
      data.remote.length ? "Loading NumPy and OpenCV from the network" : "Starting Python",
    );
    const script = await assets.inflateText(contents["worker.js"]);
    const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    const booted = new Worker(url);
    URL.revokeObjectURL(url);
    worker = booted;
    givenTables = new Set();
    booted.onmessage = ({ data: message }) => hear(message);
    booted.onerror = (event) =>
      finish({ result: "stopped", error: `Python failed: ${event.message}` });
    return { booted, contents };
  }

  async function boot() {
    const { booted, contents } = await starting();
    const { remote, lock, optional } = data;
    await ask(booted, { kind: "boot", assets: contents, remote, lock, optional });
  }

  function starting() {
    started ??= start();
    return started;
  }

  /**
   * Let the worker have a part; the parts of a job travel at the same time.
   * @param {string} part
   * @returns {Promise<void>}
   */
  function prepare(part) {
    const promise = ready.get(part) ?? (part === BASE ? boot() : add(part));
    ready.set(part, promise);
    return promise;
  }

  async function add(/** @type {string} */ part) {
    const [contents, { booted }] = await Promise.all([load(part), starting()]);
    prepare(BASE); // its order comes first
    await ask(booted, { kind: "add", part, assets: contents });
  }

  function end() {
    clearTimeout(commTimer);
    worker?.terminate();
    worker = null;
    started = null;
    ready = new Map();
    loadedBytes = wantedBytes = 0;
    for (const listener of onEnd) listener();
  }

  function hear(/** @type {WorkerAnswer} */ message) {
    if (message.kind === "printed") {
      current?.onPrinted?.(message.text);
    } else if (message.kind === "comm") {
      if (message.message.type === "comm_done") clearTimeout(commTimer);
      onComm(message.message);
    } else if (message.kind === "say") {
      current?.say(message.text);
    } else if (message.kind === "done") {
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

  /** A callback of a widget does not end: the same limit holds, where no cell runs. */
  function endLate() {
    if (current) commTimer = setTimeout(endLate, options.limitMs);
    else end();
  }

  /** Give the current job its result, and begin the next. */
  function finish(/** @type {Said} */ said) {
    clearTimeout(timer);
    const job = current;
    current = null;
    const { startedMs } = job ?? {};
    const seconds = startedMs === undefined ? 0 : (performance.now() - startedMs) / 1000;
    job?.resolve({ ...said, seconds });
    next();
  }

  async function next() {
    if (current) return;
    const job = queue.shift();
    if (!job) return;
    current = job;
    try {
      if (ready.has(BASE)) job.say(loadingText);
      const table = job.table ? assets.load(job.table) : null;
      await Promise.all(job.parts.map(prepare));
      const content = await table;
      if (current !== job) return; // stopped meanwhile
      const isNew = job.table && !givenTables.has(job.table.name);
      if (job.table) givenTables.add(job.table.name);
      job.say("Running");
      job.startedMs = performance.now();
      timer = setTimeout(stopLate, options.limitMs);
      window.cameraLab.widgets?.flush(); // what the reader has moved counts
      worker?.postMessage({ ...job.order, table: isNew ? content : null });
    } catch (thrown) {
      const error = /** @type {Error} */ (thrown);
      end();
      if (current === job)
        finish({ result: "stopped", error: `Python did not start: ${error.message}.` });
    }
  }

  /**
   * Run code when its turn comes; resolves to what the worker says, or to {result: "stopped", error}.
   * @param {JobOrder} order
   * @returns {Promise<Said>}
   */
  function run(order) {
    return new Promise((resolve) => {
      queue.push({ ...order, parts: [BASE, ...(order.parts ?? [])], resolve });
      order.say(current ? "Waiting for what runs" : "Loading Python");
      next();
    });
  }

  /** Stop the job of a cell, whether it waits, loads or runs. */
  function stop(/** @type {string} */ key) {
    const place = queue.findIndex((job) => job.key === key);
    if (place >= 0) {
      const [job] = queue.splice(place, 1);
      job.resolve({ result: "stopped", error: "Stopped before it began." });
    } else if (current?.key === key) {
      const isRunning = current.startedMs !== undefined;
      if (isRunning) end();
      finish({
        result: "stopped",
        error: isRunning ? `Stopped. ${AGAIN}` : "Stopped before it began.",
      });
    }
  }

  const python = {
    run,
    stop,
    options,
    /** Hear that Python has ended, and everything it knew is gone. */
    listenForEnd: (/** @type {() => void} */ listener) => onEnd.push(listener),
    /** Hear what widgets in Python say. */
    listenForComm(/** @type {(message: CommMessage) => void} */ listener) {
      onComm = listener;
    },
    /** Tell widgets in Python something. */
    sendComm(/** @type {CommMessage} */ message) {
      clearTimeout(commTimer);
      commTimer = setTimeout(endLate, options.limitMs); // what a callback does may never end
      worker?.postMessage({ kind: "comm", message }, message.buffers);
    },
  };
  window.cameraLab = { ...window.cameraLab, python };
})();
