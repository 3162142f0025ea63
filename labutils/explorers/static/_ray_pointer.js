// Which ray of the camera one points at: by a pixel of its picture, with pointer or keys, or by a
// direction in a drawing from above, which is a column of the picture.

import { make } from "./_frame.js";

const STEP = 1 / 40; // of the picture, per arrow key
/** @type {Record<string, Pair>} */
const KEYS = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

/**
 * Watch what is pointed at. `draw` is called after each change; then `show` marks the ray in the
 * picture and returns it, null where none is pointed at.
 * @param {HTMLCanvasElement} canvas
 * @param {() => void} draw
 */
export function makeRayPointer(canvas, draw) {
  const holder = make("div", "explorer-picker");
  canvas.replaceWith(holder);
  holder.append(canvas);
  const line = make("div", "explorer-column", holder);
  const mark = make("div", "explorer-mark", holder);
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application"); // arrow keys are for the page, not the screen reader
  canvas.setAttribute("aria-roledescription", "ray picker");
  canvas.setAttribute("aria-label", "What the camera sees. Arrow keys point at a pixel");
  /** Shares of the width and of the height; without the second a whole column is meant. */
  /** @type {number[] | null} */
  let at = null;
  const pointAt = (/** @type {number[] | null} */ shares) => {
    at = shares?.map((one) => Math.min(1 - 1e-6, Math.max(0, one))) ?? null;
    draw();
  };
  const fromPointer = (/** @type {PointerEvent} */ event) => {
    const box = canvas.getBoundingClientRect();
    pointAt([(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height]);
  };
  canvas.addEventListener("pointerdown", fromPointer);
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "touch") fromPointer(event);
  });
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch") pointAt(null); // a finger leaves, what it chose stays
  });
  canvas.addEventListener("blur", () => pointAt(null));
  canvas.addEventListener("keydown", (event) => {
    const step = KEYS[event.key];
    if (!step) return;
    const [x, y = 0.5] = at ?? [0.5, 0.5];
    pointAt([x + step[0], y + step[1]]);
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
  return {
    pointAt,
    /**
     * @param {Matrix} K
     * @param {Pair} size of the camera's picture in pixels
     */
    show(K, size) {
      line.hidden = !at;
      mark.hidden = at?.length !== 2;
      if (!at) return null;
      const [u, v] = at.map((share, place) => Math.floor(share * size[place]));
      const right = toDegrees((u - K[0][2]) / K[0][0]);
      line.style.left = mark.style.left = `${((u + 0.5) / size[0]) * 100}%`;
      if (v === undefined) return { u, v: null, right, up: null };
      mark.style.top = `${((v + 0.5) / size[1]) * 100}%`;
      return { u, v, right, up: -toDegrees((v - K[1][2]) / K[1][1]) };
    },
  };
}

/**
 * Where a ray leads, in words.
 * @param {Ray} ray
 */
export function describeRay({ u, v, right, up }) {
  const side = `${Math.abs(right).toFixed(1)}° to the ${right < 0 ? "left" : "right"}`;
  if (v === null) return `Column ${u} looks ${side}.`;
  return `Pixel (${u}, ${v}) looks ${side}, ${Math.abs(up).toFixed(1)}° ${up < 0 ? "down" : "up"}.`;
}

function toDegrees(/** @type {number} */ tangent) {
  return (Math.atan(tangent) * 180) / Math.PI;
}
