"""Pack what a learner needs into one zip: what `make student` runs.

The pages of ``_toc.yml`` become notebooks without outputs where they have code, and plain
Markdown where they have none; the library, its check tables, the scene and the lists of
packages come as they are. Nothing of ``solutions/``, ``tests/`` or ``tools/`` goes in. The
same source gives the same bytes: sorted names, one fixed time, nothing compressed (what
compression gives differs between versions of zlib).

Usage: ``python -m tools.editions.student [--out FILE]``.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import sys
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

import jupytext
import nbformat

from content.toc import Entry, list_entries, read_toc
from tools import ROOT
from tools.editions.plain_markdown import Flattener, find_labels
from tools.stable_zip import make_zip

if TYPE_CHECKING:
    from collections.abc import Iterator

OUT = Path("_build", "student", "camera-lab-student.zip")
FOLDER = "camera-lab-student"  # what unpacking makes
README = Path("tools", "editions", "student_readme.md")

WHOLE = ("LICENSE", "LICENSE-TEXT", "apt.txt", "requirements.txt")
TREES = ("labutils", "assets")
#: Sections of pyproject.toml that installing needs; the others are about this repository.
INSTALL_SECTIONS = ("build-system", "project", "tool.setuptools")

PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
VIDEO = ".webm"  # goes into the zip where a page links it
LINK = re.compile(r"(?<=\]\()(?!\w+:|#)([^)#\s]+)(?:#[^)\s]*)?(?=\))")


def main(arguments: list[str] | None = None) -> int:
    """Write the zip; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / OUT, help="file to write")
    options = parser.parse_args(arguments)
    files = make_files()
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_bytes(content := pack(files))
    notebooks = sum(name.endswith(".ipynb") for name in files)
    print(
        f"student: {len(files)} files, {notebooks} of them notebooks, {len(content) / 1e6:.1f} MB"
    )
    print(f"sha256 {hashlib.sha256(content).hexdigest()}")
    print(options.out)
    return 0


def make_files(root: Path = ROOT) -> dict[str, bytes]:
    """Return every file of the zip by its path in it."""
    files = {name: (root / name).read_bytes() for name in WHOLE}
    for tree in TREES:
        files |= {
            path.relative_to(root).as_posix(): path.read_bytes() for path in walk(root / tree)
        }
    entries = list_entries(read_toc(root))
    pages = {name: read_page(root, name) for name in (f"{one.page}.md" for one in entries)}
    shipped = {
        name: str(PurePosixPath(name).with_suffix(".ipynb" if is_notebook(text) else ".md"))
        for name, text in pages.items()
    }
    files |= make_pages(root, pages, shipped)
    files["pyproject.toml"] = make_project((root / "pyproject.toml").read_text("utf-8")).encode()
    files["README.md"] = make_readme(root, entries, pages, shipped).encode()
    return files


def walk(folder: Path) -> Iterator[Path]:
    """List the files below a folder, without what Python and editors leave there."""
    for path in sorted(folder.rglob("*")):
        parts = path.relative_to(folder).parts
        if path.is_file() and not any(part.startswith((".", "__pycache__")) for part in parts):
            yield path


def read_page(root: Path, name: str) -> str:
    """Read the source of a page."""
    return (root / name).read_text(encoding="utf-8")


def is_notebook(text: str) -> bool:
    """Tell a page with cells from one with words only."""
    return bool(re.search(r"^```\{code-cell\}", text, re.MULTILINE))


def make_pages(root: Path, pages: dict[str, str], shipped: dict[str, str]) -> dict[str, bytes]:
    """Return the pages as notebooks or Markdown, with their pictures and videos."""
    labels = find_labels(pages)
    files: dict[str, bytes] = {}
    for name, text in pages.items():
        folder = PurePosixPath(name).parent

        def resolve(link: str, folder: PurePosixPath = folder) -> str:
            target = _normalize(folder / link)
            return link[: -len(".md")] + PurePosixPath(shipped.get(target, target)).suffix

        flattener = Flattener(name, root, labels, resolve)
        if is_notebook(text):
            content = make_notebook(text, flattener)
        else:
            content = flattener.flatten(_drop_head(text))
        verify_links(content, name, shipped)
        for picture in PICTURE.findall(content):
            path = _normalize(folder / picture)
            if (root / path).is_file():
                files[path] = (root / path).read_bytes()
        for link in LINK.findall(content):
            if link.endswith(VIDEO):
                path = _normalize(folder / link)
                files[path] = (root / path).read_bytes()
        files[shipped[name]] = content.encode()
    return files


def make_notebook(text: str, flattener: Flattener) -> str:
    """Turn a page into a notebook that has never been run."""
    notebook = jupytext.reads(text, fmt="md:myst")
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"  # instead of a random one
        cell.metadata = {
            key: value for key, value in cell.metadata.items() if key in ("tags", "editable")
        }
        if cell.cell_type == "markdown":
            cell.source = flattener.flatten(f"{cell.source}\n").strip()
    notebook.cells = [cell for cell in notebook.cells if cell.source]
    # no version of jupytext: it would change the bytes
    notebook.metadata = nbformat.from_dict(
        {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
        }
    )
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    nbformat.validate(notebook)
    return nbformat.writes(notebook) + "\n"


def verify_links(text: str, page: str, shipped: dict[str, str]) -> None:
    """Fail where a page links a page that is not in the zip."""
    for link in LINK.findall(text):
        target = _normalize(PurePosixPath(page).parent / link)
        if target.endswith((".md", ".ipynb")) and target not in shipped.values():
            raise ValueError(f"{page}: expected a link to a page of _toc.yml, got {link}")


def make_project(text: str) -> str:
    """Keep what `pip install -e .` reads of pyproject.toml."""
    sections = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    kept = [
        section
        for section in sections
        if re.match(rf"\[({'|'.join(map(re.escape, INSTALL_SECTIONS))})[.\]]", section)
    ]
    return "".join(kept).rstrip() + "\n"


def make_readme(
    root: Path, entries: list[Entry], pages: dict[str, str], shipped: dict[str, str]
) -> str:
    """Return the README with the list of pages, by the parts of the book."""
    lines: list[str] = []
    last = None
    for caption, name in ((one.caption, f"{one.page}.md") for one in entries):
        if caption != last:
            lines += ["", f"**{caption}**", ""] if caption else [""]
            last = caption
        title = re.search(r"^# (.+)$", pages[name], re.MULTILINE)
        lines.append(f"- [{title[1] if title else name}]({shipped[name]})")
    text = (root / README).read_text(encoding="utf-8")
    first = next(path for path in shipped.values() if path.endswith(".ipynb"))
    return text.replace("PAGES", "\n".join(lines).strip()).replace("book/START", first)


def pack(files: dict[str, bytes]) -> bytes:
    """Write the zip, in the order of the names."""
    return make_zip((f"{FOLDER}/{name}", files[name]) for name in sorted(files))


def _drop_head(text: str) -> str:
    """Take off the front matter."""
    return re.sub(r"\A---\n.*?^---\n+", "", text, flags=re.MULTILINE | re.DOTALL)


def _normalize(path: PurePosixPath) -> str:
    """Resolve the dots of a path without asking a disk."""
    parts: list[str] = []
    for part in path.parts:
        if part == "..":
            parts.pop()
        elif part != ".":
            parts.append(part)
    return "/".join(parts)


if __name__ == "__main__":
    sys.exit(main())
