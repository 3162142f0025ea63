// Uses the editor of an exercise as a reader does: node editor.mjs SITE PAGE; prints what was seen.

import { main, openPage, PHONE, require } from "../../tools/browser.mjs";
import * as ui from "./_exercises.mjs";

const LEAVING = ["return 1", "pass", "raise ValueError", "break", "continue"];
const UNFINISHED = ["return (1,", "return [", "returned = 1", "x = 'return'", "return 1 + \\"];
const TABBED = "def f(x):\n    if x:\n\treturn 1\n\t# so\n    return 2\n";
const FOREVER = "print('kept')\nwhile True:\n    pass\n";
const seen = {};

await main(async (browser, site, name) => {
  const { page, complaints } = await openPage(browser, site, name);
  const [first, second] = await ui.listExercises(page);
  seen.docstring = await useDocstring(page, first);
  seen.completion = await useCompletion(page, first);
  seen.taking = await takeNames(page, first);
  seen.dedent = await makeLines(page, first);
  seen.tabs = await useTabs(page, first);
  seen.failed = await failInLine(page, first);
  seen.printed = await stopChecks(page, first);
  seen.axe = await findViolations(page, first);
  seen.phone = await lookOnPhone(page, first);
  seen.twoTabs = await useTwoTabs(page, second);
  seen.complaints = [...complaints];
  return seen;
});

function panel(page, name, text) {
  return ui.cell(page, name).locator(".cm-note").getByRole("button", { name: text });
}

function readLine(page, name, selector) {
  const found = ui.cell(page, name).locator(selector);
  return found.evaluateAll((all) => all.map((one) => one.textContent));
}

/** Puts the caret behind a text that replaces the code. */
async function write(page, name, text) {
  await ui.setCode(page, name, text);
  await page.keyboard.press("ControlOrMeta+End");
}

/** Folded at first, opened and folded by keyboard; the text never changes. */
async function useDocstring(page, name) {
  const starter = await page.locator(`.exercise-source-${name} pre`).textContent();
  const texts = [await ui.getCode(page, name)];
  const editor = ui.cell(page, name).locator(".cm-content");
  const button = ui.cell(page, name).locator(".cm-docstring button");
  const look = async () => ({
    button: await button.textContent(),
    expanded: await button.getAttribute("aria-expanded"),
    lines: await editor.locator(".cm-line").count(),
    summary: await editor.locator(".cm-line", { hasText: '"""' }).first().textContent(),
  });
  const looks = [await look()];
  const height = await ui
    .cell(page, name)
    .locator(".cm-editor")
    .evaluate((element) => element.offsetHeight);
  await editor.focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Shift+Tab");
  for (let i = 0; i < 2; i++) {
    await page.keyboard.press("Enter");
    looks.push(await look());
    texts.push(await ui.getCode(page, name));
    await button.focus();
  }
  await ui.setCode(page, name, "x = 1\n");
  const hidden = await button.isHidden();
  await ui.button(page, name, "Reset").click();
  looks.push(await look());
  texts.push(await ui.getCode(page, name));
  const said = await ui.check(page, name);
  return { starter, texts, looks, height, hidden, said };
}

/** What is offered after some typing. */
async function useCompletion(page, name) {
  const offered = {};
  const head = "import numpy as np\nimport cv2\ndef g(depth_raw, far):\n    ratio = far\n    ";
  for (const typed of ["dept", "rati", "prin", "retu", "np.arct", "np.linalg.in", "cv2.inR"]) {
    offered[typed] = await offer(page, name, head, typed);
  }
  offered.comment = await offer(page, name, head, "# np.arct", false);
  offered.text = await offer(page, name, head, "'prin", false);
  return offered;
}

async function offer(page, name, head, typed, isOffered = true) {
  await write(page, name, head);
  await page.keyboard.type(typed);
  const options = page.locator(".cm-tooltip-autocomplete li");
  if (isOffered) await options.first().waitFor();
  else await page.waitForTimeout(500); // time enough for a list to open
  const texts = await options.allTextContents();
  await page.keyboard.press("Escape");
  return texts;
}

/** Keys while a list is open: what each leaves in the editor, and where the focus is then. */
async function takeNames(page, name) {
  const after = {};
  const plans = {
    Enter: ["Enter"],
    "ArrowDown Enter": ["ArrowDown", "Enter"],
    Tab: ["Tab"],
    "Escape Tab": ["Escape", "Tab"],
  };
  for (const [plan, keys] of Object.entries(plans)) {
    await write(page, name, "import numpy as np\n");
    await page.keyboard.type("np.arctan");
    await page.locator(".cm-tooltip-autocomplete li").first().waitFor();
    await page.waitForTimeout(200); // sooner, a key is not meant for the list
    for (const key of keys) await page.keyboard.press(key);
    const focus = await page.evaluate(() => document.activeElement.textContent.slice(0, 20));
    after[plan] = { focus, code: await ui.getCode(page, name) };
  }
  return after;
}

/** How far the line after each statement is indented. */
async function makeLines(page, name) {
  const lines = {};
  for (const statement of [...LEAVING, ...UNFINISHED]) {
    await write(page, name, `for x in y:\n    if x:\n        ${statement}`);
    await page.keyboard.press("Enter");
    await page.keyboard.type("z");
    const last = (await ui.getCode(page, name)).split("\n").at(-1);
    lines[statement] = last.length - 1;
  }
  await write(page, name, "def f(x):\n    return x");
  await page.keyboard.press("Enter");
  await page.keyboard.type("z");
  lines.function = (await ui.getCode(page, name)).split("\n").at(-1).length - 1;
  return lines;
}

async function useTabs(page, name) {
  const note = ui.cell(page, name).locator(".cm-mixed [role='status']");
  await write(page, name, TABBED.replaceAll("\t", "    "));
  const before = await note.count();
  await write(page, name, TABBED);
  const said = await note.textContent();
  const marked = await readLine(page, name, ".cm-tabbedLine");
  await panel(page, name, "Use spaces").click();
  const code = await ui.getCode(page, name);
  const after = await note.count();
  await write(page, name, `x = """\n\ta\n"""\nif x:\n    y = 1\n`);
  return { before, said, marked, code, after, inText: await note.count() };
}

/** Errors of Check, Run and of the call itself, and how their mark goes. */
async function failInLine(page, name) {
  const look = async (said) => ({
    status: said.status,
    marked: await readLine(page, name, ".cm-failedLine"),
    gutter: await readLine(page, name, ".cm-failedGutter"),
  });
  const check = await look(await ui.check(page, name, "x = 1\ny = x +\n"));
  await panel(page, name, "Go to line 2").click();
  await page.keyboard.type("1");
  const edited = await readLine(page, name, ".cm-failedLine");
  const written = await ui.getCode(page, name);
  const call = `def ${name}(*args):\n    a = 1\n    return a.nothing\n`;
  const called = await look(await ui.check(page, name, call));
  await ui.setCode(page, name, "def f():\n    return 1 / 0\n\nf()\n");
  await ui.button(page, name, "Run").click();
  const run = await look(await ui.settle(page, name));
  await ui.button(page, name, "Reset").click();
  const reset = await readLine(page, name, ".cm-failedLine");
  return { check, edited, written, called, run, reset };
}

/** What a check printed that was stopped, by the reader or by the limit. */
async function stopChecks(page, name) {
  await ui.setCode(page, name, FOREVER);
  await ui.button(page, name, "Check").click();
  await ui.waitUntilItRuns(page, name);
  await page.waitForTimeout(500); // for the print
  await ui.button(page, name, "Stop").click();
  const stopped = await ui.settle(page, name);
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 1500));
  const late = await ui.check(page, name, FOREVER.replace("kept", "late"));
  await page.evaluate(() => (window.cameraLab.python.options.limitMs = 20_000));
  return { stopped, late };
}

/** With a list open, a line marked and tabs mixed, in both themes. */
async function findViolations(page, name) {
  await ui.check(page, name, `${TABBED}1 / 0\n`);
  const found = [];
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  for (const theme of ["light", "dark"]) {
    await page.evaluate((wanted) => (document.documentElement.dataset.theme = wanted), theme);
    await ui.check(page, name, `${TABBED}import numpy as np\n`);
    await page.keyboard.press("ControlOrMeta+End");
    await ui.cell(page, name).locator(".cm-content").focus();
    await page.keyboard.type("np.arct");
    await page.locator(".cm-tooltip-autocomplete li").first().waitFor();
    await page.keyboard.press("ArrowDown");
    const { violations } = await page.evaluate(() =>
      window.axe.run({ include: [[".exercise"]] }, { preload: false }),
    );
    for (const { id, impact, nodes } of violations) {
      if (/serious|critical/.test(impact)) {
        found.push(`${theme}: ${id}: ${nodes[0].html.slice(0, 200)} ${nodes[0].failureSummary}`);
      }
    }
    await page.keyboard.press("Escape");
  }
  return found;
}

async function lookOnPhone(page, name) {
  await ui.button(page, name, "Reset").click();
  await page.setViewportSize(PHONE);
  const look = await ui.cell(page, name).evaluate((element) => {
    const scroller = element.querySelector(".cm-scroller");
    const buttons = [...element.querySelectorAll("button")].filter((one) => one.offsetParent);
    return {
      sideways: scroller.scrollWidth - scroller.clientWidth,
      small: buttons.filter((one) => one.offsetHeight < 44).map((one) => one.textContent),
    };
  });
  return look;
}

/** The same exercise in two tabs: each hears of the other, and no text is lost. */
async function useTwoTabs(page, name) {
  const other = await page.context().newPage();
  await other.goto(page.url());
  await other.waitForSelector(".exercise .cm-line");
  const box = (tab) => ui.cell(tab, name).locator(".exercise-tabs");
  const press = (tab, text) => box(tab).getByRole("button", { name: text }).click();
  const seen = { quiet: await box(page).isHidden() };

  await ui.setCode(page, name, "a = 1\n");
  await box(other).waitFor();
  seen.said = await box(other).locator("p").textContent();
  seen.status = (await ui.read(other, name)).status;
  seen.untouched = await ui.getCode(other, name);

  // both write: what stands in neither editor but one is put aside
  await ui.setCode(other, name, "b = 2\n");
  await box(page).waitFor();
  await page.close();
  await other.reload();
  await other.waitForSelector(".exercise .cm-line");
  seen.reloaded = { code: await ui.getCode(other, name), isOffered: await box(other).isVisible() };
  await press(other, "Take the other code");
  seen.taken = await ui.getCode(other, name);
  await press(other, "Take mine back");
  seen.back = await ui.getCode(other, name);
  await press(other, "Keep this code");
  seen.isGone = await box(other).isHidden();

  // the other tab takes the same text: nothing to choose any more
  const third = await other.context().newPage();
  await third.goto(other.url());
  await third.waitForSelector(".exercise .cm-line");
  await ui.setCode(third, name, "c = 3\n");
  await box(other).waitFor();
  await press(other, "Take the other code");
  seen.agreed = [await ui.getCode(other, name), await box(third).isHidden()];
  return seen;
}
