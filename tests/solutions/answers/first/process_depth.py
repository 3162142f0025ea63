"""Right answers to process_depth, as strangers wrote them."""
import math

import numpy as np


def float64_inside(depth_raw, near=0.01, far=10.0):
    """Computes in float64, casts to float32 unless float64 came in."""
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "iuf":
        raise TypeError("depth must be real numbers")
    if not 0 < near < far:
        raise ValueError("0 < near < far must hold")
    dtype = np.float64 if d.dtype == np.float64 else np.float32
    x = np.clip(d.astype(np.float64), 0, 1)
    return np.asarray(near * far / (far - x * (far - near)), dtype=dtype)


def float32_well_conditioned(depth_raw, near=0.01, far=10.0):
    """Stays in float32, with the denominator as far (1 - d) + near d, which loses nothing near d = 1."""
    raw = np.asarray(depth_raw)
    if not (np.issubdtype(raw.dtype, np.floating) or np.issubdtype(raw.dtype, np.integer)):
        raise TypeError("real numbers, please")
    if not (near > 0 and far > near):
        raise ValueError("clip planes")
    kind = raw.dtype if raw.dtype == np.float64 else np.dtype(np.float32)
    d = np.minimum(np.maximum(raw, 0), 1).astype(kind)
    n, f = kind.type(near), kind.type(far)
    out = n * f / (f * (1 - d) + n * d)
    return np.array(out, dtype=kind)


def plain_loop(depth_raw, near=0.01, far=10.0):
    """Python loop over the flat values with math.isnan, min and max; reshaped at the end."""
    a = np.asarray(depth_raw)
    if a.dtype.kind in "cOSUbmMV":
        raise TypeError(f"dtype {a.dtype}")
    if not near > 0 or not far > near:
        raise ValueError(f"near {near}, far {far}")
    out = []
    for d in a.ravel().tolist():
        if not math.isnan(d):
            d = min(max(float(d), 0.0), 1.0)
            d = near * far / (far - d * (far - near))
        out.append(d)
    return np.array(out, dtype="float64" if a.dtype == np.dtype("float64") else "float32").reshape(a.shape)


def by_reciprocals(depth_raw, near=0.01, far=10.0):
    """1/z is linear in d: np.interp between 1/near and 1/far clips by itself; NaN restored."""
    raw = np.array(depth_raw)
    if raw.dtype.kind not in ("f", "i", "u"):
        raise ValueError("depth must be real numbers")
    if math.isnan(near) or math.isnan(far) or not 0.0 < near < far:
        raise ValueError("clip planes must satisfy 0 < near < far")
    inverse = np.interp(raw.astype(np.float64).ravel(), [0.0, 1.0], [1 / near, 1 / far])
    z = (1 / inverse).reshape(raw.shape)
    z = np.where(np.isnan(raw.astype(np.float64)), np.nan, z)
    return z if raw.dtype == np.float64 else z.astype(np.float32)


def in_place(depth_raw, near=0.01, far=10.0):
    """Works in place on one copy, so the input stays as it was; handles 0-d arrays."""
    source = np.asarray(depth_raw)
    if not np.isrealobj(source) or source.dtype.kind not in "fiu":
        raise TypeError("depth must be real")
    if not near < far or not near > 0:
        raise ValueError("not 0 < near < far")
    work = np.array(source, dtype=np.float64, ndmin=1)
    np.clip(work, 0.0, 1.0, out=work)
    work *= near - far
    work += far
    np.divide(near * far, work, out=work)
    work = work.reshape(source.shape)
    return work.astype(np.float64 if source.dtype.type is np.float64 else np.float32)


class _Projection:
    """The OpenGL way: window to normalized device coordinates to eye depth."""

    def __init__(self, near, far):
        if not (0 < near < far):
            raise ValueError("0 < near < far")
        self.a, self.b = (far + near) / (far - near), 2 * far * near / (far - near)

    def depth(self, window):
        ndc = 2 * window - 1
        return self.b / (self.a - ndc)


def with_a_class(depth_raw, near=0.01, far=10.0):
    """glFrustum's matrix: NDC = 2 d - 1, z = b / (a - NDC), in a class."""
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "iuf":
        raise TypeError("window depth must be real numbers")
    projection = _Projection(float(near), float(far))
    window = np.where(d < 0, 0.0, np.where(d > 1, 1.0, d)).astype(np.float64)
    result = projection.depth(window)
    return np.asarray(result).astype(np.float32 if d.dtype != np.float64 else np.float64)


def natural_float32(depth_raw, near=0.01, far=10.0):
    """The book's formula as it stands, in the dtype that came in (float32 stays float32 all the way)."""
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "iuf":
        raise TypeError("real numbers only")
    if not 0 < near < far:
        raise ValueError("need 0 < near < far")
    if d.dtype != np.float64:
        d = d.astype(np.float32)
    d = np.clip(d, 0, 1)
    return np.asarray(near * far / (far - d * (far - near)), dtype=d.dtype)


def far_at_infinity_too(depth_raw, near=0.01, far=10.0):
    """Divides by far first, so that far = inf (which 0 < near < far allows) gives near / (1 - d)."""
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "iuf":
        raise TypeError("depth must be numbers")
    if not 0 < near < far:
        raise ValueError("bad planes")
    x = np.clip(np.atleast_1d(d).astype(np.float64), 0, 1)
    ratio = near / far
    with np.errstate(divide="ignore"):
        z = near / ((1 - x) + x * ratio)
    return z.reshape(d.shape).astype(np.float64 if d.dtype == np.float64 else np.float32)


ANSWERS = [float64_inside, float32_well_conditioned, plain_loop, by_reciprocals, in_place,
           with_a_class, natural_float32, far_at_infinity_too]
