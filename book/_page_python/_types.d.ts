// What the scripts of a page hand to each other, and what they find on it.

/** What is kept of one exercise; see labutils/checks/progress.py. */
interface ProgressRecord {
  passed: boolean;
  attempts: number;
  hints: number;
  last_property: string | null;
  mistakes: Counts;
  relations: Counts;
  probes: Counts;
}
type Counts = Record<string, number>;

/** What was said to a prediction of a page, or null where it was only shown. */
interface ProgressPrediction {
  said: string | null;
  right: boolean;
}
/** What the box of a prediction asks for; see book/_static/predict_fields.js. */
interface PredictionField {
  element: HTMLElement;
  inputs: HTMLInputElement[];
  request: string;
  get(): string | null;
  set(answer: string): boolean;
  isRight(answer: string): boolean;
  find(answer: string): string;
  quote(answer: string): Node;
  quoteRight(): Node;
}

/** A progress file. */
interface Progress {
  exercises: Map<string, ProgressRecord>;
  predictions: Map<string, ProgressPrediction>;
}

/** The forms of one thing: kind of content to text, or to what JSON can hold. */
type Bundle = Record<string, unknown>;
/** An output of a cell, as in a notebook. */
type CellOutput =
  | { output_type: "stream"; name: string; text: string }
  | { output_type: "display_data" | "execute_result"; data: Bundle }
  | { output_type: "error"; ename: string; evalue: string; traceback: string[] };

/** What the worker says of code: from page_runner.py, page_cells.py, or python.js for them. */
interface Said {
  result: "passed" | "failed" | "not checked" | "error" | "stopped" | "ran";
  html?: string;
  error?: string;
  printed?: string;
  progress?: string;
  missing?: string | null;
  outputs?: CellOutput[];
  seconds?: number; // that the code itself took
  line?: number | null; // of the code, at which it stopped
}
interface StoredResult {
  code: string;
  said: Said;
}

/** A file of which Python in the page consists; see tools/vendor/pack_python.py. */
interface Asset {
  name: string;
  files: string[];
  bytes: number;
}
interface RemoteWheel {
  name: string;
  url: string;
  sha256: string;
}
/** What the build tells the scripts about Python; see book/_ext/live_cells.py. */
interface PythonData {
  base: string;
  version: string;
  parts: Record<string, Asset[]>;
  remote: RemoteWheel[];
  optional: Record<string, RemoteWheel[]>;
  lock: object;
  page: string;
}
/** What the build tells the scripts about exercises; see book/_ext/exercise_cells.py. */
interface ExerciseData {
  tables: Record<string, Asset>;
  exercises: Record<
    string,
    { hints: string[]; parts: string[]; example: string; isCompletion: boolean }
  >;
  titles: Record<string, string>;
}
type Say = (text: string) => void;
/** Code that has to run. */
interface JobOrder {
  key: string;
  order:
    | { kind: "check"; code: string; exercise: string; progress: string }
    | { kind: "cell"; code: string; name: string; isSetup: boolean };
  parts?: string[];
  table?: Asset;
  say: Say;
  onPrinted?(text: string): void;
}
/** The same, while it waits for the worker or has it. */
interface Job extends JobOrder {
  parts: string[];
  resolve(said: Said): void;
  startedMs?: number; // since when the code itself runs
}
type BootOrder = {
  kind: "boot";
  assets: Record<string, Blob>;
  remote: RemoteWheel[];
  optional: Record<string, RemoteWheel[]>;
  lock: object;
};
type AddOrder = { kind: "add"; part: string; assets: Record<string, Blob> };
type CheckOrder = {
  kind: "check";
  code: string;
  exercise: string;
  progress: string;
  table: Blob | null;
};
type CellOrder = { kind: "cell"; code: string; name: string; isSetup: boolean };
type CommOrder = { kind: "comm"; message: CommMessage };
type Order = BootOrder | AddOrder | CheckOrder | CellOrder | CommOrder;
type WorkerAnswer =
  | { kind: "printed"; text: string }
  | { kind: "say"; text: string }
  | { kind: "comm"; message: CommMessage }
  | { kind: "done"; said: Said }
  | { kind: "fatal"; message: string };

interface Pyodide {
  runPython(code: string): (content: Uint8Array) => string;
  unpackArchive(content: Uint8Array, format: string, options: object): void;
  // biome-ignore lint/suspicious/noExplicitAny: a module of Python has the methods it has
  pyimport(name: string): any;
  toPy(thing: unknown): unknown;
  registerJsModule(name: string, content: object): void;
  FS: { writeFile(path: string, content: Uint8Array): void; chdir(path: string): void };
}
/** A list of byte strings in Python. */
interface PyProxy {
  toJs(): Uint8Array[];
  destroy(): void;
}
interface PageModules {
  runner: {
    run(code: string, exercise: string, progress: string, onText: (text: string) => void): string;
  };
  cells: {
    prepare(): void;
    run(code: string, name: string, onText: (text: string) => void, isSetup: boolean): string;
    list_missing(code: string, optional: string): string;
    note_missing(name: string, reason: string): void;
  };
  comms: {
    connect(send: (text: string, buffers: PyProxy) => void): void;
    deliver(text: string, buffers: unknown): void;
  } | null;
}

/** As many words of JSON Schema as labutils/checks/progress_rules.py needs. */
interface Schema {
  type: string[];
  minimum?: number;
  maximum?: number;
  required?: string[];
  properties?: Record<string, Schema>;
  additionalProperties?: Schema;
}

/** A change that a reader made to a cell of the book. */
interface CellEdit {
  source: string;
  code: string;
}
interface RunInfo {
  code: string;
  isAsked: boolean;
  isWanted: boolean;
}
/** What takes part in the session of a page: a cell of a chapter, an exercise, the bar. */
interface SessionCell {
  element: HTMLElement;
  key: string;
  name: string;
  title: string;
  isNeededBelow: boolean;
  skipped: string;
  getText(): string;
  wait(): void;
  rest(): void;
  begin(): void;
  say(text: string): void;
  print(text: string): void;
  finish(said: Said, info: RunInfo): Promise<void>;
  fail(above: SessionCell): void;
  forget(): void;
}
/** A run that a reader asked for, which may have to wait, and to run others first. */
interface Turn {
  isStopped: boolean;
  running: SessionCell | null;
}
/** A cell of a chapter, as far as the bar of the page knows it. */
interface EditableCell extends SessionCell {
  isEdited(): boolean;
  reset(): void;
}

/** One section of the book; see book/_ext/search_index.py. */
interface SearchSection {
  page: number; // its place in `pages`
  anchor: string;
  trail: string[] | null; // headings between it and the page; null for the top of a page
  heading: string;
  text: string;
  code: string;
  weight: number;
}
type SearchKind = "chapter" | "exercise" | "glossary" | "help" | "reading" | "reference";
interface SearchPage {
  name: string;
  title: string;
  kind: SearchKind;
}
interface SearchIndex {
  fields: string[];
  pages: SearchPage[];
  sections: SearchSection[];
  stems: Record<string, string>;
  stopWords: string[];
  words: import("minisearch").AsPlainObject;
}
interface FoundSection {
  section: SearchSection;
  score: number;
  words: Set<string>; // those found, as the index has them
}
interface FoundPage extends SearchPage {
  score: number;
  sections: FoundSection[];
}
interface FoundWord {
  typed: string; // in small letters
  stem: string;
  start: number;
  end: number;
}
interface Answer {
  pages: FoundPage[]; // best first
  corrected: Map<string, string[]>; // unknown words as typed, and what they may mean
}
interface SearchEngine {
  cutExcerpt(found: FoundSection): { text: string; isMarked: boolean }[];
  listForms(page: FoundPage): string[];
  search(query: string): Answer;
  splitWords(text: string): FoundWord[];
}
/** An exercise, as far as the other tabs are concerned. */
interface WatchedExercise {
  name: string;
  starter: string;
  editor: CodeEditor;
  say: Say;
}

/** What the reader has done, by names of exercises, questions and predictions; see path.js. */
interface PathDone {
  isEmpty: boolean;
  isSolved(name: string): boolean;
  isTried(name: string): boolean;
  isPredicted(name: string): boolean;
  isAnswered(name: string): boolean;
  isRight(name: string): boolean;
}
interface CameraLab {
  path: {
    drawings: ((done: PathDone) => void)[];
    getNames(text: string | undefined): string[];
  };
  searchIndex?: SearchIndex;
  searchEngine: {
    makeEngine(index: SearchIndex, MiniSearch: typeof import("minisearch").default): SearchEngine;
  };
  elements: {
    make<Tag extends keyof HTMLElementTagNameMap>(
      tag: Tag,
      className: string,
      text?: string,
      attributes?: Record<string, string>,
    ): HTMLElementTagNameMap[Tag];
    KEYS: string;
    keepInPlace(element: Element): () => void;
    save(name: string, type: string, text: string): void;
    makeButton(text: string, className: string, onClick: () => void): HTMLButtonElement;
  };
  edits: {
    open(page: string): CellEdit[];
    write(page: string, edits: CellEdit[]): boolean;
  };
  outputs: {
    makeAll(said: Said, alts: string[]): HTMLElement[];
    makeText(text: string, isWarning?: boolean): HTMLElement;
  };
  CellResult: new (
    name: string,
    built: HTMLElement | null,
  ) => {
    built: HTMLElement | null;
    element: HTMLElement;
    switch: HTMLElement;
    choose(isYours: boolean): void;
    begin(): void;
    print(text: string, isWatched: boolean): void;
    show(said: Said, isSame: boolean, isWanted: boolean): Promise<boolean>;
  };
  session: {
    cells: SessionCell[];
    add(cell: SessionCell): void;
    findParts(code: string): string[];
    run(cell: SessionCell): Promise<boolean>;
    runAbove(cell: SessionCell): Promise<boolean>;
    runAll(asked: SessionCell): Promise<boolean>;
    stop(asked: SessionCell): void;
    hasRun(cell: SessionCell): boolean;
  };
  cells: {
    list: EditableCell[];
    announce(text: string): void;
    keepEdits(): void;
  };
  bar?: SessionCell;
  ExerciseButtons: new (
    name: string,
    actions: Record<"run" | "check" | "stop" | "hint" | "reset", () => void>,
  ) => {
    element: HTMLElement;
    nameReset(isUndo: boolean): void;
    setBusy(isBusy: boolean, doing: string): void;
  };
  makeWayOn(name: string): HTMLElement;
  tabs: {
    watch(exercise: WatchedExercise): {
      element: HTMLElement;
      keep(next: string | null): void;
      show(): void;
    };
  };
  verdicts: {
    data: ExerciseData;
    makeParts(said: Said): HTMLElement[];
    nameLinks(parent: Element): void;
  };
  /** book/_static/predict_fields.js */
  predictions: {
    make<Tag extends keyof HTMLElementTagNameMap>(
      tag: Tag,
      className: string,
      ...children: (Node | string)[]
    ): HTMLElementTagNameMap[Tag];
    Choices: new (list: HTMLElement, name: string, said: HTMLElement) => PredictionField;
    NumberField: new (said: HTMLElement) => PredictionField;
  };
  rules: {
    FILE_NAME: string;
    VERSION: number;
    MAX_HINTS: number;
    MAX_CHARACTERS: number;
    WORDS: Record<string, string>;
    SCHEMA: Schema;
  };
  progress: {
    FILE_NAME: string;
    isKept(): boolean;
    load(): Progress;
    merge(progress: Progress): void;
    parse(text: string): Progress;
    countHint(name: string): number;
    text(): string;
    readCode(name: string): string | null;
    writeCode(name: string, code: string | null): void;
    readAside(name: string): string | null;
    writeAside(name: string, code: string | null): void;
    listen(name: string, listener: (code: string | null) => void): void;
    readResult(name: string): StoredResult | null;
    writeResult(name: string, code: string, said: Said): void;
  };
  assets: {
    data: PythonData;
    load(asset: Asset, onLoaded?: (bytes: number) => void): Promise<Blob>;
    loadPart(part: string, onLoaded: (bytes: number) => void): Promise<Record<string, Blob>>;
    loadScript(file: string): Promise<void>;
    countBytes(part: string): number;
    inflateText(blob: Blob): Promise<string>;
  };
  python: {
    run(order: JobOrder): Promise<Said>;
    stop(key: string): void;
    options: { limitMs: number };
    listenForEnd(listener: () => void): void;
    listenForComm(listener: (message: CommMessage) => void): void;
    sendComm(message: CommMessage): void;
  };
}
interface CodeEditor {
  getText(): string;
  setText(text: string): void;
  focus(): void;
  markLine(line: number | null): void;
}
interface Window {
  cameraLab: CameraLab;
  MiniSearch?: typeof import("minisearch").default;
  cameraLabAsset(name: string, piece: number, text: string): void;
  cameraLabEditor?: {
    createEditor(options: {
      parent: Element;
      text: string;
      label: string;
      describedBy: string;
      onChange(text: string): void;
      onCheck(): void;
      onRun?(): void;
      folds?: boolean;
    }): CodeEditor;
  };
  requirejs: { config(options: object): void };
  __jupyter_widgets_assets_path__: string;
}
