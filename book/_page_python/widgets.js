// Live widgets: what Python in the page shows as a widget, and what the reader does with it. The
// models live on both sides; python.js carries the messages between them.
(() => {
  const { makeOutbox, makeWidgetManager, carryValues } = window.cameraLab;
  const VIEW = "application/vnd.jupyter.widget-view+json";
  const LONGEST_MS = 10_000; // that an element may take until it is in the page
  const STOPPED = "Python was stopped: this no longer reaches it. Run the cell again.";

  /** @type {Promise<LiveManager> | null} */
  let live = null;
  /** @type {CommMessage[]} */
  let unheard = []; // while the manager loads
  const outbox = makeOutbox((message) => widgets.onSend(message));

  /** Start the manager, which first hears what has come meanwhile. */
  function start() {
    const started = makeWidgetManager((message) => {
      if (live === started) outbox.push(message); // else Python was stopped
    }).then((ready) => {
      if (live === started) {
        for (const message of unheard) ready.hear(message);
        unheard = [];
        heard = ready;
      }
      return ready;
    });
    started.catch(() => {
      if (live === started) live = null;
    });
    return started;
  }

  /** @type {LiveManager | null} */
  let heard = null; // the manager, once it is loaded

  /**
   * Hear a message of Python.
   * @param {CommMessage} message
   */
  function hear(message) {
    if (message.type === "comm_done") {
      outbox.done(message.data.id);
    } else if (message.type === "comm_said") {
      sayBelow(message);
    } else if (heard) {
      heard.hear(message);
    } else {
      unheard.push(message);
      live ??= start();
    }
  }

  /**
   * Show a widget inside an element of the page, or say there why not.
   * @param {Bundle} bundle
   * @param {HTMLElement} element
   */
  async function show(bundle, element) {
    try {
      const { model_id } = /** @type {{ model_id: string }} */ (bundle[VIEW]);
      live ??= start();
      const { manager } = await live;
      const model = await manager.get_model(model_id);
      const view = await manager.create_view(model);
      await waitUntilConnected(element);
      const place = document.createElement("div");
      place.className = "widget-subarea widget-live";
      element.append(place);
      await manager.display_view(view, place);
      Object.assign(place, { liveView: view, liveIds: collectIds(model) });
    } catch (thrown) {
      const problem = document.createElement("pre");
      problem.textContent = `This widget cannot be shown: ${toMessage(thrown)}`;
      element.append(problem);
    }
  }

  /** What went wrong, in words; require.js and the manager throw what they like. */
  function toMessage(/** @type {unknown} */ thrown) {
    return thrown instanceof Error ? thrown.message : String(thrown);
  }

  /** A widget can be attached only to what is in the page; whoever made the element puts it there. */
  async function waitUntilConnected(/** @type {Element} */ element) {
    const latest = performance.now() + LONGEST_MS;
    while (!element.isConnected) {
      if (performance.now() > latest) throw new Error("its place is not in the page");
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
  }

  /**
   * The ids of a model and of all below it.
   * @param {WidgetModel} model
   * @returns {Set<string>}
   */
  function collectIds(model) {
    const ids = new Set([model.model_id]);
    const children = /** @type {WidgetModel[] | undefined} */ (model.get("children"));
    for (const child of children ?? []) {
      for (const id of collectIds(child)) ids.add(id);
    }
    return ids;
  }

  function listPlaces() {
    return [.../** @type {NodeListOf<LivePlace>} */ (document.querySelectorAll(".widget-live"))];
  }

  /** Show what a callback has printed, below the widget that called it. */
  function sayBelow(/** @type {CommMessage} */ { comm_id, data }) {
    const places = listPlaces();
    const place = places.findLast((one) => one.liveIds?.has(comm_id)) ?? places.at(-1);
    if (!place) return;
    let said = place.querySelector(":scope > .widget-said");
    if (!said) {
      said = document.createElement("div");
      said.className = "widget-said";
      place.append(said);
    }
    said.replaceChildren();
    widgets.showOutputs(data.outputs ?? [], /** @type {HTMLElement} */ (said));
  }

  /**
   * Show outputs as text.
   * @param {CellOutput[]} outputs
   * @param {HTMLElement} element
   */
  function showAsText(outputs, element) {
    for (const output of outputs) {
      const block = document.createElement("pre");
      if (output.output_type === "stream") block.textContent = output.text;
      else if (output.output_type === "error") block.textContent = output.traceback.join("\n");
      else block.textContent = String(output.data["text/plain"]);
      element.append(block);
    }
  }

  /** Take the widgets out of an element that is going to show something else. */
  function clear(/** @type {Element} */ element) {
    const places = /** @type {NodeListOf<LivePlace>} */ (element.querySelectorAll(".widget-live"));
    for (const place of places) {
      place.liveView?.remove();
      place.remove();
    }
  }

  /** Say that Python is gone; what is shown stays, and moves, but reaches nobody. */
  function reset() {
    if (!live) return;
    live.then(({ manager }) => manager.disconnect()).catch(() => {});
    live = heard = null;
    unheard = [];
    outbox.clear();
    for (const place of listPlaces()) {
      if (place.dataset.state === "stopped") continue;
      place.dataset.state = "stopped";
      const note = document.createElement("p");
      note.className = "widget-note";
      note.textContent = STOPPED;
      place.append(note);
    }
  }

  /**
   * Set in the live explorers of an element what the reader has set in those of another; done
   * once Python knows.
   * @param {Element} from
   * @param {Element} to
   */
  async function carry(from, to) {
    await carryValues(from, to);
    await new Promise((resolve) => setTimeout(resolve)); // links pass on what was set
    await outbox.whenQuiet();
  }

  const widgets = {
    show,
    hear,
    carry,
    clear,
    reset,
    /** Send all that waits: to be called before Python gets a cell to run. */
    flush: outbox.flush,
    /** @type {(message: CommMessage) => void} */
    onSend: () => {},
    /** @type {(outputs: CellOutput[], element: HTMLElement) => void} */
    showOutputs: showAsText,
  };
  window.cameraLab = { ...window.cameraLab, widgets };
})();
