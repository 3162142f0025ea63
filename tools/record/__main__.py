"""Record ``assets/clip/room`` anew: stereo pairs, keyframes of the walk, the inertial sensor.

The same versions of MuJoCo, NumPy and OpenGL write the same bytes.

Usage: ``python -m tools.record [--out FOLDER]``.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from pathlib import Path

from labutils.recordings import CLIPS
from labutils.room import make_room
from labutils.room.recorder import BASELINES, VIEWS, Recorder

ROOM = "room"
#: Views in the clip; the others are for `tools/record/stereo_table.py`.
IN_CLIP = ("table", "pole", "side")
FRAMES_PER_SECOND = 2.5


def main(arguments: list[str] | None = None) -> int:
    """Write the clip; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=CLIPS / ROOM, help="folder to write")
    options = parser.parse_args(arguments)
    shutil.rmtree(options.out, ignore_errors=True)
    recorder = Recorder(*make_room(ROOM), options.out)
    recorder.record_pairs({view: VIEWS[view] for view in IN_CLIP}, BASELINES)
    recorder.record_walk(frames_per_second=FRAMES_PER_SECOND)
    recorder.finish()
    files = [path for path in options.out.rglob("*") if path.is_file()]
    size = sum(path.stat().st_size for path in files)
    print(f"clip: {len(files)} files, {size / 1e6:.1f} MB in {options.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
