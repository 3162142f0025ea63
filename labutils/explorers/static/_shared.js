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

// sides of the windows that are matched
export const WINDOWS = [3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31];

// sides of the two windows that a goal compares
export const [SMALL_WINDOW, LARGE_WINDOW] = [3, 15];

// a match is right up to this error in pixels
export const GOOD_PX = 1;

// rows of the right picture, by those of the left one
export const STRIP_SHARE = 0.3;

// what of a picture is shown
export const [OVERLAY, MASK, PICTURE] = [0, 1, 2];

// how bright a picture is where nothing is selected
export const DIM = 0.4;
