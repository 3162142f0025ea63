// What lies under the pointer: which pixel of a picture, and a word beside it. A finger does not
// hover: it picks, and the keys do too.

import { make } from "./_frame.js";

/**
 * Tell which pixel of a canvas lies under the pointer, null where none does.
 * @param {HTMLCanvasElement} canvas
 * @param {(pixel: Pixel | null) => void} show
 */
export function watchPixel(canvas, show) {
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "touch") show(toPixel(canvas, event));
  });
  canvas.addEventListener("pointerleave", () => show(null));
}

/**
 * Follow the pointer over a picture: the pixel it rests on, until the keys or a click pick one.
 * @param {HTMLCanvasElement} canvas
 * @param {{ on(event: string, then: () => void): void, off(event: string, then: () => void): void }} model
 * @param {{ cleanups: (() => void)[] }} frame
 * @param {() => void} redraw called when it rests on another one
 */
export function followPointer(canvas, model, frame, redraw) {
  const pointer = { pixel: /** @type {Pixel | null} */ (null) };
  const look = (/** @type {Pixel | null} */ pixel) => {
    if (String(pixel) === String(pointer.pixel)) return;
    pointer.pixel = pixel;
    redraw();
  };
  watchPixel(canvas, look);
  const forget = () => look(null); // what the keys have picked counts, not where the pointer rests
  model.on("change:pixel", forget);
  frame.cleanups.push(() => model.off("change:pixel", forget));
  return pointer;
}

/**
 * The pixel of a canvas under a pointer; a pixel's number names its center.
 * @param {{ width: number, height: number, getBoundingClientRect(): Box }} canvas
 * @param {{ clientX: number, clientY: number }} pointer
 * @returns {Pixel}
 */
export function toPixel(canvas, { clientX, clientY }) {
  const box = canvas.getBoundingClientRect();
  const place = (/** @type {number} */ share, /** @type {number} */ size) =>
    Math.min(size - 1, Math.max(0, Math.floor(share * size)));
  return [
    place((clientX - box.left) / box.width, canvas.width),
    place((clientY - box.top) / box.height, canvas.height),
  ];
}

/**
 * Make a small label over a picture; it keeps to the side on which there is room.
 * @param {HTMLElement} holder
 */
export function makeTag(holder) {
  const tag = make("div", "explorer-tag", holder);
  tag.setAttribute("aria-hidden", "true"); // the read-out says it
  tag.hidden = true;
  return {
    /** @type {(text: string, share: Pair) => void} */
    show(text, [x, y]) {
      tag.hidden = false;
      tag.textContent = text;
      tag.style.left = `${100 * x}%`;
      tag.style.top = `${100 * y}%`;
      tag.style.translate = `${x > 0.6 ? "calc(-100% - 14px)" : "14px"} ${y > 0.2 ? "-120%" : "60%"}`;
    },
    hide() {
      tag.hidden = true;
    },
  };
}

/**
 * Make what lights up the pixels of some depths in a picture: all others turn dark.
 * @param {HTMLElement} holder
 * @param {Picture} depth in steps
 */
export function makeSpotlight(holder, { width, height, data }) {
  const canvas = make("canvas", "explorer-spotlight", holder);
  [canvas.width, canvas.height] = [width, height];
  canvas.setAttribute("aria-hidden", "true");
  canvas.hidden = true;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const image = context.createImageData(width, height);
  const out = new Uint32Array(image.data.buffer);
  let shown = "";
  return {
    /** Light up the pixels of `low` to `high` steps, without `high`; of no range hide the light. */
    show(/** @type {Pair | null} */ range) {
      canvas.hidden = !range;
      if (!range || shown === String(range)) return;
      shown = String(range);
      paintShade(data, range, out);
      context.putImageData(image, 0, 0);
    },
  };
}

const SHADE = 0xc8000000; // dark, and what lies below can still be guessed

/**
 * Shade every pixel outside a range of steps.
 * @param {ArrayLike<number>} pixels
 * @param {Pair} range
 * @param {Uint32Array} out
 */
export function paintShade(pixels, [low, high], out) {
  for (let i = 0; i < pixels.length; i++) {
    out[i] = pixels[i] >= low && pixels[i] < high ? 0 : SHADE;
  }
}
