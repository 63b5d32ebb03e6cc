"""Entries of a problem file, as a mapping with its keys."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from ._table import PathLike
from .errors import InputError

#: Points of a line or a polygon, (x, y) in m each.
Points = Union[Sequence[Sequence[float]], NDArray[Any]]

_Self = TypeVar("_Self", bound="Entries")


def _plain(value: Any) -> Any:
    """A value as JSON has it, and a copy: what is changed later does not change a problem."""
    if isinstance(value, Mapping):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(one) for one in value]
    return value


class Entries(Mapping[str, Any]):
    """What a problem file has by its keys. ``soilctl.solve`` takes it as it is."""

    def __init__(self, single: Mapping[str, Any]) -> None:
        self._all: dict[str, Any] = {key: _plain(value) for key, value in single.items() if value is not None}

    def __getitem__(self, key: str) -> Any:
        return copy.deepcopy(self._all[key])

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __repr__(self) -> str:
        counts = [f"{len(entries)} {key}" for key, entries in self._all.items() if isinstance(entries, list)]
        title = self._all.get("title")
        return f"<{type(self).__name__}{'' if title is None else f' {title!r}'}: {', '.join(counts) or 'empty'}>"

    def to_json(self) -> str:
        """The problem file as JSON."""
        return json.dumps(self._all, indent=2) + "\n"

    def write(self, path: PathLike) -> None:
        """Writes the problem file, for the command line and the functions of ``soilctl.use_cases``.

        Args:
            path: Where to; its name ends with .json.

        Raises:
            InputError: If it does not.
            OSError: If the file cannot be written.
        """
        if Path(path).suffix != ".json":
            raise InputError(f"{path}: a problem is written as JSON; give a name that ends with .json")
        Path(path).write_text(self.to_json(), encoding="utf-8")

    def _with(self: _Self, key: str, value: Any) -> _Self:
        other = copy.copy(self)
        other._all = {**self._all, key: value}
        return other

    def _set(self: _Self, key: str, entry: Mapping[str, Any]) -> _Self:
        return self._with(key, {name: _plain(value) for name, value in entry.items() if value is not None})

    def _add(self: _Self, key: str, entry: Mapping[str, Any]) -> _Self:
        plain = {name: _plain(value) for name, value in entry.items() if value is not None}
        return self._with(key, [*self._all.get(key, []), plain])
