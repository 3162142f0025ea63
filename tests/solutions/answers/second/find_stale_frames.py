"""Right answers to find_stale_frames, as strangers wrote them."""
import itertools
from dataclasses import dataclass

import cv2
import numpy as np


# 1. vectorised, int16 difference of the whole log
def f1(images, pans, noise):
    moved = np.abs(np.diff(pans)) > 0.001
    change = np.abs(np.diff(images.astype(np.int16), axis=0))
    change = change.max(axis=(1, 2, 3), initial=0)
    return np.concatenate([np.zeros(min(1, len(pans)), bool),
                           moved & (change <= noise)])


# 2. C programmer: loops and early exit by rows
def f2(images, pans, noise):
    T = len(images)
    out = np.zeros(T, dtype=bool)
    for t in range(1, T):
        if abs(pans[t] - pans[t - 1]) <= 0.001:
            continue
        changed = False
        for row in range(images.shape[1]):
            a = images[t, row].astype(int)
            b = images[t - 1, row].astype(int)
            if (abs(a - b) > noise).any():
                changed = True
                break
        if not changed:
            out[t] = True
    return out


# 3. OpenCV: absdiff
def f3(images, pans, noise):
    stale = [False]
    for before, now, a, b in zip(images[:-1], images[1:], pans[:-1], pans[1:]):
        diff = cv2.absdiff(np.ascontiguousarray(before), np.ascontiguousarray(now))
        stale.append(bool(abs(b - a) > 0.001 and int(diff.max()) <= noise))
    return np.array(stale[:len(images)], dtype=bool)


# 4. uint8 only: max minus min
def f4(images, pans, noise):
    out = np.zeros(len(images), np.bool_)
    hi = np.maximum(images[1:], images[:-1])
    lo = np.minimum(images[1:], images[:-1])
    big = (hi - lo > noise).any(axis=(1, 2, 3))
    np.logical_and(~big, np.abs(pans[1:] - pans[:-1]) > 1e-3, out=out[1:])
    return out


# 5. one-liner
def f5(images, pans, noise):
    return np.array([t > 0 and abs(pans[t] - pans[t - 1]) > .001 and np.abs(images[t] - images[t - 1].astype(float)).max() <= noise for t in range(len(pans))], bool)


# 6. float32, GPU habits: everything in one tensor
def f6(images, pans, noise):
    frames = images.reshape(images.shape[0], -1).astype(np.float32)
    delta = np.empty_like(frames)
    delta[:1] = 0
    np.subtract(frames[1:], frames[:-1], out=delta[1:])
    quiet = np.abs(delta).max(axis=1) <= np.float32(noise)
    step = np.diff(pans, prepend=pans[:1])
    return quiet & (np.abs(step) > 0.001)


# 7. dataclass and itertools.pairwise
@dataclass(frozen=True)
class _Frame:
    image: np.ndarray
    pan: float

    def moved_since(self, other, tol=0.001):
        return abs(self.pan - other.pan) > tol

    def differs_from(self, other, noise):
        return not np.allclose(self.image.astype(np.int32), other.image.astype(np.int32),
                               rtol=0, atol=noise)


def f7(images, pans, noise):
    if len(images) != len(pans):
        raise ValueError("one angle per picture, please")
    log = [_Frame(i, float(p)) for i, p in zip(images, pans)]
    flags = (now.moved_since(old) and not now.differs_from(old, noise)
             for old, now in itertools.pairwise(log))
    return np.fromiter(itertools.chain([False], flags), dtype=bool, count=len(log))


# 8. recursion: cut the log in halves
def f8(images, pans, noise):
    def go(first, last):   # pictures first .. last-1
        if last - first <= 0:
            return []
        if last - first == 1:
            if first == 0:
                return [False]
            moved = not -0.001 <= pans[first] - pans[first - 1] <= 0.001
            d = np.subtract(images[first], images[first - 1], dtype=np.int64)
            return [moved and d.max() <= noise and d.min() >= -noise]
        middle = (first + last) // 2
        return go(first, middle) + go(middle, last)
    return np.asarray(go(0, len(images)), dtype=bool)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
