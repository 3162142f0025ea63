"""Measure the explorers: how long a frame takes after a slider was moved.

Every slider of every explorer in the built book is moved from end to end in headless Chromium,
one step per frame; opening and closing stay at their largest radius meanwhile. Beside it stands
what labutils takes for the same values in Python, with OpenCV's own code, as the peer: no network,
no drawing, so a page that needed a kernel for each frame would be slower than that. The ratio of
the two is what counts; milliseconds are those of this machine.

Usage: ``python -m tools.bench.explorers [--rounds 60]``; ends with an error where there is no
Chromium or no built book.
"""

import argparse
import statistics
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from labutils.explorers._base import View
from tools import headless
from tools.explorer_views import find_pages, read_views
from tools.vendor import npm

SCRIPT = Path(__file__).with_suffix(".mjs")

REPEATS = 5


def measure_python(view: View, parameters: dict[str, object]) -> float:
    """Return the best time, in milliseconds, of the same values in Python."""
    for name, value in parameters.items():
        setattr(view, name, value)
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        view.compute()
        times.append(1000 * (time.perf_counter() - start))
    return min(times)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a table; return a shell's exit code."""
    parser = argparse.ArgumentParser(description="Measure the frames of the explorers.")
    parser.add_argument("--rounds", type=int, default=60, help="frames per slider")
    options = parser.parse_args(arguments)
    if not headless.find_browser("CHROMIUM", headless.CHROMIUM_NAMES):
        print("explorers: not measured; no Chromium found, install it or set CHROMIUM")
        return 1
    pages = headless.STUDENT_PAGES
    if not (pages / "index.html").is_file():
        print("explorers: not measured; the book is not built, run `make book` first")
        return 1
    npm.install()
    print("a frame, times labutils for the same values (milliseconds on this machine)")
    print(f"{'explorer':<18}{'frames':>7}{'median':>9}{'95 %':>9}{'labutils':>11}  ratio")
    for page in find_pages():
        found = headless.run_script(SCRIPT, pages.as_uri() + "/", page, options.rounds)
        views = read_views((pages / f"{page}.html").read_text(encoding="utf-8"))
        for one, view in zip(found, views, strict=True):
            times = sorted(one["times"])
            median, late = statistics.median(times), times[int(0.95 * len(times))]
            peer = measure_python(view, one["parameters"])
            print(
                f"{one['name']:<18}{len(times):>7}{median:>6.1f} ms{late:>6.1f} ms{peer:>8.1f} ms"
                f"  {median / peer:.2f}"
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
