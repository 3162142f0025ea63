// Times the cells of a page: node tools/bench/page_cells.mjs SITE PAGE PLAIN LOOP TURNS
//
// Presses Run on the first cell of a fresh page, then runs the code PLAIN so many times, then LOOP
// once, in the session of the page. Prints JSON: milliseconds of each, and what LOOP has printed.

import { main, openPage } from "../browser.mjs";

await main(async (browser, site, name, plain, loop, turns) => {
  const { page } = await openPage(browser, site, name);
  const first = await page.evaluate(pressRun);
  const later = [];
  for (let i = 0; i < Number(turns); i++) later.push(await page.evaluate(runCode, plain));
  const last = await page.evaluate(runCode, loop);
  return { first, later: later.map(({ ms }) => ms), printed: last.printed };
});

/** Runs in the page: from the click on Run until the cell says how long it took. */
function pressRun() {
  const cell = /** @type {HTMLElement} */ (document.querySelector(".cell.is-live"));
  return new Promise((resolve) => {
    const started = performance.now();
    const observer = new MutationObserver(() => {
      if (cell.dataset.state !== "idle") return;
      observer.disconnect();
      // the output is drawn in the same task as the state
      requestAnimationFrame(() => resolve(performance.now() - started));
    });
    observer.observe(cell, { attributeFilter: ["data-state"] });
    /** @type {HTMLElement} */ (cell.querySelector(".cell-run")).click();
  });
}

/** Runs in the page: code, as a cell of its own. */
async function runCode(code) {
  const started = performance.now();
  const order = { kind: "cell", code, name: "a bench", isSetup: false };
  const { python } = /** @type {any} */ (window).cameraLab;
  const said = await python.run({ key: "a bench", order, parts: ["simulator"], say() {} });
  const printed = said.outputs.map(({ text, traceback }) => text ?? String(traceback)).join("");
  return { ms: performance.now() - started, printed };
}
