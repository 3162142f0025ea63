// node explorer_details.mjs SITE FOLDER: uses field of view, HSV and depth convention on their pages
// (FOLDER holds pictures to open) and prints what follows. test_explorer_details.py judges it.

import { readdirSync } from "node:fs";
import { join } from "node:path";

import { close, main, openPage, waitForFrames } from "../../tools/browser.mjs";

await main(async (browser, site, folder) => ({
  ray: await visit(browser, site, "book/step2_intrinsics", pointAtRays),
  goal: await visit(browser, site, "book/step2_intrinsics", reachGoal),
  convention: await visit(browser, site, "book/step3_depth", dragPoint),
  own: await visit(browser, site, "book/step4_color", (page, box) => openAll(page, box, folder)),
}));

async function visit(browser, site, name, use) {
  const tab = await openPage(browser, site, name);
  const { page, complaints } = tab;
  const box = page.locator(".explorer-box").first();
  await box.locator('.explorer[data-state="ready"]').waitFor();
  await box.scrollIntoViewIfNeeded();
  const seen = await use(page, box);
  await close(tab);
  return { ...seen, complaints: [...complaints] };
}

/** Sets what a reader would set with controls. */
async function set(page, traits) {
  await page.evaluate((values) => {
    const model = document.querySelector(".explorer-box .explorer").explorerModel;
    for (const [name, value] of Object.entries(values)) model.set(name, value);
  }, traits);
  await waitForFrames(page);
}

/** Points at the picture, at the drawing from above, and with the keys. */
async function pointAtRays(page, box) {
  const read = async () => {
    await waitForFrames(page);
    return box.evaluate((one) => {
      const isShown = (selector) => one.querySelector(selector).getClientRects().length > 0;
      return {
        told: one.querySelector(".explorer-readout").textContent,
        ray: one.querySelector(".explorer-top-ray").getAttribute("d"),
        column: isShown(".explorer-column") && one.querySelector(".explorer-column").style.left,
        mark: isShown(".explorer-mark") && one.querySelector(".explorer-mark").style.top,
      };
    });
  };
  const seen = { first: await read() };
  const canvas = box.locator("canvas").first();
  const picture = await canvas.boundingBox();
  await page.mouse.move(picture.x + picture.width * 0.25, picture.y + picture.height * 0.75);
  seen.picture = await read();
  await set(page, { fov_y_deg: 60 });
  seen.wider = await read();
  const drawing = await box.locator(".explorer-top svg").boundingBox();
  await page.mouse.move(drawing.x + drawing.width * 0.5, drawing.y + drawing.height * 0.3);
  seen.drawing = await read();
  await page.mouse.move(0, 0);
  seen.away = await read();
  await canvas.focus();
  await page.keyboard.press("ArrowRight");
  seen.keys = await read();
  return seen;
}

/** Closes the angle until the goal is reached, too far, and back; then asks for another goal. */
async function reachGoal(page, box) {
  const seen = [];
  const goal = box.locator(".explorer-goal");
  for (const fov of [45, 42.5, 40.5, 39, 41]) {
    await set(page, { fov_y_deg: fov });
    seen.push(
      await goal.evaluate((one) => ({
        state: one.dataset.state,
        told: one.querySelector(".explorer-goal-told").textContent,
        mark: one.querySelector(".explorer-goal-mark").textContent,
        bar: one.querySelector(".explorer-goal-bar > span").style.width,
        spoken: one.querySelector("[role=status]").textContent,
        height: one.offsetHeight,
      })),
    );
  }
  await set(page, { goal: {} });
  return { seen, without: await goal.isVisible() };
}

/** Drags the point of the curve over names and numbers, then brings both planes together. */
async function dragPoint(page, box) {
  const svg = box.locator(".explorer-draggable");
  const { x, y, width, height } = await svg.boundingBox();
  await page.mouse.move(x + width * 0.5, y + height * 0.5);
  await page.mouse.down();
  await page.mouse.move(x + width * 0.6, y + height * 0.97, { steps: 5 });
  await page.mouse.move(x + 2, y + 2, { steps: 5 });
  await page.mouse.up();
  const selected = await page.evaluate(() => String(window.getSelection()));
  const planes = {};
  for (const [near, far] of [
    [0.02, 12],
    [1, 2],
    [0.2, 100],
  ]) {
    const nears = await box.evaluate((one) =>
      one.querySelector(".explorer").explorerModel.get("nears"),
    );
    await set(page, { near_place: nears.indexOf(near), far });
    planes[`${near} to ${far}`] = await svg.evaluate(measureNames);
  }
  return { selected, planes };
}

/** Runs in the page: how far each name lies from its curve, as shares of the drawing's width. */
function measureNames(svg) {
  const curves = { true: ".explorer-curve", linear: ".dashed", reversed: ".dotted" };
  const { width, left, right, top, bottom } = svg.getBoundingClientRect();
  const found = {};
  for (const text of svg.querySelectorAll("text.halo")) {
    const rect = text.getBoundingClientRect();
    const path = svg.querySelector(curves[text.textContent]);
    const matrix = path.getScreenCTM();
    let nearest = Infinity;
    for (let i = 0; i <= 400; i++) {
      const at = path.getPointAtLength((path.getTotalLength() * i) / 400).matrixTransform(matrix);
      const dx = Math.max(rect.left - at.x, 0, at.x - rect.right);
      const dy = Math.max(rect.top - at.y, 0, at.y - rect.bottom);
      nearest = Math.min(nearest, Math.hypot(dx, dy));
    }
    const inside =
      rect.left >= left && rect.right <= right && rect.top >= top && rect.bottom <= bottom;
    found[text.textContent] = { distance: nearest / width, inside };
  }
  return found;
}

/** Opens every picture of a folder and measures how it is shown. */
async function openAll(page, box, folder) {
  const measure = () =>
    box.evaluate((one) => {
      const canvas = one.querySelector("canvas");
      const { width, height } = canvas.getBoundingClientRect();
      const place = one.querySelector(".explorer-hsv-picture").getBoundingClientRect();
      return {
        shown: [width, height],
        place: [place.width, place.height],
        pixels: [canvas.width, canvas.height],
        rendering: getComputedStyle(canvas).imageRendering,
        // beside the cross in the middle
        color: [
          ...canvas.getContext("2d").getImageData(canvas.width >> 2, canvas.height >> 2, 1, 1).data,
        ],
        box: one.offsetHeight,
        isGoalShown: getComputedStyle(one.querySelector(".explorer-goal")).visibility === "visible",
        iou: JSON.parse(one.querySelector(".explorer").dataset.values).iou,
      };
    });
  const seen = { scene: await measure() };
  for (const file of readdirSync(folder)) {
    await page.setInputFiles("input[type=file]", join(folder, file));
    await box.locator(".explorer[data-picture=own]").waitFor({ state: "attached" });
    await box.getByRole("status").filter({ hasText: "your picture" }).waitFor();
    await waitForFrames(page);
    seen[file] = await measure();
    await box.getByRole("button", { name: "Back to scene" }).press("Enter");
  }
  seen.back = await measure();
  return seen;
}
