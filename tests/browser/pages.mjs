// node pages.mjs SITE PAGE...: opens every page on a narrow phone, as a first visitor, and
// prints {page: what was found}. test_pages.py and test_weight.py say what is right.

import { promisify } from "node:util";
import { gzip } from "node:zlib";

import {
  close,
  DESKTOP,
  forEach,
  loadPictures,
  main,
  NARROW,
  newPage,
  rest,
  settle,
  WIDGETS,
} from "../../tools/browser.mjs";

const packed = promisify(gzip);
const TABS_AT_ONCE = 3; // a page mostly waits
const MOST_STOPS = 200; // of the Tab key, before the article

await main((browser, site, ...names) =>
  forEach(names, TABS_AT_ONCE, (name) => visit(browser, site, name)),
);

async function visit(browser, site, name) {
  const tab = await newPage(browser, site, { viewport: NARROW });
  const { page, complaints } = tab;
  const responses = [];
  page.on("response", (response) => responses.push(response));
  await page.goto(new URL(`${name}.html`, site).href, { waitUntil: "load" });
  await rest(page);
  const weights = site.startsWith("http") ? await weigh(responses, site) : {};
  await settle(page);
  await loadPictures(page);
  const found = await page.evaluate(inspect, WIDGETS);
  await page.setViewportSize(DESKTOP);
  const keyboard = await walk(page);
  const result = { ...found, keyboard, weights, complaints: [...complaints] };
  await close(tab);
  return result;
}

/** Bytes of every response so far, gzipped, by its address: what a page costs before a gesture. */
async function weigh(responses, site) {
  const weights = {};
  for (const response of responses) {
    const name = response.url().slice(site.length).replace(/\?.*/, "");
    weights[name] = (await packed(await response.body())).length;
  }
  return weights;
}

/** Runs in the page: what a phone or a screen reader would trip over. */
function inspect(widgets) {
  const { scrollWidth, clientWidth } = document.documentElement;
  const isWide = (element) => element.getBoundingClientRect().right > clientWidth + 1;
  const describe = (element) => `${element.tagName.toLowerCase()}.${element.className}`;
  const wide = scrollWidth > clientWidth ? [...document.querySelectorAll("main *")] : [];
  const images = [...document.querySelectorAll("main article img[src]")];
  const source = (image) => image.getAttribute("src").slice(0, 80);
  return {
    tooWide: scrollWidth - clientWidth,
    wideElements: wide.filter(isWide).slice(0, 3).map(describe),
    images: images.length,
    withoutAlt: images.filter((image) => !image.alt.trim()).map(source),
    notDrawn: images.filter((image) => !image.naturalWidth).map(source),
    views: document.querySelectorAll(widgets.views).length,
    drawn: document.querySelectorAll(widgets.count).length,
    formulas: document.querySelectorAll(".math").length,
    typeset: document.querySelectorAll(".math mjx-container").length,
    formulaErrors: document.querySelectorAll("mjx-merror").length,
    icons: icons(),
  };

  /** What is drawn as a letter of an icon font: its font and its code, after all scripts. */
  function icons() {
    const found = new Set();
    for (const element of document.querySelectorAll("body, body *")) {
      for (const place of ["::before", "::after"]) {
        const { content, fontFamily } = getComputedStyle(element, place);
        const [letter] = content.match(/[\ue000-\uf8ff]/) ?? [];
        if (letter) found.add(`${fontFamily.split(",")[0]} ${letter.codePointAt(0).toString(16)}`);
      }
    }
    return [...found];
  }
}

/** Presses Tab from the top: the skip link, then through the page until its article. */
async function walk(page) {
  const focused = () =>
    page.evaluate(async () => {
      // the skip link slides in
      await Promise.allSettled(document.getAnimations().map((animation) => animation.finished));
      const element = document.activeElement;
      const box = element.getBoundingClientRect();
      const style = getComputedStyle(element);
      const ring = parseFloat(style.outlineWidth) > 0 && style.outlineStyle !== "none";
      const around = element.closest("label"); // which may show the ring of its control
      const outer = around && getComputedStyle(around).outlineStyle !== "none";
      return {
        what: `${element.tagName.toLowerCase()} ${element.textContent.trim().slice(0, 40)}`,
        link: element.getAttribute("href"),
        inArticle: Boolean(element.closest("main .bd-article, main .bd-search-container")),
        visible: box.width > 0 && box.height > 0 && box.bottom > 0 && box.top < innerHeight,
        ring: ring || Boolean(outer),
      };
    });
  await page.evaluate(() => {
    document.body.tabIndex = -1; // the search page has put the focus elsewhere
    document.body.focus();
    document.body.removeAttribute("tabindex");
    window.scrollTo(0, 0);
  });
  const stops = [];
  for (let count = 0; count < MOST_STOPS && !stops.at(-1)?.inArticle; count++) {
    await page.keyboard.press("Tab");
    stops.push(await focused());
  }
  return {
    skips: stops.some(({ link }) => link === "#main-content"),
    hidden: stops.filter((stop) => !stop.visible).map((stop) => stop.what),
    ringless: stops.filter((stop) => !stop.ring).map((stop) => stop.what),
    reachesArticle: stops.at(-1).inArticle,
    stops: stops.length,
  };
}
