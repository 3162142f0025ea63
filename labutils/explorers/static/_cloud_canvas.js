// Draw the cloud without WebGL: slower, so with fewer points while it moves, but with the same
// squares in the same order of depth.

import { getContext } from "./_frame.js";
import { makeSplatBuffer, splatPoints } from "./_splat.js";

const BUDGET_MS = 10; // leaves time for the rest of a frame of 16 ms
const MAX_STRIDE = 6;
const SETTLE_MS = 160;

/**
 * Make what draws the cloud on a canvas, without WebGL.
 * @param {HTMLCanvasElement} canvas
 * @param {Cloud} cloud
 * @returns {CloudPainter}
 */
export function makeCanvasPainter(canvas, cloud) {
  const context = getContext(canvas);
  let buffer = makeSplatBuffer(1, 1);
  let image = context.createImageData(1, 1);
  let pixels = new Uint32Array(image.data.buffer);
  let stride = 1;
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;
  /** @type {(look: Look, colors: Uint32Array, step: number) => void} */
  const paint = (look, colors, step) => {
    splatPoints(cloud, look, buffer, step);
    const { ids } = buffer;
    for (let i = 0; i < ids.length; i++) pixels[i] = ids[i] < 0 ? 0 : colors[ids[i]];
    context.putImageData(image, 0, 0);
    canvas.dataset.stride = String(step);
  };
  return {
    kind: "2d",
    resolution: 1, // device pixels would cost four times as much
    draw(look, colors) {
      if (buffer.width !== look.width || buffer.height !== look.height) {
        [canvas.width, canvas.height] = [look.width, look.height];
        buffer = makeSplatBuffer(look.width, look.height);
        image = context.createImageData(look.width, look.height);
        pixels = new Uint32Array(image.data.buffer);
      }
      clearTimeout(timer);
      const started = performance.now();
      paint(look, colors, stride);
      const spent = performance.now() - started;
      // thin out where this was too slow, take more where there is time, draw all once it rests
      if (spent > BUDGET_MS) stride = Math.min(MAX_STRIDE, stride + 1);
      else if (stride > 1 && spent * (stride / (stride - 1)) ** 2 < 0.7 * BUDGET_MS) stride -= 1;
      if (Number(canvas.dataset.stride) > 1)
        timer = setTimeout(() => paint(look, colors, 1), SETTLE_MS);
    },
    destroy() {
      clearTimeout(timer);
    },
  };
}
