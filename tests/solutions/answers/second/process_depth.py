"""Right answers to process_depth, as strangers wrote them."""
import math
from dataclasses import dataclass

import numpy as np


# 1. the formula, as the array comes
def f1(depth_raw, near=0.01, far=10.0):
    d = np.clip(depth_raw, 0, 1)
    return near * far / (far - d * (far - near))


# 2. float64
def f2(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw, dtype=np.float64)
    d = np.where(d < 0, 0.0, np.where(d > 1, 1.0, d))
    return 1.0 / ((1 - d) / near + d / far)


# 3. float32, but in the stable form
def f3(depth_raw, near=0.01, far=10.0):
    d = np.array(depth_raw, dtype=np.float32)
    np.clip(d, 0, 1, out=d)
    n, f = np.float32(near), np.float32(far)
    return (n * f / (n + (np.float32(1) - d) * (f - n))).astype(np.float32)


# 4. C programmer
def f4(depth_raw, near=0.01, far=10.0):
    H, W = depth_raw.shape
    out = np.empty((H, W), dtype=np.float32)
    for v in range(H):
        for u in range(W):
            d = float(depth_raw[v, u])
            if math.isnan(d):
                out[v, u] = math.nan
                continue
            if d < 0.0:
                d = 0.0
            elif d > 1.0:
                d = 1.0
            out[v, u] = near * far / (far - d * (far - near))
    return out


# 5. the graphics way: NDC and the entries of the projection matrix
def f5(depth_raw, near=0.01, far=10.0):
    ndc = 2 * np.clip(depth_raw.astype(np.float64), 0, 1) - 1
    A = -(far + near) / (far - near)
    B = -2 * far * near / (far - near)
    return B / (ndc + A)


# 6. homogeneous: inverse of the 2x2 map z -> d
def f6(depth_raw, near=0.01, far=10.0):
    forward = np.array([[far, -far * near], [far - near, 0.0]])   # d = (f z - f n) / ((f-n) z)
    d = np.minimum(np.maximum(depth_raw, 0.0), 1.0)
    h = np.einsum("ij,jvu->ivu", np.linalg.inv(forward),
                  np.stack([d, np.ones_like(d)]).astype(np.float64))
    return h[0] / h[1]


# 7. vectorize, one line
f7_ = np.vectorize(lambda d, n, f: d if d != d else n * f / (f - min(max(d, 0.), 1.) * (f - n)), otypes=[float])


def f7(depth_raw, near=0.01, far=10.0):
    with np.errstate(invalid="ignore"):
        return f7_(depth_raw, near, far)


# 8. a validating converter that masks NaN
@dataclass(frozen=True)
class _ClipPlanes:
    near: float
    far: float

    def __post_init__(self):
        if not 0 < self.near < self.far:
            raise ValueError("need 0 < near < far")

    def to_metric(self, window):
        known = ~np.isnan(window)
        meters = np.full(window.shape, np.nan)
        d = window[known].astype(np.float64)
        d[d > 1] = 1
        d[d < 0] = 0
        meters[known] = np.reciprocal(1 / self.near + d * (1 / self.far - 1 / self.near))
        return meters


def f8(depth_raw: np.ndarray, near: float = 0.01, far: float = 10.0) -> np.ndarray:
    return _ClipPlanes(near, far).to_metric(np.asarray(depth_raw))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
