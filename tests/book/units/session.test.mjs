// In which order the cells of a page run: book/_page_python/session.js.

import assert from "node:assert/strict";
import { test } from "node:test";

/** @type {any} */
const good = { result: "ran" };

/** A page of cells whose Python answers as `answer` says, and what was run, in order. */
async function makePage(codes, answer = (/** @type {any} */ _order) => good) {
  /** @type {any[]} */
  const ran = [];
  /** @type {(() => void)[]} */
  const listeners = [];
  const python = {
    run({ order, parts, say }) {
      say("Running");
      ran.push([order.name, order.code, parts]);
      return Promise.resolve(answer(order));
    },
    stop(key) {
      ran.push(["stop", key]);
    },
    listenForEnd: (listener) => listeners.push(listener),
  };
  /** @type {any} */ (globalThis).Node = { DOCUMENT_POSITION_FOLLOWING: 4 };
  /** @type {any} */ (globalThis).window = {
    cameraLab: { python, assets: {}, outputs: {}, elements: { keepInPlace: () => () => {} } },
  };
  await import(`../../../book/_page_python/session.js?${Math.random()}`);
  const { session } = window.cameraLab;
  const cells = codes.map((code, place) => makeCell(code, place));
  for (const cell of cells.toReversed()) session.add(cell); // in any order
  const endPython = () => {
    for (const listener of listeners) listener();
  };
  return { cells, session, ran, endPython, names: () => ran.splice(0).map(([name]) => name) };
}

function makeCell(code, place) {
  const told = [];
  const note = (word) => (thing) => told.push(thing?.title ? [word, thing.title] : [word]);
  return {
    element: { place, compareDocumentPosition: (other) => (other.place > place ? 4 : 2) },
    key: `${place}`,
    name: `${place}`,
    title: `Cell ${place}`,
    isNeededBelow: true,
    skipped: "",
    code,
    told,
    getText() {
      return this.code;
    },
    wait: note("wait"),
    rest: note("rest"),
    begin: note("begin"),
    say() {},
    print() {},
    async finish(said, { isAsked }) {
      told.push([said.result, isAsked]);
    },
    fail: note("fail"),
    forget: note("forget"),
  };
}

test("a cell runs after those above it, and each of them once", async () => {
  const { cells, session, names } = await makePage(["a", "b", "c", "d"]);
  assert.equal(await session.run(cells[2]), true);
  assert.deepEqual(names(), ["0", "1", "2"]);
  await session.run(cells[3]);
  assert.deepEqual(names(), ["3"]);
  await session.run(cells[1]);
  assert.deepEqual(names(), ["1"]);
});

test("a changed cell above runs again, and what follows from it", async () => {
  const { cells, session, names } = await makePage(["a", "b", "c", "d"]);
  await session.run(cells[3]);
  names();
  cells[1].code = "changed";
  await session.run(cells[3]);
  assert.deepEqual(names(), ["1", "2", "3"]);
});

test("running a changed cell makes those below run again when they are needed", async () => {
  const { cells, session, names } = await makePage(["a", "b", "c", "d"]);
  await session.run(cells[3]);
  names();
  cells[0].code = "changed";
  await session.run(cells[0]);
  assert.deepEqual(names(), ["0"]);
  await session.run(cells[3]);
  assert.deepEqual(names(), ["1", "2", "3"]);
});

test("a cell above that fails keeps the one below from running, and is named", async () => {
  const page = await makePage(["a", "wrong", "c"], ({ code }) => ({
    result: code === "wrong" ? "error" : "ran",
  }));
  assert.equal(await page.session.run(page.cells[2]), false);
  assert.deepEqual(page.names(), ["0", "1"]);
  assert.deepEqual(page.cells[2].told, [["wait"], ["fail", "Cell 1"], ["rest"]]);
  // once it is right, all goes on from there
  page.cells[1].code = "right";
  assert.equal(await page.session.run(page.cells[2]), true);
  assert.deepEqual(page.names(), ["1", "2"]);
});

test("when Python has ended everything is to be run again", async () => {
  const { cells, session, names, endPython } = await makePage(["a", "b"]);
  await session.run(cells[1]);
  names();
  endPython();
  assert.equal(session.hasRun(cells[0]), false);
  assert.deepEqual(cells[0].told.at(-1), ["forget"]);
  await session.run(cells[1]);
  assert.deepEqual(names(), ["0", "1"]);
});

test("an exercise needs the set-up cells above it, and not the exercises", async () => {
  const { cells, session, names } = await makePage(["set up", "first", "second"]);
  cells[1].isNeededBelow = cells[2].isNeededBelow = false;
  await session.run(cells[2]);
  assert.deepEqual(names(), ["0", "2"]);
});

test("run all goes on after a cell with an error, and leaves out what a page cannot run", async () => {
  const page = await makePage(["a", "wrong", "process", "d"], ({ code }) => ({
    result: code === "wrong" ? "error" : "ran",
  }));
  page.cells[2].skipped = "it starts a process";
  page.cells[2].isNeededBelow = false;
  const bar = makeCell("", 9);
  assert.equal(await page.session.runAll(bar), false);
  assert.deepEqual(page.names(), ["0", "1", "3"]);
  assert.deepEqual(bar.told, [["wait"], ["rest"]]);
});

test("two presses run one after the other", async () => {
  const { cells, session, names } = await makePage(["a", "b", "c"]);
  await Promise.all([session.run(cells[1]), session.run(cells[2])]);
  assert.deepEqual(names(), ["0", "1", "2"]);
});

test("stopping ends the cell that runs, and those that would come after", async () => {
  let release;
  const held = new Promise((resolve) => {
    release = resolve;
  });
  const page = await makePage(["a", "slow", "c"], ({ code }) =>
    code === "slow" ? held : { result: "ran" },
  );
  const done = page.session.run(page.cells[2]);
  while (page.ran.length < 2) await new Promise((resolve) => setTimeout(resolve));
  page.session.stop(page.cells[2]);
  assert.deepEqual(page.ran.at(-1), ["stop", "1"]);
  release({ result: "stopped" });
  assert.equal(await done, false);
  assert.deepEqual(page.names(), ["0", "1", "stop"]);
});

test("code says which parts of Python it needs", async () => {
  const { cells, session, ran } = await makePage(["import numpy", "import labutils as lab"]);
  await session.run(cells[1]);
  assert.deepEqual(
    ran.map(([, , parts]) => parts),
    [[], ["simulator"]],
  );
});

test("code that reads a recording brings the recorded pictures", async () => {
  const { session } = await makePage([]);
  const line = "from labutils.recordings import load_recording";
  assert.deepEqual(session.findParts(line), ["simulator", "recordings"]);
  assert.deepEqual(session.findParts("clip = load_recording('room')"), ["recordings"]);
  assert.deepEqual(session.findParts("import labutils as lab"), ["simulator"]);
  assert.deepEqual(session.findParts("recording = pair.left"), []);
});
