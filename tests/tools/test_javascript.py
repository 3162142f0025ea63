"""`make lint` looks at JavaScript as it does at Python, with tools of pinned versions from npm."""

from __future__ import annotations

import subprocess

import pytest

from tools import ROOT
from tools.build import javascript
from tools.vendor import npm


def test_without_npm_it_is_said_that_nothing_was_checked(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refuse() -> str:
        raise npm.VendorError("npm could not fetch the packages")

    monkeypatch.setattr(npm, "install", refuse)
    assert javascript.main(["check"]) == 1
    said = "javascript: not checked, because its tools are not here. npm could not fetch"
    assert said in capsys.readouterr().err


def test_an_unknown_command_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert javascript.main(["look"]) == 2
    assert "expected one of check, format, got ['look']" in capsys.readouterr().out


@pytest.mark.parametrize("failing", range(len(javascript.COMMANDS["check"])))
def test_one_complaint_is_enough_and_hides_no_other(
    failing: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    commands: list[list[str]] = []

    def run(command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        commands.append(command)
        return subprocess.CompletedProcess(command, int(len(commands) - 1 == failing))

    monkeypatch.setattr(npm, "install", lambda *_: "up to date")
    monkeypatch.setattr(subprocess, "run", run)
    assert javascript.main(["check"]) == 1
    assert len(commands) == len(javascript.COMMANDS["check"])


def test_its_tools_are_locked_for_every_machine() -> None:
    # Each brings a program for the machine at hand, as an optional package without scripts.
    packages = npm.read_lock(npm.LINT)
    for name in ("@biomejs/biome", "typescript"):
        builds = packages[f"node_modules/{name}"]["optionalDependencies"]
        for machine in ("linux-x64", "linux-arm64", "darwin-arm64", "win32-x64"):
            (build,) = [one for one in builds if one.endswith(machine)]
            assert packages[f"node_modules/{build}"]["optional"]
        assert not any(packages[f"node_modules/{one}"].get("hasInstallScript") for one in builds)


def test_no_rule_is_off_without_a_reason() -> None:
    lines = (ROOT / "biome.jsonc").read_text(encoding="utf-8").splitlines()
    off = [number for number, line in enumerate(lines) if '"off"' in line]
    assert off
    for number in off:
        assert lines[number - 1].strip().startswith("//"), lines[number]
