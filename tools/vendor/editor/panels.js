// Strips above and below the code: a sentence and a button.

/**
 * Make a strip.
 * @param {string} className
 * @param {() => void} onClick
 */
export function makePanel(className, onClick) {
  const dom = document.createElement("div");
  dom.className = `cm-note ${className}`;
  const text = document.createElement("span");
  const button = document.createElement("button");
  button.type = "button";
  button.addEventListener("click", onClick);
  dom.append(text, button);
  return { dom, text, button };
}

/** Change a text only where it differs: a screen reader would say it again. */
export function say(/** @type {Element} */ element, /** @type {string} */ text) {
  if (element.textContent !== text) element.textContent = text;
}
