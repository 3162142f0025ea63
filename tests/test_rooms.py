"""Imports point one way: no room knows a room that builds on it."""

from __future__ import annotations

import ast
import os
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

#: Folders to the rooms that their files may import; `book/_ext` counts before `book`.
ARROWS = {
    "content": set(),
    "labutils": set(),
    "book/_ext": {"content", "labutils"},
    "book/_page_mujoco": {"labutils"},
    "book/_page_python": {"content", "labutils"},
    "exercises": {"labutils"},
    "solutions": {"content", "labutils"},
    "tools": {"content", "labutils", "solutions"},
    "tests": {"content", "labutils", "solutions", "tools"},
}
#: What the code cells of the pages may import.
PAGES = {"labutils"}
#: The same for scripts, which stand in one folder more.
SCRIPT_ARROWS = {**ARROWS, "book/_static": set(), "book/_hero": {"labutils"}}
ROOMS = {folder for folder in ARROWS if "/" not in folder}
SKIPPED = re.compile(r"[._].*|outputs|node_modules|.*\.egg-info")
#: Files that a script imports by their place; packages of npm have another form.
PLACE = re.compile(r"""\b(?:from|import|require)\s*\(?\s*["'](\.[^"']*)["']""")
CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def list_files(root: Path, pattern: str) -> list[Path]:
    """List the files of the repository: no environment, nothing that was built."""
    return [
        path
        for folder in sorted(root.iterdir())
        if folder.is_dir() and not SKIPPED.fullmatch(folder.name)
        for path in sorted(folder.rglob(pattern))
        if "__pycache__" not in path.parts and not path.is_relative_to(root / "solutions/pages")
    ] + sorted(root.glob(pattern))


def find_imports(tree: ast.AST) -> set[str]:
    """Name the packages that code imports: at the top, inside functions, and by name."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.add(node.module)
        elif isinstance(node, ast.Call) and _get_name(node.func) in ("import_module", "__import__"):
            first = node.args[0] if node.args else None
            if isinstance(first, ast.JoinedStr):  # f"solutions.{stem}"
                first = first.values[0]
            if isinstance(first, ast.Constant):
                found.add(str(first.value))
    return {name.partition(".")[0] for name in found}


def _get_name(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))


def changes_the_path(tree: ast.AST) -> bool:
    """Tell whether code looks for modules where they are not: by `sys.path` under any name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr == "path":
            if isinstance(node.value, ast.Name) and node.value.id == "sys":
                return True
        elif isinstance(node, ast.ImportFrom) and node.module == "sys":
            if any(alias.name == "path" for alias in node.names):
                return True
        elif isinstance(node, ast.Attribute) and node.attr == "addsitedir":
            return True
    return False


def find_broken_arrows(root: Path = ROOT) -> list[str]:
    """Say which file imports what its room may not, and which file stands in no room."""
    problems = []
    for path in list_files(root, "*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        problems += _look_into(path.relative_to(root), find_imports(tree), ARROWS)
    for path in list_scripts(root):
        problems += _look_into(path.relative_to(root), find_places(path, root), SCRIPT_ARROWS)
    for path in list_files(root, "*.md"):
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(root).as_posix()
        for cell in CELL.findall(text):
            code = re.sub(r"\A---\n.*?^---\n", "", cell, flags=re.DOTALL | re.MULTILINE)
            code = "\n".join("" if re.match(r"[:%!]", x) else x for x in code.splitlines())
            problems += _name_strangers(name, find_imports(ast.parse(code)), PAGES)
    return problems


def list_scripts(root: Path) -> list[Path]:
    """List the JavaScript of the repository."""
    return [*list_files(root, "*.js"), *list_files(root, "*.mjs")]


def find_places(path: Path, root: Path) -> set[str]:
    """Name the rooms that a script imports from."""
    text = path.read_text(encoding="utf-8")
    files = (os.path.normpath(path.parent / place) for place in PLACE.findall(text))
    return {Path(file).relative_to(root).parts[0] for file in files}


def _look_into(path: Path, imports: set[str], arrows: dict[str, set[str]]) -> list[str]:
    name = path.as_posix()
    for folder, allowed in arrows.items():
        if name.startswith(f"{folder}/"):
            return _name_strangers(name, imports, allowed | {folder, folder.partition("/")[0]})
    return [f"{name} stands in no room of the table"]


def _name_strangers(name: str, imports: set[str], allowed: set[str]) -> list[str]:
    rooms = " and ".join(sorted(allowed & ROOMS)) or "nothing of ours"
    return [
        f"{name} imports {room}: it may import {rooms}"
        for room in sorted(imports & ROOMS - allowed)
    ]


def test_every_file_imports_only_rooms_below_its_own() -> None:
    problems = find_broken_arrows()
    assert not problems, "\n".join(problems)


def test_all_rooms_were_read() -> None:
    names = [path.relative_to(ROOT).as_posix() for path in list_files(ROOT, "*.py")]
    for folder in set(ARROWS) - {"exercises"}:
        assert any(name.startswith(f"{folder}/") for name in names), folder
    assert len(names) > 150
    pages = [path for path in list_files(ROOT, "*.md") if CELL.search(path.read_text("utf-8"))]
    assert len(pages) >= 17
    scripts = [path.relative_to(ROOT).as_posix() for path in list_scripts(ROOT)]
    for folder in ("labutils", "book/_page_python", "book/_static", "tools", "tests"):
        assert any(name.startswith(f"{folder}/") for name in scripts), folder
    assert sum(bool(find_places(ROOT / name, ROOT)) for name in scripts) > 40


def test_nobody_changes_where_python_looks_for_modules() -> None:
    files = [
        path.relative_to(ROOT).as_posix()
        for path in list_files(ROOT, "*.py")
        if changes_the_path(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert files == [], "expected packages and `python -m`, got changes of sys.path"


@pytest.mark.parametrize(
    ("name", "code", "expected"),
    [
        ("content/a.py", "import labutils", "it may import content"),
        ("labutils/a/b.py", "def f():\n    from solutions import x", "it may import labutils"),
        ("labutils/a.py", "import_module('content.chapters')", "it may import labutils"),
        ("book/_ext/a.py", "import tools.build", "it may import content and labutils"),
        ("solutions/a.py", "importlib.import_module(f'tools.{x}')", "content and labutils and"),
        ("tools/a/b.py", "if TYPE_CHECKING:\n    import tests.helpers", "content and labutils"),
        (
            "exercises/_generated/a.py",
            "__import__('solutions')",
            "exercises and labutils",
        ),
        ("book/a.md", "```{code-cell} ipython3\n:tags: [x]\nimport content\n```\n", "labutils"),
        ("setup.py", "import sys", "stands in no room of the table"),
        ("labutils/a/b.js", 'import { a } from "../../tools/a.js";', "it may import labutils"),
        ("tools/a.mjs", 'const a = await import("../tests/a.mjs");', "content and labutils"),
        ("book/_static/a.js", 'import "../../labutils/a.js";', "nothing of ours"),
        ("book/_ext/a.js", 'const a = require("../../tests/a.js");', "content and labutils"),
        ("page.mjs", "", "stands in no room of the table"),
    ],
)
def test_an_arrow_that_points_back_is_named(
    name: str, code: str, expected: str, tmp_path: Path
) -> None:
    (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / name).write_text(code, encoding="utf-8")
    (problem,) = find_broken_arrows(tmp_path)
    assert problem.startswith(name)
    assert expected in problem


def test_an_arrow_that_points_forward_is_let_through(tmp_path: Path) -> None:
    (tmp_path / "tools").mkdir()
    code = "import labutils.checks\nfrom content import toc\nfrom . import a\nimport numpy"
    (tmp_path / "tools" / "a.py").write_text(code, encoding="utf-8")
    script = 'import a from "../labutils/a.js";\nimport b from "tests";\nimport "./c.js";'
    (tmp_path / "tools" / "a.js").write_text(script, encoding="utf-8")
    assert find_broken_arrows(tmp_path) == []


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("import sys\nsys.path.insert(0, 'x')", True),
        ("import sys\nsys.path[:0] = ['x']", True),
        ("import sys\nsys.path += ['x']", True),
        ("import sys\nplaces = sys.path\nplaces.append('x')", True),
        ("from sys import path as places", True),
        ("import site\nsite.addsitedir('x')", True),
        ("import os, sys\nos.path.join(sys.prefix, 'x')  # not sys.path.insert", False),
    ],
)
def test_every_way_to_change_the_path_is_seen(code: str, changes: bool) -> None:
    assert changes_the_path(ast.parse(code)) is changes
