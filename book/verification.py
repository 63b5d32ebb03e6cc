"""Tables of the page on verification, made from the rows that the tests compare with what they compute."""

import csv
import json
from pathlib import Path

ROWS = Path(__file__).resolve().parents[1] / "docs" / "verification"
# Printed with three decimals; the formulas' own rounding comes on top.
EQUAL = 0.0006
NAMES = {"coulomb": "Coulomb", "log_spiral": "log-spiral, thesis variant", "log-spiral-thesis": "log-spiral, thesis variant", "chen": "Chen & Liu"}


def tables():
    """Markdown by name, as it stands in `<!-- table: name -->`."""
    return {"appendix_c": appendix_c(), "table_4_3": table_4_3(), "exact": exact()}


def _markdown(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def _read(name):
    with open(ROWS / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def appendix_c():
    """How far the models are from the columns of the thesis."""
    cells, rows = _read("appendix_c.csv"), []
    for model in ("coulomb", "log_spiral", "chen"):
        apart = [float(cell[model]) - float(cell[f"{model}_printed"]) for cell in cells]
        equal = sum(abs(one) <= EQUAL for one in apart)
        rows.append([NAMES[model], len(apart), equal, f"{max(apart):.4f}", f"{-min(apart):.4f}"])
    return _markdown(["model", "cells", f"equal within {EQUAL}", "most above print", "most below"], rows)


def table_4_3():
    """How far the sensitivities are from those of the thesis, in per cent points."""
    inputs, found = ["alpha", "beta", "phi", "delta"], {}
    for row in _read("table_4_3.csv"):
        apart = abs(float(row["percent"]) - float(row["percent_printed"]))
        key = row["model"], row["input"]
        found[key] = max(apart, found.get(key, 0.0))
    models = sorted({model for model, _ in found})
    rows = [[NAMES[model], *(f"{found[model, one]:.2f}" if (model, one) in found else "" for one in inputs)] for model in models]
    return _markdown(["greatest difference to print, per cent points", *inputs], rows)


def exact():
    """Proven bounds beside the values that are known."""
    rows = []
    for row in json.loads((ROWS / "exact.json").read_text(encoding="utf-8")):
        lower, upper = row["lower"], row["upper"]
        gap = 100 * abs((upper - lower) / (upper + lower) * 2)
        rows.append([row["problem"], _known(row["known"]), f"{lower:.5g} to {upper:.5g}", f"{gap:.2g} %", row["elements"]])
    return _markdown(["problem", "known", "proven bounds", "gap", "elements"], rows)


def _known(ends):
    low, high = ends
    # Published to six figures.
    return f"{(low + high) / 2:.6g}" if high - low <= 3e-5 * abs(high) else f"{low:.5g} to {high:.5g}"
