// Checks the starter of the first exercise of a page in Firefox: node exercises_firefox.mjs SITE PAGE

import { require } from "../../tools/browser.mjs";

const LONGEST_MS = 180_000;
const [site, name] = process.argv.slice(2);
const { launch } = require("puppeteer-core");

const browser = await launch({ browser: "firefox", executablePath: process.env.FIREFOX });
try {
  const page = await browser.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(/** @type {Error} */ (error).message));
  page.on("console", (m) => m.type() === "error" && complaints.push(m.text()));
  await page.goto(new URL(`${name}.html`, site).href);
  await page.waitForSelector(".exercise .cm-line");
  // by keyboard: formulas that are still being set may move a button away from the mouse
  await page.focus(".exercise button.exercise-check");
  await page.keyboard.press("Enter");
  const done = '.exercise[data-state="idle"] .exercise-output';
  await page.waitForSelector(done, { timeout: LONGEST_MS });
  const text = await page.$eval(done, (element) => /** @type {HTMLElement} */ (element).innerText);
  process.stdout.write(JSON.stringify({ text, complaints }));
} finally {
  await browser.close();
}
