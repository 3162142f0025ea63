// What the colors of a depth image mean: a bar from near to far in meters, a mark on it for the
// pixel one looks at, and the three kinds that are no distance.

import { findStripe } from "./_depth_picture.js";
import { getContext, make, makeCanvas } from "./_frame.js";
import { FARTHER, INSIDE, NEARER, NO_SURFACE } from "./_shared.js";

const NAMES = new Map([
  [NEARER, "nearer"],
  [FARTHER, "farther"],
  [NO_SURFACE, "no surface"],
]);

/**
 * Make the bar, and elsewhere the key of the three kinds; `show` takes its colors and range, `mark` a
 * depth and its kind.
 * @param {Element} parent
 * @param {Element} keyParent
 */
export function makeColorBar(parent, keyParent) {
  const holder = make("div", "explorer-colorbar", parent);
  const bar = make("div", "explorer-colorbar-bar", holder);
  const canvas = makeCanvas(bar, 256, 1, "Color bar");
  const context = getContext(canvas);
  const image = context.createImageData(256, 1);
  const colors = new Uint32Array(image.data.buffer);
  const mark = make("div", "explorer-colorbar-mark", bar);
  const scale = make("div", "explorer-colorbar-scale", holder);
  const ends = [0, 1, 2].map(() => make("span", "", scale));
  const key = make("div", "explorer-key", keyParent);
  const items = new Map(
    [...NAMES].map(([kind, name]) => {
      const item = make("span", "explorer-key-item", key);
      drawSwatch(item, kind);
      item.append(name);
      return [kind, item];
    }),
  );
  return {
    /**
     * @param {Uint32Array} table
     * @param {Pair} range
     */
    show(table, [near, far]) {
      colors.set(table);
      context.putImageData(image, 0, 0);
      [near, (near + far) / 2, far].forEach((meters, place) => {
        ends[place].textContent = `${meters.toFixed(2)} m`;
      });
      canvas.setAttribute(
        "aria-label",
        `Color bar from ${near.toFixed(2)} m to ${far.toFixed(2)} m`,
      );
    },
    /**
     * @param {Pair} range
     * @param {number | null} depth
     * @param {number | null} kind
     */
    mark([near, far], depth, kind) {
      mark.hidden = kind !== INSIDE || depth === null;
      if (depth !== null && far > near)
        mark.style.left = `${(100 * (depth - near)) / (far - near)}%`;
      for (const [one, item] of items) item.classList.toggle("is-here", one === kind);
    },
  };
}

/**
 * @param {Element} parent
 * @param {number} kind
 */
function drawSwatch(parent, kind) {
  const canvas = make("canvas", "explorer-swatch", parent);
  [canvas.width, canvas.height] = [32, 32];
  canvas.setAttribute("aria-hidden", "true");
  const context = getContext(canvas);
  const image = context.createImageData(32, 32);
  const out = new Uint32Array(image.data.buffer);
  for (let i = 0; i < out.length; i++) {
    out[i] = kind === NO_SURFACE ? 0xff000000 : findStripe(kind, i % 32, i >> 5);
  }
  context.putImageData(image, 0, 0);
}
