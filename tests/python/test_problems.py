"""The problems of `data/problems`, all of them solved: `cargo xtask verify published` writes what it found to `docs/verification/problems.csv`.

Pages that quote such bounds are held against these rows in every test run.
"""

import csv
import json
import os
import re
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = sorted(file.stem for file in (ROOT / "data" / "problems").glob("*.toml"))
FOUND = ROOT / "docs" / "verification" / "problems.csv"
WHOLE = os.environ.get("SOILCTL_PUBLISHED") == "all"
# Least number of problems that come to a gap of 4 % in a minute.
ENOUGH = 20
# Sentences with bounds of a problem that the page names.
QUOTED = re.compile(r"proven to be between\s+([\d.]+)\s+and\s+([\d.]+)")


def rows():
    """What was found last, by problem."""
    return {row["problem"]: row for row in csv.DictReader(FOUND.read_text(encoding="utf-8").splitlines())}


def test_each_problem_has_a_row():
    """Of bounds in order, most of them near each other."""
    found = rows()
    assert sorted(found) == PROBLEMS
    assert all(float(row["lower"]) <= float(row["upper"]) for row in found.values())
    assert sum(float(row["gap"]) <= 0.04 for row in found.values()) >= ENOUGH


def test_pages_quote_the_rows():
    """Where a page says between what the factor of a problem is proven to be, a problem that it names has these bounds."""
    found, quotes = rows(), 0
    for page in sorted((ROOT / "docs").glob("**/*.md")):
        text = page.read_text(encoding="utf-8")
        named = [found[name] for name in re.findall(r"data/problems/(\w+)\.toml", text)]
        for lower, upper in QUOTED.findall(text):
            same = [row for row in named if all(f"{float(row[key]):.{len(said.partition('.')[2])}f}" == said for key, said in (("lower", lower), ("upper", upper)))]
            assert same, f"{page.name}: {lower} to {upper}"
            quotes += 1
    assert quotes >= 4


@pytest.mark.skipif(not WHOLE, reason="minutes: cargo xtask verify published")
def test_all_are_solved(soilctl):
    """Each in a minute of its own; the rows replace those of before."""
    made = []
    for name in PROBLEMS:
        began = time.monotonic()
        done = soilctl("solve", ROOT / "data" / "problems" / f"{name}.toml", "--max-gap", "0.04", "--max-seconds", "60", "--format", "json")
        took = time.monotonic() - began
        assert done.returncode in (0, 3), f"{name}: {done.stderr}"
        answer = json.loads(done.stdout)
        made.append([name, *(f"{answer[key]:.5g}" for key in ("lower", "upper", "gap")), f"{took:.0f}"])
    with open(FOUND, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["problem", "lower", "upper", "gap", "seconds"])
        out.writerows(made)
    test_each_problem_has_a_row()
