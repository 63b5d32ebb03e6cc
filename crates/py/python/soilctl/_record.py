"""Answers with attributes, which can be read as mappings, too."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import Field, dataclass, fields
from functools import cache
from html import escape
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

#: Most characters of a value in a notebook.
_SHOWN = 200

_Record = TypeVar("_Record", bound="Record")


class Record(Mapping[str, Any]):
    """A part of an answer: ``part.key`` and ``part["key"]`` are the same."""

    def __getitem__(self, key: str) -> Any:
        try:
            return getattr(self, _fields(type(self))[key].name)
        except KeyError:
            raise KeyError(key) from None

    def __iter__(self) -> Iterator[str]:
        return iter(_fields(type(self)))

    def __len__(self) -> int:
        return len(_fields(type(self)))

    def __repr__(self) -> str:
        values = ", ".join(f"{key}={value!r}" for key, value in self.items())
        return f"{type(self).__name__}({values})"

    def to_dict(self) -> dict[str, Any]:
        """Everything as dicts, lists, numbers and texts."""
        return {key: _plain(value) for key, value in self.items()}

    def _repr_html_(self) -> str:
        return table(self)


@dataclass(frozen=True, repr=False, eq=False)
class Answer(Record):
    """The answer of a use case."""

    exit_code: int
    """0 done, 1 done and the answer is negative, 3 done in part."""


def _key(field: Field[Any]) -> str:
    """The key in JSON, where words may be names that Python or mappings keep for themselves."""
    return str(field.metadata.get("key", field.name))


def _fields_of(kind: type[Any]) -> dict[str, Field[Any]]:
    """Fields by key; the exit code comes last."""
    ordered = sorted(fields(kind), key=lambda field: field.name == "exit_code")
    return {_key(field): field for field in ordered}


_fields = cache(_fields_of)
_hints = cache(get_type_hints)


def of_json(kind: type[_Record], found: Mapping[str, Any]) -> _Record:
    """The record that a JSON object is. Keys that it does not have are left out, so that they have their defaults."""
    hints = _hints(kind)
    known = _fields(kind)
    return kind(**{known[key].name: _value(hints[known[key].name], value) for key, value in found.items() if key in known})


def _value(hint: Any, value: Any) -> Any:
    """A value with records in place of objects."""
    if not isinstance(value, (dict, list)):
        return value
    origin, args = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        kinds = [one for one in args if one is not NoneType]
        # Of several forms the one that knows most of the keys.
        return _value(max(kinds, key=lambda one: _likeness(one, value)), value)
    if isinstance(value, list):
        return [_value(args[0] if args else Any, one) for one in value]
    if isinstance(hint, type) and issubclass(hint, Record):
        return of_json(hint, value)
    return {key: _value(args[1] if origin is dict else Any, one) for key, one in value.items()}


def _likeness(kind: Any, value: Any) -> int:
    if isinstance(value, list):
        (inner,) = get_args(kind) or (Any,)
        return max((_likeness(inner, one) for one in value), default=0) if get_origin(kind) is list else -1
    if isinstance(kind, type) and issubclass(kind, Record):
        return len(set(value) & set(_fields(kind))) - len(set(value) ^ set(_fields(kind)))
    return -1


def _plain(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, list):
        return [_plain(one) for one in value]
    return {key: _plain(one) for key, one in value.items()} if isinstance(value, dict) else value


def table(answer: Mapping[str, Any]) -> str:
    """An answer as an HTML table for a notebook, with links to the pages that were written."""
    rows = "".join(f"<tr><th>{escape(str(key))}</th><td>{_shown(value)}</td></tr>" for key, value in answer.items())
    return f"<table>{rows}</table>"


def _shown(value: object) -> str:
    if isinstance(value, list) and value and all(isinstance(part, str) for part in value):
        return "<br>".join(map(_shown, value))
    if isinstance(value, str) and value.endswith(".html"):
        return f'<a href="{escape(value)}">{escape(value)}</a>'
    text = value if isinstance(value, str) else json.dumps(_plain(value), ensure_ascii=False, default=str)
    return escape(text if len(text) <= _SHOWN else text[:_SHOWN] + " ...")
