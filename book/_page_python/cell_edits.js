// What the reader has made of the cells of a page, kept in this browser:
//
//   localStorage["camera-lab-book.cells.<page>"]    [{"source", "code"}, ...]
//
// An edit belongs to the text it was made from: where the book has changed a cell since, the edit
// stays with the same text wherever that stands now, and is dropped where there is none. Of two tabs
// on one page each keeps what it has changed itself, and leaves to the other what that one has.
(() => {
  const PREFIX = "camera-lab-book.cells.";

  /** @type {Map<string, CellEdit[]>} */
  const remembered = new Map(); // what this tab knows: its own, where the browser keeps nothing

  /**
   * @param {string} page
   * @returns {CellEdit[]}
   */
  function read(page) {
    try {
      const edits = JSON.parse(localStorage.getItem(PREFIX + page) ?? "[]");
      if (Array.isArray(edits)) return edits.filter(isEdit);
    } catch {
      // no storage, or no JSON in it: as if nothing were there
    }
    return remembered.get(page) ?? [];
  }

  /**
   * Read the edits of a page when it opens; what this tab writes later is compared with them.
   * @param {string} page
   */
  function open(page) {
    const edits = read(page);
    remembered.set(page, edits);
    return edits;
  }

  const isEdit = (/** @type {any} */ edit) =>
    typeof edit?.source === "string" && typeof edit?.code === "string";

  /**
   * What is to be kept: of each text what this tab has changed, else what is kept by now.
   * @param {CellEdit[]} known
   * @param {CellEdit[]} mine
   * @param {CellEdit[]} kept
   */
  function merge(known, mine, kept) {
    const of = (/** @type {CellEdit[]} */ edits, /** @type {string} */ source) =>
      edits.filter((edit) => edit.source === source);
    const isSame = (/** @type {CellEdit[]} */ one, /** @type {CellEdit[]} */ other) =>
      JSON.stringify(one.map(({ code }) => code)) === JSON.stringify(other.map(({ code }) => code));
    const sources = new Set([...kept, ...mine].map(({ source }) => source));
    return [...sources].flatMap((source) =>
      isSame(of(mine, source), of(known, source)) ? of(kept, source) : of(mine, source),
    );
  }

  /**
   * Keep the edits of a page; returns whether the browser will still have them after a reload.
   * @param {string} page
   * @param {CellEdit[]} edits
   */
  function write(page, edits) {
    const all = merge(remembered.get(page) ?? [], edits, read(page));
    remembered.set(page, edits);
    try {
      if (all.length) localStorage.setItem(PREFIX + page, JSON.stringify(all));
      else localStorage.removeItem(PREFIX + page);
      return true;
    } catch {
      return false;
    }
  }

  window.cameraLab = { ...window.cameraLab, edits: { open, write } };
})();
