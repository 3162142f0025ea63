// What the modules of the explorers hand to each other, in words that TypeScript checks. Nothing
// here reaches a page: comments in the modules name these types.

type Pair = [number, number];
type Triple = [number, number, number];
/** Column and row of a picked pixel; empty where none is picked. */
type Pixel = number[];
/** Rows of three: the intrinsic matrix. */
type Matrix = number[][];
/** Twelve numbers, see _orbit.js. */
type Transform = number[];
/** Low and high [hue, saturation, value]. */
type HsvLimits = [Triple, Triple];
type Attributes = Record<string, string | number>;

/** What anywidget hands to a view: its traits, with a name and a type each. */
interface Model<Traits> {
  get<Name extends keyof Traits>(name: Name): Traits[Name];
  set<Name extends keyof Traits>(name: Name, value: Traits[Name]): void;
  on(event: string, callback: () => void): void;
  off(event: string, callback: () => void): void;
  save_changes(): void;
}

/** What every view has. `start` holds the parameters, those that a reader changes. */
interface ViewTraits<Parameters> {
  label: string;
  help: string;
  start: Parameters;
  goal?: Goal | Record<string, never>;
}
/** What a reader is to reach, see _goal.js. */
interface Goal {
  text: string;
  parts: GoalPart[];
}
interface GoalPart {
  /** The value, by the name under which the view tells it. */
  value: string;
  /** Its name for the reader. */
  name: string;
  low: number | null;
  high: number | null;
  unit: string;
  digits: number;
  /** How far from the limits the bar is empty; null: as far as it is at first. */
  scale: number | null;
}
type ViewModel<Own, Parameters> = Model<ViewTraits<Parameters> & Own & Parameters>;

interface Picked {
  pixel: Pixel;
}
interface Scene {
  rgb_png: DataView<ArrayBuffer>;
  depth_png: DataView<ArrayBuffer>;
  depth_step: number;
}
type FovModel = ViewModel<
  { wide_png: DataView<ArrayBuffer>; max_fov_deg: number; sizes: Pair[]; landmarks: Landmark[] },
  { fov_y_deg: number; size: number }
>;
type HsvModel = ViewModel<
  { rgb_png: DataView<ArrayBuffer>; truth_png: DataView<ArrayBuffer> },
  HueEnds & HsvParameters & Picked
>;
interface HueEnds {
  hue_from: number;
  hue_to: number;
}
interface HsvParameters {
  saturation_limits: Pair;
  value_limits: Pair;
  open_radius: number;
  close_radius: number;
  shown: number;
}
type ConventionModel = ViewModel<
  { nears: number[] },
  { raw: number; near_place: number; far: number }
>;
type RangeModel = ViewModel<
  {
    depth_png: DataView<ArrayBuffer>;
    depth_step: number;
    valid_m: Pair;
    clip_m: Pair;
    upper_m: number;
    color_names: string[];
    color_tables: DataView<ArrayBuffer>;
  },
  { range_m: Pair; color_map: number } & Picked
>;
type StereoModel = ViewModel<
  Scene & { valid_m: Pair; K: Matrix },
  { baseline_mm: number; error_px: number } & Picked
>;
type MatchingModel = ViewModel<
  {
    left_png: DataView<ArrayBuffer>;
    right_png: DataView<ArrayBuffer>;
    truth_png: DataView<ArrayBuffer>;
    disparity_step: number;
    K: Matrix;
    baseline: number;
    max_disparity: number;
    places: [string, Pair][];
  },
  { window: number; search: number; noise: number } & Picked
>;
type CloudModel = ViewModel<
  Scene & {
    min_depth: number;
    palette: DataView<ArrayBuffer>;
    true_K: Matrix;
    true_fov_y_deg: number;
    T_world_cam: number[][];
    faces: Face[];
    depth_limits: Pair;
    height_limits: Pair;
    view_fov_deg: number;
  },
  { fov_y_deg: number; far: number; color: number; orbit: Orbit } & Picked
>;

interface Landmark {
  name: string;
  x: number;
  z: number;
  color: string;
  half_tan: number | null;
}
/** Pixel and direction in degrees that one points at; a column has no row. */
type Ray = { u: number; right: number } & ({ v: number; up: number } | { v: null; up: null });
/** A name and three of its pixels. */
type Face = [string, Pair[]];
interface Orbit {
  azimuth_deg: number;
  elevation_deg: number;
  distance: number;
  target: number[];
}

/** What a view fills, see _frame.js. */
interface Frame {
  root: HTMLElement;
  /** For the picture that the controls change: it stays in view while they are used. */
  stage: HTMLElement;
  /** For more drawings: beside the stage, or on a phone below the controls. */
  side: HTMLElement;
  foot: HTMLElement;
  cleanups: (() => void)[];
  reserve(longest: string): void;
  suspendGoal(isSuspended: boolean): void;
  tell(text: string, values: object): void;
  fail(error: unknown): void;
  destroy(): void;
}

type Values = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint8ClampedArray;

interface Picture {
  width: number;
  height: number;
  channels: number;
  data: Values;
}

/** The points of a camera's picture, see readCloud in cloud.js. */
interface Cloud {
  width: number;
  height: number;
  /** Depth of every pixel in steps of `depthStep` meters. */
  steps: Values;
  depthStep: number;
  minDepth: number;
  rgba32: Uint32Array;
  palette: Uint8Array;
  palette32: Uint32Array;
  trueK: Matrix;
  trueFov: number;
  worldFromCamera: Transform | null;
  orbitFromBase: Transform;
  orbitFromCamera: Transform;
  faces: Face[];
  depthLimits: Pair;
  heightLimits: Pair;
}
/** How a cloud is seen, in pixels of a canvas. */
interface Look {
  width: number;
  height: number;
  focal: number;
  eyeFromCamera: Transform;
  K: Matrix;
  far: number;
}
/** The same with the size on the page, for the lines drawn over the canvas. */
interface PageLook extends Look {
  pageWidth: number;
  pageHeight: number;
  pageFocal: number;
  eyeFromOrbit: Transform;
}
interface CloudPainter {
  kind: string;
  /** Pixels of the canvas per pixel of the page. */
  resolution: number;
  draw(look: Look, colors: Uint32Array, version: number): void;
  destroy(): void;
}
interface SplatBuffer {
  width: number;
  height: number;
  distance: Float32Array;
  ids: Int32Array;
}

/** Where something stands on the page. */
interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}
/** Places of an area in a drawing. */
interface Area {
  left: number;
  right: number;
  top: number;
  bottom: number;
}
interface Axis {
  label: string;
  log?: boolean;
  format?: (value: number) => string;
}
interface Plot {
  svg: SVGElement;
  area: Area;
  inside: SVGElement;
  above: SVGElement;
  x(value: number): number;
  y(value: number): number;
  setLimits(xLimits: Pair, yLimits: Pair): boolean;
}

/** What describePair in stereo.js tells. */
type StereoValues = StereoSeen | Nothing<StereoSeen>;
interface StereoSeen {
  depth: number;
  /** The same, if the right eye sees the point. */
  shared_depth: number | null;
  disparity: number;
  u_right: number;
  right: number;
  z_near: number;
  z_far: number | null;
  error_mm: number | null;
  error_linear_mm: number;
}
/** Gray levels of both pictures. */
interface GrayPair {
  left: Uint8ClampedArray;
  right: Uint8ClampedArray;
  width: number;
  height: number;
}
interface MatchScene extends GrayPair {
  /** Focal length in pixels times baseline in meters. */
  product: number;
  /** True disparities of a row of the left picture, NaN where there is none. */
  readRow(v: number): ArrayLike<number>;
}
/** What describeMatch in _matching.js tells. */
type MatchValues = (Minimum | Nothing<Minimum>) & {
  costs: number[];
  truth: number | null;
  true_depth: number | null;
  right: number | null;
  errors_px: (number | null)[];
  small_window_px: number | null;
  large_window_px: number | null;
  right_windows: number | null;
};
/** The lowest point of a curve of costs. */
interface Minimum {
  disparity: number;
  cost: number;
  subpixel: number;
  depth: number | null;
  second: number | null;
  ratio: number | null;
  error_px: number | null;
  depth_error_mm: number | null;
}
/** The same names, where there is no point to tell of. */
type Nothing<Values> = { [Name in keyof Values]: null };
interface Shapes {
  wedges: Pair[][];
  diamond: Pair[];
}
/** From meters [right, depth] to a place in a drawing. */
type Placing = (place: Pair) => Pair;

interface HsvPlanes {
  h: Uint8Array;
  s: Uint8Array;
  v: Uint8Array;
}
/** Twice the area of an outline, and six times its moments. */
interface Sums {
  area: number;
  alongX: number;
  alongY: number;
}
/** What the read-out tells of a picked pixel. */
type PixelValues = { pixel_excluded_by: string[] } & (PickedColor | Nothing<PickedColor>);
interface PickedColor {
  pixel_rgb: number[];
  pixel_hsv: Triple;
  pixel_inside: boolean;
  pixel_selected: boolean;
}
/** How a depth image is painted: limits in meters and in steps, colors, meters per step. */
interface DepthLook {
  table: Uint32Array;
  range: Pair;
  rangeSteps: Pair;
  valid: Pair;
  step: number;
}
type CountedCloud = Pick<Cloud, "steps" | "depthStep" | "minDepth">;
interface FoundPoint {
  point_camera: Triple | null;
  point_world: Triple | null;
}

/** An end of the arc on the ring of hues. */
interface RingEnd {
  handle: HTMLElement;
  trait: keyof HueEnds;
  radius: number;
}
type OrbitModel = Model<{ orbit: Orbit; start: { orbit: Orbit } }>;
interface OwnPictureParts {
  frame: Frame;
  place: HTMLElement;
  size: { width: number; height: number };
  /** Gets a picture, or null for the scene's. */
  show(picture: Picture | null): void;
}
interface WebcamParts {
  say(text: string): void;
  accept(video: HTMLVideoElement): void;
  onChange(running: boolean): void;
}
type HsvValues = PixelValues & {
  share: number;
  count: number;
  centroid: Pair | null;
  iou: number | null;
};
interface Clip {
  depth: number;
  near: number;
  far: number;
}
/** What a range holds of a depth image: surfaces only, but for `no_surface`. */
interface RangeCounts {
  surfaces: number;
  left_out: number;
  share_nearer: number;
  share_inside: number;
  share_farther: number;
  no_surface: number;
  /** How wide the range is: 100 is the tightest that holds every surface. */
  width_percent: number;
  raw_range: Pair;
  raw_closest: number;
  metric_bins: number[];
  raw_bins: number[];
}
interface PixelReading {
  pixel_depth: number | null;
  pixel_raw: number | null;
  pixel_kind: number | null;
}
interface CloudValues extends FoundPoint {
  points: number;
  f: number;
  stretch: number;
  angle_deg: number | null;
}
