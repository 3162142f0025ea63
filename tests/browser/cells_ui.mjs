// Uses the code cells of a page as a reader does: node cells_ui.mjs SITE PAGE; prints what was seen.

import { readFileSync } from "node:fs";
import { loadPictures, main, NARROW, newPage, openPage, require } from "../../tools/browser.mjs";
import * as ui from "./_cells.mjs";
import { getText } from "./_editors.mjs";

const ENDLESS = 'print("began")\nwhile True:\n    pass\n';
const seen = {};

await main(async (browser, site, name) => {
  const { page, complaints } = await openPage(browser, site, name, { acceptDownloads: true });
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.waitForTimeout(300); // nothing may be loaded without a click
  seen.askedBefore = asked.filter((url) => url.includes("/_static/python/"));
  await watchWords(page);

  // --- the first run, by keyboard ---
  await ui.button(page, 1, "Run").focus();
  await page.keyboard.press("Enter");
  seen.first = await ui.settle(page, 1);
  seen.focusAfterRun = await page.evaluate(() => document.activeElement.getAttribute("aria-label"));
  seen.words = await page.evaluate(() => window.seenWords);
  seen.loading = await page.evaluate(() => window.seenStatus);

  // --- a cell far below: those above run first, and the page does not move under the reader ---
  const shown = await findShown(page);
  seen.number = shown;
  const place = () => ui.button(page, shown, "Run").evaluate((b) => b.getBoundingClientRect().y);
  await loadPictures(page); // or one that comes late moves the page by itself
  await ui.button(page, shown, "Run").scrollIntoViewIfNeeded();
  const before = await place();
  seen.below = await ui.run(page, shown);
  seen.moved = (await place()) - before;
  seen.above = (await ui.readCells(page)).slice(0, shown - 1);
  seen.switched = [];
  for (const choice of ["The book's", "Yours"]) {
    await ui.cell(page, shown).getByRole("button", { name: choice, exact: true }).click();
    const { isYoursShown, isBuiltShown } = (await ui.readCells(page))[shown - 1];
    seen.switched.push([isYoursShown, isBuiltShown]);
  }
  const again = performance.now();
  await ui.run(page, 1);
  seen.laterSeconds = (performance.now() - again) / 1000;

  // --- edit, run from the editor, take back ---
  await ui.edit(page, 1, "print('by keyboard')\n7 * 6\n");
  await page.keyboard.press("ControlOrMeta+Enter");
  await ui.cell(page, 1).getByText("by keyboard", { exact: true }).last().waitFor();
  seen.edited = await ui.settle(page, 1);
  seen.editor = await ui.cell(page, 1).locator(".cm-content").getAttribute("aria-label");
  seen.marked = await ui.cell(page, 1).evaluate((one) => one.classList.contains("is-edited"));
  seen.saved = await saveNotebook(page);
  await ui.button(page, 1, "Reset").click();
  seen.reset = await readEditor(page, 1);
  await ui.button(page, 1, "Undo reset").click();
  seen.undone = await readEditor(page, 1);

  // --- what goes wrong ---
  await ui.edit(page, 1, "x = 1\nprint('so far')\n1 / 0\n");
  seen.wrong = await ui.run(page, 1);
  seen.failedLine = await ui.cell(page, 1).locator(".cm-failedLine").allTextContents();
  seen.notRun = await ui.run(page, 2);
  await ui.edit(page, 1, "import matplotlib\n");
  seen.matplotlib = await ui.run(page, 1);
  await page.route("https://cdn.jsdelivr.net/**", (route) => route.fulfill({ body: "forged" }));
  seen.forged = await ui.run(page, 1);
  await page.unroute("https://cdn.jsdelivr.net/**");
  await ui.edit(page, 1, "raise MemoryError('no room')\n");
  seen.memory = await ui.run(page, 1);
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 700));
  await ui.edit(page, 1, ENDLESS);
  seen.endless = await ui.run(page, 1);
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 600_000));
  await ui.edit(page, 1, ENDLESS.replace("began", "again"));
  await ui.button(page, 1, "Run").click();
  await ui.cell(page, 1).locator(".cell-yours").getByText("again").waitFor();
  await ui.button(page, 1, "Stop").click();
  seen.stopped = await ui.settle(page, 1);
  seen.focusAfterStop = await page.evaluate(() => document.activeElement.textContent);

  // --- looks, with an error, an edit and an output to see ---
  await ui.edit(page, 1, "print('kept')\n");
  await page.setViewportSize(NARROW);
  await waitForTabStops(page);
  seen.axe = await findAxeViolations(page);
  seen.sideways = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  seen.smallButtons = await page.$$eval(".cell-bar button, .cells-bar button", (all) =>
    all.filter((b) => b.offsetHeight && b.offsetHeight < 44).map((b) => b.textContent),
  );

  // --- what stays ---
  await page.reload();
  await page.waitForSelector(".cell-bar");
  seen.reloaded = await ui.cell(page, 1).locator(".cell-changed").textContent();
  seen.kept = await ui.run(page, 1);
  seen.print = await print(page);
  await page.getByRole("button", { name: "Reset all" }).click();
  seen.stored = await page.evaluate(() => Object.keys(localStorage).filter((k) => /cells/.test(k)));
  seen.complaints = [...complaints];
  seen.plain = await openWithoutScripts(browser, site, name);
  return seen;
});

/** Writes down what the page says from now on: to a screen reader, and beside cell 1. */
function watchWords(page) {
  return page.evaluate(() => {
    for (const [list, selector] of [
      ["seenWords", ".cells-live"],
      ["seenStatus", ".cell-status"],
    ]) {
      window[list] = [];
      const element = document.querySelector(`.cell.is-live ${selector}, body > ${selector}`);
      new MutationObserver(() => window[list].push(element.textContent)).observe(element, {
        childList: true,
      });
    }
  });
}

/** The first cell after the third whose output in the book is a picture. */
async function findShown(page) {
  const cells = await ui.readCells(page);
  return cells.findIndex(({ builtPictures }, place) => place > 2 && builtPictures) + 1;
}

function readEditor(page, number) {
  return getText(page, ui.cell(page, number).locator(".cm-content"));
}

async function saveNotebook(page) {
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as notebook" }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

/** Waits until the theme has seen the new width, and lets the keyboard reach what scrolls. */
function waitForTabStops(page) {
  return page.waitForFunction(() =>
    [...document.querySelectorAll(".cell_input pre")].every(
      (one) => one.scrollWidth <= one.clientWidth || one.tabIndex === 0,
    ),
  );
}

async function findAxeViolations(page) {
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  const found = [];
  for (const theme of ["light", "dark"]) {
    await page.evaluate((wanted) => (document.documentElement.dataset.theme = wanted), theme);
    // without preload: it asks for style sheets, which a page from a file may not
    const { violations } = await page.evaluate(() =>
      window.axe.run({ include: [[".cell.is-live"], [".cells-bar"]] }, { preload: false }),
    );
    found.push(...violations.map((v) => `${theme} ${v.id}: ${v.nodes[0].html}`));
  }
  return found;
}

/** What is on paper. */
async function print(page) {
  await page.emulateMedia({ media: "print" });
  const counts = await page.evaluate(() => {
    const count = (selector) =>
      [...document.querySelectorAll(selector)].filter((one) => one.getClientRects().length).length;
    return {
      bars: count(".cell-bar, .cells-bar"),
      yours: count(".cell-yours, .cell-changed"),
      code: count(".cell.is-live .cell_input pre"),
      cells: document.querySelectorAll(".cell.is-live").length,
      built: count(".cell.is-live > .cell_output"),
      allBuilt: document.querySelectorAll(".cell.is-live > .cell_output").length,
    };
  });
  await page.emulateMedia({ media: null });
  return counts;
}

async function openWithoutScripts(browser, site, name) {
  const { page } = await newPage(browser, site, { javaScriptEnabled: false });
  await page.goto(new URL(`${name}.html`, site).href);
  return {
    bars: await page.locator(".cell-bar, .cells-bar").count(),
    code: await page.locator(".cell_input pre").first().isVisible(),
    built: await page.locator(".cell_output").first().isVisible(),
  };
}
