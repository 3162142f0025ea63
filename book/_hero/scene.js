// From the data of the first screen to a cloud, and from a point to what there is to say of it.

import { pixelToPoint } from "../../labutils/explorers/static/_camera.js";
import { readDepth } from "../../labutils/explorers/static/_cloud_points.js";
import { joinTransforms, makeNamedView } from "../../labutils/explorers/static/_orbit.js";
import { decodePng } from "../../labutils/explorers/static/_png.js";
import { FROM_WORLD } from "../../labutils/explorers/static/_shared.js";

export const FAR = 4; // meters: beyond all that is in sight
const EDGE = 0.005; // meters: off by more than this is only what lies on an outline

/**
 * @param {HeroData} data
 * @returns {Promise<HeroScene>}
 */
export async function readScene(data) {
  const [colors, depth, errors, things] = await Promise.all([
    readColors(data.rgb_webp),
    ...[data.depth_png, data.error_png, data.thing_png].map((text) => decodePng(toBytes(text))),
  ]);
  const { width, height, data: steps } = depth;
  const worldFromCamera = data.T_world_cam.slice(0, 3).flat();
  const orbitFromCamera = joinTransforms(FROM_WORLD, worldFromCamera);
  const cloud = {
    width,
    height,
    steps,
    depthStep: data.depth_step,
    minDepth: 0.05,
    rgba32: colors,
    palette: new Uint8Array(),
    palette32: new Uint32Array(),
    trueK: data.K,
    trueFov: (2 * Math.atan(height / 2 / data.K[1][1]) * 180) / Math.PI,
    worldFromCamera,
    orbitFromBase: FROM_WORLD,
    orbitFromCamera,
    faces: [],
    depthLimits: /** @type {Pair} */ ([0.5, 2]),
    heightLimits: /** @type {Pair} */ ([0, 1]),
  };
  // one walks around what the camera has in its middle
  const middle = readDepth(cloud, width >> 1, height >> 1);
  const target = [0, 1, 2].map(
    (i) => orbitFromCamera[4 * i + 3] + middle * orbitFromCamera[4 * i + 2],
  );
  const any = { azimuth_deg: 0, elevation_deg: 0, distance: middle, target };
  return {
    cloud,
    start: makeNamedView("camera", any, orbitFromCamera),
    names: data.names,
    things: things.data,
    errors: errors.data,
    toMeters: (error) => (error - data.error_zero) * data.error_step,
  };
}

/**
 * The distance of a point from the camera, as its depth says and as it is.
 * @param {HeroScene} scene
 * @param {number} id
 * @returns {HeroReading}
 */
export function readPoint({ cloud, names, things, errors, toMeters }, id) {
  const measured = Math.hypot(...findPoint(cloud, id));
  return { name: names[things[id]], measured, truth: measured - toMeters(errors[id]) };
}

/**
 * The point of a pixel in the camera frame.
 * @param {Cloud} cloud
 * @param {number} id
 */
export function findPoint(cloud, id) {
  const [u, v] = [id % cloud.width, Math.floor(id / cloud.width)];
  return pixelToPoint(u, v, readDepth(cloud, u, v), cloud.trueK);
}

/**
 * A pixel in the middle of a thing: the one closest to the mean of its pixels.
 * @param {HeroScene} scene
 * @param {string} name
 */
export function findMiddle({ cloud: { width }, names, things }, name) {
  const own = names.indexOf(name);
  const ids = [...things.keys()].filter((id) => things[id] === own);
  const mean = (/** @type {(id: number) => number} */ get) =>
    ids.reduce((sum, id) => sum + get(id), 0) / ids.length;
  const [u, v] = [mean((id) => id % width), mean((id) => Math.floor(id / width))];
  return Math.round(v) * width + Math.round(u);
}

/** @param {HeroReading} reading */
export function inWords({ name, measured, truth }) {
  const error = Math.abs(measured - truth);
  const digits = error < EDGE ? 1 : 0;
  const text =
    `${name[0].toUpperCase()}${name.slice(1)}: ${measured.toFixed(3)} m from the camera. ` +
    `Truth: ${truth.toFixed(3)} m. Error: ${(1000 * error).toFixed(digits)} mm.`;
  return error < EDGE ? text : `${text} This pixel lies on an edge.`;
}

/** @param {string} text */
function toBytes(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

/**
 * Colors of all pixels; from a text of the page's own a canvas may read them also as a file.
 * @param {string} webp
 */
async function readColors(webp) {
  const image = new Image();
  image.src = `data:image/webp;base64,${webp}`;
  await image.decode();
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("the browser has no canvas left");
  context.drawImage(image, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
}
