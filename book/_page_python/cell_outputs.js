// Draws the outputs of a cell: text, pictures, tables, widgets, errors.
(() => {
  const { make } = window.cameraLab.elements;
  const WIDGET = "application/vnd.jupyter.widget-view+json";

  /**
   * @param {string} kind
   * @param {string} base64
   * @param {string} alt
   */
  function makeImage(kind, base64, alt) {
    return make("img", "", "", { src: `data:${kind};base64,${base64.replace(/\s/g, "")}`, alt });
  }

  function makeHtml(/** @type {string} */ html) {
    const element = make("div", "cell-html");
    element.innerHTML = html;
    return element;
  }

  /**
   * A drawing as a picture of its own: names in it cannot meet those of another.
   * @param {string} svg
   * @param {string} alt
   */
  function makeSvg(svg, alt) {
    const element = makeHtml(svg);
    const drawing = element.querySelector("svg");
    drawing?.setAttribute("role", "img");
    drawing?.setAttribute("aria-label", alt);
    return element;
  }

  /**
   * A live widget; it is there as soon as its manager is loaded.
   * @param {Bundle} bundle
   */
  function makeWidget(bundle) {
    const element = make("div", "cell-widget");
    window.cameraLab.widgets?.show(bundle, element);
    return element;
  }

  /**
   * The richest form that a page can show.
   * @param {Bundle} bundle
   * @param {string} alt what the book says of this picture; empty where the cell was changed
   * @returns {HTMLElement}
   */
  function makeDisplay(bundle, alt) {
    const get = (/** @type {string} */ kind) => String(bundle[kind] ?? "");
    const said = alt || get("text/plain") || "output of the cell";
    if (bundle[WIDGET] && window.cameraLab.widgets) return makeWidget(bundle);
    if (bundle["text/html"]) return makeHtml(get("text/html"));
    if (bundle["image/svg+xml"]) return makeSvg(get("image/svg+xml"), said);
    for (const kind of ["image/png", "image/jpeg"]) {
      if (bundle[kind]) return makeImage(kind, get(kind), said);
    }
    const text = get("text/markdown") || get("text/latex") || get("text/plain");
    return make("pre", "cell-text", text, { tabindex: "0" });
  }

  /**
   * @param {CellOutput} output
   * @param {string} alt
   */
  function makeOutput(output, alt) {
    if (output.output_type === "stream") return makeText(output.text, output.name === "stderr");
    if (output.output_type === "error")
      return make("pre", "cell-error", output.traceback.join("\n"));
    return makeDisplay(output.data, alt);
  }

  function makeText(/** @type {string} */ text, isWarning = false) {
    const style = isWarning ? "cell-text cell-warning" : "cell-text";
    return make("pre", style, text.replace(/\n$/, ""), { tabindex: "0" });
  }

  /**
   * Elements for all that a cell has given.
   * @param {Said} said
   * @param {string[]} alts of the pictures, in their order
   */
  function makeAll(said, alts) {
    const left = [...alts];
    const isPicture = (/** @type {CellOutput} */ output) =>
      "data" in output && Object.keys(output.data).some((kind) => kind.startsWith("image/"));
    const parts = (said.outputs ?? []).map((output) =>
      makeOutput(output, isPicture(output) ? (left.shift() ?? "") : ""),
    );
    if (said.printed) parts.push(makeText(said.printed));
    if (said.error) parts.push(make("pre", "cell-error", said.error));
    return parts;
  }

  window.cameraLab = { ...window.cameraLab, outputs: { makeAll, makeText } };
})();
