// In which order the cells of a page run: as in a notebook from top to bottom, those above first.
// What stands in a cell is the business of cells.js and exercises.js, which add their cells here.
(() => {
  const { assets, elements, outputs, python } = window.cameraLab;

  /** @type {SessionCell[]} */
  const cells = [];
  /** @type {Map<SessionCell, string>} */
  const ran = new Map(); // cell: the code of it that Python has run
  let tail = Promise.resolve(); // one run after the other

  const WIDGET_SCRIPTS = [
    "widgets_outbox.js",
    "widgets_manager.js",
    "widgets_carry.js",
    "widgets.js",
  ];
  const LATE_MS = 500; // that a picture may take to get its size

  /** Cells that need these parts of Python name them. */
  const WIDGETS = /\b(?:explorers?|ipywidgets|anywidget|interact)\b/;
  const SIMULATOR = /\b(?:mujoco|labutils|lab)\b/;
  const RECORDINGS = /\b(?:recordings|load_recording)\b/;

  /**
   * Which parts of Python code needs.
   * @param {string} code
   */
  function findParts(code) {
    const parts = SIMULATOR.test(code) ? ["simulator"] : [];
    if (RECORDINGS.test(code)) parts.push("recordings");
    return WIDGETS.test(code) ? [...parts, "widgets"] : parts;
  }

  /** Load what draws live widgets, the first time that code makes some. */
  async function loadWidgets() {
    if (window.cameraLab.widgets) return;
    for (const script of WIDGET_SCRIPTS) await assets.loadScript(script);
    const { widgets } = /** @type {Required<CameraLab>} */ (window.cameraLab);
    widgets.onSend = python.sendComm;
    widgets.showOutputs = (said, element) =>
      element.replaceChildren(...outputs.makeAll({ result: "ran", outputs: said }, []));
    python.listenForComm(widgets.hear);
    python.listenForEnd(widgets.reset);
  }

  /** Add a cell; they come in the order of the page. */
  function add(/** @type {SessionCell} */ cell) {
    cells.push(cell);
    cells.sort((a, b) =>
      a.element.compareDocumentPosition(b.element) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1,
    );
  }

  /** Cells above that have to run first: from the first one on that has not run as it stands. */
  function findNeeded(/** @type {SessionCell} */ cell) {
    const above = cells.slice(0, cells.indexOf(cell)).filter((one) => one.isNeededBelow);
    const first = above.findIndex((one) => ran.get(one) !== one.getText());
    return first < 0 ? [] : above.slice(first);
  }

  /**
   * Run one cell, now.
   * @param {SessionCell} cell
   * @param {SessionCell} asked the cell whose button was pressed
   * @param {boolean} isWanted whether the reader wants to see what it gives
   * @returns {Promise<boolean>} whether those below may run
   */
  async function runOne(cell, asked, isWanted) {
    const code = cell.getText();
    const before = ran.get(cell);
    cell.begin();
    const parts = findParts(code);
    if (parts.includes("widgets")) await loadWidgets();
    const said = await python.run({
      key: cell.key,
      order: { kind: "cell", code, name: cell.name, isSetup: cell.isNeededBelow },
      parts,
      say(text) {
        cell.say(text);
        if (asked !== cell) asked.say(`${cell.title}: ${text}`);
      },
      onPrinted: (text) => cell.print(text),
    });
    if (said.result === "ran") {
      // what was made from the older text, below, is no longer true
      if (before !== undefined && before !== code) forgetBelow(cell);
      ran.set(cell, code);
    }
    await cell.finish(said, { code, isAsked: cell === asked, isWanted });
    return said.result === "ran";
  }

  function forgetBelow(/** @type {SessionCell} */ cell) {
    for (const below of cells.slice(cells.indexOf(cell) + 1)) ran.delete(below);
  }

  /**
   * Run cells in order; stops at the first that fails.
   * @param {SessionCell[]} wanted
   * @param {SessionCell} asked
   * @param {Turn} turn
   */
  async function runAllOf(wanted, asked, turn) {
    for (const cell of wanted) {
      if (turn.isStopped) return false;
      turn.running = cell;
      if (!(await runOne(cell, asked, cell === asked))) {
        if (cell !== asked) asked.fail(cell);
        return false;
      }
    }
    return true;
  }

  /** @type {Map<SessionCell, Turn>} */
  const turns = new Map();

  /**
   * Wait for one's turn, then do something that runs cells.
   * @param {SessionCell} asked
   * @param {(turn: Turn) => Promise<boolean>} work
   * @returns {Promise<boolean>}
   */
  function takeTurn(asked, work) {
    /** @type {Turn} */
    const turn = { isStopped: false, running: null };
    turns.set(asked, turn);
    asked.wait();
    const done = tail.then(async () => {
      if (turn.isStopped) return false;
      const letGo = elements.keepInPlace(asked.element);
      return work(turn).finally(() => setTimeout(letGo, LATE_MS));
    });
    tail = done.then(
      () => {},
      () => {},
    );
    return done.finally(() => {
      turns.delete(asked);
      asked.rest();
    });
  }

  /**
   * Run a cell, and first those above that it needs; resolves to whether all went well.
   * @param {SessionCell} cell
   */
  function run(cell) {
    return takeTurn(cell, (turn) => runAllOf([...findNeeded(cell), cell], cell, turn));
  }

  /**
   * Run what a cell needs from above, and not the cell.
   * @param {SessionCell} cell
   */
  function runAbove(cell) {
    return takeTurn(cell, (turn) => runAllOf(findNeeded(cell), cell, turn));
  }

  /**
   * Run all cells of the page from the top; one that fails does not keep the others from running.
   * @param {SessionCell} asked the bar of the page, which takes part as a cell
   */
  function runAll(asked) {
    return takeTurn(asked, async (turn) => {
      let good = true;
      for (const cell of cells.filter((one) => !one.skipped)) {
        if (turn.isStopped) return false;
        turn.running = cell;
        good = (await runOne(cell, asked, true)) && good;
      }
      return good;
    });
  }

  /** Stop what was begun with a cell. */
  function stop(/** @type {SessionCell} */ asked) {
    const turn = turns.get(asked);
    if (!turn) return;
    turn.isStopped = true;
    if (turn.running) python.stop(turn.running.key);
  }

  python.listenForEnd(() => {
    ran.clear();
    for (const cell of cells) cell.forget();
  });

  const session = {
    cells,
    add,
    findParts,
    run,
    runAbove,
    runAll,
    stop,
    hasRun: (/** @type {SessionCell} */ cell) => ran.get(cell) === cell.getText(),
  };
  window.cameraLab = { ...window.cameraLab, session };
})();
