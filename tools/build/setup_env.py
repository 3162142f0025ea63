"""Set up everything `make` needs: system packages, a virtual environment, locked packages.

Runs with the system's Python and nothing but its standard library. Does nothing when all is in
place. Called by every target of the Makefile.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

from tools import ROOT
from tools.build.jupyter_settings import install_settings, list_settings

VENV = ROOT / ".venv"
STAMP = VENV / ".ready"
MINIMUM = (3, 11)


def main() -> int:
    """Install what is missing; return a shell's exit code."""
    if sys.version_info < MINIMUM:
        found = ".".join(map(str, sys.version_info[:3]))
        print(f"setup: expected Python >= 3.11, got {found} ({sys.executable})", file=sys.stderr)
        print("setup: name another one: make PYTHON=/path/to/python3.11 ...", file=sys.stderr)
        return 1
    install_system_packages()
    wanted = fingerprint()
    if STAMP.is_file() and STAMP.read_text(encoding="ascii") == wanted:
        return 0
    try:
        install_python_packages()
    except subprocess.CalledProcessError as error:
        print(f"setup: {' '.join(map(str, error.cmd))} failed", file=sys.stderr)
        print(
            "setup: packages come from the Python package index; is this machine online, "
            "and is python3-venv installed?",
            file=sys.stderr,
        )
        return 1
    install_settings(VENV)
    STAMP.write_text(wanted, encoding="ascii")
    print("setup: done")
    return 0


def fingerprint() -> str:
    """Hash what the environment depends on, so that a changed lock file installs again."""
    digest = hashlib.sha256()
    for path in (ROOT / "requirements.txt", ROOT / "pyproject.toml", *list_settings()):
        digest.update(path.read_bytes())
    digest.update(str(ROOT).encode() + sys.version.encode())
    return digest.hexdigest()


def install_system_packages() -> None:
    """Install apt.txt where we may; elsewhere name the one command and go on."""
    if shutil.which("dpkg-query") is None:
        return  # not Debian or Ubuntu: macOS and Windows draw without extra packages
    wanted = (ROOT / "apt.txt").read_text(encoding="ascii").split()
    missing = find_missing(wanted)
    if not missing:
        return
    command = ["apt-get", "install", "-y", "--no-install-recommends", *missing]
    if os.geteuid() != 0:
        print(f"setup: drawing with OpenGL needs {' '.join(missing)}. To get it, run")
        print(f"setup:   sudo {' '.join(command)}")
        print("setup: going on without: the ray caster draws (exact depth, flat colors)")
        return
    print(f"setup: installing {' '.join(missing)} with apt-get")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for step in (["apt-get", "update"], command):
        done = subprocess.run(step, env=environment, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(f"setup: {' '.join(step)} failed:\n{done.stderr.strip()}", file=sys.stderr)
            print("setup: going on without: the ray caster draws (exact depth, flat colors)")
            return


def find_missing(packages: list[str]) -> list[str]:
    """Ask dpkg, once, which of the packages are not installed."""
    done = subprocess.run(
        ["dpkg-query", "--show", "--showformat=${Package} ${db:Status-Status}\n", *packages],
        capture_output=True,
        text=True,
        check=False,  # it fails where it does not know one, and tells of the others
    )
    lines = set(done.stdout.splitlines())
    return [name for name in packages if f"{name} installed" not in lines]


def install_python_packages() -> None:
    """Make the virtual environment and fill it with exactly the locked packages."""
    python = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.exists():
        print("setup: making the virtual environment .venv")
        venv.create(VENV, with_pip=True, clear=True, symlinks=os.name != "nt")
    lock = (ROOT / "requirements.txt").read_text(encoding="utf-8")
    # uv installs ten times as fast as pip; pip fetches uv itself, by the same locked hashes.
    uv_lines = re.search(r"^uv==.*?(?=^\S|\Z)", lock, re.MULTILINE | re.DOTALL)
    if uv_lines is None:
        raise SystemExit("setup: expected uv in requirements.txt; run `make lock`")
    with tempfile.TemporaryDirectory() as folder:
        only_uv = Path(folder) / "uv.txt"
        only_uv.write_text(uv_lines.group(), encoding="utf-8")
        pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run(
            [*pip, "--require-hashes", "-r", str(only_uv)], check=True, stdout=subprocess.DEVNULL
        )
    print("setup: installing the locked packages (about 1.3 GB on disk)")
    uv = [str(python), "-m", "uv", "pip", "install", "--quiet", "--python", str(python)]
    subprocess.run(
        [*uv, "--require-hashes", "-r", str(ROOT / "requirements.txt")],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    subprocess.run(
        [*uv, "--no-deps", "--no-build-isolation", "--editable", str(ROOT)],
        check=True,
        stdout=subprocess.DEVNULL,
    )


if __name__ == "__main__":
    sys.exit(main())
