"""The notebooks run, and hold nothing but what was written into them. Their assertions are in them."""

import sys
import time
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "book"))
import notebooks  # noqa: E402

NOTEBOOKS = sorted(notebooks.SOURCES.glob("*.ipynb"))


def test_there_are_three():
    assert [path.stem for path in NOTEBOOKS] == ["bounds", "campaign", "strokes"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_they_are_kept_without_outputs(path):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            assert cell.outputs == [] and cell.execution_count is None, "see CONTRIBUTING.md: clear the outputs"
    assert set(notebook.metadata) == {"kernelspec", "language_info"}, "nothing of one's own machine"


# Sockets of the kernel that are closed late, and a folder of Jupyter's that will have another place one day.
@pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_they_run(path, record_property):
    begin = time.monotonic()
    notebook = notebooks.keep(path)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.execution_count for cell in code)
    assert sum("assert" in cell.source for cell in code) >= 5
    figures = [output for cell in code for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(figures) >= 2
    # Warnings of libraries and the like would stand on the page.
    assert not [output for cell in code for output in cell.outputs if output.get("name") == "stderr"]
    # Told, not asserted: the machine may be busy.
    record_property("seconds", time.monotonic() - begin)
    print(f"{path.stem}: {time.monotonic() - begin:.1f} s")


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_pages_show_what_they_showed(path):
    markdown = pytest.importorskip("markdown")
    text, figures = notebooks.page(path)
    html = markdown.markdown(text, extensions=["tables", "fenced_code"])
    assert html.startswith("<h1>") and html.count("<img ") == len(figures) >= 2
    assert all(f'src="{name}"' in html and image.startswith(b"\x89PNG") for name, image in figures.items())
    # Regions and brackets as notebooks show them: nothing of them is lost on the way.
    assert text.count("<table>") == html.count("<table>") and text.count("<path") == html.count("<path")
