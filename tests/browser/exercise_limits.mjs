// Exercise cells where something is missing: node exercise_limits.mjs SITE PAGE WHEELS
//
// WHEELS is a file {remote: [{name, url, sha256}], files: {url: file}}: the page is changed as if
// the build had found no wheels, and the network stands in for the CDN. Prints what was seen.

import { readFileSync } from "node:fs";
import { main } from "../../tools/browser.mjs";
import * as ui from "./_exercises.mjs";

const DATA = /(<script type="application\/json" id="python-data">)(.*?)(<\/script>)/s;

await main(async (browser, site, name, wheelsFile) => ({
  scriptless: await readWithoutScripts(browser, site, name),
  forgetful: await useWithoutStorage(browser, site, name),
  spoiled: await loadFromCdn(browser, site, name, wheelsFile, (bytes) => bytes.subarray(1)),
  unreachable: await loadFromCdn(browser, site, name, wheelsFile, () => null),
  cdn: await loadFromCdn(browser, site, name, wheelsFile, (bytes) => bytes),
}));

async function readWithoutScripts(browser, site, name) {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(new URL(`${name}.html`, site).href);
  const seen = {
    sources: await page.locator(".exercise-source").filter({ visible: true }).count(),
    checks: await page.locator(".exercise-check").filter({ visible: true }).count(),
    hints: await page.locator(".exercise-hint").filter({ visible: true }).count(),
    ours: await page.locator(".exercise, .exercise-bar").filter({ visible: true }).count(),
  };
  await context.close();
  return seen;
}

/** Storage that is switched off: every use of it throws. */
async function useWithoutStorage(browser, site, name) {
  const context = await browser.newContext();
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.addInitScript(() => {
    const refuse = () => {
      throw new DOMException("switched off", "SecurityError");
    };
    for (const method of ["getItem", "setItem", "removeItem"]) Storage.prototype[method] = refuse;
  });
  await page.goto(new URL(`${name}.html`, site).href);
  await page.waitForSelector(".exercise .cm-line");
  const [exercise] = await ui.listExercises(page);
  const before = await ui.read(page, exercise);
  await ui.button(page, exercise, "Hint").click();
  await ui.button(page, exercise, "Hint").click();
  const hints = await ui.cell(page, exercise).locator(".exercise-hints li").count();
  const after = await ui.check(page, exercise, "y = 1\n");
  await context.close();
  // the theme and the quiz have their own ways with storage: only what is ours counts here
  return { before, hints, after, errors: errors.filter((text) => /cameraLab|exercise/.test(text)) };
}

/** Opens the page as a build without wheels would have made it. */
async function loadFromCdn(browser, site, name, wheelsFile, change) {
  const { remote, files } = JSON.parse(readFileSync(wheelsFile, "utf8"));
  const context = await browser.newContext();
  const page = await context.newPage();
  const asked = [];
  await context.route("https://cdn.jsdelivr.net/**", async (route) => {
    asked.push(route.request().url());
    const bytes = change(readFileSync(files[route.request().url()]));
    if (!bytes) return route.abort();
    return route.fulfill({ body: bytes, headers: { "Access-Control-Allow-Origin": "*" } });
  });
  await page.route(`**/${name}.html`, async (route) => {
    const answer = await route.fetch();
    const text = (await answer.text()).replace(DATA, (_, head, json, tail) => {
      const data = JSON.parse(json);
      data.parts.python = data.parts.python.filter(({ name }) => !/numpy|cv2/.test(name));
      return head + JSON.stringify({ ...data, remote }) + tail;
    });
    await route.fulfill({ response: answer, body: text });
  });
  await page.goto(new URL(`${name}.html`, site).href);
  await page.waitForSelector(".exercise .cm-line");
  const [exercise] = await ui.listExercises(page);
  const before = await ui.read(page, exercise);
  const bar = await page.locator(".cells-bar p").textContent();
  const askedBefore = asked.length;
  const after = await ui.check(page, exercise);
  await context.close();
  return { before, after, askedBefore, asked, bar };
}
