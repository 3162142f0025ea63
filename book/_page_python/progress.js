// What the reader has done, kept in this browser: the code of every exercise, its last result, and
// the progress, which is the very file that the notebook writes (labutils-progress.json):
//
//   localStorage["camera-lab-book.progress"]         {"version": 1, "exercises": {name: record}}
//   localStorage["camera-lab-book.code.<name>"]      the reader's code, where it is not the starter
//   localStorage["camera-lab-book.result.<name>"]    {"code", "said"} of the last check
//
// Where the browser keeps nothing, the page works with what this tab remembers.
(() => {
  const PREFIX = "camera-lab-book.";
  const FILE_NAME = "labutils-progress.json";
  const VERSION = 1;
  const MAX_HINTS = 3; // the same limits as in labutils/checks/progress.py
  const COUNTED = /** @type {const} */ (["mistakes", "relations", "probes"]); // older files have only the first
  const MAX_FILE = 1_000_000; // characters; a file of ours has a few thousand

  /** @type {Map<string, string>} */
  const remembered = new Map(); // this tab's own, where the browser keeps nothing
  let kept = true;

  function read(/** @type {string} */ key) {
    try {
      const value = localStorage.getItem(PREFIX + key);
      if (value !== null) return value;
    } catch {
      kept = false;
    }
    return remembered.get(key) ?? null;
  }

  /**
   * Store a text; null removes it.
   * @param {string} key
   * @param {string | null} value
   */
  function write(key, value) {
    if (value === null) remembered.delete(key);
    else remembered.set(key, value);
    try {
      if (value === null) localStorage.removeItem(PREFIX + key);
      else localStorage.setItem(PREFIX + key, value);
      kept = true;
    } catch {
      kept = false; // switched off, or full
    }
  }

  /** Whether what was written last will be there tomorrow. */
  function isKept() {
    try {
      localStorage.setItem(`${PREFIX}probe`, "");
      localStorage.removeItem(`${PREFIX}probe`);
      return kept;
    } catch {
      return false;
    }
  }

  const isObject = (/** @type {unknown} */ value) =>
    typeof value === "object" && value !== null && !Array.isArray(value);
  const isCount = (/** @type {any} */ value) => Number.isSafeInteger(value) && value >= 0;

  /**
   * Read a progress file by the rules of the library; throws an Error that says what is wrong.
   * @param {string} text
   * @returns {ProgressRecords}
   */
  function parse(text) {
    if (text.length > MAX_FILE) throw new Error("it is far too long");
    let content;
    try {
      content = JSON.parse(text);
    } catch {
      throw new Error("it is no JSON");
    }
    if (!isObject(content?.exercises)) throw new Error('it has no "exercises"');
    if (content.version !== VERSION) throw new Error(`its version is not ${VERSION}`);
    const entries = Object.entries(content.exercises);
    return new Map(entries.map(([name, item]) => [name, parseRecord(name, item)]));
  }

  /**
   * @param {string} name
   * @param {any} item
   * @returns {ProgressRecord}
   */
  function parseRecord(name, item) {
    const isRecord =
      isObject(item) &&
      typeof item.passed === "boolean" &&
      isCount(item.attempts) &&
      isCount(item.hints) &&
      item.hints <= MAX_HINTS &&
      (item.last_property === null || typeof item.last_property === "string") &&
      isObject(item.mistakes) &&
      COUNTED.every((kind) => isObject(item[kind] ?? {})) &&
      COUNTED.every((kind) => Object.values(item[kind] ?? {}).every(isCount));
    if (!isRecord) throw new Error(`what it says of ${JSON.stringify(name)} is no record`);
    const { passed, attempts, hints, last_property } = item;
    const [mistakes, relations, probes] = COUNTED.map((kind) => ({ ...item[kind] }));
    return { passed, attempts, hints, last_property, mistakes, relations, probes };
  }

  /**
   * Write records as the library does: names in order, indented by one.
   * @param {ProgressRecords} records
   */
  function format(records) {
    const names = [...records.keys()].sort();
    const exercises = Object.fromEntries(names.map((name) => [name, records.get(name)]));
    return `${JSON.stringify({ version: VERSION, exercises }, null, 1)}\n`;
  }

  /**
   * Join two counts: the larger of each wins.
   * @param {Counts} a
   * @param {Counts} b
   */
  function mergeCounts(a, b) {
    const merged = { ...a };
    for (const [name, count] of Object.entries(b)) {
      merged[name] = Math.max(count, merged[name] ?? 0);
    }
    return merged;
  }

  /**
   * Join two records of one exercise: nothing that was reached gets lost.
   * @param {ProgressRecord} a
   * @param {ProgressRecord} b
   * @returns {ProgressRecord}
   */
  function mergeRecord(a, b) {
    return {
      passed: a.passed || b.passed,
      attempts: Math.max(a.attempts, b.attempts),
      hints: Math.max(a.hints, b.hints),
      last_property: (b.attempts >= a.attempts ? b : a).last_property,
      mistakes: mergeCounts(a.mistakes, b.mistakes),
      relations: mergeCounts(a.relations, b.relations),
      probes: mergeCounts(a.probes, b.probes),
    };
  }

  function load() {
    try {
      return parse(read("progress") ?? format(new Map()));
    } catch {
      return new Map(); // not ours
    }
  }

  /**
   * Add records to those that are stored; of two that differ, the longer history wins.
   * @param {ProgressRecords} records
   */
  function merge(records) {
    const stored = load();
    for (const [name, record] of records) {
      const before = stored.get(name);
      stored.set(name, before ? mergeRecord(before, record) : record);
    }
    write("progress", format(stored));
    document.dispatchEvent(new CustomEvent("camera-lab-progress"));
  }

  /**
   * Count the next hint of an exercise; return its number, as `hint` of the library does.
   * @param {string} name
   */
  function countHint(name) {
    const records = load();
    const empty = { passed: false, attempts: 0, hints: 0, last_property: null, mistakes: {} };
    const record = records.get(name) ?? parseRecord(name, empty);
    record.hints = Math.min(record.hints + 1, MAX_HINTS);
    merge(new Map([[name, record]]));
    return record.hints;
  }

  function readResult(/** @type {string} */ name) {
    try {
      const stored = JSON.parse(read(`result.${name}`) ?? "null");
      return typeof stored?.code === "string" && isObject(stored.said) ? stored : null;
    } catch {
      return null;
    }
  }

  window.cameraLab = {
    ...window.cameraLab,
    progress: {
      FILE_NAME,
      isKept,
      load,
      merge,
      parse,
      countHint,
      text: () => format(load()),
      readCode: (name) => read(`code.${name}`),
      writeCode: (name, code) => write(`code.${name}`, code),
      readResult,
      writeResult: (name, code, said) => write(`result.${name}`, JSON.stringify({ code, said })),
    },
  };
})();
