"""A small book, built for real: again, after changes, and with a cell that fails."""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tools.build import memory

ROOT = Path(__file__).resolve().parents[2]
TOP = """---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {display_name: Python 3, language: python, name: python3}
---
"""


def write(folder: Path, name: str, text: str) -> None:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


@pytest.mark.slow
def test_a_real_book_is_built_anew_only_where_it_has_changed(tmp_path: Path) -> None:
    # one page with a cell, one with a question, in a copy of everything else
    ignored = shutil.ignore_patterns(
        "_build", "outputs", ".*", "tests", "__pycache__", "*.egg-info", "pages"
    )
    shutil.copytree(ROOT, tmp_path, dirs_exist_ok=True, ignore=ignored)
    for name in ("vendor", "vendor_python"):
        if not (ROOT / "_build" / name).is_dir():
            pytest.skip("the front end is not there; run `make book` first")
        shutil.copytree(ROOT / "_build" / name, tmp_path / "_build" / name)
    write(tmp_path, "_toc.yml", "format: jb-book\nroot: book/one\nchapters:\n- file: book/two\n")
    write(tmp_path, "book/one.md", f"{TOP}# One\n\n```{{code-cell}}\nprint(6 * 7)\n```\n")
    question = (ROOT / "exercises" / "concepts" / "step3_depth.yml").read_text()
    labels = sorted(set(re.findall(r"^ *section: (\S+)", question, re.MULTILINE)))
    places = "".join(f"({label})=\n## {label}\n\n" for label in labels)
    write(tmp_path, "book/two.md", f"# Two\n\n{places}```{{quiz}} two\n```\n")
    write(tmp_path, "exercises/concepts/two.yml", question)

    no_network = {"https_proxy": "http://127.0.0.1:9", memory.OUTSIDE: ""}  # to load wheels from

    def run_build() -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "tools.build.book"],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(tmp_path), "EDITION": "student"} | no_network,
            capture_output=True,
            text=True,
            check=False,
        )

    def build() -> tuple[str, float]:
        started = time.monotonic()
        done = run_build()
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout, time.monotonic() - started

    said, whole = build()
    assert "2 pages read, 1 executed" in said
    said, again = build()
    assert "nothing has changed" in said
    assert again < whole / 3
    write(tmp_path, "book/one.md", (tmp_path / "book/one.md").read_text().replace("6 * 7", "7 * 7"))
    assert "1 pages read, 1 executed" in build()[0]
    assert "49" in (tmp_path / "_build" / "html" / "book" / "one.html").read_text()
    write(tmp_path, "exercises/concepts/two.yml", f"{question}\n")
    assert "1 pages read, 0 executed" in build()[0]
    sheet = tmp_path / "book" / "_static" / "book.css"
    sheet.write_text(sheet.read_text() + "\n.added { color: red }\n")
    assert "2 pages read, 0 executed" in build()[0]
    assert ".added" in (tmp_path / "_build" / "html" / "_static" / "book.css").read_text()
    write(tmp_path, "book/one.md", f"{TOP}# One\n\n```{{code-cell}}\nprint(6 / 0)\n```\n")
    done = run_build()
    assert done.returncode
    assert "book/one.md: WARNING: Executing notebook failed: CellExecutionError" in done.stderr
    assert "ZeroDivisionError: division by zero" in done.stderr
    assert "print(6 / 0)" in done.stderr
    assert "Extension error" not in done.stderr
    assert run_build().returncode  # and it stays one
