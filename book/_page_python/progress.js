// What the reader has done, kept in this browser: the code of every exercise, its last result, and
// the progress, which is the very file that the notebook writes (labutils-progress.json):
//
//   localStorage["camera-lab-book.progress"]         {"version": 1, "exercises": {name: record}}, and
//                                                    "predictions", which predict.js writes
//   localStorage["camera-lab-book.code.<name>"]      the reader's code, where it is not the starter
//   localStorage["camera-lab-book.aside.<name>"]     another tab's code, until the reader has chosen
//   localStorage["camera-lab-book.result.<name>"]    {"code", "said"} of the last check
//
// Where the browser keeps nothing, the page works with what this tab remembers.
(() => {
  const PREFIX = "camera-lab-book.";
  const { FILE_NAME, VERSION, MAX_HINTS, MAX_CHARACTERS, SCHEMA, WORDS } = window.cameraLab.rules;
  const COUNTED = /** @type {const} */ (["mistakes", "relations", "probes"]); // older files have only the first

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

  /** Name the kind of a value of JSON; a number that is whole, and exact, is an integer. */
  function getKind(/** @type {unknown} */ value) {
    if (value === null) return "null";
    if (Array.isArray(value)) return "array";
    return Number.isSafeInteger(value) ? "integer" : typeof value;
  }

  /**
   * Say where JSON differs from a schema, and how, as find_fault in progress_rules.py: the first
   * fault; "" where there is none.
   * @param {any} value
   * @param {Schema} schema
   * @param {string} place
   * @returns {string}
   */
  function findFault(value, schema, place = "the file") {
    const kind = getKind(value);
    if (!schema.type.includes(kind)) {
      const wanted = schema.type.map((one) => WORDS[one]).join(" or ");
      return `${place}: expected ${wanted}, got ${WORDS[kind]}`;
    }
    const { minimum: low = 0, maximum: high } = schema;
    if (kind === "integer" && (value < low || (high !== undefined && value > high))) {
      const range = low === high ? low : `${low} to ${high}`;
      return `${place}: expected ${high === undefined ? `${low} or more` : range}, got ${value}`;
    }
    if (kind !== "object") return "";
    const missing = schema.required?.find((name) => !Object.hasOwn(value, name));
    if (missing) return `${place}: expected "${missing}", got none`;
    for (const name of Object.keys(value).sort()) {
      const own = new Map(Object.entries(schema.properties ?? {})).get(name);
      const rule = own ?? schema.additionalProperties;
      const inside = place === "the file" ? name : `${place}.${name}`;
      const fault = rule ? findFault(value[name], rule, inside) : "";
      if (fault) return fault;
    }
    return "";
  }

  /**
   * Read a progress file by the rules of the library; throws an Error that says what is wrong.
   * @param {string} text
   * @returns {Progress}
   */
  function parse(text) {
    if (text.length > MAX_CHARACTERS) throw new Error("it is far too long");
    let content;
    try {
      content = JSON.parse(text);
    } catch {
      throw new Error("it is no JSON");
    }
    const fault = findFault(content, SCHEMA);
    if (fault) throw new Error(fault);
    const read = (/** @type {object} */ items, /** @type {(item: any) => any} */ readItem) =>
      new Map(Object.entries(items).map(([name, item]) => [name, readItem(item)]));
    return {
      exercises: read(content.exercises, readRecord),
      predictions: read(content.predictions ?? {}, ({ said, right }) => ({ said, right })),
    };
  }

  /**
   * @param {any} item
   * @returns {ProgressRecord}
   */
  function readRecord(item) {
    const { passed, attempts, hints, last_property } = item;
    const [mistakes, relations, probes] = COUNTED.map((kind) => ({ ...item[kind] }));
    return { passed, attempts, hints, last_property, mistakes, relations, probes };
  }

  /**
   * Write a file as the library does: names in order, indented by one.
   * @param {Progress} progress
   */
  function format({ exercises, predictions }) {
    const sort = (/** @type {Map<string, object>} */ items) =>
      Object.fromEntries([...items.keys()].sort().map((name) => [name, items.get(name)]));
    const content = { version: VERSION, exercises: sort(exercises) };
    const all = predictions.size ? { ...content, predictions: sort(predictions) } : content;
    return `${JSON.stringify(all, null, 1)}\n`;
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
    /** @type {Progress} */
    const empty = { exercises: new Map(), predictions: new Map() };
    try {
      return parse(read("progress") ?? format(empty));
    } catch {
      return empty; // not ours
    }
  }

  /**
   * Add to what is stored. Of two records that differ, the longer history wins; of predictions,
   * what was said first, see progress_rules.py.
   * @param {Progress} progress
   */
  function merge({ exercises, predictions }) {
    const stored = load();
    for (const [name, record] of exercises) {
      const before = stored.exercises.get(name);
      stored.exercises.set(name, before ? mergeRecord(before, record) : record);
    }
    for (const [name, prediction] of predictions) {
      const hasAnswer = typeof stored.predictions.get(name)?.said === "string";
      if (!hasAnswer) stored.predictions.set(name, prediction);
    }
    write("progress", format(stored));
    document.dispatchEvent(new CustomEvent("camera-lab-progress"));
  }

  /**
   * Count the next hint of an exercise; return its number, as `hint` of the library does.
   * @param {string} name
   */
  function countHint(name) {
    const { exercises } = load();
    const empty = { passed: false, attempts: 0, hints: 0, last_property: null, mistakes: {} };
    const record = exercises.get(name) ?? readRecord(empty);
    record.hints = Math.min(record.hints + 1, MAX_HINTS);
    merge({ exercises: new Map([[name, record]]), predictions: new Map() });
    return record.hints;
  }

  function readResult(/** @type {string} */ name) {
    try {
      const stored = JSON.parse(read(`result.${name}`) ?? "null");
      return typeof stored?.code === "string" && getKind(stored.said) === "object" ? stored : null;
    } catch {
      return null;
    }
  }

  /**
   * Hear that another tab has changed the code of an exercise; null stands for the starter.
   * @param {string} name
   * @param {(code: string | null) => void} listener
   */
  function listen(name, listener) {
    window.addEventListener("storage", ({ key, newValue }) => {
      if (key === `${PREFIX}code.${name}`) listener(newValue);
    });
  }

  // another tab has solved or imported something
  window.addEventListener("storage", ({ key }) => {
    if (key === `${PREFIX}progress`) document.dispatchEvent(new CustomEvent("camera-lab-progress"));
  });

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
      readAside: (name) => read(`aside.${name}`),
      writeAside: (name, code) => write(`aside.${name}`, code),
      listen,
      readResult,
      writeResult: (name, code, said) => write(`result.${name}`, JSON.stringify({ code, said })),
    },
  };
})();
