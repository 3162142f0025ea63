"""Collect the recordings that the pages can load: stereo pairs, and no keyframes of the walk.

``tools/vendor/pack_python.py`` calls this, and makes of it what the pages load.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from labutils.recordings import CLIPS, INDEX
from tools import ROOT
from tools.stable_zip import make_zip

if TYPE_CHECKING:
    from pathlib import Path


def make_recording_assets() -> dict[str, bytes]:
    """Return the one asset, an archive to be unpacked beside ``labutils``, by its name."""
    return {"recordings.zip": make_zip((name, path.read_bytes()) for name, path in list_files())}


def list_files() -> list[tuple[str, Path]]:
    """List the index of every recording and the files of its stereo pairs, by their places."""
    files = set()
    for index in CLIPS.glob(f"*/{INDEX}"):
        pairs = json.loads(index.read_text(encoding="utf-8"))["pairs"]
        names = {name for row in pairs for name in row.values() if str(name).endswith(".png")}
        files |= {index, *(index.parent / name for name in names)}
    return [(path.relative_to(ROOT).as_posix(), path) for path in sorted(files)]
