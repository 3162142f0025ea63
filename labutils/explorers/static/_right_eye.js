// What the right eye makes of the left eye's picture: a strip of its own picture, and where it sees
// one point. The strip is computed from the left eye's depth, so what that does not see stays empty.

import { getContext, make, makeCanvas } from "./_frame.js";
import { HIDDEN, OUTSIDE } from "./_shared.js";
import { findDisparity } from "./_stereo.js";

const STRIP_ROWS = 72;

/**
 * Make the strip below the picture, a mark in both where the right eye sees the point, and a line as
 * long as the disparity.
 * @param {Element} parent
 * @param {HTMLElement} holder of the left eye's picture
 * @param {ImageData} picture
 * @param {ArrayLike<number>} depths in meters, 0 where there is no surface
 */
export function makeRightEye(parent, holder, picture, depths) {
  const { width, height } = picture;
  const rows = Math.min(STRIP_ROWS, height);
  const line = make("div", "explorer-disparity", holder);
  const pointed = make("div", "explorer-mark explorer-pointed", holder);
  const square = makeSquare(holder);
  const strip = make("div", "explorer-picker explorer-strip", parent);
  const canvas = makeCanvas(strip, width, rows, "The same rows, as the right eye sees them");
  makeEyeName(strip, "right eye");
  const squareBelow = makeSquare(strip);
  const context = getContext(canvas);
  const image = context.createImageData(width, rows);
  const out = new Uint32Array(image.data.buffer);
  const colors = new Uint32Array(picture.data.buffer);
  let drawn = "";
  return {
    /**
     * Mark the point of a pixel; `isPointed` if it is not the one that was picked.
     * @param {StereoValues} values
     * @param {Pixel} pixel
     * @param {number} focal
     * @param {number} baseline
     * @param {boolean} isPointed
     */
    show({ u_right, right }, [u, v], focal, baseline, isPointed) {
      const row = v ?? height >> 1;
      const first = Math.min(height - rows, Math.max(0, row - (rows >> 1)));
      if (drawn !== `${first} ${baseline}`) {
        drawn = `${first} ${baseline}`;
        warpRows({ colors, depths, width }, [first, first + rows], focal, baseline, out);
        context.putImageData(image, 0, 0);
      }
      pointed.hidden = !isPointed;
      line.hidden = u_right === null;
      const inRow = `${((row + 0.5) / height) * 100}%`;
      pointed.style.left = `${((u + 0.5) / width) * 100}%`;
      line.style.top = pointed.style.top = inRow;
      const from = Math.max(u_right ?? 0, -0.5);
      line.style.left = `${((from + 0.5) / width) * 100}%`;
      line.style.width = `${((u - from) / width) * 100}%`;
      const isSeen = u_right !== null && right !== OUTSIDE;
      square(isSeen, right === HIDDEN, line.style.left, inRow);
      squareBelow(
        isSeen,
        right === HIDDEN,
        line.style.left,
        `${((row - first + 0.5) / rows) * 100}%`,
      );
    },
  };
}

/**
 * Say over a picture whose it is.
 * @param {HTMLElement} holder
 * @param {string} text
 */
export function makeEyeName(holder, text) {
  const name = make("div", "explorer-tag explorer-eye-name", holder);
  name.setAttribute("aria-hidden", "true"); // the canvas has a name
  name.textContent = text;
}

/** @param {HTMLElement} holder */
function makeSquare(holder) {
  const mark = make("div", "explorer-mark explorer-right-mark", holder);
  /** @type {(isShown: boolean, isHidden: boolean, left: string, top: string) => void} */
  return (isShown, isHidden, left, top) => {
    mark.hidden = !isShown;
    mark.style.left = left;
    mark.style.top = top;
    mark.classList.toggle("hidden-there", isHidden);
  };
}

/**
 * Move the pixels of some rows to where the right eye sees them; what is nearer covers what is
 * farther, what has no depth is infinitely far, and what no pixel reaches is left empty: 0.
 * @param {{ colors: Uint32Array, depths: ArrayLike<number>, width: number }} left
 * @param {Pair} rows the first, and the one behind the last
 * @param {number} focal
 * @param {number} baseline
 * @param {Uint32Array} out
 */
export function warpRows({ colors, depths, width }, [first, end], focal, baseline, out) {
  const covered = new Float32Array(width);
  out.fill(0);
  for (let v = first; v < end; v++) {
    covered.fill(-1);
    for (let u = 0, i = v * width; u < width; u++, i++) {
      const disparity = depths[i] ? findDisparity(depths[i], focal, baseline) : 0;
      const place = Math.floor(u - disparity);
      // it falls between two pixels and fills both, or a slanted face would have gaps
      for (let at = Math.max(place, 0); at <= place + 1 && at < width; at++) {
        if (at - (u - disparity) >= 1 || disparity < covered[at]) continue;
        covered[at] = disparity;
        out[(v - first) * width + at] = colors[i];
      }
    }
  }
}
