// One exercise in two tabs: the one hears that the other has changed the code, and offers to take
// it. No text gets lost: the browser keeps the code that was typed last and, until the reader has
// chosen, beside it the other tab's, and the reader's own from before taking that.
(() => {
  const { progress } = window.cameraLab;
  const { make, makeButton } = window.cameraLab.elements;

  const OTHER = "Another tab has changed this code. Here it is as it was.";
  const MINE = "Your code from before you took the other tab's is kept.";

  /**
   * Read what was put aside.
   * @param {string} name
   * @returns {{other: string | null, mine: string | null}}
   */
  function read(name) {
    try {
      const { other, mine } = JSON.parse(progress.readAside(name) ?? "{}");
      const check = (/** @type {unknown} */ text) => (typeof text === "string" ? text : null);
      return { other: check(other), mine: check(mine) };
    } catch {
      return { other: null, mine: null }; // not ours
    }
  }

  class OtherTabs {
    /** @param {WatchedExercise} exercise */
    constructor(exercise) {
      this.exercise = exercise;
      const { name } = exercise;
      /** @type {string | null} */
      this.seen = progress.readCode(name); // the code that this tab has last written, or heard of
      /** @type {string | null} */
      this.taken = null;
      ({ other: this.other, mine: this.mine } = read(name));
      this.text = make("p", "");
      this.takeButton = makeButton("", "", () => this.take());
      const keepButton = makeButton("Keep this code", "", () => this.drop());
      const buttons = make("div", "exercise-buttons");
      buttons.append(this.takeButton, keepButton);
      this.element = make("div", "exercise-tabs exercise-note");
      this.element.append(this.text, buttons);
      this.element.hidden = true;
      progress.listen(name, (code) => this.hear(code));
    }

    /** Another tab has written; null stands for the starter. */
    hear(/** @type {string | null} */ code) {
      this.seen = code;
      const { editor, starter } = this.exercise;
      const text = code ?? starter;
      this.other = text === editor.getText() ? null : text;
      this.show();
      if (this.other !== null) this.exercise.say(OTHER);
    }

    /** Put aside what is about to be overwritten; a tab that slept has not heard of it. */
    keep(/** @type {string | null} */ next) {
      const stored = progress.readCode(this.exercise.name);
      if (stored !== this.seen && stored !== next) this.hear(stored);
      this.seen = next;
      if (this.other !== null || this.mine !== null) this.store();
    }

    /** Put the other code into the editor, and the one that was there aside. */
    take() {
      const { editor } = this.exercise;
      const before = editor.getText();
      const text = this.other ?? this.mine ?? before;
      // what was only taken from the other tab is no code of the reader's own
      if (this.other === null || this.mine === null || before !== this.taken) this.mine = before;
      this.taken = this.other === null ? null : text;
      this.other = null;
      this.store();
      editor.setText(text);
      this.show();
      editor.focus();
    }

    drop() {
      const { editor, name, starter } = this.exercise;
      const text = editor.getText();
      if (this.other === null) this.mine = null;
      this.other = null;
      this.store();
      this.seen = text === starter ? null : text;
      progress.writeCode(name, this.seen);
      this.exercise.say("Kept: the code that stands here.");
      this.show();
      editor.focus();
    }

    store() {
      const { other, mine } = this;
      const isEmpty = other === null && mine === null;
      progress.writeAside(this.exercise.name, isEmpty ? null : JSON.stringify({ other, mine }));
    }

    /** What is offered: the other tab's code first. */
    show() {
      const text = this.other === null ? MINE : OTHER;
      this.element.hidden = this.other === null && this.mine === null;
      this.text.textContent = text;
      this.takeButton.textContent = this.other === null ? "Take mine back" : "Take the other code";
    }
  }

  const tabs = {
    watch: (/** @type {WatchedExercise} */ exercise) => new OtherTabs(exercise),
  };
  window.cameraLab = { ...window.cameraLab, tabs };
})();
