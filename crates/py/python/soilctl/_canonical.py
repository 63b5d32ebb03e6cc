"""One text for one value: JSON whose bytes depend on nothing but the value."""

from __future__ import annotations

import base64
import json
import math
from typing import Any

import numpy as np

from .errors import InputError, InputTypeError

_ARRAY = "__ndarray__"


def encode(value: Any, what: str) -> bytes:
    """The JSON of a value: keys sorted, shortest floats, arrays in base64. ``what`` names it in messages."""
    plain = _plain(value, what)
    text = json.dumps(plain, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    return text.encode("utf-8")


def decode(data: bytes | str) -> Any:
    """The value of :func:`encode`; tuples come back as lists, numpy scalars as numbers."""
    return json.loads(data, object_hook=_revive)


def _plain(value: Any, place: str) -> Any:
    if hasattr(value, "to_dict") and not isinstance(value, (dict, type)):
        value = value.to_dict()
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            raise InputError(f"{place} is {value}; only finite numbers are stored")
        return value
    if isinstance(value, np.ndarray):
        return _array(value, place)
    if isinstance(value, (list, tuple)):
        return [_plain(item, f"{place}[{index}]") for index, item in enumerate(value)]
    if isinstance(value, dict):
        return {_key(key, place): _plain(item, f"{place}[{key!r}]") for key, item in value.items()}
    raise InputTypeError(
        f"{place} is of type {type(value).__name__}, which has no canonical form; use numbers, text, lists, dicts "
        "with text keys, numpy arrays, or an object with to_dict()"
    )


def _key(key: Any, place: str) -> str:
    if not isinstance(key, str):
        raise InputTypeError(f"{place} has the key {key!r}; keys must be text")
    if key == _ARRAY:
        raise InputError(f"{place} has the key {_ARRAY!r}, which marks arrays; choose another")
    return key


def _array(array: np.ndarray, place: str) -> dict[str, Any]:
    if np.ma.is_masked(array):
        raise InputError(f"{place} has masked elements, which have no value; leave them out or fill them")
    if array.dtype.kind not in "biuf":
        raise InputTypeError(f"{place} is an array of {array.dtype}; only real numbers and booleans are stored")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise InputError(f"{place} holds numbers that are not finite; only finite ones are stored")
    little = np.ascontiguousarray(array, dtype=array.dtype.newbyteorder("<"))
    data = base64.b64encode(little.tobytes()).decode("ascii")
    return {_ARRAY: {"data": data, "dtype": little.dtype.str, "shape": list(array.shape)}}


def _revive(found: dict[str, Any]) -> Any:
    if set(found) != {_ARRAY}:
        return found
    parts = found[_ARRAY]
    flat = np.frombuffer(base64.b64decode(parts["data"]), dtype=np.dtype(parts["dtype"]))
    return flat.reshape(parts["shape"]).copy()
