// node goals.mjs SITE: reaches the goals of depth range, stereo and cloud as a reader would, and
// leaves them again; prints what their lines say. test_goals.py says what is right.

import { close, main, openPage, waitForFrames } from "../../tools/browser.mjs";

await main(async (browser, site) => ({
  "depth-range": await reach(browser, site, "book/step3_depth", "depth-range", reachRange),
  stereo: await reach(browser, site, "book/background", "stereo", reachStereo),
  cloud: await reach(browser, site, "book/step5_cloud", "cloud", reachCloud),
}));

async function reach(browser, site, name, explorer, steps) {
  const tab = await openPage(browser, site, name);
  const box = tab.page.locator(`.explorer-box:has([data-explorer="${explorer}"])`);
  await box.locator('.explorer[data-state="ready"]').waitFor();
  await box.scrollIntoViewIfNeeded();
  const seen = [];
  const note = async () => {
    await waitForFrames(tab.page);
    seen.push(await read(box));
  };
  await note();
  for (const step of steps(tab.page, box)) {
    await step();
    await note();
  }
  await close(tab);
  return { seen, complaints: [...tab.complaints] };
}

function read(box) {
  return box.evaluate((one) => {
    const text = (selector) => one.querySelector(selector)?.textContent ?? "";
    return {
      state: one.querySelector(".explorer-goal").dataset.state,
      told: text(".explorer-goal-told"),
      mark: text(".explorer-goal-mark"),
      bar: Number.parseFloat(one.querySelector(".explorer-goal-bar > span").style.width),
      values: JSON.parse(one.querySelector(".explorer").dataset.values),
    };
  });
}

/** Presses a key on a handle until a test of the values holds. */
function turn(page, box, number, key, isThere) {
  return async () => {
    await box.locator(".noUi-handle").nth(number).focus();
    for (let i = 0; i < 100; i++) {
      await page.keyboard.press(key);
      await waitForFrames(page);
      if (isThere((await read(box)).values)) return;
    }
  };
}

function reachRange(page, box) {
  return [
    turn(page, box, 1, "PageDown", ({ left_out }) => left_out > 0),
    turn(page, box, 1, "ArrowRight", ({ left_out }) => left_out === 0),
    turn(page, box, 0, "PageUp", ({ width_percent }) => width_percent < 105),
    turn(page, box, 0, "PageUp", ({ left_out }) => left_out > 0),
  ];
}

function reachStereo(page, box) {
  return [
    async () => {
      const canvas = box.locator("canvas[role=application]");
      const { width } = await canvas.boundingBox();
      await canvas.click({ position: { x: 0.6 * width, y: 4 } });
    },
    turn(page, box, 0, "PageUp", ({ error_mm }) => error_mm < 10),
    turn(page, box, 0, "PageDown", ({ error_mm }) => error_mm > 10.2),
  ];
}

function reachCloud(page, box) {
  return [
    turn(page, box, 0, "ArrowLeft", ({ angle_deg }) => angle_deg < 90.5),
    turn(page, box, 0, "ArrowLeft", ({ angle_deg }) => angle_deg < 89.5),
  ];
}
