// What the first screen is made of. Written by tools/draw/hero.py; pictures are in base64.

interface HeroData {
  K: Matrix;
  T_world_cam: Matrix;
  depth_step: number;
  error_step: number;
  error_zero: number;
  names: string[];
  rgb_webp: string;
  depth_png: string;
  error_png: string;
  thing_png: string;
}
/** The cloud, what each of its points belongs to, and how far each is off the truth. */
interface HeroScene {
  cloud: Cloud;
  /** Where the camera itself stands, as a place to look from. */
  start: Orbit;
  names: string[];
  things: Values;
  errors: Values;
  toMeters(error: number): number;
}
interface HeroReading {
  name: string;
  measured: number;
  truth: number;
}
/** What a test reads, and moves. */
interface HeroElement extends HTMLElement {
  heroModel?: OrbitModel;
}
interface CameraLab {
  heroData?: HeroData;
}
/** What the buttons below the photo do, by their values. */
interface HeroActions {
  lift(): void;
  ball(): void;
  reset(): void;
}
/** See makeFlights. */
interface Flights {
  fly(move: (share: number) => void, land?: () => void): void;
  stop(): void;
}
