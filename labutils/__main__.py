"""``python -m labutils``: run the lab once and write its five files, or report progress."""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

from tqdm import tqdm

from labutils.checks import report
from labutils.rendering import NoOpenGLWarning


def main(arguments: list[str] | None = None) -> int:
    """Run ``report``, or without a command write the files of the lab."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if arguments[:1] == ["report"]:
        return _print_report(arguments[1:])
    return _write_outputs(arguments)


def _print_report(arguments: list[str]) -> int:
    """Print what is done and what is next; write it as a page where one is asked for."""
    parser = argparse.ArgumentParser(
        prog="python -m labutils report",
        description="Show which exercises are done, what is next, and the points in reach.",
    )
    parser.add_argument(
        "--in", dest="folder", type=Path, default=Path(), help="folder of labutils-progress.json"
    )
    parser.add_argument("--html", type=Path, help="also write the report as a page to this file")
    options = parser.parse_args(arguments)
    found = report(options.folder)
    print(found)
    if options.html:
        try:
            options.html.write_text(found.to_page(), encoding="utf-8")
        except OSError as error:
            print(f"labutils: {error}", file=sys.stderr)
            return 1
        print(options.html)
    return 0


def _write_outputs(arguments: list[str]) -> int:
    """Parse the command line, write the files, say where they are."""
    # MuJoCo is needed for pictures only, not for a report.
    from labutils.outputs import save_outputs  # noqa: PLC0415

    parser = argparse.ArgumentParser(
        prog="python -m labutils",
        description="Render the scene once and write the five files of the lab.",
        epilog="python -m labutils report: which exercises are done and what is next.",
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
