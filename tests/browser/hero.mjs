// node hero.mjs SITE: uses the first screen as a reader would: with the mouse, by keyboard, on
// four screens, without WebGL, without scripts and on paper. test_hero.py says what is right.

import { close, launch, main, newPage, PHONE, rest, waitForFrames } from "../../tools/browser.mjs";

const PAGE = "book/index";
const LAPTOP = { width: 1366, height: 650 };
const SCREENS = [LAPTOP, PHONE, { width: 844, height: 390 }, { width: 1920, height: 1080 }];
const READY = ".hero[data-state]";
const LIFTED = '.hero[data-state="lifted"]';
const FLAT = '.hero[data-state="flat"]';
const HIDE_MARKS = ".hero .explorer-cloud-marks { visibility: hidden }";
const NO_3D = ["--disable-gpu", "--disable-3d-apis"];

await main(async (browser, site) => ({
  screens: await onAllScreens(browser, site),
  mouse: await useMouse(browser, site),
  keys: await useKeys(browser, site),
  smooth: await liftSmoothly(browser, site),
  plain: await without3d(site),
  withoutScripts: await withoutScripts(browser, site),
  paper: await putOnPaper(browser, site),
}));

async function open(browser, site, options = {}) {
  const tab = await newPage(browser, site, { viewport: LAPTOP, ...options });
  await tab.page.goto(new URL(`${PAGE}.html`, site).href, { waitUntil: "load" });
  await tab.page.waitForSelector(READY); // the data come while nobody waits
  return tab;
}

/** How the first screen fits, flat and once it is lifted, in both themes. */
async function onAllScreens(browser, site) {
  const seen = [];
  for (const [place, viewport] of SCREENS.entries()) {
    const colorScheme = place % 2 ? "dark" : "light";
    const tab = await open(browser, site, { viewport, colorScheme });
    const before = await tab.page.evaluate(measure);
    await dragStage(tab.page, 60, 20);
    const after = await tab.page.evaluate(measure);
    seen.push({ viewport, before, after, complaints: [...tab.complaints] });
    await close(tab);
  }
  return seen;
}

/** Runs in the page. */
function measure() {
  const find = (selector) => document.querySelector(selector).getBoundingClientRect();
  const { scrollWidth, clientWidth } = document.documentElement;
  const [stage, links] = [find(".hero-stage"), find(".hero + p a:last-of-type")];
  const { width, height, top, bottom } = stage;
  return {
    state: document.querySelector(".hero").dataset.state,
    stage: { width, height, top, bottom },
    article: find(".bd-article").width,
    buttonsBottom: find(".hero-bar").bottom,
    linksBottom: links.bottom,
    titleBottom: find(".bd-article h1").bottom,
    tooWide: scrollWidth - clientWidth,
  };
}

async function dragStage(page, dx, dy) {
  const { x, y, width, height } = await page.locator(".hero-stage").boundingBox();
  const [left, top] = [x + width / 2, y + height / 2];
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + dx, top + dy, { steps: 4 });
  await page.mouse.up();
  await waitForFrames(page);
}

/** Clicks, in parts of the photo's height from its middle; returns what is read there. */
async function clickStage(page, u, v) {
  const { x, y, width, height } = await page.locator(".hero-stage").boundingBox();
  await page.mouse.click(x + width / 2 + u * height, y + height / 2 + v * height);
  return read(page);
}

async function read(page) {
  await waitForFrames(page);
  return page.locator(".hero-reading").textContent();
}

function getOrbit(page) {
  return page.evaluate(() => document.querySelector(".hero").heroModel.get("orbit"));
}

function getState(page) {
  return page.evaluate(() => ({ ...document.querySelector(".hero").dataset }));
}

async function useMouse(browser, site) {
  const tab = await open(browser, site);
  const { page, complaints } = tab;
  const seen = { flat: await getState(page), help: await read(page) };
  // pixels (u, v) of 640 x 320
  const places = { ball: [188, 159], table: [120, 290], sky: [225, 20] };
  seen.clicks = {};
  for (const [name, [u, v]] of Object.entries(places)) {
    const text = await clickStage(page, (u + 0.5 - 320) / 320, (v + 0.5 - 160) / 320);
    seen.clicks[name] = { pixel: [u, v], text };
  }
  seen.stillFlat = await getState(page);
  await page.addStyleTag({ content: HIDE_MARKS });
  const shoot = async () => (await page.locator(".hero-stage").screenshot()).toString("base64");
  await page.mouse.move(0, 0);
  seen.photo = await shoot();
  await dragStage(page, 80, 10);
  seen.lifted = await getState(page);
  seen.turned = await getOrbit(page);
  await page.evaluate(() => {
    const { heroModel } = document.querySelector(".hero");
    heroModel.set("orbit", heroModel.get("start").orbit);
  });
  await page.addStyleTag({ content: ".hero .hero-stage img { visibility: hidden }" });
  await waitForFrames(page);
  seen.cloud = await shoot(); // from where the camera stands
  seen.nothing = await clickStage(page, -0.9, -0.48).then(() => clickStage(page, -0.3, -0.45));
  await page.getByRole("button", { name: "Reset" }).click();
  await page.waitForSelector(FLAT);
  seen.reset = await getOrbit(page);
  seen.start = await page.evaluate(() => document.querySelector(".hero").heroModel.get("start"));
  seen.complaints = [...complaints];
  await close(tab);
  return seen;
}

async function useKeys(browser, site) {
  const tab = await open(browser, site);
  const { page } = tab;
  const stage = page.locator(".hero-stage");
  await stage.focus();
  const seen = { name: await stage.getAttribute("aria-label"), orbits: {} };
  for (const key of ["ArrowLeft", "ArrowUp", "+", "-"]) {
    await page.keyboard.press(key);
    await waitForFrames(page);
    seen.orbits[key] = await getOrbit(page);
  }
  seen.afterKeys = await getState(page);
  await page.keyboard.press("Home");
  await page.waitForSelector(FLAT);
  seen.home = await getOrbit(page);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter"); // the second button
  seen.ball = await read(page);
  seen.role = await page.locator(".hero-reading").getAttribute("role");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Enter"); // the first
  await page.waitForSelector(LIFTED);
  seen.lifted = await getOrbit(page); // this reader asks for less motion: it is there at once
  await close(tab);
  return seen;
}

/** Who has not asked for less motion sees it turn: there are places on the way. */
async function liftSmoothly(browser, site) {
  const tab = await open(browser, site, { reducedMotion: "no-preference" });
  const { page } = tab;
  const seen = await page.evaluate(async () => {
    const { heroModel } = document.querySelector(".hero");
    const degrees = [heroModel.get("orbit").azimuth_deg];
    /** @type {HTMLElement} */ (document.querySelector('.hero button[value="lift"]')).click();
    for (let same = 0; same < 5 || degrees.length < 10; ) {
      await new Promise(requestAnimationFrame);
      const now = heroModel.get("orbit").azimuth_deg;
      same = now === degrees.at(-1) ? same + 1 : 0;
      degrees.push(now);
    }
    return degrees;
  });
  await close(tab);
  return seen;
}

/** In a browser that has no WebGL. */
async function without3d(site) {
  const browser = await launch(NO_3D);
  const tab = await open(browser, site);
  await dragStage(tab.page, 80, 0);
  const seen = { ...(await getState(tab.page)), complaints: [...tab.complaints] };
  await browser.close();
  return seen;
}

/** Runs in the page: what is to be seen of the figure. */
function look() {
  const sees = (selector) =>
    [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility()).length;
  const image = document.querySelector(".hero img");
  return {
    images: sees(".hero img"),
    opacity: getComputedStyle(image).opacity,
    drawn: image.naturalWidth,
    alt: image.alt,
    captions: sees(".hero figcaption"),
    buttons: sees(".hero-bar button"),
    links: [...document.querySelectorAll(".hero + p a")].map((one) => one.getAttribute("href")),
  };
}

async function withoutScripts(browser, site) {
  const tab = await newPage(browser, site, { javaScriptEnabled: false });
  await tab.page.goto(new URL(`${PAGE}.html`, site).href);
  await rest(tab.page);
  const seen = await tab.page.evaluate(look);
  await close(tab);
  return seen;
}

/** Printed while it is lifted. */
async function putOnPaper(browser, site) {
  const tab = await open(browser, site);
  await dragStage(tab.page, 80, 0);
  await tab.page.emulateMedia({ media: "print" });
  const seen = await tab.page.evaluate(look);
  const canvases = await tab.page.evaluate(
    () =>
      [...document.querySelectorAll(".hero canvas")].filter((one) => one.checkVisibility()).length,
  );
  await close(tab);
  return { ...seen, canvases };
}
