"""Objects on a table, with labels and depth: some fit into a hand, some mislead who chooses."""

from __future__ import annotations

from typing import Any

import numpy as np

from labutils import find_valid_depth
from labutils.checks.table import Case
from solutions._cases import make_blocks, make_pose


def make_table(rng: np.random.Generator, label: str) -> Case:
    """Make five objects: near but wide, near but to the side, nearest by distance, and two far."""
    height, width = 48, 72
    focal_px = float(rng.uniform(58, 64))
    K = np.array([[focal_px, 0, 35.1], [0, 1.1 * focal_px, 24.2], [0, 0, 1]])
    labels = np.zeros((height, width), dtype=np.int32)
    depth = np.full((height, width), 2.6, dtype=np.float32)
    near = float(rng.uniform(0.95, 1.05))
    # Left, top, columns, rows, depth. By depth the second is nearest, then the first, which is too
    # wide; by distance the first, then the third. The last two differ in the same way.
    shapes = [
        (22, 3, 30, 9, near - 0.04),
        (1, 18, 7, 20, near - 0.06),
        (31, 20, 9, 11, near + 0.01),
    ]
    shapes += [(42, 16, 8, 12, near + 0.5), (62, 30, 8, 12, near + 0.44)]
    numbers = rng.permutation([1, 2, 3, 4, 5])
    for number, (left, top, columns, rows, z) in zip(numbers, shapes, strict=True):
        where = np.s_[top : top + rows, left : left + columns]
        labels[where] = number
        depth[where] = z + rng.uniform(-0.004, 0.004, size=(rows, columns))
        depth[top : top + rows // 4, left : left + columns] += 0.06  # a part that stands back
        if z < near + 0.4:  # all but the last two have pixels that measured nothing
            depth[top + rows - 1, left : left + 3] = (0, 12, 12)
            depth[top + rows - 1, left + columns - 2 : left + columns] = 12
    # The origin of the world lies at the object on the right: distances from there mislead.
    place = (near + 0.44) * np.array([(65.5 - K[0, 2]) / K[0, 0], (35.5 - K[1, 2]) / K[1, 1], 1])
    return Case(label, (labels, depth, np.round(K, 3), make_pose(rng, place), 0.25))


def make_small_objects(rng: np.random.Generator) -> tuple[Case, ...]:
    """Make three tables of few blocks: a near background, uneven depth, values at their limits."""
    near = float(rng.uniform(0.95, 1.05))
    a, b, c, d = map(int, rng.permutation([1, 2, 3, 4]))
    wide, far = map(int, rng.permutation([2, 3]))
    empty, other = map(int, rng.permutation([1, 2]))
    blocks = {
        "something near is background, and one object has no valid pixel": (
            (0, 9, 3, (near / 2,) * 2),
            (empty, 16, 1, (12.0, 0.0, 12.0)),
            (other, 3, 11, (near + 0.6,) * 3),
            (3, 24, 10, (near,) * 3),
        ),
        # Too wide, for a part of it stands back at the side; a near tip of a far one; the right
        # one, whose median is not at its middle pixel. It is 1, as above it was the last number.
        "objects that are nearer or farther in parts": (
            (wide, 20, 10, (near - 0.2, near - 0.2, near + 0.1)),
            (far, 9, 1, (near - 0.4,) * 2),
            (far, 9, 7, (near + 0.5,) * 2),
            (far, 9, 13, (near + 0.5,) * 2),
            (1, 24, 2, (near + 0.25, near, near + 0.1)),
        ),
        # Hardly valid depths make two too wide; the right one is 4 / 32 m wide, which is exact.
        "depths and a width at their limits": (
            (a, 20, 1, (0.015, 0.8, 0.8)),
            (b, 0, 1, (0.9, 0.9, 9.6)),
            (c, 24, 7, (0.01, 1.0, 1.0, 1.0, 1.0, 1.0, 10.0)),
            (c, 24, 13, (0.004, 1.0, 1.0, 1.0, 1.0, 1.0, 10.5)),
            (d, 6, 9, (near + 0.4,) * 2),
        ),
    }
    K = np.array([[32.0, 0, 10], [0, 35, 8], [0, 0, 1]])
    return tuple(
        Case(label, (*make_blocks(some), K, make_pose(rng, rng.uniform(-1, 1, size=3)), 0.125))
        for label, some in blocks.items()
    )


def fill_objects(args: dict[str, Any]) -> dict[str, Any]:
    """Give the invalid pixels of every object the median depth of the others, or a large one."""
    depth, labels = args["depth_metric"], args["labels"]
    valid = find_valid_depth(depth)
    for label in np.unique(labels[labels > 0]):
        inside = labels == label
        seen = depth[inside & valid]
        depth[inside & ~valid] = np.median(seen) if seen.size else 9.0
    return {"depth_metric": depth}


def move_background(args: dict[str, Any]) -> dict[str, Any]:
    """Move the background behind everything."""
    return {"depth_metric": np.where(args["labels"] == 0, np.float32(9.5), args["depth_metric"])}


def flatten_objects(args: dict[str, Any]) -> dict[str, Any]:
    """Give every object one depth."""
    depth, labels = args["depth_metric"], args["labels"]
    for label in np.unique(labels):
        seen = find_valid_depth(depth) & (labels == label)
        if seen.any():
            depth[seen] = np.median(depth[seen])
    return {"depth_metric": depth}
