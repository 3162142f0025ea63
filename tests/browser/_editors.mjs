// How scripts write into an editor and read from it, given the locator of its `.cm-content`.

/** Replaces the text of an editor, as a reader who pastes. */
export async function setText(page, editor, text) {
  await selectAll(page, editor);
  await editor.evaluate((element, given) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", given);
    const options = { clipboardData, bubbles: true, cancelable: true };
    element.dispatchEvent(new ClipboardEvent("paste", options));
  }, text);
}

/** The whole text of an editor, also what is scrolled away: as a reader who copies. */
export async function getText(page, editor) {
  await selectAll(page, editor);
  return editor.evaluate((element) => {
    const clipboardData = new DataTransfer();
    const options = { clipboardData, bubbles: true, cancelable: true };
    element.dispatchEvent(new ClipboardEvent("copy", options));
    return clipboardData.getData("text/plain");
  });
}

async function selectAll(page, editor) {
  await editor.focus();
  await page.keyboard.press("ControlOrMeta+A");
}
