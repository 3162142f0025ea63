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
   * @param {string} text
   * @param {SearchIndex} index
   */
  function splitWords(text, index) {
    return [...text.matchAll(WORD)].flatMap((match) => {
      const typed = match[0].toLowerCase();
      const word = index.spellings[typed] ?? typed;
      return index.stopWords.includes(word)
        ? []
        : [{ word: index.stem(word), start: match.index, end: match.index + match[0].length }];
    });
  }

  /**
   * Make a search from the index.
   * @param {SearchIndex} index
   * @param {typeof import("minisearch").default} MiniSearch
   */
  function makeEngine(index, MiniSearch) {
    const engine = MiniSearch.loadJS(index.words, {
      fields: index.fields,
      tokenize: (text) => splitWords(text, index).map(({ word }) => word),
      processTerm: (word) => word,
    });
    const known = index.words.index.map(([word]) => word);
    const isBeginning = (/** @type {string} */ word) => known.some((one) => one.startsWith(word));

    /**
     * What to look for: for a word that the book knows its stem, else the words spelled like it.
     * @param {string} query
     */
    function read(query) {
      /** @type {Map<string, string>} */
      const typedOf = new Map();
      const corrected = new Map();
      for (const { word, start, end } of splitWords(query, index)) {
        const typed = query.slice(start, end);
        const near = isBeginning(word) ? [] : findNearest(typed.toLowerCase());
        if (!isBeginning(word)) corrected.set(typed, near);
        for (const one of near) typedOf.set(index.stem(one), typed);
        if (!near.length) typedOf.set(word, typed);
      }
      return { typedOf, corrected };
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
        const words = new Set(splitWords(section.heading, index).map(({ word }) => word));
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
      const words = new Set();
      for (const { heading, text } of index.sections)
        for (const [word] of `${heading} ${text}`.toLowerCase().matchAll(WORD)) words.add(word);
      const made = new MiniSearch({ fields: ["id"], tokenize: (text) => [text] });
      made.addAll([...words].map((id) => ({ id })));
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
      const text = hasWord(section.text, words) || !section.code ? section.text : section.code;
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
      return splitWords(text, index).filter(({ word }) => words.has(word));
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

    return { cutExcerpt, listForms, search };
  }

  /**
   * Where an excerpt begins: at a word, before the place with most different words.
   * @param {string} text
   * @param {{ word: string, start: number, end: number }[]} places
   */
  function chooseStart(text, places) {
    let best = { count: 0, start: 0 };
    for (const { start } of places) {
      const near = places.filter(
        (one) => one.start >= start && one.end <= start + EXCERPT - BEFORE,
      );
      // of two places with the same words the one where they are said more often
      const count = new Set(near.map(({ word }) => word)).size + near.length / 100;
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

  window.cameraLab = { ...window.cameraLab, searchEngine: { makeEngine, splitWords } };
})();
