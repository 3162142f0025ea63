// The lowest point of the cost curve from near: three costs, the parabola through them, its lowest
// point and the truth. It has a scale of its own, or a steep curve and a flat one would look alike.

import { sampleParabola } from "./_cost_curve.js";
import { make } from "./_frame.js";
import { addWindow, makeScale, toPath } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";

const [WIDTH, HEIGHT] = [132, 182];
const AREA = { left: 8, right: WIDTH - 8, top: 26, bottom: HEIGHT - 40 };
const HALF = 1.7; // disparities to either side

/**
 * Make the drawing.
 * @param {Element} parent
 */
export function makeCloseUp(parent) {
  const figure = make("div", "explorer-plot explorer-close-up", parent);
  const svg = addShape(figure, "svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  addShape(svg, "text", { x: 4, y: 14 }, "close-up");
  const frame = addShape(svg, "g", { class: "explorer-axes" });
  addShape(frame, "path", { class: "axis", d: `M${AREA.left} ${AREA.bottom}H${AREA.right}` });
  const ticks = [-1, 0, 1].map((step) => {
    const at = makeScale([-HALF, HALF], [AREA.left, AREA.right])(step);
    addShape(frame, "path", { d: `M${at} ${AREA.bottom}v5` });
    return addShape(frame, "text", { x: at, y: AREA.bottom + 18, "text-anchor": "middle" });
  });
  const told = addShape(svg, "text", { x: WIDTH / 2, y: HEIGHT - 6, "text-anchor": "middle" });
  const inside = addWindow(svg, AREA);
  const truth = addShape(inside, "path", { class: "explorer-true-line" });
  const lowest = addShape(inside, "path", { class: "explorer-found-line" });
  const parabola = addShape(inside, "path", { class: "explorer-parabola" });
  const points = ticks.map(() => addShape(inside, "circle", { r: 5, class: "explorer-point" }));
  const shapes = [...points, ...ticks, lowest, parabola];
  return {
    /** @type {(values: MatchValues) => void} */
    show({ costs, disparity: best, subpixel, truth: real }) {
      const sampled = best === null ? [] : sampleParabola(costs, best);
      for (const one of [...shapes, truth]) one.style.display = sampled.length ? "" : "none";
      told.textContent = subpixel === null ? "no window" : `${subpixel.toFixed(2)} px`;
      setShape(svg, { "aria-label": `Parabola through three costs: ${told.textContent}` });
      if (best === null || subpixel === null || !sampled.length) return;
      const three = costs.slice(best - 1, best + 2);
      const spread = Math.max(...three) - three[1] || 1;
      const x = makeScale([best - HALF, best + HALF], [AREA.left, AREA.right]);
      const y = makeScale(
        [three[1] - 0.3 * spread, three[1] + 1.2 * spread],
        [AREA.bottom, AREA.top],
      );
      for (const [i, cost] of three.entries()) {
        setShape(points[i], { cx: x(best - 1 + i), cy: y(cost) });
        ticks[i].textContent = String(best - 1 + i);
      }
      setShape(parabola, { d: toPath(sampled.map(([d, cost]) => [x(d), y(cost)])) });
      const upright = (/** @type {number} */ d) => `M${x(d)} ${AREA.top}V${AREA.bottom}`;
      setShape(lowest, { d: upright(subpixel) });
      setShape(truth, { d: real === null ? "" : upright(real) });
    },
  };
}
