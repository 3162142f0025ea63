// Turn a camera by its picture: drag what is seen, or press the arrow keys.

import { setTraits } from "./_frame.js";

const DEGREES_PER_KEY = 2;
const LEAP = 5; // times as far with Shift
/** @type {Record<string, Pair>} */
const KEYS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * Angles that lie within their limits, in tenths of a degree as the sliders have them.
 * @param {Pair} angles pan to the left and tilt down, in degrees
 * @param {Pair[]} limits
 * @returns {Pair}
 */
export function limitAngles([pan, tilt], limits) {
  const limit = (/** @type {number} */ angle, /** @type {Pair} */ [low, high]) =>
    Math.min(high, Math.max(low, Math.round(angle * 10) / 10));
  return [limit(pan, limits[0]), limit(tilt, limits[1])];
}

/**
 * Let the reader drag `canvas`: what is under the pointer stays there, in the middle of the picture.
 * On a touch screen a finger that moves up or down scrolls the page until the canvas was tapped (see
 * `touch-action` in scene.css).
 * @param {Model<SceneAngles & { limits_deg: Pair[], fov_y_deg: number }>} model
 * @param {HTMLCanvasElement} canvas
 */
export function makeLookControls(model, canvas) {
  /** @type {{ x: number, y: number, pan: number, tilt: number } | null} */
  let grabbed = null;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application"); // arrow keys are for the page, not the screen reader
  canvas.setAttribute("aria-roledescription", "camera");
  const look = (/** @type {Pair} */ angles) => {
    const [pan_deg, tilt_deg] = limitAngles(angles, model.get("limits_deg"));
    if (pan_deg === model.get("pan_deg") && tilt_deg === model.get("tilt_deg")) return;
    setTraits(model, { pan_deg, tilt_deg });
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    const [pan, tilt] = [model.get("pan_deg"), model.get("tilt_deg")];
    grabbed = { x: event.clientX, y: event.clientY, pan, tilt };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!grabbed) return;
    const degreesPerPixel = model.get("fov_y_deg") / canvas.getBoundingClientRect().height;
    const scrolls = event.pointerType === "touch" && !canvas.matches(":focus");
    const down = scrolls ? 0 : event.clientY - grabbed.y;
    look([
      grabbed.pan + (event.clientX - grabbed.x) * degreesPerPixel,
      grabbed.tilt - down * degreesPerPixel,
    ]);
  });
  const release = () => {
    grabbed = null;
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("keydown", (event) => {
    const turn = KEYS[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    const pace = DEGREES_PER_KEY * (event.shiftKey ? LEAP : 1);
    look([model.get("pan_deg") + turn[0] * pace, model.get("tilt_deg") + turn[1] * pace]);
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
}
