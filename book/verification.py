"""Tables of the page on verification, made from the rows that the tests compare with what they compute."""

import csv
import json
from pathlib import Path

ROWS = Path(__file__).resolve().parents[1] / "docs" / "verification"
PUBLISHED = ROWS.parents[1] / "data" / "published" / "published.csv"
# Printed with three decimals; the formulas' own rounding comes on top.
EQUAL = 0.0006
NAMES = {"coulomb": "Coulomb", "log_spiral": "log-spiral, thesis variant", "log-spiral-thesis": "log-spiral, thesis variant", "chen": "Chen & Liu",
         "caquot": "Caquot & Kerisel", "thesis-ub": "the thesis's upper bound", "thesis-lb": "the thesis's lower bound"}
SOILS = {"ticino_rained": "Ticino, rained", "ticino_loose": "Ticino, loose", "nevada_fine": "Nevada, fine", "glass_beads": "glass beads"}


def tables():
    """Markdown by name, as it stands in `<!-- table: name -->`."""
    return {"appendix_c": appendix_c(), "table_4_3": table_4_3(), "estimates": estimates(), "direct_shear": direct_shear(), "exact": exact(), "end_factor": end_factor(), "published": published(), "problems": problems()}


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


def estimates():
    """Ranges of friction angle and density beside those of chapter 7."""
    rows = []
    for row in _read("estimates.csv"):
        digits, unit = (1, "deg") if row["quantity"] == "phi_deg" else (0, "kg/m3")
        ours, printed = (f"{float(row[f'from{end}']):.{digits}f} to {float(row[f'to{end}']):.{digits}f}" for end in ("", "_printed"))
        rows.append([SOILS[row["soil"]], NAMES[row["model"]], row["density"], f"{ours} {unit}", f"{printed} {unit}"])
    return _markdown(["soil", "model", "density", "ours", "printed"], rows)


def direct_shear():
    """Equivalent stresses and friction angles of strokes beside tables 6.14 and 6.15."""
    rows = []
    for row in _read("direct_shear.csv"):
        stress, angle = ([float(row[f"{name}{end}"]) for end in ("", "_printed")] for name in ("stress_psi", "phi_deg"))
        rows.append([SOILS[row["soil"]], f"{float(row['depth_in']):.2f}", row["stress"], f"{stress[0]:.4f} ({stress[1]:.3f})", f"{angle[0]:.1f} ({angle[1]:.1f})"])
    return _markdown(["soil", "depth (in)", "stress", "psi (printed)", "friction angle, deg (printed)"], rows)


def end_factor():
    """How often the true soil is in the region, with ends and as if there were none."""
    found = [list(row.values()) for row in _read("end_factor.csv")]
    head = ["plates", "true soil in the region, with ends", "by plane strain", "no soil at all by plane strain"]
    return _markdown(head, [[plates, *(f"{float(share):.0f} %" for share in shares)] for plates, *shares in found])


def exact():
    """Proven bounds beside the values that are known."""
    rows = []
    for row in json.loads((ROWS / "exact.json").read_text(encoding="utf-8")):
        lower, upper = row["lower"], row["upper"]
        gap = 100 * abs((upper - lower) / (upper + lower) * 2)
        rows.append([row["problem"], _known(row["known"]), f"{lower:.5g} to {upper:.5g}", f"{gap:.2g} %", row["elements"]])
    return _markdown(["problem", "known", "proven bounds", "gap", "elements"], rows)


def published():
    """Proven bounds beside published values, which are of other methods."""
    found = {row["problem"]: row for row in _read("published.csv")}
    with open(PUBLISHED, newline="", encoding="utf-8") as file:
        known = list(csv.DictReader(file))
    rows = []
    for row in known:
        ours = found[row["problem"]]
        values = row["low"] if row["low"] == row["high"] else f"{row['low']} to {row['high']}"
        told = f"{row['source']}; {row['note']}" if row["note"] else row["source"]
        rows.append([told, values, row["methods"], f"{float(ours['lower']):.4g} to {float(ours['upper']):.4g}", f"{100 * float(ours['gap']):.1f} %", ours["seconds"]])
    return _markdown(["problem", "published", "by", "proven bounds", "gap", "s"], rows)


def problems():
    """Proven bounds on the problems that come with the program."""
    rows = [[f"`{row['problem']}`", f"{float(row['lower']):.4g} to {float(row['upper']):.4g}", f"{100 * float(row['gap']):.1f} %", row["seconds"]] for row in _read("problems.csv")]
    return _markdown(["problem", "bounds", "gap", "s"], rows)


def _known(ends):
    low, high = ends
    # Published to six figures.
    return f"{(low + high) / 2:.6g}" if high - low <= 3e-5 * abs(high) else f"{low:.5g} to {high:.5g}"
