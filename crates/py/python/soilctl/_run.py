"""Runs use cases: keyword arguments become a request, and its answer an object."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import numpy as np

from ._native import run_use_case
from ._progress import callback
from ._record import Answer, of_json
from ._table import PathLike, to_csv
from .errors import InputError, InputTypeError

_Answer = TypeVar("_Answer", bound=Answer)


def run(
    name: str,
    function: Callable[..., _Answer],
    arguments: Mapping[str, Any],
    kind: type[_Answer],
    tables: tuple[str, ...] = (),
    page: PathLike | None = None,
) -> _Answer:
    """Runs a use case for the function of it. ``tables`` are the arguments that may be columns in memory; ``page``, which no request
    has, is a page to write."""
    # What is not given is left out, since it may exclude something else that is.
    defaults: dict[str, Any] = getattr(function, "__kwdefaults__", {})
    request = {}
    for key, value in arguments.items():
        if key == "progress" or value is None or (key in defaults and value is defaults[key]):
            continue
        if key in tables and not isinstance(value, (str, os.PathLike)):
            request[key] = {"csv": to_csv(key, value)}
        else:
            request[key] = _plain(key, value)
    with callback(arguments["progress"], "steps") as report:
        exit_code, answer = run_use_case(name, json.dumps(request), report, page)
    return of_json(kind, {**json.loads(answer), "exit_code": exit_code})


def _plain(key: str, value: Any) -> Any:
    """A value as JSON has it."""
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError(f"{key} is {value}; it must be a finite number")
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, (list, tuple)):
        return [_plain(key, one) for one in value]
    raise InputTypeError(f"{key} is of type {type(value).__name__}; it must be a number, a text, a path or several of one kind")
