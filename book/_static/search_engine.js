// Finds sections of the book: splits what is typed into words, asks MiniSearch, orders the pages
// and cuts excerpts. Draws nothing; search_page.js does. The index is search_index.js, which
// book/_ext/search_index.py writes.
(() => {
  const WORD = /[\p{L}\p{N}]+/gu;
  // a heading is a promise, and what a section explains counts more than what it mentions
  const BOOST = { title: 3, heading: 5, terms: 3, text: 1, code: 0.4 };
  const SHORTEST_BEGINNING = 3; // letters that already find the words that begin with them
  // Letters that may be wrong in a word that the book does not know, by its length: of a shorter one
  // none, or it would be another word; of a longer one two, as two exchanged letters count.
  const LETTERS_WRONG = [0, 0, 0, 0, 1, 2];
  const NEAREST = 3; // words that may be meant, if they are equally near
  const NEXT_SECTIONS = [1, 0.25, 0.1]; // what the best sections of a page add to it
  const SECTIONS_SHOWN = 3;
  const WEAKEST = 0.04; // of the best page: what says one of many words in passing is no result
  const EXCERPT = 200; // characters
  const BEFORE = 60; // of them before the first word found

  /**
   * Make a search from the index.
   * @param {SearchIndex} index
   * @param {typeof import("minisearch").default} MiniSearch
   */
  function makeEngine(index, MiniSearch) {
    const engine = MiniSearch.loadJS(index.words, { fields: index.fields });
    const stems = new Map(Object.entries(index.stems)); // of the words that are not their own stem
    const stopWords = new Set(index.stopWords);
    const known = new Set([...index.words.index.map(([stem]) => stem), ...stems.keys()]);

    /**
     * The words of a text that count, by their stems.
     * @param {string} text
     * @returns {FoundWord[]}
     */
    function splitWords(text) {
      return [...text.matchAll(WORD)].flatMap((match) => {
        const typed = match[0].toLowerCase();
        const end = match.index + typed.length;
        return stopWords.has(typed)
          ? []
          : [{ typed, stem: getStem(typed), start: match.index, end }];
      });
    }

    /** @param {string} word */
    function getStem(word) {
      return stems.get(word) ?? word;
    }

    /**
     * What to look for: the stem of a word of the book, else of words that begin with it, else of
     * words that are spelled like it.
     * @param {string} query
     */
    function read(query) {
      /** @type {Map<string, string>} */
      const typedOf = new Map();
      const corrected = new Map();
      for (const { typed, stem } of splitWords(query)) {
        let meant = known.has(typed) ? [typed] : listBeginnings(typed);
        if (!meant.length) {
          meant = findNearest(typed);
          corrected.set(typed, meant);
        }
        for (const one of meant.length ? meant : [stem]) typedOf.set(getStem(one), typed);
      }
      return { typedOf, corrected };
    }

    /** @param {string} typed */
    function listBeginnings(typed) {
      if (typed.length < SHORTEST_BEGINNING) return [];
      return [...known].filter((word) => word.startsWith(typed));
    }

    /**
     * @param {string} query
     * @returns {Answer}
     */
    function search(query) {
      const { typedOf, corrected } = read(query);
      const count = new Set(typedOf.values()).size;
      const results = engine.search([...typedOf.keys()].join(" "), {
        boost: BOOST,
        tokenize: (text) => text.split(" "),
        processTerm: (word) => word,
        prefix: (word) => word.length >= SHORTEST_BEGINNING,
        boostDocument: (place) => index.sections[place].weight,
      });
      const found = results.map(({ id, score, terms, queryTerms }) => {
        const share = new Set(queryTerms.map((term) => typedOf.get(term))).size / count;
        return { section: index.sections[id], score: score * share, words: new Set(terms) };
      });
      const pages = groupByPage(found.sort((one, other) => other.score - one.score));
      return { pages: raiseDefinition(pages, new Set(typedOf.keys())), corrected };
    }

    /**
     * Move the glossary up to the second place where it defines just what was asked for.
     * @param {FoundPage[]} pages
     * @param {Set<string>} asked
     */
    function raiseDefinition(pages, asked) {
      const place = pages.findIndex(({ kind }) => kind === "glossary");
      if (place < 2) return pages;
      const isAsked = (/** @type {FoundSection} */ { section }) => {
        const words = new Set(splitWords(section.heading).map(({ stem }) => stem));
        return words.size === asked.size && [...words].every((word) => asked.has(word));
      };
      if (!pages[place].sections.some(isAsked)) return pages;
      const [best, ...others] = pages.toSpliced(place, 1);
      return [best, pages[place], ...others];
    }

    /** @type {import("minisearch").default | null} */
    let speller = null;

    /**
     * Words of the book that are spelled like an unknown one.
     * @param {string} typed
     * @returns {string[]}
     */
    function findNearest(typed) {
      speller ??= makeSpeller();
      const fuzzy = LETTERS_WRONG[typed.length] ?? LETTERS_WRONG.at(-1);
      const near = fuzzy ? speller.search(typed, { fuzzy }) : [];
      return near
        .filter(({ score }) => score > near[0].score - 1e-9)
        .slice(0, NEAREST)
        .map(({ id }) => id);
    }

    /** An index of whole words; made for the first word that is unknown, as most are known. */
    function makeSpeller() {
      const made = new MiniSearch({ fields: ["id"], tokenize: (text) => [text] });
      made.addAll([...known].map((id) => ({ id })));
      return made;
    }

    /** @param {FoundSection[]} found */
    function groupByPage(found) {
      /** @type {Map<number, FoundPage>} */
      const pages = new Map();
      for (const one of found) {
        const { page } = one.section;
        const group = pages.get(page) ?? { ...index.pages[page], score: 0, sections: [] };
        group.score += (NEXT_SECTIONS[group.sections.length] ?? 0) * one.score;
        if (group.sections.length < SECTIONS_SHOWN) group.sections.push(one);
        pages.set(page, group);
      }
      const ordered = [...pages.values()].sort((one, other) => other.score - one.score);
      return ordered.filter(({ score }) => score >= WEAKEST * ordered[0].score);
    }

    /**
     * The part of a section that holds most of the words, in pieces, some of them marked.
     * @param {FoundSection} found
     */
    function cutExcerpt({ section, words }) {
      // code is shown only where nothing else says why the section was found
      const isSaid = [section.heading, section.text].some((text) => hasWord(text, words));
      const text = isSaid || !hasWord(section.code, words) ? section.text : section.code;
      const places = findWords(text, words);
      const start = chooseStart(text, places);
      const end = snapEnd(text, start + EXCERPT);
      const inside = places.filter((place) => place.start >= start && place.end <= end);
      const pieces = [{ text: start ? "… " : "", isMarked: false }];
      let from = start;
      for (const place of inside) {
        pieces.push({ text: text.slice(from, place.start), isMarked: false });
        pieces.push({ text: text.slice(place.start, place.end), isMarked: true });
        from = place.end;
      }
      pieces.push({
        text: text.slice(from, end) + (end < text.length ? " …" : ""),
        isMarked: false,
      });
      return pieces.filter((piece) => piece.text);
    }

    /** @param {string} text @param {Set<string>} words */
    function findWords(text, words) {
      return splitWords(text).filter(({ stem }) => words.has(stem));
    }

    /** @param {string} text @param {Set<string>} words */
    function hasWord(text, words) {
      return findWords(text, words).length > 0;
    }

    /**
     * The forms in which a page has the words found, to mark them there.
     * @param {FoundPage} page
     */
    function listForms(page) {
      const forms = page.sections.flatMap(({ section: { heading, text, code }, words }) =>
        [heading, text, code].flatMap((field) =>
          findWords(field, words).map(({ start, end }) => field.slice(start, end).toLowerCase()),
        ),
      );
      return [...new Set(forms)];
    }

    return { cutExcerpt, listForms, search, splitWords };
  }

  /**
   * Where an excerpt begins: at a word, before the place with most different words.
   * @param {string} text
   * @param {FoundWord[]} places
   */
  function chooseStart(text, places) {
    let best = { count: 0, start: 0 };
    for (const { start } of places) {
      const near = places.filter(
        (one) => one.start >= start && one.end <= start + EXCERPT - BEFORE,
      );
      // of two places with the same words the one where they are said more often
      const count = new Set(near.map(({ stem }) => stem)).size + near.length / 100;
      if (count > best.count) best = { count, start };
    }
    if (best.start <= BEFORE) return 0;
    const sentence = text.slice(best.start - BEFORE, best.start).search(/(?<=[.?!:] )\S/);
    if (sentence >= 0) return best.start - BEFORE + sentence;
    const space = text.indexOf(" ", best.start - BEFORE);
    return space >= 0 && space < best.start ? space + 1 : best.start;
  }

  /** @param {string} text @param {number} end */
  function snapEnd(text, end) {
    if (end >= text.length) return text.length;
    const space = text.lastIndexOf(" ", end);
    return space > end - BEFORE ? space : end;
  }

  window.cameraLab = { ...window.cameraLab, searchEngine: { makeEngine } };
})();
