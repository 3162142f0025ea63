"""Check where the links of the built pages lead.

Inside the book a link has to name a file and, after #, a place in it: the tests ask for that. Pages
of others are asked only on demand, by ``python -m tools.build.links`` (``make links``), since they
need a network and may be down for a day.
"""

from __future__ import annotations

import sys
import urllib.error
import urllib.request
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING
from urllib.parse import unquote, urldefrag, urlsplit

from bs4 import BeautifulSoup

from tools import ROOT

if TYPE_CHECKING:
    from pathlib import Path

HTML = ROOT / "_build" / "html"
ATTRIBUTES = ("href", "src", "poster")
#: Where a place is shown by a script of the page, so that no element has its name.
SHOWN_BY_SCRIPTS = ("search.html",)
AGENT = "Mozilla/5.0 (link checker of an open book)"
PATIENCE = 20  # seconds for one page of others
AT_ONCE = 8


@dataclass(frozen=True)
class Link:
    """A link of a built page, with the page's path inside the site."""

    page: str
    target: str


def read_links(html: Path) -> list[Link]:
    """Return the links of all built pages, each once per page, in a stable order."""
    links = set()
    for path in sorted(html.rglob("*.html")):
        page = path.relative_to(html).as_posix()
        for element in _parse(path).select("*"):
            for name in ATTRIBUTES:
                target = str(element.get(name) or "").strip()
                if target and not target.startswith(("data:", "mailto:", "javascript:", "blob:")):
                    links.add(Link(page, target))
    return sorted(links, key=lambda link: (link.page, link.target))


def find_broken(html: Path) -> list[str]:
    """Check the links that stay inside the book.

    Parameters
    ----------
    html : Path
        The folder of the built pages.

    Returns
    -------
    list of str
        One sentence for each link that leads nowhere.
    """
    places = {path: _read_places(path) for path in html.rglob("*.html")}
    broken = []
    for link in read_links(html):
        if urlsplit(link.target).scheme or link.target.startswith("//"):
            continue
        address, place = urldefrag(link.target)
        source = html / link.page
        address = unquote(urlsplit(address).path)
        path = (source.parent / address).resolve() if address else source
        if not path.is_file():
            broken.append(f"{link.page}: no file for {link.target}")
        elif place and not _has_place(places.get(path), path.name, unquote(place)):
            broken.append(f"{link.page}: no such place: {link.target}")
    return broken


def find_broken_outside(html: Path) -> list[str]:
    """Ask the pages of others, and return one sentence for each that does not answer."""
    pages = defaultdict(list)
    for link in read_links(html):
        if urlsplit(link.target).scheme in ("http", "https"):
            pages[urldefrag(link.target)[0]].append(link.page)
    addresses = sorted(pages)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        answers = list(pool.map(_ask, addresses))
    return [
        f"{address} ({pages[address][0]}): {answer}"
        for address, answer in zip(addresses, answers, strict=True)
        if answer
    ]


def _parse(path: Path) -> BeautifulSoup:
    return BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")


def _read_places(path: Path) -> set[str]:
    return {str(element.get("id")) for element in _parse(path).find_all(id=True)}


def _has_place(places: set[str] | None, page: str, place: str) -> bool:
    return places is None or page in SHOWN_BY_SCRIPTS or place in places


def _ask(address: str) -> str:
    """Return why a page cannot be read; empty where it can."""
    request = urllib.request.Request(address, headers={"User-Agent": AGENT})  # noqa: S310 - http(s)
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE) as answer:  # noqa: S310
            answer.read(1)
    except urllib.error.HTTPError as error:
        # refused to a program, which says nothing about the page
        return "" if error.code in (401, 403, 429) else f"status {error.code}"
    except OSError as error:
        return str(getattr(error, "reason", error))
    return ""


def main() -> int:
    """Check all links; return a shell's exit code."""
    if not (HTML / "index.html").is_file():
        print("links: expected built pages in _build/html; run `make book`", file=sys.stderr)
        return 2
    broken = find_broken(HTML) + find_broken_outside(HTML)
    for line in broken:
        print(f"links: {line}")
    print(f"links: {len(read_links(HTML))} links, {len(broken)} lead nowhere")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
