"""Typeset formulas with the pinned MathJax: lines of JSON in, lines of JSON out.

``book/_ext/formulas.py`` starts it as ``python -m tools.vendor.typeset``, once per build.
"""

import subprocess
import sys
from pathlib import Path

from tools.vendor import npm

SCRIPT = Path(__file__).with_suffix(".mjs")


def main() -> int:
    """Hand the lines to MathJax in Node until there are no more; return the exit code."""
    try:
        npm.install()
        return subprocess.run([*npm.find_node(), str(SCRIPT)], check=False).returncode
    except npm.VendorError as error:
        print(f"formulas: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
