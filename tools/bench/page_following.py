"""Measure the following loop in the page: a step with its pictures beside a step of the bare loop.

Both run in the same Python of the same page in headless Chromium, with the controller of the page.
With its pictures a step is asked for by the page, drawn (every third time from outside, too), sent
and answered; the bare loop, the peer, draws for the controller alone and shows nothing.

Usage: ``python -m tools.bench.page_following [--steps 100]``; ends with an error where there is no
Chromium, or no built book with its wheels.
"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from tools import ROOT, headless
from tools.bench.page_python import HTML, has_wheels, print_line
from tools.vendor import npm

if TYPE_CHECKING:
    from collections.abc import Sequence

SCRIPT = ROOT / "tools" / "bench" / "page_following.mjs"
PAGE = "book/following"


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the times and their ratio; return a shell's exit code."""
    parser = argparse.ArgumentParser(description="Measure the following loop in the page.")
    parser.add_argument("--steps", type=int, default=100, help="how many are measured")
    options = parser.parse_args(arguments)
    if not headless.find_browser("CHROMIUM", headless.CHROMIUM_NAMES):
        print("following: not measured; no Chromium found, install it or set CHROMIUM")
        return 1
    if not has_wheels():
        print("following: not measured; no built book that holds the wheels")
        return 1
    npm.install()
    found = headless.run_script(SCRIPT, HTML.as_uri() + "/", PAGE, options.steps)
    print_line("a step with its pictures", found["shown"], "the bare loop", found["bare"])
    return 0


if __name__ == "__main__":
    sys.exit(main())
