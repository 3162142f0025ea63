// What the box of a prediction asks for: one of its choices, or a number. Each is an element for the
// form of predict.js, and knows what is right and how an answer is quoted.
(() => {
  /**
   * @template {keyof HTMLElementTagNameMap} Tag
   * @param {Tag} tag
   * @param {string} className
   * @param {(Node | string)[]} children
   * @returns {HTMLElementTagNameMap[Tag]}
   */
  function make(tag, className, ...children) {
    const element = document.createElement(tag);
    element.className = className;
    element.append(...children);
    return element;
  }

  /** What a box asks for: one of its choices. */
  class Choices {
    /**
     * @param {HTMLElement} list
     * @param {string} name
     * @param {HTMLElement} said
     */
    constructor(list, name, said) {
      this.request = "Choose an answer first.";
      this.right = String(said.dataset.right);
      this.texts = [...list.children].map((item) => make("span", "", ...item.childNodes));
      this.inputs = this.texts.map((_text, place) => {
        const input = make("input", "");
        Object.assign(input, { type: "radio", name, value: String(place + 1) });
        return input;
      });
      const labels = this.inputs.map((input, place) =>
        make("label", "predict-choice", input, `${input.value}.`, this.texts[place]),
      );
      this.element = make("fieldset", "", ...labels);
    }

    get() {
      return this.inputs.find((input) => input.checked)?.value ?? null;
    }

    set(/** @type {string} */ answer) {
      const input = this.inputs[Number(answer) - 1];
      if (input) input.checked = true;
      return Boolean(input);
    }

    isRight(/** @type {string} */ answer) {
      return answer === this.right;
    }

    /** Which of the texts is said to an answer. */
    find(/** @type {string} */ answer) {
      return answer;
    }

    /** An answer in words, without the full stop: it stands in a sentence. */
    quote(/** @type {string} */ answer) {
      const quote = make("q", "");
      for (const node of this.texts[Number(answer) - 1].childNodes) {
        const part = node instanceof HTMLParagraphElement ? [...node.childNodes] : [node];
        quote.append(...part.map((one) => one.cloneNode(true)));
      }
      const last = quote.lastChild;
      if (last?.nodeType === Node.TEXT_NODE) {
        last.textContent = String(last.textContent).trimEnd().replace(/\.$/, "");
      }
      return quote;
    }

    quoteRight() {
      return this.quote(this.right);
    }
  }

  /** What a box asks for: a number. */
  class NumberField {
    /** @param {HTMLElement} said */
    constructor(said) {
      this.request = "Type a number first.";
      this.number = Number(said.dataset.number);
      this.tolerance = Number(said.dataset.tolerance);
      this.unit = said.dataset.unit ?? "";
      const input = make("input", "");
      Object.assign(input, { type: "text", inputMode: "decimal", autocomplete: "off" });
      this.inputs = [input];
      const label = make("label", "predict-number", "Your number", input, this.unit);
      this.element = make("fieldset", "", label);
    }

    get() {
      const text = this.inputs[0].value.trim().replace(",", ".");
      return text && Number.isFinite(Number(text)) ? text : null;
    }

    set(/** @type {string} */ answer) {
      this.inputs[0].value = answer;
      return this.get() !== null;
    }

    isRight(/** @type {string} */ answer) {
      return Math.abs(Number(answer) - this.number) <= this.tolerance;
    }

    find(/** @type {string} */ answer) {
      if (this.isRight(answer)) return "right";
      return Number(answer) < this.number ? "low" : "high";
    }

    quote(/** @type {string} */ answer) {
      return make("q", "", this.unit ? `${answer} ${this.unit}` : answer);
    }

    quoteRight() {
      return this.quote(String(Number(this.number.toPrecision(3))));
    }
  }

  window.cameraLab = { ...window.cameraLab, predictions: { make, Choices, NumberField } };
})();
