// Lets the predictions of a page be made: choose or type, commit, compare. What a box covers (marked
// by book/_ext/predictions.py) opens with the answer, with "Show anyway", and when the reader runs
// a cell whose output is covered. An address or the search of the browser opens it for this visit.
// Answers stay in this browser, in the progress file that the exercises keep:
//
//   localStorage["camera-lab-book.progress"] = {..., "predictions": {"stale": {"said": "2", "right": true}}}
//
// A prediction that was only shown has said null.
(() => {
  const { make, Choices, NumberField } = window.cameraLab.predictions;
  const KEY = "camera-lab-book.progress";
  const VERSION = 1;
  const CAN_BE_FOUND = "onbeforematch" in HTMLElement.prototype;

  /** The progress file, or a new one; null where it cannot be used or is of another version. */
  function load() {
    try {
      const text = localStorage.getItem(KEY);
      const record = text === null ? { version: VERSION, exercises: {} } : JSON.parse(text);
      if (record?.version !== VERSION || typeof record.exercises !== "object") return null;
      if (typeof record.predictions !== "object" || !record.predictions) record.predictions = {};
      return record;
    } catch {
      return null; // storage is switched off, or holds something that is not ours
    }
  }

  /**
   * Keep what was said, or forget it; where that is impossible the page works without memory.
   * @param {string} id
   * @param {ProgressPrediction | null} said
   */
  function keep(id, said) {
    const record = load();
    if (!record) return;
    if (said) record.predictions[id] = said;
    else delete record.predictions[id];
    try {
      localStorage.setItem(KEY, `${JSON.stringify(record, null, 1)}\n`);
    } catch {
      return; // full or switched off
    }
    document.dispatchEvent(new CustomEvent("camera-lab-progress"));
  }

  /**
   * @param {string} text
   * @param {string} className
   * @param {() => void} [onClick] without it, the button submits
   */
  function makeButton(text, className, onClick) {
    const button = make("button", className, text);
    button.type = onClick ? "button" : "submit";
    if (onClick) button.addEventListener("click", onClick);
    return button;
  }

  class Prediction {
    /** @param {HTMLElement} box */
    constructor(box) {
      this.id = box.id.replace(/^predict-/, "");
      this.said = /** @type {HTMLElement} */ (box.querySelector(".predict-said"));
      const list = /** @type {HTMLElement | null} */ (box.querySelector(":scope > ol"));
      this.field = list ? new Choices(list, box.id, this.said) : new NumberField(this.said);
      const question = /** @type {HTMLElement} */ (box.querySelector("p:not(.admonition-title)"));
      question.id ||= `${box.id}-question`;
      this.field.element.setAttribute("aria-labelledby", question.id);
      this.result = make("p", "predict-result");
      this.result.tabIndex = -1; // takes the focus with the answer, and is read once
      this.commitButton = makeButton("Commit", "predict-commit");
      this.showButton = makeButton("Show anyway", "predict-show", () => this.showAnyway());
      this.againButton = makeButton("Cover again", "predict-again", () => this.startOver());
      const buttons = [this.commitButton, this.showButton, this.againButton];
      const action = make("div", "predict-action", ...buttons);
      this.form = make("form", "predict-form", this.field.element, this.result, action);
      this.form.addEventListener("submit", (event) => {
        event.preventDefault();
        this.commit();
      });
      if (list) list.replaceWith(this.form);
      else box.append(this.form);
      this.isOpen = true;
      this.covered = this.findCovered();
      this.restore();
    }

    /** The parts of the page that hold the answer, each with a note that stands there instead. */
    findCovered() {
      return [...document.querySelectorAll(`.predict-answer-${CSS.escape(this.id)}`)].flatMap(
        (part) => {
          const isCell = part.classList.contains("predict-cell");
          const element = isCell ? part.querySelector(":scope > .cell_output") : part;
          if (!(element instanceof HTMLElement)) return [];
          const link = make("a", "", "Predict first");
          link.href = `#predict-${this.id}`;
          const note = make("p", "predict-note", isCell ? "The output" : "The answer");
          note.append(" is covered. ", link);
          // one note is enough where a text follows its cell
          if (!part.previousElementSibling?.matches(".predict-cell:has(.predict-note)")) {
            element.before(note);
          }
          element.classList.add("predict-covered");
          element.addEventListener("beforematch", () => this.open());
          if (isCell) this.watch(part);
          return [{ cell: isCell ? part : null, element, note }];
        },
      );
    }

    /** Whoever runs this very cell wants to see what it gives. */
    watch(/** @type {Element} */ cell) {
      const observer = new MutationObserver(() => {
        if (cell.getAttribute("aria-busy") === "true" && !this.isOpen) this.showAnyway();
      });
      observer.observe(cell, { attributeFilter: ["aria-busy"] });
    }

    restore() {
      this.form.reset(); // a browser may bring back a choice without its answer
      const { said, right } = load()?.predictions[this.id] ?? {};
      if (said === null) this.tell(null);
      else if (typeof said !== "string") this.close();
      // the question may have changed since
      else if (this.field.isRight(said) === right && this.field.set(said)) this.tell(said);
      else this.close();
    }

    commit() {
      const said = this.field.get();
      if (said === null) {
        this.result.textContent = this.field.request;
        this.field.inputs[0].focus();
        return;
      }
      keep(this.id, { said, right: this.field.isRight(said) });
      this.tell(said);
      this.result.focus({ preventScroll: true });
    }

    showAnyway() {
      keep(this.id, { said: null, right: false });
      const hadFocus = document.activeElement === this.showButton;
      this.form.reset();
      this.tell(null);
      if (hadFocus) this.result.focus({ preventScroll: true });
    }

    startOver() {
      keep(this.id, null);
      this.form.reset();
      this.close();
      this.field.inputs[0].focus({ preventScroll: true });
    }

    /** Say what there is to say to an answer, or to none, and open what was covered. */
    tell(/** @type {string | null} */ said) {
      const { field, result } = this;
      if (said === null) {
        result.replaceChildren("Shown without a prediction.");
      } else if (field.isRight(said)) {
        result.replaceChildren("You said ", field.quote(said), ", and so it is. ");
      } else {
        const [yours, right] = [field.quote(said), field.quoteRight()];
        result.replaceChildren("You said ", yours, ". It is ", right, ". ");
      }
      const text = said && this.said.querySelector(`[data-answer="${field.find(said)}"]`);
      if (text) result.append(...[...text.childNodes].map((node) => node.cloneNode(true)));
      this.setAnswered(true);
      this.open();
    }

    setAnswered(/** @type {boolean} */ isAnswered) {
      for (const input of this.field.inputs) input.disabled = isAnswered;
      this.commitButton.hidden = this.showButton.hidden = isAnswered;
      this.againButton.hidden = !isAnswered;
    }

    open() {
      this.isOpen = true;
      for (const { cell, element, note } of this.covered) {
        element.removeAttribute("hidden");
        cell?.classList.remove("is-covered");
        note.hidden = true;
      }
      window.dispatchEvent(new Event("resize")); // what draws by its width has had none
    }

    close() {
      this.isOpen = false;
      this.result.replaceChildren();
      this.setAnswered(false);
      for (const { cell, element, note } of this.covered) {
        element.setAttribute("hidden", CAN_BE_FOUND ? "until-found" : "");
        cell?.classList.add("is-covered");
        note.hidden = false;
      }
    }

    covers(/** @type {Element} */ target) {
      return this.covered.some(({ element }) => element.contains(target));
    }
  }

  document.addEventListener("DOMContentLoaded", () => {
    /** @type {NodeListOf<HTMLElement>} */
    const boxes = document.querySelectorAll(".admonition.predict:has(> .predict-said)");
    const all = [...boxes].map((box) => new Prediction(box));

    /** Go where the address leads, also into what is covered. */
    const follow = () => {
      const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
      if (!target) return;
      all.find((one) => one.covers(target))?.open();
      target.scrollIntoView();
    };
    window.addEventListener("hashchange", follow);
    follow();
  });
})();
