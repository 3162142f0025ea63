"""Hooks, dev container, forms and .gitignore: true to the Makefile, the locks and the library."""

import json
import os
import re
import shlex
import subprocess
from pathlib import Path
from typing import Any, NoReturn

import pytest

from labutils.checks.progress import Progress, load_progress, save_progress
from labutils.checks.progress_rules import FILE_NAME
from tests.helpers.everyday import (
    GITHUB,
    ROOT,
    find_command,
    get_installed,
    get_steps,
    get_system_packages,
    load_yaml,
)

FORMS = sorted((GITHUB / "ISSUE_TEMPLATE").glob("*.yml"))
FORMS.remove(GITHUB / "ISSUE_TEMPLATE" / "config.yml")

TARGET = re.compile(r"^([a-z][a-z-]*):", re.MULTILINE)


@pytest.fixture
def hooks() -> dict[str, Any]:
    repos = load_yaml(ROOT / ".pre-commit-config.yaml")["repos"]
    return {hook["id"]: hook for repo in repos if repo["repo"] == "local" for hook in repo["hooks"]}


@pytest.fixture
def container() -> dict[str, Any]:
    return json.loads((ROOT / ".devcontainer" / "devcontainer.json").read_text(encoding="utf-8"))


@pytest.fixture
def learner(tmp_path: Path) -> Path:
    """Make a folder of a learner, under git with our .gitignore, with a room for notebooks."""
    run_git(tmp_path, "init", "--quiet")
    (tmp_path / ".gitignore").write_bytes((ROOT / ".gitignore").read_bytes())
    (tmp_path / "book").mkdir()
    return tmp_path


def run_git(folder: Path, *arguments: str) -> str:
    """Run git as if nobody had configured it; return what it printed."""
    nobody = os.environ | {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1"}
    done = subprocess.run(
        ["git", *arguments], cwd=folder, env=nobody, check=True, capture_output=True, text=True
    )
    return done.stdout


# --- pre-commit


def test_every_hook_of_ours_calls_a_target_that_the_makefile_has(hooks: dict[str, Any]) -> None:
    targets = set(TARGET.findall((ROOT / "Makefile").read_text(encoding="utf-8")))
    assert hooks
    for name, hook in hooks.items():
        program, *arguments = shlex.split(hook["entry"])
        assert program == "make", name
        called = [word for word in arguments if not word.startswith("-")]
        assert called, name
        assert set(called) <= targets, name
        assert hook["pass_filenames"] is False, name  # make would take a file for a target


def test_a_commit_is_formatted_and_derived_anew_and_types_wait_for_the_push(
    hooks: dict[str, Any],
) -> None:
    entries = {name: shlex.split(hook["entry"])[-1] for name, hook in hooks.items()}
    assert entries == {"format": "format", "exercises": "exercises", "lint": "lint"}
    assert hooks["lint"]["stages"] == ["pre-push"]
    config = load_yaml(ROOT / ".pre-commit-config.yaml")
    assert config["default_stages"] == ["pre-commit"]
    assert set(config["default_install_hook_types"]) == {"pre-commit", "pre-push"}


@pytest.mark.parametrize(
    ("path", "is_watched"),
    [
        ("solutions/process_depth.py", True),
        ("exercises/concepts/step3.yml", True),
        ("exercises/_generated/process_depth.py", True),
        ("labutils/checks/tables/exercises.json", True),
        ("book/step3_depth.md", True),
        ("README.md", False),
        ("tests/tools/test_everyday_files.py", False),
    ],
)
def test_the_hook_of_the_exercises_watches_what_they_are_derived_from(
    hooks: dict[str, Any], path: str, is_watched: bool
) -> None:
    assert bool(re.search(hooks["exercises"]["files"], path)) is is_watched


def test_the_version_of_ruff_stands_in_the_lock_alone() -> None:
    config = load_yaml(ROOT / ".pre-commit-config.yaml")
    others = [repo for repo in config["repos"] if repo["repo"] != "local"]
    assert {repo["repo"].rpartition("/")[2] for repo in others} == {"pre-commit-hooks"}
    hooks = [hook for repo in config["repos"] for hook in repo["hooks"]]
    assert not any("additional_dependencies" in hook for hook in hooks)
    locked = re.findall(r"^ruff==", (ROOT / "requirements.txt").read_text(), re.MULTILINE)
    assert len(locked) == 1


def test_hooks_of_others_are_pinned_to_a_commit() -> None:
    text = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    revisions = re.findall(r"^\s*rev: (.+)$", text, re.MULTILINE)
    assert revisions
    for revision in revisions:
        assert re.fullmatch(r"[0-9a-f]{40} # frozen: v\d+\.\d+\.\d+", revision)


def test_the_hooks_that_clean_white_space_leave_derived_files_alone() -> None:
    config = load_yaml(ROOT / ".pre-commit-config.yaml")
    hooks = {hook["id"]: hook for repo in config["repos"] for hook in repo["hooks"]}
    derived = [*ROOT.glob("*/_generated/*"), *ROOT.glob("labutils/checks/tables/*.json")]
    drawn = [*ROOT.glob("book/_static/figures/*.svg")]
    assert derived
    assert drawn
    for name in ("trailing-whitespace", "end-of-file-fixer"):
        exclude = re.compile(hooks[name]["exclude"])
        for path in [*derived, *drawn]:
            assert exclude.search(path.relative_to(ROOT).as_posix()), path
        assert not exclude.search("labutils/camera_utils.py")
        assert not exclude.search("book/step3_depth.md")


# --- the dev container


def test_the_container_installs_apt_txt_and_the_browsers_of_ci(container: dict[str, Any]) -> None:
    command = find_command(container["onCreateCommand"], "apt-get install")
    wanted = get_system_packages()
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    by_ci = find_command(script, "apt-get install").removesuffix("> /dev/null")
    browsers = get_installed(by_ci)
    assert "chromium" in browsers
    assert get_installed(command) == wanted | browsers


def test_the_container_sets_up_as_everybody_does_and_has_the_python_of_ci(
    container: dict[str, Any],
) -> None:
    assert container["postCreateCommand"] == "make setup"
    check = load_yaml(GITHUB / "workflows" / "ci.yml")["jobs"]["check"]
    (python,) = get_steps(check, "actions/setup-python")
    tag = container["image"].rpartition(":")[2]
    assert re.fullmatch(rf"\d+-{re.escape(python['with']['python-version'])}-[a-z]+", tag)


def test_the_container_forwards_the_ports_of_the_pages_and_of_the_notebooks(
    container: dict[str, Any],
) -> None:
    assert container["forwardPorts"] == [8000, 8888]
    assert set(container["portsAttributes"]) == {"8000", "8888"}
    serve = find_command((ROOT / "Makefile").read_text(encoding="utf-8"), "http.server")
    assert serve.endswith(" 8000")


def test_the_editor_uses_the_locked_environment(container: dict[str, Any]) -> None:
    settings = container["customizations"]["vscode"]["settings"]
    assert settings["python.defaultInterpreterPath"].endswith("/.venv/bin/python")
    assert settings["ruff.importStrategy"] == "fromEnvironment"


# --- issues, requests, security


@pytest.mark.parametrize("path", FORMS, ids=lambda path: path.stem)
def test_every_form_asks_for_something_and_its_fields_have_names(path: Path) -> None:
    form = load_yaml(path)
    assert form["name"]
    assert form["description"]
    fields = [field for field in form["body"] if field["type"] != "markdown"]
    assert all(field["attributes"]["label"] for field in fields)
    names = [field["id"] for field in fields]
    assert len(names) == len(set(names))
    assert sum(field.get("validations", {}).get("required", False) for field in fields) >= 2


def test_the_form_for_a_verdict_requires_code_and_message() -> None:
    form = load_yaml(GITHUB / "ISSUE_TEMPLATE" / "verdict.yml")
    fields = {field["id"]: field for field in form["body"] if "id" in field}
    required = {name for name, field in fields.items() if field.get("validations")}
    assert required == {"exercise", "place", "code", "message", "expected"}
    # shown as they were typed: Markdown would eat the stars and the indents
    assert fields["code"]["attributes"]["render"] == "python"
    assert fields["message"]["attributes"]["render"] == "text"


def test_the_form_for_a_page_quotes_the_line_that_every_page_ends_with() -> None:
    form = (GITHUB / "ISSUE_TEMPLATE" / "page.yml").read_text(encoding="utf-8")
    (quoted,) = re.findall(r'\("(.+?) \.\.\."\)', form)
    assert quoted in (ROOT / "book" / "_ext" / "page_stamp.py").read_text(encoding="utf-8")


def test_the_buttons_of_the_pages_can_open_an_issue() -> None:
    book = load_yaml(ROOT / "_config.yml")
    issues = load_yaml(GITHUB / "ISSUE_TEMPLATE" / "config.yml")
    assert book["html"]["use_issues_button"] is True
    # it opens a blank issue whose text names the page; without blank ones the name is lost
    assert issues["blank_issues_enabled"] is True


def test_the_link_for_reports_in_private_leads_to_this_repository() -> None:
    address = load_yaml(ROOT / "_config.yml")["repository"]["url"]
    (link,) = load_yaml(GITHUB / "ISSUE_TEMPLATE" / "config.yml")["contact_links"]
    assert link["url"] == f"{address}/security/advisories/new"


@pytest.mark.parametrize("path", [GITHUB / "PULL_REQUEST_TEMPLATE.md", ROOT / "SECURITY.md"])
def test_texts_for_contributors_name_targets_that_exist(path: Path) -> None:
    targets = set(TARGET.findall((ROOT / "Makefile").read_text(encoding="utf-8")))
    named = set(re.findall(r"`make ([a-z-]+)`", path.read_text(encoding="utf-8")))
    assert named
    assert named <= targets


# --- what git must not take up


def test_git_ignores_what_is_kept_of_a_learner(
    learner: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for folder in (learner, learner / "book"):
        for _ in range(2):  # two damaged files, each set aside under a number
            (folder / FILE_NAME).write_text("{", encoding="utf-8")
            assert "kept as" in load_progress(folder).notice
        assert save_progress(Progress(), folder) == ""
        with monkeypatch.context() as patch:  # the kernel is interrupted while it writes
            patch.setattr(os, "replace", _interrupt)
            with pytest.raises(KeyboardInterrupt, match="while writing"):
                save_progress(Progress(), folder)
    written = [path.relative_to(learner).as_posix() for path in learner.rglob("labutils-*")]
    assert len(written) == 2 * 4
    assert sorted(run_git(learner, "check-ignore", *written).split()) == sorted(written)


def _interrupt(*_: object) -> NoReturn:
    raise KeyboardInterrupt("while writing")


def test_git_takes_up_the_module_that_keeps_the_progress(learner: Path) -> None:
    module = learner / "labutils" / "checks" / "progress.py"
    module.parent.mkdir(parents=True)
    module.touch()
    listed = run_git(learner, "status", "--porcelain", "--untracked-files=all")
    assert "labutils/checks/progress.py" in listed
