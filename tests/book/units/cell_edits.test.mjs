// What two tabs on one page keep of its cells: book/_page_python/cell_edits.js.

import assert from "node:assert/strict";
import { test } from "node:test";

/** A browser's storage; it may refuse to keep anything. */
function makeStorage(refuses = false) {
  const kept = new Map();
  return {
    getItem: (key) => kept.get(key) ?? null,
    setItem: (key, value) => {
      if (refuses) throw new Error("full");
      kept.set(key, value);
    },
    removeItem: (key) => kept.delete(key),
  };
}

/** Opens a tab on a page, with what the tab finds there. */
async function openTab(storage) {
  /** @type {any} */ (globalThis).localStorage = storage;
  /** @type {any} */ (globalThis).window = {};
  await import(`../../../book/_page_python/cell_edits.js?${Math.random()}`);
  const { edits } = /** @type {any} */ (globalThis).window.cameraLab;
  const found = edits.open("step1");
  return { found, write: (cells) => edits.write("step1", cells) };
}

const edit = (/** @type {string} */ source, code = `${source}, changed`) => ({ source, code });

test("each tab keeps its own cells, and the other's", async () => {
  const storage = makeStorage();
  const one = await openTab(storage);
  const other = await openTab(storage);
  assert.ok(one.write([edit("a = 1")]));
  assert.ok(other.write([edit("b = 2")]));
  const { found } = await openTab(storage);
  assert.deepEqual(new Set(found.map(({ source }) => source)), new Set(["a = 1", "b = 2"]));
});

test("of one cell the last change stays", async () => {
  const storage = makeStorage();
  const one = await openTab(storage);
  const other = await openTab(storage);
  one.write([edit("a = 1", "a = 10")]);
  other.write([edit("a = 1", "a = 20")]);
  assert.deepEqual((await openTab(storage)).found, [edit("a = 1", "a = 20")]);
});

test("a cell that is reset is reset, and no other", async () => {
  const storage = makeStorage();
  const one = await openTab(storage);
  one.write([edit("a = 1"), edit("b = 2")]);
  const other = await openTab(storage);
  other.write([edit("b = 2")]);
  assert.deepEqual((await openTab(storage)).found, [edit("b = 2")]);
  // the first tab still shows its change of the other cell, and changes it again
  one.write([edit("a = 1"), edit("b = 2", "b = 3")]);
  assert.deepEqual((await openTab(storage)).found, [edit("b = 2", "b = 3")]);
});

test("where nothing can be kept, it says so", async () => {
  const tab = await openTab(makeStorage(true));
  assert.equal(tab.write([edit("a = 1")]), false);
});
