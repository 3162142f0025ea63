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
type ProgressRecords = Map<string, ProgressRecord>;

/** What a check says: from page_runner.py, or from python.js where there was none. */
interface Said {
  result: "passed" | "failed" | "not checked" | "error" | "stopped";
  html?: string;
  error?: string;
  printed?: string;
  progress?: string;
}
interface StoredResult {
  code: string;
  said: Said;
}

/** A part of what Python in the page consists of; see tools/vendor/pack_python.py. */
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
/** What the build tells the scripts; see book/_ext/exercise_cells.py. */
interface ExerciseData {
  base: string;
  version: string;
  bytes: number;
  assets: Asset[];
  tables: Record<string, Asset>;
  remote: RemoteWheel[];
  lock: object;
  exercises: Record<string, { hints: string[] }>;
  titles: Record<string, string>;
}
type Say = (text: string) => void;
/** A check that waits for the worker, or has it. */
interface Job {
  exercise: string;
  code: string;
  say: Say;
  resolve(said: Said): void;
  isRunning?: boolean;
}
type BootOrder = {
  kind: "boot";
  assets: Record<string, Blob>;
  remote: RemoteWheel[];
  lock: object;
};
type RunOrder = {
  kind: "run";
  code: string;
  exercise: string;
  progress: string;
  table: Blob | null;
};
type WorkerAnswer =
  | { kind: "ready" }
  | { kind: "done"; said: Said }
  | { kind: "fatal"; message: string };

interface Pyodide {
  runPython(code: string): (content: Uint8Array) => string;
  unpackArchive(content: Uint8Array, format: string, options: object): void;
  pyimport(name: string): { run(code: string, exercise: string, progress: string): string };
  FS: { writeFile(path: string, content: Uint8Array): void; chdir(path: string): void };
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

interface CameraLab {
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
    load(): ProgressRecords;
    merge(records: ProgressRecords): void;
    parse(text: string): ProgressRecords;
    countHint(name: string): number;
    text(): string;
    readCode(name: string): string | null;
    writeCode(name: string, code: string | null): void;
    readResult(name: string): StoredResult | null;
    writeResult(name: string, code: string, said: Said): void;
  };
  python: {
    check(exercise: string, code: string, say: (text: string) => void): Promise<Said>;
    stop(exercise: string): void;
    options: { limitMs: number };
    data: ExerciseData;
  };
}
interface CodeEditor {
  getText(): string;
  setText(text: string): void;
  focus(): void;
}
interface Window {
  cameraLab: CameraLab;
  cameraLabAsset(name: string, piece: number, text: string): void;
  cameraLabEditor?: {
    createEditor(options: {
      parent: Element;
      text: string;
      label: string;
      describedBy: string;
      onChange(text: string): void;
      onCheck(): void;
    }): CodeEditor;
  };
  MathJax?: {
    Hub?: object;
    startup?: { promise: Promise<void> }; // only once it has been loaded
    typesetPromise(elements: Element[]): Promise<void>;
  };
  requirejs: { config(options: object): void };
  __jupyter_widgets_assets_path__: string;
}
