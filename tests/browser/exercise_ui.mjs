// Uses the exercise cells of a page as a reader does: node exercise_ui.mjs SITE PAGE IMPORTS
//
// IMPORTS is a file {good: [file, ...], bad: [file, ...]} of progress files. Prints what was seen.

import { readFileSync } from "node:fs";
import { main, NARROW, openPage, require } from "../../tools/browser.mjs";
import * as ui from "./_exercises.mjs";

const ENDLESS = "while True:\n    pass\n";
const seen = {};

await main(async (browser, site, name, importsFile) => {
  const imports = JSON.parse(readFileSync(importsFile, "utf8"));
  const { page, complaints } = await openPage(browser, site, name, { acceptDownloads: true });
  const [first, second] = await ui.listExercises(page);
  const starter = await ui.getCode(page, first);
  seen.names = [first, second];

  // --- before and while Python loads ---
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.waitForTimeout(300); // nothing may be loaded without a click
  seen.askedBefore = asked.filter((url) => url.includes("/_static/python/"));
  await watchStatus(page, first);
  await ui.button(page, first, "Check").click();
  // On a quick machine all may be loaded between this check and the next, unseen.
  await page.waitForFunction(() => window.seenStatus.some((text) => text.includes(" MB")));
  await ui.button(page, first, "Stop").click();
  seen.stoppedEarly = await ui.settle(page, first);
  await Promise.all([first, second].map((one) => ui.button(page, one, "Check").click()));
  seen.queued = [await ui.settle(page, first), await ui.settle(page, second)];
  seen.progressOfLoading = await page.evaluate(() => window.seenStatus);

  // --- code that does not end ---
  seen.limit = await page.evaluate(() => window.cameraLab.python.options.limitMs);
  seen.endlessByDefault = await ui.check(page, first, ENDLESS);
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 500));
  seen.endless = await ui.check(page, first, ENDLESS);
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 600_000));
  await ui.button(page, first, "Check").click();
  await ui.waitUntilItRuns(page, first);
  await ui.button(page, first, "Stop").click();
  seen.stopped = await ui.settle(page, first);
  seen.focusAfterStop = await page.evaluate(() => document.activeElement.textContent);
  seen.afterStop = await ui.check(page, first, "print('alive')\nx = [][1]\n");

  // --- hints, reset ---
  for (let i = 0; i < 4; i++) await ui.button(page, second, "Hint").click();
  seen.hints = await ui.cell(page, second).locator(".exercise-hints li").allTextContents();
  seen.reset = await useReset(page, first, starter);
  seen.keyboard = await useKeyboard(page, second);

  // --- progress as a file ---
  seen.exported = await exportProgress(page);
  seen.imports = [];
  for (const file of [...imports.bad, ...imports.good]) {
    await page.locator('.exercise-bar input[type="file"]').setInputFiles(file);
    const status = page.locator('.exercise-bar [role="status"]');
    await page.waitForFunction(() =>
      /Imported|no progress/.test(document.querySelector(".exercise-bar p").textContent),
    );
    seen.imports.push({
      said: await status.textContent(),
      count: await page.locator(".exercise-count").textContent(),
      exported: await exportProgress(page),
    });
  }

  // --- looks ---
  await page.setViewportSize(NARROW);
  seen.axe = await findAxeViolations(page);
  seen.sideways = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  seen.smallButtons = await page.$$eval(".exercise button, .exercise-bar button", (all) =>
    all.filter((b) => b.offsetParent && b.offsetHeight < 44).map((b) => b.textContent),
  );

  // --- what stays ---
  await ui.setCode(page, first, "kept = 'as it was'\n");
  await page.reload();
  await page.waitForSelector(".exercise .cm-line");
  seen.reloaded = { code: await ui.getCode(page, first), ...(await ui.read(page, first)) };
  seen.reloadedCount = await page.locator(".exercise-count").textContent();
  seen.print = await print(page, first);
  seen.complaints = [...complaints];
  return seen;
});

/** Writes down what the status line of an exercise says from now on. */
function watchStatus(page, name) {
  return page.evaluate((wanted) => {
    window.seenStatus = [];
    const status = document.querySelector(wanted);
    new MutationObserver(() => window.seenStatus.push(status.textContent)).observe(status, {
      childList: true,
    });
  }, `.exercise[data-exercise="${name}"] .exercise-status`);
}

async function useReset(page, name, starter) {
  const before = await ui.getCode(page, name);
  await ui.button(page, name, "Reset").click();
  const isStarter = (await ui.getCode(page, name)) === starter;
  await ui.button(page, name, "Undo reset").click();
  const isBack = (await ui.getCode(page, name)) === before;
  await ui.button(page, name, "Reset").click();
  await ui.setCode(page, name, "x = 1\n"); // an edit ends the chance to undo
  const buttons = await ui.cell(page, name).getByRole("button").allTextContents();
  return { isStarter, isBack, buttons };
}

/** Indents, leaves the editor, and checks without the mouse. */
async function useKeyboard(page, name) {
  await ui.setCode(page, name, "");
  const editor = ui.cell(page, name).locator(".cm-content");
  const label = await editor.getAttribute("aria-label");
  await editor.focus();
  await page.keyboard.press("Tab");
  await page.keyboard.type("pass");
  const indented = await ui.getCode(page, name);
  await page.keyboard.press("Escape");
  await page.waitForTimeout(2500); // longer than CodeMirror itself waits for the next key
  await page.keyboard.press("Tab");
  const next = await page.evaluate(() => document.activeElement.textContent);
  await page.keyboard.press("Shift+Tab");
  const back = await editor.evaluate((element) => element === document.activeElement);
  await ui.setCode(page, name, "print('by keyboard')\n");
  await page.keyboard.press("ControlOrMeta+Enter");
  // not the state "busy": a check may be over before anybody has looked
  await ui.cell(page, name).getByText("Your code has no function").waitFor();
  return { label, indented, next, back, said: await ui.settle(page, name) };
}

async function exportProgress(page) {
  const waiting = page.waitForEvent("download");
  await page.locator(".exercise-bar").getByRole("button", { name: "Export" }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

async function findAxeViolations(page) {
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  await page.locator(".exercise:not(.is-completion) .exercise-output").first().waitFor();
  const found = [];
  // without preload: it asks for style sheets, which a page from a file may not
  for (const theme of ["light", "dark"]) {
    await page.evaluate((wanted) => (document.documentElement.dataset.theme = wanted), theme);
    const { violations } = await page.evaluate(() =>
      window.axe.run({ include: [[".exercise"], [".exercise-bar"]] }, { preload: false }),
    );
    for (const { id, impact, nodes } of violations) {
      if (/serious|critical/.test(impact))
        found.push(`${theme}: ${id}: ${nodes[0].html.slice(0, 200)}`);
    }
  }
  return found;
}

/** What stands on paper. */
async function print(page, name) {
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  const shown = (selector) =>
    page.$$eval(selector, (all) => all.some((element) => element.getClientRects().length > 0));
  return {
    editors: await shown(".exercise, .exercise-bar"),
    hints: await shown(".exercise-hint"),
    code: await page.locator(`.exercise-source-${name} pre`).innerText(),
  };
}
