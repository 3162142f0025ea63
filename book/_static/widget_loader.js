// The widget manager, loaded once an explorer is about to be used: it weighs more than the rest of a
// page. Until then the poster of an explorer stands in its place, with a button that starts it.
// Pages that show no widget get this script once Python in the page shows one.
(() => {
  const script = /** @type {HTMLScriptElement} */ (document.currentScript);
  const here = script.src.replace(/[^/]*$/, "");
  const folder = `${here}widgets`;
  const VIEW = 'script[type="application/vnd.jupyter.widget-view+json"]';
  /** What tells that somebody is there; before it nothing is loaded. */
  const GESTURES = ["pointermove", "pointerdown", "touchstart", "wheel", "scroll", "keydown"];
  const NEAR = "100% 0px"; // a window's height away: it is there when the reader is

  /** @type {Promise<void> | null} */
  let loading = null;

  function loadScript(/** @type {string} */ file) {
    const element = document.createElement("script");
    element.src = here + file;
    return new Promise((resolve, reject) => {
      element.onload = resolve;
      element.onerror = () => reject(new Error(`a file of this page could not be loaded: ${file}`));
      document.head.append(element);
    });
  }

  /** Name the files of the book, so that the widget manager asks no other host. */
  function configure() {
    window.__jupyter_widgets_assets_path__ = `${folder}/`;
    window.requirejs.config({
      paths: {
        anywidget: `${folder}/anywidget`,
        // for its icon fonts: it finds them through the address of its own module and otherwise
        // misses them now and then
        "@jupyter-widgets": folder,
        "@jupyter-widgets/html-manager/dist": folder,
      },
    });
  }

  async function loadFiles() {
    await loadScript("widgets/require.js");
    configure();
    // never give it data-jupyter-widgets-cdn-only: its presence alone turns the CDN on
    await loadScript("widgets/embed-amd.js"); // draws every widget of the page
  }

  /** Load the manager once; what failed is tried again the next time. */
  function loadWidgets() {
    loading ??= loadFiles().catch((error) => {
      loading = null;
      throw error;
    });
    return loading;
  }

  function findPosters() {
    return [...document.querySelectorAll("img.explorer-poster")];
  }

  /** Give every explorer its place around its poster, with a button: not everybody makes gestures. */
  function makePlaces() {
    for (const poster of findPosters()) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "explorer-start";
      button.textContent = "Start the explorer";
      button.addEventListener("click", start);
      const place = document.createElement("div");
      place.className = "explorer-place"; // explorer_places.css says how high
      poster.replaceWith(place);
      place.append(button, poster);
    }
  }

  async function start() {
    const buttons = [...document.querySelectorAll(".explorer-start")];
    const say = (/** @type {string} */ text) => {
      for (const button of buttons) button.textContent = text;
    };
    say("Starting …");
    try {
      await loadWidgets();
    } catch {
      say("It could not be loaded. Try again");
    }
  }

  /** Load with the first gesture that comes near an explorer, or uses the keyboard to get there. */
  function waitForReader() {
    const stop = new AbortController();
    const begin = () => {
      stop.abort();
      start();
    };
    const near = new IntersectionObserver(
      (entries) => {
        if (entries.some((entry) => entry.isIntersecting) && !stop.signal.aborted) begin();
        if (stop.signal.aborted) near.disconnect();
      },
      { rootMargin: NEAR },
    );
    let isThere = false;
    for (const gesture of GESTURES) {
      const hear = (/** @type {Event} */ event) => {
        if (event instanceof KeyboardEvent && event.key === "Tab") begin();
        else if (!isThere) for (const one of findPosters()) near.observe(one);
        isThere = true;
      };
      document.addEventListener(gesture, hear, {
        signal: stop.signal,
        passive: true,
        capture: true,
      });
    }
  }

  window.cameraLab = { ...window.cameraLab, loadWidgets };
  document.addEventListener("DOMContentLoaded", () => {
    if (!document.querySelector(VIEW)) return;
    makePlaces();
    waitForReader();
  });
})();
