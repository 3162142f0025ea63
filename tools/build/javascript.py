"""Check or rewrite the JavaScript of the house: Biome for style and rules, TypeScript for types.

Both come from npm at the versions of ``tools/lint/package-lock.json`` (``tools/vendor/npm.py``), in
builds for the machine at hand that need no script at their install. ``biome.jsonc``,
``tsconfig.json`` and ``tsconfig.scripts.json`` say what is asked.

Usage: ``python -m tools.build.javascript check`` or ``... format``.
"""

from __future__ import annotations

import subprocess
import sys

from tools import ROOT
from tools.vendor import npm

COMMANDS = {
    "check": (
        ("@biomejs/biome/bin/biome", "check", "--error-on-warnings"),
        ("typescript/bin/tsc", "--project", "tsconfig.json"),
        ("typescript/bin/tsc", "--project", "tsconfig.scripts.json"),
    ),
    "format": (("@biomejs/biome/bin/biome", "check", "--write"),),
}


def main(arguments: list[str]) -> int:
    """Run the tools of one command, all of them; return the worst exit code."""
    if len(arguments) != 1 or arguments[0] not in COMMANDS:
        print(f"javascript: expected one of {', '.join(COMMANDS)}, got {arguments}")
        return 2
    try:
        npm.install()  # the packages whose types the scripts use
        npm.install(npm.LINT)
        node = npm.find_node()
    except npm.VendorError as error:
        print(f"javascript: not checked, because its tools are not here. {error}", file=sys.stderr)
        return 1
    return max(
        subprocess.run(
            [*node, str(npm.get_package(script, npm.LINT)), *options], cwd=ROOT, check=False
        ).returncode
        for script, *options in COMMANDS[arguments[0]]
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
