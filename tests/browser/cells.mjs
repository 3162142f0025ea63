// Presses "Run all" on pages: node cells.mjs SITE PAGE...; prints {page: what was seen}.

import { close, forEach, main, openPage } from "../../tools/browser.mjs";
import { readCells, runAll } from "./_cells.mjs";

const AT_ONCE = 2; // each page has a Python of its own

await main((browser, site, ...names) =>
  forEach(names, AT_ONCE, async (name) => {
    const tab = await openPage(browser, site, name);
    const started = performance.now();
    await runAll(tab.page);
    const seen = {
      seconds: (performance.now() - started) / 1000,
      cells: await readCells(tab.page),
      exercises: await tab.page.$$eval(".exercise[data-exercise]", (all) =>
        all.map((one) => [one.dataset.exercise, one.dataset.ran]),
      ),
      said: await tab.page.locator(".cells-bar .cell-status").textContent(),
      complaints: [...tab.complaints],
    };
    await close(tab);
    return seen;
  }),
);
