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

  let keeping = 0; // how many elements at the moment

  /**
   * Keep an element where the reader sees it while what stands above it grows and shrinks; returns
   * what ends that. An element below the window is not kept: then nobody looks at it.
   * @param {Element} element
   */
  function keepInPlace(element) {
    const root = document.documentElement;
    const getTop = () => element.getBoundingClientRect().top + window.scrollY;
    let top = getTop();
    let frame = 0;
    function follow() {
      const moved = getTop() - top;
      top += moved;
      const wasSeen = element.getBoundingClientRect().top - moved < root.clientHeight;
      if (moved && wasSeen) window.scrollBy({ top: moved, behavior: "instant" });
      frame = requestAnimationFrame(follow);
    }
    keeping += 1;
    root.classList.add("is-kept"); // or the browser does the same a second time
    follow();
    return () => {
      follow(); // what has changed since the last frame
      cancelAnimationFrame(frame);
      keeping -= 1;
      if (!keeping) root.classList.remove("is-kept");
    };
  }

  window.cameraLab = { ...window.cameraLab, elements: { keepInPlace, make, makeButton } };
})();
