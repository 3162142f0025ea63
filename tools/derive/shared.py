"""Write what Python and JavaScript both need to know, once said, into a file for JavaScript.

The truth stands in the library, the scripts of the pages get a copy.

Usage: ``python -m tools.derive.shared``; ``make exercises`` runs it. A test compares.
"""

from __future__ import annotations

import json
import sys

from labutils import stereo
from labutils._constants import MAX_HUE, TURN_WORLD
from labutils.checks import progress_rules as rules
from labutils.explorers import _depth_picture as picture
from labutils.explorers import _stereo_pair, _window_match, hsv, matching
from tools import ROOT

STATIC = "labutils/explorers/static"
RULES = "book/_page_python/progress_rules.js"
HEAD = """// biome-ignore-all format: written by a tool
// Written by `make exercises` from labutils, see tools/derive/shared.py: change it there.
"""


def main() -> int:
    """Write all files; return the exit code."""
    for name, text in make_files().items():
        (ROOT / name).write_text(text, encoding="utf-8")
        print(f"shared: wrote {name}")
    return 0


def make_files() -> dict[str, str]:
    """Return the text of every file, by its path from the repository on."""
    lines = [
        f"\n// {comment}\nexport const {name} = {value};\n"
        for name, comment, value in list_explorer_constants()
    ]
    return {f"{STATIC}/_shared.js": HEAD + "".join(lines), RULES: HEAD + _write_rules()}


def list_explorer_constants() -> list[tuple[str, str, str]]:
    """List what explorers share with the library: name, comment, value as JavaScript."""
    turn = [int(one) for row in TURN_WORLD for one in (*row, 0)]
    kinds = [picture.NEARER, picture.INSIDE, picture.FARTHER, picture.NO_SURFACE]
    stripes = ", ".join(
        f"{kind}: [{', '.join(map(_write_color, colors))}]"
        for kind, colors in picture.STRIPES.items()
    )
    return [
        ("HUES", "hues of an 8-bit picture", str(MAX_HUE + 1)),
        ("FROM_WORLD", "from a world with z up to the frame one orbits in", str(turn)),
        ("[NEARER, INSIDE, FARTHER, NO_SURFACE]", "kinds of pixels of a depth image", str(kinds)),
        (
            "STRIPES",
            "two colors by kind\n/** @type {Record<number, number[]>} */",
            f"{{ {stripes} }}",
        ),
        (
            "[OUTSIDE, SEEN, HIDDEN]",
            "what the right eye sees of a point",
            str([stereo.OUTSIDE, stereo.SEEN, stereo.HIDDEN]),
        ),
        ("WINDOWS", "sides of the windows that are matched", str(list(_window_match.WINDOWS))),
        (
            "[SMALL_WINDOW, LARGE_WINDOW]",
            "sides of the two windows that a goal compares",
            str([matching.SMALL_WINDOW, matching.LARGE_WINDOW]),
        ),
        ("GOOD_PX", "a match is right up to this error in pixels", f"{matching.GOOD_PX:g}"),
        (
            "STRIP_SHARE",
            "rows of the right picture, by those of the left one",
            str(_stereo_pair.STRIP_SHARE),
        ),
        (f"[{', '.join(hsv.SHOWN).upper()}]", "what of a picture is shown", str([0, 1, 2])),
        ("DIM", "how bright a picture is where nothing is selected", str(hsv.DIM)),
    ]


def _write_rules() -> str:
    """Write the rules of progress files for the scripts of a page, which are no modules."""
    names = ("FILE_NAME", "VERSION", "MAX_HINTS", "MAX_CHARACTERS", "SCHEMA", "WORDS")
    content = json.dumps({name: getattr(rules, name) for name in names}, indent=1)
    return f"""// What a progress file may hold; progress.js reads it.
window.cameraLab = {{ ...window.cameraLab, rules: {content} }};
"""


def _write_color(rgb: tuple[int, int, int]) -> str:
    """Write an opaque color as four bytes of a canvas, the last one first."""
    red, green, blue = rgb
    return f"0xff{blue:02x}{green:02x}{red:02x}"


if __name__ == "__main__":
    sys.exit(main())
