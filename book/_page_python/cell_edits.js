// What the reader has made of the cells of a page, kept in this browser:
//
//   localStorage["camera-lab-book.cells.<page>"]    [{"source", "code"}, ...]
//
// An edit belongs to the text it was made from: where the book has changed a cell since, the edit
// stays with the same text wherever that stands now, and is dropped where there is none.
(() => {
  const PREFIX = "camera-lab-book.cells.";

  /** @type {Map<string, CellEdit[]>} */
  const remembered = new Map(); // this tab's own, where the browser keeps nothing

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

  const isEdit = (/** @type {any} */ edit) =>
    typeof edit?.source === "string" && typeof edit?.code === "string";

  /**
   * Keep the edits of a page; returns whether the browser will still have them after a reload.
   * @param {string} page
   * @param {CellEdit[]} edits
   */
  function write(page, edits) {
    remembered.set(page, edits);
    try {
      if (edits.length) localStorage.setItem(PREFIX + page, JSON.stringify(edits));
      else localStorage.removeItem(PREFIX + page);
      return true;
    } catch {
      return false;
    }
  }

  window.cameraLab = { ...window.cameraLab, edits: { read, write } };
})();
