// node site.mjs SITE: uses what every page shares - theme switch, skip link, print - as
// a reader would, and prints what happened. test_site.py says what is right.

import { close, main, newPage, openPage } from "../../tools/browser.mjs";

const PAGE = "book/step2_intrinsics";
const PAGE_WITH_FOLDS = "book/conventions";
const STORE_MS = 1000; // Chromium writes down a choice a moment later; no reader reloads sooner

await main(async (browser, site) => ({
  theme: await switchTheme(browser, site),
  skip: await skip(browser, site),
  paper: await putOnPaper(browser, site),
}));

/** Clicks the switch until the theme is dark, then reloads and goes to another page. */
async function switchTheme(browser, site) {
  const tab = await openPage(browser, site, PAGE, { colorScheme: "light" });
  const { page, complaints } = tab;
  const look = () =>
    page.evaluate(() => ({
      theme: document.documentElement.dataset.theme,
      paper: getComputedStyle(document.body).backgroundColor,
    }));
  const before = await look();
  const seen = [];
  for (let clicks = 0; clicks < 3 && (await look()).theme !== "dark"; clicks++) {
    await page.click(".theme-switch-button:visible");
    seen.push((await look()).theme);
  }
  const after = await look();
  await page.waitForTimeout(STORE_MS);
  await page.reload();
  const reloaded = await look();
  await page.goto(new URL("book/glossary.html", site).href);
  const elsewhere = await look();
  await close(tab);
  // leaving a page ends what it still loads, which is nobody's fault
  const lasting = [...complaints].filter((one) => !one.endsWith("net::ERR_ABORTED"));
  return { before, seen, after, reloaded, elsewhere, complaints: lasting };
}

/** Tab, Enter: the focus leaves the header for the content. */
async function skip(browser, site) {
  const tab = await newPage(browser, site);
  const { page } = tab;
  await page.goto(new URL(`${PAGE}.html`, site).href);
  await page.keyboard.press("Tab");
  const first = await page.evaluate(() => document.activeElement.textContent.trim());
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  const inMain = await page.evaluate(() => Boolean(document.activeElement.closest("main")));
  await close(tab);
  return { first, inMain };
}

/** Prints a dark page, and looks what would be on the paper. */
async function putOnPaper(browser, site) {
  const tab = await openPage(browser, site, PAGE_WITH_FOLDS, { colorScheme: "dark" });
  const { page } = tab;
  await page.evaluate(() => {
    const folded = document.createElement("details");
    folded.innerHTML = "<summary>More</summary><p id='folded'>Folded text</p>";
    document.querySelector("article").append(folded);
  });
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await page.pdf(); // loads the pictures that wait to be seen
  const paper = await page.evaluate(() => {
    const sees = (selector) =>
      [...document.querySelectorAll(selector)].some((e) => e.checkVisibility());
    const { color, backgroundColor } = getComputedStyle(document.body);
    return {
      sidebars: sees(".bd-sidebar-primary, .bd-sidebar-secondary, .bd-header-article"),
      article: sees("article.bd-article p"),
      unfolded: document.getElementById("folded").getBoundingClientRect().height > 0,
      color,
      backgroundColor,
      missing: [...document.images].filter((i) => i.checkVisibility() && !i.naturalWidth).length,
    };
  });
  await close(tab);
  return paper;
}
