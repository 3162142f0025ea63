// Walk around with a pointer, two fingers, the wheel, keys or buttons.

import { make, setTraits } from "./_frame.js";
import { makeNamedView, turnOrbit, zoomOrbit } from "./_orbit.js";

const DEGREES_PER_PIXEL = 0.4;
const DEGREES_PER_KEY = 5;
const ZOOM_PER_PRESS = 1.2;
/** @type {Record<string, number>} */
const CLICK_SLACK = { mouse: 3, pen: 6, touch: 10 }; // pixels a press may move and still be a click
/** @type {Record<string, Pair>} */
const KEY_TURNS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {Record<string, number>} */
const KEY_ZOOMS = {
  "+": 1 / ZOOM_PER_PRESS,
  "=": 1 / ZOOM_PER_PRESS,
  "-": ZOOM_PER_PRESS,
  _: ZOOM_PER_PRESS,
};

const NAMED_VIEWS = {
  camera: "view of the camera",
  above: "view from above",
  side: "view from the side",
};

/**
 * Let the reader turn `surface`; the trait `orbit` holds the place. A press that does not move
 * calls `pick(x, y, slack)` in pixels of the surface.
 *
 * A scrolling page is left alone: the wheel zooms only after a click (or with Ctrl), and a finger
 * that moves up or down scrolls the page until the surface was tapped (see `touch-action` in
 * explorer.css).
 * @param {{ model: OrbitModel, frame: Frame, surface: HTMLElement, pick: (x: number, y: number, slack: number) => void }} parts
 */
export function makeOrbitControls({ model, frame, surface, pick }) {
  /** @type {Map<number, Pair>} */
  const fingers = new Map();
  let moved = 0;
  const look = (/** @type {Orbit} */ orbit) => model.set("orbit", orbit); // a kernel hears where it ends, not every step
  surface.tabIndex = 0;
  surface.setAttribute("role", "application");
  surface.setAttribute("aria-roledescription", "3-D view");

  surface.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    if (!fingers.size) moved = 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    surface.setPointerCapture(event.pointerId);
  });
  surface.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    /** @type {Pair} */
    const now = [event.clientX, event.clientY];
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    moved += Math.hypot(dx, dy);
    const [gapBefore, gap] = [spread(fingers), spread(fingers.set(event.pointerId, now))];
    if (gapBefore && gap) look(zoomOrbit(model.get("orbit"), gapBefore / gap));
    else if (moved > CLICK_SLACK[event.pointerType]) {
      const scrolls = event.pointerType === "touch" && !surface.matches(":focus");
      const tilt = scrolls ? 0 : dy * DEGREES_PER_PIXEL;
      look(turnOrbit(model.get("orbit"), -dx * DEGREES_PER_PIXEL, tilt));
    }
  });
  const release = (/** @type {PointerEvent} */ event) => {
    if (!fingers.delete(event.pointerId) || fingers.size) return;
    const slack = CLICK_SLACK[event.pointerType];
    if (event.type === "pointerup" && moved <= slack) {
      const box = surface.getBoundingClientRect();
      pick(event.clientX - box.left, event.clientY - box.top, slack + 4);
      surface.focus({ preventScroll: true });
    }
    model.save_changes();
  };
  surface.addEventListener("pointerup", release);
  surface.addEventListener("pointercancel", release);
  surface.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !surface.matches(":focus")) return;
      event.preventDefault();
      look(
        zoomOrbit(model.get("orbit"), Math.exp(Math.max(-60, Math.min(60, event.deltaY)) / 300)),
      );
      model.save_changes();
    },
    { passive: false },
  );
  surface.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const orbit = model.get("orbit");
    const turn = KEY_TURNS[event.key];
    if (turn) look(turnOrbit(orbit, turn[0] * DEGREES_PER_KEY, turn[1] * DEGREES_PER_KEY));
    else if (event.key in KEY_ZOOMS) look(zoomOrbit(orbit, KEY_ZOOMS[event.key]));
    else if (event.key === "Home") look(model.get("start").orbit);
    else return;
    model.save_changes();
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
  frame.cleanups.push(() => fingers.clear());
}

/**
 * How far apart two fingers are; 0 for one.
 * @param {Map<number, Pair>} fingers
 */
function spread(fingers) {
  if (fingers.size !== 2) return 0;
  const [a, b] = fingers.values();
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/**
 * Make the buttons: two zooms, three views.
 * @param {Element} parent
 * @param {OrbitModel} model
 * @param {Transform} camera
 */
export function makeOrbitButtons(parent, model, camera) {
  const row = make("div", "explorer-cloud-buttons", parent);
  row.setAttribute("role", "group");
  row.setAttribute("aria-label", "view");
  /**
   * @param {string} text
   * @param {string} name
   * @param {(orbit: Orbit) => Orbit} change
   */
  const add = (text, name, change) => {
    const button = make("button", "explorer-button", row);
    button.type = "button";
    button.textContent = text;
    button.setAttribute("aria-label", name);
    button.addEventListener("click", () => setTraits(model, { orbit: change(model.get("orbit")) }));
  };
  add("+", "zoom in", (orbit) => zoomOrbit(orbit, 1 / ZOOM_PER_PRESS));
  add("−", "zoom out", (orbit) => zoomOrbit(orbit, ZOOM_PER_PRESS));
  for (const [name, spoken] of Object.entries(NAMED_VIEWS)) {
    add(name, spoken, () => makeNamedView(name, model.get("start").orbit, camera));
  }
}
