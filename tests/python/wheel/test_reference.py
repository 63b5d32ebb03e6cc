"""The generated reference has everything: each verb, each option, each public name; and no page leads nowhere."""

import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import soilctl

ROOT = Path(__file__).parents[3]
COMMAND = Path(sys.executable).with_name("soilctl")
sys.path.insert(0, str(ROOT / "book"))
import reference  # noqa: E402


@pytest.fixture(scope="module")
def page():
    return reference.command_line()


def options():
    """Options by verb, from the completions for bash, which are made from the parser and not from its help."""
    script = subprocess.run([COMMAND, "completions", "bash"], capture_output=True, text=True, check=True).stdout
    for name, words in re.findall(r'^        (soilctl\w*)\)\n            opts="([^"]*)"', script, flags=re.MULTILINE):
        verb = name.replace("__subcmd__", " ")
        if " help" not in verb:
            yield verb, [word for word in words.split() if word.startswith("--")]


def test_every_option_of_every_verb_is_in_the_reference(page):
    sections = {"soilctl": page.partition("\n## ")[0]}
    for head, body in re.findall(r"^###? (soilctl [\w -]+)\n(.*?)(?=^###? |\Z)", page, flags=re.MULTILINE | re.DOTALL):
        sections[head] = body
    found = dict(options())
    assert set(found) == set(sections) and len(found) > 20 and sum(map(len, found.values())) > 150
    for verb, words in found.items():
        shown = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", sections[verb]))
        assert not set(words) - shown, f"{verb}: {sorted(set(words) - shown)}"


def test_every_public_name_is_in_the_reference():
    page = reference.python()
    for name in soilctl.__all__:
        assert name.startswith("__") or f"## {name}\n" in page
    for part in ("gym", "mesh", "plot", "problem", "use_cases", "xarray"):
        module = pytest.importorskip(f"soilctl.{part}")
        assert f"## soilctl.{part}\n" in page
        for name in module.__all__:
            assert f"### {part}.{name}\n" in page and inspect.getdoc(getattr(module, name)), name
    assert "gravity_m_s2=9.80665" in page and "Ellipsis" not in page
    # Fields of classes without members of their own.
    for field in ("failures: Cells that failed", "error: Type and message"):
        assert field in page


def test_options_that_pages_name_are_there():
    known = {word for _, words in options() for word in words}
    # Of other programs: cargo, its tests, maturin, a script of the tests, and sbatch.
    others = {"--release", "--locked", "--git", "--bench", "--path", "--manifest-path", "--example", "--nocapture", "--latency", "--servo", "--memory", "--image", "--array", "--wrap"}
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        # In code only; a table's rule is no option.
        for code in re.findall(r"```(?:sh|console)\n.*?```|`[^`\n]+`", text, flags=re.DOTALL):
            missing = set(re.findall(r"(?<![\w-])--[a-z][a-z0-9-]*", code)) - known - others
            assert not missing, f"{path.relative_to(ROOT)} names {sorted(missing)}"
