"""Reference pages, made from what is installed, so that they cannot drift."""

import dataclasses
import importlib
import inspect
import json
import os
import re
import subprocess
import sys
import tempfile
from html import escape
from pathlib import Path

import soilctl

COMMAND = Path(sys.executable).with_name("soilctl")
ROOT = Path(__file__).resolve().parents[1]
PLATE = ["--alpha", "80", "--phi", "40", "--delta", "25"]
STROKES = ["estimate", "data/soils/ticino_rained/strokes.csv", "--delta", "23"]
#: Modules beside the package itself; most are imported on their own, since they need other packages.
PARTS = ["gym", "mesh", "plot", "problem", "use_cases", "xarray"]
FIGURES = {
    "surfaces": ["predict", *PLATE],
    "velocity": ["bound", "--alpha", "80", "--phi", "35", "--delta", "20", "--max-gap", "0.05"],
    "bands": [*STROKES, "--plot-kind", "bands"],
    "region": [*STROKES, "--density", "1600"],
    "shear": ["shear", "data/direct_shear.csv", "--soil", "ticino_rained"],
}


def _help(*words):
    environment = {**os.environ, "COLUMNS": "100", "NO_COLOR": "1"}
    done = subprocess.run([COMMAND, *words, "--help"], capture_output=True, text=True, check=True, env=environment)
    return done.stdout


def _verbs(text):
    found = re.search(r"^Commands:\n((?:  .*\n)+)", text, flags=re.MULTILINE)
    return re.findall(r"^  (\w[\w-]*) ", found.group(1), flags=re.MULTILINE) if found else []


def command_line():
    """Every verb with every option."""
    top = _help()
    parts = ["# Command line\n", f"```text\n{top}```\n"]
    for verb in _verbs(top):
        if verb == "help":
            continue
        text = _help(verb)
        parts.append(f"## soilctl {verb}\n\n```text\n{text}```\n")
        for action in _verbs(text):
            if action != "help":
                parts.append(f"### soilctl {verb} {action}\n\n```text\n{_help(verb, action)}```\n")
    return "\n".join(parts)


def _signature(name, thing):
    try:
        shown = str(inspect.signature(thing))
    except (TypeError, ValueError):
        shown = "(...)"
    return name + re.sub(r"^\((?:\$?self|slf)(?:, /)?(?:, )?", "(", shown)


def _described(thing):
    return f"<pre>{escape(inspect.getdoc(thing) or '', quote=False)}</pre>\n"


def _entry(name, thing, mark):
    """A public name under a heading, a class with its members."""
    if inspect.isclass(thing):
        parts = [f"{mark} {name}\n\n{_described(thing)}"]
        # How it is made, if it is not only returned.
        made = _signature(name, thing)
        if not (issubclass(thing, BaseException) or dataclasses.is_dataclass(thing) or made.endswith("()")):
            parts = [f"{mark} {name}\n\n**`{made}`**\n\n{_described(thing)}"]
        # A class of the compiled module has its members in another order each time, so all are sorted.
        for member in sorted(m for m in vars(thing) if not m.startswith("_") or m == "__geo_interface__"):
            value = getattr(thing, member)
            if thing.__module__.startswith("soilctl") and inspect.getdoc(value):
                # Plain values have the documentation of their type.
                if not (callable(value) or inspect.isdatadescriptor(value)):
                    continue
                head = _signature(member, value) if callable(value) else member
                parts.append(f"**`{name}.{head}`**\n\n{_described(value)}")
        return parts
    if callable(thing):
        return [f"{mark} {name}\n\n**`{_signature(name, thing)}`**\n\n{_described(thing)}"]
    return [f"{mark} {name}\n\n`{thing!r}`\n"]


def python():
    """Everything public, as `help()` tells it."""
    parts = ["# Python\n", "What `help()` says of everything in the package; [the guide](../python.md) shows how it goes together.\n"]
    names = [name for name in soilctl.__all__ if not name.startswith("__")]
    for name in sorted(names, key=str.lower):
        parts += _entry(name, getattr(soilctl, name), "##")
    for part in PARTS:
        module = importlib.import_module(f"soilctl.{part}")
        parts.append(f"## soilctl.{part}\n\n{_described(module)}")
        for name in sorted(module.__all__, key=str.lower):
            parts += _entry(f"{part}.{name}", getattr(module, name), "###")
    return "\n".join(parts)


def schemas(folder):
    """The top of every JSON schema."""
    parts = ["# JSON schemas\n", "One of every request, answer and file that is JSON. A field that may be absent or null says so.\n"]
    for path in sorted(folder.glob("*.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        parts.append(f"## {path.stem}\n\n[{path.name}](../schemas/{path.name}). {schema.get('description', '')}\n")
        rows = []
        for name, about in schema.get("properties", {}).items():
            told = " ".join(about.get("description", "").split()).replace("|", "\\|")
            rows.append(f"| `{name}` | {_kind(about)} | {told} |")
        if rows:
            parts.append("| key | type | what it is |\n|---|---|---|\n" + "\n".join(rows) + "\n")
    return "\n".join(parts)


def _kind(about):
    if "$ref" in about:
        return about["$ref"].rsplit("/", 1)[-1]
    if "anyOf" in about:
        return " or ".join(_kind(one) for one in about["anyOf"])
    if "const" in about:
        return f"`{about['const']}`"
    kinds = about.get("type", "any")
    kinds = kinds if isinstance(kinds, list) else [kinds]
    return " or ".join(f"array of {_kind(about.get('items', {}))}" if kind == "array" else kind for kind in kinds)


def figures():
    """Figures of the pages by name, as SVG."""
    made = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, words in FIGURES.items():
            path = Path(folder, f"{name}.svg")
            subprocess.run([COMMAND, *words, "--plot", path], cwd=ROOT, capture_output=True, check=True)
            made[name] = path.read_bytes()
    return made
