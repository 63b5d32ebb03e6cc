"""Tables in memory: columns by name, such as a DataFrame of pandas or polars, or a dict of arrays."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Protocol

import numpy as np

from .errors import InputError, InputTypeError


class Columns(Protocol):
    """A table with columns by name, such as ``pandas.DataFrame``."""

    @property
    def columns(self) -> Iterable[Any]:
        """Names of the columns."""

    def __getitem__(self, name: Any, /) -> Any:
        """The values of a column."""


PathLike = str | os.PathLike[str]

#: A table in memory.
TableInMemory = Columns | Mapping[str, Iterable[Any]]

#: The path of a table, or the table itself.
Table = PathLike | TableInMemory


def is_table(value: object) -> bool:
    """Whether a value is a table in memory, rather than the path of one."""
    return isinstance(value, Mapping) or hasattr(value, "columns")


def columns(table: Any) -> dict[str, list[Any]]:
    """The columns of a table as lists."""
    names: Iterator[Any] = iter(table if isinstance(table, Mapping) else table.columns)
    return {str(name): np.ma.atleast_1d(np.ma.asarray(table[name])).tolist() for name in names}


def to_csv(what: str, table: Any) -> str:
    """The text of a table as a file would have it. What is missing, also a number that is none, is an empty cell.

    Raises:
        InputError: If columns differ in length.
        InputTypeError: If it has no columns by name.
    """
    if not is_table(table):
        raise InputTypeError(f"{what} is of type {type(table).__name__}; it must be a path or columns by name")
    found = columns(table)
    lengths = {name: len(column) for name, column in found.items()}
    if len(set(lengths.values())) > 1:
        raise InputError(f"columns of {what} differ in length: {lengths}")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(found)
    writer.writerows([_cell(value) for value in row] for row in zip(*found.values(), strict=True))
    return text.getvalue()


def _cell(value: Any) -> Any:
    # Only what is no number is not equal to itself; that of pandas says nothing to the question.
    missing = value is None or type(value).__name__ == "NAType" or value != value
    return "" if missing else value


def like(table: Any, found: Mapping[str, Any]) -> Any:
    """Columns in a table of the same kind as another one, with its index."""
    if isinstance(table, Mapping):
        return dict(found)
    if hasattr(table, "iloc"):
        return type(table)(found, index=table.index)
    return type(table)(found)
