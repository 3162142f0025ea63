// The search page: shows what search_engine.js finds, while a reader types and for the query that
// the address brings. The count is said once per query.
(() => {
  const PAGES_SHOWN = 8;
  const TYPING_MS = 250; // a pause in which results are worth showing
  const KINDS = {
    chapter: "Chapter",
    exercise: "Exercises",
    glossary: "Glossary",
    help: "When in doubt",
    reading: "Reading",
    reference: "Reference",
  };

  const get = (/** @type {string} */ selector) =>
    /** @type {HTMLElement} */ (document.querySelector(selector));
  const field = /** @type {HTMLInputElement} */ (get(".bd-search-container form.bd-search input"));
  const status = get("#search-status");
  const results = get("#search-results");
  const index = window.cameraLab?.searchIndex;
  if (!index || !window.MiniSearch) {
    status.textContent = "The index of this book did not load. Reload the page to try again.";
    return;
  }
  const engine = window.cameraLab.searchEngine.makeEngine(index, window.MiniSearch);
  let shown = "";

  /** Search for what stands in the field, unless that is what is shown. */
  function show() {
    const query = field.value.trim();
    if (query === shown) return;
    shown = query;
    remember(query);
    const answer = engine.search(query);
    status.textContent = query ? describe(query, answer) : "";
    draw(answer.pages, PAGES_SHOWN);
  }

  /**
   * @param {string} query
   * @param {Answer} answer
   */
  function describe(query, { pages, corrected }) {
    if (!pages.length) return `Nothing found for “${query}”. Try other words, or fewer.`;
    const count = pages.length === 1 ? "1 page" : `${pages.length} pages`;
    const notes = [...corrected].map(([typed, near]) => {
      const meant = near.map((word) => `“${word}”`).join(" or ");
      return meant
        ? `“${typed}” is not in the book, ${meant} is.`
        : `“${typed}” is not in the book.`;
    });
    return [`${count} found for “${query}”, best first.`, ...notes].join(" ");
  }

  /** Keep the query in the address, for Back and for a bookmark. @param {string} query */
  function remember(query) {
    const address = new URL(location.href);
    if ((address.searchParams.get("q") ?? "") === query) return;
    address.searchParams.set("q", query);
    try {
      history.replaceState(null, "", address);
    } catch {
      // some browsers keep the address of a file as it is
    }
  }

  /**
   * @param {FoundPage[]} pages
   * @param {number} limit
   */
  function draw(pages, limit) {
    const list = make("ol", "search-pages");
    list.append(...pages.slice(0, limit).map(drawPage));
    results.replaceChildren(list);
    if (pages.length <= limit) return;
    const more = make("button", "search-more", `Show all ${pages.length} pages`);
    more.addEventListener("click", () => {
      draw(pages, pages.length);
      const next = results.querySelectorAll(".search-page")[limit];
      /** @type {HTMLElement | null} */ (next.querySelector("a"))?.focus();
    });
    results.append(more);
  }

  /** @param {FoundPage} page */
  function drawPage(page) {
    const marks = new URLSearchParams({ highlight: engine.listForms(page).join(" ") });
    const address = `${page.name}.html?${marks}`;
    const item = make("li", "search-page");
    const heading = make("h2", "search-title");
    heading.append(makeLink(address, page.title));
    item.append(make("p", "search-kind", KINDS[page.kind]), heading);
    // the title above is the link to the top of a page: what stands there is of use right below it
    const drawn = page.sections.filter(({ section }, place) => section.trail || !place);
    item.append(...drawn.map((found) => drawSection(found, address)));
    return item;
  }

  /**
   * @param {FoundSection} found
   * @param {string} address
   */
  function drawSection(found, address) {
    const { anchor, heading, trail } = found.section;
    const part = make("div", "search-section");
    if (trail) part.append(makeLink(`${address}#${anchor}`, [...trail, heading].join(" › ")));
    const excerpt = make("p", "search-excerpt");
    for (const { text, isMarked } of engine.cutExcerpt(found))
      excerpt.append(isMarked ? make("mark", "", text) : text);
    if (excerpt.textContent) part.append(excerpt);
    return part;
  }

  /**
   * @param {string} address
   * @param {string} text
   */
  function makeLink(address, text) {
    const link = make("a", "", text);
    link.href = address;
    return link;
  }

  /**
   * @template {keyof HTMLElementTagNameMap} Tag
   * @param {Tag} tag
   * @param {string} className
   */
  function make(tag, className, text = "") {
    const element = document.createElement(tag);
    if (className) element.className = className;
    element.textContent = text;
    return element;
  }

  let timer = 0;
  field.addEventListener("input", () => {
    clearTimeout(timer);
    timer = window.setTimeout(show, TYPING_MS);
  });
  field.form?.addEventListener("submit", (event) => {
    event.preventDefault();
    show();
  });
  field.value = new URLSearchParams(location.search).get("q") ?? "";
  show();
  field.focus();
  field.select();
})();
