"""List the names that the editor of the pages offers: Python's own, NumPy's and OpenCV's.

They are read from what is installed. The list is packed into the editor (``page_python.py``).
"""

from __future__ import annotations

import builtins
import keyword
from types import ModuleType

import cv2
import numpy as np

#: Parts of NumPy whose functions have a dot more.
NUMPY_PARTS = ("linalg", "random")

#: Families of constants for cameras, windows and files, of which a page has none, and for networks.
LEFT_OUT = (
    "CAP_",
    "DNN_",
    "EVENT_",
    "FILE_",
    "IMWRITE_",
    "OPEN_CAMERA",
    "QT_",
    "VIDEOWRITER_",
    "VIDEO_",
    "WINDOW_",
    "WND_",
)


def list_names() -> dict[str, str]:
    """List names by the module as a page's code calls it; "python" for Python's own.

    Returns
    -------
    dict of str to str
        Names in order, with blanks between them.
    """
    own = [name for name in dir(builtins) if not name.startswith("_")]
    names = {
        "python": {*own, *keyword.kwlist},
        "np": _list_public(np),
        "cv2": {name for name in dir(cv2) if _is_offered(name)},
    }
    names |= {f"np.{part}": _list_public(getattr(np, part)) for part in NUMPY_PARTS}
    return {module: " ".join(sorted(found)) for module, found in names.items()}


def _list_public(module: ModuleType) -> set[str]:
    return {name for name in module.__all__ if not name.startswith("_")}


def _is_offered(name: str) -> bool:
    """Tell whether somebody may want a name of OpenCV, which has no list of its public ones."""
    is_module = isinstance(getattr(cv2, name), ModuleType)
    return not (name.startswith(("_", *LEFT_OUT)) or is_module)
