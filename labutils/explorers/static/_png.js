// Read a PNG exactly. A canvas would cut 16-bit depth down to 8 bits, and a privacy setting of
// the browser may add noise to what is read back from it.

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
/** @type {Record<number, number>} */
const CHANNELS = { 0: 1, 2: 3, 4: 2, 6: 4 }; // color type: values per pixel

/**
 * Decode bytes (a DataView or Uint8Array): gray or color, 8 or 16 bits, not interlaced.
 * @param {ArrayBufferView<ArrayBuffer>} bytes
 * @returns {Promise<Picture>}
 */
export async function decodePng(bytes) {
  const data = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (SIGNATURE.some((value, place) => data[place] !== value)) throw new Error("this is no PNG");
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const [bits, type, interlaced] = [data[24], data[25], data[28]];
  if (!(type in CHANNELS) || ![8, 16].includes(bits) || interlaced) {
    throw new Error(`PNG of color type ${type} with ${bits} bits is not supported`);
  }
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  for (let at = 8; at < data.length; ) {
    const length = view.getUint32(at);
    const name = String.fromCharCode(...data.subarray(at + 4, at + 8));
    if (name === "IDAT") parts.push(data.subarray(at + 8, at + 8 + length));
    at += length + 12;
  }
  const channels = CHANNELS[type];
  const bytesPerPixel = (channels * bits) / 8;
  const raw = undoFilters(await inflate(parts), height, width * bytesPerPixel, bytesPerPixel);
  return { width, height, channels, data: bits === 8 ? raw : joinBytes(raw) };
}

/** @param {Uint8Array<ArrayBuffer>[]} parts */
async function inflate(parts) {
  const stream = new Blob(parts).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * PNG specification, section 9: each row says how it was predicted.
 * @param {Uint8Array} packed
 * @param {number} height
 * @param {number} stride
 * @param {number} step
 */
function undoFilters(packed, height, stride, step) {
  const out = new Uint8Array(height * stride);
  for (let row = 0, from = 0, to = 0; row < height; row++, to += stride) {
    const filter = packed[from++];
    for (let i = 0; i < stride; i++, from++) {
      const left = i < step ? 0 : out[to + i - step];
      const up = row ? out[to + i - stride] : 0;
      const corner = i < step || !row ? 0 : out[to + i - stride - step];
      let guess = 0;
      if (filter === 1) guess = left;
      else if (filter === 2) guess = up;
      else if (filter === 3) guess = (left + up) >> 1;
      else if (filter === 4) guess = paeth(left, up, corner);
      out[to + i] = packed[from] + guess;
    }
  }
  return out;
}

/**
 * @param {number} left
 * @param {number} up
 * @param {number} corner
 */
function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
  if (a <= b && a <= c) return left;
  return b <= c ? up : corner;
}

/** @param {Uint8Array} raw */
function joinBytes(raw) {
  const out = new Uint16Array(raw.length / 2);
  for (let i = 0; i < out.length; i++) out[i] = (raw[2 * i] << 8) | raw[2 * i + 1];
  return out;
}

/**
 * Turn RGB values into what a canvas takes.
 * @param {Picture} picture
 */
export function toImageData({ width, height, channels, data }) {
  const image = new ImageData(width, height);
  for (let i = 0, j = 0; j < image.data.length; i += channels, j += 4) {
    image.data[j] = data[i];
    image.data[j + 1] = data[i + 1];
    image.data[j + 2] = data[i + 2];
    image.data[j + 3] = 255;
  }
  return image;
}
