"""Every example of the documentation's pages is run, and what it prints is what the page says."""

import contextlib
import io
import re
import shlex
import subprocess
import sys
from pathlib import Path

import matplotlib
import pytest

ROOT = Path(__file__).parents[3]
DOCS = ROOT / "docs"
# By their place in the folder of the pages.
README = "../README.md"
PAGES = ["tutorial.md", "python.md", "own-robot.md", *(f"how/{path.name}" for path in sorted((DOCS / "how").glob("*.md")))]
BLOCK = re.compile(r"(<!-- not run: [^>]*-->\n)?^```(\w+)\n(.*?)^```$", flags=re.MULTILINE | re.DOTALL)
COMMAND = Path(sys.executable).with_name("soilctl")
matplotlib.use("Agg")


def blocks(page):
    text = (DOCS / page).read_text(encoding="utf-8")
    return [(kind, body) for skipped, kind, body in BLOCK.findall(text) if not skipped]


def same(shown, printed):
    """Lines of only dots stand for any lines, dots at the end of a line for the rest of it."""
    lines = [re.escape(line) for line in shown.strip().splitlines()]
    pattern = "".join(r"(?:.*\n)*" if line == r"\.\.\." else re.sub(r"(\\\.){3}$", ".*", line) + r"\n" for line in lines)
    # The last of them may be left out.
    return re.fullmatch(pattern, printed.strip() + "\n")


@pytest.fixture
def place(tmp_path, monkeypatch):
    (tmp_path / "data").symlink_to(ROOT / "data")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("page", PAGES)
def test_python(page, place):
    names, printed = {"__name__": "__main__"}, None
    for kind, body in blocks(page):
        if kind == "python":
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile(body, page, "exec"), names)  # noqa: S102
            printed = out.getvalue()
        elif kind == "text":
            assert same(body, printed), f"{body!r} is shown, but it printed {printed!r}"


@pytest.mark.parametrize("page", [README, *PAGES])
def test_commands(page, place):
    for kind, body in blocks(page):
        if kind != "console":
            continue
        for part in re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]:
            line, _, shown = part.partition("\n")
            words = shlex.split(line)
            assert words[0] == "soilctl"
            done = subprocess.run(
                [COMMAND, *words[1:]], cwd=place, capture_output=True, text=True, timeout=300, check=False
            )
            assert done.returncode in (0, 1), line + done.stderr
            # A command of which nothing is shown may print anything.
            assert not shown.strip() or same(shown, done.stdout), f"{line}\n{done.stdout}"
