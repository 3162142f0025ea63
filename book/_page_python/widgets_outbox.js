// Messages of widgets on their way to Python. Python hears them only between cells, and a slider
// that is dragged sends many: while some are on their way, new states of a model are joined into
// one, of which the latest values count.
(() => {
  /**
   * Make an outbox.
   * @param {(message: CommMessage) => void} post
   * @returns {CommOutbox}
   */
  function makeOutbox(post) {
    /** @type {CommMessage[]} */
    let queue = [];
    const onTheirWay = new Set();
    let lastId = 0;
    let isDue = false;
    /** @type {(() => void)[]} */
    let listeners = [];

    function flush() {
      for (const message of queue) {
        lastId += 1;
        onTheirWay.add(lastId);
        post({ ...message, id: lastId });
      }
      queue = [];
    }

    /** What one task of the page sends leaves together, so that Python answers once. */
    function flushSoon() {
      if (isDue || onTheirWay.size) return;
      isDue = true;
      queueMicrotask(() => {
        isDue = false;
        if (!onTheirWay.size) flush();
      });
    }

    function tellIfQuiet() {
      if (queue.length || onTheirWay.size) return;
      const told = listeners;
      listeners = [];
      for (const listen of told) listen();
    }

    return {
      push(message) {
        const before = queue.findLast((one) => one.comm_id === message.comm_id);
        if (before && isUpdate(before) && isUpdate(message)) join(before, message);
        else queue.push(message);
        flushSoon();
      },
      flush,
      done(id) {
        onTheirWay.delete(id);
        if (!onTheirWay.size) flush();
        tellIfQuiet();
      },
      whenQuiet() {
        return new Promise((resolve) => {
          listeners.push(resolve);
          tellIfQuiet();
        });
      },
      clear() {
        queue = [];
        onTheirWay.clear();
        tellIfQuiet();
      },
    };
  }

  function isUpdate(/** @type {CommMessage} */ { type, data }) {
    return type === "comm_msg" && data.method === "update";
  }

  /**
   * Put newer values over older ones, their binary parts with them.
   * @param {CommMessage} before
   * @param {CommMessage} after
   */
  function join(before, after) {
    const newPaths = after.data.buffer_paths ?? [];
    // a value that is binary itself is no part of the state: only its path names it
    const names = new Set([
      ...Object.keys(after.data.state ?? {}),
      ...newPaths.map(([one]) => one),
    ]);
    const state = Object.entries(before.data.state ?? {}).filter(([name]) => !names.has(name));
    const kept = (before.data.buffer_paths ?? [])
      .map((path, place) => ({ path, buffer: before.buffers[place] }))
      .filter(({ path }) => !names.has(path[0]));
    before.data = {
      method: "update",
      state: { ...Object.fromEntries(state), ...after.data.state },
      buffer_paths: [...kept.map(({ path }) => path), ...newPaths],
    };
    before.buffers = [...kept.map(({ buffer }) => buffer), ...after.buffers];
  }

  window.cameraLab = { ...window.cameraLab, makeOutbox };
})();
