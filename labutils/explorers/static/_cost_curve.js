// The cost of every disparity, its minimum, and the parabola through it; beside them the truth. The
// reader can choose a disparity on it.

import { watchBins } from "./_bins.js";
import { makePlot, toPath } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";

const STEPS = [1, 1.5, 2, 3, 4, 5, 6, 8, 10];
const LEAST = 20; // squared gray levels: the ripples of a plain wall stay small
const ROOM = 0.37; // of the plot, for the name of a valley: it stands away from the lowest one
const REACH = 1.6; // disparities to either side that the parabola is drawn

/**
 * Make the curve for up to `longest` disparities; `choose` hears the one the reader points at.
 * @param {Element} parent
 * @param {number} longest
 * @param {(disparity: number | null) => void} choose
 */
export function makeCostCurve(parent, longest, choose) {
  const plot = makePlot(parent, {
    height: 182,
    left: 50,
    x: { label: "disparity (px)" },
    y: { label: "SSD per pixel of the window" },
  });
  const { area, inside, above } = plot;
  const tall = { y: area.top, height: area.bottom - area.top };
  const beyond = addShape(inside, "rect", { class: "explorer-band", ...tall });
  const truth = addShape(inside, "path", { class: "explorer-true-line" });
  const curve = addShape(inside, "path", { class: "explorer-curve" });
  const parabola = addShape(inside, "path", { class: "explorer-parabola" });
  const hovered = addShape(inside, "rect", { class: "explorer-hovered", ...tall, width: 0 });
  const second = addShape(above, "circle", { r: 5, class: "explorer-second" });
  const point = addShape(above, "circle", { r: 6, class: "explorer-found-point" });
  const trueNote = makeNote(above, area.top + 10);
  const secondNote = makeNote(above, 0);
  const note = makeNote(above, area.top + 10);
  /** @type {number[]} */
  let costs = [];
  let [pixels, search] = [1, longest];
  let isPointed = false;

  const options = { bins: longest, first: 0, name: "curve", describe };
  watchBins(plot, options, (bin) => {
    isPointed = bin !== null;
    if (bin !== null) setShape(hovered, { x: plot.x(bin - 0.5), width: plot.x(1) - plot.x(0) });
    else setShape(hovered, { width: 0 });
    for (const one of [trueNote, secondNote]) one.style.display = isPointed ? "none" : "";
    if (bin !== null) place(note, bin, describe(bin));
    else note.textContent = "";
    choose(bin);
  });
  return {
    /** @type {(values: MatchValues, window: number, search: number) => void} */
    show(values, window, asked) {
      [costs, pixels, search] = [values.costs, window * window, asked];
      plot.setLimits([-0.5, longest - 0.5], [0, findLimit(costs, pixels)]);
      const from = plot.x(search - 0.5);
      setShape(beyond, { x: from, width: Math.max(0, area.right - from) });
      setShape(curve, { d: toPath(costs.map((cost, d) => toPlace(d, cost))) });
      const { disparity: best, truth: true_px } = values;
      setShape(parabola, { d: best === null ? "" : toPath(sampleParabola(costs, best).map(bend)) });
      show(point, best);
      // a valley may lie above the plot
      const high = values.second === null ? 0 : toPlace(values.second, costs[values.second])[1];
      const rival = high < area.top ? null : values.second;
      show(second, rival);
      secondNote.textContent = "";
      if (rival !== null) {
        const share = rival < (best ?? 0) ? ROOM : 1 - ROOM;
        place(secondNote, rival, nameSecond(values.ratio), share);
        setShape(secondNote, { y: Math.max(high - 8, area.top + 24) });
      }
      const at = true_px === null ? "" : plot.x(true_px).toFixed(2);
      setShape(truth, { d: at && `M${at} ${area.top}V${area.bottom}` });
      if (true_px !== null) place(trueNote, true_px, "truth");
      else trueNote.textContent = "";
      setShape(plot.svg, { "aria-label": `Cost over disparity: ${inWords(values)}` });
    },
  };

  /** @type {(disparity: number, cost: number) => Pair} */
  function toPlace(disparity, cost) {
    return [plot.x(disparity), plot.y(cost / pixels)];
  }

  /** @type {(one: Pair) => Pair} */
  function bend([disparity, cost]) {
    return toPlace(disparity, cost);
  }

  /**
   * @param {SVGElement} mark
   * @param {number | null} disparity
   */
  function show(mark, disparity) {
    mark.style.display = disparity === null ? "none" : "";
    if (disparity === null) return;
    const [cx, cy] = toPlace(disparity, costs[disparity]);
    setShape(mark, { cx, cy });
  }

  /**
   * Write beside a disparity: left of it beyond a share of the plot, else right of it.
   * @param {SVGElement} text
   * @param {number} disparity
   * @param {string} words
   * @param {number} share
   */
  function place(text, disparity, words, share = 0.5) {
    const onLeft = disparity > share * longest;
    const at = plot.x(disparity);
    setShape(text, { x: onLeft ? at - 6 : at + 6, "text-anchor": onLeft ? "end" : "start" });
    text.textContent = words;
  }

  /** @param {number} d */
  function describe(d) {
    if (d >= search) return `${d} px: not searched`;
    if (d >= costs.length) return `${d} px: beyond the picture`;
    return `${d} px: ${formatCost(costs[d] / pixels)} per pixel`;
  }
}

/**
 * Points of the parabola through the cost of a disparity and its neighbors'; none at an end.
 * @param {number[]} costs
 * @param {number} best
 */
export function sampleParabola(costs, best) {
  /** @type {Pair[]} */
  const points = [];
  if (best <= 0 || best >= costs.length - 1) return points;
  const [before, here, after] = costs.slice(best - 1, best + 2);
  const [slope, bend] = [(after - before) / 2, (before - 2 * here + after) / 2];
  for (let x = -REACH; x <= REACH + 1e-9; x += REACH / 8) {
    points.push([best + x, here + slope * x + bend * x * x]);
  }
  return points;
}

/**
 * How high the plot is: what is far too different may leave it, or all valleys would look flat.
 * @param {number[]} costs
 * @param {number} pixels
 */
export function findLimit(costs, pixels) {
  const sorted = costs.map((cost) => cost / pixels).sort((a, b) => a - b);
  const most = sorted.length
    ? Math.min(sorted[sorted.length - 1], 2 * sorted[sorted.length >> 1])
    : 0;
  return roundUp(Math.max(most, LEAST));
}

/**
 * The next round number: limits stay while costs change a little.
 * @param {number} value
 */
export function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (STEPS.find((one) => one * power >= value * (1 - 1e-9)) ?? 10);
}

/** @param {number} cost */
export function formatCost(cost) {
  return cost < 9.95 ? cost.toFixed(1) : Math.round(cost).toLocaleString("en-US");
}

/**
 * The name of the second-best valley, with its cost by that of the best.
 * @param {number | null} ratio of the best to it
 */
function nameSecond(ratio) {
  return ratio ? `next: ${formatCost(1 / ratio)} times` : "next";
}

/** @param {MatchValues} values */
function inWords({ disparity, cost, second, ratio, truth }) {
  if (disparity === null) return "no window fits";
  const rival = second === null ? "" : `, ${nameSecond(ratio)}, at ${second} px`;
  const real = truth === null ? "" : `, truth at ${truth.toFixed(1)} px`;
  return `smallest at ${disparity} px, ${formatCost(cost ?? 0)} per pixel${rival}${real}`;
}

/**
 * @param {Element} parent
 * @param {number} y
 */
function makeNote(parent, y) {
  return addShape(parent, "text", { class: "halo", y });
}
