// Turns the exercise cells of a page into editors with buttons. Without this script the page is
// plain: the starter, the check, and how to ask for a hint in a notebook.
(() => {
  const { assets, outputs, progress, python, session, tabs, verdicts } = window.cameraLab;
  const { KEYS, make } = window.cameraLab.elements;
  const { data } = verdicts;

  // what the status line says after a check; the verdict itself stands below it
  const SUMMARY = {
    passed: "Checked: passed.",
    failed: "Checked: not yet.",
    "not checked": "Not checked.",
    error: "Your code stops with an error.",
    stopped: "Stopped.",
    ran: "Ran.",
  };

  /**
   * The parts of one exercise: the mount that the build has put before its cell, and the cells.
   * @param {HTMLElement} mount
   */
  function find(mount) {
    const name = String(mount.dataset.exercise);
    const [source, check, hint] = ["source", "check", "hint"].map(
      (part) => /** @type {HTMLElement} */ (document.querySelector(`.exercise-${part}-${name}`)),
    );
    return { mount, source, check, hint, name };
  }

  /** @implements {SessionCell} */
  class Exercise {
    printed = ""; // by what runs

    /** @param {ReturnType<typeof find>} parts */
    constructor({ mount, source, check, hint, name }) {
      this.name = name;
      this.mount = mount;
      this.code = /** @type {HTMLElement} */ (source.querySelector("pre"));
      this.starter = String(this.code.textContent).replace(/\n$/, "");
      this.hints = data.exercises[name].hints;
      /** @type {string | null} */
      this.undo = null; // the text before a reset
      this.isBusy = false;
      this.isRestoring = false;
      /** @type {string | undefined} */
      this.checkedCode = undefined;
      this.element = mount;
      this.key = this.title = name;
      this.isNeededBelow = false;
      this.skipped = "";
      this.text = "";
      this.doing = ""; // "check" or "run"
      this.buttons = new window.cameraLab.ExerciseButtons(name, {
        run: () => session.run(this),
        check: () => this.check(),
        stop: () => this.stop(),
        hint: () => this.hint(),
        reset: () => this.reset(),
      });
      this.status = make("p", "exercise-status", "", { role: "status" });
      this.hintList = make("ol", "exercise-hints", "", { "aria-live": "polite" });
      this.output = make("div", "exercise-output", "", { "aria-live": "polite" });
      this.shown = make("div", "exercise-shown cell-yours");
      this.tabs = tabs.watch(this);
      this.editor = this.build();
      for (const cell of [source, check, hint]) cell?.classList.add("exercise-replaced");
      mount.hidden = false;
      this.restore();
    }

    /** Put the parts on the page; returns the editor among them. */
    build() {
      const help = `exercise-help-${this.name}`;
      const frame = make("div", "exercise-editor");
      const keys = `Tab indents, or takes the name offered; Escape, then Tab, leaves the editor. ${KEYS} checks, Shift and Enter runs.`;
      this.mount.append(this.tabs.element, frame, make("p", "exercise-help", keys, { id: help }));
      this.mount.append(this.buttons.element, this.status, this.hintList, this.output, this.shown);
      const { createEditor } = /** @type {Required<Window>} */ (window).cameraLabEditor;
      return createEditor({
        parent: frame,
        text: this.starter,
        label: `Code of ${this.name}`,
        describedBy: help,
        onChange: (text) => this.keep(text),
        onCheck: () => this.check(),
        onRun: () => session.run(this),
        folds: true,
      });
    }

    /** Bring back the reader's code and the last result. */
    restore() {
      const code = progress.readCode(this.name);
      const stored = progress.readResult(this.name);
      if (code !== null && code !== this.starter) {
        this.isRestoring = true;
        this.editor.setText(code);
        this.isRestoring = false;
      }
      if (stored) this.show(stored.said, stored.code);
      this.say(code === null ? this.getNotice() : "Restored: your code from last time.");
      this.tabs.show();
    }

    /** What to know before the first click. */
    getNotice() {
      if (!progress.isKept()) return "This browser keeps nothing: your code is lost with the page.";
      const hosts = new Set(assets.data.remote.map(({ url }) => new URL(url).host));
      if (!hosts.size) return "";
      return `The first check loads NumPy and OpenCV from ${[...hosts]}: it needs a network.`;
    }

    say(/** @type {string} */ text) {
      if (this.status.textContent !== text) this.status.textContent = text;
    }

    /**
     * Keep what the reader has typed.
     * @param {string} text
     */
    keep(text) {
      const code = text === this.starter ? null : text;
      if (!this.isRestoring) this.tabs.keep(code);
      progress.writeCode(this.name, code);
      if (this.checkedCode !== undefined) {
        this.output.classList.toggle("is-outdated", text !== this.checkedCode);
      }
      if (this.isRestoring) return;
      this.undo = null;
      this.buttons.nameReset(false);
      if (!progress.isKept()) this.say(this.getNotice());
    }

    reset() {
      const before = this.editor.getText();
      const text = this.undo ?? this.starter;
      const undo = this.undo === null && before !== text ? before : null;
      this.editor.setText(text);
      this.undo = undo; // after the change, which forgets it
      this.buttons.nameReset(undo !== null);
      this.say(undo === null ? "Your code is back." : "This is the starter again.");
      if (undo === null && text === this.starter) this.say("This is the starter.");
    }

    /** Show the next hint; after the last, the last again. */
    hint() {
      const number = progress.countHint(this.name);
      const text = `Hint ${number} of ${this.hints.length}: ${this.hints[number - 1]}`;
      for (const item of this.hintList.children) if (item.textContent === text) return;
      this.hintList.append(make("li", "", text));
    }

    async check() {
      if (this.isBusy) return;
      const code = this.editor.getText();
      this.doing = "check";
      this.setBusy(true);
      this.shown.replaceChildren();
      const started = performance.now();
      let said = await this.askForVerdict(code);
      // the code asks for what the cells above make
      if (said.missing && (await session.runAbove(this))) said = await this.askForVerdict(code);
      const seconds = (performance.now() - started) / 1000;
      this.mount.dataset.seconds = seconds.toFixed(3);
      if (said.result === "stopped") said.printed = this.printed;
      if (said.progress) progress.merge(progress.parse(said.progress));
      if (said.result !== "stopped") progress.writeResult(this.name, code, said);
      this.show(said, code);
      this.tell(said, code);
      if (said.result === "passed") await this.goOn();
      this.setBusy(false);
    }

    askForVerdict(/** @type {string} */ code) {
      this.begin();
      return python.run({
        key: this.key,
        order: { kind: "check", code, exercise: this.name, progress: progress.text() },
        parts: /\bmujoco\b/.test(code) ? ["simulator"] : data.exercises[this.name].parts,
        table: data.tables[this.name],
        say: (text) => this.say(text),
        onPrinted: (text) => this.print(text),
      });
    }

    /** Say how it went, and mark the line that stopped. */
    tell(/** @type {Said} */ said, /** @type {string} */ code) {
      const { line, result } = said;
      const summary = SUMMARY[/** @type {keyof typeof SUMMARY} */ (result)];
      const isSame = code === this.editor.getText(); // or the line is another one now
      this.editor.markLine(isSame ? (line ?? null) : null);
      const place = result === "error" ? summary.replace(".", "") : `${summary} It stopped`;
      this.say(line ? `${place} in line ${line}.` : summary);
    }

    stop() {
      if (this.doing === "check") python.stop(this.key);
      session.stop(this);
    }

    // --- Run: the session of the page has this exercise as one of its cells ---

    /** The reader's code; after a pass also the call that shows what it does. */
    getText() {
      return this.editor.getText() + this.text;
    }

    wait() {
      if (this.doing === "check") return;
      this.doing = "run";
      this.setBusy(true);
    }

    rest() {
      if (this.doing !== "check") this.setBusy(false);
    }

    begin() {
      this.printed = "";
    }

    print(/** @type {string} */ text) {
      this.printed += text;
    }

    /** What has run, where the code was. */
    async finish(/** @type {Said} */ said, /** @type {RunInfo} */ { code }) {
      const all = said.result === "stopped" ? { ...said, printed: this.printed } : said;
      const parts = outputs.makeAll(all, []);
      const title = this.text ? "Your function at work:" : "Your code, run:";
      this.shown.replaceChildren(make("p", "exercise-label", title), ...parts);
      this.mount.dataset.ran = said.result;
      if (this.text) return; // the verdict has been told
      const silent = "Ran. To see what your function gives, call it below: show(...).";
      this.tell(said, code);
      if (said.result === "ran" && !parts.length) this.say(silent);
    }

    fail(/** @type {SessionCell} */ above) {
      this.say(`Did not run: ${above.title} has to run first, and stopped.`);
    }

    forget() {}

    /** After a pass: the reader's own result, and the way on. */
    async goOn() {
      this.output.append(window.cameraLab.makeWayOn(this.name));
      this.text = `\n\n${data.exercises[this.name].example}`;
      await session.run(this);
      this.text = "";
      this.say(SUMMARY.passed);
    }

    setBusy(/** @type {boolean} */ isBusy) {
      this.isBusy = isBusy;
      this.mount.setAttribute("aria-busy", String(isBusy));
      this.mount.dataset.state = isBusy ? "busy" : "idle";
      this.buttons.setBusy(isBusy, this.doing);
      if (!isBusy) this.doing = "";
    }

    /**
     * Show what a check said, and of which code.
     * @param {Said} said
     * @param {string} code
     */
    show(said, code) {
      this.checkedCode = code;
      this.mount.dataset.result = said.result;
      this.output.classList.toggle("is-outdated", code !== this.editor.getText());
      const parts = verdicts.makeParts(said);
      this.output.replaceChildren(...parts);
    }
  }

  /** On paper there is the plain cell: with the reader's code, where it is not the starter. */
  function preparePrint(/** @type {Exercise[]} */ exercises) {
    for (const { code, editor, starter } of exercises) {
      const text = editor.getText();
      code.dataset.starter ??= code.innerHTML;
      if (text === starter) code.innerHTML = code.dataset.starter;
      else code.textContent = text;
    }
  }

  function start() {
    for (const output of document.querySelectorAll(".cell_output")) verdicts.nameLinks(output);
    if (!window.cameraLabEditor) return; // the page stays plain
    /** @type {NodeListOf<HTMLElement>} */
    const found = document.querySelectorAll(".exercise[data-exercise]");
    const mounts = [...found];
    const exercises = mounts.map((mount) => new Exercise(find(mount)));
    for (const exercise of exercises) session.add(exercise);
    window.addEventListener("beforeprint", () => preparePrint(exercises));
  }

  document.addEventListener("DOMContentLoaded", start);
})();
