// Small plots in SVG. Colors come from the style sheet; every plot fits a phone, with text that
// can be read there, so wide ones are two beside each other and not one with small text.

import { make } from "./_frame.js";
import { addShape } from "./_shapes.js";

export const PLOT_WIDTH = 320;

/**
 * Make an empty drawing that says in words what it shows.
 * @param {Element} parent
 * @param {number} height
 */
export function makeDrawing(parent, height) {
  const figure = make("div", "explorer-plot", parent);
  return addShape(figure, "svg", { viewBox: `0 0 ${PLOT_WIDTH} ${height}`, role: "img" });
}

/**
 * Make the part of a drawing outside which nothing is drawn; it has the drawing's coordinates.
 * @param {Element} svg
 * @param {Area} area
 */
export function addWindow(svg, { left, top, right, bottom }) {
  const [width, height] = [right - left, bottom - top];
  const viewBox = `${left} ${top} ${width} ${height}`;
  return addShape(svg, "svg", { x: left, y: top, width, height, viewBox, overflow: "hidden" });
}

/**
 * Make a function from values to places; the logarithmic one takes values above 0.
 * @param {Pair} limits
 * @param {Pair} places
 * @param {boolean} log
 */
export function makeScale([low, high], [from, to], log = false) {
  const warp = log ? Math.log10 : Number;
  const slope = (to - from) / (warp(high) - warp(low));
  return (/** @type {number} */ value) => from + slope * (warp(value) - warp(low));
}

/**
 * Round values for the ticks of an axis: at most `most` steps of 1, 2 or 5 times a power of ten.
 * @param {Pair} limits
 * @param {number} most
 * @param {boolean} log
 */
export function chooseTicks([low, high], most = 5, log = false) {
  const ticks = [];
  if (log) {
    const [first, last] = [Math.log10(low) - 1e-9, Math.log10(high) + 1e-9];
    for (let n = Math.ceil(first); n <= last; n++) ticks.push(Number(`1e${n}`));
    return ticks;
  }
  const rough = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((one) => one * power >= rough * (1 - 1e-9)) ?? 10);
  for (let n = Math.ceil(low / step - 1e-9); n * step <= high + step * 1e-9; n++) {
    ticks.push(Number((n * step).toPrecision(9)));
  }
  return ticks;
}

/**
 * The text of SVG's path through points.
 * @param {Pair[]} points
 */
export function toPath(points) {
  return points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
}

/**
 * Make axes; `x` and `y` have a label, and may have log and format. `setLimits` draws the ticks
 * where the limits have changed; then `plot.x` and `plot.y` turn values into places.
 * @param {Element} parent
 * @param {{ height?: number, left?: number, x: Axis, y: Axis }} options
 * @returns {Plot}
 */
export function makePlot(parent, { height = 200, left = 44, x, y }) {
  const svg = makeDrawing(parent, height);
  const area = { left, right: PLOT_WIDTH - 12, top: 26, bottom: height - 40 };
  const ground = addShape(svg, "g", { class: "explorer-axes" });
  const inside = addWindow(svg, area);
  const above = addShape(svg, "g");
  addShape(svg, "text", { x: 4, y: 14 }, y.label);
  const under = { x: (area.left + area.right) / 2, y: height - 6, "text-anchor": "middle" };
  addShape(svg, "text", under, x.label);
  let drawn = "";
  /** @type {Plot} */
  const plot = { svg, area, inside, above, x: Number, y: Number, setLimits };
  return plot;

  /** @type {Plot["setLimits"]} */
  function setLimits(xLimits, yLimits) {
    if (drawn === `${xLimits};${yLimits}`) return false;
    drawn = `${xLimits};${yLimits}`;
    plot.x = makeScale(xLimits, [area.left, area.right], x.log);
    plot.y = makeScale(yLimits, [area.bottom, area.top], y.log);
    ground.replaceChildren();
    for (const tick of chooseTicks(yLimits, 4, y.log)) {
      const at = plot.y(tick);
      addShape(ground, "path", { d: `M${area.left} ${at}H${area.right}` });
      const place = { x: area.left - 6, y: at + 4.5, "text-anchor": "end" };
      addShape(ground, "text", place, (y.format ?? String)(tick));
    }
    for (const tick of chooseTicks(xLimits, 5, x.log)) {
      const at = plot.x(tick);
      addShape(ground, "path", { d: `M${at} ${area.bottom}v5` });
      const place = { x: at, y: area.bottom + 18, "text-anchor": "middle" };
      addShape(ground, "text", place, (x.format ?? String)(tick));
    }
    addShape(ground, "path", { d: `M${area.left} ${area.bottom}H${area.right}`, class: "axis" });
    return true;
  }
}
