"""Valid input of the exercises whose arguments are numbers, short lists or a text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from solutions._cases import make_rotation

if TYPE_CHECKING:
    from collections.abc import Callable


def _choose_pan(rng: np.random.Generator) -> tuple[Any, ...]:
    width, height = rng.integers(1, 900, size=2)
    u = rng.uniform(-0.2, 1.2) * width
    return (
        float(u),
        float(rng.uniform(-1.5, 1.5)),
        float(rng.uniform(0.1, 2.9)),
        int(width),
        int(height),
    )


def _intrinsics_matrix(rng: np.random.Generator) -> tuple[Any, ...]:
    width, height = rng.integers(1, 2000, size=2)
    return float(rng.uniform(0.05, 3.1)), int(width), int(height)


def _which_camera(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        width, height = map(int, rng.integers(20, 400, size=2))
        count = int(rng.integers(1, 10))
        fovs = rng.uniform(0.2, 2.5, size=int(rng.integers(1, 7)))
        center = np.array([(width - 1) / 2, (height - 1) / 2])
        focals = height / (2 * np.tan(fovs / 2))
        slopes = (rng.uniform([0, 0], [width, height], size=(count, 2)) - center) / rng.choice(
            focals
        )
        z = rng.uniform(0.3, 5, size=(count, 1))
        points = np.hstack([slopes * z, z])
        pixels = slopes * rng.choice(focals) + center + rng.uniform(-1, 1, size=(count, 2))
        gaps = focals[:, None, None] * slopes + center - pixels
        errors = np.sort(np.sqrt((gaps**2).sum(axis=2)).mean(axis=1))
        if len(errors) == 1 or errors[1] - errors[0] > 0.05:  # no near tie
            return points, pixels, fovs, width, height


def _camera_to_world(rng: np.random.Generator) -> tuple[Any, ...]:
    points = rng.uniform(-6, 6, size=(int(rng.integers(0, 6)), 3))
    if rng.random() < 0.2:
        points = points.astype(rng.choice(["float32", "int64"]))
    rotation = make_rotation(rng, 0.0, 3.1)
    if rng.random() < 0.1:  # along the axes of the world
        rotation = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
    return points, rng.uniform(-5, 5, size=3), rotation.ravel() if rng.random() < 0.5 else rotation


def _find_stale_frames(rng: np.random.Generator) -> tuple[Any, ...]:
    """Draw a log whose changes lie around the noise, on both sides, and steps around 0.001."""
    count, height, width = map(int, rng.integers(1, 6, size=3))
    noise = int(rng.choice([0, 1, 3, 8, 100, 200]))
    pictures = [rng.integers(0, 256, size=(height, width, 3))]
    pans = [float(rng.uniform(-2, 2))]
    for _ in range(count - 1):
        change = rng.integers(-noise, noise + 1, size=(height, width, 3))
        if rng.random() < 0.4:
            change[-1, -1, rng.integers(3)] = rng.choice([-1, 1]) * (noise + rng.integers(0, 3))
        whole = rng.integers(0, 256, size=change.shape) if rng.random() < 0.2 else pictures[-1]
        pictures.append(np.clip(whole + change, 0, 255))
        steps = [0.0, 0.0005, 0.0009, 0.0011, 0.0015, 0.05, 0.5, 1.5]
        pans.append(pans[-1] + float(rng.choice(steps)) * float(rng.choice([-1, 1])))
    return np.array(pictures).astype(np.uint8), np.array(pans), noise


def _parse_ply(rng: np.random.Generator) -> tuple[Any, ...]:
    names = ["x", "y", "z", *(["red", "green", "blue"] if rng.random() < 0.6 else [])]
    names += list(rng.choice(["nx", "quality", "alpha"], size=rng.integers(0, 3), replace=False))
    if rng.random() < 0.7:
        names = [str(name) for name in rng.permutation(names)]
    count, faces = int(rng.integers(0, 6)), int(rng.integers(0, 4))
    faces *= count > 0  # without points there is nothing between them
    header = ["ply", "format ascii 1.0"]
    if rng.random() < 0.5:
        words = ["made by hand", "element vertex 3", "end_header", "property float red"]
        header.append(f"comment {rng.choice(words)}")
    header.append(f"element vertex {count}")
    for name in names:
        header.append(f"property {'uchar' if name in ('red', 'green', 'blue') else 'float'} {name}")
        if rng.random() < 0.1:
            header.append("comment property float w")
    if faces:
        header += [f"element face {faces}", "property list uchar int vertex_indices"]
        header += ["property int flags"] if rng.random() < 0.3 else []
    gap, form = str(rng.choice([" ", "  ", "\t"])), str(rng.choice([".4f", ".4e"]))
    rows = [
        gap.join(
            str(rng.integers(0, 256))
            if name in ("red", "green", "blue")
            else format(rng.uniform(-3, 3), form)
            for name in names
        )
        for _ in range(count)
    ]
    corners = [" ".join(map(str, [3, *rng.integers(0, count, size=3)])) for _ in range(faces)]
    return ("\n".join([*header, "end_header", *rows, *corners]) + "\n",)


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "choose_pan": _choose_pan,
    "intrinsics_matrix": _intrinsics_matrix,
    "which_camera": _which_camera,
    "camera_to_world": _camera_to_world,
    "find_stale_frames": _find_stale_frames,
    "parse_ply": _parse_ply,
}
