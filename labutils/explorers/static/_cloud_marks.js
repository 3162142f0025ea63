// Lines and letters over the cloud: axes, the camera's rays, the measured faces, the picked point.
// An SVG, so that the page's style sheet colors it and letters stay sharp.

import { pixelToPoint } from "./_camera.js";
import { findCorners } from "./_cloud_points.js";
import { joinTransforms, movePoint, projectLine } from "./_orbit.js";
import { addShape, setShape } from "./_shapes.js";

const AXIS_LENGTH = 0.2; // meters
const AXES = ["X", "Y", "Z"];

/**
 * Make the drawing over the cloud; returns the function that draws it for a look.
 * @param {Element} parent
 * @param {Cloud} cloud
 */
export function makeMarks(parent, cloud) {
  const svg = addShape(parent, "svg", { class: "explorer-cloud-marks", "aria-hidden": "true" });
  const frustum = addShape(svg, "path", { class: "explorer-frustum" });
  const faces = cloud.faces.map(() => addShape(svg, "path", { class: "explorer-face" }));
  const ray = addShape(svg, "path", { class: "explorer-ray" });
  const axes = AXES.map((name) => {
    const kind = `explorer-axis-${name.toLowerCase()}`;
    const letter = addShape(svg, "text", { class: kind }, name);
    return { line: addShape(svg, "path", { class: kind }), letter };
  });
  const picked = addShape(svg, "circle", { class: "explorer-picked", r: 6 });
  const outline = addShape(svg, "circle", { class: "explorer-picked-inside", r: 6 });
  const reach = 0.15 * cloud.depthLimits[1]; // how far the camera's own rays are drawn

  /** @type {(look: PageLook, point: Triple | null) => void} */
  return function drawMarks(look, point) {
    const { pageWidth: width, pageHeight: height, pageFocal: focal, eyeFromCamera, K } = look;
    setShape(svg, { viewBox: `0 0 ${width} ${height}` });
    const trace = (/** @type {Triple[][]} */ lines) =>
      lines
        .map(([from, to]) => {
          const ends = projectLine(from, to, focal, width, height);
          return ends.length ? `M${ends[0].map(round)}L${ends[1].map(round)}` : "";
        })
        .join("");
    const inEye = (/** @type {Triple[]} */ points) =>
      points.map((one) => movePoint(eyeFromCamera, one));
    const around = (/** @type {Triple[]} */ corners) =>
      corners.map((one, i) => [one, corners[(i + 1) % corners.length]]);

    const [right, bottom] = [cloud.width - 0.5, cloud.height - 0.5]; // outer edges of the outer pixels
    const pixels = [
      [-0.5, -0.5],
      [right, -0.5],
      [right, bottom],
      [-0.5, bottom],
    ];
    const [apex, ...corners] = inEye([
      [0, 0, 0],
      ...pixels.map(([u, v]) => pixelToPoint(u, v, reach, K)),
    ]);
    setShape(frustum, { d: trace([...around(corners), ...corners.map((one) => [apex, one])]) });
    cloud.faces.forEach(([, three], i) => {
      setShape(faces[i], { d: trace(around(inEye(findCorners(cloud, three, K)))) });
    });

    const eyeFromBase = joinTransforms(look.eyeFromOrbit, cloud.orbitFromBase);
    const origin = movePoint(eyeFromBase, [0, 0, 0]);
    axes.forEach(({ line, letter }, i) => {
      const tip = [0, 1, 2].map((j) => (i === j ? AXIS_LENGTH : 0));
      setShape(line, { d: trace([[origin, movePoint(eyeFromBase, tip)]]) });
      placeAt(
        letter,
        movePoint(
          eyeFromBase,
          tip.map((value) => 1.25 * value),
        ),
        ["x", "y"],
      );
    });

    const place = point && movePoint(eyeFromCamera, point);
    setShape(ray, { d: place ? trace([[apex, place]]) : "" });
    for (const circle of [picked, outline]) placeAt(circle, place, ["cx", "cy"]);

    /**
     * @param {Element} element
     * @param {Triple | null} where
     * @param {Pair | string[]} names
     */
    function placeAt(element, where, names) {
      const shown = where && where[2] > 0.02;
      element.toggleAttribute("hidden", !shown);
      if (!shown) return;
      setShape(element, {
        [names[0]]: round((focal * where[0]) / where[2] + width / 2),
        [names[1]]: round((focal * where[1]) / where[2] + height / 2),
      });
    }
  };
}

function round(/** @type {number} */ value) {
  return Math.round(10 * value) / 10;
}
