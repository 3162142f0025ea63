// Uses the following explorer, first as the book has built it, then with Python behind it, then with
// a controller that fails: node following.mjs SITE. test_following.py says what is right.

import { close, main, openPage } from "../../tools/browser.mjs";
import * as ui from "./_cells.mjs";

const PAGE = "book/following";
const LONGEST_MS = 60_000;
const FAILING = `def control(rgb, depth, K, state):
    if state.time > 0.22:
        return 1 / 0
    return state.pan, state.tilt`;

await main(async (browser, site) => {
  const tab = await openPage(browser, site, PAGE);
  const { page } = tab;
  const number = await findCell(page, "explore_following(");
  const cell = ui.cell(page, number);
  const seen = { recorded: await useRecording(page, cell.locator(".cell_output")) };
  seen.cell = await ui.run(page, number);
  seen.live = await useLive(page, cell.locator(".cell-yours"));
  await ui.edit(page, await findCell(page, "def control("), FAILING);
  seen.failingCell = await ui.run(page, number);
  seen.failing = await useFailing(page, cell.locator(".cell-yours"));
  seen.complaints = [...tab.complaints];
  await close(tab);
  return seen;
});

/** The number of the last cell whose code holds a text. */
async function findCell(page, text) {
  const codes = await page.$$eval(".cell.is-live .cell_input pre", (all) =>
    all.map((pre) => pre.textContent),
  );
  return codes.findLastIndex((code) => code.includes(text)) + 1;
}

/** What an explorer tells at the moment. */
function read(place) {
  return place.locator(".explorer").evaluate((root) => ({
    mode: root.dataset.mode,
    steps: Number(root.dataset.steps),
    parameters: JSON.parse(root.dataset.parameters),
    values: JSON.parse(root.dataset.values),
    note: root.querySelector(".explorer-following-note").textContent,
    problem: root.querySelector(".explorer-following-problem").textContent,
    budget: root.querySelector(".explorer-budget-list").textContent,
    buttons: [...root.querySelectorAll(".explorer-following-buttons button")].map((one) => [
      one.textContent,
      one.disabled,
    ]),
  }));
}

function press(place, name) {
  return place.getByRole("button", { name, exact: true }).press("Enter");
}

/** Waits until an explorer tells something. */
async function wait(page, place, test, value) {
  const root = await place.locator(".explorer").elementHandle();
  const code = `([root, value]) => { const { dataset } = root; return ${test}; }`;
  // biome-ignore lint/security/noGlobalEval: the page gets its own text
  await page.waitForFunction(eval(code), [root, value], { timeout: LONGEST_MS });
}

/** Runs in the page, so that it is as quick as the page: plays a recording until some time. */
function playAWhile(root, time) {
  const [button] = root.querySelectorAll(".explorer-following-buttons button");
  return new Promise((resolve) => {
    const observer = new MutationObserver(() => {
      if (JSON.parse(root.dataset.values).time <= time || button.textContent !== "Pause") return;
      observer.disconnect();
      button.click();
      resolve(true);
    });
    observer.observe(root, { attributeFilter: ["data-values"] });
    button.click();
  });
}

/** Waits until the step that was on its way has come. */
async function waitUntilStill(page, place) {
  for (let before = -1, now = 0; before !== now; ) {
    before = now;
    await page.waitForTimeout(1500);
    now = (await read(place)).steps;
  }
}

async function useRecording(page, place) {
  await place.locator('.explorer[data-state="ready"]').waitFor();
  const first = await read(place);
  const canvas = place.locator("canvas").first();
  const picture = () => canvas.evaluate((one) => one.toDataURL());
  const last = await picture();
  await press(place, "Start again");
  await wait(page, place, "JSON.parse(dataset.values).time === 0");
  await press(place, "Step");
  await wait(page, place, "JSON.parse(dataset.values).time > 0");
  const stepped = await read(place);
  await place.locator(".explorer").evaluate(playAWhile, 0.4);
  await place.getByRole("button", { name: "Play", exact: true }).waitFor();
  const paused = await read(place);
  const pictureHasChanged = last !== (await picture());
  const scrubber = place.locator("input[type=range]");
  await scrubber.press("End");
  await wait(page, place, "JSON.parse(dataset.values).time > 5");
  const scrubbed = { ...(await read(place)), said: await scrubber.getAttribute("aria-valuetext") };
  return { first, stepped, paused, pictureHasChanged, scrubbed };
}

async function useLive(page, place) {
  await wait(page, place, 'dataset.mode === "live"');
  const seen = { first: await read(place) };
  for (const count of [1, 2, 3]) {
    await press(place, "Step");
    await wait(page, place, "Number(dataset.steps) >= value", count);
  }
  seen.stepped = await read(place);
  const started = performance.now();
  await press(place, "Run");
  await wait(page, place, "Number(dataset.steps) >= value", 33);
  seen.stepsPerSecond = 30 / ((performance.now() - started) / 1000);
  seen.answerMs = await place.locator(".explorer").getAttribute("data-answer-ms");
  await press(place, "Hide the ball");
  await wait(page, place, "JSON.parse(dataset.values).is_hidden");
  seen.hidden = await read(place);
  await wait(page, place, "!JSON.parse(dataset.values).is_hidden");
  const delay = place.locator('.noUi-handle[aria-label^="delay"]');
  await delay.press("End");
  const delayed = "/delay 400 ms/.test(root.querySelector('.explorer-budget-list').textContent)";
  await wait(page, place, delayed);
  seen.delayed = await read(place);
  await press(place, "Pause");
  await place.getByRole("button", { name: "Run", exact: true }).waitFor();
  await waitUntilStill(page, place);
  seen.python = await ask(
    page,
    `import gc, json
from labutils.explorers import FollowingExplorer
made = [one for one in gc.get_objects() if isinstance(one, FollowingExplorer)]
print(json.dumps([len(made[-1].record.time), made[-1].values]))`,
  );
  seen.paused = await read(place);
  await press(place, "Start again");
  await wait(page, place, "dataset.steps === '0'");
  seen.restarted = await read(place);
  return seen;
}

async function useFailing(page, place) {
  await wait(page, place, 'dataset.mode === "live"');
  await press(place, "Run");
  await place.locator(".explorer-following-problem:not(:empty)").waitFor({ timeout: LONGEST_MS });
  const stopped = await read(place);
  await press(place, "Step");
  await place.locator(".explorer-following-problem:not(:empty)").waitFor({ timeout: LONGEST_MS });
  return { stopped, again: await read(place) };
}

/** Runs code in the session of the page, behind its cells; returns what it prints. */
function ask(page, code) {
  return page.evaluate(async (given) => {
    const order = { kind: "cell", code: given, name: "a test", isSetup: false };
    const said = await window.cameraLab.python.run({ key: "a test", order, say: () => {} });
    return said.outputs.map((o) => o.text ?? o.traceback.join("\n")).join("");
  }, code);
}
