// node axe.mjs SITE PAGE...: has axe-core look at every page, in both themes, with what is
// folded opened, and prints {page: {theme: [finding]}}.

import { readFileSync } from "node:fs";

import { close, main, openPage, require } from "./_browser.mjs";

const THEMES = ["light", "dark"];
const GRAVE = ["serious", "critical"];
const TABS_AT_ONCE = 2;
const source = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

await main(async (browser, site, ...names) => {
  const results = Object.fromEntries(names.map((name) => [name, {}]));
  const queue = names.flatMap((name) => THEMES.map((theme) => [name, theme]));
  const worker = async () => {
    for (let next = queue.shift(); next; next = queue.shift()) {
      const [name, theme] = next;
      results[name][theme] = await audit(browser, site, name, theme);
    }
  };
  await Promise.all(Array.from({ length: TABS_AT_ONCE }, worker));
  return results;
});

async function audit(browser, site, name, theme) {
  const tab = await openPage(browser, site, name, { colorScheme: theme });
  const { page } = tab;
  await page.evaluate(() => {
    for (const folded of document.querySelectorAll("main details")) folded.open = true;
  });
  await page.evaluate(source);
  const findings = await page.evaluate(async (grave) => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations
      .filter(({ impact }) => grave.includes(impact))
      .map(({ id, help, nodes }) => ({
        rule: id,
        help,
        places: nodes.map((node) => `${node.target.join(" ")}: ${node.failureSummary}`),
      }));
  }, GRAVE);
  const checked = await page.evaluate(() => document.documentElement.dataset.theme);
  await close(tab);
  return { theme: checked, findings };
}
