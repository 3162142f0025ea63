// Two eyes from above: a ray from each, as wide as the match is uncertain, and the diamond both
// allow. Its tips are the nearest and the farthest depth; a lens shows it larger.

import { addWindow, makePlot, toPath } from "./_plot.js";
import { addShape, setShape } from "./_shapes.js";
import { meetRays } from "./_stereo.js";

const TOPS = [0.5, 1, 1.5, 2, 3, 5, 8, 12, 16]; // meters: the view ends at one of them
const LAST = TOPS[TOPS.length - 1];
const LENS = { width: 84, height: 92, tall: 54 }; // the diamond is `tall` in it

/**
 * Make the drawing; `show` takes what `describePair` returns.
 * @param {Element} parent
 */
export function makeRays(parent) {
  const x = { label: "to the right (m)" };
  const plot = makePlot(parent, { height: 210, x, y: { label: "from above: depth (m)" } });
  const { area, above } = plot;
  const rays = makeShapes(plot.inside);
  const eyes = [0, 1].map(() => addShape(above, "circle", { r: 4, class: "explorer-eye" }));
  const note = addShape(above, "text", { class: "halo", "text-anchor": "middle" });
  setShape(note, { x: (area.left + area.right) / 2, y: area.top + 14 });
  const lens = makeLens(above, area);
  return {
    /**
     * @param {StereoValues} values
     * @param {number} u column of the point in the left picture
     * @param {Matrix} K
     * @param {number} baseline
     * @param {number} error
     */
    show(values, u, K, baseline, error) {
      const { depth, u_right, z_near, z_far } = values;
      const end = TOPS.find((one) => one >= 1.4 * (depth ?? 1)) ?? LAST;
      // a meter is as long sideways as it is upward
      const half = (end * (area.right - area.left)) / (area.bottom - area.top) / 2;
      plot.setLimits([-half, half], [0, end]);
      /** @type {Placing} */
      const place = ([right, z]) => [plot.x(right), plot.y(z)];
      for (const [i, eye] of eyes.entries()) {
        setShape(eye, { cx: plot.x(i * baseline), cy: plot.y(0) });
      }
      const shapes =
        u_right === null ? null : findShapes([u, u_right], K, baseline, error, 2 * end);
      rays.show(shapes, place);
      const bounded = depth !== null && z_far !== null;
      lens.show(bounded ? shapes : null, values, place);
      note.textContent =
        depth === null ? "no surface" : bounded ? "" : formatInterval(z_near, z_far);
      const finding = `a match ${error.toFixed(1)} px off leaves depths of ${formatInterval(z_near, z_far)}`;
      const label = depth === null ? "no surface, so no rays" : finding;
      setShape(plot.svg, { "aria-label": `From above: ${label}` });
    },
  };
}

/**
 * @param {number | null} zNear
 * @param {number | null} zFar
 */
export function formatInterval(zNear, zFar) {
  if (zNear === null) return "none";
  return zFar === null
    ? `${zNear.toFixed(3)} m or more`
    : `${zNear.toFixed(3)} to ${zFar.toFixed(3)} m`;
}

/**
 * Corners in meters, [right, depth]: the wedge of each eye, and the diamond where they overlap.
 * @param {Pair} columns
 * @param {Matrix} K
 * @param {number} baseline
 * @param {number} error
 * @param {number} reach
 * @returns {Shapes}
 */
export function findShapes([uLeft, uRight], K, baseline, error, reach) {
  /**
   * @param {number} eye
   * @param {number} column
   * @returns {Pair}
   */
  const atReach = (eye, column) => [eye * baseline + ((column - K[0][2]) / K[0][0]) * reach, reach];
  const off = error / 2; // each picture may be off by half of it
  /** @type {(column: number, eye: number) => Pair[]} */
  const wedgeOf = (column, eye) => [
    [eye * baseline, 0],
    atReach(eye, column - off),
    atReach(eye, column + off),
  ];
  const wedges = [uLeft, uRight].map(wedgeOf);
  /**
   * @param {number} left
   * @param {number} right
   */
  const meet = (left, right) => meetRays(uLeft + left, uRight + right, K, baseline);
  const tip = meet(-off, off);
  const open = [atReach(1, uRight + off), atReach(0, uLeft - off)]; // the rays never meet
  const diamond = [meet(off, -off), meet(off, off), ...(tip ? [tip] : open), meet(-off, -off)];
  return { wedges, diamond: diamond.filter((corner) => corner !== null) };
}

/** @param {Element} parent */
function makeShapes(parent) {
  const wedges = [0, 1].map(() => addShape(parent, "path", { class: "explorer-ray" }));
  const diamond = addShape(parent, "path", { class: "explorer-diamond" });
  return {
    /** @type {(shapes: Shapes | null, place: Placing) => void} */
    show(shapes, place) {
      const draw = (/** @type {Pair[]} */ corners) => `${toPath(corners.map(place))}Z`;
      for (const [eye, wedge] of wedges.entries()) {
        setShape(wedge, { d: shapes ? draw(shapes.wedges[eye]) : "" });
      }
      setShape(diamond, { d: shapes ? draw(shapes.diamond) : "" });
    },
  };
}

/**
 * The diamond so large that its length can be seen, beside the drawing and on its free side.
 * @param {Element} parent
 * @param {Area} area
 */
function makeLens(parent, area) {
  const top = area.top + 20;
  const group = addShape(parent, "g");
  const leader = addShape(group, "path", { class: "explorer-gap" });
  const box = { width: LENS.width, height: LENS.height, y: top };
  const ground = addShape(group, "rect", { class: "explorer-lens", ...box });
  const window = addWindow(group, { left: 0, top: 0, right: LENS.width, bottom: LENS.height });
  setShape(window, { y: top });
  const shapes = makeShapes(window);
  const [farText, nearText, scaleText] = [0, 1, 2].map(() =>
    addShape(group, "text", { class: "halo" }),
  );
  setShape(farText, { y: top + 16 });
  setShape(nearText, { y: top + LENS.height - 7 });
  setShape(scaleText, { y: top + LENS.height + 18 });
  return {
    /** @type {(found: Shapes | null, values: StereoValues, place: Placing) => void} */
    show(found, { z_near, z_far }, place) {
      group.style.display = found ? "" : "none";
      if (!found || z_near === null || z_far === null) return;
      const [near, , tip] = found.diamond;
      const here = place([(near[0] + tip[0]) / 2, (near[1] + tip[1]) / 2]);
      const onLeft = here[0] > (area.left + area.right) / 2;
      const left = onLeft ? area.left + 6 : area.right - LENS.width - 2;
      for (const one of [ground, window]) setShape(one, { x: left });
      const scale = LENS.tall / (z_far - z_near); // the same in both directions
      const [midX, midZ] = [(near[0] + tip[0]) / 2, (near[1] + tip[1]) / 2];
      /** @type {Placing} */
      const enlarge = ([x, z]) => [
        LENS.width / 2 + (x - midX) * scale,
        LENS.height / 2 - (z - midZ) * scale,
      ];
      shapes.show(found, enlarge);
      setShape(leader, {
        d: `M${here}L${onLeft ? left + LENS.width : left} ${top + LENS.height / 2}`,
      });
      // each end is written on the side that the rays leave free
      const sides = { low: [left + 4, "start"], high: [left + LENS.width - 4, "end"] };
      const leansLeft = tip[0] < near[0];
      const write = (
        /** @type {SVGElement} */ text,
        /** @type {(string | number)[]} */ [at, anchor],
      ) => setShape(text, { x: at, "text-anchor": anchor });
      write(farText, leansLeft ? sides.high : sides.low);
      write(nearText, leansLeft ? sides.low : sides.high);
      write(scaleText, [left + LENS.width / 2, "middle"]);
      farText.textContent = `${z_far.toFixed(3)} m`;
      nearText.textContent = `${z_near.toFixed(3)} m`;
      const times = scale / (place([0, 0])[1] - place([0, 1])[1]);
      scaleText.textContent = `× ${times.toFixed(times < 10 ? 1 : 0)}`;
    },
  };
}
