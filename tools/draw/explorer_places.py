"""Keep the place of every explorer free until it is drawn, so that the text below does not jump.

How high an explorer is only a browser knows: this measures the built pages and writes
``explorer_places.css``. Run it after a change of an explorer's layout, on a fresh build:
``python -m tools.draw.explorer_places``.
"""

from pathlib import Path

from tools import ROOT, headless
from tools.explorer_views import find_pages
from tools.headless import CHROMIUM_NAMES, STUDENT_PAGES, find_browser

SCRIPT = Path(__file__).with_suffix(".mjs")
SHEET = ROOT / "book" / "_static" / "explorer_places.css"
HEAD = """\
/* The place of an explorer until it is drawn. Written by tools/draw/explorer_places.py, which
   measures it: run that after a change of their layout. */
"""
PHONE = "(max-width: 699px)"  # where explorers put everything below each other


def measure_places() -> dict[str, dict[str, int]]:
    """Measure every explorer of the built pages: pixels by name, narrow and wide."""
    browser = find_browser("CHROMIUM", CHROMIUM_NAMES)
    if browser is None:
        raise FileNotFoundError("browser: expected Chromium, got none; install it or set CHROMIUM")
    places: dict[str, dict[str, int]] = headless.run_script(
        SCRIPT, f"{STUDENT_PAGES.as_uri()}/", *find_pages(), variables={"CHROMIUM": browser}
    )
    return places


def make_sheet(places: dict[str, dict[str, int]]) -> str:
    """Write the style sheet: on screens only, in the element that widget_loader.js makes."""
    wide = [_make_rule(name, place["wide"]) for name, place in sorted(places.items())]
    narrow = [_make_rule(name, place["narrow"]) for name, place in sorted(places.items())]
    blocks = (("screen", wide), (f"screen and {PHONE}", narrow))
    return HEAD + "".join(f"\n@media {where} {{\n{''.join(rules)}}}\n" for where, rules in blocks)


def _make_rule(name: str, height: int) -> str:
    selector = f".explorer-place:has(.explorer-poster-{name})"
    return f"  {selector} {{\n    min-height: {height}px;\n  }}\n"


def main() -> None:
    """Measure, and write the sheet."""
    places = measure_places()
    SHEET.write_text(make_sheet(places), encoding="utf-8")
    print(f"{SHEET.name}: {', '.join(sorted(places))}")


if __name__ == "__main__":
    main()
