// The camera from above: how wide it sees, which things lie inside, and a ray that is pointed at.

import { make } from "./_frame.js";
import { addShape, setShape } from "./_shapes.js";

const [WIDTH, HEIGHT] = [320, 300];
/** @type {Pair} */
const CAMERA = [WIDTH / 2, HEIGHT - 24];
const REACH = CAMERA[1] - 2;

/**
 * Make the drawing. `show` draws an angle and a ray; `onPoint` tells at which share of the picture's
 * width one points, null for none.
 * @param {Element} parent
 * @param {Landmark[]} landmarks
 */
export function makeTopView(parent, landmarks) {
  const figure = make("div", "explorer-top", parent);
  const svg = addShape(figure, "svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  make("p", "explorer-small", figure).textContent = "from above";
  const farthest = Math.max(...landmarks.map(({ x, z }) => Math.hypot(x, z)), 0.1);
  const scale = (HEIGHT - 70) / farthest; // pixels per meter
  const wedge = addShape(svg, "path", { class: "explorer-wedge" });
  const dots = landmarks.map(({ x, z, color }) =>
    addShape(svg, "circle", {
      cx: CAMERA[0] + x * scale,
      cy: CAMERA[1] - z * scale,
      r: 6,
      fill: color,
    }),
  );
  const line = addShape(svg, "path", { class: "explorer-top-ray" });
  addShape(svg, "path", { d: `M${CAMERA} l-9 20 h18 Z`, class: "explorer-eye" });
  let half = 0;
  /** @param {number} angle */
  const endOf = (angle) => [
    CAMERA[0] + REACH * Math.sin(angle),
    CAMERA[1] - REACH * Math.cos(angle),
  ];
  return {
    /**
     * Draw; returns the names of the things between the rays, from left to right.
     * @param {number} fovX
     * @param {Ray | null} ray
     */
    show(fovX, ray) {
      half = (fovX * Math.PI) / 360;
      const arc = `A${REACH} ${REACH} 0 ${half > Math.PI / 2 ? 1 : 0} 1 ${endOf(half)}`;
      setShape(wedge, { d: `M${CAMERA} L${endOf(-half)} ${arc} Z` });
      const isInside = (/** @type {Landmark} */ { x, z }) =>
        z > 0 && Math.abs(x / z) <= Math.tan(half);
      for (const [place, dot] of dots.entries()) {
        const kind = isInside(landmarks[place]) ? "explorer-dot inside" : "explorer-dot";
        setShape(dot, { class: kind });
      }
      const angle = ray && (ray.right * Math.PI) / 180;
      setShape(line, { d: angle === null ? "" : `M${CAMERA} L${endOf(angle)}` });
      const inside = landmarks.filter(isInside);
      const count = `${inside.length} of ${landmarks.length}`;
      setShape(svg, { "aria-label": `From above: ${count} objects lie between the rays` });
      return inside.sort((a, b) => a.x / a.z - b.x / b.z).map(({ name }) => name);
    },
    /** @param {(share: number[] | null) => void} point */
    onPoint(point) {
      const follow = (/** @type {PointerEvent} */ event) => {
        const box = svg.getBoundingClientRect();
        const x = ((event.clientX - box.left) / box.width) * WIDTH - CAMERA[0];
        const z = CAMERA[1] - ((event.clientY - box.top) / box.height) * HEIGHT;
        const share = 0.5 + x / z / (2 * Math.tan(half));
        point(z > 0 && share >= 0 && share < 1 ? [share] : null);
      };
      svg.addEventListener("pointermove", follow);
      svg.addEventListener("pointerdown", follow);
      svg.addEventListener("pointerleave", (event) => {
        if (event.pointerType !== "touch") point(null);
      });
    },
  };
}
