"""Look at whatever a function answers: a picture, a mask, a depth image, a cloud, a number.

The plots of `labutils.figures` are called by what they draw. Whoever tries a function does not want
to choose one first: `show` looks at what came, and refuses what is neither.
"""

from __future__ import annotations

import numbers
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from labutils._guards import _describe

#: An array of so many numbers, such as K or a pose, is read rather than looked at.
_MOST_READ = 16
#: A table of so many columns is none of pixels: pixels (u, v), boxes, planes.
_MOST_COLUMNS = 4
#: Of longer arrays the first and the last rows are printed.
_MOST_PRINTED = 60
_DECIMALS = 4
_COLUMNS_OF_TEXT = 76
_PICTURES_IN_A_ROW = 3

_EXPECTED = (
    "a picture (uint8, (H, W, 3)), a mask (bool or uint8, (H, W)), a depth image (float, (H, W)), "
    "points (float, (N, 3)), numbers or text"
)


def show(thing: Any, title: str = "", *, frame: str = "camera") -> None:
    """Show what a function has answered, also in the middle of a cell.

    Parameters
    ----------
    thing : array, Picture, mapping, tuple, number, str or None
        A picture, uint8 RGB (H, W, 3); a mask, bool or uint8 (H, W), in black and white; a depth
        image, float (H, W), in meters; points, float (N, 3). A mapping shows its pictures side by
        side under their titles, and a tuple its parts one after another, but (points, colors) as
        one cloud. Everything else is printed: numbers with four decimals, long arrays in part.
    title : str
        Above the picture, or before what is printed.
    frame : "camera" or "world"
        Of points: which way is up, as in `labutils.figures.plot_cloud`.

    Returns
    -------
    None
        What is shown is shown already; outside of a notebook, a line of text stands for a picture.

    Raises
    ------
    TypeError, ValueError
        If it is nothing of that, such as a picture of the wrong dtype, or holds no finite number.

    Examples
    --------
    >>> show(np.array([[579.4113, 0, 319.5], [0, 579.4113, 239.5], [0, 0, 1]]), "K")
    K
    [[579.4113   0.0000 319.5000]
     [  0.0000 579.4113 239.5000]
     [  0.0000   0.0000   1.0000]]
    >>> show((320, 241.5), "center")
    center: (320, 241.5000)
    """
    for view in _find_views(thing, title, frame):
        _display(view)


def _display(view: Any) -> None:
    if isinstance(view, str):
        print(view)
        return
    try:
        from IPython.display import display  # noqa: PLC0415 - a script may have no IPython
    except ImportError:
        print(repr(view))
    else:
        display(view)  # type: ignore[no-untyped-call]


def _find_views(thing: Any, title: str, frame: str) -> Iterator[Any]:
    """Turn a thing into finished pictures and lines of text."""
    if isinstance(thing, Mapping):
        yield from _view_mapping(thing, title, frame)
    elif isinstance(thing, tuple | list) and _is_cloud_with_colors(thing):
        yield from _view_cloud(thing[0], thing[1], title, frame)
    elif isinstance(thing, tuple | list) and any(_has_rows(part) for part in thing):
        for part in thing:
            yield from _find_views(part, title, frame)
    elif isinstance(thing, np.ndarray) and not _is_read(thing):
        yield from _view_array(thing, title, frame)
    elif _draws_itself(thing):
        yield from ([title] if title else [])
        yield thing
    else:
        yield _add_title(_write(thing), title)


def _view_mapping(things: Mapping[Any, Any], title: str, frame: str) -> Iterator[Any]:
    if not things:
        raise ValueError("thing: expected one picture at least in the mapping, got none")
    if title:
        yield title
    if all(_is_picture(one) or _is_mask(one) for one in things.values()):
        pictures = {str(name): _make_rgb(one) for name, one in things.items()}
        yield _plot_images(pictures)
        return
    for name, one in things.items():
        yield from _find_views(one, str(name), frame)


def _view_array(array: np.ndarray, title: str, frame: str) -> Iterator[Any]:
    if _is_picture(array) or _is_mask(array):
        picture = _plot_images({title: _make_rgb(array)})
        # without a title, nothing else would say in words what is there
        picture.summary = title or f"a picture of {array.shape[1]} x {array.shape[0]} pixels"
        yield picture
    elif _is_cloud(array):
        yield from _view_cloud(array, None, title, frame)
    elif array.ndim == 2 and array.dtype.kind == "f":
        yield _plot_depth(array, title)
    else:
        raise TypeError(f"thing: expected {_EXPECTED}, got {_describe(array)}{_advise(array)}")


def _advise(array: np.ndarray) -> str:
    """Say what to do with an array that is nearly something."""
    if array.ndim == 3 and array.shape[2] == 3:
        if array.dtype.kind == "f" and array.size and np.nanmax(array) <= 1:
            return ": colors from 0 to 1 become a picture by (255 * colors).astype(np.uint8)"
        return ": the colors of a picture are uint8; .astype(np.uint8) converts 0 to 255"
    if array.ndim == 2 and array.dtype.kind in "iu":
        return ": of numbers of objects, show one as a mask, such as labels == 1"
    return ""


def _view_cloud(
    points: np.ndarray, colors: np.ndarray | None, title: str, frame: str
) -> Iterator[Any]:
    from labutils.figures import plot_cloud  # noqa: PLC0415 - figures are for those who look

    finite = np.isfinite(points).all(axis=1)
    if not finite.any():
        raise ValueError(f"thing: expected one finite point at least, got none of {len(points)}")
    yield from ([title] if title else [])
    if not finite.all():
        yield f"Of {len(points)} points, {(~finite).sum()} are not finite: they are left out."
    yield plot_cloud(points[finite], None if colors is None else colors[finite], frame=frame)


def _plot_depth(depth: np.ndarray, title: str) -> Any:
    from labutils.figures import plot_depth  # noqa: PLC0415 - as above

    if not np.isfinite(depth).any():
        raise ValueError(f"thing: expected one finite depth at least, got {_describe(depth)}")
    return plot_depth(depth, title=title)


def _plot_images(pictures: dict[str, np.ndarray]) -> Any:
    from labutils.figures import plot_images  # noqa: PLC0415 - as above

    return plot_images(pictures, columns=min(len(pictures), _PICTURES_IN_A_ROW))


def _make_rgb(image: np.ndarray) -> np.ndarray:
    """Return three channels: a mask of one value only has no contrast to draw it by."""
    if image.ndim == 3:
        return image
    is_mask = image.dtype == np.bool_ or not np.setdiff1d(image, (0, 1, 255)).size
    gray = np.where(image, np.uint8(255), np.uint8(0)) if is_mask else image
    return np.repeat(gray[..., None], 3, axis=2)


def _is_picture(thing: Any) -> bool:
    return (
        isinstance(thing, np.ndarray)
        and thing.dtype == np.uint8
        and thing.ndim == 3
        and thing.shape[2] == 3
        and thing.size > 0
    )


def _is_mask(thing: Any) -> bool:
    return (
        isinstance(thing, np.ndarray)
        and thing.dtype in (np.uint8, np.bool_)
        and thing.ndim == 2
        and not _is_read(thing)
    )


def _is_cloud(thing: Any) -> bool:
    return (
        isinstance(thing, np.ndarray)
        and thing.dtype.kind == "f"
        and thing.ndim == 2
        and thing.shape[1] == 3
        and thing.size > _MOST_READ
    )


def _is_cloud_with_colors(thing: tuple[Any, ...] | list[Any]) -> bool:
    if len(thing) != 2 or not _is_cloud(thing[0]):
        return False
    colors = thing[1]
    if colors is None:
        return True
    return _is_cloud(colors) and len(colors) == len(thing[0]) and _is_share(colors)


def _is_share(colors: np.ndarray) -> bool:
    return bool(colors.min() >= 0 and colors.max() <= 1)


def _has_rows(thing: Any) -> bool:
    return isinstance(thing, np.ndarray) and thing.ndim >= 2


def _is_read(array: np.ndarray) -> bool:
    """Whether an array is printed: few numbers, one row of them, or a table of few columns."""
    is_table = array.ndim == 2 and array.shape[1] <= _MOST_COLUMNS and not _is_cloud(array)
    return array.size <= _MOST_READ or array.ndim < 2 or is_table


def _draws_itself(thing: Any) -> bool:
    return any(hasattr(thing, name) for name in ("_repr_mimebundle_", "_repr_html_", "_repr_png_"))


def _add_title(text: str, title: str) -> str:
    if not title:
        return text
    return f"{title}\n{text}" if "\n" in text else f"{title}: {text}"


def _write(thing: Any) -> str:
    """Write numbers, text, and lists of them."""
    if isinstance(thing, np.ndarray):
        return _write_array(thing)
    if isinstance(thing, tuple | list):
        table = _make_table(thing)
        return _write_parts(thing) if table is None else _write_array(table)
    if isinstance(thing, str) or thing is None:
        return str(thing)
    if isinstance(thing, bool | np.bool_ | numbers.Integral):
        return str(thing)
    if isinstance(thing, numbers.Real):
        number = float(thing)
        return f"{number:.{_DECIMALS}{'f' if number == 0 or abs(number) >= 1e-3 else 'g'}}"
    raise TypeError(f"thing: expected {_EXPECTED}, got {_describe(thing)}")


def _write_parts(things: tuple[Any, ...] | list[Any]) -> str:
    parts = ", ".join(repr(one) if isinstance(one, str) else _write(one) for one in things)
    return f"[{parts}]" if isinstance(things, list) else f"({parts})"


def _make_table(things: tuple[Any, ...] | list[Any]) -> np.ndarray | None:
    """Return rows of equally many numbers as an array, such as a K written as lists."""
    if not all(isinstance(one, tuple | list) for one in things):
        return None
    try:
        table = np.array(things)
    except ValueError:  # rows of different lengths
        return None
    return table if table.ndim == 2 and table.dtype.kind in "biuf" else None


def _write_array(array: np.ndarray) -> str:
    if not array.size:
        return f"an empty array of shape {array.shape}"
    text = np.array2string(
        array,
        precision=_DECIMALS,
        floatmode="fixed",
        suppress_small=True,
        threshold=_MOST_PRINTED,
        max_line_width=_COLUMNS_OF_TEXT,
    )
    return f"an array of shape {array.shape}\n{text}" if array.size > _MOST_PRINTED else text
