// node explorers.mjs SITE PAGE...: uses every explorer of the pages as a reader would, with the
// keyboard, and prints {page: what they said}. test_explorers.py says what is right.

import { close, forEach, main, newPage, openPage, waitForFrames } from "../../tools/browser.mjs";

const SPEAK_MS = 1500; // longer than an explorer waits before it speaks
const CHANGE_MS = 800;
const LONGEST = 5000;

const TABS_AT_ONCE = 2; // an explorer mostly waits before it speaks

await main((browser, site, ...names) =>
  forEach(names, TABS_AT_ONCE, (name) => visit(browser, site, name)),
);

async function visit(browser, site, name) {
  const tab = await openPage(browser, site, name);
  const { page, complaints } = tab;
  const explorers = [];
  for (const box of await page.locator(".explorer-box").all()) {
    await box.scrollIntoViewIfNeeded();
    explorers.push(await use(page, box));
  }
  await page.emulateMedia({ media: "print" });
  const printed = await countShown(page);
  await close(tab);
  const plain = await newPage(browser, site, { javaScriptEnabled: false });
  await plain.page.goto(new URL(`${name}.html`, site).href);
  const withoutScripts = await countShown(plain.page);
  await close(plain);
  return { explorers, printed, withoutScripts, complaints: [...complaints] };
}

/** How many posters and how many explorers are to be seen. */
function countShown(page) {
  return page.evaluate(() => {
    const count = (selector) =>
      [...document.querySelectorAll(selector)].filter((one) => one.getClientRects().length).length;
    return { posters: count("img.explorer-poster"), explorers: count(".explorer-box") };
  });
}

/** Moves every control of an explorer to its ends and its middle; picks; resets. */
async function use(page, box) {
  const root = box.locator(".explorer");
  const name = await root.getAttribute("data-explorer");
  await box.locator('.explorer[data-state="ready"]').waitFor({ timeout: LONGEST });
  const first = await read(page, root);
  const moves = [];
  let last = first;
  const note = async (control, step) => {
    last = await read(page, root, last);
    moves.push({ control, step, ...last });
  };

  for (const handle of await box.locator(".noUi-handle").all()) {
    const label = await handle.getAttribute("aria-label");
    const steps = {
      min: () => press(page, handle, "Home"),
      mid: () => drag(page, handle),
      max: () => press(page, handle, "End"),
    };
    for (const [step, move] of Object.entries(steps)) {
      await move();
      await note(label, step);
      const said = await handle.getAttribute("aria-valuetext");
      Object.assign(moves.at(-1), { said, shown: Number.parseFloat(said.replace("−", "-")) });
    }
    // out of the way: a range whose ends meet would shut its other handle in
    const isHigh = /, high$/.test(label);
    await press(page, handle, isHigh ? "End" : "Home");
  }
  for (const button of await box.locator(".widget-toggle-button").all()) {
    await button.press("Enter");
    await note(await button.textContent(), "pressed");
    moves.at(-1).pressed = await button.getAttribute("aria-pressed");
  }
  for (const canvas of await box.locator('canvas[role="application"]').all()) {
    await press(page, canvas, "ArrowRight", "Shift+ArrowDown");
    await note("picture", "arrow keys");
    const { width, height } = await canvas.boundingBox();
    await canvas.click({ position: { x: width * 0.3, y: height * 0.7 } });
    await note("picture", "click");
  }
  await page.waitForTimeout(SPEAK_MS);
  const spoken = await root.locator(".explorer-spoken").textContent();
  const readout = await root.locator(".explorer-readout").textContent();
  await root.getByRole("button", { name: "Reset", exact: true }).press("Enter");
  const reset = await read(page, root, last);
  const unnamed = await box.locator("[role=slider]:not([aria-label]), button:empty").count();
  return { name, first, moves, spoken, readout, reset, unnamed };
}

async function press(page, element, ...keys) {
  await element.focus();
  for (const key of keys) await page.keyboard.press(key);
}

/** Drags a handle to the middle of its slider. */
async function drag(page, handle) {
  const box = await waitUntilStill(page, handle);
  const slider = await handle.locator("xpath=ancestor::*[@class and contains(@class,'noUi-base')]");
  const middle = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(middle.x + middle.width / 2, box.y + box.height / 2, { steps: 3 });
  await page.mouse.up();
}

/** Where an element is, once two frames agree on it. */
async function waitUntilStill(page, element) {
  for (let before = await element.boundingBox(); ; ) {
    await page.evaluate(() => new Promise(requestAnimationFrame));
    const now = await element.boundingBox();
    if (now.x === before.x && now.y === before.y) return now;
    before = now;
  }
}

/** What the explorer says, once it has drawn what was last asked of it. */
async function read(page, root, before = {}) {
  // a pointer is heard with the next frame, which may be late; not every move changes something
  const hasMoved = ([one, old]) => one.dataset.parameters !== old;
  const old = JSON.stringify(before.parameters);
  await page
    .waitForFunction(hasMoved, [await root.elementHandle(), old], { timeout: CHANGE_MS })
    .catch(() => {});
  await waitForFrames(page);
  return root.evaluate(({ dataset, explorerModel }) => {
    const parameters = JSON.parse(dataset.parameters);
    const near = explorerModel.get("nears")?.[parameters.near_place]; // chosen from a list
    return { parameters, near, values: JSON.parse(dataset.values) };
  });
}
