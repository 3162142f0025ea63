// All hues in a ring, red on top; the chosen arc is lit and both its ends can be moved. The sector
// inside it shows which saturations go with it, gray in the middle.

import { isHueInside } from "./_color.js";
import { make, setTraits } from "./_frame.js";
import { addShape, setShape } from "./_shapes.js";
import { HUES } from "./_shared.js";

const SIZE = 240;
const MIDDLE = SIZE / 2;
const [RING, RING_INNER, DISC] = [100, 74, 68];
// two ends of the same hue stay apart: one sits outside the arc, one inside
/** @type {{ trait: keyof HueEnds, label: string, radius: number }[]} */
const ENDS = [
  { trait: "hue_from", label: "hue from, on the ring", radius: RING },
  { trait: "hue_to", label: "hue to, on the ring", radius: RING_INNER },
];
/** @type {Record<string, number | undefined>} */
const PACES = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};

/**
 * Make the ring; its ends set hue_from and hue_to. Returns { show }.
 * @param {Element} parent
 * @param {Model<HueEnds>} model
 */
export function makeHueRing(parent, model) {
  const figure = make("div", "explorer-ring", parent);
  const dial = make("div", "explorer-dial", figure);
  const svg = addShape(dial, "svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, "aria-hidden": "true" });
  const hues = Array.from({ length: HUES }, (_, hue) => {
    const color = `hsl(${2 * hue} 100% 50%)`; // the outline closes the seam to the next hue
    return addShape(svg, "path", {
      d: drawSector(hue, hue, RING_INNER, RING),
      fill: color,
      stroke: color,
    });
  });
  addShape(svg, "circle", { cx: MIDDLE, cy: MIDDLE, r: DISC, class: "explorer-disc" });
  const sector = addShape(svg, "path", { class: "explorer-sector" });
  for (let hue = 0; hue < HUES; hue += 30) {
    const [x, y] = toPlace(hue, RING + 13);
    addShape(svg, "text", { x, y: y + 5 }, String(hue));
  }
  const dot = addShape(svg, "circle", { r: 5, class: "explorer-hue-dot" });
  const caption = make("p", "explorer-ring-caption", figure);
  const ends = ENDS.map((end) => makeEnd(dial, model, end));
  dragEnds(dial, model, ends);

  let drawn = "";
  return {
    /**
     * Light the arc of the limits, and mark the color of the picked pixel, if any.
     * @param {HsvLimits} limits
     * @param {Triple | null} hsv
     * @param {number[] | null} rgb
     */
    show(limits, hsv, rgb) {
      dot.classList.toggle("hidden", !hsv);
      if (hsv) {
        const [cx, cy] = toPlace(hsv[0], (hsv[1] / 255) * DISC);
        setShape(dot, { cx, cy, fill: `rgb(${rgb})` });
      }
      const [[from, sLow], [to, sHigh]] = limits;
      const wanted = [from, to, sLow, sHigh].join();
      if (wanted === drawn) return;
      drawn = wanted;
      for (const [hue, path] of hues.entries()) {
        path.classList.toggle("lit", isHueInside(hue, from, to));
      }
      sector.setAttribute("d", drawSector(from, to, (sLow / 255) * DISC, (sHigh / 255) * DISC));
      caption.textContent = `hue ${from} to ${to}${from > to ? ", through 0" : ""}`;
      placeEnd(ends[0].handle, from, ends[0].radius);
      placeEnd(ends[1].handle, to, ends[1].radius);
    },
  };
}

/**
 * Where a hue lies, clockwise from the top.
 * @param {number} hue
 * @param {number} radius
 * @returns {Pair}
 */
function toPlace(hue, radius) {
  const angle = (hue / HUES) * 2 * Math.PI;
  return [MIDDLE + radius * Math.sin(angle), MIDDLE - radius * Math.cos(angle)];
}

/**
 * The outline of all hues from one to another, each with half a step on both sides.
 * @param {number} from
 * @param {number} to
 * @param {number} inner
 * @param {number} outer
 */
function drawSector(from, to, inner, outer) {
  const [first, end] = [from - 0.5, (to < from ? to + HUES : to) + 0.5];
  // an arc of a full turn would vanish: two halves never do
  const half = (first + end) / 2;
  /** @type {(radius: number, hue: number, clockwise: number) => string} */
  const arc = (radius, hue, clockwise) =>
    `A${radius} ${radius} 0 0 ${clockwise} ${toPlace(hue, radius)}`;
  return (
    `M${toPlace(first, outer)} ${arc(outer, half, 1)} ${arc(outer, end, 1)} ` +
    `L${toPlace(end, inner)} ${arc(inner, half, 0)} ${arc(inner, first, 0)} Z`
  );
}

/**
 * @param {Element} dial
 * @param {Model<HueEnds>} model
 * @param {(typeof ENDS)[0]} end
 */
function makeEnd(dial, model, { trait, label, radius }) {
  const handle = make("div", "explorer-end", dial);
  handle.tabIndex = 0;
  const range = { "aria-valuemin": 0, "aria-valuemax": HUES - 1 };
  setShape(handle, { role: "slider", "aria-label": label, ...range });
  handle.addEventListener("keydown", (event) => {
    const hue = model.get(trait);
    const ends = new Map([
      ["Home", 0],
      ["End", HUES - 1],
    ]);
    const next = ends.get(event.key) ?? hue + (PACES[event.key] ?? NaN);
    if (Number.isNaN(next)) return;
    setTraits(model, { [trait]: (next + HUES) % HUES });
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
  return { handle, trait, radius };
}

/**
 * @param {HTMLElement} handle
 * @param {number} hue
 * @param {number} radius
 */
function placeEnd(handle, hue, radius) {
  const [x, y] = toPlace(hue, radius);
  handle.style.left = `${(100 * x) / SIZE}%`;
  handle.style.top = `${(100 * y) / SIZE}%`;
  handle.style.background = `hsl(${2 * hue} 100% 50%)`;
  handle.setAttribute("aria-valuenow", String(hue));
}

/**
 * Let a pointer drag the end it is nearest to; a finger has to start on an end, to scroll elsewhere.
 * @param {HTMLElement} dial
 * @param {Model<HueEnds>} model
 * @param {RingEnd[]} ends
 */
function dragEnds(dial, model, ends) {
  /** @type {RingEnd | null} */
  let held = null;
  const locate = (/** @type {PointerEvent} */ event) => {
    const box = dial.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top].map((at) => (at / box.width) * SIZE);
  };
  const move = (/** @type {PointerEvent} */ event) => {
    if (!held) return;
    const [x, y] = locate(event);
    const turn = Math.atan2(x - MIDDLE, MIDDLE - y) / (2 * Math.PI);
    setTraits(model, { [held.trait]: (Math.round(turn * HUES) + HUES) % HUES });
  };
  dial.addEventListener("pointerdown", (event) => {
    const onEnd = ends.some(({ handle }) => handle.contains(/** @type {Node} */ (event.target)));
    const [x, y] = locate(event);
    const radius = Math.hypot(x - MIDDLE, y - MIDDLE);
    const onRing = event.pointerType !== "touch" && radius > RING_INNER - 2 && radius < RING + 2;
    if (event.button || !(onEnd || onRing)) return;
    const distance = (/** @type {RingEnd} */ end) => {
      const [endX, endY] = toPlace(model.get(end.trait), end.radius);
      return Math.hypot(x - endX, y - endY);
    };
    held = distance(ends[0]) < distance(ends[1]) ? ends[0] : ends[1];
    event.preventDefault();
    held.handle.focus({ preventScroll: true });
    dial.setPointerCapture(event.pointerId);
    if (!onEnd) move(event);
  });
  dial.addEventListener("pointermove", move);
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
    dial.addEventListener(end, () => (held = null));
  }
}
