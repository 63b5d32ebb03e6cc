"""Units and long names of variables, from their names."""

from __future__ import annotations

import re

#: Units at the ends of names, longer ones first.
_ENDINGS = {
    "_kg_m3": "kg/m3",
    "_m_s2": "m/s2",
    "_rad_s": "rad/s",
    "_deg": "deg",
    "_rad": "rad",
    "_pa": "Pa",
    "_nm": "N m",
    "_kg": "kg",
    "_mps": "m/s",
    "_m2": "m2",
    "_m": "m",
    "_n": "N",
    "_s": "s",
    "_a": "A",
    "_v": "V",
    "_j": "J",
}

#: Names that have no unit at their end, but one of their own.
_PARTS = {
    "position": "rad",
    "velocity": "rad/s",
    "effort": "N m",
    "force_x": "N",
    "force_y": "N",
    "force_z": "N",
    "torque_x": "N m",
    "torque_y": "N m",
    "torque_z": "N m",
    "wrench": "N, N, N, N m, N m, N m",
    "pose": "m, m, m, rad, rad",
    "counts": "count",
}

#: What a name alone does not tell.
_LONG = {
    "coefficient": "net coefficient per slant length",
    "lower": "lower end of the bracket on the net coefficient",
    "upper": "upper end of the bracket on the net coefficient",
    "interpolation_margin": "relative error that interpolation may make",
    "force_n": "failure force",
    "force_lower_n": "lower end of the bracket on the failure force",
    "force_upper_n": "upper end of the bracket on the failure force",
}


def attributes(name: str) -> dict[str, str]:
    """``units`` and ``long_name`` of a variable; the unit of a pure number is 1."""
    ending = next((ending for ending in _ENDINGS if name.endswith(ending)), "")
    part = next((part for part in _PARTS if re.search(rf"(^|_|\.){part}$", name)), "")
    units = _ENDINGS[ending] if ending else _PARTS.get(part, "1")
    long = _LONG.get(name) or name.removesuffix(ending).replace("_", " ").replace(".", " ").strip("/ ")
    return {"units": units, "long_name": long}
