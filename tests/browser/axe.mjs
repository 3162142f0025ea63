// node axe.mjs SITE PAGE...: has axe-core look at every page, in both themes, with what is
// folded opened, and prints {page: {themes: {theme: [finding]}, complaints}}.

import { readFileSync } from "node:fs";

import { close, forEach, main, openPage, require } from "../../tools/browser.mjs";

const THEMES = ["light", "dark"];
const GRAVE = ["serious", "critical"];
const TABS_AT_ONCE = 2;
const source = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

await main((browser, site, ...names) =>
  forEach(names, TABS_AT_ONCE, (name) => audit(browser, site, name)),
);

/** Audits one page in both themes; the page follows what the reader's system asks for. */
async function audit(browser, site, name) {
  const tab = await openPage(browser, site, name, { colorScheme: THEMES[0] });
  const { page, complaints } = tab;
  const opened = [...complaints]; // before axe-core, which asks for the style sheets once more
  await page.evaluate(() => {
    for (const folded of document.querySelectorAll("main details")) folded.open = true;
  });
  await page.evaluate(source);
  const audits = {};
  for (const theme of THEMES) {
    await page.emulateMedia({ colorScheme: theme });
    await page.waitForFunction(
      (wanted) => document.documentElement.dataset.theme === wanted,
      theme,
    );
    audits[theme] = await page.evaluate(runAxe, GRAVE);
  }
  await close(tab);
  return { themes: audits, complaints: opened };
}

/** Runs in the page: what axe-core finds that a reader could not work around. */
async function runAxe(grave) {
  const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
  const findings = violations
    .filter(({ impact }) => grave.includes(impact))
    .map(({ id, help, nodes }) => ({
      rule: id,
      help,
      places: nodes.map((node) => `${node.target.join(" ")}: ${node.failureSummary}`),
    }));
  return { theme: document.documentElement.dataset.theme, findings };
}
