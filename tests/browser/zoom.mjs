// node zoom.mjs SITE: enlarges pictures on a phone, by finger and by keyboard, copies code whose
// lines wrap, and prints what happened. test_zoom.py says what is right.

import { readFileSync } from "node:fs";

import {
  close,
  DESKTOP,
  loadPictures,
  main,
  openPage,
  PHONE,
  require,
} from "../../tools/browser.mjs";

const PAGE = "book/step4_color";
const VIEW = ".zoom-view[open]";
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

await main(async (browser, site) => ({
  phone: await useOnPhone(browser, site),
  late: await drawLate(browser, site),
  desktop: await lookOnDesktop(browser, site),
}));

async function useOnPhone(browser, site) {
  const tab = await openPage(browser, site, PAGE, { viewport: PHONE, hasTouch: true });
  const { page, complaints } = tab;
  await loadPictures(page);
  const address = page.url();
  const picture = page.locator("img.has-zoom").first();
  const button = page.locator(".zoom-button").first();
  const small = (await picture.boundingBox()).width;

  await picture.tap();
  await page.waitForSelector(VIEW);
  const large = await page.evaluate(inspectView, VIEW);
  await page.evaluate(axe);
  const barriers = await page.evaluate(async () => {
    const { violations } = await window.axe.run(".zoom-view", { preload: false });
    return violations.map(({ id }) => id);
  });
  await page.locator(`${VIEW} img`).tap();
  const afterTap = await page.locator(".zoom-view").count();

  await button.focus();
  await page.keyboard.press("Enter");
  await page.waitForSelector(VIEW);
  const focusInside = await page.evaluate(() => document.activeElement.className);
  await page.keyboard.press("Escape");
  const afterEscape = await page.locator(".zoom-view").count();
  const focusAfter = await page.evaluate(() => document.activeElement.className);
  const copied = await page.evaluate(copyCode);
  const stayed = page.url() === address;
  await close(tab);
  return {
    ...{ small, large, barriers, afterTap, focusInside, afterEscape, focusAfter, copied, stayed },
    complaints: [...complaints],
  };
}

/** Runs in the page: the picture that is shown large, and whether all of it can be reached. */
function inspectView(selector) {
  const image = document.querySelector(`${selector} img`);
  const place = image.parentElement;
  const original = document.querySelector("img.has-zoom");
  return {
    width: image.getBoundingClientRect().width,
    scrolls: place.scrollWidth > place.clientWidth,
    fromLeft: image.getBoundingClientRect().left,
    sameAlt: image.alt === original.alt,
  };
}

/** Runs in the page: what a reader copies of each block of code, and what stands there. */
function copyCode() {
  for (const folded of document.querySelectorAll("details")) folded.open = true;
  const differing = [];
  let wrapped = 0;
  for (const pre of document.querySelectorAll(".cell_input pre")) {
    if (!pre.offsetWidth) continue;
    const selection = window.getSelection();
    selection.selectAllChildren(pre);
    if (selection.toString().trimEnd() !== pre.textContent.trimEnd()) {
      differing.push([selection.toString(), pre.textContent]);
    }
    wrapped += pre.querySelectorAll(".code-line").length;
  }
  return { differing, wrapped };
}

/** Puts a picture into a cell after the page was opened, as the reader's own run does. */
async function drawLate(browser, site) {
  const tab = await openPage(browser, site, PAGE, { viewport: PHONE });
  const { page } = tab;
  const buttons = await page.evaluate(async () => {
    const draw = async (width) => {
      const canvas = Object.assign(document.createElement("canvas"), { width, height: 100 });
      const place = document.createElement("div");
      place.className = "cell-yours";
      const image = new Image();
      place.append(image);
      document.querySelector(".bd-article section").append(place);
      image.src = canvas.toDataURL();
      await image.decode();
      await new Promise((done) => setTimeout(done)); // after the event that says so
      return place.querySelectorAll(".zoom-button").length;
    };
    return { large: await draw(1200), small: await draw(100) };
  });
  await close(tab);
  return buttons;
}

async function lookOnDesktop(browser, site) {
  const tab = await openPage(browser, site, PAGE, { viewport: DESKTOP });
  await loadPictures(tab.page);
  const seen = await tab.page.locator(".zoom-button:visible").count();
  await close(tab);
  return { seen };
}
