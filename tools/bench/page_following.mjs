// node following.mjs SITE PAGE STEPS: runs the following explorer of a page, and the bare loop in the
// same Python; prints the milliseconds of every step of both.

import { main, openPage } from "../browser.mjs";

const LONGEST_MS = 120_000;
const BARE = `
import json, time
from labutils.following import FollowingLoop
loop, times = FollowingLoop(160, 120), []
for _ in range(STEPS + 5):
    started = time.perf_counter()
    loop.step(control)
    times.append(1000 * (time.perf_counter() - started))
print(json.dumps(times[5:]))
`;

await main(async (browser, site, name, steps) => {
  const { page } = await openPage(browser, site, name);
  const cell = page.locator(".cell.is-live:has-text('explore_following(')").last();
  await cell.getByRole("button", { name: /^Run cell/ }).click();
  const live = cell.locator(".cell-yours .explorer[data-mode=live]");
  await live.waitFor({ timeout: LONGEST_MS });
  await live.getByRole("button", { name: "Run", exact: true }).click();
  const shown = await live.evaluate(collect, Number(steps));
  await live.getByRole("button", { name: "Pause", exact: true }).click();
  const bare = await page.evaluate(runCode, BARE.replace("STEPS", steps));
  return { shown, bare: JSON.parse(bare) };
});

/** Runs in the page: the milliseconds from question to answer, of so many steps. */
function collect(root, steps) {
  return new Promise((resolve) => {
    const times = [];
    let last = root.dataset.steps;
    const observer = new MutationObserver(() => {
      if (root.dataset.steps === last) return;
      last = root.dataset.steps;
      times.push(Number(root.dataset.answerMs));
      if (times.length < steps) return;
      observer.disconnect();
      resolve(times);
    });
    observer.observe(root, { attributeFilter: ["data-values", "data-steps"] });
  });
}

/** Runs in the page: code, as a cell of its own; returns what it prints. */
async function runCode(code) {
  const order = { kind: "cell", code, name: "a bench", isSetup: false };
  const { python } = /** @type {any} */ (window).cameraLab;
  python.options.limitMs = 120_000; // a bench may run beside others
  const said = await python.run({ key: "a bench", order, parts: ["simulator"], say() {} });
  return said.outputs.map(({ text, traceback }) => text ?? String(traceback)).join("");
}
