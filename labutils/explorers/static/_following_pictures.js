// The robot's eye with its middle and the true ball marked, and the robot from outside.

import { getContext, make, makeCanvas } from "./_frame.js";
import { addShape, setShape } from "./_shapes.js";

const ARM = 7; // of the cross in the middle, in pixels of the picture
const RING = 9;
const TOLD = 3.5;

/**
 * Make the place of one picture.
 * @param {Element} parent
 * @param {Pair} size
 * @param {string} label
 */
export function makePicture(parent, [width, height], label) {
  const holder = make("div", "explorer-following-picture", parent);
  const canvas = makeCanvas(holder, width, height, label);
  const context = getContext(canvas);
  /** @type {FollowingBytes | null} */
  let shown = null;
  return {
    holder,
    canvas,
    /**
     * Draw a compressed picture; of two that come at once the later one stays.
     * @param {FollowingBytes | null} bytes
     */
    async show(bytes) {
      if (bytes === shown || !bytes) return;
      shown = bytes;
      const image = await createImageBitmap(new Blob([bytes]));
      if (shown === bytes) context.drawImage(image, 0, 0);
      image.close();
    },
  };
}

/**
 * Make the marks over the eye's picture: sharp, however large a pixel of it is.
 * @param {Element} holder
 * @param {Pair} size
 */
export function makeMarks(holder, [width, height]) {
  // the middle of pixel (0, 0) is at the origin
  const viewBox = `-0.5 -0.5 ${width} ${height}`;
  const svg = addShape(holder, "svg", { viewBox, class: "explorer-marks", "aria-hidden": "true" });
  const [u, v] = [(width - 1) / 2, (height - 1) / 2];
  const cross = `M${u - ARM} ${v}H${u - 2}M${u + 2} ${v}H${u + ARM}M${u} ${v - ARM}V${v - 2}M${u} ${v + 2}V${v + ARM}`;
  addDouble(svg, "path", { d: cross }, "");
  const ring = addDouble(svg, "circle", { r: RING }, "explorer-truth");
  const told = addDouble(svg, "path", {}, "explorer-marks-told");
  return {
    /** @param {FollowingMoment | null} moment */
    show(moment) {
      const isSeen = moment !== null && moment.u !== null && moment.v !== null;
      if (isSeen) ring.set({ cx: Number(moment.u), cy: Number(moment.v) });
      ring.toggle(isSeen);
      ring.group.classList.toggle("hidden-there", Boolean(moment?.is_hidden));
      const isTold = moment !== null && moment.told_u !== null && moment.told_v !== null;
      if (isTold) told.set({ d: drawTimes(Number(moment.told_u), Number(moment.told_v)) });
      told.toggle(isTold);
    },
  };
}

/**
 * A slanted cross.
 * @param {number} u
 * @param {number} v
 */
function drawTimes(u, v) {
  const [left, right, top, bottom] = [u - TOLD, u + TOLD, v - TOLD, v + TOLD];
  return `M${left} ${top}L${right} ${bottom}M${left} ${bottom}L${right} ${top}`;
}

/**
 * A shape in its color on a dark one: it stands out from anything.
 * @param {Element} svg
 * @param {string} tag
 * @param {Attributes} attributes
 * @param {string} name
 */
function addDouble(svg, tag, attributes, name) {
  const group = addShape(svg, "g", { class: name });
  const both = ["below", "above"].map((one) =>
    addShape(group, tag, { class: `explorer-marks-${one}`, ...attributes }),
  );
  return {
    group,
    /** @param {Attributes} values */
    set(values) {
      for (const one of both) setShape(one, values);
    },
    /** @param {boolean} isShown */
    toggle(isShown) {
      group.style.display = isShown ? "" : "none";
    },
  };
}
