// Choose a part of a plot, from left to right: with the pointer over it, with a finger, or with the
// arrow keys. Nothing is set by it: the choice is gone when the pointer or the focus leaves.

import { PLOT_WIDTH } from "./_plot.js";
import { setShape } from "./_shapes.js";

/** @type {Record<string, number>} */
const KEYS = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 };

/**
 * Let the reader choose one of the `bins` of a plot; `choose` hears which, null for none. `first` is
 * where the keys begin, `name` says what it is, and `describe` says a bin in words.
 * @param {Pick<Plot, "svg" | "area">} plot
 * @param {{ bins: number, first: number, name: string, describe: (bin: number) => string }} options
 * @param {(bin: number | null) => void} choose
 */
export function watchBins({ svg, area }, { bins, first, name, describe }, choose) {
  /** @type {number | null | undefined} */
  let chosen;
  const to = (/** @type {number | null} */ bin) => {
    if (bin === chosen) return;
    chosen = bin;
    const text = bin === null ? "none chosen" : describe(bin);
    setShape(svg, { "aria-valuenow": bin ?? 0, "aria-valuetext": text });
    choose(bin);
  };
  setShape(svg, { role: "slider", tabindex: 0, "aria-roledescription": name });
  setShape(svg, { "aria-valuemin": 0, "aria-valuemax": bins - 1 });
  to(null);
  const point = (/** @type {Event} */ event) => {
    const box = svg.getBoundingClientRect();
    const { clientX } = /** @type {PointerEvent} */ (event);
    to(findBin(((clientX - box.left) / box.width) * PLOT_WIDTH, bins, area));
  };
  svg.addEventListener("pointerdown", point);
  svg.addEventListener("pointermove", point);
  svg.addEventListener("pointerleave", (event) => {
    if (/** @type {PointerEvent} */ (event).pointerType !== "touch") to(null);
  });
  svg.addEventListener("blur", () => to(null));
  svg.addEventListener("keydown", (event) => {
    const { key } = /** @type {KeyboardEvent} */ (event);
    if (key === "Escape") to(null);
    if (!KEYS[key]) return;
    const now = chosen ?? null;
    to(now === null ? first : Math.min(bins - 1, Math.max(0, now + KEYS[key])));
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
}

/**
 * The bin at a place of the drawing; null beside the plot.
 * @param {number} x
 * @param {number} bins
 * @param {Pick<Area, "left" | "right">} area
 */
export function findBin(x, bins, { left, right }) {
  const bin = Math.floor(((x - left) / (right - left)) * bins);
  return bin >= 0 && bin < bins ? bin : null;
}
