// Point cloud: every pixel with a depth becomes a point, in the browser. The reader walks around
// it, picks points in the cloud or in the picture, and bends it with a wrong field of view.

import { makeCanvasPainter } from "./_cloud_canvas.js";
import { makeGlPainter } from "./_cloud_gl.js";
import { makeMarks } from "./_cloud_marks.js";
import {
  assumeIntrinsics,
  colorPoints,
  findPoint,
  makeCounter,
  measureAngle,
} from "./_cloud_points.js";
import { readCloud } from "./_cloud_read.js";
import {
  defineView,
  drawOnChange,
  getContext,
  make,
  makeCanvas,
  setTraits,
  toError,
} from "./_frame.js";
import { focalOfView, joinTransforms, makeEyeTransform } from "./_orbit.js";
import { makeOrbitButtons, makeOrbitControls } from "./_orbit_controls.js";
import { makePicker } from "./_picker.js";
import { decodePng, toImageData } from "./_png.js";
import { makeSplatBuffer, pickDrawn, splatPoints } from "./_splat.js";

const SCALE_NAMES = ["", "depth", "height"];

export default defineView("cloud", start);

/**
 * @param {CloudModel} model
 * @param {Frame} frame
 */
async function start(model, frame) {
  const [image, depth] = await Promise.all([
    decodePng(model.get("rgb_png")).then(toImageData),
    decodePng(model.get("depth_png")),
  ]);
  const cloud = readCloud(model, image, depth);
  const surface = make("div", "explorer-cloud-view", frame.stage);
  surface.setAttribute(
    "aria-label",
    "Point cloud. Arrow keys walk around, plus and minus zoom, Home returns. Pick points in the picture",
  );
  const stand = makePainter(surface, cloud, frame);
  const drawMarks = makeMarks(surface, cloud);
  const showScale = makeColorScale(surface, cloud);
  const side = make("div", "explorer-cloud-side", frame.side);
  const canvas = makeCanvas(side, cloud.width, cloud.height, "The camera's picture");
  getContext(canvas).putImageData(image, 0, 0);
  makePicker({ model, frame, canvas, label: "The camera's picture" });
  makeOrbitButtons(side, model, cloud.orbitFromCamera);

  frame.reserve(makeLongest(cloud, hasGoal(model)));

  const countPoints = makeCounter(cloud);
  const colors = new Uint32Array(cloud.steps.length);
  let [colored, version] = ["", 0];
  const later = drawOnChange(model, frame, () => {
    const [fov, far, mode] = [model.get("fov_y_deg"), model.get("far"), model.get("color")];
    const { K, stretch } = assumeIntrinsics(cloud.trueK, cloud.trueFov, fov);
    const found = findPoint(cloud, model.get("pixel"), K, far);
    const needed = `${mode} ${mode === 2 ? fov : ""}`; // only heights depend on the field of view
    if (needed !== colored) {
      colorPoints(cloud, K, mode, colors);
      [colored, version] = [needed, version + 1];
      showScale(mode);
    }
    const { painter } = stand;
    const look = painter && makeLook(surface, model, cloud, K, far, painter.resolution);
    if (look) {
      painter.draw(look, colors, version);
      drawMarks(look, found.point_camera);
    }
    const angle_deg = measureAngle(cloud, K);
    const values = { points: countPoints(far), f: K[1][1], stretch, angle_deg, ...found };
    frame.tell(inWords(values, model, cloud), values);
  });
  stand.onChange = later;

  makeOrbitControls({
    model,
    frame,
    surface,
    pick(x, y, slack) {
      const { K } = assumeIntrinsics(cloud.trueK, cloud.trueFov, model.get("fov_y_deg"));
      const look = makeLook(surface, model, cloud, K, model.get("far"), 1);
      if (!look) return;
      const buffer = makeSplatBuffer(look.width, look.height);
      splatPoints(cloud, look, buffer);
      const id = pickDrawn(buffer, x, y, slack);
      setTraits(model, { pixel: id < 0 ? [] : [id % cloud.width, Math.floor(id / cloud.width)] });
    },
  });
  const observer = new ResizeObserver(later);
  observer.observe(surface);
  frame.cleanups.push(() => observer.disconnect());
}

/**
 * How the cloud is seen now, in pixels of the page and of the canvas; null where it has no size.
 * @param {HTMLElement} surface
 * @param {CloudModel} model
 * @param {Cloud} cloud
 * @param {Matrix} K
 * @param {number} far
 * @param {number} resolution
 * @returns {PageLook | null}
 */
function makeLook(surface, model, cloud, K, far, resolution) {
  const [pageWidth, pageHeight] = [surface.clientWidth, surface.clientHeight];
  if (!pageWidth || !pageHeight) return null;
  const eyeFromOrbit = makeEyeTransform(model.get("orbit"));
  const height = Math.round(pageHeight * resolution);
  return {
    pageWidth,
    pageHeight,
    width: Math.round(pageWidth * resolution),
    height,
    pageFocal: focalOfView(model.get("view_fov_deg"), pageHeight),
    focal: focalOfView(model.get("view_fov_deg"), height),
    eyeFromOrbit,
    eyeFromCamera: joinTransforms(eyeFromOrbit, cloud.orbitFromCamera),
    K,
    far,
  };
}

/**
 * Choose what draws: WebGL, and without it, or once the browser takes it away, a plain canvas.
 * @param {HTMLElement} surface
 * @param {Cloud} cloud
 * @param {Frame} frame
 */
function makePainter(surface, cloud, frame) {
  /** @type {{ painter: CloudPainter | null, onChange: () => void, forget: () => void }} */
  const stand = { painter: null, onChange() {}, forget() {} };
  /** @param {(canvas: HTMLCanvasElement, cloud: Cloud) => CloudPainter | null} make3d */
  const use = (make3d) => {
    const canvas = document.createElement("canvas");
    const painter = make3d(canvas, cloud);
    if (!painter) return false;
    stand.painter?.destroy();
    surface.querySelector("canvas")?.remove();
    canvas.className = "explorer-cloud-points";
    canvas.setAttribute("aria-hidden", "true"); // the surface around it speaks
    surface.prepend(canvas);
    stand.painter = painter;
    frame.root.dataset.painter = painter.kind;
    const onLost = () => use(makeCanvasPainter) && stand.onChange();
    canvas.addEventListener("webglcontextlost", onLost, { once: true });
    stand.forget = () => canvas.removeEventListener("webglcontextlost", onLost);
    return true;
  };
  try {
    use(makeGlPainter);
  } catch (error) {
    console.warn(toError(error).message); // a driver that cannot run the program: the canvas can
  }
  if (!stand.painter) use(makeCanvasPainter);
  frame.cleanups.push(() => {
    stand.forget();
    stand.painter?.destroy();
  });
  return stand;
}

/**
 * The scale of the colors; it keeps its place where there is none.
 * @param {Element} parent
 * @param {Cloud} cloud
 */
function makeColorScale(parent, cloud) {
  const scale = make("p", "explorer-cloud-scale", parent);
  const low = make("span", "", scale);
  const bar = make("span", "explorer-cloud-bar", scale);
  const high = make("span", "", scale);
  const stops = Array.from(
    { length: 18 },
    (_, i) => `rgb(${cloud.palette.slice(60 * i, 60 * i + 3)})`,
  );
  bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
  return (/** @type {number} */ mode) => {
    scale.style.visibility = mode ? "visible" : "hidden";
    const limits = mode === 2 ? cloud.heightLimits : cloud.depthLimits;
    low.textContent = `${SCALE_NAMES[mode]} ${limits[0].toFixed(2)} m`;
    high.textContent = `${limits[1].toFixed(2)} m`;
  };
}

/**
 * @param {CloudValues} values
 * @param {CloudModel} model
 * @param {Cloud} cloud
 */
function inWords({ points, f, stretch, angle_deg, point_camera, point_world }, model, cloud) {
  const right = Math.abs(stretch - 1) < 5e-4;
  let text = `${points.toLocaleString("en-US")} points. f = ${f.toFixed(1)} px`;
  text += right ? ", the camera's own" : `: all ${stretch.toFixed(2)} times as wide as it is`;
  if (angle_deg !== null && !hasGoal(model)) {
    const names = cloud.faces.map(([name]) => name).join(" and ");
    text += `; ${names} meet at ${angle_deg.toFixed(1)}°`;
  }
  const pixel = model.get("pixel");
  if (!pixel.length) return `${text}.\nNo point picked.`;
  text += `.\nPixel (${pixel.join(", ")})`;
  if (!point_camera) return `${text}: no surface closer than ${model.get("far").toFixed(2)} m.`;
  text += ` is at ${inMeters(point_camera)} from the camera`;
  return point_world ? `${text}, at ${inMeters(point_world)} in the world.` : `${text}.`;
}

/** Whether the line of the goal tells the angle. */
function hasGoal(/** @type {CloudModel} */ model) {
  return "parts" in (model.get("goal") ?? {});
}

/**
 * As long a text as may come, in as many lines.
 * @param {Cloud} cloud
 * @param {boolean} isAngleTold elsewhere
 */
function makeLongest({ faces, worldFromCamera }, isAngleTold) {
  const angle =
    faces.length && !isAngleTold ? `; ${faces[0][0]} and ${faces[1][0]} meet at 101.3°` : "";
  const point = "(-0.250, -0.091, 0.831) m";
  const world = worldFromCamera ? `, at ${point} in the world` : "";
  return (
    `297,179 points. f = 461.0 px: all 1.26 times as wide as it is${angle}.\n` +
    `Pixel (600, 400) is at ${point} from the camera${world}.`
  );
}

/**
 * Three coordinates to the millimeter; never minus zero.
 * @param {Triple} point
 */
function inMeters(point) {
  return `(${point.map((value) => (Math.round(value * 1000) / 1000 || 0).toFixed(3)).join(", ")}) m`;
}
