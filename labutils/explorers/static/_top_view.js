// The camera from above: how wide it sees, and which things lie inside.

import { make } from "./_frame.js";

const SVG = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [320, 300];
const CAMERA = [WIDTH / 2, HEIGHT - 24];

function add(parent, tag, attributes) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
}

/** Make the drawing; `drawTopView` fills it. */
export function makeTopView(parent) {
  const figure = make("div", "explorer-top", parent);
  const svg = add(figure, "svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  make("p", "explorer-small", figure).textContent = "from above";
  return svg;
}

/** Draw the wedge of sight and the things as dots; return the names of those inside. */
export function drawTopView(svg, fovX, landmarks) {
  const farthest = Math.max(...landmarks.map(({ x, z }) => Math.hypot(x, z)), 0.1);
  const scale = (HEIGHT - 70) / farthest; // pixels per meter
  const place = ({ x, z }) => [CAMERA[0] + x * scale, CAMERA[1] - z * scale];
  const half = (fovX * Math.PI) / 360;
  const reach = CAMERA[1] - 2;
  const end = (side) => [
    CAMERA[0] + side * reach * Math.sin(half),
    CAMERA[1] - reach * Math.cos(half),
  ];
  svg.replaceChildren();
  const [left, right] = [end(-1), end(1)];
  const arc = `M${CAMERA} L${left} A${reach} ${reach} 0 ${half > Math.PI / 2 ? 1 : 0} 1 ${right} Z`;
  add(svg, "path", { d: arc, class: "explorer-wedge" });
  const inside = landmarks.filter(({ x, z }) => z > 0 && Math.abs(x / z) <= Math.tan(half));
  for (const one of landmarks) {
    const [x, y] = place(one);
    const kind = inside.includes(one) ? "explorer-dot inside" : "explorer-dot";
    add(svg, "circle", { cx: x, cy: y, r: 6, fill: one.color, class: kind });
  }
  add(svg, "path", { d: `M${CAMERA} l-9 20 h18 Z`, class: "explorer-eye" });
  svg.setAttribute(
    "aria-label",
    `From above: ${inside.length} of ${landmarks.length} objects lie between the rays`,
  );
  return inside.sort((a, b) => a.x / a.z - b.x / b.z).map(({ name }) => name);
}
