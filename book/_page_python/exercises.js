// Turns the exercise cells of a page into editors with buttons. Without this script the page is
// plain: the starter, the check, and how to ask for a hint in a notebook.
(() => {
  const { progress, python } = window.cameraLab;
  const isApple = /Mac|iPhone|iPad/.test(navigator.platform);
  const KEYS = isApple ? "Command and Enter" : "Ctrl and Enter";

  // what the status line says after a check; the verdict itself stands below it
  const SUMMARY = {
    passed: "Checked: passed.",
    failed: "Checked: not yet.",
    "not checked": "Not checked.",
    error: "Your code stops with an error.",
    stopped: "Stopped.",
  };

  /**
   * Make an element: a class, a text, attributes.
   * @template {keyof HTMLElementTagNameMap} Tag
   * @param {Tag} tag
   * @param {string} className
   * @param {string} text
   * @param {Record<string, string>} attributes
   */
  function make(tag, className, text = "", attributes = {}) {
    const element = document.createElement(tag);
    element.className = className;
    element.textContent = text;
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  }

  /**
   * @param {string} text
   * @param {string} className
   * @param {() => void} onClick
   */
  function makeButton(text, className, onClick) {
    const button = make("button", className, text, { type: "button" });
    button.addEventListener("click", onClick);
    return button;
  }

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

  class Exercise {
    /** @param {ReturnType<typeof find>} parts */
    constructor({ mount, source, check, hint, name }) {
      this.name = name;
      this.mount = mount;
      this.code = /** @type {HTMLElement} */ (source.querySelector("pre"));
      this.starter = String(this.code.textContent).replace(/\n$/, "");
      this.hints = python.data.exercises[name].hints;
      /** @type {string | null} */
      this.undo = null; // the text before a reset
      this.isBusy = false;
      this.isRestoring = false;
      /** @type {string | undefined} */
      this.checkedCode = undefined;
      this.checkButton = makeButton("Check", "exercise-check", () => this.check());
      this.stopButton = makeButton("Stop", "exercise-stop", () => python.stop(name));
      this.stopButton.hidden = true;
      this.hintButton = makeButton("Hint", "", () => this.hint());
      this.resetButton = makeButton("Reset", "", () => this.reset());
      this.status = make("p", "exercise-status", "", { role: "status" });
      this.hintList = make("ol", "exercise-hints", "", { "aria-live": "polite" });
      this.output = make("div", "exercise-output", "", { "aria-live": "polite" });
      this.editor = this.build();
      for (const cell of [source, check, hint]) cell.classList.add("exercise-replaced");
      mount.hidden = false;
      this.restore();
    }

    /** Put the parts on the page; returns the editor among them. */
    build() {
      const help = `exercise-help-${this.name}`;
      const frame = make("div", "exercise-editor");
      const buttons = make("div", "exercise-buttons", "", {
        role: "group",
        "aria-label": `Buttons of ${this.name}`,
      });
      buttons.append(this.checkButton, this.stopButton, this.hintButton, this.resetButton);
      const keys = `Tab indents; Escape, then Tab, leaves the editor. ${KEYS} checks.`;
      this.mount.append(frame, make("p", "exercise-help", keys, { id: help }));
      this.mount.append(buttons, this.status, this.hintList, this.output);
      const { createEditor } = /** @type {Required<Window>} */ (window).cameraLabEditor;
      return createEditor({
        parent: frame,
        text: this.starter,
        label: `Code of ${this.name}`,
        describedBy: help,
        onChange: (text) => this.keep(text),
        onCheck: () => this.check(),
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
    }

    /** What to know before the first click. */
    getNotice() {
      if (!progress.isKept()) return "This browser keeps nothing: your code is lost with the page.";
      const hosts = new Set(python.data.remote.map(({ url }) => new URL(url).host));
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
      progress.writeCode(this.name, text === this.starter ? null : text);
      if (this.checkedCode !== undefined) {
        this.output.classList.toggle("is-outdated", text !== this.checkedCode);
      }
      if (this.isRestoring) return;
      this.undo = null;
      this.resetButton.textContent = "Reset";
      if (!progress.isKept()) this.say(this.getNotice());
    }

    reset() {
      const before = this.editor.getText();
      const text = this.undo ?? this.starter;
      const undo = this.undo === null && before !== text ? before : null;
      this.editor.setText(text);
      this.undo = undo; // after the change, which forgets it
      this.resetButton.textContent = undo === null ? "Reset" : "Undo reset";
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
      this.setBusy(true);
      const started = performance.now();
      const said = await python.check(this.name, code, (text) => this.say(text));
      const seconds = (performance.now() - started) / 1000;
      this.setBusy(false);
      this.mount.dataset.seconds = seconds.toFixed(3);
      if (said.progress) progress.merge(progress.parse(said.progress));
      if (said.result !== "stopped") progress.writeResult(this.name, code, said);
      this.show(said, code);
      this.say(SUMMARY[said.result]);
    }

    setBusy(/** @type {boolean} */ isBusy) {
      const hadFocus = this.mount.contains(document.activeElement);
      const focused = document.activeElement;
      this.isBusy = isBusy;
      this.mount.setAttribute("aria-busy", String(isBusy));
      this.mount.dataset.state = isBusy ? "busy" : "idle";
      this.stopButton.hidden = !isBusy;
      this.checkButton.hidden = isBusy;
      // the button that had the focus has just gone
      if (hadFocus && focused === this.checkButton) this.stopButton.focus();
      if (hadFocus && focused === this.stopButton) this.checkButton.focus();
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
      const parts = [];
      if (said.html) parts.push(makeVerdict(said.html));
      if (said.error) parts.push(make("pre", "exercise-error", said.error));
      if (said.printed) {
        parts.push(make("p", "exercise-label", "Printed by your code:"));
        parts.push(make("pre", "exercise-printed", said.printed, { tabindex: "0" }));
      }
      parts.push(make("p", "exercise-outdated", "Your code has changed since this check."));
      this.output.replaceChildren(...parts);
    }
  }

  /** The verdict's own HTML, as in the notebook, in the colors of the page. */
  function makeVerdict(/** @type {string} */ html) {
    const verdict = make("div", "exercise-verdict");
    verdict.innerHTML = html;
    for (const element of verdict.querySelectorAll("[style]")) element.removeAttribute("style");
    nameLinks(verdict);
    return verdict;
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

  /** Links of verdicts that the build has put on the page say their heading, too. */
  function nameLinks(/** @type {Element} */ parent) {
    for (const link of parent.querySelectorAll("a")) {
      const title = python.data.titles[link.getAttribute("href") ?? ""];
      if (title !== undefined) link.textContent = title;
    }
  }

  function start() {
    for (const output of document.querySelectorAll(".cell_output")) nameLinks(output);
    if (!window.cameraLabEditor) return; // the page stays plain
    /** @type {NodeListOf<HTMLElement>} */
    const found = document.querySelectorAll(".exercise[data-exercise]");
    const mounts = [...found];
    const exercises = mounts.map((mount) => new Exercise(find(mount)));
    window.addEventListener("beforeprint", () => preparePrint(exercises));
  }

  document.addEventListener("DOMContentLoaded", start);
})();
