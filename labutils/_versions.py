"""Which versions of other packages this library is right with, where it must ask."""

from __future__ import annotations

import re
import sys

#: Older ones lose rays of bodies whose center of mass is not where their geoms are, and do not
#: know the scene's ``castshadow``. `pyproject.toml` asks for the same version.
OLDEST_MUJOCO = (4, 0)


def check_mujoco_version(found: str) -> None:
    """Stop the import of what draws or casts rays where MuJoCo is too old for it.

    Parameters
    ----------
    found : str
        ``mujoco.__version__``.

    Raises
    ------
    ImportError
        If it is older than `OLDEST_MUJOCO`.
    """
    if sys.platform == "emscripten":
        return  # a page has the one build that was packed for it: nothing else can be installed
    if is_older(found, OLDEST_MUJOCO):
        oldest = ".".join(map(str, OLDEST_MUJOCO))
        raise ImportError(
            f"labutils needs MuJoCo {oldest} or later, found {found}: rays of older ones pass "
            f'through parts of robots; to get it: pip install "mujoco>={oldest}"'
        )


def is_older(found: str, oldest: tuple[int, int]) -> bool:
    """Tell whether a version is older than (major, minor); one without numbers is not."""
    numbers = re.match(r"(\d+)\.(\d+)", found)
    return numbers is not None and tuple(map(int, numbers.groups())) < oldest
