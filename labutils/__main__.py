"""``python -m labutils``: run the lab once and write its five files."""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

from tqdm import tqdm

from labutils.outputs import save_outputs
from labutils.rendering import NoOpenGLWarning


def main(arguments: list[str] | None = None) -> int:
    """Parse the command line, write the files, say where they are."""
    parser = argparse.ArgumentParser(
        prog="python -m labutils",
        description="Render the scene once and write the five files of the lab.",
    )
    parser.add_argument("--out", type=Path, default=Path("outputs"), help="folder to write to")
    parser.add_argument("--camera", default="head_camera", help="camera to look through")
    parser.add_argument("--width", type=int, default=640, help="picture width in pixels")
    parser.add_argument("--height", type=int, default=480, help="picture height in pixels")
    options = parser.parse_args(arguments)
    # A reader of a terminal wants the sentence, not the line of code it came from.
    warnings.showwarning = _print_notice
    warnings.simplefilter("always", NoOpenGLWarning)
    try:
        paths = save_outputs(
            options.out, options.camera, options.width, options.height, progress=True
        )
    except (ValueError, OSError) as error:
        print(f"labutils: {error}", file=sys.stderr)
        return 1
    for path in paths:
        print(f"{path}  {path.stat().st_size / 1000:.0f} kB")
    return 0


def _print_notice(message: Warning | str, *_: object, **__: object) -> None:
    tqdm.write(f"Note: {message}", file=sys.stderr)  # on a line of its own, above the bar


if __name__ == "__main__":
    sys.exit(main())
