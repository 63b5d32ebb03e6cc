"""Notebooks: run, kept with what they showed, and turned into pages.

The repository holds them without outputs. `executed` runs one where the package is installed; the tests do so and keep what came of it
in target/notebooks, from where the pages of the site take it.
"""

import base64
import re
import tomllib
from pathlib import Path
from urllib.parse import quote

import nbformat
from nbclient import NotebookClient

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "docs" / "notebooks"
KEPT = ROOT / "target" / "notebooks"
# Seconds for one cell: only a cell that hangs takes so long.
PATIENCE = 300
COLOURS = re.compile(r"\x1b\[[0-9;]*m")


def executed(source):
    """A notebook with its outputs; it runs in the folder of its file. An assertion that fails is an exception."""
    notebook = nbformat.read(source, as_version=4)
    NotebookClient(notebook, timeout=PATIENCE, resources={"metadata": {"path": str(source.parent)}}).execute()
    return notebook


def keep(source):
    """Runs a notebook and keeps it with its outputs."""
    notebook = executed(source)
    KEPT.mkdir(parents=True, exist_ok=True)
    nbformat.write(notebook, KEPT / source.name)
    return notebook


def shown(source):
    """A notebook with its outputs: as the tests kept it, if it is the same notebook, and otherwise run now."""
    kept = KEPT / source.name
    if kept.exists():
        notebook = nbformat.read(kept, as_version=4)
        if _text(notebook) == _text(nbformat.read(source, as_version=4)):
            return notebook
    return keep(source)


def _text(notebook):
    return [(cell.cell_type, cell.source) for cell in notebook.cells]


def hosted(source):
    """HTML with the addresses at which a notebook can be run: that of the version that the package index has."""
    package = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]
    place = package["repository"].removeprefix("https://github.com/")
    tag, file = f"v{package['version']}", source.relative_to(ROOT).as_posix()
    addresses = {
        "Colab": f"https://colab.research.google.com/github/{place}/blob/{tag}/{file}",
        "Binder": f"https://mybinder.org/v2/gh/{place}/{tag}?labpath={quote(file, safe='')}",
    }
    return "\n".join(f'<a class="hosted" href="{address}">Open in {name}</a>' for name, address in addresses.items())


def page(source):
    """Markdown of a page, and its figures by name."""
    parts, figures = [], {}
    for cell in shown(source).cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        for output in cell.outputs:
            data = output.get("data", {})
            if "image/png" in data:
                name = f"{source.stem}-{len(figures) + 1}.png"
                figures[name] = base64.b64decode(data["image/png"])
                parts.append(f"![Figure {len(figures)} of this notebook]({name})")
            elif "text/html" in data:
                # A block of its own: no empty line may be inside; and Markdown drops tags that close themselves.
                html = re.sub(r"<(\w+)([^<>]*)/>", r"<\1\2></\1>", data["text/html"])
                parts.append(re.sub(r"\n\s*\n", "\n", html))
            elif text := output.get("text") or data.get("text/plain"):
                parts.append(f"```text\n{COLOURS.sub('', text).rstrip()}\n```")
    download = f"This page is a notebook that the tests run: [{source.name}]({source.name})."
    title, *rest = parts
    head, _, body = title.partition("\n")
    return "\n\n".join([head, download, hosted(source), body.strip(), *rest]) + "\n", figures


def clear(source):
    """Takes out what a run left behind: outputs, numbers of the cells, and what Jupyter notes of the machine."""
    notebook = nbformat.read(source, as_version=4)
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    for cell in notebook.cells:
        cell.metadata = {}
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    nbformat.write(notebook, source)


if __name__ == "__main__":
    for path in sorted(SOURCES.glob("*.ipynb")):
        clear(path)
