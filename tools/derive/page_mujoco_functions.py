"""How functions and named views of MuJoCo are called: read from the Python package.

A parameter is written as one short text: ``geomid:i4[1,1]w?`` is an array of int32 of one number
that the function writes (w), and that may be None (?).
"""

from __future__ import annotations

import re
from typing import Any

import mujoco
import numpy as np
from mujoco.introspect import ast_nodes, functions

#: Families of functions that pages may call. ``mjr_`` draws with OpenGL, ``mjs_`` is behind MjSpec.
FAMILIES = re.compile(r"(?:mj|mju|mjv|mjd)_\w+")
#: They read or write files, which the engine of the page cannot reach, or change what it prints.
LEFT_OUT = re.compile(
    r"mj_(?:print|save|load)\w+|mju_(?:print|write|message|setLog|getLog|thread)\w*"
)
#: Called by hand in the page's package: they take more than one call, or have to be fast.
BY_HAND = ("mj_step", "mj_ray", "mj_multiRay", "mj_saveModel", "mj_copyData", "mj_name2id")
#: The page's engine wants the sizes of their arrays besides.
WITH_SIZES = (
    "mju_L1",
    "mju_isZero",
    "mju_mulMatMat",
    "mju_mulMatMatT",
    "mju_mulMatTMat",
    "mju_mulMatTVec",
    "mju_mulMatVec",
    "mju_norm",
    "mju_normalize",
    "mju_sqrMatTD",
    "mju_sum",
    "mju_symmetrize",
    "mju_transpose",
    "mju_zero",
)

_ARRAY = re.compile(
    r"typing\.Annotated\[numpy\.typing\.NDArray\[numpy\.(\w+)\], \"\[([^\]]*)\]\"([^\]]*)\]"
)
_NUMBER = "typing.SupportsInt | typing.SupportsIndex"
_FLOAT = "typing.SupportsFloat | typing.SupportsIndex"
_DTYPES = {
    "float64": "f8",
    "float32": "f4",
    "int32": "i4",
    "int64": "i8",
    "uint8": "u1",
    "bool": "?",
}

#: Name of the accessor to: struct of the views, prefix of its fields in the model.
VIEWS = {
    "actuator": ("Actuator", "actuator"),
    "body": ("Body", "body"),
    "camera": ("Camera", "cam"),
    "equality": ("Equality", "eq"),
    "exclude": ("Exclude", "exclude"),
    "geom": ("Geom", "geom"),
    "hfield": ("Hfield", "hfield"),
    "joint": ("Joint", "jnt"),
    "key": ("Keyframe", "key"),
    "light": ("Light", "light"),
    "material": ("Material", "mat"),
    "mesh": ("Mesh", "mesh"),
    "numeric": ("Numeric", "numeric"),
    "pair": ("Pair", "pair"),
    "sensor": ("Sensor", "sensor"),
    "site": ("Site", "site"),
    "skin": ("Skin", "skin"),
    "tendon": ("Tendon", "tendon"),
    "texture": ("Texture", "tex"),
    "tuple": ("Tuple", "tuple"),
}

#: What else the names of arrays begin with, in models and in states.
OTHER_PREFIXES = {
    "actuator": ("",),
    "body": ("",),
    "jnt": ("dof_", ""),
    "sensor": ("sensor",),
    "tendon": ("ten_",),
}

#: A joint has arrays of its own and of its degrees of freedom, some by the same names.
PROBE = """<mujoco><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>"""


def derive_functions(declarations: str) -> dict[str, str]:
    """Return the signature of every function that both sides have in the same form."""
    theirs = read_declarations(declarations)
    found = {}
    for name in sorted(vars(mujoco)):
        if not FAMILIES.fullmatch(name) or (LEFT_OUT.match(name) and name not in BY_HAND):
            continue
        signature = shorten(getattr(mujoco, name).__doc__ or "")
        count = len(signature.partition(" -> ")[0].split())
        is_known = name in BY_HAND or (name in WITH_SIZES and theirs.get(name, 0) > count)
        if signature and (is_known or theirs.get(name) == count):
            found[name] = signature
    return found


def read_declarations(declarations: str) -> dict[str, int]:
    """Return the number of parameters of every function of the page's engine."""
    return {
        name: len(re.findall(r"_\d+: ", parameters))
        for name, parameters in re.findall(
            r"^  (mj[uvd]?_\w+)\(([^)]*)\):", declarations, re.MULTILINE
        )
    }


def shorten(text: str) -> str:
    """Write the signature that the package documents in short; empty where it is no single one."""
    found = re.match(r"\w+\((.*)\) -> (.+)$", text, re.MULTILINE)
    if not found or "Overloaded function" in text:
        return ""
    parameters = _ARRAY.sub(_shorten_array, found[1])
    for long, short in ((_NUMBER, "int"), (_FLOAT, "float"), ("mujoco._structs.", "")):
        parameters = parameters.replace(long, short)
    parameters = parameters.replace(" | None", "?").replace(" = ", "=")
    parameters = re.sub(r": ", ":", parameters).replace(", ", " ")
    return f"{parameters} -> {found[2].replace('mujoco._structs.', '')}"


def _shorten_array(found: re.Match[str]) -> str:
    sizes = found[2].replace(" ", "")
    return f"{_DTYPES[found[1]]}[{sizes}]" + ("w" if "writeable" in found[3] else "")


def list_model_writers() -> list[str]:
    """List the functions that change a model; all others leave it as it is."""
    found = []
    for name, function in functions.FUNCTIONS.items():
        for parameter in function.parameters:
            kind = parameter.type
            if isinstance(kind, ast_nodes.PointerType):
                inner = kind.inner_type
                is_model = getattr(inner, "name", "") == "mjModel"
                if is_model and not getattr(inner, "is_const", True):
                    found.append(name)
    return sorted(set(found))


def derive_views(fields: dict[str, dict[str, str]]) -> dict[str, dict[str, dict[str, str]]]:
    """Return where the attributes of named views come from: {owner: {kind: {attribute: field}}}."""
    table: dict[str, dict[str, dict[str, str]]] = {}
    for owner in ("MjModel", "MjData"):
        table[owner] = {}
        for kind, (title, prefix) in VIEWS.items():
            views = getattr(mujoco._structs, f"_{owner}{title}Views", None)  # noqa: SLF001
            if views is None:
                continue
            names = [name for name in dir(views) if not name.startswith("_")]
            found = {name: _list_fields(name, prefix, fields[owner]) for name in names}
            table[owner][kind] = {
                name: _choose(owner, kind, name, fields) for name, fields in found.items() if fields
            }
    return table


def _list_fields(attribute: str, prefix: str, fields: dict[str, str]) -> list[str]:
    """List the arrays that an attribute of a view may be a part of, by their names."""
    prefixes = [f"{prefix}_", *OTHER_PREFIXES.get(prefix, ())]
    return [found for one in prefixes if (found := one + attribute) in fields]


def _choose(owner: str, kind: str, attribute: str, fields: list[str]) -> str:
    """Choose the array that an attribute really is a part of, where its name leaves a choice."""
    if len(fields) == 1:
        return fields[0]
    probe: Any = mujoco.MjModel.from_xml_string(PROBE)
    if owner == "MjData":
        probe = mujoco.MjData(probe)
    part = getattr(getattr(probe, kind)(0), attribute)
    return next(one for one in fields if np.shares_memory(part, getattr(probe, one)))
