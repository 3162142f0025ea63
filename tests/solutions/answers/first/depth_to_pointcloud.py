"""Right answers to depth_to_pointcloud, as strangers wrote them."""
import math

import numpy as np


def _K_strict(K):
    """An intrinsic matrix without skew, as arrays of float64."""
    K = np.asarray(K)
    if K.dtype.kind not in "iuf":
        raise TypeError("K must be real numbers")
    K = K.astype(np.float64)
    if K.shape != (3, 3):
        raise ValueError("K must be 3x3")
    if not np.isfinite(K).all() or K[0, 0] <= 0 or K[1, 1] <= 0:
        raise ValueError("focal lengths must be positive and finite")
    if K[0, 1] != 0 or K[1, 0] != 0 or not np.array_equal(K[2], [0, 0, 1]):
        raise ValueError("K is no intrinsic matrix")
    return K


def vectorized(depth_metric, K, rgb_image=None):
    """np.nonzero of the valid pixels, float64 inside, cast at the end."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in "iuf":
        raise TypeError("depth must be real numbers")
    if depth.ndim != 2:
        raise ValueError("depth must be (H, W)")
    K = _K_strict(K)
    dtype = np.float64 if depth.dtype == np.float64 else np.float32
    z64 = depth.astype(np.float64)
    valid = (z64 > 0.01) & (z64 < 10)
    v, u = np.nonzero(valid)
    z = z64[valid]
    points = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    if rgb_image is None:
        return points.astype(dtype), None
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8:
        raise TypeError("rgb_image must be uint8")
    if rgb.shape != depth.shape + (3,):
        raise ValueError("the pictures differ in size")
    return points.astype(dtype), rgb[valid].astype(np.float32) / 255


def plain_loops(depth_metric, K, rgb_image=None):
    """Two loops over rows and columns, Python lists, arrays at the end."""
    depth = np.asarray(depth_metric)
    if depth.ndim != 2 or depth.dtype.kind not in "iuf":
        raise ValueError("depth is no image of real numbers")
    K = _K_strict(K).tolist()
    fx, cx, fy, cy = K[0][0], K[0][2], K[1][1], K[1][2]
    rgb = None
    if rgb_image is not None:
        rgb = np.asarray(rgb_image)
        if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
            raise ValueError("rgb_image is no color picture")
        if rgb.shape[:2] != depth.shape:
            raise ValueError("the pictures differ in size")
    points, colors = [], []
    for v, row in enumerate(depth.tolist()):
        for u, z in enumerate(row):
            if math.isfinite(z) and 0.01 < z < 10:
                points.append(((u - cx) / fx * z, (v - cy) / fy * z, z))
                if rgb is not None:
                    colors.append(rgb[v, u])
    dtype = np.float64 if depth.dtype == np.float64 else np.float32
    points = np.array(points, dtype=dtype).reshape(-1, 3)
    if rgb is None:
        return points, None
    return points, np.array(colors, dtype=np.float32).reshape(-1, 3) / np.float32(255)


def float32_inside(depth_metric, K, rgb_image=None):
    """Computes in the dtype of the result: float32 unless float64 depth came in."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in "iuf":
        raise TypeError("depth must be real")
    if depth.ndim != 2:
        raise ValueError("depth must have two dimensions")
    K = _K_strict(K)
    dtype = np.dtype("float64") if depth.dtype == "float64" else np.dtype("float32")
    keep = np.isfinite(depth) & (depth > 0.01) & (depth < 10)
    z = depth[keep].astype(dtype)
    x = (np.arange(depth.shape[1], dtype=dtype) - dtype.type(K[0, 2])) / dtype.type(K[0, 0])
    y = (np.arange(depth.shape[0], dtype=dtype) - dtype.type(K[1, 2])) / dtype.type(K[1, 1])
    X, Y = np.meshgrid(x, y)
    points = np.empty((len(z), 3), dtype)
    points[:, 0], points[:, 1], points[:, 2] = X[keep] * z, Y[keep] * z, z
    colors = None
    if rgb_image is not None:
        rgb = np.asarray(rgb_image)
        if rgb.dtype != np.uint8 or rgb.shape != (*depth.shape, 3):
            raise ValueError("rgb_image must be uint8, (H, W, 3), as large as the depth")
        colors = np.divide(rgb[keep], 255, dtype=np.float32)
    return points, colors


def inverse_of_K(depth_metric, K, rgb_image=None):
    """z K^-1 (u, v, 1): also right for a K with skew, which it accepts."""
    d = np.array(depth_metric)
    if d.ndim != 2 or not (np.issubdtype(d.dtype, np.floating) or np.issubdtype(d.dtype, np.integer)):
        raise TypeError("depth must be an image of real numbers")
    K = np.array(K, dtype=np.float64)
    if K.shape != (3, 3) or not np.all(np.isfinite(K)):
        raise ValueError("K must be 3x3")
    if min(K[0, 0], K[1, 1]) <= 0 or K[1, 0] or K[2, 0] or K[2, 1] or K[2, 2] != 1:
        raise ValueError("K must be upper triangular with positive focal lengths and a 1")
    H, W = d.shape
    v, u = np.indices((H, W)).reshape(2, -1)
    rays = np.linalg.inv(K) @ np.stack([u, v, np.ones(u.shape)])
    z = d.reshape(-1).astype(np.float64)
    ok = np.isfinite(z)
    ok[ok] = (z[ok] > 0.01) & (z[ok] < 10)
    points = (rays[:, ok] * z[ok]).T
    points = np.ascontiguousarray(points, dtype=np.float64 if d.dtype == np.float64 else np.float32)
    if rgb_image is None:
        return points, None
    c = np.array(rgb_image)
    if c.dtype != np.uint8:
        raise TypeError("colors must be uint8")
    if c.shape != (H, W, 3):
        raise ValueError("sizes differ")
    return points, (c.reshape(-1, 3)[ok] / 255).astype(np.float32)


def row_by_row(depth_metric, K, rgb_image=None, near=0.01, far=10.0):
    """A generator makes one block per row; the limits are optional arguments."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in "fiu" or depth.ndim != 2:
        raise TypeError("depth is no image of real numbers")
    K = _K_strict(K)
    if rgb_image is not None:
        rgb_image = np.asarray(rgb_image)
        if rgb_image.dtype != np.uint8 or rgb_image.shape != depth.shape + (3,):
            raise ValueError("rgb_image does not fit")
    out = np.float64 if depth.dtype.type is np.float64 else np.float32

    def blocks():
        for v in range(depth.shape[0]):
            z = depth[v].astype(np.float64)
            u = np.flatnonzero((z > near) & (z < far))
            z = z[u]
            x, y = z * (u - K[0, 2]) / K[0, 0], z * ((v - K[1, 2]) / K[1, 1])
            yield np.column_stack([x, y, z]).astype(out), (None if rgb_image is None else rgb_image[v, u])

    parts = list(blocks())
    points = np.concatenate([np.zeros((0, 3), out)] + [p for p, _ in parts])
    if rgb_image is None:
        return points, None
    colors = np.concatenate([np.zeros((0, 3), np.uint8)] + [c for _, c in parts])
    return points, colors * np.float32(1 / 255)


class _Cloud:
    """Collects what was checked, hands out points and colors."""

    def __init__(self, depth, K):
        self.depth = np.asarray(depth)
        if self.depth.dtype.kind not in "iuf":
            raise TypeError(f"depth of dtype {self.depth.dtype}")
        if self.depth.ndim != 2:
            raise ValueError(f"depth of shape {self.depth.shape}")
        self.K = _K_strict(K)
        z = self.depth.astype(float)
        z[~np.isfinite(z)] = 0.0
        self.valid = np.logical_and(np.greater(z, 0.01), np.less(z, 10.0))
        self.z = z

    @property
    def points(self):
        v, u = np.ogrid[:self.depth.shape[0], :self.depth.shape[1]]
        xyz = np.dstack([(u - self.K[0, 2]) / self.K[0, 0] * self.z,
                         (v - self.K[1, 2]) / self.K[1, 1] * self.z, self.z])
        return xyz[self.valid].astype("f8" if self.depth.dtype == np.float64 else "f4")

    def colors(self, rgb):
        rgb = np.asarray(rgb)
        if rgb.dtype != np.uint8:
            raise TypeError(f"picture of dtype {rgb.dtype}")
        if rgb.ndim != 3 or rgb.shape[2] != 3 or rgb.shape[:2] != self.valid.shape:
            raise ValueError(f"picture of shape {rgb.shape}, depth of shape {self.valid.shape}")
        table = (np.arange(256) / 255).astype(np.float32)
        return table[rgb[self.valid]]


def with_a_class(depth_metric, K, rgb_image=None):
    """A class; colors from a table of 256 floats; integer depth gives float32."""
    cloud = _Cloud(depth_metric, K)
    colors = None if rgb_image is None else cloud.colors(rgb_image)
    return cloud.points, colors


def comprehension(depth_metric, K, rgb_image=None):
    """List comprehensions over flat pixel numbers, divmod for row and column."""
    depth = np.asarray(depth_metric)
    if depth.ndim != 2:
        raise ValueError("depth must be two-dimensional")
    if depth.dtype.kind not in "iuf":
        raise TypeError("depth must be real")
    matrix = _K_strict(K)
    (fx, _, cx), (_, fy, cy) = matrix[:2].tolist()
    rgb = None if rgb_image is None else np.asarray(rgb_image)
    if rgb is not None and (rgb.dtype != np.uint8 or rgb.shape != depth.shape + (3,)):
        raise ValueError("rgb_image must be uint8 and as large as the depth")
    flat = depth.ravel().tolist()
    index = [i for i, z in enumerate(flat) if 0.01 < z < 10]
    points = [[(i % depth.shape[1] - cx) * flat[i] / fx, (i // depth.shape[1] - cy) * flat[i] / fy, flat[i]]
              for i in index]
    points = np.array(points, "float64").reshape(len(index), 3)
    if depth.dtype != np.float64:
        points = points.astype("float32")
    if rgb is None:
        return points, None
    return points, (rgb.reshape(-1, 3)[np.array(index, dtype=int)] / np.float32(255)).astype(np.float32)


ANSWERS = [vectorized, plain_loops, float32_inside, inverse_of_K, row_by_row, with_a_class, comprehension]
