import assert from "node:assert/strict";
import { test } from "node:test";
import * as points from "../../../labutils/explorers/static/_cloud_points.js";
import * as orbits from "../../../labutils/explorers/static/_orbit.js";
import { FROM_WORLD } from "../../../labutils/explorers/static/_shared.js";
import * as splat from "../../../labutils/explorers/static/_splat.js";
import { assertNear } from "./_near.mjs";

const K = [
  [4, 0, 1],
  [0, 4, 1],
  [0, 0, 1],
];
const START = { azimuth_deg: 20, elevation_deg: 10, distance: 2, target: [0, 0, 1] };
/**
 * Three pixels in a row: nothing, 1 m, 2 m; as much of a cloud as is asked for here.
 * @type {any}
 */
const CLOUD = {
  width: 3,
  height: 1,
  steps: Uint16Array.of(0, 5000, 10000),
  depthStep: 0.0002,
  minDepth: 0.01,
  worldFromCamera: null,
  faces: [],
};

test("an assumed field of view stretches to the sides and leaves depths alone", () => {
  const { K: wide, stretch } = points.assumeIntrinsics(K, 90, 90);
  assert.deepEqual(wide, K);
  assert.equal(stretch, 1);
  const { K: half, stretch: twice } = points.assumeIntrinsics(
    K,
    (Math.atan(0.5) * 360) / Math.PI,
    90,
  );
  assertNear([twice, half[0][0], half[1][1]], [2, 2, 2]);
});

test("points are counted below a depth that is itself left out", () => {
  const count = points.makeCounter(CLOUD);
  assert.deepEqual([0.5, 1, 1.5, 2, 2.1].map(count), [0, 0, 1, 1, 2]);
});

test("a picked pixel has a point where it sees a surface", () => {
  assert.equal(points.findPoint(CLOUD, [0, 0], K, 5).point_camera, null);
  assert.equal(points.findPoint(CLOUD, [], K, 5).point_camera, null);
  const { point_camera, point_world } = points.findPoint(CLOUD, [2, 0], K, 5);
  assertNear(point_camera, [0.5, -0.5, 2], 1e-6);
  assert.equal(point_world, null);
});

test("the eye looks at its target from its distance", () => {
  const eye = orbits.makeEyeTransform(START);
  assertNear(orbits.movePoint(eye, START.target), [0, 0, START.distance]);
});

test("joined transforms move as one after the other", () => {
  const eye = orbits.makeEyeTransform(START);
  const point = [0.3, -0.2, 0.7];
  const joined = orbits.joinTransforms(eye, FROM_WORLD);
  assertNear(
    orbits.movePoint(joined, point),
    orbits.movePoint(eye, orbits.movePoint(FROM_WORLD, point)),
  );
  assert.deepEqual(orbits.joinTransforms(eye, orbits.STAY), eye);
});

test("what is ahead in the world is ahead, what is above it is above", () => {
  assert.deepEqual(orbits.movePoint(FROM_WORLD, [1, 2, 3]), [-2, -3, 1]);
});

test("nobody walks over the pole, into the cloud or away from it", () => {
  assert.equal(orbits.turnOrbit(START, 0, 500).elevation_deg, 90);
  assert.equal(orbits.turnOrbit(START, 0, -500).elevation_deg, -90);
  assert.equal(orbits.zoomOrbit(START, 1e-6).distance, 0.1);
  assert.equal(orbits.zoomOrbit(START, 1e6).distance, 20);
});

test("the camera's view has its eye where the camera stands", () => {
  const view = orbits.makeNamedView("camera", START, orbits.STAY);
  assertNear(orbits.movePoint(orbits.makeEyeTransform(view), [0, 0, 0]), [0, 0, 0]);
});

test("a line that passes the eye is cut, one behind it is not drawn", () => {
  assert.deepEqual(orbits.projectLine([0, 0, -1], [1, 0, -1], 10, 20, 20), []);
  const [from, to] = orbits.projectLine([0, 0, 1], [0, 0, -1], 10, 20, 20);
  assertNear([...from, ...to], [10, 10, 10, 10]);
});

test("the nearest point is drawn, and found within the slack only", () => {
  const buffer = splat.makeSplatBuffer(40, 40);
  const look = { width: 40, height: 40, eyeFromCamera: orbits.STAY, focal: 20, K, far: 5 };
  splat.splatPoints(CLOUD, look, buffer);
  assert.deepEqual(new Set(buffer.ids), new Set([-1, 1, 2]));
  assert.equal(splat.pickDrawn(buffer, 20, 15, 0), 1);
  assert.equal(splat.pickDrawn(buffer, 39, 39, 3), -1);
});
