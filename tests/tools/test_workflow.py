"""The workflow on GitHub: it does what .ci/run does, with small rights and pinned actions."""

import re
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.everyday import (
    GITHUB,
    ROOT,
    find_command,
    get_installed,
    get_steps,
    get_system_packages,
    load_yaml,
)

WORKFLOWS = sorted((GITHUB / "workflows").glob("*.y*ml"))

# An action of somebody else: a tag can be moved, a commit cannot; the comment is for readers.
PINNED = re.compile(r"^[\w-]+/[\w./-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+$")
USES = re.compile(r"^\s*(?:- )?uses: (.+?)\s*$", re.MULTILINE)
ON_MAIN_ONLY = "github.event_name == 'push' && github.ref == 'refs/heads/main'"
# What somebody who opens a pull request can choose; pasted into a script, it is run.
UNTRUSTED = re.compile(r"\$\{\{[^}]*github\.(event\.|head_ref)")


def get_jobs() -> list[tuple[str, dict[str, Any]]]:
    """List every job of every workflow, with a name for messages."""
    return [
        (f"{path.name}: {name}", job)
        for path in WORKFLOWS
        for name, job in load_yaml(path)["jobs"].items()
    ]


@pytest.fixture
def check() -> dict[str, Any]:
    return load_yaml(GITHUB / "workflows" / "ci.yml")["jobs"]["check"]


@pytest.fixture
def deploy() -> dict[str, Any]:
    return load_yaml(GITHUB / "workflows" / "ci.yml")["jobs"]["deploy"]


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_every_action_is_pinned_to_a_commit_and_says_its_version(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    found = USES.findall(text)
    in_jobs = [step for job in load_yaml(path)["jobs"].values() for step in job["steps"]]
    assert len(found) == sum("uses" in step for step in in_jobs) > 0
    assert [uses for uses in found if not PINNED.match(uses)] == []


def test_one_action_is_pinned_to_one_commit() -> None:
    pins = {uses for path in WORKFLOWS for uses in USES.findall(path.read_text(encoding="utf-8"))}
    names = [uses.partition("@")[0] for uses in pins]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_may_read_the_source_and_nothing_else(path: Path) -> None:
    assert load_yaml(path)["permissions"] == {"contents": "read"}


def test_only_the_deployment_may_write() -> None:
    may_write = {
        name: job["permissions"]
        for name, job in get_jobs()
        if "write" in str(job.get("permissions", ""))
    }
    assert may_write == {"ci.yml: deploy": {"pages": "write", "id-token": "write"}}


def test_every_job_has_an_end_and_a_runner_that_does_not_move() -> None:
    for name, job in get_jobs():
        assert 0 < job["timeout-minutes"] <= 60, name
        assert re.fullmatch(r"ubuntu-\d\d\.\d\d", job["runs-on"]), name


def test_the_workflow_runs_on_main_and_on_requests_without_their_secrets() -> None:
    workflow = load_yaml(GITHUB / "workflows" / "ci.yml")
    # YAML 1.1 reads the bare word `on` as true
    assert workflow[True] == {"push": {"branches": ["main"]}, "pull_request": None}
    assert "secrets." not in (GITHUB / "workflows" / "ci.yml").read_text(encoding="utf-8")


def test_no_script_runs_what_a_pull_request_can_name() -> None:
    scripts = [step["run"] for _, job in get_jobs() for step in job["steps"] if "run" in step]
    assert scripts
    assert not any(UNTRUSTED.search(script) for script in scripts)


def test_no_step_leaves_a_token_in_the_checkout(check: dict[str, Any]) -> None:
    (checkout,) = get_steps(check, "actions/checkout")
    assert checkout["with"]["persist-credentials"] is False


def test_the_workflow_runs_the_script_of_ci_and_no_checks_of_its_own(check: dict[str, Any]) -> None:
    scripts = [step["run"].strip() for step in check["steps"] if "run" in step]
    assert scripts.count("bash .ci/run") == 1
    assert (ROOT / ".ci" / "run").is_file()
    assert not any(re.search(r"\b(make|pytest|ruff|mypy)\b", script) for script in scripts)
    assert not any("continue-on-error" in step for step in check["steps"])
    (python,) = get_steps(check, "actions/setup-python")
    assert python["with"]["python-version"] == "3.11"


def test_the_workflow_installs_what_the_setup_may_not(check: dict[str, Any]) -> None:
    # the runner is not root, and the setup would go on without OpenGL
    (script,) = (step["run"] for step in check["steps"] if "apt-get" in step.get("run", ""))
    wanted = get_system_packages()
    assert get_installed(find_command(script, "apt-get install")) == wanted


def test_the_browsers_of_the_workflow_are_named_as_the_tests_ask(check: dict[str, Any]) -> None:
    # without these names the tests would look for those of Debian, which .ci/run installs as root
    assert set(check["env"]) == {"CHROMIUM", "FIREFOX"}
    assert all(path.startswith("/usr/bin/") for path in check["env"].values())


def test_caches_follow_the_lock_files_and_hold_no_executed_page(check: dict[str, Any]) -> None:
    caches = [step["with"] for step in get_steps(check, "actions/cache")]
    kept = [path for cache in caches for path in cache["path"].split()]
    assert {"_build/vendor*", "_build/npm", "_build/wheels", "~/.cache/uv"} <= set(kept)
    for path in kept:
        for derived in ("html", ".jupyter_cache", ".doctrees", "page_python", "instructor"):
            assert not Path("_build", derived).match(path), path
        assert path not in {"_build", "_build/", "_build/*", "_build/**", ".venv"}
    for cache in caches:
        locks = re.findall(r"'([^']+)'", cache["key"])
        assert locks, cache["key"]
        assert all((ROOT / name).is_file() for name in locks)
        assert set(locks) <= {"requirements.txt", "package-lock.json"}


def test_the_book_is_kept_and_the_instructors_book_is_not(check: dict[str, Any]) -> None:
    (book,) = get_steps(check, "actions/upload-artifact")
    (pages,) = get_steps(check, "actions/upload-pages-artifact")
    assert book["with"]["path"].split() == ["_build/html", "_build/book.log"]
    assert pages["with"]["path"] == "_build/html"
    assert pages["if"] == ON_MAIN_ONLY


def test_pages_are_published_from_main_and_after_the_checks_alone(deploy: dict[str, Any]) -> None:
    assert deploy["if"] == ON_MAIN_ONLY  # an own `if` with always() would ignore a failed check
    assert deploy["needs"] == "check"
    assert deploy["environment"]["name"] == "github-pages"
    assert deploy["concurrency"]["cancel-in-progress"] is False
    # the job that may write runs no line of the repository
    assert [step["uses"].partition("@")[0] for step in deploy["steps"]] == ["actions/deploy-pages"]


def test_only_requests_are_cut_short_by_a_newer_push() -> None:
    concurrency = load_yaml(GITHUB / "workflows" / "ci.yml")["concurrency"]
    assert "github.ref" in concurrency["group"]
    assert concurrency["cancel-in-progress"] == "${{ github.event_name == 'pull_request' }}"


def test_dependabot_renews_the_actions_and_leaves_our_locks_alone() -> None:
    (update,) = load_yaml(GITHUB / "dependabot.yml")["updates"]
    assert update["package-ecosystem"] == "github-actions"
    assert update["schedule"]["interval"] == "weekly"
