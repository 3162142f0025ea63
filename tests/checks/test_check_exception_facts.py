"""Advice about exceptions stays short and true, runs nothing, and knows the words of versions."""

import re
from pathlib import Path

import cv2
import mujoco
import numpy as np
import pytest

from labutils.checks.exceptions import MAX_LENGTH, explain
from labutils.checks.exceptions.tutorials import INSTEAD
from labutils.checks.table import load_table
from labutils.raycast import RaycastRenderer
from labutils.scene import make_scene
from tests.helpers.cells import IMPORTS, find_raised, stop, write


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_long_names_make_no_long_advice() -> None:
    name = "the_depth_image_that_the_camera_on_the_head_of_the_robot_saw"
    for body in (
        f"{name} = None\nreturn {name}[0]",
        f"{name} = depth_raw\nreturn {name} @ np.ones((7, 7)) @ {name}",
        f"{name} = depth_raw\nreturn {name}.append(1)",
        f"{name}_2 = 1\nreturn {name}_3",
        f"{name} = cv2.moments(depth_raw)\nreturn {name}['m0']",
    ):
        assert len(find_raised("process_depth", write("process_depth", body)).advice) <= MAX_LENGTH


def test_advice_runs_nothing_of_the_learner() -> None:
    before = f"""{IMPORTS}
seen = []
class Curious:
    def __getattribute__(self, name):
        seen.append(name)
        raise AttributeError(name, name=name, obj=self)
    def __len__(self):
        seen.append("len")
        return 0
    def __dir__(self):
        seen.append("dir")
        return []
    def __repr__(self):
        seen.append("repr")
        return ""
"""
    for body, due in (
        ("thing = Curious()\nreturn thing[0]", []),
        ("thing = Curious()\nreturn thing + 1", []),
        ("thing = Curious()\nreturn np.zeros(3)[thing]", None),
        ("thing = Curious()\nreturn thing.depth", ["depth"]),
    ):
        function = write("process_depth", body, before)
        table = load_table("process_depth")
        seen = function.__globals__["seen"]
        arguments = table.cases[0].args
        error = stop(function, *arguments)
        alone = list(seen)
        assert due is None or alone == due
        explain(error, function.__code__.co_filename)
        assert seen == alone, body


#: Kind, text and sentence where other versions of Python, NumPy and OpenCV use other words.
OTHER_WORDS = [
    (ValueError, "max() iterable argument is empty", "There is nothing to choose from"),
    (ValueError, "max() arg is an empty sequence", "There is nothing to choose from"),
    (ValueError, "too many values to unpack (expected 2, got 3)", "gives 3 values, the left takes"),
    (TypeError, "only length-1 arrays can be converted to Python scalars", "one number is needed"),
    (TypeError, "cannot use 'list' as a dict key (unhashable type: 'list')", "a tuple can"),
    (
        IndexError,
        (
            "boolean index did not match indexed array along dimension 0; dimension is 4 but "
            "corresponding boolean dimension is 3"
        ),
        "needs the shape of the array",
    ),
    (
        cv2.error,
        (
            "OpenCV(4.11.0) :-1: error: (-5:Bad argument) in function 'findContours'\n"
            "> Overload resolution failed:\n>  - image data type = bool is not supported\n"
            ">  - Expected Ptr<cv::UMat> for argument 'image'"
        ),
        "image holds True and False: image.astype(np.uint8) * 255 is a mask of 0 and 255.",
    ),
    (
        cv2.error,
        (
            "OpenCV(4.11.0) arithm.cpp:230: error: (-215:Assertion failed) (mtype == CV_8U || "
            "mtype == CV_8S) && _mask.sameSize(*psrc1) in function 'binary_op'"
        ),
        "mask has to hold uint8",
    ),
    (
        cv2.error,
        (
            "OpenCV(4.5.0) color.simd_helpers.hpp:92: error: (-2:Unspecified error) in function "
            "'CvtHelper'\n> Invalid number of channels in input image:\n"
            ">     'VScn::contains(scn)'\n> where\n>     'scn' is 1"
        ),
        "depth_raw has shape (24, 32) and dtype float32: this conversion starts from other",
    ),
    (
        cv2.error,
        (
            "OpenCV(4.11.0) window.cpp:1295: error: (-2:Unspecified error) The function is not "
            "implemented. Rebuild the library with Windows, GTK+ 2.x or Cocoa support."
        ),
        "This OpenCV opens no windows",
    ),
]


@pytest.mark.parametrize(("kind", "text", "sentence"), OTHER_WORDS)
def test_words_of_other_versions_are_understood(
    kind: type[Exception], text: str, sentence: str
) -> None:
    def call_opencv(src: object) -> None:
        """call_opencv(src) -> nothing, as OpenCV writes its help."""
        del src
        raise kind(text)

    function = write("process_depth", "a, b = call_opencv(depth_raw)")
    function.__globals__["call_opencv"] = call_opencv
    assert sentence in find_raised("process_depth", function).advice


def test_what_is_said_to_exist_instead_exists() -> None:
    model, data = make_scene()
    known: dict[str, object] = {
        "np": np,
        "cv2": cv2,
        "mujoco": mujoco,
        "model": model,
        "data": data,
        "renderer": RaycastRenderer(model, 6, 8),
    }
    owners: dict[str, object] = {
        "numpy": np,
        "numpy.linalg": np.linalg,
        "cv2": cv2,
        "mujoco": mujoco,
        "Renderer": mujoco.Renderer,
        "MjModel": model,
        "MjData": data,
        "_MjModelCameraViews": model.camera(0),
        "_MjDataCameraViews": data.camera(0),
        "ndarray": np.zeros(3),
        "list": [],
        "tuple": (),
        "dict": {},
        "str": "",
    }
    assert owners.keys() == INSTEAD.keys()
    for owner, table in INSTEAD.items():
        for name, text in table.items():
            # NumPy 1.26 lacks what NumPy 2 has, and the other way round
            is_newer = owner == "numpy" and name in ("concat", "bool")
            is_older = owner == "numpy" and np.__version__.startswith("1.")
            assert is_newer or is_older or name not in dir(owners[owner]), (owner, name)
            for root, path in re.findall(
                r"\b(np|cv2|mujoco|model|data|renderer)((?:\.\w+)+)", text
            ):
                value = known[root]
                for step in path[1:].split("."):
                    value = getattr(value, step)
