"""Lead to a section where the learner reads: on the built page, or in the notebook beside it."""

from __future__ import annotations

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
        The same, or the notebook without the place in it: headings are named otherwise there.
    """
    page = link.partition("#")[0]
    notebook = page.removesuffix(".html") + ".ipynb"
    return notebook if page != notebook and Path(notebook).is_file() else link
