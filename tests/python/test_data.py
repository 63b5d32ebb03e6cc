"""The data folder: every file has its provenance, and what can be recomputed is recomputed."""

import csv
import importlib.util
import json
import math
import subprocess
import sys

import pytest
from conftest import DATA

KEYS = ["title", "source", "units", "normalisation", "status", "exceptions", "notes"]
SOILS = {"ticino_rained": 23.0, "ticino_loose": 23.0, "nevada_fine": 27.0, "glass_beads": 19.0}
TABLES = [
    "appendix_c",
    "caquot_active_inferred",
    "failure_forces",
    "soils",
    "table_4_3",
    "table_6_14_6_15",
    "table_7_2",
]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def check_sidecar(sidecar, table):
    content = json.loads(sidecar.read_text(encoding="utf-8"))
    assert list(content) == KEYS
    assert content["status"] in ("printed", "reconstructed", "inferred", "computed")
    assert list(content["units"]) == list(rows_of(table)[0])
    assert all(content["units"].values()) and content["title"] and content["notes"]
    for exception in content["exceptions"]:
        assert list(exception) == ["where", "status", "note"]
    return content


def test_every_table_has_a_sidecar():
    named = {path.stem for path in DATA.glob("*.csv")}
    assert named == {*TABLES, "direct_shear", "obstacle_ratios", "plate_bounds", "published_soils"}


def test_the_ratios_near_a_block_go_with_bounds_found_anew(soilctl):
    table = DATA / "obstacle_ratios.csv"
    assert check_sidecar(DATA / "obstacle_ratios.json", table)["status"] == "computed"
    rows = [{key: float(value) for key, value in row.items()} for row in rows_of(table)]
    assert len(rows) == 30
    # Another mesh and less work: both intervals hold the same ratio.
    words = ["--phi", 30, "--delta", 20, "--density", 1500, "--ahead", 0.1, "--body-top", 0.05, "--body-height", 0.2]
    words += ["--body-length", 0.3, "--max-gap", 0.3, "--max-elements", 2000]
    found = soilctl.json("obstacle", DATA / "tools/plate.toml", *words, code=None)["distances"][0]
    (row,) = [row for row in rows if (row["phi_deg"], row["ahead_depths"], row["top_depths"]) == (30, 1, 0.5)]
    assert found["ratio_lower"] <= row["ratio_upper"] and row["ratio_lower"] <= found["ratio_upper"]


def test_the_table_of_bounds_has_the_rows_and_the_sidecar_of_a_bracket_file():
    sidecar = json.loads((DATA / "plate_bounds.csv.json").read_text(encoding="utf-8"))
    assert sidecar["schema"] == "soilctl.bracket-file/1" and sidecar["normalisation"] == "slant"
    rows = rows_of(DATA / "plate_bounds.csv")
    assert len(rows) == sidecar["cells"] == 287
    nodes = [tuple(float(row[key]) for key in ("alpha_deg", "phi_deg", "delta_deg")) for row in rows]
    printed = rows_of(DATA / "appendix_c.csv")
    assert nodes == [tuple(float(row[key]) for key in ("alpha_deg", "phi_deg", "delta_deg")) for row in printed]
    for row in rows:
        lower, upper = float(row["lower"]), float(row["upper"])
        assert row["certified"] == "true" and 0 < lower < upper
        assert float(row["gap"]) == pytest.approx(2 * (upper - lower) / (upper + lower), abs=1e-12)


@pytest.mark.parametrize("name", TABLES)
def test_sidecars_are_complete(name):
    content = check_sidecar(DATA / f"{name}.json", DATA / f"{name}.csv")
    assert "Hong" in content["source"]
    if name in ("appendix_c", "caquot_active_inferred", "table_4_3"):
        assert content["normalisation"].startswith("slant length")


def test_published_soils_have_a_source_each():
    content = check_sidecar(DATA / "published_soils.json", DATA / "published_soils.csv")
    assert content["normalisation"] is None
    rows = rows_of(DATA / "published_soils.csv")
    assert all(row["source"] and row["method"] and row["body"] in ("earth", "moon", "mars") for row in rows)


@pytest.mark.parametrize("soil", SOILS)
def test_soils_have_their_sidecars(soil):
    content = check_sidecar(DATA / "soils" / soil / "provenance.json", DATA / "soils" / soil / "strokes.csv")
    assert "Hong" in content["source"]
    assert content["status"] == ("printed" if soil == "ticino_rained" else "reconstructed")


def test_the_script_reproduces_the_soils(tmp_path):
    script = DATA / "soils" / "make.py"
    subprocess.run([sys.executable, script, "--out", tmp_path], check=True)
    made = {path.relative_to(tmp_path): path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert {str(path.parent) for path in made} == set(SOILS)
    for path, content in made.items():
        assert (DATA / "soils" / path).read_bytes() == content, path
    stored = {p.relative_to(script.parent) for soil in SOILS for p in (script.parent / soil).iterdir()}
    assert stored == set(made)


@pytest.mark.parametrize("soil", SOILS)
def test_strokes_are_the_published_forces_in_si_units(soil):
    published = [row for row in rows_of(DATA / "failure_forces.csv") if row["soil"] == soil]
    strokes = rows_of(DATA / "soils" / soil / "strokes.csv")
    assert [float(row["alpha_deg"]) for row in strokes] == [70, 80, 90, 100]
    for row, source in zip(strokes, published, strict=True):
        # One pound-force is the weight of 0.45359237 kg under standard gravity.
        for key, published_key in [("force_n", "force_lbf_at_1in"), ("force_sd_n", "force_sd_lbf")]:
            newton = float(source[published_key]) * 0.45359237 * 9.80665
            assert float(row[key]) == pytest.approx(newton, rel=1e-15)
        slant_m = float(row["depth_m"]) / math.sin(math.radians(float(row["alpha_deg"])))
        assert slant_m == pytest.approx(0.0254, rel=1e-15)
        assert float(row["width_m"]) == 0.127
        assert float(row["delta_set_deg"]) == SOILS[soil]
        density = next(r for r in rows_of(DATA / "soils.csv") if r["soil"] == soil)["density_g_cc"]
        assert float(row["density_kg_m3"]) == pytest.approx(1000 * float(density), rel=1e-15)


def test_numbers_keep_every_digit():
    spec = importlib.util.spec_from_file_location("make", DATA / "soils" / "make.py")
    make = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make)
    for path, text in make.files().items():
        if path.endswith("strokes.csv"):
            for row in csv.DictReader(text.splitlines()):
                numbers = [value for key, value in row.items() if key != "stroke_id"]
                assert all(repr(float(value)) == value for value in numbers)


def test_the_unsolved_lower_bounds_are_means_of_their_neighbours():
    cells = {
        tuple(float(row[key]) for key in ("alpha_deg", "phi_deg", "delta_deg")): row
        for row in rows_of(DATA / "appendix_c.csv")
    }
    at_5 = [(alpha, phi) for alpha, phi, delta in cells if delta == 5]
    assert len(cells) == 287 and len(at_5) == 42
    for alpha, phi in at_5:
        at_0, here, at_10 = (float(cells[alpha, phi, delta]["num_lb"]) for delta in (0.0, 5.0, 10.0))
        # Printed to three decimals each.
        assert abs(here - (at_0 + at_10) / 2) <= 0.0011


def test_every_column_of_appendix_c_increases_in_every_angle():
    rows = rows_of(DATA / "appendix_c.csv")
    names = ["alpha_deg", "phi_deg", "delta_deg"]
    for column in ["coulomb", "log_spiral", "chen", "caquot", "num_ub", "num_lb"]:
        cells = {tuple(float(row[k]) for k in names): float(row[column]) for row in rows if row[column]}
        for at, value in cells.items():
            for axis in range(3):
                following = tuple(x + 5 * (i == axis) for i, x in enumerate(at))
                assert cells.get(following, math.inf) > value, (column, at, names[axis])
