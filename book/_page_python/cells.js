// Makes the code cells of a page live: Run, Edit, Reset, and the reader's output where the book's
// stands. Without this script, and on paper, the page shows what the build has computed.
(() => {
  const { CellResult, assets, edits, elements, session } = window.cameraLab;
  const { KEYS, make, makeButton } = elements;
  const { page } = assets.data;

  /** Tags of cells that need what no page has: what is said instead of running them. */
  const SKIPPED = new Map([
    ["needs-process", "This cell starts another program, which a page cannot: run the notebook."],
  ]);

  /** The same for cells of which a part needs it: what is said beside what the rest gives. */
  const NOTES = new Map([
    ["uses-open3d", " No page has Open3D: its part of this cell is left out."],
  ]);

  /** @type {LiveCell[]} */
  const cells = [];
  const live = make("p", "cells-live", "", { role: "status" }); // what a screen reader hears, once

  function announce(/** @type {string} */ text) {
    live.textContent = text;
  }

  const capitalize = (/** @type {string} */ text) => text.charAt(0).toUpperCase() + text.slice(1);

  /** Keep the edits of all cells. */
  function keepEdits() {
    const changed = cells.filter((cell) => cell.isEdited());
    const kept = edits.write(
      page,
      changed.map((cell) => ({ source: cell.source, code: cell.getText() })),
    );
    if (!kept) announce("This browser keeps nothing: your changes are lost with the page.");
    document.dispatchEvent(new CustomEvent("camera-lab-cells"));
  }

  /** @implements {SessionCell} */
  class LiveCell {
    /**
     * @param {HTMLElement} element
     * @param {number} number
     */
    constructor(element, number) {
      this.element = element;
      this.number = number;
      this.title = `Cell ${number}`;
      this.name = `cell ${number}`;
      this.key = this.name;
      this.isNeededBelow = true;
      this.input = /** @type {HTMLElement} */ (element.querySelector(".cell_input"));
      this.pre = /** @type {HTMLElement} */ (this.input.querySelector("pre"));
      this.result = new CellResult(this.name, element.querySelector(".cell_output"));
      this.source = String(this.pre.textContent).replace(/\n$/, "");
      this.code = this.source;
      /** @type {CodeEditor | null} */
      this.editor = null;
      /** @type {string | null} */
      this.undo = null; // the text before a reset
      this.isBusy = false;
      this.skipped = this.findByTag(SKIPPED);
      this.note = this.findByTag(NOTES);
      if (this.skipped) this.isNeededBelow = false;
      this.runButton = makeButton("Run", "cell-run", () => this.press());
      this.editButton = makeButton("Edit", "", () => this.edit());
      this.resetButton = makeButton("Reset", "", () => this.reset());
      this.status = make("span", "cell-status");
      this.build();
    }

    /** What is said of a cell with a tag; nothing without one. */
    findByTag(/** @type {Map<string, string>} */ texts) {
      const tags = [...texts.keys()].filter((one) => this.element.classList.contains(`tag_${one}`));
      return tags.map((tag) => texts.get(tag)).join("");
    }

    build() {
      const bar = make("div", "cell-bar");
      const buttons = make("span", "cell-buttons", "", {
        role: "group",
        "aria-label": `Buttons of ${this.name}`,
      });
      for (const button of [this.runButton, this.editButton, this.resetButton]) {
        button.setAttribute("aria-label", `${button.textContent} ${this.name}`);
        buttons.append(button);
      }
      this.resetButton.hidden = true;
      bar.append(buttons, make("span", "cell-number", this.title), this.status);
      bar.append(this.result.switch);
      this.input.after(bar);
      this.element.append(this.result.element);
      this.element.classList.add("is-live");
      if (this.skipped) {
        this.runButton.hidden = true;
        this.say(this.skipped);
      }
    }

    // --- what the reader does ---

    press() {
      if (this.isBusy) session.stop(this);
      else session.run(this);
    }

    async edit() {
      if (!this.editor) {
        this.say("Loading the editor");
        try {
          await this.openEditor();
        } catch (error) {
          this.say(`No editor: ${/** @type {Error} */ (error).message}.`);
          return;
        }
        this.say("");
      }
      this.editor?.focus();
    }

    async openEditor() {
      if (!window.cameraLabEditor) await assets.loadScript("editor.js");
      const { createEditor } = /** @type {Required<Window>} */ (window).cameraLabEditor;
      const help = `cell-help-${this.number}`;
      const frame = make("div", "exercise-editor cell-editor");
      const keys = `Tab indents, or takes the name offered; Escape, then Tab, leaves the editor. ${KEYS} runs.`;
      this.input.append(frame, make("p", "exercise-help", keys, { id: help }));
      this.editor = createEditor({
        parent: frame,
        text: this.code,
        label: `Code of ${this.name}`,
        describedBy: help,
        onChange: (text) => this.keep(text),
        onCheck: () => this.isBusy || session.run(this),
      });
      this.element.classList.add("is-editing");
      this.editButton.hidden = true;
    }

    keep(/** @type {string} */ text) {
      this.code = text;
      this.undo = null;
      this.showEdit();
      keepEdits();
    }

    reset() {
      const before = this.getText();
      const undo = this.undo;
      this.setText(undo ?? this.source);
      this.undo = undo === null ? before : null; // after the change, which forgets it
      this.showEdit();
      if (undo === null) this.result.choose(false);
      this.tell(undo === null ? "this is the book's cell again." : "your code is back.");
    }

    // --- its text ---

    getText() {
      return this.code;
    }

    setText(/** @type {string} */ text) {
      if (this.editor) this.editor.setText(text);
      else this.code = text;
      this.showEdit();
      keepEdits();
    }

    isEdited() {
      return this.code !== this.source;
    }

    /** Say that the cell was changed; without an editor its new text stands in a box of its own. */
    showEdit() {
      const isEdited = this.isEdited();
      this.element.classList.toggle("is-edited", isEdited);
      this.resetButton.hidden = !isEdited && this.undo === null;
      this.resetButton.textContent = this.undo === null ? "Reset" : "Undo reset";
      this.resetButton.setAttribute("aria-label", `${this.resetButton.textContent} ${this.name}`);
      let box = this.input.querySelector(".cell-changed");
      if (isEdited && !this.editor) {
        box ??= this.input.appendChild(make("pre", "cell-changed", "", { tabindex: "0" }));
        box.textContent = this.code;
      } else {
        box?.remove();
      }
    }

    // --- what the session tells ---

    say(/** @type {string} */ text) {
      if (this.status.textContent !== text) this.status.textContent = text;
    }

    /** Say something that a screen reader should hear. */
    tell(/** @type {string} */ text) {
      this.say(capitalize(text));
      announce(`${this.title}: ${text}`);
    }

    wait() {
      this.isBusy = true;
      this.showButton();
      announce(`${this.title}: running`);
    }

    rest() {
      this.isBusy = false;
      this.showButton();
    }

    /** One button, so that the focus stays where it is. */
    showButton() {
      this.runButton.textContent = this.isBusy ? "Stop" : "Run";
      this.runButton.setAttribute("aria-label", `${this.runButton.textContent} ${this.name}`);
      this.element.setAttribute("aria-busy", String(this.isBusy));
    }

    begin() {
      this.result.begin();
      this.element.dataset.state = "busy";
    }

    print(/** @type {string} */ text) {
      this.result.print(text, this.isBusy);
    }

    /**
     * @param {Said} said
     * @param {RunInfo} info
     */
    async finish(said, { code, isAsked, isWanted }) {
      this.element.dataset.state = "idle";
      this.element.dataset.result = said.result;
      // what the reader has not asked for, and what is as in the book, need not be seen anew
      const isNews = isWanted || cells.some((cell) => cell.isEdited());
      const isShown = await this.result.show(said, code === this.source, isNews);
      const seconds = said.seconds ?? 0;
      const time = seconds < 0.1 ? "less than 0.1 s" : `${seconds.toFixed(1)} s`;
      const ran = `ran in ${time}${isShown ? "" : ", nothing to show"}${this.note && `.${this.note}`}`;
      this.editor?.markLine(code === this.code ? (said.line ?? null) : null);
      const error = `stopped with an error${said.line ? `, line ${said.line}` : ""}`;
      const text = { ran, error, stopped: "stopped" }[
        /** @type {"ran" | "error" | "stopped"} */ (said.result)
      ];
      if (isAsked) this.tell(text);
      else this.say(capitalize(text));
    }

    /** A cell above has failed, so this one did not run. */
    fail(/** @type {SessionCell} */ above) {
      this.tell(`did not run: ${above.title} has to run first, and stopped.`);
    }

    /** Python has ended: what ran is no longer known. */
    forget() {
      if (this.element.dataset.state === "idle") this.say("Python was stopped: not run since");
    }
  }

  /** Bring back the reader's edits. */
  function restore() {
    for (const { source, code } of edits.open(page)) {
      const cell = cells.find((one) => one.source === source && !one.isEdited());
      if (!cell) continue;
      cell.code = code;
      cell.showEdit();
      cell.say("Restored: your code from last time");
    }
  }

  /** An address inside a picture of the book shows that picture. */
  function showTarget() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const cell = cells.find(({ result }) => target && result.built?.contains(target));
    cell?.result.choose(false);
  }

  function start() {
    /** @type {NodeListOf<HTMLElement>} */
    const found = document.querySelectorAll(".cell:not(.tag_exercise):not(.exercise-check)");
    for (const element of found) {
      if (!element.querySelector(".cell_input pre")) continue;
      const cell = new LiveCell(element, cells.length + 1);
      cells.push(cell);
      session.add(cell);
    }
    if (!cells.length) return;
    document.body.append(live);
    restore();
    window.addEventListener("hashchange", showTarget);
    document.dispatchEvent(new CustomEvent("camera-lab-cells"));
  }

  window.cameraLab = { ...window.cameraLab, cells: { list: cells, announce, keepEdits } };
  document.addEventListener("DOMContentLoaded", start);
})();
