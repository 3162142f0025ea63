// node explorer_places.mjs SITE PAGE...: prints {explorer: {narrow, wide}}, the pixels that each
// takes once it is drawn. explorer_places.py keeps them free for it.

import { close, main, openPage, PHONE } from "../browser.mjs";

const SIZES = { narrow: PHONE, wide: { width: 1366, height: 800 } };

await main(async (browser, site, ...names) => {
  /** @type {Record<string, Record<string, number>>} */
  const places = {};
  for (const name of names) {
    const tab = await openPage(browser, site, name, { viewport: PHONE });
    for (const [size, viewport] of Object.entries(SIZES)) {
      await tab.page.setViewportSize(viewport);
      await tab.page.waitForTimeout(500); // explorers draw again after a change of width
      for (const [kind, height] of await tab.page.evaluate(measure)) {
        places[kind] ??= {};
        places[kind][size] = Math.min(Number(height), places[kind][size] ?? Infinity);
      }
    }
    await close(tab);
  }
  return places;
});

/** Runs in the page: every explorer by its name, and how high it is. */
function measure() {
  return [...document.querySelectorAll(".widget-subarea:has(.explorer-box)")].map((area) => [
    area.querySelector(".explorer").getAttribute("data-explorer"),
    String(Math.round(area.getBoundingClientRect().height)),
  ]);
}
