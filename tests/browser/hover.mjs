// node hover.mjs SITE: points at the pictures and plots of depth range and stereo, each on a page
// that holds nothing else, and prints what is marked. test_hover.py says what is right.

import { main, newPage, waitForFrames } from "../../tools/browser.mjs";

const PICTURE = ".explorer-stage canvas[role=application]";

await main(async (browser, site) => ({
  depth: await watch(browser, site, "depth_range", lookAtDepth),
  stereo: await watch(browser, site, "stereo", lookAtStereo),
}));

async function watch(browser, site, name, look) {
  const { page, complaints } = await newPage(browser, site);
  await page.goto(new URL(`${name}.html`, site).href);
  await page.locator(".explorer[data-state=ready]").waitFor();
  const seen = await look(page);
  await page.context().close();
  return { ...seen, complaints: [...complaints] };
}

/** Moves the pointer to a pixel of the picture, and returns what is marked then. */
async function pointAt(page, [u, v], size) {
  const box = await page.locator(PICTURE).boundingBox();
  const share = [(u + 0.5) / size[0], (v + 0.5) / size[1]];
  await page.mouse.move(box.x + share[0] * box.width, box.y + share[1] * box.height);
  return read(page);
}

/** Moves the pointer to a share of the width of a plot. */
async function pointInPlot(page, number, share) {
  const plot = page.locator(".explorer-side svg[role=slider]").nth(number);
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  await page.mouse.move(box.x + share * box.width, box.y + 0.5 * box.height);
  return read(page);
}

async function read(page) {
  await waitForFrames(page);
  return page.evaluate(() => {
    const all = (selector) => [...document.querySelectorAll(selector)];
    const isShown = (one) =>
      Boolean(one) && !one.hidden && getComputedStyle(one).display !== "none";
    const [root] = all(".explorer");
    const tag = all(".explorer-tag:not(.explorer-eye-name)")[0];
    return {
      pixel: host.get("pixel"),
      saves: host.saves,
      values: JSON.parse(root.dataset.values),
      text: all(".explorer-readout")[0].textContent,
      tag: isShown(tag) ? tag.textContent : null,
      lines: all(".explorer-pixel-line").map((one) => one.getAttribute("d")),
      barMark: all(".explorer-colorbar-mark").map((one) => isShown(one) && one.style.left)[0],
      kinds: all(".is-here").map((one) => one.textContent),
      squares: all(".explorer-stage .explorer-right-mark:not(.explorer-key-mark)").map(
        (one) => isShown(one) && one.style.left,
      ),
      point: all(".explorer-point").map((one) => [
        one.getAttribute("cx"),
        one.getAttribute("cy"),
      ])[0],
      lit: findLit(all(".explorer-spotlight")[0]),
      sliders: all("svg[role=slider]").map((one) => one.getAttribute("aria-valuetext")),
      drawMs: Number(root.dataset.drawMs),
    };
    function findLit(canvas) {
      if (!isShown(canvas)) return null;
      const { width, height } = canvas;
      const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
      const lit = [];
      for (let i = 0; i < width * height; i++) if (data[4 * i + 3] === 0) lit.push(i);
      return lit;
    }
  });
}

async function press(page, key) {
  await page.keyboard.press(key);
  return read(page);
}

async function lookAtDepth(page) {
  const size = await sizeOf(page);
  const seen = { first: await read(page) };
  seen.pointed = await pointAt(page, [30, 50], size);
  seen.other = await pointAt(page, [60, 20], size);
  seen.window = await pointAt(page, [20, 3], size);
  await page.mouse.move(1, 1);
  seen.left = await read(page);
  await page.locator(PICTURE).focus();
  seen.keys = await press(page, "ArrowRight");
  seen.bar = await pointInPlot(page, 0, 0.35);
  seen.lastRaw = await pointInPlot(page, 1, 0.955);
  seen.beside = await pointInPlot(page, 1, 0.01);
  await page.mouse.move(1, 1);
  await page.locator("svg[role=slider]").first().focus();
  seen.keyBar = await press(page, "ArrowRight");
  seen.nextBar = await press(page, "ArrowRight");
  seen.escaped = await press(page, "Escape");
  await page.evaluate(() => host.set("range_m", [0.9, 1.2]));
  seen.narrow = await pointAt(page, [30, 58], size);
  return seen;
}

async function lookAtStereo(page) {
  const size = await sizeOf(page);
  const seen = { first: await read(page) };
  seen.pointed = await pointAt(page, [250, 30], size);
  seen.near = await pointAt(page, [100, 220], size);
  await page.mouse.move(1, 1);
  seen.left = await read(page);
  seen.curve = await pointInPlot(page, 0, 0.66);
  await page.mouse.move(1, 1);
  seen.away = await read(page);
  await page.locator("svg[role=slider]").focus();
  seen.keys = await press(page, "ArrowRight");
  return seen;
}

function sizeOf(page) {
  return page.locator(PICTURE).evaluate(({ width, height }) => [width, height]);
}
