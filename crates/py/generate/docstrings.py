"""Docstrings as text."""

from __future__ import annotations

import textwrap

WIDTH = 116


def described(name: str, parts: list[str]) -> str:
    text = " ".join(part for part in parts if part) or "See the command line."
    return textwrap.fill(f"{name}: {text}", WIDTH - 4, initial_indent="    ", subsequent_indent="        ", break_long_words=False, break_on_hyphens=False)


def docstring(text: str, indent: int) -> str:
    """A docstring, with lines of a single paragraph filled."""
    space = " " * indent
    first, _, rest = text.partition("\n")
    lines = textwrap.wrap(first, WIDTH - indent - 3, break_long_words=False, break_on_hyphens=False) or [""]
    lines += rest.split("\n") if rest else []
    if len(lines) == 1 and len(lines[0]) + indent + 6 <= WIDTH:
        return f'{space}"""{lines[0]}"""\n'
    body = "".join(f"{space}{line}".rstrip() + "\n" for line in lines[1:])
    return f'{space}"""{lines[0]}\n{body}{space}"""\n'
