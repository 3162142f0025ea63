// The reader's output of a cell, where the book's stands, and the choice between the two.
(() => {
  const { elements, outputs } = window.cameraLab;
  const { make, makeButton } = elements;

  class CellResult {
    /**
     * @param {string} name of the cell
     * @param {HTMLElement | null} built the output that the book has
     */
    constructor(name, built) {
      this.built = built;
      this.printed = ""; // while the cell runs
      /** @type {HTMLElement | null} */
      this.running = null; // where that stands
      this.element = make("div", "cell-yours");
      this.element.hidden = true;
      this.switch = make("span", "cell-switch", "", {
        role: "group",
        "aria-label": `Output of ${name}`,
      });
      this.yoursButton = makeButton("Yours", "", () => this.choose(true));
      this.builtButton = makeButton("The book's", "", () => this.choose(false));
      this.switch.append(this.yoursButton, this.builtButton);
      this.switch.hidden = true;
    }

    /** Which of the two is to be seen. */
    choose(/** @type {boolean} */ isYours) {
      this.element.hidden = !isYours || !this.element.hasChildNodes();
      this.built?.classList.toggle("is-replaced", isYours);
      this.yoursButton.setAttribute("aria-pressed", String(isYours));
      this.builtButton.setAttribute("aria-pressed", String(!isYours));
    }

    /** The cell begins to run. */
    begin() {
      this.printed = "";
    }

    /**
     * What a cell prints is kept; if it is watched, it is seen at once, in place of the output before.
     * @param {string} text
     * @param {boolean} isWatched
     */
    print(text, isWatched) {
      if (isWatched && !this.printed) {
        this.running = outputs.makeText("");
        this.element.replaceChildren(this.running);
        this.choose(true);
      }
      this.printed += text;
      if (isWatched && this.running) this.running.textContent = this.printed;
    }

    /**
     * Show what a cell gave; returns whether there is anything to show.
     * @param {Said} said
     * @param {boolean} isSame whether the book's own code has run
     * @param {boolean} isWanted whether the reader wants to see it instead of the book's
     */
    async show(said, isSame, isWanted) {
      const images = (isSame && this.built?.querySelectorAll("img")) || [];
      const alts = [...images].map((image) => image.alt);
      const all = said.result === "stopped" ? { ...said, printed: this.printed } : said;
      const parts = outputs.makeAll(all, alts);
      window.cameraLab.widgets?.clear(this.element); // of the run before
      this.element.replaceChildren(...parts);
      this.switch.hidden = !(this.built && parts.length);
      // a widget that Python hears has to be the one that is seen
      const isLive = parts.some((part) => part.classList.contains("cell-widget"));
      const isNews = isWanted || isLive || !this.built || said.result !== "ran";
      this.choose(parts.length > 0 && isNews);
      if (this.built && window.cameraLab.widgets) {
        await window.cameraLab.widgets.carry(this.built, this.element);
      }
      return parts.length > 0;
    }
  }

  window.cameraLab = { ...window.cameraLab, CellResult };
})();
