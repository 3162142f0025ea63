// Sensor noise, the same as in labutils/explorers/_noise.py: whole numbers from a hash of the place.

const STRIDE = 0x9e3779b9;
const TWICE_SD = 296; // of the sum of four bytes
const MOST = 510; // the sum is as large to either side

/**
 * Noise for some pixels: -510 to 510, standard deviation 148.
 * @param {number} count
 * @param {number} seed
 */
export function makeNoise(count, seed) {
  const noise = new Int16Array(count);
  const start = Math.imul(seed, STRIDE);
  for (let i = 0; i < count; i++) {
    let hash = (start + i) | 0;
    hash = Math.imul(hash ^ (hash >>> 16), 0x7feb352d);
    hash = Math.imul(hash ^ (hash >>> 15), 0x846ca68b);
    hash ^= hash >>> 16;
    const sum = (hash & 255) + ((hash >>> 8) & 255) + ((hash >>> 16) & 255) + (hash >>> 24);
    noise[i] = sum - MOST;
  }
  return noise;
}

/**
 * Add noise of a standard deviation of `sigma` gray levels to a picture.
 * @param {ArrayLike<number>} gray
 * @param {Int16Array} noise
 * @param {number} sigma
 * @param {Uint8ClampedArray} out
 */
export function addNoise(gray, noise, sigma, out) {
  // a picture has more pixels than there are sums: each is divided once
  const levels = Int16Array.from({ length: 2 * MOST + 1 }, (_, i) =>
    Math.floor((2 * sigma * (i - MOST) + TWICE_SD / 2) / TWICE_SD),
  );
  for (let i = 0; i < gray.length; i++) out[i] = gray[i] + levels[noise[i] + MOST];
}
