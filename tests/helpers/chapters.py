"""Find the pages of the book; ``notebooks.py`` runs them."""

from __future__ import annotations

from pathlib import Path

from content import toc

ROOT = Path(__file__).resolve().parents[2]


def get_toc_pages(root: Path = ROOT) -> list[Path]:
    """List the pages of the table of contents, in order, without endings."""
    return [Path(page) for page in toc.list_pages(root)]


def find_pages(root: Path = ROOT) -> list[Path]:
    """List the page files of the book and the exercises, without endings."""
    return [
        path.relative_to(root).with_suffix("")
        for folder in ("book", "exercises")
        for path in sorted((root / folder).rglob("*.md"))
        if not any(part.startswith(("_", ".")) for part in path.relative_to(root).parts)
    ]


def find_widgets(root: Path = ROOT) -> list[str]:
    """List the names of the explorers: one public module each."""
    folder = root / "labutils" / "explorers"
    return sorted(p.stem for p in folder.glob("*.py") if not p.stem.startswith("_"))


def find_orphans(root: Path = ROOT) -> list[str]:
    """Say which pages and widgets nobody can reach, and which listed pages do not exist."""
    listed, existing = get_toc_pages(root), find_pages(root)
    problems = [f"page {p} is not in _toc.yml" for p in existing if p not in listed]
    problems += [f"page {p} in _toc.yml does not exist" for p in listed if p not in existing]
    problems += [f"page {p} is in _toc.yml twice" for p in set(listed) if listed.count(p) > 1]
    text = "".join((root / p).with_suffix(".md").read_text(encoding="utf-8") for p in existing)
    for name in find_widgets(root):
        if f"explore_{name}(" not in text:
            problems.append(f"widget {name} is on no page")
        if not (root / "tests" / "explorers" / f"test_{name}.py").is_file():
            problems.append(f"widget {name} has no test")
    return problems


def get_executable_pages() -> list[Path]:
    """List the pages with code cells, by the table of contents: all of them are run."""
    files = {page: (ROOT / page).with_suffix(".md") for page in get_toc_pages()}
    # A listed page without a file is another test's finding; it must not hide all the others.
    return [
        page
        for page, file in files.items()
        if file.is_file() and "```{code-cell}" in file.read_text(encoding="utf-8")
    ]
