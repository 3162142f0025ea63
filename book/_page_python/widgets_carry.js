// What a reader has set in one explorer, set in another: the page has shown an explorer before
// Python made it anew, and nobody wants to move the same sliders twice.
(() => {
  const LONGEST_MS = 10_000; // an explorer draws itself within a second, or never

  /**
   * The explorers inside an element; a view hangs its model on its own element, see
   * labutils/explorers/static/_frame.js.
   * @param {Element} element
   */
  function findExplorers(element) {
    const roots = /** @type {NodeListOf<ExplorerElement>} */ (
      element.querySelectorAll(".explorer[data-explorer]")
    );
    return [...roots].filter((root) => root.explorerModel);
  }

  /**
   * The values that a reader has changed, by name.
   * @param {ExplorerElement["explorerModel"]} model
   */
  function readChanged(model) {
    const start = Object.entries(model.get("start"));
    const isChanged = (/** @type {[string, unknown]} */ [name, value]) =>
      JSON.stringify(model.get(name)) !== JSON.stringify(value);
    return start.filter(isChanged).map(([name]) => ({ name, value: model.get(name) }));
  }

  /**
   * Wait until as many explorers stand in an element as are meant, but not for ever.
   * @param {Element} element
   * @param {number} count
   * @returns {Promise<ExplorerElement[]>}
   */
  function waitForExplorers(element, count) {
    return new Promise((resolve) => {
      const look = () => {
        const found = findExplorers(element);
        if (found.length < count && timer) return;
        observer.disconnect();
        clearTimeout(timer);
        resolve(found);
      };
      /** @type {ReturnType<typeof setTimeout> | undefined} */
      let timer = setTimeout(() => {
        timer = undefined;
        look();
      }, LONGEST_MS);
      const observer = new MutationObserver(look);
      observer.observe(element, { childList: true, subtree: true });
      look();
    });
  }

  /**
   * Set in the explorers of one element what has been set in those of another.
   * @param {Element} from
   * @param {Element} to
   */
  async function carryValues(from, to) {
    const changes = findExplorers(from).map(({ dataset, explorerModel }) => ({
      kind: dataset.explorer,
      values: readChanged(explorerModel),
    }));
    if (!changes.some(({ values }) => values.length)) return;
    const targets = await waitForExplorers(to, changes.length);
    for (const [place, { kind, values }] of changes.entries()) {
      const target = targets[place];
      // the reader may have changed the code
      if (!values.length || target?.dataset.explorer !== kind) continue;
      const { explorerModel } = target;
      const known = explorerModel.get("start");
      for (const { name, value } of values) if (name in known) explorerModel.set(name, value);
      explorerModel.save_changes();
    }
  }

  window.cameraLab = { ...window.cameraLab, carryValues };
})();
