// Depth convention: from the raw value of a depth buffer to meters, and what one step is worth.

import {
  floatLevels,
  gapMm,
  integerLevels,
  metricToRaw,
  processDepth,
  reversedGapMm,
} from "./_depth.js";
import { defineView, drawOnChange, make, setTraits } from "./_frame.js";
import { makePlot, PLOT_WIDTH, toPath } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";

const CURVE_POINTS = 240;
const FINE_STEP = 0.01; // meters per arrow key
const BUFFERS = /** @type {const} */ ([
  ["step16_mm", "16-bit integer"],
  ["step24_mm", "24-bit integer"],
  ["step_float_mm", "float32"],
  ["step_reversed_mm", "float32, reversed"],
]);

// where along its curve each one is named, and on which side: no curve runs through a name
const LABELS = [
  { text: "true", kind: "", anchor: "end", share: 0.3, dx: -7, dy: -7, read: metricToRaw },
  { text: "linear", kind: "soft", anchor: "start", share: 0.6, dx: 8, dy: 16, read: readLinear },
  { text: "reversed", kind: "soft", anchor: "middle", share: 0.8, dx: 0, dy: -9, read: readBack },
];

/** @typedef {ReturnType<typeof readRaw>} RawValues */

export default defineView("depth-convention", start);

/**
 * @param {ConventionModel} model
 * @param {Frame} frame
 */
function start(model, frame) {
  const curve = makeCurve(frame.stage);
  const table = makeTable(frame.side);
  frame.reserve(describeLongest());
  /** @returns {Triple} */
  const get = () => [
    model.get("raw"),
    model.get("nears")[model.get("near_place")],
    model.get("far"),
  ];
  makeDraggable(curve.plot.svg, curve.plot.area, {
    get() {
      const [raw, near, far] = get();
      return { depth: processDepth(raw, near, far), near, far };
    },
    set(depth) {
      const [, near, far] = get();
      setTraits(model, { raw: metricToRaw(depth, near, far) });
    },
  });
  drawOnChange(model, frame, () => {
    const [raw, near, far] = get();
    const values = readRaw(raw, near, far);
    curve.show(values, raw, near, far);
    table.show(values);
    frame.tell(inWords(values, raw, near, far), values);
  });
}

/** Of all values the longest text: far planes are at 100 m at most. */
function describeLongest() {
  const errors = { linear_error: 99.999, reversed_error: -99.999 };
  return inWords({ ...readRaw(0.5, 0.125, 99.9), depth: 50, ...errors }, 0.5, 0.125, 99.9);
}

/**
 * What a raw value means; the same as DepthConventionView.compute in Python.
 * @param {number} raw
 * @param {number} near
 * @param {number} far
 */
export function readRaw(raw, near, far) {
  const depth = processDepth(raw, near, far);
  return {
    depth,
    linear_error: near + raw * (far - near) - depth,
    reversed_error: processDepth(1 - raw, near, far) - depth,
    step16_mm: gapMm(integerLevels(raw, 16), near, far),
    step24_mm: gapMm(integerLevels(raw, 24), near, far),
    step_float_mm: gapMm(floatLevels(raw), near, far),
    step_reversed_mm: reversedGapMm(floatLevels(1 - raw), near, far),
  };
}

/** @type {(depth: number, near: number, far: number) => number} */
function readLinear(depth, near, far) {
  return (depth - near) / (far - near);
}

/** @type {(depth: number, near: number, far: number) => number} */
function readBack(depth, near, far) {
  return 1 - metricToRaw(depth, near, far);
}

/**
 * The hyperbola with the point on it, and the two readings that are wrong.
 * @param {Element} parent
 */
function makeCurve(parent) {
  const plot = makePlot(parent, {
    height: 270,
    x: { label: "depth (m)" },
    y: { label: "raw value" },
  });
  const { inside, above } = plot;
  const reversed = addShape(inside, "path", { class: "explorer-rival dotted" });
  const linear = addShape(inside, "path", { class: "explorer-rival dashed" });
  const curve = addShape(inside, "path", { class: "explorer-curve" });
  const gap = addShape(above, "path", { class: "explorer-gap" });
  const rivals = [0, 1].map(() =>
    addShape(above, "circle", { r: 5, class: "explorer-rival-point" }),
  );
  const point = addShape(above, "circle", { r: 7, class: "explorer-point" });
  const names = LABELS.map(({ text, anchor, kind }) =>
    addShape(above, "text", { class: `halo ${kind}`, "text-anchor": anchor }, text),
  );
  let drawn = "";
  return {
    plot,
    /** @type {(values: RawValues, raw: number, near: number, far: number) => void} */
    show(values, raw, near, far) {
      plot.setLimits([0, far], [0, 1]);
      if (drawn !== `${near};${far}`) {
        drawn = `${near};${far}`;
        /** @type {Pair[]} */
        const points = [];
        for (let i = 0; i <= CURVE_POINTS; i++) {
          const depth = near + (far - near) * (i / CURVE_POINTS) ** 3; // dense where it bends
          points.push([plot.x(depth), metricToRaw(depth, near, far)]);
        }
        setShape(curve, { d: toPath(points.map(([x, d]) => [x, plot.y(d)])) });
        setShape(reversed, { d: toPath(points.map(([x, d]) => [x, plot.y(1 - d)])) });
        setShape(linear, { d: `M${plot.x(near)} ${plot.y(0)}L${plot.x(far)} ${plot.y(1)}` });
        for (const [i, { share, dx, dy, read }] of LABELS.entries()) {
          const depth = near + share * (far - near);
          setShape(names[i], {
            x: plot.x(depth) + dx,
            y: plot.y(read(depth, near, far)) + dy,
          });
        }
      }
      const [x, y] = [plot.x(values.depth), plot.y(raw)];
      const wrong = [values.linear_error, values.reversed_error].map((one) =>
        plot.x(values.depth + one),
      );
      setShape(point, { cx: x, cy: y });
      for (const [i, rival] of rivals.entries()) setShape(rival, { cx: wrong[i], cy: y });
      setShape(gap, { d: `M${Math.min(x, ...wrong)} ${y}H${Math.max(x, ...wrong)}` });
      const half = processDepth(0.5, near, far);
      const finding = `Raw value over depth: half of the scale ends at ${formatMeters(half)}`;
      setShape(plot.svg, {
        "aria-label": `${finding}. Depth of the point`,
        "aria-valuemin": near,
        "aria-valuemax": far,
        "aria-valuenow": values.depth,
        "aria-valuetext": formatMeters(values.depth),
      });
    },
  };
}

/**
 * Let the point be dragged, or moved with keys, along the depth.
 * @param {SVGElement} svg
 * @param {Area} area
 * @param {{ get: () => Clip, set: (depth: number) => void }} state
 */
function makeDraggable(svg, area, state) {
  setShape(svg, { role: "slider", tabindex: 0, class: "explorer-draggable" });
  /** @param {PointerEvent} event */
  const fromPointer = (event) => {
    const box = svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * PLOT_WIDTH;
    const { near, far } = state.get();
    state.set(Math.min(far, Math.max(near, (far * (x - area.left)) / (area.right - area.left))));
  };
  svg.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    svg.setPointerCapture(event.pointerId);
    fromPointer(event);
  });
  svg.addEventListener("pointermove", (event) => {
    if (svg.hasPointerCapture(event.pointerId)) fromPointer(event);
  });
  svg.addEventListener("keydown", (event) => {
    const { depth, near, far } = state.get();
    const fine = event.shiftKey ? 10 * FINE_STEP : FINE_STEP;
    /** @type {Record<string, number>} */
    const ways = { ArrowRight: fine, ArrowUp: fine, ArrowLeft: -fine, ArrowDown: -fine };
    Object.assign(ways, { PageUp: 1, PageDown: -1, Home: -far, End: far });
    if (!(event.key in ways)) return;
    state.set(Math.min(far, Math.max(near, depth + ways[event.key])));
    event.preventDefault();
    event.stopPropagation(); // in JupyterLab the arrows would move to another cell
  });
}

/** @param {Element} parent */
function makeTable(parent) {
  const table = make("table", "explorer-steps", parent);
  make("caption", "", table).textContent = "One step of the buffer, at this depth";
  const cells = BUFFERS.map(([, text]) => {
    const row = make("tr", "", table);
    const head = make("th", "", row);
    head.scope = "row";
    head.textContent = text;
    return make("td", "", row);
  });
  return {
    show(/** @type {RawValues} */ values) {
      for (const [i, [name]] of BUFFERS.entries()) cells[i].textContent = formatMm(values[name]);
    },
  };
}

function formatMm(/** @type {number} */ mm) {
  if (mm < 1e-4) return "below 0.0001 mm";
  return mm < 1000 ? `${Number(mm.toPrecision(3))} mm` : formatMeters(mm / 1000);
}

/**
 * Three digits or more behind what matters, and never an exponent.
 * @param {number} meters
 */
function formatMeters(meters) {
  const size = Math.abs(meters);
  return `${meters.toFixed(size < 1 ? 4 : size < 10 ? 3 : 2)} m`;
}

/**
 * @param {RawValues} values
 * @param {number} raw
 * @param {number} near
 * @param {number} far
 */
function inWords({ depth, linear_error, reversed_error }, raw, near, far) {
  /** @param {number} error */
  const wrong = (error) => {
    const way = error > 0 ? "too far" : "too near";
    const off = Math.abs(error) < 5e-5 ? "no error" : `${formatMeters(Math.abs(error))} ${way}`;
    return `${formatMeters(depth + error)}, ${off}`;
  };
  return (
    `Raw ${raw.toFixed(5)} between ${Number(near.toPrecision(3))} and ${Number(far.toPrecision(4))} m ` +
    `is ${formatMeters(depth)}. Taken for linear: ${wrong(linear_error)}. ` +
    `Taken for reversed: ${wrong(reversed_error)}. ` +
    `Half of the scale ends at ${formatMeters(processDepth(0.5, near, far))}.`
  );
}
