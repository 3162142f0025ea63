"""Lead to a section where the learner reads: on the built page, or in the notebook beside it."""

from __future__ import annotations

import re
from pathlib import Path


def find_link(link: str) -> str:
    """Return the notebook of a section where there is one, else the built page.

    Parameters
    ----------
    link : str
        Relative to a page of the book, such as "../book/step3_depth.html#step3-raw".

    Returns
    -------
    str
        The same; or the notebook of a student's folder, without the place in it, because headings
        are named otherwise there; or the chapter's source, which JupyterLab opens as a notebook.
    """
    page, mark, place = link.partition("#")
    stem = page.removesuffix(".html")
    if stem == page:
        return link
    if Path(f"{stem}.ipynb").is_file():
        return f"{stem}.ipynb"
    return f"{stem}.md{mark}{place}" if Path(f"{stem}.md").is_file() else link


def name_link(link: str) -> str:
    """Say in words where a link leads.

    Parameters
    ----------
    link : str
        To a page of the book or to its notebook, such as "../book/step3_depth.md#step3-raw".

    Returns
    -------
    str
        The chapter, and the heading where the chapter's source lies at the link, else the name of
        the place: "step 3: What is in a depth buffer?" or "step 3, raw".
    """
    page, _, place = link.partition("#")
    source = Path(page)
    step = re.match(r"step(\d+)", source.stem)
    chapter = f"step {step[1]}" if step else source.stem.replace("_", " ")
    if place and source.suffix == ".md" and source.is_file():
        text = source.read_text(encoding="utf-8")
        heading = re.search(rf"^\({re.escape(place)}\)=\n+#+ (.+)$", text, re.MULTILINE)
        if heading:
            return f"{chapter}: {heading[1]}"
    words = place.removeprefix(f"{chapter.replace(' ', '')}-").replace("-", " ")
    return f"{chapter}, {words}" if words else chapter
