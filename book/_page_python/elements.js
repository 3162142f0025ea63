// Making elements: what the scripts of a page share.
(() => {
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

  window.cameraLab = { ...window.cameraLab, elements: { make, makeButton } };
})();
