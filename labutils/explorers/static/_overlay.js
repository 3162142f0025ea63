// The picture with what is not selected dimmed, or the mask, or the picture alone.

import { getContext } from "./_frame.js";
import { toImageData } from "./_png.js";
import { DIM, MASK, PICTURE } from "./_shared.js";

const ARM = 14; // of the cross, in pixels
const FULL_CROSS = 120; // pixels: in a picture smaller than this the cross is smaller, too
const LEAST_CROSS = 12; // in a smaller one it would hide what it marks

/**
 * Prepare a canvas for a picture: { width, height, channels, data }.
 * @param {HTMLCanvasElement} canvas
 * @param {Picture} picture
 */
export function makeOverlay(canvas, picture) {
  const { width, height } = Object.assign(canvas, { width: picture.width, height: picture.height });
  const context = getContext(canvas);
  const image = toImageData(picture);
  // four bytes at a time: pixels are copied, never looked into
  const out = new Uint32Array(image.data.buffer);
  const bright = out.slice();
  const dim = new Uint32Array(dimBytes(image.data).buffer);
  const [white, black] = new Uint32Array(Uint8Array.of(255, 255, 255, 255, 0, 0, 0, 255).buffer);

  // where they differ; a mask of noise would make a condition per pixel slow
  const change = bright.map((pixel, i) => pixel ^ dim[i]);
  /** @param {Uint8Array} mask */
  const fillOverlay = (mask) => {
    for (let y = 0, i = 0, at = width + 3; y < height; y++, at += 2) {
      for (let x = 0; x < width; x++, i++, at++) {
        out[i] = dim[i] ^ (change[i] & (-mask[at] >> 31)); // all bits set where the mask is
      }
    }
  };
  /** @param {Uint8Array} mask */
  const fillMask = (mask) => {
    for (let y = 0, i = 0, at = width + 3; y < height; y++, at += 2) {
      for (let x = 0; x < width; x++, i++, at++) out[i] = mask[at] ? white : black;
    }
  };
  return {
    /**
     * Draw with a mask that has a rim one pixel wide, and a cross at the centroid, if any.
     * @param {Uint8Array} mask
     * @param {number} shown
     * @param {Pair | null} centroid
     */
    draw(mask, shown, centroid) {
      if (shown === MASK) fillMask(mask);
      else if (shown === PICTURE) out.set(bright);
      else fillOverlay(mask);
      context.putImageData(image, 0, 0);
      const size = Math.min(width, height);
      if (!centroid || size < LEAST_CROSS) return;
      drawCross(context, centroid[0] + 0.5, centroid[1] + 0.5, Math.min(1, size / FULL_CROSS));
    },
  };
}

/**
 * Make a picture gray and dark, so that colors are left only where something is selected.
 * @param {Uint8ClampedArray} rgba
 */
function dimBytes(rgba) {
  const dim = new Uint8Array(rgba.length);
  for (let i = 0; i < rgba.length; i += 4) {
    const gray = DIM * (0.299 * rgba[i] + 0.587 * rgba[i + 1] + 0.114 * rgba[i + 2]);
    dim[i] = dim[i + 1] = dim[i + 2] = gray;
    dim[i + 3] = 255;
  }
  return dim;
}

const BLACK_BELOW = { color: "#000", width: 7 };
const WHITE_ABOVE = { color: "#fff", width: 3 };

/**
 * White on black: one of the two stands out from anything.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} scale
 */
function drawCross(context, x, y, scale) {
  context.lineCap = "round";
  for (const { color, width } of [BLACK_BELOW, WHITE_ABOVE]) {
    context.strokeStyle = color;
    context.lineWidth = width * scale;
    const arm = ARM * scale;
    context.beginPath();
    context.moveTo(x - arm, y);
    context.lineTo(x + arm, y);
    context.moveTo(x, y - arm);
    context.lineTo(x, y + arm);
    context.stroke();
  }
}
