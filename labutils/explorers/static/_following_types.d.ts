// What the modules of the following explorer hand to each other; see _types.d.ts for the rest.

interface FollowingSettings {
  gain: number;
  delay: number;
  noise: number;
  speed: number;
}
/** What was true when a command was given; null stands for what is not known. */
interface FollowingMoment {
  time: number;
  /** Where the ball's center is in the picture, in pixels. */
  u: number | null;
  v: number | null;
  /** Where the controller says it is. */
  told_u: number | null;
  told_v: number | null;
  error_px: number | null;
  error_mm: number | null;
  is_hidden: boolean;
  /** Whether it counts for the means. */
  is_measured: boolean;
  delay_ms: number;
  /** null in a recording: what another machine took says nothing */
  render_ms: number | null;
  control_ms: number | null;
}
/** An exception of the controller, in words. */
interface FollowingProblem {
  kind: string;
  message: string;
  line: number | null;
  code: string;
  time: number;
}
type FollowingBytes = DataView<ArrayBuffer>;
/** A moment, and the pictures that came with it. */
interface FollowingFrame {
  moment: FollowingMoment;
  eye: FollowingBytes | null;
  outside: FollowingBytes | null;
}
/** What Python says; see FollowingExplorer. */
interface FollowingAnswer {
  kind: string;
  id: number;
  moment?: FollowingMoment;
  problem?: FollowingProblem;
}
type FollowingListener = (content: FollowingAnswer, buffers: FollowingBytes[]) => void;
interface FollowingAsking {
  send(content: object): void;
  on(event: "msg:custom", callback: FollowingListener): void;
  off(event: "msg:custom", callback: FollowingListener): void;
}
interface FollowingRecorded {
  moments: Record<string, unknown[]>;
  pictures: FollowingBytes;
  /** Of each picture: moment, 0 for the eye and 1 for outside, first byte, bytes. */
  places: number[][];
}
interface FollowingBounds {
  size: Pair;
  near_px: number;
  near_mm: number;
  dt: number;
  neck_ms: number;
}
type FollowingModel = FollowingAsking &
  ViewModel<
    FollowingRecorded &
      FollowingBounds & {
        problem: FollowingProblem | Record<string, never>;
        recorded: FollowingSettings;
      },
    FollowingSettings & { moment: number }
  >;
interface FollowingValues {
  time: number | null;
  error_px: number | null;
  error_mm: number | null;
  is_hidden: boolean | null;
  mean_px: number | null;
  mean_mm: number | null;
}
/** Where the time goes, in ms. */
interface FollowingBudget {
  name: string;
  /** null where it is not known */
  ms: number | null;
}
