// node videos.mjs SITE: plays the video of a page by keyboard alone, looks at it on paper, and prints
// what happened. test_videos.py says what is right.

import { close, main, newPage, openPage, PHONE } from "../../tools/browser.mjs";

const PAGE = "book/following";
const PLAYER = "video.video-player";

await main(async (browser, site) => ({
  played: await play(browser, site),
  paper: await print(browser, site),
  withoutScripts: await lookWithoutScripts(browser, site),
}));

async function play(browser, site) {
  const tab = await openPage(browser, site, PAGE, { viewport: PHONE });
  const { page, complaints } = tab;
  const player = page.locator(PLAYER);
  await player.scrollIntoViewIfNeeded();
  const before = await player.evaluate(inspect);
  await player.focus();
  await page.keyboard.press("Space");
  await page.waitForFunction(
    (selector) => document.querySelector(selector).currentTime > 0,
    PLAYER,
  );
  await page.keyboard.press("Space");
  await page.waitForFunction((selector) => document.querySelector(selector).paused, PLAYER);
  const after = await player.evaluate(inspect);
  const sideways = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  await close(tab);
  return { before, after, sideways, complaints: [...complaints] };
}

/** Runs in the page: the state of the player. */
function inspect(player) {
  return {
    loaded: player.readyState,
    seconds: player.duration,
    width: player.videoWidth,
    name: player.getAttribute("aria-label"),
    focused: document.activeElement === player,
    problem: player.error?.message ?? null,
  };
}

async function print(browser, site) {
  const tab = await openPage(browser, site, PAGE);
  await tab.page.emulateMedia({ media: "print" });
  const seen = await tab.page.evaluate(() => ({
    player: document.querySelector("video.video-player").offsetWidth,
    poster: document.querySelector("img.video-poster").offsetWidth,
  }));
  await close(tab);
  return seen;
}

async function lookWithoutScripts(browser, site) {
  const tab = await newPage(browser, site, { javaScriptEnabled: false });
  await tab.page.goto(new URL(`${PAGE}.html`, site).href);
  const seen = await tab.page.locator(PLAYER).isVisible();
  await close(tab);
  return seen;
}
