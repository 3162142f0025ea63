// Elements of the page.

/**
 * Make an element inside another.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {string} className
 * @param {Element} [parent]
 */
export function make(tag, className, parent) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  parent?.append(element);
  return element;
}

/**
 * Set an attribute only where it differs: who observes it is not woken for nothing.
 * @param {Element} element
 * @param {string} name
 * @param {string} value
 */
export function setOnce(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}
