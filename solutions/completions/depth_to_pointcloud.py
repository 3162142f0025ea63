"""Step 5: the points of a map of heights."""

from __future__ import annotations

import numpy as np

from solutions._completion import Case, Completion, Part, Slip


def height_map_to_points(heights: np.ndarray, cell: float) -> np.ndarray:
    """Turn a map of heights into points.

    Parameters
    ----------
    heights : ndarray, float32, shape (H, W)
        Height of every cell, meters; what is not finite is unknown.
    cell : float
        From one cell to the next, meters.

    Returns
    -------
    ndarray, float, shape (N, 3)
        x = column times cell, y = row times cell, z = the height
        where it is known, meters.
    """
    rows, columns = heights.shape
    u, v = np.meshgrid(np.arange(columns), np.arange(rows))  # open: column, row of every cell
    points = np.stack([u * cell, v * cell, heights], axis=-1)
    known = np.isfinite(heights)
    known_points = points[known]  # open: only those that are known, shape (N, 3)
    return known_points


def _choose(cases: tuple[Case, ...]) -> tuple[Case, ...]:
    clean, spoiled = cases[0].args[0], cases[1].args[0]
    return (
        Case("every height is known", (clean, 0.05)),
        Case("some heights are unknown", (spoiled, 0.2)),
    )


COMPLETION = Completion(
    title="points of a map of heights",
    statement="A laser scanner over a table has measured a height for every square of a grid, "
    "but not for all of them. No camera is involved: a square lies where its column and its row "
    "are.",
    section="step5-worked-grid",
    twin=height_map_to_points,
    parts=(Part("points", "cloud", "float", atol=1e-4, unit="m"),),
    cases=_choose,
    slips=(
        Slip(
            "rows-first",
            "the grid has the wrong shape, it is as wide as the map is high. np.meshgrid wants "
            "what counts columns first.",
            line="u, v = np.meshgrid(np.arange(rows), np.arange(columns))",
        ),
        Slip(
            "all-cells",
            "squares without a known height became points too, with NaN or infinity as their "
            "height. Pick with the mask.",
            line="known_points = points.reshape(-1, 3)",
        ),
    ),
    example="""\
heights = np.where(lab.find_valid_depth(depth), 2.2 - depth, np.nan)
points = height_map_to_points(heights[::4, ::4], 0.01)
print(len(points), "points up to", points[:, 2].max().round(2), "m")""",
)
