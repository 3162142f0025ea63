"""Wrong answers to find_stale_frames, as strangers wrote them."""
import cv2
import numpy as np


def _right(images, pans, noise):
    images = np.asarray(images).astype(np.int16)
    stale = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        moved = abs(pans[t] - pans[t - 1]) > 0.001
        stale[t] = moved and np.abs(images[t] - images[t - 1]).max() <= noise
    return stale


def w_uint8_overflow(images, pans, noise):
    diff = np.abs(images[1:] - images[:-1])
    changed = diff.reshape(len(diff), -1).max(axis=1) > noise
    moved = np.abs(np.diff(pans)) > 0.001
    return np.concatenate([[False], moved & ~changed])


def w_mean_change(images, pans, noise):
    stale = np.zeros(len(images), dtype=bool)
    for t in range(1, len(images)):
        change = np.abs(images[t].astype(float) - images[t - 1].astype(float)).mean()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and change <= noise
    return stale


def w_strictly_below_noise(images, pans, noise):
    img = images.astype(np.int32)
    stale = [False]
    for i in range(1, len(img)):
        changed = np.any(np.abs(img[i] - img[i - 1]) >= noise)
        moved = np.abs(pans[i] - pans[i - 1]) > 0.001
        stale.append(bool(moved and not changed))
    return np.array(stale)


def w_compare_with_first(images, pans, noise):
    img = images.astype(np.int16)
    change = np.abs(img - img[0]).max(axis=(1, 2, 3))
    moved = np.abs(pans - pans[0]) > 0.001
    return moved & (change <= noise)


def w_signed_pan(images, pans, noise):
    img = images.astype(int)
    moved = np.diff(pans, prepend=pans[0]) > 0.001
    same = np.abs(np.diff(img, axis=0, prepend=img[:1])).max(axis=(1, 2, 3)) <= noise
    return moved & same


def w_ignores_noise(images, pans, noise):
    out = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        if abs(pans[t] - pans[t - 1]) > 0.001 and np.array_equal(images[t], images[t - 1]):
            out[t] = True
    return out


def w_one_entry_short(images, pans, noise):
    img = images.astype(np.int16)
    same = np.abs(np.diff(img, axis=0)).max(axis=(1, 2, 3)) <= noise
    moved = np.abs(np.diff(pans)) > 1e-3
    return moved & same


def w_marks_the_older(images, pans, noise):
    n = len(images)
    stale = np.zeros(n, bool)
    for t in range(n - 1):
        moved = abs(pans[t + 1] - pans[t]) > 0.001
        diff = cv2.absdiff(images[t + 1], images[t])
        stale[t] = moved and diff.max() <= noise
    return stale


def w_any_pixel_still(images, pans, noise):
    img = images.astype(np.int16)
    stale = np.zeros(len(img), dtype=bool)
    for t in range(1, len(img)):
        if abs(pans[t] - pans[t - 1]) > 0.001:
            stale[t] = (np.abs(img[t] - img[t - 1]) <= noise).any()
    return stale


def w_threshold_in_degrees(images, pans, noise):
    pans = np.degrees(pans)
    stale = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        diff = cv2.absdiff(images[t], images[t - 1]).max()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and diff <= noise
    return stale


def w_forgets_the_neck(images, pans, noise):
    img = images.astype(np.int16)
    stale = np.zeros(len(img), bool)
    stale[1:] = np.abs(img[1:] - img[:-1]).max(axis=(1, 2, 3)) <= noise
    return stale


def w_returns_indices(images, pans, noise):
    img = images.astype(np.int16)
    change = np.abs(img[1:] - img[:-1]).reshape(len(img) - 1, -1).max(axis=1)
    moved = np.abs(pans[1:] - pans[:-1]) > 0.001
    return np.nonzero(moved & (change <= noise))[0] + 1


def w_compares_gray(images, pans, noise):
    gray = [cv2.cvtColor(im, cv2.COLOR_RGB2GRAY).astype(int) for im in images]
    stale = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        change = np.abs(gray[t] - gray[t - 1]).max()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and change <= noise
    return stale


def w_roll_wraps(images, pans, noise):
    img = images.astype(np.int16)
    change = np.abs(img - np.roll(img, 1, axis=0)).max(axis=(1, 2, 3))
    moved = np.abs(pans - np.roll(pans, 1)) > 0.001
    return moved & (change <= noise)


def w_int8_cast(images, pans, noise):
    img = images.astype(np.int8)
    stale = np.zeros(len(img), bool)
    for t in range(1, len(img)):
        change = np.abs(img[t] - img[t - 1]).max()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and change <= noise
    return stale


def w_subtract_saturates(images, pans, noise):
    stale = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        change = cv2.subtract(images[t], images[t - 1]).max()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and change <= noise
    return stale


def w_last_fresh_frame(images, pans, noise):
    img = images.astype(np.int16)
    stale = np.zeros(len(img), bool)
    fresh = 0
    for t in range(1, len(img)):
        moved = abs(pans[t] - pans[fresh]) > 0.001
        if moved and np.abs(img[t] - img[fresh]).max() <= noise:
            stale[t] = True
        else:
            fresh = t
    return stale


def w_upper_limit_overflow(images, pans, noise):
    stale = np.zeros(len(images), bool)
    for t in range(1, len(images)):
        old, new = images[t - 1], images[t]
        low, high = old - np.uint8(noise), old + np.uint8(noise)
        changed = ((new < low) | (new > high)).any()
        stale[t] = abs(pans[t] - pans[t - 1]) > 0.001 and not changed
    return stale


WRONG = [
    (w_uint8_overflow, "differences in uint8 wrap around: a value that falls by 1 counts as 255; any stale pair with a value that gets smaller within the noise"),
    (w_mean_change, "mean instead of largest change; a fresh picture in which only a few pixels change"),
    (w_strictly_below_noise, "a change equal to the noise counts as a change (>= instead of >), also noise 0; a change of exactly `noise`"),
    (w_compare_with_first, "compares each picture with the first one instead of the one before; any log in which a later picture repeats its predecessor"),
    (w_signed_pan, "forgets the absolute value of the turn; stale pictures while the neck turns right (angle falls)"),
    (w_ignores_noise, "argument noise is not used, only identical pictures are stale; a stale picture with noise"),
    (w_one_entry_short, "answers T-1 entries, the first picture is missing; every input"),
    (w_marks_the_older, "marks the picture before the stale one (index off by one); every log with a stale picture"),
    (w_any_pixel_still, "any unchanged value is enough (any instead of all); a fresh picture with an unchanged corner"),
    (w_threshold_in_degrees, "0.001 is compared with degrees; a neck that moves by less than 0.001 rad and more than 0.001 degrees"),
    (w_forgets_the_neck, "ignores the pans; unchanged pictures while the neck stands still"),
    (w_returns_indices, "answers the numbers of the stale pictures instead of a mask; every input"),
    (w_compares_gray, "compares gray values: a change in one channel shrinks; a picture whose blue changes by a little more than the noise"),
    (w_roll_wraps, "np.roll compares the first picture with the last; a log whose last picture equals the first at another angle"),
    (w_int8_cast, "pictures cast to int8 overflow, the difference wraps; a change of 128 or more, or from 127 to 129"),
    (w_subtract_saturates, "cv2.subtract cuts falling values at 0, so only brightening counts; a fresh picture that only gets darker"),
    (w_last_fresh_frame, "compares with the last picture that was not stale instead of the picture before; two small changes that add up, or the neck moves back"),
    (w_upper_limit_overflow, "old value plus or minus noise wraps in uint8; values near 0 or 255"),
]


def _cases():
    rng = np.random.default_rng(0)

    def a():
        r = np.random.default_rng(1)
        base = r.integers(20, 230, (5, 4, 6, 3)).astype(np.uint8)
        base[2] = base[1] + 2
        base[3] = base[2] - 3
        return base, np.array([0.0, 0.1, 0.3, 0.2, 0.2]), 3

    def b():
        im = np.full((6, 3, 4, 3), 100, np.uint8)
        im[1] += 3          # equal to noise
        im[2] = im[1]
        im[2, 0, 0, 2] += 9  # one blue value
        im[3] = im[2]
        im[4] = im[3]
        im[5] = 90
        return im, np.array([0, 0.2, 0.4, 0.4, 0.4005, 0.1]), 3

    def c():
        im = np.full((4, 3, 4, 3), 1, np.uint8)
        im[1] = 0
        im[2] = 254
        im[3] = 255
        return im, np.array([0, -0.2, 0.4, 0.0]), 2

    def d():
        im = np.zeros((3, 2, 2, 3), np.uint8)
        im[1] += 2
        im[2] += 4
        return im, np.array([0, 0.2, 0.4]), 2

    def e():
        im = np.full((3, 2, 2, 3), 7, np.uint8)
        return im, np.array([0.0, 0.3, 0.5]), 0

    def f():
        im = np.full((2, 2, 2, 3), 200, np.uint8)
        im[1, 0, 0] = 72
        return im, np.array([0.0, 0.3]), 5
    return [a, b, c, d, e, f]
