"""Rays: where they meet the geoms of a scene, one at a time or many from one point."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np
from pyodide.ffi import to_js

from ._derived import FUNCTIONS
from ._engine import bridge
from ._functions import ask_and_recover
from ._signature import Signature

if TYPE_CHECKING:
    from collections.abc import Iterator

_RAY = Signature.parse("mj_ray", FUNCTIONS["mj_ray"])
_MULTI_RAY = Signature.parse("mj_multiRay", FUNCTIONS["mj_multiRay"])


def mj_ray(*arguments: Any, **named: Any) -> float:
    """Cast one ray; return the distance in lengths of its vector, or -1."""
    model, data, point, ray, *options, geom_id, normal = _RAY.bind(arguments, named)
    ids, distances, normals = _cast(bridge.castRay, model, data, point, ray, options)
    _fill(ids, geom_id)
    _fill(normals, normal)
    return float(distances[0])


def mj_multiRay(*arguments: Any, **named: Any) -> None:  # noqa: N802 - MuJoCo's name
    """Cast many rays from one point; write geoms, distances and normals into arrays."""
    values = _MULTI_RAY.bind(arguments, named)
    model, data, point, rays, *options = values[:7]
    geom_ids, distances, normals, count, cutoff = values[7:]
    _check_sizes(rays, geom_ids, distances, normals, count)
    with _looking_at_every_geom(model):
        rest = int(count), float(cutoff)
        answers = _cast(bridge.castRays, model, data, point, rays, options, *rest)
    for answer, array in zip(answers, (geom_ids, distances, normals), strict=True):
        _fill(answer, array)


@contextmanager
def _looking_at_every_geom(model: Any) -> Iterator[None]:
    """Let `mj_multiRay` skip no geom inside the block.

    It skips what lies beyond angles that it computes from the corners of a box, and so loses rays
    at the edges of things that bulge out between these angles. A body without a tree of bounds is
    never skipped.
    """
    kept = model.body_bvhadr.copy()
    model.body_bvhadr[:] = -1
    try:
        yield
    finally:
        model.body_bvhadr[:] = kept


def _cast(
    cast: Any, model: Any, data: Any, point: Any, rays: Any, options: list[Any], *rest: Any
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cast rays; return ids of geoms, distances and normals."""
    groups, sees_static, body = options
    model._memory.push()
    data._memory.push()
    views = ask_and_recover(
        [data],
        cast,
        model._handle,
        data._handle,
        to_js(np.array(point, float).reshape(-1)),
        to_js(np.ascontiguousarray(rays, float).reshape(-1)),
        None if groups is None else to_js(np.array(groups, np.uint8).reshape(-1)),
        bool(sees_static),
        int(body),
        *rest,
    )
    ids, distances, normals = (_read(view, kind) for view, kind in zip(views, "idd", strict=True))
    return ids, distances, normals


def _read(view: Any, kind: str) -> np.ndarray:
    answer = np.empty(view.length, kind)
    view.assign_to(answer)
    return answer


def _fill(answer: np.ndarray, array: Any) -> None:
    if array is not None:
        array[...] = answer.reshape(array.shape)


def _check_sizes(rays: Any, geom_ids: Any, distances: Any, normals: Any, count: int) -> None:
    """Raise TypeError where an array is not as long as the number of rays says."""
    wanted = {"vec": 3 * count, "geomid": count, "dist": count, "normal": 3 * count}
    given = {"vec": rays, "geomid": geom_ids, "dist": distances, "normal": normals}
    for name, array in given.items():
        if array is not None and np.size(array) != wanted[name]:
            raise TypeError(f"{name} should have length {wanted[name]}, got {np.size(array)}")
