// Lines and letters over the cloud: axes, the camera's rays, the measured faces, the picked point.
// An SVG, so that the page's style sheet colors it and letters stay sharp.

import { pixelToPoint } from "./_camera.js";
import { findCorners } from "./_cloud_points.js";
import { joinTransforms, movePoint, projectLine } from "./_orbit.js";

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";
const AXIS_LENGTH = 0.2; // meters
const AXES = ["X", "Y", "Z"];

/** Make the drawing over the cloud; returns the function that draws it for a look. */
export function makeMarks(parent, cloud) {
  const svg = addShape(parent, "svg", "explorer-cloud-marks");
  svg.setAttribute("aria-hidden", "true");
  const frustum = addShape(svg, "path", "explorer-frustum");
  const faces = cloud.faces.map(() => addShape(svg, "path", "explorer-face"));
  const ray = addShape(svg, "path", "explorer-ray");
  const axes = AXES.map((name) => {
    const kind = `explorer-axis-${name.toLowerCase()}`;
    const letter = addShape(svg, "text", kind);
    letter.textContent = name;
    return { line: addShape(svg, "path", kind), letter };
  });
  const picked = addShape(svg, "circle", "explorer-picked");
  picked.setAttribute("r", "6");
  const outline = addShape(svg, "circle", "explorer-picked-inside");
  outline.setAttribute("r", "6");
  const reach = 0.15 * cloud.depthLimits[1]; // how far the camera's own rays are drawn

  return function drawMarks(look, point) {
    const { pageWidth: width, pageHeight: height, pageFocal: focal, eyeFromCamera, K } = look;
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const trace = (lines) =>
      lines
        .map(([from, to]) => {
          const ends = projectLine(from, to, focal, width, height);
          return ends.length ? `M${ends[0].map(round)}L${ends[1].map(round)}` : "";
        })
        .join("");
    const inEye = (points) => points.map((one) => movePoint(eyeFromCamera, one));
    const around = (corners) => corners.map((one, i) => [one, corners[(i + 1) % corners.length]]);

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
    frustum.setAttribute("d", trace([...around(corners), ...corners.map((one) => [apex, one])]));
    cloud.faces.forEach(([, three], i) => {
      faces[i].setAttribute("d", trace(around(inEye(findCorners(cloud, three, K)))));
    });

    const eyeFromBase = joinTransforms(look.eyeFromOrbit, cloud.orbitFromBase);
    const origin = movePoint(eyeFromBase, [0, 0, 0]);
    axes.forEach(({ line, letter }, i) => {
      const tip = [0, 1, 2].map((j) => (i === j ? AXIS_LENGTH : 0));
      line.setAttribute("d", trace([[origin, movePoint(eyeFromBase, tip)]]));
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
    ray.setAttribute("d", place ? trace([[apex, place]]) : "");
    for (const circle of [picked, outline]) placeAt(circle, place, ["cx", "cy"]);

    function placeAt(element, where, names) {
      const shown = where && where[2] > 0.02;
      element.toggleAttribute("hidden", !shown);
      if (!shown) return;
      element.setAttribute(names[0], round((focal * where[0]) / where[2] + width / 2));
      element.setAttribute(names[1], round((focal * where[1]) / where[2] + height / 2));
    }
  };
}

function round(value) {
  return Math.round(10 * value) / 10;
}

function addShape(parent, tag, className) {
  const element = document.createElementNS(SVG_NAMESPACE, tag);
  element.setAttribute("class", className);
  parent.append(element);
  return element;
}
