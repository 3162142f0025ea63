// node firefox.mjs SITE PAGE...: opens pages in Firefox, over WebDriver BiDi, and prints
// {page: what was found}. FIREFOX names the browser.

import { require, WIDGETS } from "../../tools/browser.mjs";

const { default: puppeteer } = await import(require.resolve("puppeteer-core"));

const OWN = /^(file|data|blob|about):/;
const NARROW = { width: 360, height: 740 };
const WAIT_MS = 60_000; // a first start makes a profile
const WIDGETS_MS = 20_000;
const QUIET_MS = 300; // no request for so long: all has come

const [site, ...names] = process.argv.slice(2);
const browser = await puppeteer.launch({
  browser: "firefox",
  executablePath: process.env.FIREFOX,
  headless: true,
  timeout: WAIT_MS,
});
const results = {};
try {
  for (const name of names) results[name] = await visit(name);
} finally {
  await browser.close();
}
process.stdout.write(JSON.stringify(results));

async function visit(name) {
  const page = await browser.newPage();
  const complaints = new Set();
  const isOwn = (address) => OWN.test(address) || address.startsWith(site);
  page.on("console", (m) => m.type() === "error" && complaints.add(`console: ${m.text()}`));
  page.on("pageerror", (error) => complaints.add(`script error: ${error.message}`));
  page.on("request", (r) => isOwn(r.url()) || complaints.add(`foreign: ${r.url()}`));
  page.on("requestfailed", (r) => complaints.add(`failed: ${r.url()}`));
  await page.setViewport(NARROW);
  await page.goto(new URL(`${name}.html`, site).href, { waitUntil: "load", timeout: WAIT_MS });
  await page.keyboard.press("Tab"); // explorers start with the first gesture
  const drawn = ({ views, count }) =>
    document.querySelectorAll(count).length >= document.querySelectorAll(views).length;
  await page.waitForFunction(drawn, { timeout: WIDGETS_MS }, WIDGETS).catch(() => {});
  await page.waitForNetworkIdle({ idleTime: QUIET_MS, timeout: WAIT_MS }).catch(() => {});
  const found = await page.evaluate(inspect, WIDGETS);
  await page.close();
  return { ...found, complaints: [...complaints] };
}

/** Runs in the page. */
async function inspect(widgets) {
  const fonts = [...document.fonts].filter(({ family }) => family.includes("Lab Book"));
  await Promise.allSettled(fonts.map((font) => font.load()));
  const images = [...document.querySelectorAll("main article img[src]")];
  for (const image of images) image.loading = "eager";
  await Promise.allSettled(images.map((image) => image.decode()));
  const { scrollWidth, clientWidth } = document.documentElement;
  return {
    tooWide: scrollWidth - clientWidth,
    pictures: images.length,
    views: document.querySelectorAll(widgets.views).length,
    drawn: document.querySelectorAll(widgets.count).length,
    formulas: document.querySelectorAll(".math").length,
    typeset: document.querySelectorAll(".math mjx-container").length,
    notDrawn: images.filter((image) => !image.naturalWidth).map((image) => image.src),
    iconFonts: fonts.map(({ status }) => status),
  };
}
