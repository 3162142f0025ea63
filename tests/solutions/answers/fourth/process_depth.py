"""Right answers to process_depth, as strangers wrote them."""
import math
from dataclasses import dataclass
from functools import partial
from typing import Optional

import cv2
import numpy as np


# 1. straight from the book: NumPy keeps float32 where the input is float32
def f1(depth_raw, near=0.01, far=10.0):
    d = np.clip(depth_raw, 0, 1)
    return near * far / (far - d * (far - near))


# 2. beginner, loops; NaN first
def f2(depth_raw, near=0.01, far=10.0):
    rows = depth_raw.shape[0]
    cols = depth_raw.shape[1]
    result = np.zeros((rows, cols), dtype=float)
    for r in range(rows):
        for c in range(cols):
            value = float(depth_raw[r, c])
            if math.isnan(value):
                result[r, c] = value
                continue
            if value < 0:
                value = 0.0
            if value > 1:
                value = 1.0
            result[r, c] = near * far / (far - value * (far - near))
    return result


# 3. physicist: 1/z is linear in d
def f3(depth_raw, near=0.01, far=10.0):
    d = np.minimum(np.maximum(np.asarray(depth_raw, np.float64), 0.0), 1.0)
    inverse_z = (1 - d) / near + d / far
    return 1.0 / inverse_z


# 4. game developer: NDC -1..1, linearize as in every GLSL tutorial
def f4(depth_raw, near=0.01, far=10.0):
    depth = np.array(depth_raw, dtype=np.float64)
    depth[depth < 0.0] = 0.0
    depth[depth > 1.0] = 1.0
    z_ndc = depth * 2.0 - 1.0
    return (2.0 * near * far) / (far + near - z_ndc * (far - near))


# 5. game developer: inverse projection matrix, homogeneous coordinates
def f5(depth_raw, near=0.01, far=10.0):
    P = np.array([[-(far + near) / (far - near), -2 * far * near / (far - near)],
                  [-1.0, 0.0]])
    d = np.where(np.isnan(depth_raw), np.nan, np.clip(depth_raw, 0, 1)).astype(float)
    clip = np.stack([2 * d - 1, np.ones_like(d)], axis=-1)
    eye = np.einsum("ij,hwj->hwi", np.linalg.inv(P), clip)
    return -eye[..., 0] / eye[..., 1]


# 6. over-engineered
@dataclass(frozen=True)
class ClipPlanes:
    near: float
    far: float

    def __post_init__(self):
        if not (0 < self.near < self.far):
            raise ValueError("need 0 < near < far")

    @property
    def a(self) -> float:
        return self.far / (self.far - self.near)

    @property
    def b(self) -> float:
        return -self.far * self.near / (self.far - self.near)

    def unproject(self, d: np.ndarray) -> np.ndarray:
        # d = a + b / z
        return self.b / (d - self.a)


def f6(depth_raw: np.ndarray, near: float = 0.01, far: float = 10.0,
       planes: Optional[ClipPlanes] = None) -> np.ndarray:
    if depth_raw.ndim != 2:
        raise ValueError("depth_raw must be (H, W)")
    planes = planes or ClipPlanes(float(near), float(far))
    return planes.unproject(np.clip(depth_raw.astype(np.float64), 0.0, 1.0))


# 7. float32 fan, in the order that loses nothing
def f7(depth_raw, near=0.01, far=10.0):
    one = np.float32(1)
    d = np.clip(np.asarray(depth_raw, dtype=np.float32), np.float32(0), one)
    n, f = np.float32(near), np.float32(far)
    return (n * f / (n * d + f * (one - d))).astype(np.float32)


# 8. vectorize a scalar function, functional style
def _one(d, near, far):
    if d != d:
        return d
    d = sorted((0.0, d, 1.0))[1]
    return near * far / (far - d * (far - near))


def f8(depth_raw, near=0.01, far=10.0):
    return np.vectorize(partial(_one, near=near, far=far), otypes=[float])(
        np.asarray(depth_raw, float))


# 9. masked array
def f9(depth_raw, near=0.01, far=10.0):
    d = np.ma.masked_invalid(np.array(depth_raw, float))
    d = np.ma.array(depth_raw, dtype=float, mask=np.isnan(depth_raw), copy=True)
    d = np.ma.clip(d, 0.0, 1.0)
    z = far * near / (far - (far - near) * d)
    return z.filled(np.nan)


# 10. perspective divide with in-place buffers on a defensive copy
def f10(depth_raw, near=0.01, far=10.0):
    z = np.array(depth_raw, dtype=np.float64, copy=True)
    np.clip(z, 0, 1, out=z)
    z *= near - far
    z += far
    np.reciprocal(z, out=z)
    z *= near * far
    return z


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10]
