// biome-ignore-all format: written by a tool
// Written by `make exercises` from labutils, see tools/derive/shared.py: change it there.

// hues of an 8-bit picture
export const HUES = 180;

// from a world with z up to the frame one orbits in
export const FROM_WORLD = [0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0];

// kinds of pixels of a depth image
export const [NEARER, INSIDE, FARTHER, NO_SURFACE] = [0, 1, 2, 3];

// two colors by kind
/** @type {Record<number, number[]>} */
export const STRIPES = { 0: [0xffffffff, 0xff8c3cd6], 2: [0xffc8c8c8, 0xff8c8c8c] };

// what the right eye sees of a point
export const [OUTSIDE, SEEN, HIDDEN] = [0, 1, 2];

// what of a picture is shown
export const [OVERLAY, MASK, PICTURE] = [0, 1, 2];

// how bright a picture is where nothing is selected
export const DIM = 0.4;
