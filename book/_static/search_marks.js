// Marks on a page the words that led there: search_page.js writes them into the address as
// `highlight`. Escape takes the marks away.
(() => {
  // what scripts read or draw, and what is not text
  const LEFT_ALONE =
    "script, style, nav, textarea, button, select, svg, .math, .widget-subarea, .headerlink, mark";
  const words = new URLSearchParams(location.search).get("highlight")?.split(/\s+/) ?? [];
  const wanted = words.filter((word) => /^[\p{L}\p{N}]+$/u.test(word));
  const article = document.querySelector("article.bd-article");
  if (!wanted.length || !article) return;

  const pattern = new RegExp(`(?<![\\p{L}\\p{N}])(?:${wanted.join("|")})(?![\\p{L}\\p{N}])`, "giu");
  const walker = document.createTreeWalker(article, NodeFilter.SHOW_TEXT, (node) =>
    node.parentElement?.closest(LEFT_ALONE) ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT,
  );
  const texts = [];
  while (walker.nextNode()) texts.push(/** @type {Text} */ (walker.currentNode));
  for (const text of texts) {
    // from the end on: what stands before keeps its place
    for (const match of [...text.data.matchAll(pattern)].reverse()) {
      const mark = document.createElement("mark");
      mark.className = "search-mark";
      const word = text.splitText(match.index);
      word.splitText(match[0].length);
      word.replaceWith(mark);
      mark.append(word);
    }
  }

  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    for (const mark of document.querySelectorAll("mark.search-mark"))
      mark.replaceWith(...mark.childNodes);
    article.normalize();
  });
})();
