"""Write and read point clouds as PLY, the format every viewer reads.

Own code, because nothing else fits: `plyfile` reads all forms right, but is under the GPL, and this
library under MIT; `trimesh` refuses binary lists of different lengths, keeps the low byte of 16-bit
colors and takes a text that is cut short; Open3D cannot be imported without EGL. The page's Python
has NumPy and OpenCV only.

Taught in: step 6.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from labutils._files import write_in_one_step
from labutils._guards import check_colors, check_columns, check_finite_rows
from labutils._ply_parts import AXES, CHANNELS, read_columns, read_header

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: Frames that have a name in this library, and what the file says about them.
_FRAMES = {
    "camera": "OpenCV camera (x right, y down, z forward)",
    "world": "world (z up)",
}

#: A comment stays far below the shortest line that readers have room for.
_LONGEST_FRAME = 200


def write_ply(
    path: str | Path,
    points: ArrayLike,
    colors: ArrayLike | None = None,
    *,
    frame: str | None = None,
) -> Path:
    """Write a point cloud as binary PLY, readable by Open3D, MeshLab and CloudCompare.

    Two comments in the header say the unit, meters, and the frame. The file appears as a whole:
    where it cannot be written, what was there before stays.

    Parameters
    ----------
    path : path
        The file; its folder must exist.
    points : array-like, real and finite, shape (N, 3)
        Meters; stored as float32, so off by at most 0.0005 mm at 10 m. Subtract an origin from
        coordinates of a map first.
    colors : array-like, real in [0, 1], shape (N, 3), optional
        RGB; stored as 8 bits. Colors of a picture, 0 to 255, are to be divided by 255.
    frame : str, optional
        "camera" for the OpenCV camera frame (x right, y down, z forward), "world" for a frame whose
        z points up, or one line of ASCII text that says which frame it is. Without it, the file
        says that the frame is unknown.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    TypeError, ValueError, OSError
        If a shape does not fit, a point is not finite or too large for float32, a color lies
        outside [0, 1] or is an unsigned number as in a picture, or the frame is no line of text.
        Nothing is written then.

    References
    ----------
    .. [1] Turk, The PLY Polygon File Format, 1994.
    """
    cloud = check_finite_rows("points", check_columns("points", points, 3), np.float32)
    comments = [f"comment frame: {_describe_frame(frame)}", "comment unit: meter"]
    fields = [(name, "<f4") for name in AXES]
    properties = [f"property float {name}" for name in AXES]
    if colors is not None:
        colors = check_colors(colors, len(cloud))
        fields += [(name, "u1") for name in CHANNELS]
        # Not "uchar", the older word for the same: meshio takes that for signed numbers.
        properties += [f"property uint8 {name}" for name in CHANNELS]
    vertices = np.empty(len(cloud), dtype=fields)
    for axis, name in enumerate(AXES):
        vertices[name] = cloud[:, axis]
    if colors is not None:
        for channel, name in enumerate(CHANNELS):
            vertices[name] = np.round(colors[:, channel] * 255)
    lines = ["ply", "format binary_little_endian 1.0", *comments]
    lines += [f"element vertex {len(cloud)}", *properties, "end_header", ""]
    return write_in_one_step(path, "\n".join(lines).encode("ascii") + vertices.tobytes())


def read_ply(path: str | Path) -> tuple[np.ndarray, np.ndarray | None]:
    """Read the points and colors of a PLY file, whoever wrote it.

    Text or binary, in either byte order. Other properties of the vertices, such as normals, and
    other elements, such as faces, are skipped.

    Parameters
    ----------
    path : path
        The file.

    Returns
    -------
    points : ndarray, float32 or float64, shape (N, 3)
        In the unit and the frame of the file, which `read_ply_comments` may tell. float32 where the
        file has its x, y and z so, else float64.
    colors : ndarray, float32, shape (N, 3), or None
        RGB in [0, 1], from 8-bit, 16-bit or floating-point colors; None where the file has none.

    Raises
    ------
    ValueError
        If the file is no PLY file or cut short, its vertices lack x, y or z, a point is not finite,
        or a color lies outside its range. The message names the file, and the first vertex that
        is wrong by its index.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     points, colors = read_ply(write_ply(f"{folder}/cloud.ply", [[1.0, 2.0, 3.0]]))
    >>> points
    array([[1., 2., 3.]], dtype=float32)
    >>> colors is None
    True

    References
    ----------
    .. [1] Turk, The PLY Polygon File Format, 1994.
    """
    content = Path(path).read_bytes()
    try:
        columns = read_columns(content, read_header(content))
        return _make_points(columns), _make_colors(columns)
    except ValueError as error:
        raise ValueError(f"{Path(path).name}: {error}") from None


def read_ply_comments(path: str | Path) -> tuple[str, ...]:
    """Read the comments in the header of a PLY file, which may tell its frame and unit.

    Parameters
    ----------
    path : path
        The file.

    Returns
    -------
    tuple of str
        One line each, without the word ``comment``, in the order of the file.

    Raises
    ------
    ValueError, OSError
        If the file is no PLY file, or cannot be read.
    """
    try:
        return read_header(Path(path).read_bytes()).comments
    except ValueError as error:
        raise ValueError(f"{Path(path).name}: {error}") from None


def _describe_frame(frame: str | None) -> str:
    if frame is None:
        return "unknown"
    if not isinstance(frame, str):
        raise TypeError(f"frame: expected text, got {type(frame).__name__} {frame!r}")
    text = _FRAMES.get(frame, frame)
    fits = text.strip() and len(text) <= _LONGEST_FRAME and text.isascii() and text.isprintable()
    # Simple readers look for the end of the header without looking for the start of a line.
    if not fits or "end_header" in text:
        raise ValueError(
            f"frame: expected 'camera', 'world' or one line of at most {_LONGEST_FRAME} ASCII "
            f"characters, got {text[:60]!r}"
        )
    return text


def _make_points(columns: dict[str, np.ndarray]) -> np.ndarray:
    points = np.stack([columns[name] for name in AXES], axis=1)
    return check_finite_rows(
        "points", points, np.float32 if points.dtype == np.float32 else np.float64
    )


def _make_colors(columns: dict[str, np.ndarray]) -> np.ndarray | None:
    if CHANNELS[0] not in columns:
        return None
    channels = []
    for name in CHANNELS:
        stored = columns[name]
        if stored.dtype.kind != "f" and stored.dtype not in (np.uint8, np.uint16):
            raise ValueError(f"{name}: expected uchar, ushort, float or double, got {stored.dtype}")
        scale = 1 if stored.dtype.kind == "f" else np.iinfo(stored.dtype).max
        channels.append((stored / scale).astype(np.float32))
    colors = np.stack(channels, axis=1)
    inside = ((colors >= 0) & (colors <= 1)).all(axis=1)
    if not inside.all():
        first = int(inside.argmin())
        raise ValueError(f"colors[{first}]: expected 0 to 1, got {colors[first].tolist()}")
    return colors
