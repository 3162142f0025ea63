// The widget manager that the book brings for its explorers, and the far ends of comms, by which
// its models hear Python. Pages without explorers load it with the first widget.
(() => {
  const script = /** @type {HTMLScriptElement} */ (document.currentScript);
  const STATIC = new URL("..", script.src).href;
  const LOADER = "widget_loader.js"; // which names the files of the manager
  const TARGET = "jupyter.widget";

  /** @type {Promise<HtmlManagerModule> | null} */
  let loading = null;

  function loadLoader() {
    const element = document.createElement("script");
    element.src = STATIC + LOADER;
    return new Promise((resolve, reject) => {
      element.onload = resolve;
      element.onerror = () =>
        reject(new Error(`a file of this page could not be loaded: ${LOADER}`));
      document.head.append(element);
    });
  }

  /**
   * @param {string} name
   * @returns {Promise<never>}
   */
  function requireModule(name) {
    const load = /** @type {RequireModules} */ (/** @type {unknown} */ (window.requirejs));
    return new Promise((resolve, reject) => load([name], resolve, reject));
  }

  async function loadModule() {
    if (!window.cameraLab.loadWidgets) await loadLoader();
    await window.cameraLab.loadWidgets?.();
    return requireModule("@jupyter-widgets/html-manager");
  }

  /** Load the manager once; what failed is tried again the next time. */
  function load() {
    loading ??= loadModule().catch((error) => {
      loading = null;
      throw error;
    });
    return loading;
  }

  /**
   * Make the page's end of a comm. What comes before its model listens waits for it.
   * @param {string} id
   * @param {(message: CommMessage) => void} push
   * @returns {PageComm}
   */
  function makeComm(id, push) {
    /** @type {Record<"msg" | "close", ((told: object) => void) | null>} */
    const listeners = { msg: null, close: null };
    /** @type {{ kind: "msg" | "close", told: object }[]} */
    let waiting = [];
    const listen = (/** @type {"msg" | "close"} */ kind) => {
      return (/** @type {(told: object) => void} */ listener) => {
        listeners[kind] = listener;
        const due = waiting.filter((one) => one.kind === kind);
        waiting = waiting.filter((one) => one.kind !== kind);
        for (const { told } of due) listener(told);
      };
    };
    return {
      comm_id: id,
      target_name: TARGET,
      on_msg: listen("msg"),
      on_close: listen("close"),
      send(data, callbacks, metadata = {}, buffers = []) {
        const message = { comm_id: id, data, metadata, buffers: buffers.map(copyBuffer) };
        push({ type: "comm_msg", ...message });
        // The model would wait for this before it sends again; here the outbox waits.
        const idle = { content: { execution_state: "idle" } };
        queueMicrotask(() => callbacks?.iopub?.status?.(idle));
        return "";
      },
      close() {
        push({ type: "comm_close", comm_id: id, data: {}, buffers: [] });
      },
      hear(kind, message) {
        const told = toKernelMessage(message);
        const listener = listeners[kind];
        if (listener) listener(told);
        else waiting.push({ kind, told });
      },
    };
  }

  /** A message as a kernel would send it. */
  function toKernelMessage(/** @type {CommMessage} */ { comm_id, data, metadata, buffers }) {
    const views = buffers.map((buffer) => new DataView(buffer));
    return { content: { comm_id, data }, metadata: metadata ?? {}, buffers: views };
  }

  /** The bytes of a view, or of a whole buffer, for themselves. */
  function copyBuffer(/** @type {ArrayBuffer | ArrayBufferView} */ given) {
    if (given instanceof ArrayBuffer) return given.slice(0);
    const { buffer, byteOffset, byteLength } = given;
    return /** @type {ArrayBuffer} */ (buffer).slice(byteOffset, byteOffset + byteLength);
  }

  /**
   * Make a manager whose models live in Python; it never asks another host.
   * @param {(message: CommMessage) => void} push
   * @returns {Promise<LiveManager>}
   */
  async function makeManager(push) {
    const { HTMLManager } = await load();
    const manager = new HTMLManager({ loader: requireModule });
    /** @type {Map<string, PageComm>} */
    const comms = new Map();
    return {
      manager,
      hear(message) {
        const { comm_id, type } = message;
        if (type === "comm_open" && message.target_name === TARGET) {
          const comm = makeComm(comm_id, push);
          comms.set(comm_id, comm);
          manager.handle_comm_open(comm, toKernelMessage(message));
        } else if (type === "comm_msg") {
          comms.get(comm_id)?.hear("msg", message);
        } else if (type === "comm_close") {
          comms.get(comm_id)?.hear("close", message);
          comms.delete(comm_id);
        }
      },
    };
  }

  window.cameraLab = { ...window.cameraLab, makeWidgetManager: makeManager };
})();
