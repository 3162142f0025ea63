// The buttons of an exercise. Stop stands in place of Run and Check while something runs.
(() => {
  const { make, makeButton } = window.cameraLab.elements;

  class ExerciseButtons {
    /**
     * @param {string} name of the exercise
     * @param {Record<"run" | "check" | "stop" | "hint" | "reset", () => void>} actions
     */
    constructor(name, actions) {
      this.run = makeButton("Run", "exercise-run", actions.run);
      this.check = makeButton("Check", "exercise-check", actions.check);
      this.stop = makeButton("Stop", "exercise-stop", actions.stop);
      this.stop.hidden = true;
      this.reset = makeButton("Reset", "", actions.reset);
      this.element = make("div", "exercise-buttons", "", {
        role: "group",
        "aria-label": `Buttons of ${name}`,
      });
      const hint = makeButton("Hint", "", actions.hint);
      hint.hidden = window.cameraLab.verdicts.data.exercises[name].isCompletion;
      this.element.append(this.run, this.check, this.stop, hint, this.reset);
    }

    nameReset(/** @type {boolean} */ isUndo) {
      this.reset.textContent = isUndo ? "Undo reset" : "Reset";
    }

    /**
     * @param {boolean} isBusy
     * @param {string} doing "run" or "check"
     */
    setBusy(isBusy, doing) {
      const focused = document.activeElement;
      this.stop.hidden = !isBusy;
      this.check.hidden = this.run.hidden = isBusy;
      // the button that had the focus has just gone
      if (focused === this.run || focused === this.check) this.stop.focus();
      if (focused === this.stop) (doing === "run" ? this.run : this.check).focus();
    }
  }

  window.cameraLab = { ...window.cameraLab, ExerciseButtons };
})();
