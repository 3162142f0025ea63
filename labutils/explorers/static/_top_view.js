// The camera from above: how wide it sees, and which things lie inside.

import { make } from "./_frame.js";
import { addShape } from "./_shapes.js";

const [WIDTH, HEIGHT] = [320, 300];
const CAMERA = [WIDTH / 2, HEIGHT - 24];

/** Make the drawing; `drawTopView` fills it. @param {Element} parent */
export function makeTopView(parent) {
  const figure = make("div", "explorer-top", parent);
  const svg = addShape(figure, "svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  make("p", "explorer-small", figure).textContent = "from above";
  return svg;
}

/**
 * Draw the wedge of sight and the things as dots; return the names of those inside.
 * @param {SVGElement} svg
 * @param {number} fovX
 * @param {Landmark[]} landmarks
 */
export function drawTopView(svg, fovX, landmarks) {
  const farthest = Math.max(...landmarks.map(({ x, z }) => Math.hypot(x, z)), 0.1);
  const scale = (HEIGHT - 70) / farthest; // pixels per meter
  const place = (/** @type {Landmark} */ { x, z }) => [
    CAMERA[0] + x * scale,
    CAMERA[1] - z * scale,
  ];
  const half = (fovX * Math.PI) / 360;
  const reach = CAMERA[1] - 2;
  const end = (/** @type {number} */ side) => [
    CAMERA[0] + side * reach * Math.sin(half),
    CAMERA[1] - reach * Math.cos(half),
  ];
  svg.replaceChildren();
  const [left, right] = [end(-1), end(1)];
  const arc = `M${CAMERA} L${left} A${reach} ${reach} 0 ${half > Math.PI / 2 ? 1 : 0} 1 ${right} Z`;
  addShape(svg, "path", { d: arc, class: "explorer-wedge" });
  const inside = landmarks.filter(({ x, z }) => z > 0 && Math.abs(x / z) <= Math.tan(half));
  for (const one of landmarks) {
    const [x, y] = place(one);
    const kind = inside.includes(one) ? "explorer-dot inside" : "explorer-dot";
    addShape(svg, "circle", { cx: x, cy: y, r: 6, fill: one.color, class: kind });
  }
  addShape(svg, "path", { d: `M${CAMERA} l-9 20 h18 Z`, class: "explorer-eye" });
  svg.setAttribute(
    "aria-label",
    `From above: ${inside.length} of ${landmarks.length} objects lie between the rays`,
  );
  return inside.sort((a, b) => a.x / a.z - b.x / b.z).map(({ name }) => name);
}
