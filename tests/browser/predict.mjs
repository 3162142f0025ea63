// Predicts as readers do: node predict.mjs SITE; prints what was seen. test_predict.py says what is
// right.

import { close, main, newPage, PHONE, require, settle, uncover } from "../../tools/browser.mjs";

const seen = { complaints: [] };
const AXE = require.resolve("axe-core/axe.min.js");
const KEY = "camera-lab-book.progress";

/** Opens a page with all its covers. */
async function open(browser, site, address, options = {}) {
  const tab = await newPage(browser, site, options);
  await tab.page.goto(new URL(address, site).href, { waitUntil: "load" });
  await settle(tab.page);
  return tab;
}

/** What a reader sees of a prediction: texts of the box, and how many parts it covers or shows. */
const read = (page, id) =>
  page.evaluate((name) => {
    const box = document.getElementById(`predict-${name}`);
    const isSeen = (one) => one.checkVisibility({ contentVisibilityAuto: true });
    const parts = [...document.querySelectorAll(`.predict-answer-${name}`)].flatMap((part) => {
      const inside = part.matches(".predict-cell") ? part.querySelector(".cell_output") : part;
      return inside?.firstElementChild ? [inside.firstElementChild] : [];
    });
    return {
      result: box.querySelector(".predict-result")?.textContent ?? null,
      buttons: [...box.querySelectorAll("button")].filter(isSeen).map((one) => one.textContent),
      seen: parts.filter(isSeen).length,
      parts: parts.length,
      notes: [...document.querySelectorAll(".predict-note")].filter(
        (one) => isSeen(one) && one.querySelector("a").hash === `#predict-${name}`,
      ).length,
      codes: [
        ...document.querySelectorAll(`.predict-cell.predict-answer-${name} .cell_input pre`),
      ].filter(isSeen).length,
      focus: document.activeElement?.className ?? "",
      live: box.querySelectorAll("[aria-live], [role=status], [role=alert]").length,
    };
  }, id);

const kept = (page) => page.evaluate((key) => JSON.parse(localStorage.getItem(key)), KEY);
const box = (page, id) => page.locator(`#predict-${id}`);
const press = (page, id, name) => box(page, id).getByRole("button", { name }).click();

await main(async (browser, site) => {
  const audit = async (page) => {
    if (!(await page.evaluate(() => "axe" in window))) await page.addScriptTag({ path: AXE });
    const { violations } = await page.evaluate(() => window.axe.run(".predict, .predict-note"));
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.target)}`);
  };

  // --- choices ---
  const tab = await open(browser, site, "book/step1_camera.html");
  const { page } = tab;
  seen.before = await read(page, "stale");
  seen.empty = await press(page, "stale", "Commit").then(() => read(page, "stale"));
  await box(page, "stale").getByRole("radio").first().focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter"); // commits, as in any form
  seen.right = await read(page, "stale");
  seen.other = await read(page, "pan");
  await box(page, "pan").getByRole("radio").nth(1).check();
  await press(page, "pan", "Commit");
  seen.wrong = await read(page, "pan");
  await press(page, "one-step", "Show anyway");
  seen.shown = await read(page, "one-step");
  seen.kept = await kept(page);
  await page.reload();
  await settle(page);
  seen.reloaded = [await read(page, "stale"), await read(page, "one-step")];
  await press(page, "stale", "Cover again");
  seen.again = await read(page, "stale");
  seen.keptAgain = await kept(page);
  seen.complaints.push(...tab.complaints);

  // --- what leads into a covered part ---
  await page.goto(new URL("book/step1_camera.html#fig-step1-stale", site).href);
  await settle(page);
  seen.address = await read(page, "stale");
  seen.addressKept = (await kept(page)).predictions.stale ?? null;
  await close(tab);

  // --- a number, on a phone, in the dark ---
  const phone = await open(browser, site, "book/step2_intrinsics.html", {
    viewport: PHONE,
    colorScheme: "dark",
  });
  const number = box(phone.page, "middle").getByRole("textbox");
  await number.fill("three");
  await press(phone.page, "middle", "Commit");
  seen.noNumber = await read(phone.page, "middle");
  seen.complaints.push(...phone.complaints); // before axe-core, which asks for style sheets anew
  seen.covered = await audit(phone.page);
  await number.fill("3,0");
  await press(phone.page, "middle", "Commit");
  seen.high = await read(phone.page, "middle");
  await press(phone.page, "middle", "Cover again");
  await number.fill("2.5");
  await press(phone.page, "middle", "Commit");
  seen.exact = await read(phone.page, "middle");
  seen.answered = await audit(phone.page);
  seen.sideways = await phone.page.evaluate(
    () => document.documentElement.scrollWidth - innerWidth,
  );
  seen.explorer = await openExplorer(phone.page);
  seen.targets = await phone.page.$$eval(".predict-form :is(button, label)", (all) =>
    Math.min(...all.filter((one) => one.checkVisibility()).map((one) => one.offsetHeight)),
  );
  await close(phone);

  // --- found by the search of the browser ---
  seen.found = await findText(browser, site);

  // --- on paper, and without scripts ---
  const paper = await open(browser, site, "book/step1_camera.html");
  await paper.page.emulateMedia({ media: "print" });
  seen.paper = await read(paper.page, "stale");
  await close(paper);
  const plain = await open(browser, site, "book/step1_camera.html", { javaScriptEnabled: false });
  seen.plain = {
    choices: await box(plain.page, "stale").locator("ol > li").allInnerTexts(),
    isAnswerSeen: await plain.page.getByText("The picture is sharp, bright and wrong").isVisible(),
    isSaidSeen: await box(plain.page, "stale").locator(".predict-said").isVisible(),
  };
  await close(plain);

  // --- every box of the book covers what is in view below it ---
  seen.book = {};
  for (const name of ["background", "start", "step1_camera", "step2_intrinsics", "step3_depth"]) {
    seen.book[name] = await countCovers(browser, site, name);
  }
  for (const name of ["projection_matrix", "step4_color", "step5_cloud", "step6_view"]) {
    seen.book[name] = await countCovers(browser, site, name);
  }
  for (const name of ["following", "stereo"]) {
    seen.book[name] = await countCovers(browser, site, name);
  }
  return seen;
});

/** An explorer that was covered has its size once it is open. */
async function openExplorer(page) {
  await press(page, "twice-the-angle", "Show anyway");
  await settle(page);
  const explorer = page.locator(".predict-answer-twice-the-angle canvas").first();
  await explorer.scrollIntoViewIfNeeded();
  await page.waitForTimeout(300);
  return explorer.evaluate((one) => one.getBoundingClientRect().width);
}

/** Follows an address that asks for words of a covered part: the browser finds them as Ctrl+F does. */
async function findText(browser, site) {
  const words = encodeURIComponent("picture is sharp, bright and wrong");
  const tab = await open(browser, site, `book/step1_camera.html#:~:text=${words}`);
  await tab.page.waitForTimeout(500);
  const found = [await read(tab.page, "stale"), (await kept(tab.page)) ?? "nothing"];
  await close(tab);
  return found;
}

/** For each box of a page: how many parts are covered, and how many are in view, before and after. */
async function countCovers(browser, site, name) {
  const tab = await open(browser, site, `book/${name}.html`);
  const ids = await tab.page.$$eval(".admonition.predict", (all) => all.map((one) => one.id));
  const counts = {};
  for (const id of ids.map((one) => one.replace("predict-", ""))) {
    const before = await read(tab.page, id);
    counts[id] = [before.parts, before.seen, before.notes];
  }
  await uncover(tab.page);
  for (const id of Object.keys(counts)) counts[id].push((await read(tab.page, id)).seen);
  await close(tab);
  return counts;
}
