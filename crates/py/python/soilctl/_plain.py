"""JSON of whatever stands for numbers, lists and dicts."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from .errors import InputTypeError


def dumps(value: Any) -> str:
    """The JSON of a value whose numbers, arrays and mappings may be numpy's or others'."""
    return json.dumps(value, default=_plain)


def _plain(value: Any) -> Any:
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    raise InputTypeError(
        f"{value!r} is of type {type(value).__name__}; a description is made of numbers, texts, lists and mappings"
    )
