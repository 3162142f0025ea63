// node matching.mjs SITE: uses the matching view on a page that holds nothing else: its places, the
// pointer over its picture and its curve, its noise. test_matching_view.py says what is right.

import { main, newPage, waitForFrames } from "../../tools/browser.mjs";

const PICTURE = ".explorer-stage canvas[role=application]";
const CURVE = "svg[role=slider]";

await main(async (browser, site) => {
  const { page, complaints } = await newPage(browser, site);
  await page.goto(new URL("matching.html", site).href);
  await page.locator(".explorer[data-state=ready]").waitFor();
  const seen = { first: await read(page) };
  seen.pointed = await pointAt(page, [250, 150]);
  await page.mouse.move(1, 1);
  seen.left = await read(page);
  seen.curve = await pointInCurve(page, 0.5);
  await page.mouse.move(1, 1);
  await page.locator(CURVE).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  seen.keys = await read(page);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "pole" }).press("Enter");
  seen.place = await read(page);
  seen.saves = seen.place.saves - seen.keys.saves;
  await page.evaluate(() => {
    host.set("search", 20);
    host.set("noise", 7);
  });
  seen.noisy = await read(page);
  seen.pictures = await page.evaluate(readPictures);
  await page.evaluate(() => host.set("pixel", [2, 3]));
  seen.edge = await read(page);
  return { ...seen, complaints: [...complaints] };
});

async function pointAt(page, [u, v]) {
  const canvas = page.locator(PICTURE);
  const { x, y, width, height } = await canvas.boundingBox();
  const size = await canvas.evaluate((one) => [one.width, one.height]);
  await page.mouse.move(x + ((u + 0.5) / size[0]) * width, y + ((v + 0.5) / size[1]) * height);
  return read(page);
}

async function pointInCurve(page, share) {
  const plot = page.locator(CURVE);
  await plot.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await plot.boundingBox();
  await page.mouse.move(x + share * width, y + height / 2);
  return read(page);
}

async function read(page) {
  await waitForFrames(page);
  return page.evaluate(() => {
    const all = (selector) => [...document.querySelectorAll(selector)];
    const isShown = (one) => Boolean(one) && getComputedStyle(one).display !== "none";
    const [root] = all(".explorer");
    const boxes = all(".explorer-box-mark").map((one) => {
      if (!isShown(one)) return null;
      // what lies inside the border, in pixels of the picture
      const picture = one.parentElement.querySelector("canvas");
      const holder = picture.getBoundingClientRect();
      const scale = picture.width / holder.width;
      const { left, top } = one.getBoundingClientRect();
      const from = [left + one.clientLeft - holder.left, top + one.clientTop - holder.top];
      const size = [one.clientWidth, one.clientHeight];
      return [...from, ...size].map((place) => place * scale);
    });
    return {
      pixel: host.get("pixel"),
      saves: host.saves,
      values: JSON.parse(root.dataset.values),
      text: all(".explorer-readout")[0].textContent,
      tag: all(".explorer-tag:not(.explorer-eye-name)").filter(isShown)[0]?.textContent ?? null,
      boxes,
      chosen: all("svg[role=slider]")[0].getAttribute("aria-valuetext"),
      captions: all(".explorer-window span").map((one) => one.textContent),
      right: all(".explorer-size.is-right").map((one) => Number(one.textContent)),
      search: all(".explorer-search-line").map((one) => isShown(one))[0],
      closeUp: all(".explorer-close-up svg")[0].getAttribute("aria-label"),
    };
  });
}

/** Runs in the page: the gray levels of the left picture, and of the strip of the right one. */
function readPictures() {
  return [...document.querySelectorAll(".explorer-stage canvas")].map((canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    return { height, gray: Array.from({ length: width * height }, (_, i) => data[4 * i]) };
  });
}
