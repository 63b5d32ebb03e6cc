"""The builder of problem files, from their JSON schema."""

from __future__ import annotations

import json
import keyword
import re
from typing import Any

from docstrings import described, docstring
from use_cases import Scope, default_of, sentences

HEAD = '''"""Problem files from Python: each call adds an entry, with its units in the names of its arguments.

    from soilctl.problem import Problem

    cut = (
        Problem("cut in clay", default_boundary="fixed")
        .soil("clay", phi_deg=0, unit_weight_kn_m3=18, cohesion_kpa=20)
        .region("clay", [[-9, 3], [-9, -4], [6, -4], [6, 0], [0, 0], [0, 3]])
        .boundary("free", line=[[-9, 3], [0, 3], [0, 0], [6, 0]])
        .objective_strength_reduction()
    )
    soilctl.solve(cut)

The keys are those of problem files, which docs/problem-file.md explains. A problem is never changed: each call makes another one, so a
part that several have in common can be kept.
"""

# Made by crates/py/generate from the schema of problem files.

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, TypeAlias, TypedDict

from ._problem import Entries, Points

__all__ = ["Anisotropy", "Factors", "Interface", "Problem", "SoilInterface"]
'''
#: Entries within entries.
PARTS = ("Anisotropy", "Factors", "Interface", "SoilInterface")
#: Values of several kinds, and what their classes are called beside the kind.
LAWS = {"StrengthLaw": "Strength"}
#: Arguments with a unit in their name are given by it.
UNIT = re.compile(r"_(deg|kpa|m|m3|kn_per_m)$")


def problem(schema: dict[str, Any]) -> str:
    """The text of `problem.py`."""
    definitions = schema["$defs"]
    scope = Scope("", {name: one for name, one in definitions.items() if name not in PARTS and name not in LAWS})
    parts = [part(name, definitions[name], scope) for name in PARTS]
    parts += [law(name, definitions[name], scope) for name in LAWS]
    single, methods = {}, []
    for key, about in schema["properties"].items():
        reference = next((one["$ref"] for one in [about, *about.get("anyOf", [])] if "$ref" in one), "")
        of = definitions.get(reference.rsplit("/", 1)[-1], {})
        if key == "objective":
            for kind in of["oneOf"]:
                words = kind["properties"]["kind"]["const"]
                methods.append(method(f"objective_{words.replace('-', '_')}", key, kind, scope, "_set", {"kind": words}))
        elif about.get("type") == "array":
            entry = definitions[about["items"]["$ref"].rsplit("/", 1)[-1]]
            methods.append(method(key, key, entry, scope, "_add"))
        elif of.get("type") == "object":
            methods.append(method(key, key, of, scope, "_set"))
        elif key != "schema":
            single[key] = about
    return "\n".join([HEAD, *parts, whole(single, scope), *methods])


def kind_of(about: dict[str, Any], scope: Scope) -> str:
    if "const" in about:
        return f"Literal[{json.dumps(about['const'])}]"
    kind = " | ".join(one for one in scope.type(about).split(" | ") if one != "None")
    kind = kind.replace("list[list[float]]", "Points")
    return kind.replace("list[", "Sequence[").replace("dict[", "Mapping[")


def law(name: str, schema: dict[str, Any], scope: Scope) -> str:
    """A class for each kind, and what they are together."""
    kinds = {one["properties"]["kind"]["const"]: one for one in schema["oneOf"]}
    classes = {kind.title().replace("-", "") + LAWS[name]: one for kind, one in kinds.items()}
    text = "".join(part(one, about, scope) for one, about in classes.items())
    return f"{text}\n\n#: {sentences(schema)}\n{name}: TypeAlias = {' | '.join(classes)}\n"


def part(name: str, schema: dict[str, Any], scope: Scope) -> str:
    lines = []
    for key, about in schema["properties"].items():
        lines.append(f"    {key}: {kind_of(about, scope)}\n" + docstring(sentences(about) or "Which kind it is.", 4))
    return f"\nclass {name}(TypedDict, total=False):\n{docstring(sentences(schema), 4)}\n" + "".join(lines)


def whole(single: dict[str, Any], scope: Scope) -> str:
    """The head of the class, whose constructor takes what is no table."""
    order = sorted(single, key=lambda key: key != "title")
    head = "".join(f"        {key}: {kind_of(single[key], scope)} | None = None,\n" + "        *,\n" * (key == "title") for key in order)
    told = "\n".join(described(key, [sentences(single[key])]) for key in order)
    given = ", ".join(f'"{key}": {key}' for key in order)
    text = docstring("A problem file in the making.\n\nArgs:\n" + told, 4)
    return f"\nclass Problem(Entries):\n{text}\n    def __init__(\n        self,\n{head}    ) -> None:\n        super().__init__({{{given}}})\n"


def method(name: str, key: str, schema: dict[str, Any], scope: Scope, does: str, given: dict[str, str] | None = None) -> str:
    """A method that adds an entry, or sets one."""
    given = given or {}
    properties = {key: about for key, about in schema["properties"].items() if key not in given}
    required = [key for key in schema.get("required", []) if key not in given]
    required.sort(key=lambda key: UNIT.search(key) is not None)
    first = sum(1 for key in required if not UNIT.search(key))
    others = [key for key in properties if key not in required]
    head, told = [], []
    for one in required + others:
        about, argument = properties[one], argument_of(one)
        default = "" if one in required else f" = {default_of(about) if about.get('default') else None}"
        kind = kind_of(about, scope) + (" | None" if default == " = None" else "")
        head.append(f"        {argument}: {kind}{default},\n")
        told.append(described(argument, [sentences(about)]))
    if len(head) > first:
        head.insert(first, "        *,\n")
    entries = [f"{json.dumps(one)}: {json.dumps(value)}" for one, value in given.items()]
    entries += [f'"{one}": {argument_of(one)}' for one in required + others]
    text = sentences(schema) + ("\n\nArgs:\n" + "\n".join(told) if told else "")
    signature = f"(\n        self,\n{''.join(head)}    )" if head else "(self)"
    return f"    def {name}{signature} -> Problem:\n{indented(docstring(text, 4))}        return self.{does}({json.dumps(key)}, {{{', '.join(entries)}}})\n"


def argument_of(key: str) -> str:
    return key + "_" if keyword.iskeyword(key) else key


def indented(text: str) -> str:
    return "".join(f"    {line}" if line.strip() else line for line in text.splitlines(keepends=True))
