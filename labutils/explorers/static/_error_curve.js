// How far off a depth may be, over depth. Both axes are logarithmic: a straight line is a power, and
// its slope is two. The reader can choose a depth on it.

import { watchBins } from "./_bins.js";
import { makePlot, toPath } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";
import { findDisparity, findLargestError, findLinearError } from "./_stereo.js";

const [NEAREST, FARTHEST, CURVE_STEPS] = [0.1, 10, 100];
const [LEAST_MM, MOST_MM] = [0.1, 10000];
const BINS = 60;

/**
 * Make the curve; `choose` hears the depths, in meters, that the reader points at, or null.
 * @param {Element} parent
 * @param {(depths: Pair | null) => void} choose
 */
export function makeErrorCurve(parent, choose) {
  /** @param {number} mm */
  const format = (mm) => (mm < 1000 ? `${mm} mm` : `${mm / 1000} m`);
  const y = { label: "depth error", log: true, format };
  const x = { label: "depth (m)", log: true };
  const plot = makePlot(parent, { height: 190, left: 66, x, y });
  plot.setLimits([NEAREST, FARTHEST], [LEAST_MM, MOST_MM]);
  const { area, inside, above } = plot;
  const tall = { y: area.top, height: area.bottom - area.top };
  const beyond = addShape(inside, "rect", { class: "explorer-band", ...tall });
  const linear = addShape(inside, "path", { class: "explorer-rival dashed" });
  const exact = addShape(inside, "path", { class: "explorer-curve" });
  const note = makeNote(above, area.right - 4, area.top + 16);
  note.textContent = "no far limit";
  const name = makeNote(above, area.right - 4, area.bottom - 10);
  const hovered = addShape(inside, "rect", { class: "explorer-hovered", ...tall, width: 0 });
  const point = addShape(above, "circle", { r: 7, class: "explorer-point" });
  let [focal, baseline, error] = [1, 1, 0];

  const options = { bins: BINS, first: BINS >> 1, name: "curve", describe };
  watchBins(plot, options, (bin) => {
    const [low, high] = toDepths(bin ?? 0);
    setShape(hovered, { x: plot.x(low), width: bin === null ? 0 : plot.x(high) - plot.x(low) });
    name.textContent = bin === null ? "dashed: Z² e / (f b)" : describe(bin);
    choose(bin === null ? null : [low, high]);
  });
  return {
    /** @type {(values: StereoValues, focal: number, baseline: number, error: number) => void} */
    show({ depth, error_mm }, ...setting) {
      [focal, baseline, error] = setting;
      /** @type {{ exact: Pair[], linear: Pair[] }} */
      const points = { exact: [], linear: [] };
      for (let i = 0; i <= CURVE_STEPS; i++) {
        const z = NEAREST * (FARTHEST / NEAREST) ** (i / CURVE_STEPS);
        const largest = findLargestError(z, ...swap(setting));
        points.linear.push([plot.x(z), plot.y(1000 * findLinearError(z, ...swap(setting)))]);
        if (largest !== null) points.exact.push([plot.x(z), plot.y(1000 * largest)]);
      }
      setShape(linear, { d: toPath(points.linear) });
      setShape(exact, { d: toPath(points.exact) });
      const limit = (focal * baseline) / error;
      const from = plot.x(Math.min(limit, FARTHEST));
      setShape(beyond, { x: from, width: area.right - from });
      note.style.display = area.right - from > 20 ? "" : "none";
      point.style.display = error_mm === null ? "none" : "";
      if (error_mm !== null) {
        const inLimits = Math.min(MOST_MM, Math.max(LEAST_MM, error_mm));
        setShape(point, { cx: plot.x(Math.max(depth, NEAREST)), cy: plot.y(inLimits) });
      }
      const label = `Depth error over depth: ${tell(1)} at 1 m, ${tell(2)} at 2 m`;
      setShape(plot.svg, { "aria-label": label });
    },
  };

  /** @param {number} meters */
  function tell(meters) {
    const largest = findLargestError(meters, error, focal, baseline);
    return largest === null ? "without limit" : `${(1000 * largest).toFixed(1)} mm`;
  }

  /** @param {number} bin */
  function describe(bin) {
    const [low, high] = toDepths(bin);
    const middle = Math.sqrt(low * high);
    const disparity = findDisparity(middle, focal, baseline);
    return `${middle.toFixed(2)} m: ${disparity.toFixed(1)} px, off by ${tell(middle)}`;
  }
}

/**
 * The depths between which a part of the curve lies.
 * @param {number} bin
 * @returns {Pair}
 */
function toDepths(bin) {
  const at = (/** @type {number} */ end) => NEAREST * (FARTHEST / NEAREST) ** (end / BINS);
  return [at(bin), at(bin + 1)];
}

/**
 * Focal length, baseline, error in the order of the formulas.
 * @param {[number, number, number]} setting
 * @returns {[number, number, number]}
 */
function swap([focal, baseline, error]) {
  return [error, focal, baseline];
}

/**
 * @param {Element} parent
 * @param {number} x
 * @param {number} y
 */
function makeNote(parent, x, y) {
  return addShape(parent, "text", { class: "halo soft", "text-anchor": "end", x, y });
}
