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
  const NEXT_SECTIONS = [1, 0.25, 0.1]; // what the best sections of a page add to it
  const SECTIONS_SHOWN = 3;
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
   * Make a search from the index; `search` returns the pages, best first.
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
     * @param {string} query
     * @returns {FoundPage[]}
     */
    function search(query) {
      const asked = new Set(splitWords(query, index).map(({ word }) => word));
      const results = engine.search(query, {
        boost: BOOST,
        prefix: (word) => word.length >= SHORTEST_BEGINNING,
        // a word that the book knows is no typing error
        fuzzy: (word) => !isBeginning(word) && (LETTERS_WRONG[word.length] ?? LETTERS_WRONG.at(-1)),
        boostDocument: (place) => index.sections[place].weight,
      });
      const found = results.map(({ id, score, terms, queryTerms }) => {
        const share = new Set(queryTerms).size / asked.size;
        return { section: index.sections[id], score: score * share, words: new Set(terms) };
      });
      return groupByPage(found.sort((one, other) => other.score - one.score));
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
      return [...pages.values()].sort((one, other) => other.score - one.score);
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
      pieces.push({ text: text.slice(from, end) + (end < text.length ? " …" : ""), isMarked: false });
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
     * The words of a query that the book does not have, as they were typed.
     * @param {string} query
     */
    function findUnknown(query) {
      return splitWords(query, index)
        .filter(({ word }) => !isBeginning(word))
        .map(({ start, end }) => query.slice(start, end));
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

    return { cutExcerpt, findUnknown, findWords, listForms, search };
  }

  /**
   * Where an excerpt begins: at a word, before the place with most different words.
   * @param {string} text
   * @param {{ word: string, start: number, end: number }[]} places
   */
  function chooseStart(text, places) {
    let best = { count: 0, start: 0 };
    for (const { start } of places) {
      const near = places.filter((one) => one.start >= start && one.end <= start + EXCERPT - BEFORE);
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
