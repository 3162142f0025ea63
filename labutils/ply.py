"""Write point clouds as PLY, the format every viewer reads.

Taught in: step 6.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from labutils._guards import check_colors, check_columns


def write_ply(path: str | Path, points: np.ndarray, colors: np.ndarray | None = None) -> Path:
    """Write a point cloud as binary PLY, readable by Open3D, MeshLab and CloudCompare.

    Written here, not by Open3D, because Open3D cannot even be imported on a machine without the
    EGL library, and the file must come out there too.

    Parameters
    ----------
    path : path
        The file; its folder must exist.
    points : array-like, real, shape (N, 3)
        Meters; stored as float32.
    colors : array-like, real in [0, 1], shape (N, 3), optional
        RGB; stored as uint8.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit, or a color lies outside [0, 1]. Nothing is written then.

    References
    ----------
    .. [1] Turk, The PLY Polygon File Format, 1994.
    """
    points = check_columns("points", points, 3)
    fields = [("x", "<f4"), ("y", "<f4"), ("z", "<f4")]
    header = ["property float x", "property float y", "property float z"]
    if colors is not None:
        colors = check_colors(colors, len(points))
        fields += [("red", "u1"), ("green", "u1"), ("blue", "u1")]
        header += ["property uchar red", "property uchar green", "property uchar blue"]
    vertices = np.empty(len(points), dtype=fields)
    for axis, name in enumerate(("x", "y", "z")):
        vertices[name] = points[:, axis]
    if colors is not None:
        for channel, name in enumerate(("red", "green", "blue")):
            vertices[name] = np.round(colors[:, channel] * 255)
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}", *header]
    path = Path(path)
    path.write_bytes(("\n".join([*lines, "end_header"]) + "\n").encode() + vertices.tobytes())
    return path
