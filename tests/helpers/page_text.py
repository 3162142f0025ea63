"""Run the cells of pages as the page does, in this Python with the ray caster.

    python -m tests.helpers.page_text PAGE...    prints {page: [text of each cell]}

It has to be a process of its own: MuJoCo decides at its import whether there is OpenGL.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import jupytext

ROOT = Path(__file__).resolve().parents[2]
PAGE_PYTHON = ROOT / "book" / "_page_python"
#: As the worker of the page sets it.
ENVIRONMENT = {"MUJOCO_GL": "disable", "LABUTILS_GL_MISSING": "a web page has none"}


def read_cells(page: str) -> list[str]:
    """Return the code cells of a page, without those of its exercises' checks."""
    notebook = jupytext.read((ROOT / page).with_suffix(".md"))
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    tags = [cell.metadata.get("tags", []) for cell in code]
    return [
        cell.source
        for place, cell in enumerate(code)
        if "exercise" not in tags[place] and "exercise" not in (tags[place - 1] if place else [])
    ]


def run_pages(pages: Iterable[str]) -> dict[str, list[str]]:
    """Run pages in a fresh Python; return the text that each of their cells prints."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.helpers.page_text", *pages],
        cwd=ROOT,
        env={**os.environ, **ENVIRONMENT, "PYTHONPATH": f"{ROOT}{os.pathsep}{PAGE_PYTHON}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def read_text(outputs: list[dict[str, Any]]) -> str:
    """Join what a cell has printed, and what it shows as nothing but text."""
    parts = []
    for output in outputs:
        if output["output_type"] == "stream" and output["name"] == "stdout":
            parts.append(output["text"].removesuffix("\n"))
        elif output["output_type"] == "execute_result" and list(output["data"]) == ["text/plain"]:
            parts.append(output["data"]["text/plain"])
        elif output["output_type"] == "error":
            parts.append(output["traceback"][0])
    return "\n".join(parts)


def main() -> None:
    """Run the pages that are named."""
    import page_cells  # noqa: PLC0415 - only this process has its folder in the path

    texts = {}
    for page in sys.argv[1:]:
        session = page_cells.Session()
        cells = enumerate(read_cells(page), 1)
        texts[page] = [read_text(session.run(code, f"cell {number}")) for number, code in cells]
    print(json.dumps(texts))


if __name__ == "__main__":
    main()
