"""Docstrings of the compiled module for its stub."""

from __future__ import annotations

import ast
import inspect
from types import ModuleType
from typing import Any

from docstrings import docstring


def stub(text: str, module: ModuleType) -> str:
    """The text of `_native.pyi` with the docstrings of the compiled module."""
    lines = text.split("\n")
    places = [(node, owner) for owner, node in definitions(ast.parse(text))]
    # From the end, so that lines before keep their numbers.
    for node, owner in sorted(places, key=lambda place: -place[0].lineno):
        thing = getattr(getattr(module, owner) if owner else module, node.name, None)
        told = inspect.getdoc(thing) if thing is not None and not node.name.startswith("__") else None
        set_docstring(lines, node, told)
    return "\n".join(lines)


def definitions(tree: ast.Module) -> Any:
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield None, node
            yield from ((node.name, one) for one in node.body if isinstance(one, ast.FunctionDef))
        elif isinstance(node, ast.FunctionDef):
            yield None, node


def set_docstring(lines: list[str], node: ast.ClassDef | ast.FunctionDef, told: str | None) -> None:
    """Replaces the docstring of a definition; that of a function is all of its body."""
    first = node.body[0]
    has_one = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant) and isinstance(first.value.value, str)
    indent = node.col_offset + 4
    new = docstring(told.replace("\\", "\\\\"), indent).rstrip("\n").split("\n") if told else []
    if isinstance(node, ast.ClassDef):
        end = first.end_lineno if has_one else first.lineno - 1 - len(getattr(first, "decorator_list", []))
        lines[node.lineno : end] = new
        return
    start, end = first.lineno - 1, first.end_lineno
    if has_one:
        lines[start - 1] += "" if new else " ..."
        lines[start:end] = new
    elif new:
        head = lines[start][: first.col_offset].rstrip()
        lines[start:end] = [head, *new]
