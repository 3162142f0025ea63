"""Sentences for cv2.error, whose own words are those of OpenCV's C++ code.

OpenCV 4 and 5 differ in which file and line they name, and in what they take: version 4 refuses
masks of True and False in most functions.
"""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.exceptions.facts import Rule, get_child, join, tell_none
from labutils.checks.exceptions.site import UNKNOWN

if TYPE_CHECKING:
    from labutils.checks.exceptions.site import Site

#: Kinds of pixels that a function takes, by what its message asks for.
_TAKES = (
    (r"RETR_FLOODFILL|in function 'threshold'", "one channel of uint8, shape (H, W)"),
    (r"Depth == CV_8U|CV_8UC1 \)|== CV_8UC1", "one channel of uint8, shape (H, W)"),
    (r"channels\(\) == 1|must be single-channel", "one channel, shape (H, W)"),
    (r"ColorMap only supports", "uint8, from 0 to 255"),
    (r"Unsupported depth of input image", "uint8, uint16 or float32"),
    (r"Unsupported data type \(=", "uint8 or float32"),
    (r"src\.depth\(\) == CV_8U", "uint8"),
    (r"npoints >= 0", "points as int32 or float32, shape (N, 2)"),
)


def _list_arguments(site: Site) -> dict[str, ast.expr]:
    """List what the call got, by the names that OpenCV's own help gives them."""
    if not isinstance(site.node, ast.Call):
        return {}
    function = site.get_value(site.node.func)
    help_text = getattr(function, "__doc__", None) or ""
    signature = re.match(r"\w+\((.*?)\)", help_text)
    names = re.findall(r"\w+", signature[1]) if signature else []
    given = dict(zip(names, site.node.args, strict=False))
    return given | {one.arg: one.value for one in site.node.keywords if one.arg}


def _tell(site: Site, node: ast.expr | None) -> str:
    """Say what an argument was: its shape and dtype, or its type."""
    value, shown = site.get_value(node), site.show(node)
    if not shown or value is UNKNOWN:
        return ""
    if isinstance(value, np.ndarray):
        return f"{shown} has shape {value.shape} and dtype {value.dtype}"
    return f"{shown} is a {type(value).__name__}"


def _explain_empty(site: Site, found: re.Match[str]) -> str:
    del found
    first = next(iter(_list_arguments(site).values()), None)
    value = site.get_value(first)
    if value is None:
        return tell_none(site, first)
    told = _tell(site, first) if isinstance(value, np.ndarray) and not value.size else ""
    return f"{told}: it holds no pixel." if told else "The picture that it got holds no pixel."


def _explain_channels(site: Site, found: re.Match[str]) -> str:
    del found
    arguments = _list_arguments(site)
    told, code = _tell(site, arguments.get("src")), site.show(arguments.get("code"))
    source = re.search(r"COLOR_([A-Za-z]+)2", code)
    if source is None:
        return f"{told}: this conversion starts from other channels." if told else ""
    shapes = {"GRAY": "(H, W)", "RGBA": "(H, W, 4)", "BGRA": "(H, W, 4)"}
    wish = f"{code} starts from shape {shapes.get(source[1], '(H, W, 3)')}"
    return f"{told}; {wish}." if told else f"{wish}."


def _explain_pixels(site: Site, found: re.Match[str]) -> str:
    """Say what pixels a function takes, and what it got."""
    arguments = _list_arguments(site)
    name = site.show(get_child(site, "func")) or "The function"
    takes = next(words for pattern, words in _TAKES if re.search(pattern, found.string))
    first = next(iter(arguments.values()), None)
    if first is not None and site.get_value(first) is None:
        return tell_none(site, first)
    told = _tell(site, first)
    return f"{f'{told}; ' if told else ''}{name} takes {takes}."


def _explain_type(site: Site, found: re.Match[str]) -> str:
    parameter, kind = found.groups()
    node = _list_arguments(site).get(parameter)
    shown = site.show(node) or parameter
    if isinstance(node, ast.Compare | ast.BinOp | ast.UnaryOp | ast.BoolOp):
        shown = f"({shown})"
    if kind == "bool":
        return (
            f"{shown} holds True and False: {shown}.astype(np.uint8) * 255 is a mask of 0 and 255."
        )
    return f"{shown} holds {kind}, which OpenCV does not take: .astype(np.uint8) or np.float32."


def _explain_no_array(site: Site, found: re.Match[str]) -> str:
    parameter = found[1]
    node = _list_arguments(site).get(parameter)
    shown, value = site.show(node) or parameter, site.get_value(node)
    if type(value) in (list, tuple) and value:
        if type(value[0]) in (list, tuple, np.ndarray):
            kind = type(value).__name__
            return f"{shown} is a {kind} of {len(value)}; {parameter} takes one of them."
        if parameter in ("lowerb", "upperb"):
            return f"{shown} is a list; {parameter} takes a tuple or an array: np.array({shown})."
    if type(value) in (list, tuple):
        return f"{shown} is a {type(value).__name__}, and {parameter} takes an array."
    return f"{parameter} has to be an array or a tuple of numbers."


def _explain_limits(site: Site, found: re.Match[str]) -> str:
    del found
    arguments = _list_arguments(site)
    picture = site.get_value(arguments.get("src"))
    if not isinstance(picture, np.ndarray):
        return ""
    count = 1 if picture.ndim < 3 else picture.shape[2]
    shown = site.show(arguments.get("src")) or "The picture"
    return f"{shown} has {count} channel{'s' * (count > 1)}: each limit needs as many numbers."


def _explain_pair(site: Site, found: re.Match[str]) -> str:
    del found
    nodes = list(_list_arguments(site).values())[:2]
    told = [_tell(site, one) for one in nodes if isinstance(site.get_value(one), np.ndarray)]
    return f"{join(told)}: both need one shape and one dtype." if len(told) > 1 else ""


def _explain_signature(site: Site, found: re.Match[str]) -> str:
    """Give the arguments that a function needs, from OpenCV's own help."""
    shown = site.show(get_child(site, "func"))
    help_text = getattr(site.get_value(get_child(site, "func")), "__doc__", None) or ""
    signature = re.match(r"\w+\((.*?)(\[.*)?\)", help_text)
    if signature is None or not shown:
        return f"It lacks its argument {found[1]}." if found.re.groups else ""
    more = ", ..." if signature[2] else ""
    return f"It is called as {shown}({signature[1]}{more})."


def _explain_whole(site: Site, found: re.Match[str]) -> str:
    node = _list_arguments(site).get(found[1])
    value, shown = site.get_value(node), site.show(node)
    if isinstance(value, str) and found[1] == "code":
        return "code is a constant of OpenCV, as in cv2.COLOR_RGB2HSV, and no text."
    if isinstance(value, float) and shown:
        return f"{shown} is a float, and {found[1]} takes a whole number: int({shown})."
    return f"{found[1]} takes a whole number: // or int(...) gives one."


RULES = (
    Rule("error", r"^OpenCV.*(?:src|image|mat|img)\.empty\(\)", _explain_empty),
    Rule("error", r"^OpenCV.*Bad number of channels|Invalid number of channels", _explain_channels),
    Rule("error", r"^OpenCV.*?(\w+) data type = (\w+) is not supported", _explain_type),
    Rule(
        "error",
        r"^OpenCV.*?(\w+) is not a num(?:py array, neither a scalar|erical tuple)",
        _explain_no_array,
    ),
    Rule("error", r"^OpenCV.*boundary is neither an array", _explain_limits),
    Rule(
        "error",
        r"^OpenCV.*(?:Sizes of input arguments do not match|output array type must be)",
        _explain_pair,
    ),
    Rule("error", r"^OpenCV.*?missing required argument '(\w+)'", _explain_signature),
    Rule("error", r"^OpenCV.*takes at most \d+ arguments", _explain_signature),
    Rule("error", r"^OpenCV.*?Argument '(\w+)' is required to be an integer", _explain_whole),
    Rule(
        "error",
        r"^OpenCV.*?Can't parse '(\w+)'\. Sequence item with index \d+ has a wrong type",
        "{0} takes whole numbers: int(...) for each of them.",
    ),
    Rule(
        "error",
        r"^OpenCV.*?Can't parse '(\w+)'\. Expected sequence length (\d+), got (\d+)",
        "{0} takes {1} numbers, and got {2}.",
    ),
    Rule(
        "error",
        r"^OpenCV.*?Can't parse '(\w+)'\. Input argument doesn't provide sequence protocol",
        "{0} takes several numbers in brackets, as in (5, 5), and got a single one.",
    ),
    Rule(
        "error",
        r"^OpenCV.*?Scalar value for argument '(\w+)' is not numeric",
        "{0} takes numbers, as in (255, 0, 0).",
    ),
    Rule(
        "error",
        r"^OpenCV.*Layout of the output array (\w+) is incompatible",
        "OpenCV cannot draw into this array, a view or of a type that it has not: "
        "np.ascontiguousarray({0}, np.uint8) makes one.",
    ),
    Rule(
        "error",
        r"^OpenCV.*npoints > 0 in function 'drawContours'",
        "drawContours takes a list of contours, also for one: [contour].",
    ),
    Rule(
        "error",
        r"^OpenCV.*_kernel\.type\(\) == CV_8U",
        "The kernel has to be an array, as in np.ones((5, 5), np.uint8).",
    ),
    Rule(
        "error",
        r"^OpenCV.*k\w*\.?\w* % 2 == 1",
        "The size of the window has to be odd: 3, 5, 7, ...",
    ),
    Rule(
        "error",
        r"^OpenCV.*mtype == CV_8U",
        "mask has to hold uint8 and to be of the size of the picture.",
    ),
    Rule(
        "error",
        r"^OpenCV.*Rebuild the library with",
        "This OpenCV opens no windows: leave out imshow, waitKey and destroyAllWindows. "
        "labutils.show(picture) shows a picture.",
    ),
    Rule("error", rf"^OpenCV.*(?:{'|'.join(pattern for pattern, _ in _TAKES)})", _explain_pixels),
)
