// node explorers.mjs SITE PAGE FRAMES: drags every slider of every explorer of a page through its
// range and prints how long each frame took to compute and draw, in milliseconds.

import { close, main, openPage } from "../browser.mjs";

const HARDEST = /radius|open|close/i; // sliders that stay at their end while the others move

await main(async (browser, site, name, frames) => {
  const tab = await openPage(browser, site, name);
  const { page } = tab;
  const found = [];
  for (const box of await page.locator(".explorer-box").all()) {
    await box.scrollIntoViewIfNeeded();
    await box.locator('.explorer[data-state="ready"]').waitFor();
    for (const handle of await box.locator(".noUi-handle").all()) {
      if (HARDEST.test(await handle.getAttribute("aria-label"))) {
        await handle.focus();
        await page.keyboard.press("End");
      }
    }
    found.push(await box.evaluate(dragAll, { frames: Number(frames), hardest: HARDEST.source }));
  }
  await close(tab);
  return found;
});

/** Runs in the page: moves each handle from end to end with key presses, one per frame. */
async function dragAll(box, { frames, hardest }) {
  const root = box.querySelector(".explorer");
  const nextFrame = () => new Promise(requestAnimationFrame);
  const times = [];
  for (const handle of box.querySelectorAll(".noUi-handle")) {
    if (new RegExp(hardest, "i").test(handle.getAttribute("aria-label"))) continue;
    const press = (key) =>
      handle.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    for (const [start, key] of [
      ["Home", "PageUp"],
      ["End", "PageDown"],
    ]) {
      press(start);
      for (let frame = 0; frame < frames / 2; frame++) {
        await nextFrame();
        delete root.dataset.drawMs;
        press(key);
        await nextFrame();
        await nextFrame();
        if (root.dataset.drawMs) times.push(Number(root.dataset.drawMs)); // else it stood at its end
      }
    }
  }
  return { name: root.dataset.explorer, parameters: JSON.parse(root.dataset.parameters), times };
}
