import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { findWindow, toBrokenPath } from "../../../labutils/explorers/static/_following_curves.js";
import { makePlayer } from "../../../labutils/explorers/static/_following_player.js";
import {
  describeBudget,
  findPicture,
  findPlace,
  LAST,
} from "../../../labutils/explorers/static/_following_tape.js";

/** @returns {any} a frame, of which not all is needed */
function makeFrame(time, more = {}) {
  const moment = { time, is_hidden: false, is_measured: true, error_px: 1, error_mm: null };
  return { moment: { ...moment, ...more }, eye: null, outside: null };
}

/** A model as small as can be, whose Python answers when the test says so. */
function makeModel() {
  const traits = { dt: 0.05, moment: LAST };
  const sent = [];
  /** @type {(content: object, buffers: string[]) => void} */
  let hear = () => {};
  return {
    sent,
    get: (name) => traits[name],
    set(name, value) {
      traits[name] = value;
    },
    save_changes() {},
    send: (content) => sent.push(content),
    on: (_, listener) => {
      hear = listener;
    },
    off: () => {
      hear = () => {};
    },
    answer: (more) => hear({ id: sent.at(-1).id, ...more }, ["eye", "outside"]),
  };
}

/** A player on a clock that the test moves. */
function start(t, frames = []) {
  mock.timers.enable({ apis: ["setTimeout"] });
  t.after(() => mock.timers.reset());
  const model = makeModel();
  const seen = { begun: 0, problems: [] };
  const player = makePlayer(model, frames, {
    draw() {},
    begin: () => {
      seen.begun += 1;
    },
    fail: (problem) => seen.problems.push(problem.message),
  });
  return { model, player, frames, seen };
}

const kinds = ({ sent }) => sent.map(({ kind }) => kind);
const stepped = (time) => ({ kind: "stepped", moment: makeFrame(time).moment });

test("a recording is played to its end, and from its beginning after that", (t) => {
  const { model, player } = start(
    t,
    [0, 0.05, 0.1].map((time) => makeFrame(time)),
  );
  player.toggle();
  assert.equal(model.get("moment"), 1); // from the end it begins anew
  mock.timers.tick(60);
  assert.equal(model.get("moment"), 2);
  assert.equal(player.isRunning, false);
  player.restart();
  player.step();
  assert.equal(model.get("moment"), 1);
  assert.equal(player.isLive, false);
  assert.deepEqual(kinds(model), ["hello"]);
});

test("once Python answers, the recording makes room for what happens", (t) => {
  const { model, player, frames, seen } = start(t, [makeFrame(0), makeFrame(0.05)]);
  model.set("moment", 1);
  model.answer({ kind: "ready" });
  assert.equal(player.isLive, true);
  assert.deepEqual([frames.length, seen.begun, model.get("moment")], [0, 1, LAST]);
});

test("the next step is asked for when one has come, and no other before", (t) => {
  const { model, player, frames } = start(t);
  model.answer({ kind: "ready" });
  player.toggle();
  mock.timers.tick(200);
  assert.deepEqual(kinds(model), ["hello", "step"]);
  model.answer(stepped(0));
  mock.timers.tick(60);
  assert.deepEqual(kinds(model), ["hello", "step", "step"]);
  player.toggle();
  model.answer(stepped(0.05));
  mock.timers.tick(60);
  assert.deepEqual(kinds(model), ["hello", "step", "step"]);
  assert.deepEqual(
    frames.map(({ moment }) => moment.time),
    [0, 0.05],
  );
});

test("the ball is hidden once for each press, and a press lets the head run", (t) => {
  const { model, player } = start(t);
  model.answer({ kind: "ready" });
  player.hide();
  assert.equal(player.isRunning, true);
  assert.equal(model.sent.at(-1).hide, true);
  model.answer(stepped(0));
  mock.timers.tick(60);
  assert.equal(model.sent.at(-1).hide, false);
});

test("a problem stops the run and keeps what was", (t) => {
  const { model, player, frames, seen } = start(t);
  model.answer({ kind: "ready" });
  player.toggle();
  model.answer(stepped(0));
  mock.timers.tick(60);
  model.answer({ kind: "stepped", problem: { message: "no" } });
  mock.timers.tick(60);
  assert.deepEqual([player.isRunning, frames.length, seen.problems], [false, 1, ["no"]]);
  player.step();
  assert.deepEqual(kinds(model), ["hello", "step", "step", "step"]);
});

test("who starts again while a step is on its way does so when it has come", (t) => {
  const { model, player, frames } = start(t);
  model.answer({ kind: "ready" });
  player.toggle();
  player.restart();
  assert.deepEqual(kinds(model), ["hello", "step"]);
  model.answer(stepped(0));
  assert.deepEqual(kinds(model), ["hello", "step", "restart"]);
  model.answer({ kind: "ready" });
  mock.timers.tick(60);
  assert.deepEqual([frames.length, kinds(model).at(-1)], [0, "step"]);
});

test("where Python falls silent the run stops, and a later answer is heard", (t) => {
  const { model, player, frames } = start(t);
  model.answer({ kind: "ready" });
  player.toggle();
  mock.timers.tick(10_000);
  assert.deepEqual([player.isRunning, player.isLost], [false, true]);
  model.answer(stepped(0));
  assert.deepEqual([player.isLost, frames.length], [false, 1]);
});

test("what Python never answers is a recording, and nothing is lost", (t) => {
  const { player, frames } = start(t, [makeFrame(0)]);
  mock.timers.tick(10_000);
  assert.deepEqual([player.isLive, player.isLost, frames.length], [false, false, 1]);
});

test("a chosen moment that is not there yet is the newest one", () => {
  assert.equal(findPlace(LAST, 3), 2);
  assert.equal(findPlace(1, 3), 1);
  assert.equal(findPlace(7, 3), 2);
  assert.equal(findPlace(LAST, 0), -1);
});

test("a picture stands until the next one of its kind", () => {
  const frames = [0, 1, 2].map((time) => makeFrame(time));
  frames[1].eye = "eye of 1";
  assert.equal(findPicture(frames, 0, "eye"), null);
  assert.equal(findPicture(frames, 2, "eye").bytes, "eye of 1");
  assert.equal(findPicture(frames, 2, "eye").moment.time, 1);
  assert.equal(findPicture(frames, 2, "outside"), null);
});

test("a budget is the mean of the last second", () => {
  const frames = [500, ...Array(20).fill(10)].map((render_ms, i) =>
    makeFrame(i, { delay_ms: 100, render_ms, control_ms: 2 }),
  );
  const parts = describeBudget(frames, 20, 50).map(({ ms }) => ms);
  assert.deepEqual(parts, [100, 10, 2, 50]);
  assert.deepEqual(
    describeBudget([], -1, 50).map(({ ms }) => ms),
    [0, 0, 0, 50],
  );
  const recorded = makeFrame(0, { delay_ms: 50, render_ms: null, control_ms: null });
  assert.deepEqual(
    describeBudget([recorded], 0, 50).map(({ ms }) => ms),
    [50, null, null, 50],
  );
});

test("the window of a plot moves in leaps and holds the time", () => {
  assert.deepEqual(findWindow(0), [0, 6]);
  assert.deepEqual(findWindow(6), [0, 6]);
  assert.deepEqual(findWindow(6.05), [2, 8]);
  for (let time = 0; time < 40; time += 0.05) {
    const [from, to] = findWindow(time);
    assert.ok(from <= time && time <= to + 1e-9);
  }
});

test("a curve is broken where a value is not known", () => {
  const path = toBrokenPath([[0, 1], [1, 2], null, [3, 4], [4, 5]]);
  assert.equal(path, "M0.0 1.0L1.0 2.0M3.0 4.0L4.0 5.0");
});
