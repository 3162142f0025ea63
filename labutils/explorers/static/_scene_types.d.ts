// What the modules of the live scene hand to each other; see _types.d.ts for the rest.

interface SceneAngles {
  pan_deg: number;
  tilt_deg: number;
}
interface ScenePose extends SceneAngles {
  ball_x: number;
  ball_y: number;
}
/** A model that hears and is heard beside its traits, where there is Python. */
interface AskingModel {
  send(content: object): void;
  on(
    event: "msg:custom",
    callback: (content: SceneAnswer, buffers: DataView<ArrayBuffer>[]) => void,
  ): void;
  off(
    event: "msg:custom",
    callback: (content: SceneAnswer, buffers: DataView<ArrayBuffer>[]) => void,
  ): void;
}
type SceneModel = AskingModel &
  ViewModel<
    {
      rgb_png: DataView<ArrayBuffer>;
      depth_png: DataView<ArrayBuffer>;
      depth_step: number;
      valid_steps: Pair;
      colored_m: Pair;
      color_table: DataView<ArrayBuffer>;
      fov_y_deg: number;
      limits_deg: Pair[];
      ball_px: Pixel;
    },
    ScenePose & Picked
  >;
/** What Python says of a picture that it was asked for; see SceneExplorer. */
interface SceneAnswer {
  kind: string;
  id: number;
  width: number;
  height: number;
  pose: ScenePose;
  ball_px: Pixel;
}
/** A picture: color in rows of RGB, depth in steps, the pose that both belong to,
 *  and where the ball's middle is; empty where it cannot be seen. */
interface SceneFrame {
  width: number;
  height: number;
  pose: ScenePose;
  ball_px: Pixel;
  rgb: Uint8Array<ArrayBuffer>;
  steps: Uint16Array<ArrayBuffer>;
}
type SceneValues = ScenePose & {
  is_current: boolean;
  pixel_depth: number | null;
  ball_off_px: number | null;
};
