// Choose a pixel of a canvas: with a pointer, or with the arrow keys.

import { make, setTraits } from "./_frame.js";

/** @type {Record<string, Pair>} */
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const LEAP = 10; // pixels per key press with Shift

/**
 * Let the reader choose a pixel of `canvas`; the trait `pixel` holds [u, v], or [] for none.
 * Shift makes the arrow keys ten times as fast. Returns the element around the canvas.
 * @param {object} parts
 * @param {Model<Picked>} parts.model
 * @param {Frame} parts.frame
 * @param {HTMLCanvasElement} parts.canvas
 * @param {string} parts.label
 */
export function makePicker({ model, frame, canvas, label }) {
  const holder = make("div", "explorer-picker");
  canvas.replaceWith(holder);
  holder.append(canvas);
  const mark = make("div", "explorer-mark", holder);
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application"); // arrow keys are for the page, not the screen reader
  canvas.setAttribute("aria-roledescription", "pixel picker");
  canvas.setAttribute(
    "aria-label",
    `${label}. Arrow keys choose a pixel, with Shift in steps of ten`,
  );

  const choose = (/** @type {number} */ u, /** @type {number} */ v) => {
    const clamp = (/** @type {number} */ value, /** @type {number} */ size) =>
      Math.min(size - 1, Math.max(0, Math.round(value)));
    setTraits(model, { pixel: [clamp(u, canvas.width), clamp(v, canvas.height)] });
  };
  const fromPointer = (/** @type {PointerEvent} */ event) => {
    const box = canvas.getBoundingClientRect();
    // a pixel's number names its center, so half a pixel lies to its left
    choose(
      ((event.clientX - box.left) / box.width) * canvas.width - 0.5,
      ((event.clientY - box.top) / box.height) * canvas.height - 0.5,
    );
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    fromPointer(event);
    if (event.pointerType !== "touch") canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons && event.pointerType !== "touch") fromPointer(event);
  });
  canvas.addEventListener("keydown", (event) => {
    const step = KEYS[event.key];
    if (!step) return;
    const picked = model.get("pixel");
    const [u, v] = picked.length ? picked : [canvas.width >> 1, canvas.height >> 1];
    const pace = event.shiftKey ? LEAP : 1;
    choose(u + step[0] * pace, v + step[1] * pace);
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
  const place = () => {
    const [u, v] = model.get("pixel");
    mark.hidden = u === undefined;
    mark.style.left = `${((u + 0.5) / canvas.width) * 100}%`;
    mark.style.top = `${((v + 0.5) / canvas.height) * 100}%`;
  };
  model.on("change:pixel", place);
  frame.cleanups.push(() => model.off("change:pixel", place));
  place();
  return holder;
}
