// The rows of the right picture around the chosen one: the search line in it, the window that was
// found, the true one, and the one the reader points at.

import { getContext, make, makeCanvas } from "./_frame.js";
import { makeEyeName } from "./_right_eye.js";
import { STRIP_SHARE } from "./_shared.js";

/**
 * Make the strip below the left picture; both are equally wide, so a column stands below itself.
 * @param {Element} parent
 * @param {{ width: number, height: number }} size of the right picture
 */
export function makeSearchStrip(parent, { width, height }) {
  const rows = Math.min(height, Math.max(1, Math.round(STRIP_SHARE * height)));
  const holder = make("div", "explorer-picker explorer-search", parent);
  const canvas = makeCanvas(holder, width, rows, "The same rows of the right picture");
  const context = getContext(canvas);
  makeEyeName(holder, "right");
  const line = make("div", "explorer-search-line", holder);
  const [truth, found, pointed] = ["true", "found", "pointed"].map((name) =>
    make("div", `explorer-box-mark is-${name}`, holder),
  );
  return {
    /**
     * @param {ImageData} picture
     * @param {Pixel} pixel
     * @param {number} window
     * @param {{ tried: number, found: number | null, truth: number | null, pointed: number | null }} at
     */
    show(picture, pixel, window, at) {
      const [u, v] = pixel.length ? pixel : [0, height >> 1];
      const first = Math.min(height - rows, Math.max(0, v - (rows >> 1)));
      context.putImageData(picture, 0, -first, 0, first, width, rows);
      /** @type {(mark: HTMLElement, disparity: number | null) => void} */
      const mark = (box, disparity) => {
        box.hidden = disparity === null || !pixel.length;
        placeWindow(box, u - (disparity ?? 0), v - first, window, { width, height: rows });
      };
      mark(truth, at.truth);
      mark(found, at.found);
      mark(pointed, at.pointed);
      line.hidden = !at.tried;
      const reach = window >> 1;
      const from = u - at.tried + 1 - reach;
      line.style.left = `${(100 * from) / width}%`;
      line.style.width = `${(100 * (u + reach + 1 - from)) / width}%`;
      line.style.top = `${(100 * (v - first - reach)) / rows}%`;
      line.style.height = `${(100 * window) / rows}%`;
    },
  };
}

/**
 * Lay an element over a window of a picture; its border stands outside and covers no pixel of it.
 * @param {HTMLElement} box
 * @param {number} u
 * @param {number} v
 * @param {number} window
 * @param {{ width: number, height: number }} size
 */
export function placeWindow(box, u, v, window, { width, height }) {
  const reach = window >> 1;
  box.style.left = `${(100 * (u - reach)) / width}%`;
  box.style.top = `${(100 * (v - reach)) / height}%`;
  box.style.width = `${(100 * window) / width}%`;
  box.style.height = `${(100 * window) / height}%`;
}
