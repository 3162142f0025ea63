// The controls of ipywidgets beside a view: a screen reader hears a name, and a value with its unit.

import { setOnce } from "./_elements.js";

const NAME_AND_UNIT = /^(.*?)(?: \(([^()]+)\))?$/; // "near (m)"
const BETWEEN_ENDS = " – "; // as ipywidgets writes a range

/**
 * Wait until a view stands in its explorer; then know how wide that may be, and name its controls.
 * Returns what ends both.
 * @param {HTMLElement} el
 */
export function adoptControls(el) {
  /** @type {MutationObserver | undefined} */
  let observer;
  let waiting = requestAnimationFrame(function start() {
    const box = el.closest(".explorer-box");
    if (!box) {
      waiting = requestAnimationFrame(start); // not yet in the page
      return;
    }
    // the style sheet asks for the width of the room, not of the window: JupyterLab has panels
    box.parentElement?.classList.add("explorer-room");
    // in JupyterLab arrow keys would leave the cell instead of moving the handle
    box.setAttribute("data-lm-suppress-shortcuts", "true");
    nameAll(box);
    observer = new MutationObserver(() => nameAll(box));
    observer.observe(box, {
      attributeFilter: ["class", "aria-valuetext"],
      childList: true,
      subtree: true,
    });
  });
  return () => {
    cancelAnimationFrame(waiting);
    observer?.disconnect();
  };
}

function nameAll(/** @type {Element} */ box) {
  for (const control of box.querySelectorAll(".explorer-controls > *")) {
    /** @type {HTMLElement | null} */
    const label = control.querySelector(".widget-label");
    if (label?.title === "null") label.removeAttribute("title");
    const text = label?.textContent ?? "";
    nameHandles(control, text);
    const readout = control.querySelector(".widget-readout");
    if (readout) {
      setOnce(readout, "role", "textbox");
      setOnce(readout, "aria-label", `${text}, as a number`);
    }
    if (control.classList.contains("widget-toggle-buttons")) {
      setOnce(control, "role", "group");
      setOnce(control, "aria-label", text);
      for (const button of control.querySelectorAll("button")) {
        setOnce(button, "aria-pressed", String(button.classList.contains("mod-active")));
      }
    }
  }
}

/**
 * Name the handles of a slider, and say their values as they are written beside them: the slider
 * itself says a place in a list, or all digits of a number.
 * @param {Element} control
 * @param {string} text
 */
function nameHandles(control, text) {
  const unit = NAME_AND_UNIT.exec(text)?.[2];
  const written = control.querySelector(".widget-readout")?.textContent ?? "";
  const handles = [...control.querySelectorAll(".noUi-handle")];
  const values = handles.length > 1 ? written.split(BETWEEN_ENDS) : [written];
  handles.forEach((handle, place) => {
    const end = handles.length > 1 ? [", low", ", high"][place] : "";
    setOnce(handle, "aria-label", text + end);
    const value = values[place]?.trim();
    if (value) setOnce(handle, "aria-valuetext", unit ? `${value} ${unit}` : value);
  });
}
