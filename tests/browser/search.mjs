// node search.mjs SITE: searches as a reader does - on the search page, from another page, by
// keyboard, on a phone, without scripts - and prints what happened. test_search.py says what is
// right.

import { readFileSync } from "node:fs";

import { close, main, newPage, openPage, PHONE, require, settle } from "../../tools/browser.mjs";

const QUERIES = ["intrinsic", "hue", "how do I convert depth to meters", "disparty", "xylophonist"];
const FIELD = ".bd-search-container input[type=search]";
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

await main(async (browser, site) => ({
  answers: await ask(browser, site),
  fromPage: await searchFromPage(browser, site),
  phone: await searchOnPhone(browser, site),
  scriptless: await lookWithoutScripts(browser, site),
}));

/** Types queries one after the other, and lists what is shown and said. */
async function ask(browser, site) {
  const tab = await openPage(browser, site, "search");
  const { page, complaints } = tab;
  await page.evaluate(() => {
    const status = document.getElementById("search-status");
    window.said = [];
    const listen = () => window.said.push(status.textContent);
    new MutationObserver(listen).observe(status, { childList: true, characterData: true });
  });
  const focused = await page.evaluate((field) => document.activeElement.matches(field), FIELD);
  const found = {};
  for (const query of QUERIES) {
    await page.fill(FIELD, query);
    await page.press(FIELD, "Enter");
    await page.waitForFunction((q) => window.said.at(-1)?.includes(q), query);
    await page.waitForTimeout(400); // longer than the pause after typing: it must not search again
    found[query] = await page.evaluate(() => ({
      said: window.said.splice(0),
      pages: [...document.querySelectorAll(".search-title a")].map((a) => a.getAttribute("href")),
      excerpts: document.querySelectorAll(".search-excerpt").length,
      marked: [...document.querySelectorAll(".search-excerpt mark")].map((m) => m.innerText),
    }));
  }
  const isLive = await page.$eval("#search-status", (e) => e.getAttribute("role") === "status");
  await page.fill(FIELD, "depth");
  await page.waitForSelector(".search-more");
  const some = await page.locator(".search-page").count();
  await page.focus(".search-more");
  await page.keyboard.press("Enter");
  const all = await page.locator(".search-page").count();
  const next = await page.evaluate(() => document.activeElement.closest(".search-page") !== null);
  await close(tab);
  return { found, focused, isLive, more: { some, all, next }, complaints: [...complaints] };
}

/** Ctrl+K on a page, a word, Enter; then the first result by keyboard, its marks, Escape, Back. */
async function searchFromPage(browser, site) {
  const tab = await openPage(browser, site, "book/start");
  const { page, complaints } = tab;
  await page.keyboard.press("Control+k");
  await page.waitForSelector("#pst-search-dialog[open]");
  const covered = await page.evaluate(() => {
    const input = document.querySelector("#pst-search-dialog input");
    const icon = document.querySelector("#pst-search-dialog i").getBoundingClientRect();
    const text =
      input.getBoundingClientRect().left + parseFloat(getComputedStyle(input).paddingLeft);
    return icon.right - text;
  });
  await page.keyboard.type("hue");
  await Promise.all([page.waitForURL(/search\.html\?q=/), page.keyboard.press("Enter")]);
  await page.waitForSelector(".search-page");
  await page.focus(FIELD);
  await page.keyboard.press("Tab");
  const link = await page.locator(":focus").getAttribute("href");
  await Promise.all([page.waitForURL(/highlight=/), page.keyboard.press("Enter")]);
  await settle(page);
  const count = () => page.locator("mark.search-mark").count();
  // an answer that is covered has its marks too
  const marked = await page.$$eval("mark.search-mark", (all) => all.map((m) => m.textContent));
  const outside = await page.locator("body mark:not(article mark), script mark").count();
  const text = await page.locator("article").innerText();
  await page.keyboard.press("Escape");
  const left = await count();
  const isSame = (await page.locator("article").innerText()) === text;
  await page.goBack();
  await page.waitForSelector(".search-page");
  const back = await page.inputValue(FIELD);
  await close(tab);
  const lasting = [...complaints].filter((one) => !one.endsWith("net::ERR_ABORTED"));
  return { covered, link, marked, outside, left, isSame, back, complaints: lasting };
}

/** Results on a phone: nothing sideways, and what axe-core says in both themes. */
async function searchOnPhone(browser, site) {
  const tab = await newPage(browser, site, { viewport: PHONE, colorScheme: "light" });
  const { page } = tab;
  await page.goto(new URL("search.html?q=depth_to_meters", site).href);
  await page.waitForSelector(".search-page");
  await page.evaluate(axe);
  const themes = {};
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme });
    await page.waitForFunction((name) => document.documentElement.dataset.theme === name, theme);
    themes[theme] = await page.evaluate(async () => {
      const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
      return violations.map(({ id, nodes }) => `${id}: ${nodes[0].target}`);
    });
  }
  const tooWide = await page.evaluate(() => {
    const { scrollWidth, clientWidth } = document.documentElement;
    return scrollWidth - clientWidth;
  });
  await close(tab);
  return { themes, tooWide };
}

/** What a reader without scripts is told. */
async function lookWithoutScripts(browser, site) {
  const tab = await newPage(browser, site, { javaScriptEnabled: false });
  await tab.page.goto(new URL("search.html", site).href);
  const text = await tab.page.locator(".bd-search-container").innerText();
  await close(tab);
  return text;
}
