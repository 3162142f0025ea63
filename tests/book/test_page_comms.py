"""Widgets of Python in the page: what they tell the page, and what they hear of it.

What the page unpacks is unpacked here too, and runs in a Python of its own, in which the small
IPython of the page stands in front of the real one.
"""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any, TypeAlias

import pytest

from tools import ROOT
from tools.vendor import pack_python, page_widgets

Run: TypeAlias = Callable[[str], Any]

PRELUDE = """
import json
import page_comms, page_outputs
messages = []
page_comms.connect(lambda text, buffers: messages.append({**json.loads(text), "buffers": buffers}))
import ipywidgets
import numpy as np

def hear(widget, state, buffer_paths=(), buffers=(), **more):
    data = {"method": "update", "state": state, "buffer_paths": list(buffer_paths)}
    message = {"type": "comm_msg", "comm_id": widget.model_id, "id": 7, "data": data, **more}
    messages.clear()
    page_comms.deliver(json.dumps(message), list(buffers))

def said():
    return [m["data"]["outputs"] for m in messages if m["type"] == "comm_said"]
"""


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("packages")
    for content in page_widgets.make_widget_assets().values():
        zipfile.ZipFile(io.BytesIO(content)).extractall(folder)
    for name, module in pack_python.collect_modules():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(module)
    return folder


@pytest.fixture
def run(unpacked: Path) -> Run:
    """Run code; return what it leaves as `answer`."""

    def run_code(code: str) -> Any:
        paths = os.pathsep.join([str(unpacked), str(ROOT)])
        done = subprocess.run(
            [sys.executable, "-W", "error", "-c", f"{PRELUDE}\n{code}\nprint(json.dumps(answer))"],
            env={**os.environ, "PYTHONPATH": paths},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout.splitlines()[-1])

    return run_code


def test_the_packed_packages_run_and_not_those_of_the_environment(run: Run, unpacked: Path) -> None:
    names = ["IPython", "ipywidgets", "anywidget", "traitlets", "comm", "psygnal"]
    code = f"import importlib\nanswer = [importlib.import_module(n).__file__ for n in {names}]"
    assert all(Path(file).is_relative_to(unpacked) for file in run(code))


def test_a_widget_is_opened_with_its_parts_before_it(run: Run) -> None:
    opened = run("ipywidgets.IntSlider(3)\nanswer = [{**m, 'buffers': 0} for m in messages]")
    assert {message["type"] for message in opened} == {"comm_open"}
    assert {message["target_name"] for message in opened} == {"jupyter.widget"}
    assert opened[-1]["metadata"]["version"].startswith("2.")
    states = [message["data"]["state"] for message in opened]
    assert [state["_model_name"] for state in states[-2:]] == ["SliderStyleModel", "IntSliderModel"]
    assert states[-1]["value"] == 3


def test_what_the_reader_moves_reaches_python_and_calls_it_back(run: Run) -> None:
    code = """
    slider, seen = ipywidgets.IntSlider(3), []
    slider.observe(lambda change: seen.append(change.new), "value")
    hear(slider, {"value": 8})
    answer = [slider.value, seen, messages[-1]["type"], messages[-1]["data"], len(messages)]
    """
    # nothing but the word that it is done: the page knows what it has said
    assert run(dedent(code)) == [8, [8], "comm_done", {"id": 7}, 1]


def test_what_python_sets_reaches_the_page(run: Run) -> None:
    code = """
    slider = ipywidgets.IntSlider(3)
    messages.clear()
    slider.value = 9
    answer = [{**m, "buffers": 0} for m in messages]
    """
    (message,) = run(dedent(code))
    assert (message["type"], message["data"]["state"]) == ("comm_msg", {"value": 9})


def test_bytes_travel_beside_the_text_both_ways(run: Run) -> None:
    code = """
    image = ipywidgets.Image(value=b"abc")
    opened = messages[-1]
    hear(image, {}, [["value"]], [memoryview(b"defg")])
    (sent,), heard = opened["buffers"], bytes(image.value)
    answer = [opened["data"]["buffer_paths"], sent.decode(), heard.decode()]
    """
    assert run(dedent(code)) == [[["value"]], "abc", "defg"]


def test_an_explorer_gives_python_what_the_reader_has_set(run: Run) -> None:
    code = """
    from labutils.explorers import explore_hsv
    explorer = explore_hsv(np.zeros((3, 4, 3), np.uint8))
    hear(explorer.view, {"hue_from": 170, "hue_to": 6, "pixel": [2, 1]})
    forms = page_outputs.make_bundle(explorer)
    answer = [explorer.hsv_range, explorer.pixel, sorted(forms)]
    """
    limits, pixel, forms = run(dedent(code))
    assert (limits, pixel) == ([[170, 0, 0], [6, 255, 255]], [2, 1])
    # a poster is for who knows no widgets, and takes its time
    assert forms == ["application/vnd.jupyter.widget-view+json", "text/plain"]


def test_what_a_callback_prints_goes_back_to_the_page(run: Run) -> None:
    code = """
    button = ipywidgets.Button()
    button.on_click(lambda _: print("pressed", "twice"))
    content = {"method": "custom", "content": {"event": "click"}}
    hear(button, {}, data=content)
    answer = [said(), page_outputs.current.outputs]
    """
    text = {"output_type": "stream", "name": "stdout", "text": "pressed twice\n"}
    assert run(dedent(code)) == [[[text]], []]


def test_an_error_in_a_callback_is_told_and_the_next_message_is_heard(run: Run) -> None:
    code = """
    slider = ipywidgets.IntSlider(3)
    def complain(change):
        raise ValueError(f"not {change.new}")
    slider.observe(complain, "value")
    hear(slider, {"value": 8})
    first = said(), messages[-1]["type"]
    hear(slider, {"value": 9})
    answer = [*first, said(), slider.value]
    """
    errors, last, again, value = run(dedent(code))
    assert errors == [
        [
            {
                "output_type": "error",
                "ename": "ValueError",
                "evalue": "not 8",
                "traceback": ["ValueError: not 8"],
            }
        ]
    ]
    assert last == "comm_done"
    assert again[0][0]["evalue"] == "not 9"
    assert value == 9


def test_a_message_to_a_widget_that_is_closed_is_answered_all_the_same(run: Run) -> None:
    code = """
    slider = ipywidgets.IntSlider(3)
    name = slider.model_id
    slider.close()
    messages.clear()
    data = {"method": "update", "state": {}, "buffer_paths": []}
    page_comms.deliver(json.dumps({"type": "comm_msg", "comm_id": name, "id": 1, "data": data}))
    answer = [m["type"] for m in messages]
    """
    assert run(dedent(code)) == ["comm_done"]


def test_interact_shows_what_its_function_prints_and_returns(run: Run) -> None:
    code = """
    def tell(x):
        print("x is", x)
        if x > 8:
            raise ValueError("too much")
        return 2 * x
    box = ipywidgets.interact(tell, x=(0, 10)).widget
    slider, output = box.children
    shown = [output.outputs]
    for value in (6, 9):
        hear(slider, {"value": value})
        shown.append(output.outputs)
    answer = [shown, [o["output_type"] for o in page_outputs.current.outputs]]
    """
    (first, second, third), published = run(dedent(code))
    assert published == ["display_data"]
    assert [o.get("text") or o["data"]["text/plain"] for o in first] == ["x is 5\n", "10"]
    assert [o.get("text") or o["data"]["text/plain"] for o in second] == ["x is 6\n", "12"]
    assert third[1]["evalue"] == "too much"


def test_an_error_names_the_cell_that_its_callback_stands_in(run: Run) -> None:
    code = """
    import page_outputs
    page_outputs.names.append("cell 1")
    slider, names = ipywidgets.IntSlider(3), {}
    exec(compile("def complain(change):\\n    raise ValueError('no')", "cell 1", "exec"), names)
    slider.observe(names["complain"], "value")
    hear(slider, {"value": 8})
    answer = said()[0][0]["traceback"]
    """
    (text,) = run(dedent(code))
    assert text.startswith("In cell 1:\n  line 2 in complain: ")
    assert "ValueError: no" in text


def test_an_output_widget_takes_what_is_shown_inside_it_only(run: Run) -> None:
    code = """
    from IPython.display import HTML, clear_output, display
    output = ipywidgets.Output()
    with output:
        print("one")
        print("two")
    text = output.outputs
    with output:
        clear_output(wait=True)
        display(HTML("<b>three</b>"))
    display(HTML("outside"))
    answer = [text, output.outputs, page_outputs.current.outputs]
    """
    text, shown, published = run(dedent(code))
    assert text == [{"output_type": "stream", "name": "stdout", "text": "one\ntwo\n"}]
    assert [o["data"]["text/html"] for o in shown] == ["<b>three</b>"]
    assert [o["data"]["text/html"] for o in published] == ["outside"]


def test_a_cell_can_clear_what_it_has_shown(run: Run) -> None:
    code = """
    from IPython.display import HTML, clear_output, display
    display(HTML("old"))
    clear_output()
    display(HTML("new"))
    answer = [o["data"]["text/html"] for o in page_outputs.current.outputs]
    """
    assert run(dedent(code)) == ["new"]


def test_numbers_of_numpy_travel_as_numbers(run: Run) -> None:
    code = """
    label = ipywidgets.Label()
    messages.clear()
    label.comm.send({"numbers": [np.int64(3), np.float32(0.5), np.arange(2)]})
    answer = messages[0]["data"]["numbers"]
    """
    assert run(dedent(code)) == [3, 0.5, [0, 1]]


def test_what_json_cannot_hold_is_named(run: Run) -> None:
    code = """
    try:
        ipywidgets.Label().comm.send({"what": object()})
    except TypeError as error:
        answer = str(error)
    """
    assert run(dedent(code)) == "a widget's value: expected what JSON can hold, got object"


def test_a_picture_is_shown_as_what_its_bytes_are(run: Run) -> None:
    code = """
    from IPython.display import Image
    try:
        Image(b"GIF89a")
    except ValueError as error:
        told = str(error)
    png = bytes([0x89]) + b"PNG"
    jpeg = bytes([255, 216, 255])
    answer = [*(list(Image(data)._repr_mimebundle_())[0] for data in (png, jpeg)), told]
    """
    png, jpeg, told = run(dedent(code))
    assert (png, jpeg) == ("image/png", "image/jpeg")
    assert told == "data: expected the bytes of a PNG or JPEG file, got b'GIF8'"
