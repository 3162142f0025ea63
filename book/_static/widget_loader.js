// Runs between require.js and embed-amd.js: on pages that show a widget, and on others once Python
// in the page shows one. It names the vendored files, so that the widget manager asks no CDN. The
// two "@jupyter-widgets" lines are for its icon fonts: it finds them through the address of its own
// module and otherwise misses them now and then.
(() => {
  const script = /** @type {HTMLScriptElement} */ (document.currentScript);
  const here = script.src.replace(/[^/]*$/, "");
  const folder = `${here}widgets`;
  window.__jupyter_widgets_assets_path__ = `${folder}/`;
  window.requirejs.config({
    paths: {
      anywidget: `${folder}/anywidget`,
      "@jupyter-widgets": folder,
      "@jupyter-widgets/html-manager/dist": folder,
    },
  });

  // Widgets typeset their labels through MathJax 2; answer with MathJax 3, which has
  // loaded by the time the document is parsed (its script is deferred).
  function answerForHub() {
    const mathjax = window.MathJax;
    const loaded = mathjax?.startup?.promise;
    if (!loaded) return;
    mathjax.Hub = {
      Queue: (/** @type {[any, any, Element]} */ [, , element]) =>
        loaded.then(() => mathjax.typesetPromise([element])),
    };
  }
  if (document.readyState === "loading") {
    document.addEventListener("DOMContentLoaded", answerForHub);
  } else {
    answerForHub();
  }
})();
