"""What waits for Python while it is busy: the latest values only, in as few messages as can be."""

from __future__ import annotations

import json
from typing import Any

from tests.helpers.node import run_node
from tools import ROOT

SCRIPT = ROOT / "book" / "_page_python" / "widgets_outbox.js"
PRELUDE = """
globalThis.window = { cameraLab: {} };
await import(process.argv[1]);
const posted = [];
const outbox = window.cameraLab.makeOutbox((message) => posted.push(message));
const update = (comm_id, state, buffer_paths = [], buffers = []) => outbox.push({
  type: "comm_msg", comm_id, data: { method: "update", state, buffer_paths }, buffers });
const tell = (comm_id, content) => outbox.push({
  type: "comm_msg", comm_id, data: { method: "custom", content }, buffers: [] });
const taskEnd = () => new Promise((resolve) => setTimeout(resolve));
const brief = () =>
  posted.map(({ id, comm_id, data }) => [id, comm_id, data.state ?? data.content]);
"""


def run(code: str) -> Any:
    printed = run_node(f"{PRELUDE}\n{code}\nconsole.log(JSON.stringify(answer));", SCRIPT.as_uri())
    return json.loads(printed)


def test_what_one_task_sends_leaves_together() -> None:
    code = """
    update("slider", { value: 1 });
    update("view", { hue: 1 });
    const before = posted.length;
    await taskEnd();
    const answer = [before, brief()];
    """
    assert run(code) == [0, [[1, "slider", {"value": 1}], [2, "view", {"hue": 1}]]]


def test_while_python_is_busy_the_latest_value_of_each_name_wins() -> None:
    code = """
    update("view", { hue: 1 });
    await taskEnd();
    for (const hue of [2, 3, 4]) { update("view", { hue }); await taskEnd(); }
    update("view", { shown: 1 });
    await taskEnd();
    const before = posted.length;
    outbox.done(1);
    const answer = [before, brief().slice(1)];
    """
    assert run(code) == [1, [[2, "view", {"hue": 4, "shown": 1}]]]


def test_the_next_batch_leaves_only_when_the_whole_one_before_is_done() -> None:
    code = """
    update("slider", { value: 1 });
    update("view", { hue: 1 });
    await taskEnd();
    update("view", { hue: 2 });
    await taskEnd();
    outbox.done(1);
    await taskEnd();
    const before = posted.length;
    outbox.done(2);
    const answer = [before, posted.length];
    """
    assert run(code) == [2, 3]


def test_a_message_of_its_own_is_not_overtaken() -> None:
    code = """
    update("view", { hue: 1 });
    tell("view", "look");
    update("view", { hue: 2 });
    await taskEnd();
    const answer = brief().map(([, , what]) => what);
    """
    assert run(code) == [{"hue": 1}, "look", {"hue": 2}]


def test_binary_values_are_replaced_with_what_is_binary_and_what_is_not() -> None:
    code = """
    update("view", { kept: 1, turned: [1] }, [["old"], ["turned", 0], ["left"]], ["a", "b", "c"]);
    update("view", { turned: 2 }, [["old"]], ["d"]);
    await taskEnd();
    const [{ data, buffers }] = posted;
    const answer = [posted.length, data, buffers];
    """
    count, data, buffers = run(code)
    assert count == 1
    assert data["state"] == {"kept": 1, "turned": 2}
    places = [path for (path,) in data["buffer_paths"]]
    assert dict(zip(places, buffers, strict=True)) == {"left": "c", "old": "d"}


def test_flush_sends_what_waits_before_a_cell_although_python_is_busy() -> None:
    code = """
    update("view", { hue: 1 });
    await taskEnd();
    update("view", { hue: 2 });
    outbox.flush();
    const answer = brief();
    """
    assert run(code) == [[1, "view", {"hue": 1}], [2, "view", {"hue": 2}]]


def test_quiet_is_when_python_has_heard_all() -> None:
    code = """
    const heard = [];
    await outbox.whenQuiet();
    update("view", { hue: 1 });
    await taskEnd();
    update("view", { hue: 2 });
    outbox.whenQuiet().then(() => heard.push("quiet"));
    outbox.done(1);
    await taskEnd();
    heard.push("one");
    outbox.done(2);
    await taskEnd();
    const answer = heard;
    """
    assert run(code) == ["one", "quiet"]


def test_a_python_that_was_stopped_lets_nobody_wait() -> None:
    code = """
    update("view", { hue: 1 });
    await taskEnd();
    update("view", { hue: 2 });
    const quiet = outbox.whenQuiet();
    outbox.clear();
    await quiet;
    update("view", { hue: 3 });
    await taskEnd();
    const answer = brief().map(([, , what]) => what.hue);
    """
    assert run(code) == [1, 3]
