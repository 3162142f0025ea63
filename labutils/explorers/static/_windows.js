// Windows, enlarged: the one around the pixel, the one that was found, the true one, and how much each
// differs from the first. And for which sizes a window finds the truth.

import { formatCost } from "./_cost_curve.js";
import { getContext, make } from "./_frame.js";
import { GOOD_PX, WINDOWS } from "./_shared.js";

const CONTRAST = 4; // a difference of 64 gray levels is white

/**
 * Make the five pictures.
 * @param {Element} parent
 */
export function makeWindows(parent) {
  const row = make("div", "explorer-windows", parent);
  const left = makeWindow(row, "left");
  const found = makeWindow(row, "found", "is-found");
  const foundOff = makeWindow(row, "difference");
  const right = makeWindow(row, "truth", "is-true");
  const rightOff = makeWindow(row, "difference");
  return {
    /**
     * Show the windows around a pixel and its matches; null for none.
     * @param {GrayPair} pair
     * @param {Pixel} pixel
     * @param {number} side
     * @param {{ found: number | null, isPointed: boolean, truth: number | null }} matches
     */
    show(pair, pixel, side, { found: match, isPointed, truth }) {
      const own = cut(pair.left, pair, pixel, side);
      const at = (/** @type {number | null} */ disparity) =>
        disparity === null ? null : cut(pair.right, pair, [pixel[0] - disparity, pixel[1]], side);
      const [ours, theirs] = [at(match), at(truth === null ? null : Math.round(truth))];
      left.show(own, side, "left");
      found.show(ours, side, isPointed ? `at ${match} px` : "found");
      foundOff.show(differ(own, ours), side, tellCost(own, ours));
      right.show(theirs, side, "truth");
      rightOff.show(differ(own, theirs), side, tellCost(own, theirs));
    },
  };
}

/**
 * @param {Element} parent
 * @param {string} name
 * @param {string} look
 */
function makeWindow(parent, name, look = "") {
  const figure = make("div", "explorer-window", parent);
  const canvas = make("canvas", look, figure);
  canvas.setAttribute("role", "img");
  const caption = make("span", "", figure);
  return {
    /** @type {(gray: Uint8ClampedArray | null, side: number, words: string) => void} */
    show(gray, side, words) {
      canvas.classList.toggle("empty", !gray);
      caption.textContent = gray ? words : "none";
      canvas.setAttribute("aria-label", `${name}: ${caption.textContent}`);
      if (canvas.width !== side) canvas.width = canvas.height = side;
      const image = new ImageData(side, side);
      const out = new Uint32Array(image.data.buffer);
      if (gray) for (let i = 0; i < gray.length; i++) out[i] = 0xff000000 | (0x10101 * gray[i]);
      getContext(canvas).putImageData(image, 0, 0);
    },
  };
}

/**
 * Cut a window out of a picture; null where it is not wholly inside.
 * @param {Uint8ClampedArray} gray
 * @param {{ width: number, height: number }} size
 * @param {Pixel} pixel
 * @param {number} side
 */
export function cut(gray, { width, height }, [u, v], side) {
  const reach = side >> 1;
  if (!(u >= reach && v >= reach && u < width - reach && v < height - reach)) return null;
  const out = new Uint8ClampedArray(side * side);
  for (let row = 0; row < side; row++) {
    const from = (v - reach + row) * width + u - reach;
    out.set(gray.subarray(from, from + side), row * side);
  }
  return out;
}

/**
 * How much two windows differ, brightened.
 * @param {Uint8ClampedArray | null} one
 * @param {Uint8ClampedArray | null} other
 */
function differ(one, other) {
  if (!one || !other) return null;
  return one.map((gray, i) => CONTRAST * Math.abs(gray - other[i]));
}

/**
 * @param {Uint8ClampedArray | null} one
 * @param {Uint8ClampedArray | null} other
 */
function tellCost(one, other) {
  if (!one || !other) return "";
  return `SSD ${formatCost(one.reduce((sum, gray, i) => sum + (gray - other[i]) ** 2, 0) / one.length)}`;
}

/**
 * Make the row of window sizes: filled where a window of that size finds the truth.
 * @param {Element} parent
 */
export function makeSizes(parent) {
  const row = make("div", "explorer-sizes", parent);
  row.setAttribute("role", "img");
  make("span", "explorer-sizes-name", row).textContent = `right to ${GOOD_PX} px`;
  const sizes = WINDOWS.map((side) => {
    const one = make("span", "explorer-size", row);
    one.textContent = String(side);
    return one;
  });
  return {
    /** @type {(errors: (number | null)[], window: number) => void} */
    show(errors, window) {
      row.hidden = errors.every((one) => one === null);
      const right = WINDOWS.filter((_, i) => isRight(errors[i]));
      for (const [i, size] of sizes.entries()) {
        size.classList.toggle("is-right", isRight(errors[i]));
        size.classList.toggle("is-chosen", WINDOWS[i] === window);
      }
      const list = right.length ? right.join(", ") : "none";
      row.setAttribute("aria-label", `Windows that are right to ${GOOD_PX} px: ${list}`);
    },
  };
}

/** @param {number | null} error */
function isRight(error) {
  return error !== null && error <= GOOD_PX;
}
