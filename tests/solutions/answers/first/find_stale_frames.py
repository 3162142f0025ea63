"""Right answers to find_stale_frames, as strangers wrote them."""
import cv2
import numpy as np


def vectorized(images, pans, noise):
    """int16 differences of all pictures at once, a False in front."""
    T = len(images)
    stale = np.zeros(T, dtype=bool)
    if T > 1:
        change = np.abs(np.diff(images.astype(np.int16), axis=0)).reshape(T - 1, -1).max(axis=1)
        stale[1:] = (np.abs(np.diff(pans)) > 0.001) & (change <= noise)
    return stale


def plain_loop(images, pans, noise):
    """One loop over the pictures, list of bools, np.array(..., dtype=bool) at the end."""
    result = []
    for i in range(len(images)):
        if i == 0:
            result.append(False)
            continue
        moved = abs(float(pans[i]) - float(pans[i - 1])) > 0.001
        largest = int(np.abs(images[i].astype(int) - images[i - 1].astype(int)).max())
        result.append(moved and not largest > noise)
    return np.array(result, dtype=bool)


def with_absdiff(images, pans, noise):
    """cv2.absdiff saturates instead of wrapping; comprehension over pairs."""
    pairs = zip(images, images[1:], pans, pans[1:])
    later = [abs(b - a) > 1e-3 and cv2.absdiff(p, q).max() <= noise for p, q, a, b in pairs]
    return np.array(([False] + later)[:len(images)], dtype=np.bool_)


def nested_loops(images, pans, noise):
    """Goes through all values in Python and stops at the first real change."""
    def changed(a, b):
        for x, y in zip(a.ravel().tolist(), b.ravel().tolist()):
            if x - y > noise or y - x > noise:
                return True
        return False

    stale = np.full(len(images), False)
    for i in range(1, len(images)):
        stale[i] = not -0.001 <= pans[i] - pans[i - 1] <= 0.001 and not changed(images[i], images[i - 1])
    return stale


def max_minus_min(images, pans, noise):
    """Stays in uint8: maximum minus minimum cannot wrap; looks only at frames where the neck moved."""
    stale = np.zeros(images.shape[0], dtype=bool)
    for i in np.flatnonzero(np.abs(pans[1:] - pans[:-1]) > 0.001) + 1:
        a, b = images[i - 1], images[i]
        stale[i] = not np.any(np.maximum(a, b) - np.minimum(a, b) > int(noise))
    return stale


def float_norm(images, pans, noise):
    """float32 inside: exact for bytes; largest norm by cv2.norm(NORM_INF)."""
    flat = [np.ravel(image).astype(np.float32) for image in images]
    moved = np.concatenate([[False], np.abs(np.diff(np.asarray(pans, dtype=np.float64))) > 0.001])[:len(images)]
    same = [i > 0 and cv2.norm(flat[i], flat[i - 1], cv2.NORM_INF) <= noise for i in range(len(flat))]
    return moved & np.array(same, dtype=bool)


class _Log:
    def __init__(self, tolerance):
        self.before, self.tolerance = None, tolerance

    def feed(self, image, pan):
        before, self.before = self.before, (image, pan)
        if before is None:
            return False
        window = (before[0].astype(np.int32) - self.tolerance, before[0].astype(np.int32) + self.tolerance)
        still = bool(((image >= window[0]) & (image <= window[1])).all())
        return still and bool(abs(pan - before[1]) > 0.001)


def with_a_class(images, pans, noise):
    """A small class remembers the picture before; np.fromiter."""
    log = _Log(int(noise))
    return np.fromiter((log.feed(image, pan) for image, pan in zip(images, pans)), dtype=bool)


def recursive_generator(images, pans, noise, least_turn=0.001):
    """Recursion over halves of the log, limit of the angle as optional argument."""
    def walk(start, stop):
        if stop - start == 1:
            if start == 0:
                return [False]
            d = images[start].astype(np.int64) - images[start - 1]
            return [bool(np.abs(pans[start] - pans[start - 1]) > least_turn and np.all(d ** 2 <= int(noise) ** 2))]
        if stop <= start:
            return []
        middle = (start + stop) // 2
        return walk(start, middle) + walk(middle, stop)

    return np.asarray(walk(0, len(images)), dtype=bool)


ANSWERS = [vectorized, plain_loop, with_absdiff, nested_loops, max_minus_min, float_norm,
           with_a_class, recursive_generator]
