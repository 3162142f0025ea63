// Making elements: what the scripts of a page share.
(() => {
  const isApple = /Mac|iPhone|iPad/.test(navigator.platform);
  /** What a reader presses in an editor. */
  const KEYS = isApple ? "Command and Enter" : "Ctrl and Enter";

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
   * Let the reader save a text as a file.
   * @param {string} name
   * @param {string} type
   * @param {string} text
   */
  function save(name, type, text) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    // the download begins after this
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
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

  window.cameraLab = {
    ...window.cameraLab,
    elements: { KEYS, keepInPlace, make, makeButton, save },
  };
})();
