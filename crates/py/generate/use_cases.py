"""Types and functions of the use cases, from their JSON schemas."""

from __future__ import annotations

import json
import keyword
import re
from collections.abc import Mapping
from typing import Any

from docstrings import described, docstring

HEAD = '''"""Every use case as a function: its request as keyword arguments, its answer as an object with attributes.

Arguments and attributes have their units in their names. An answer can also be read as a mapping, ``answer["key"]``, with the keys of
the JSON answer of the command line.
"""

# Made by crates/py/generate from the schemas of the use cases.

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypedDict

from ._progress import Progress
from ._record import Answer, Record
from ._run import run
from ._table import PathLike, Table
'''
#: Use cases whose keyword arguments another function of the package hands on, with those that it takes itself.
FORWARDED = {"process": ("out", "shard")}
RAISES = {
    "InputError": "If a value makes no sense, is missing or outside its range; the message names it.",
    "FileError": "If a file cannot be read or written.",
}


def use_cases(schemas: list[tuple[str, str, str, str]]) -> str:
    """The text of `use_cases.py`."""
    records: dict[str, str] = {}
    functions, names = [], []
    users: dict[str, list[str]] = {}
    for name, answer_id, _, _ in schemas:
        users.setdefault(answer_id, []).append(f"``{function_name(name)}``")
    for name, answer_id, request, answer in schemas:
        prefix = camel(answer_id.removeprefix("soilctl.").partition("/")[0])
        kind = f"{prefix}Answer"
        # Several use cases may have the same form of answer.
        if kind not in records:
            summary = f"The answer of {', '.join(users[answer_id])}."
            records |= answer_records(prefix, {**json.loads(answer), "description": summary})
        functions.append(function(name, json.loads(request), kind))
        names.append(function_name(name))
        if name in FORWARDED:
            arguments = f"{prefix}Arguments"
            functions.append(keywords(arguments, name, json.loads(request), FORWARDED[name]))
            names.append(arguments)
    listed = "".join(f'    "{name}",\n' for name in sorted([*records, *names]))
    return "\n".join([HEAD, f"__all__ = [\n{listed}]\n", *records.values(), *functions])


def function_name(name: str) -> str:
    return name.replace(" ", "_").replace("-", "_")


def camel(words: str) -> str:
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[-_ ]", words))


def answer_records(prefix: str, schema: dict[str, Any]) -> dict[str, str]:
    """Classes of an answer and of all records in it, by name."""
    definitions = schema.get("$defs", {})
    enums = {name: one for name, one in definitions.items() if "oneOf" in one or "enum" in one}
    scope = Scope(prefix, enums)
    found = {}
    for name, one in definitions.items():
        if name not in enums:
            found[scope.record(name)] = record(scope.record(name), "Record", one, scope)
    whole = united(schema, definitions)
    whole["properties"] = dict(sorted(whole["properties"].items(), key=lambda pair: pair[0] not in ("schema", "version")))
    found[f"{prefix}Answer"] = record(f"{prefix}Answer", "Answer", whole, scope)
    return found


def united(schema: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """An answer of several forms as one, in which what is not in all forms may be missing."""
    forms = []
    for form in schema.get("oneOf", []):
        of = definitions[form["$ref"].rsplit("/", 1)[-1]] if "$ref" in form else {}
        own = {**of.get("properties", {}), **form.get("properties", {})}
        forms.append({"properties": own, "required": [*of.get("required", []), *form.get("required", [])]})
    properties: dict[str, Any] = dict(schema.get("properties", {}))
    required = list(schema.get("required", []))
    for key in {key: None for form in forms for key in form["properties"]}:
        kinds = [form["properties"][key] for form in forms if key in form["properties"]]
        unique = [one for index, one in enumerate(kinds) if not any(same_type(one, other) for other in kinds[:index])]
        described = {"description": kinds[0].get("description", "")}
        properties[key] = kinds[0] if len(unique) == 1 else {"anyOf": unique, **described}
        if all(key in form.get("required", []) for form in forms):
            required.append(key)
    return {**schema, "properties": properties, "required": required}


def same_type(one: dict[str, Any], other: dict[str, Any]) -> bool:
    return {**one, "description": ""} == {**other, "description": ""}


class Scope:
    """Names of the records and enums of one answer."""

    def __init__(self, prefix: str, enums: dict[str, Any]) -> None:
        self.prefix = prefix
        self.enums = enums

    def record(self, name: str) -> str:
        return self.prefix + name.removeprefix(self.prefix).removesuffix("Answer")

    def type(self, schema: dict[str, Any]) -> str:
        """The Python type of values of a schema."""
        if "$ref" in schema:
            name = schema["$ref"].rsplit("/", 1)[-1]
            return self.type(self.enums[name]) if name in self.enums else self.record(name)
        for key in ("anyOf", "oneOf"):
            if key in schema:
                return union(self.type(one) for one in schema[key])
        if "const" in schema:
            return f"Literal[{json.dumps(schema['const'])}]"
        if "enum" in schema:
            return f"Literal[{', '.join(map(json.dumps, schema['enum']))}]"
        kinds = schema.get("type", "any")
        return union(self.plain(kind, schema) for kind in (kinds if isinstance(kinds, list) else [kinds]))

    def plain(self, kind: str, schema: dict[str, Any]) -> str:
        if kind == "array":
            return f"list[{self.type(schema.get('items', {}))}]"
        if kind == "object" and isinstance(schema.get("additionalProperties"), dict):
            return f"dict[str, {self.type(schema['additionalProperties'])}]"
        names = {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None", "object": "dict[str, Any]"}
        return names.get(kind, "Any")


def union(kinds: Any) -> str:
    # A union of unions is one; a bar within brackets is of what is inside.
    unique = list(dict.fromkeys(part for kind in kinds for part in re.split(r" \| (?![^\[]*\])", kind)))
    literals = [kind.removeprefix("Literal[").removesuffix("]") for kind in unique if kind.startswith("Literal[")]
    others = [kind for kind in unique if not kind.startswith("Literal[")]
    joined = ([f"Literal[{', '.join(literals)}]"] if literals else []) + sorted(others, key="None".__eq__)
    return " | ".join(joined)


def attribute_of(key: str) -> str:
    """The name of a key as an attribute: words of Python, and what every mapping has, get an underscore."""
    return key + "_" if keyword.iskeyword(key) or hasattr(Mapping, key) else key


def record(name: str, base: str, schema: dict[str, Any], scope: Scope) -> str:
    """A class of an answer."""
    required = schema.get("required", [])
    # Those with defaults follow those without.
    properties = sorted(schema.get("properties", {}).items(), key=lambda pair: pair[0] not in required)
    lines = []
    for key, about in properties:
        kind = scope.type(about)
        default = ""
        if key not in required:
            kind, default = union([kind, "None"]), " = None"
        attribute = attribute_of(key)
        if attribute != key:
            metadata = f'metadata={{"key": {json.dumps(key)}}}'
            default = f" = field(default=None, {metadata})" if default else f" = field({metadata})"
        lines.append(f"    {attribute}: {kind}{default}\n" + docstring(sentences(about) or "See its type.", 4))
    told = [described(attribute_of(key), [sentences(about) or "See its type."]) for key, about in properties]
    summary = "\n".join([sentences(schema) or "Part of an answer.", "\nAttributes:", *told])
    return f"\n@dataclass(frozen=True, repr=False, eq=False)\nclass {name}({base}):\n{docstring(summary, 4)}\n" + "".join(lines)


def function(name: str, schema: dict[str, Any], answer: str) -> str:
    """A function that runs a use case."""
    scope = Scope("", {key: one for key, one in schema.get("$defs", {}).items()})
    required = schema.get("required", [])
    # A request that asks for nothing has none.
    properties = schema.get("properties", {})
    first = [(key, properties[key]) for key in required]
    others = [(key, properties[key]) for key in schema.get("propertyOrder", []) if key not in required]
    others.sort(key=lambda pair: not pair[1].get("positional", False))
    names = list(properties)
    head, told, tables = [], [], []
    for key, about in first + others:
        kind, is_table = parameter_type(about, scope)
        tables += [key] * is_table
        default = "" if key in required else f" = {default_of(about)}"
        if default == " = None":
            kind = union([kind, "None"])
        head.append(f"    {key}: {kind}{default},\n")
        told.append(described(key, [in_python(sentences(about), names), limits(about)]))
    # What used to be required stays positional when it has a default.
    at = len(required) + sum(1 for _, about in others if about.get("positional"))
    signature = "".join([*head[:at], "    *,\n", *head[at:], "    progress: Progress = None,\n"])
    told.append(described("progress", ["Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm."]))
    text = in_python(sentences(schema), names) + "\n\nArgs:\n" + "\n".join(told)
    text += f"\n\nReturns:\n    The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part."
    text += "\n\nRaises:\n" + "\n".join(described(kind, [when]) for kind, when in RAISES.items())
    listed = "".join(f"{json.dumps(key)}, " for key in tables).rstrip()
    called = function_name(name)
    given = f"run({json.dumps(name)}, {called}, locals(), {answer}" + (f", tables=({listed}))" if tables else ")")
    return f"\ndef {called}(\n{signature}) -> {answer}:\n{docstring(text, 4)}    return {given}\n"


def keywords(kind: str, name: str, schema: dict[str, Any], without: tuple[str, ...]) -> str:
    """The keyword arguments of a use case as a type, but for some."""
    scope = Scope("", dict(schema.get("$defs", {})))
    lines = []
    for key, about in schema["properties"].items():
        if key not in (*schema.get("required", []), *without):
            lines.append(f"    {key}: {union([parameter_type(about, scope)[0], 'None'])}\n")
    told = docstring(f"Keyword arguments of :func:`{function_name(name)}`, which tells what they mean.", 4)
    return f"\nclass {kind}(TypedDict, total=False):\n{told}\n" + "".join(lines)


def parameter_type(about: dict[str, Any], scope: Scope) -> tuple[str, bool]:
    """The type of an argument, and whether it may be a table in memory."""
    if is_table(about):
        return "Table", True
    kind = scope.type(about).replace("list[", "Sequence[")
    return (kind.replace("str", "PathLike") if about.get("format") == "path" else kind), False


def is_table(about: dict[str, Any]) -> bool:
    return "csv" in about.get("properties", {}) or any(map(is_table, about.get("anyOf", [])))


def default_of(about: dict[str, Any]) -> str:
    default = about.get("default")
    if isinstance(default, list):
        return repr(tuple(default))
    return json.dumps(default) if isinstance(default, str) else repr(default)


def limits(about: dict[str, Any]) -> str:
    """The range of a number in words, unless its description tells it."""
    of = about.get("items", about)
    words = {"minimum": "at least", "exclusiveMinimum": "above", "maximum": "at most", "exclusiveMaximum": "below"}
    ends = [f"{word} {of[end]:g}" for end, word in words.items() if end in of]
    sentence = " and ".join(ends)
    return f"{sentence[:1].upper()}{sentence[1:]}." if sentence else ""


def sentences(about: dict[str, Any]) -> str:
    """A description as sentences."""
    text = " ".join(about.get("description", "").split())
    text = re.sub(r" ?\[default: [^]]*\]", "", text)
    text = re.sub(r"(?<!`)`([^`]+)`(?!`)", r"``\1``", text).replace("\\", "\\\\")
    return text if not text or text.endswith((".", "!", "?")) else text + "."


def in_python(text: str, names: list[str]) -> str:
    """A description with arguments in place of options of the command line."""
    text = re.sub(r" \(may be repeated(, or a list with commas)?\)|; may be repeated, or a list with commas|; a list with commas", "", text)

    def named(option: re.Match[str]) -> str:
        word = option[1].replace("-", "_")
        fitting = [name for name in names if re.fullmatch(rf"{word}(_(deg|m|m2|n|pa|hz|s|kg_m3|m_s2))?", name)]
        return f"``{fitting[0]}``" if fitting else option[0]

    return re.sub(r"--([a-z][a-z-]*)", named, text)
