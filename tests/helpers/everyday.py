"""Read the files that GitHub, pre-commit and editors read."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parents[2]
GITHUB = ROOT / ".github"


def load_yaml(path: Path) -> Any:
    """Read a YAML file."""
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def get_steps(job: dict[str, Any], action: str) -> list[dict[str, Any]]:
    """List the steps of a job that use an action."""
    return [step for step in job["steps"] if step.get("uses", "").startswith(f"{action}@")]


def get_installed(command: str) -> set[str]:
    """Name the packages of an ``apt-get install``, those that xargs reads from apt.txt included."""
    words = shlex.split(command)
    named = {word for word in words[words.index("install") :] if not word.startswith("-")}
    if words[:3] == ["xargs", "-a", "apt.txt"]:
        named |= get_system_packages()
    return named - {"install"}


def find_command(text: str, part: str) -> str:
    """Return the one command of a script, or of commands joined by &&, that holds a text."""
    (found,) = (line for line in re.split(r"\n|&&", text) if part in line)
    return found.strip()


def get_system_packages() -> set[str]:
    """Name what apt.txt asks for."""
    return set((ROOT / "apt.txt").read_text(encoding="ascii").split())
