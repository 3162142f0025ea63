// Uses the widgets of the pages with Python behind them: node widgets.mjs SITE. On a page with an
// explorer, on one with the live scene, and on one that the book has built without widgets.
// test_widgets.py says what is right.

import { close, main, openPage, WIDGETS } from "../../tools/browser.mjs";
import * as ui from "./_cells.mjs";

const LONGEST_MS = 60_000;
const DRAG_STEPS = 40;

await main(async (browser, site) => ({
  hsv: await useHsv(browser, site, "book/step4_color"),
  scene: await useScene(browser, site, "book/step1_camera"),
  plain: await usePlain(browser, site, "book/conventions"),
}));

/** The number of the first cell whose code holds a text. */
async function findCell(page, text) {
  const codes = await page.$$eval(".cell.is-live .cell_input pre", (all) =>
    all.map((pre) => pre.textContent),
  );
  return codes.findIndex((code) => code.includes(text)) + 1;
}

/** Runs code in the session of the page, behind its cells; returns what it prints. */
function ask(page, code) {
  return page.evaluate(async (given) => {
    const order = { kind: "cell", code: given, name: "a test", isSetup: false };
    const said = await window.cameraLab.python.run({ key: "a test", order, say: () => {} });
    return said.outputs.map((o) => o.text ?? o.traceback.join("\n")).join("");
  }, code);
}

function yours(page, number) {
  return ui.cell(page, number).locator(".cell-yours");
}

/** The reader moves the explorer of the book, and goes on with a cell below it. */
async function useHsv(browser, site, name) {
  const { page, complaints, ...tab } = await openPage(browser, site, name);
  const seen = {};
  const number = await findCell(page, "explore_hsv(");
  const built = ui.cell(page, number).locator(".cell_output");
  await built.locator('.explorer[data-state="ready"]').waitFor();
  const builtHandle = built.locator(".noUi-handle").first();
  await builtHandle.press("End");
  await builtHandle.press("ArrowLeft");
  seen.below = await ui.run(page, await findCell(page, "hsv_explorer.hsv_range"));
  seen.carried = await ask(page, "print(hsv_explorer.hsv_range)");
  seen.cell = (await ui.readCells(page))[number - 1];

  const live = yours(page, number);
  const handle = live.locator(".noUi-handle").first();
  await handle.press("Home");
  await handle.press("ArrowRight");
  seen.moved = await ask(page, "print(hsv_explorer.hsv_range)");
  await live
    .locator(".explorer-picker canvas")
    .first()
    .click({ position: { x: 40, y: 30 } });
  seen.picked = await ask(page, "print(hsv_explorer.pixel, hsv_explorer.pixel_rgb)");
  const told = live.locator(".explorer-readout").filter({ hasText: /Pixel \(/ });
  seen.told = await told.textContent(); // which waits until it says so
  await ask(page, "hsv_explorer.move(saturation_limits=[77, 255])");
  await handle.and(page.locator('[aria-valuetext="77"]')).waitFor();

  // while Python is busy the page holds back what is overwritten anyway
  const counter = await page.evaluateHandle(() => {
    const { python, widgets } = window.cameraLab;
    const counted = { messages: 0 };
    widgets.onSend = (message) => {
      counted.messages += 1;
      python.sendComm(message);
    };
    return counted;
  });
  const busy = ask(page, "import time\nuntil = time.time() + 5\nwhile time.time() < until: pass");
  // in the page, so that Python is busy until all are made, whatever else the machine does
  await handle.evaluate(async (element) => {
    for (let i = 0; i < 20; i++) {
      element.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
      await new Promise((resolve) => setTimeout(resolve)); // a task of its own each
    }
  });
  seen.sentWhileBusy = await counter.evaluate(({ messages }) => messages);
  await busy;
  seen.afterBusy = await ask(page, "print(hsv_explorer.hsv_range)");

  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 500));
  await ask(page, "while True: pass").catch(() => {});
  seen.stopped = await live.locator(".widget-note").textContent();
  await handle.press("ArrowRight");
  seen.movesStopped = await handle.getAttribute("aria-valuetext");
  seen.complaints = [...complaints];
  await close({ page, ...tab });
  return seen;
}

/** The reader turns the head in the picture. */
async function useScene(browser, site, name) {
  const { page, complaints, ...tab } = await openPage(browser, site, name);
  const seen = {};
  const number = await findCell(page, "explore_scene(");
  const built = ui.cell(page, number).locator(".cell_output .explorer-scene-note");
  await built.getByText("Press Run").waitFor();
  seen.still = await built.textContent();
  seen.cell = await ui.run(page, number);
  const live = yours(page, number);
  const root = live.locator(".explorer[data-frames]");
  await root.waitFor({ timeout: LONGEST_MS });
  seen.live = await live.locator(".explorer-scene-note").textContent();
  const color = live.locator("canvas").first();
  await color.scrollIntoViewIfNeeded();
  const first = await color.evaluate((canvas) => canvas.toDataURL());
  const { x, y, width, height } = await color.boundingBox();
  const [middleX, middleY] = [x + width / 2, y + height / 2];
  const count = () => root.evaluate(({ dataset }) => Number(dataset.frames));
  const before = await count();
  const started = performance.now();
  await page.mouse.move(middleX, middleY);
  await page.mouse.down();
  for (let i = 1; i <= DRAG_STEPS; i++) await page.mouse.move(middleX + 2 * i, middleY + i);
  await page.mouse.up();
  await live
    .locator("canvas")
    .nth(1)
    .click({ position: { x: 60, y: 90 } });
  await page.waitForFunction(
    (one) => JSON.parse(one.dataset.values).is_current,
    await root.elementHandle(),
    { timeout: LONGEST_MS },
  );
  seen.framesPerSecond = ((await count()) - before) / ((performance.now() - started) / 1000);
  seen.frames = (await count()) - before;
  seen.hasChanged = first !== (await color.evaluate((canvas) => canvas.toDataURL()));
  seen.values = JSON.parse(await root.getAttribute("data-values"));
  seen.python = await ask(page, "import json\nprint(json.dumps(scene_explorer.values))");
  seen.data = await ask(page, "print(data.joint('neck_pan').qpos, data.joint('neck_tilt').qpos)");
  await ask(page, "scene_explorer.move(pan_deg=-15.0, ball_x=0.7)");
  await page.waitForFunction(
    (one) => JSON.parse(one.dataset.values).pan_deg === -15,
    await root.elementHandle(),
    { timeout: LONGEST_MS },
  );
  seen.complaints = [...complaints];
  await close({ page, ...tab });
  return seen;
}

/** The reader writes widgets into a page that has none. */
async function usePlain(browser, site, name) {
  const { page, complaints, ...tab } = await openPage(browser, site, name);
  const seen = { built: await page.locator(WIDGETS.views).count() };
  const code = [
    "import ipywidgets",
    "from IPython.display import display",
    "button = ipywidgets.Button(description='Go')",
    "button.on_click(lambda _: print('clicked'))",
    "def double(x):",
    "    print('x is', x)",
    "    return 1 / 0 if x == 10 else 2 * x",
    "display(button)",
    "interactive = ipywidgets.interact(double, x=(0, 10))",
  ];
  await ui.edit(page, 1, `${code.join("\n")}\n`);
  seen.cell = await ui.run(page, 1);
  const live = yours(page, 1);
  await live.getByRole("button", { name: "Go" }).click();
  await live.getByText("clicked").waitFor();
  await live.getByText("x is 5").waitFor();
  await live.locator(".noUi-handle").press("ArrowRight");
  await live.getByText("x is 6").waitFor();
  seen.returned = await live.getByText("12", { exact: true }).count();
  await live.locator(".noUi-handle").press("End");
  await live.getByText("ZeroDivisionError").waitFor();
  seen.complaints = [...complaints];
  await close({ page, ...tab });
  return seen;
}
