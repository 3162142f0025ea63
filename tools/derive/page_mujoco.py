"""Derive what the page's package ``mujoco`` has to know of the real one: shapes and signatures.

The pages run MuJoCo's WebAssembly build, which speaks JavaScript. ``book/_page_mujoco/mujoco``
gives it the form of the Python package. What arrays hold, how functions are called and what named
views show is not written there by hand: it is read from the installed package and from the
declarations of the build, and kept in one file beside the package.

Usage: ``python -m tools.derive.page_mujoco [--check]``; ``make exercises`` runs it, and every build
of the book checks that it still holds.
"""

from __future__ import annotations

import difflib
import json
import re
import sys
from typing import Any

import mujoco

from tools import ROOT
from tools.derive.page_mujoco_functions import derive_functions, derive_views, list_model_writers
from tools.derive.page_mujoco_structs import (
    derive_constants,
    derive_enums,
    derive_structs,
    list_absent,
    read_interfaces,
)
from tools.vendor import npm

PLACE = "book/_page_mujoco/mujoco/derived.json"
DERIVED = ROOT / PLACE
PACKAGE = "@mujoco/mujoco"
#: What is MuJoCo's own of what its package holds: no imported module, no helper.
OWN_NAMES = re.compile(r"(?:mj|Mj|get_mj|set_mj|GLContext$|from_zip$|to_zip$)")
#: Of the package, imported by hand: what a reader may try.
SUBMODULES = {"viewer", "rollout", "minimize", "mjx", "msh2obj", "usd"}
DECLARATIONS = "mujoco.d.ts"
MOST_LINES = 40  # of a difference: enough to see what it is


def main(arguments: list[str]) -> int:
    """Write the file, or compare it; return the exit code."""
    try:
        npm.install()
    except npm.VendorError as error:
        print(f"page mujoco: {error}", file=sys.stderr)
        return 1
    if "--check" in arguments:
        problem = find_difference()
        print(f"page mujoco: {problem or 'up to date'}", file=sys.stderr if problem else sys.stdout)
        return 1 if problem else 0
    DERIVED.write_text(make_text(), encoding="utf-8")
    print(f"page mujoco: wrote {PLACE}")
    return 0


def find_difference() -> str:
    """Say what the committed file has other than what is derived now; empty where nothing."""
    now, kept = make_text().splitlines(), _read_kept().splitlines()
    if now == kept:
        return ""
    lines = list(difflib.unified_diff(kept, now, "committed", "derived", n=1, lineterm=""))
    more = [f"... and {len(lines) - MOST_LINES} lines more"] if len(lines) > MOST_LINES else []
    shown = "\n".join([*lines[:MOST_LINES], *more])
    return f"{PLACE} is not what is derived now; run `make exercises`.\n{shown}"


def make_text() -> str:
    """Return what the file should hold."""
    return json.dumps(derive(), indent=0, sort_keys=True) + "\n"


def derive() -> dict[str, Any]:
    """Collect all tables, from the package and from the build of the page."""
    folder = npm.get_package(PACKAGE)
    declarations = (folder / DECLARATIONS).read_text(encoding="utf-8")
    interfaces = read_interfaces(declarations)
    fields = derive_structs(interfaces)
    page = json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"]
    tables = {
        "versions": {"package": mujoco.__version__, "page": page},
        "structs": fields,
        "absent": list_absent(interfaces),
        "views": derive_views(fields),
        "functions": derive_functions(declarations),
        "model_writers": list_model_writers(),
        "constants": derive_constants(declarations),
        "enums": derive_enums(declarations),
    }
    return tables | {"elsewhere": list_elsewhere(tables)}


def list_elsewhere(tables: dict[str, Any]) -> list[str]:
    """List the names of the package that no table has: the page says of them where they are."""
    known = {"MjModel", "MjData", "MjSpec", "Renderer", "FatalError", "UnexpectedError"}
    known |= {*tables["structs"], *tables["functions"], *tables["constants"], *tables["enums"]}
    names = {name for name in vars(mujoco) if OWN_NAMES.match(name)} - known
    return sorted(names | SUBMODULES)


def _read_kept() -> str:
    return DERIVED.read_text(encoding="utf-8") if DERIVED.is_file() else ""


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
