// Flies from one place to another, as long as nobody takes over.

const FLIGHT_MS = 1100;

/**
 * Make what moves something from 0 to 1, smoothly; a new flight ends the one before. Readers who
 * asked for less motion are there at once.
 * @returns {Flights}
 */
export function makeFlights() {
  let current = 0;
  const stop = () => cancelAnimationFrame(current);
  /** @type {Flights["fly"]} */
  const fly = (move, land = () => {}) => {
    stop();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      move(1);
      land();
      return;
    }
    /** @type {number | undefined} */
    let started;
    const step = (/** @type {number} */ now) => {
      started ??= now;
      const time = Math.min(1, (now - started) / FLIGHT_MS);
      move(time * time * (3 - 2 * time));
      if (time < 1) current = requestAnimationFrame(step);
      else land();
    };
    current = requestAnimationFrame(step);
  };
  return { fly, stop };
}

/**
 * A place between two, which look at the same point.
 * @param {Orbit} from
 * @param {Orbit} to
 * @param {number} share
 * @returns {Orbit}
 */
export function mixOrbits(from, to, share) {
  const mix = (/** @type {number} */ a, /** @type {number} */ b) => a + share * (b - a);
  const around = ((to.azimuth_deg - from.azimuth_deg + 540) % 360) - 180; // the shorter way
  return {
    azimuth_deg: from.azimuth_deg + share * around,
    elevation_deg: mix(from.elevation_deg, to.elevation_deg),
    distance: mix(from.distance, to.distance),
    target: from.target.map((value, i) => mix(value, to.target[i])),
  };
}
