"""`soilctl tool --table`: bounds over friction angles, against Coulomb, and gone on with."""

import csv
import json
import math

from conftest import DATA
from reference import GRAVITY_M_S2, coulomb_k_depth

PLATE = DATA / "tools/plate.toml"
SOIL = ["--phi", 35, "--delta", 20, "--density", 1600]
QUICK = ["--max-gap", 0.1, "--max-elements", 1000]


def test_a_table_of_a_plate(soilctl, validate, tmp_path):
    path = tmp_path / "plate.csv"
    words = ["tool", PLATE, *SOIL, *QUICK, "--table", path, "--phis", "30:35:5", "--deltas"]
    first = soilctl.json(*words, "10:20:10", code=None)
    validate(first)
    table = first["table"]
    assert [(row["phi_deg"], row["delta_deg"]) for row in table["rows"]] == [(30, 10), (30, 20), (35, 10), (35, 20)]
    for row in table["rows"]:
        half = 0.5 * 1600 * GRAVITY_M_S2 * 0.1**2 * math.cos(math.radians(row["delta_deg"]))
        passive, active = [half * float(k) for k in coulomb_k_depth(90, row["phi_deg"], row["delta_deg"])]
        assert 0.8 * (passive - active) < row["lower_n_per_m"] <= passive - active
        assert row["lower_n_per_m"] <= row["upper_n_per_m"]
    # The row at the angles of the request is the answer.
    assert table["rows"][-1]["lower_n_per_m"] == first["lower_n_per_m"]
    written = list(csv.DictReader(path.read_text().splitlines()))
    assert [float(row["upper_n_per_m"]) for row in written] == [row["upper_n_per_m"] for row in table["rows"]]
    # As if it had been broken off after two rows.
    beside = tmp_path / "plate.csv.json"
    kept = json.loads(beside.read_text())
    del kept["rows"][2:]
    beside.write_text(json.dumps(kept))
    again = soilctl.json(*words, "10:20:10", code=None)
    assert again["table"]["kept_rows"] == 2 and again["table"]["rows"] == table["rows"]
    soilctl.refuses(*words, "10:20:10", "--width", 1, mentions=["made from another tool"])


def test_what_is_refused(soilctl, tmp_path):
    path = tmp_path / "table.csv"
    soilctl.refuses("tool", PLATE, *SOIL, "--phis", "30:35:5", mentions=["--table"])
    soilctl.refuses("tool", PLATE, *SOIL, "--table", tmp_path / "table.txt", mentions=[".csv or .parquet"])
    soilctl.refuses("tool", PLATE, *SOIL, "--table", path, "--phis", "10:15:5", "--deltas", "20:30:5", mentions=["0 rows"])
    blade = DATA / "tools/blade.toml"
    soilctl.refuses("tool", blade, *SOIL, "--table", path, "--deltas", "20:30:5", mentions=["--deltas"])
