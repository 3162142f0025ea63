import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { limitAngles } from "../../../labutils/explorers/static/_look_controls.js";
import { makeSceneSource } from "../../../labutils/explorers/static/_scene_source.js";

/** @type {Pair[]} */
const LIMITS = [
  [-80, 80],
  [-40, 57],
];

/** A model as small as can be, whose Python answers when the test says so. */
function makeModel() {
  const pose = { pan_deg: 0, tilt_deg: 0, ball_x: 1, ball_y: 0 };
  const sent = [];
  /** @type {(content: object, buffers: DataView[]) => void} */
  let hear = () => {};
  return {
    pose,
    sent,
    get: (name) => pose[name],
    send: (content) => sent.push(content),
    on: (_, listener) => {
      hear = listener;
    },
    off: () => {
      hear = () => {};
    },
    answer(id = sent.at(-1).id) {
      const content = { kind: "drawn", id, width: 1, height: 1, pose: { ...pose } };
      hear(content, [new DataView(new ArrayBuffer(3)), new DataView(new ArrayBuffer(2))]);
    },
    other: (content) => hear(content, []),
  };
}

function start(model) {
  const seen = { frames: [], missed: 0 };
  const source = makeSceneSource(model, {
    show: (frame) => seen.frames.push(frame.pose.pan_deg),
    miss: () => {
      seen.missed += 1;
    },
  });
  return { source, seen };
}

test("of many changes while Python draws, only the last is asked for", () => {
  const model = makeModel();
  const { source, seen } = start(model);
  for (const pan of [1, 2, 3, 4]) {
    model.pose.pan_deg = pan;
    source.ask();
  }
  assert.deepEqual(
    model.sent.map(({ pose }) => pose.pan_deg),
    [1],
  );
  model.answer();
  assert.deepEqual(
    model.sent.map(({ pose }) => pose.pan_deg),
    [1, 4],
  );
  model.answer();
  assert.equal(model.sent.length, 2);
  assert.deepEqual(seen.frames, [4, 4]);
  source.destroy();
});

test("a picture that another view asked for is shown, and is no answer", () => {
  const model = makeModel();
  const { source, seen } = start(model);
  source.ask();
  model.answer(99);
  source.ask();
  assert.equal(model.sent.length, 1);
  assert.equal(seen.frames.length, 1);
  source.destroy();
});

test("messages of another kind are left alone", () => {
  const model = makeModel();
  const { source, seen } = start(model);
  model.other({ kind: "anywidget-command-response" });
  assert.deepEqual(seen, { frames: [], missed: 0 });
  source.destroy();
});

test("a question without an answer is told, and does not keep the next one back", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  try {
    const model = makeModel();
    const { source, seen } = start(model);
    source.ask();
    source.ask();
    mock.timers.tick(6000);
    assert.equal(seen.missed, 1);
    assert.equal(model.sent.length, 2);
    source.destroy();
    mock.timers.tick(6000);
    assert.equal(seen.missed, 1, "nobody listens any more");
  } finally {
    mock.timers.reset();
  }
});

test("angles stay within the limits of the neck, in tenths of a degree", () => {
  assert.deepEqual(limitAngles([12.34, -3.21], LIMITS), [12.3, -3.2]);
  assert.deepEqual(limitAngles([99, -99], LIMITS), [80, -40]);
});
