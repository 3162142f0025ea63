// Elements of SVG. Colors come from the style sheet.

const SVG_SPACE = "http://www.w3.org/2000/svg";

/**
 * Make an SVG element inside another.
 * @param {Element} parent
 * @param {string} tag
 * @param {Attributes} attributes
 * @param {string} text
 */
export function addShape(parent, tag, attributes = {}, text = "") {
  const element = document.createElementNS(SVG_SPACE, tag);
  setShape(element, attributes);
  if (text) element.textContent = text;
  parent.append(element);
  return /** @type {SVGElement} */ (element);
}

/**
 * Set attributes of an SVG element.
 * @param {Element} element
 * @param {Attributes} attributes
 */
export function setShape(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}
