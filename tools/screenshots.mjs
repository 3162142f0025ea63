// Look at every page of the built book, as a reader with a browser would.
//
//   python tools/vendor_frontend.py --tests     (once: fetches the browser driver)
//   node tools/screenshots.mjs _build/html OUT [page ...]
//
// Writes OUT/<page>.<light|dark>.<desktop|phone>[.<part>].png and prints, per page, console errors,
// failed or foreign requests, sideways scrolling at 360 px and images without alternative
// text. Exits 1 if there is any. CHROMIUM names the browser; without a page, all of the
// table of contents are visited. The pages are opened from file://.

import { existsSync, mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(new URL("../_build/npm/", import.meta.url));
const { chromium } = require("playwright-core");

const BROWSERS = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const FLAGS = [
  "--no-sandbox",
  "--disable-background-networking",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
];
const SIZES = { desktop: { width: 1280, height: 900 }, phone: { width: 390, height: 844 } };
const THEMES = ["light", "dark"];
const NARROW = { width: 360, height: 740 };
const SETTLE_MS = 1500; // longest wait for a page whose widgets keep the network busy
const TALLEST = 7000; // px; of a taller window Chromium repeats the top
const OWN = /^(file|data|blob|about):/;

const [folder, out, ...wanted] = process.argv.slice(2);
if (!folder || !out) {
  console.error("usage: node tools/screenshots.mjs HTML_FOLDER OUT [page ...]");
  process.exit(2);
}
const root = pathToFileURL(resolve(folder) + "/");

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? BROWSERS.find(existsSync),
  args: FLAGS,
});
const pages = wanted.length ? wanted : await pagesOfContents();
mkdirSync(out, { recursive: true });
let complaints = 0;
for (const name of pages) complaints += report(name, await visit(name));
console.log(`${pages.length} pages, ${complaints} complaints, pictures in ${out}`);
await browser.close();
process.exit(complaints ? 1 : 0);

/** Names of the pages in the sidebar, in reading order. */
async function pagesOfContents() {
  const page = await browser.newPage();
  await page.goto(new URL("index.html", root).href);
  await page.waitForSelector("nav.bd-links"); // index.html redirects to the first page
  const links = await page.$$eval("nav.bd-links a.internal", (all) => all.map((a) => a.href));
  await page.close();
  const names = links.map((link) => link.split("#")[0].slice(root.href.length));
  return [...new Set(names)].map((name) => name.replace(/\.html$/, ""));
}

/** Photograph one page in both themes and sizes; return what is wrong with it. */
async function visit(name) {
  const found = new Set();
  for (const theme of THEMES) {
    for (const [size, viewport] of Object.entries(SIZES)) {
      const page = await openPage(name, theme, viewport, found);
      const file = `${name.replaceAll("/", "-")}.${theme}.${size}`;
      // tall windows: Chromium's own full-page mode loses what scrolls inside the sidebar
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      const step = Math.min(height, TALLEST);
      await page.setViewportSize({ width: viewport.width, height: step });
      for (let part = 0; part * step < height; part++) {
        await page.evaluate((top) => window.scrollTo(0, top), part * step);
        const number = height > step ? `.${part + 1}` : "";
        await page.screenshot({ path: join(out, `${file}${number}.png`) });
      }
      await page.context().close();
    }
  }
  const page = await openPage(name, "light", NARROW, found);
  for (const complaint of await page.evaluate(inspect)) found.add(complaint);
  await page.context().close();
  return found;
}

async function openPage(name, colorScheme, viewport, found) {
  const context = await browser.newContext({ viewport, colorScheme, reducedMotion: "reduce" });
  const page = await context.newPage();
  page.on("console", (m) => m.type() === "error" && found.add(`console: ${m.text()}`));
  page.on("pageerror", (error) => found.add(`script error: ${error.message}`));
  page.on("requestfailed", (r) => found.add(`failed: ${r.url()} ${r.failure()?.errorText}`));
  page.on("request", (r) => OWN.test(r.url()) || found.add(`foreign: ${r.url()}`));
  await page.goto(new URL(`${name}.html`, root).href, { waitUntil: "load" });
  await page.evaluate(() => window.MathJax?.startup?.promise);
  await page.waitForLoadState("networkidle", { timeout: SETTLE_MS }).catch(() => {});
  return page;
}

/** Runs in the page: what a phone or a screen reader would trip over. */
function inspect() {
  const said = [];
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth > clientWidth) {
    const wide = [...document.querySelectorAll("main *")].find(
      (element) => element.getBoundingClientRect().right > clientWidth + 1,
    );
    const where = wide ? `${wide.tagName.toLowerCase()}.${wide.className}` : "?";
    said.push(`sideways: ${scrollWidth - clientWidth} px too wide at ${clientWidth} px (${where})`);
  }
  for (const image of document.querySelectorAll("main article img")) {
    if (!image.alt.trim()) said.push(`no alt text: ${image.getAttribute("src")}`);
    if (!image.naturalWidth && image.loading !== "lazy") said.push(`empty image: ${image.src}`);
  }
  const views = document.querySelectorAll('script[type$="widget-view+json"]').length;
  const drawn = document.querySelectorAll(".widget-subarea > .jupyter-widgets").length;
  if (drawn < views) said.push(`widgets: ${drawn} of ${views} are drawn`);
  return said;
}

function report(name, found) {
  console.log(`${found.size ? "!!" : "ok"} ${name}`);
  for (const complaint of found) console.log(`   ${complaint}`);
  return found.size;
}
