// What the scripts of live widgets hand to each other and to the page.

interface CameraLab {
  makeOutbox(post: (message: CommMessage) => void): CommOutbox;
  makeWidgetManager(push: (message: CommMessage) => void): Promise<LiveManager>;
  carryValues(from: Element, to: Element): Promise<void>;
  /** book/_static/widget_loader.js */
  loadWidgets?(): Promise<void>;
  /** Only where code has made widgets. */
  widgets?: {
    show(bundle: Bundle, element: HTMLElement): Promise<void>;
    hear(message: CommMessage): void;
    carry(from: Element, to: Element): Promise<void>;
    clear(element: Element): void;
    reset(): void;
    flush(): void;
    onSend: (message: CommMessage) => void;
    showOutputs: (outputs: CellOutput[], element: HTMLElement) => void;
  };
}
/** What require.js offers, of which _types.d.ts names the rest. */
type RequireModules = (
  names: string[],
  done: (module: never) => void,
  failed: (error: Error) => void,
) => void;

/** A message between a widget of Python and its model in the page; see page_comms.py. */
interface CommMessage {
  type: "comm_open" | "comm_msg" | "comm_close" | "comm_said" | "comm_done";
  comm_id: string;
  target_name?: string;
  data: CommData;
  metadata?: object;
  buffers: ArrayBuffer[];
  /** Of a message to Python: what comm_done will name. */
  id?: number;
}
interface CommData {
  method?: string;
  state?: Record<string, unknown>;
  /** Where in the state the buffers belong. */
  buffer_paths?: (string | number)[][];
  /** Of comm_done. */
  id?: number;
  /** Of comm_said. */
  outputs?: CellOutput[];
}
interface CommOutbox {
  push(message: CommMessage): void;
  flush(): void;
  done(id?: number): void;
  whenQuiet(): Promise<void>;
  clear(): void;
}
/** The page's end of a comm, as a widget manager wants it. */
interface PageComm {
  comm_id: string;
  target_name: string;
  on_msg(listener: (told: object) => void): void;
  on_close(listener: (told: object) => void): void;
  send(
    data: CommData,
    callbacks?: { iopub?: { status?: (message: object) => void } },
    metadata?: object,
    buffers?: (ArrayBuffer | ArrayBufferView)[],
  ): string;
  close(): void;
  hear(kind: "msg" | "close", message: CommMessage): void;
}
interface WidgetModel {
  model_id: string;
  get(name: string): unknown;
}
interface WidgetView {
  remove(): void;
}
interface HtmlManager {
  handle_comm_open(comm: PageComm, message: object): Promise<WidgetModel>;
  get_model(id: string): Promise<WidgetModel>;
  create_view(model: WidgetModel): Promise<WidgetView>;
  display_view(view: WidgetView, place: HTMLElement): Promise<void>;
  disconnect(): void;
}
interface HtmlManagerModule {
  HTMLManager: new (options: { loader(name: string): Promise<unknown> }) => HtmlManager;
}
interface LiveManager {
  manager: HtmlManager;
  hear(message: CommMessage): void;
}
/** An element that shows a live widget. */
interface LivePlace extends HTMLElement {
  liveView?: WidgetView;
  liveIds?: Set<string>;
}
/** The element of an explorer's view. */
interface ExplorerElement extends HTMLElement {
  explorerModel: Model<ViewTraits<Record<string, unknown>> & Record<string, unknown>>;
}
