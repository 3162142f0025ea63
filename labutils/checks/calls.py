"""Call a learner's function on the cases of an exercise, and keep the checker out of its reach."""

from __future__ import annotations

import inspect
import linecache
import traceback
import warnings
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import Any

import numpy as np

from labutils.checks.exceptions import Call, explain
from labutils.checks.kinds import get_kind
from labutils.checks.loops.scenario import Loop
from labutils.checks.table import Case, CheckTable, Misfit, Outcome, Part, Raised, Scene

Function = Callable[..., object]

#: What a controller answers, call by call.
_COMMAND = (Part("pan", "number", "float"), Part("tilt", "number", "float"))

#: Text of an exception is cut here: a message has to stay readable.
_TEXT_LIMIT = 160


def collect_answers(table: CheckTable, function: Function) -> tuple[Outcome, ...]:
    """Call the function once per case.

    Every call gets its own copy of the arguments: a function that writes into its input, or keeps
    it, changes no other case.
    """
    return unify_answers(
        table, tuple(call_once(table.parts, case, function) for case in table.cases)
    )


def unify_answers(table: CheckTable, answers: tuple[Outcome, ...]) -> tuple[Outcome, ...]:
    """Bring the answers of all cases into one form, where the statement leaves a choice."""
    both = [
        (n, due, yours)
        for n, (due, yours) in enumerate(zip(table.expected, answers, strict=True))
        if isinstance(due, tuple) and isinstance(yours, tuple)
    ]
    unified = {n: list(yours) for n, _, yours in both}
    for number, part in enumerate(table.parts):
        pairs = [
            (n, x, y)
            for n, due, yours in both
            if (x := due[number]) is not None and (y := yours[number]) is not None
        ]
        if not pairs:
            continue
        changed = get_kind(part).unify([x for _, x, _ in pairs], [y for _, _, y in pairs])
        for (n, _, _), value in zip(pairs, changed, strict=True):
            unified[n][number] = value
    return tuple(tuple(unified[n]) if n in unified else answer for n, answer in enumerate(answers))


def call_once(parts: tuple[Part, ...], case: Case, function: Function) -> Outcome:
    """Call the function on a fresh copy of one case and take its answer apart.

    In a loop it is called as often as the loop says: what comes back is the trace.
    """
    if case.args and isinstance(case.args[0], Loop):
        return _act(case, case.args[0], function)
    args, observers = prepare_arguments(case.args)
    try:
        # Warnings about NaN and zero are expected on invalid pixels: they are not the verdict.
        with warnings.catch_warnings(), np.errstate(all="ignore"), _drawing(case, function):
            warnings.simplefilter("ignore")
            output = function(*args)
    except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a learner's code raises
        return describe_error(error, function, _name_call(case, function, args))
    seen = tuple(observe() for observe in observers)
    return split_answer(parts, output, seen)


class _UnfitError(Exception):
    """An answer that is no command: the loop cannot go on."""

    def __init__(self, misfit: Misfit) -> None:
        super().__init__(misfit.text)
        self.misfit = misfit


def _act(case: Case, loop: Loop, function: Function) -> Outcome:
    """Let the function act in a loop."""
    # MuJoCo is imported here, because most exercises run without it.
    from labutils.checks.loops.acting import act  # noqa: PLC0415

    asked: list[tuple[Any, ...]] = []

    def decide(*args: Any) -> np.ndarray:
        asked[:] = [args]
        return _read_command(function(*args))

    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            return (act(loop, decide),)
    except _UnfitError as error:
        return error.misfit
    except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a learner's code raises
        return describe_error(error, function, _name_call(case, function, *asked))


def _read_command(output: object) -> np.ndarray:
    """Read two numbers, of whatever size; raise where they are none."""
    values = tuple(output) if isinstance(output, np.ndarray) and output.shape == (2,) else output
    found = split_answer(_COMMAND, values, ())
    if isinstance(found, Misfit):
        raise _UnfitError(found)
    assert isinstance(found, tuple)  # noqa: S101 - nothing is called here that could raise
    for part, value in zip(_COMMAND, found, strict=True):
        if value is None or value.shape:
            what = "None" if value is None else f"an array of shape {value.shape}"
            raise _UnfitError(Misfit(f"expected {part.name} as one number, yours is {what}"))
    return np.array(found, dtype=np.float64)


def _name_call(case: Case, function: Function, args: tuple[Any, ...]) -> Call:
    """Name the arguments of a call as the function itself names them."""
    try:
        arguments = inspect.signature(function).bind(*args).arguments
    except (TypeError, ValueError):  # written in C, or it takes others
        return Call(raises=case.raises)
    return Call(arguments, case.raises)


def _drawing(case: Case, function: Function) -> AbstractContextManager[None]:
    """Return the block in which a function may make renderers of its own."""
    if not any(isinstance(value, Scene) and "renderer" in value.gives for value in case.args):
        return nullcontext()
    from labutils.checks.scenes import drawing_by_rays  # noqa: PLC0415 - needs MuJoCo

    return drawing_by_rays(function)


def prepare_arguments(
    args: tuple[Any, ...],
) -> tuple[tuple[Any, ...], tuple[Callable[[], object], ...]]:
    """Copy the arguments; return them and what to look at after the call."""
    prepared: list[Any] = []
    observers: tuple[Callable[[], object], ...] = ()
    for value in args:
        if isinstance(value, Scene):
            # MuJoCo is imported here, because every other exercise runs without it.
            from labutils.checks.scenes import make_scene_arguments  # noqa: PLC0415

            made, observers = make_scene_arguments(value)
            prepared.extend(made)
        else:
            prepared.append(value.copy() if isinstance(value, np.ndarray) else value)
    return tuple(prepared), observers


def split_answer(parts: tuple[Part, ...], output: object, seen: tuple[object, ...]) -> Outcome:
    """Turn what came back into one array (or None) per part."""
    returned = len(parts) - len(seen)
    if returned == 1:
        values: tuple[object, ...] = (output,)
    elif isinstance(output, tuple | list) and len(output) == returned:
        values = tuple(output)
    else:
        wanted = ", ".join(part.name for part in parts[:returned])
        text = f"expected {returned} things ({wanted}), yours is {describe(output)}"
        return Misfit(text, is_empty=_is_empty(output))
    read: list[np.ndarray | None] = []
    for part, value in zip(parts, (*values, *seen), strict=True):
        found = None if value is None else _read_part(part, value)
        if isinstance(found, Misfit):
            return found if returned == 1 else Misfit(found.text)  # several things are not nothing
        read.append(found)
    return tuple(read)


def _is_empty(value: object) -> bool:
    return value is None or value is Ellipsis


def _read_part(part: Part, value: object) -> np.ndarray | Misfit:
    """Read one part; a list of whole numbers, or of nothing, takes the dtype that is due."""
    array = _to_array(value, with_texts=part.dtype == "str")
    if array is None:
        text = f"expected numbers, yours is {describe(value)}"
        return Misfit(text, is_empty=_is_empty(value))
    empty_shape = get_kind(part).empty_shape
    if empty_shape is not None and array.shape in ((0,), empty_shape):
        return np.zeros(empty_shape, dtype=part.dtype)
    if isinstance(value, tuple | list) and array.dtype.kind in "iu":
        if part.dtype == "float":
            return array.astype(np.float64)
        if part.dtype == "uint8" and ((array >= 0) & (array <= 255)).all():
            return array.astype(np.uint8)
    return array


def _to_array(value: object, *, with_texts: bool) -> np.ndarray | None:
    """Read numbers, tuples, lists and arrays as an array; return None where they are none."""
    try:
        array = np.array(value)
    except Exception:  # noqa: BLE001 - ragged lists, and whatever a learner's object raises
        return None
    return array if array.dtype.kind in ("biufU" if with_texts else "biuf") else None


def describe(value: object) -> str:
    """Name what came back, in words a learner uses."""
    if value is None:
        return "None"
    if value is Ellipsis:
        return "..."
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    if isinstance(value, tuple | list):
        return f"a {type(value).__name__} of {len(value)}"
    return f"a {type(value).__name__}"


def describe_error(error: BaseException, function: Function, call: Call | None = None) -> Raised:
    """Keep an exception as words: kind, first line, the learner's line, and what it means."""
    text = (str(error).strip().splitlines() or [""])[0]
    # The renderer of a check draws by rays; whoever wrote for MuJoCo's has not heard of that.
    text = text.replace("RaycastRenderer", "Renderer")
    if len(text) > _TEXT_LIMIT:
        text = text[: _TEXT_LIMIT - 3] + "..."
    kinds = tuple(kind.__name__ for kind in type(error).__mro__)
    code = getattr(inspect.unwrap(function), "__code__", None)
    advice = "" if code is None else explain(error, code.co_filename, call)
    return Raised(type(error).__name__, text, _find_learner_line(error, function), kinds, advice)


def _find_learner_line(error: BaseException, function: Function) -> str:
    """Return "line n: source" of the deepest line in the file or cell of the function."""
    code = getattr(inspect.unwrap(function), "__code__", None)
    if code is None:
        return ""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if frame.filename == code.co_filename]
    if not own or own[-1].lineno is None:
        return ""
    source = linecache.getline(own[-1].filename, own[-1].lineno).strip()[:_TEXT_LIMIT]
    return f"line {own[-1].lineno}: {source}" if source else f"line {own[-1].lineno}"


def find_call_problem(table: CheckTable, function: object) -> str:
    """Say why the function cannot be called with the arguments of the exercise, or ""."""
    if function is None:
        return f"Pass your function as well: check({table.name!r}, {table.name})."
    if not callable(function):
        return (
            f"check() needs the function itself, without parentheses; it got {describe(function)}."
        )
    try:
        signature = inspect.signature(function)
        signature.bind(*table.parameters)
    except ValueError:
        return ""  # written in C: it does not tell its arguments
    except TypeError as error:
        return f"It will be called as {table.signature}, but that does not fit yours: {error}."
    return _find_other_order(table, tuple(signature.parameters))


def _find_other_order(table: CheckTable, names: tuple[str, ...]) -> str:
    """Say that a parameter stands where another is due; who renames them all may."""
    places = zip(table.parameters, names, strict=False)
    if all(due == name or name not in table.parameters for due, name in places):
        return ""
    return (
        f"Its parameters stand in another order: it is called as {table.signature}, and yours is "
        f"{table.name}({', '.join(names)})."
    )
