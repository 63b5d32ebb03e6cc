"""`soilctl table`: a built table read back by another implementation of Parquet."""

import itertools
import json

import pyarrow.parquet
import pytest

ALPHA, PHI, DELTA = [70, 80, 90, 100], [30, 35, 40], [0, 10, 20]
AXES = ["--alpha", "70:100:10", "--phi", "30:40:5", "--delta", "0:20:10"]


@pytest.fixture(scope="module")
def built(soilctl, tmp_path_factory):
    """The file of a table of the model `chen`, and the answer of the command that built it."""
    file = tmp_path_factory.mktemp("table") / "t.parquet"
    return file, soilctl.json("table", "build", "--model", "chen", *AXES, "--out", file)


def test_answer_follows_the_schema(built, validate):
    validate(built[1])
    assert built[1]["schema"] == "soilctl.table/1"


def test_parquet_holds_every_node_with_the_value_of_predict(built, soilctl):
    table = pyarrow.parquet.read_table(built[0])
    assert [str(field.type) for field in table.schema][:4] == ["double"] * 4
    rows = {(r["alpha_deg"], r["phi_deg"], r["delta_deg"]): r for r in table.to_pylist()}
    assert len(rows) == table.num_rows
    assert set(rows) == set(itertools.product(ALPHA, PHI, DELTA))
    for (alpha, phi, delta), row in rows.items():
        assert row["status"] == "solved"
        answer = soilctl.json("predict", "--model", "chen", "--alpha", alpha, "--phi", phi, "--delta", delta)
        assert row["k_net"] == answer["k_net"], (alpha, phi, delta)


def test_sidecar_tells_normalisation_and_count(built):
    sidecar = json.loads((built[0].parent / "t.parquet.json").read_text(encoding="utf-8"))
    assert sidecar["normalisation"] == "slant"
    assert sidecar["cells"] == len(ALPHA) * len(PHI) * len(DELTA)


def test_csv_and_parquet_hold_the_same_numbers(built, soilctl, tmp_path):
    import csv

    file = tmp_path / "t.csv"
    soilctl("table", "build", "--model", "chen", *AXES, "--out", file, code=0)
    with open(file, newline="", encoding="utf-8") as text:
        rows = list(csv.DictReader(line for line in text if not line.startswith("#")))
    parquet = pyarrow.parquet.read_table(built[0]).to_pylist()
    assert len(rows) == len(parquet)
    for a, b in zip(rows, parquet, strict=True):
        assert {key: float(a[key]) for key in ("alpha_deg", "phi_deg", "delta_deg", "k_net")} == {
            key: b[key] for key in ("alpha_deg", "phi_deg", "delta_deg", "k_net")
        }


def test_building_twice_gives_the_same_bytes(built, soilctl, tmp_path):
    file = tmp_path / "t.parquet"
    soilctl("table", "build", "--model", "chen", *AXES, "--out", file, code=0)
    assert file.read_bytes() == built[0].read_bytes()


def test_a_good_table_passes_its_check_and_a_cut_one_is_refused(built, soilctl, tmp_path):
    soilctl("table", "check", built[0], code=0)
    cut = tmp_path / "cut.parquet"
    cut.write_bytes(built[0].read_bytes()[:-100])
    (tmp_path / "cut.parquet.json").write_bytes((built[0].parent / "t.parquet.json").read_bytes())
    soilctl.refuses("table", "check", cut, mentions=["cut.parquet"])


@pytest.mark.parametrize("axis", ["100:70:10", "70:100:0", "70:100:-5", "70:100", "a:b:c", "70:100:nan"])
def test_bad_axes_are_refused(soilctl, tmp_path, axis):
    arguments = ["--model", "chen", "--alpha", axis, "--phi", "30:40:5", "--delta", "0:20:10"]
    soilctl.refuses("table", "build", *arguments, "--out", tmp_path / "t.parquet", mentions=["--alpha"])
    assert list(tmp_path.iterdir()) == []


def test_the_built_in_bounds_are_shown_checked_and_planned_by_the_schema(soilctl, validate, tmp_path):
    shown = soilctl.json("table", "show", "plate-bounds")
    checked = soilctl.json("table", "check", "plate-bounds", "--against", "appendix-c-num-ub")
    plan = soilctl.json("table", "build", "--dry-run", "--out", tmp_path / "t.csv")
    for answer in (shown, checked, plan):
        validate(answer)
    assert len(shown["cells"]) == plan["cases"] == 287 and checked["consistent"]
    for cell in shown["cells"]:
        node = ["--alpha", cell["alpha_deg"], "--phi", cell["phi_deg"], "--delta", cell["delta_deg"]]
        if cell["alpha_deg"] == 85 and cell["phi_deg"] == 40:
            answer = soilctl.json("predict", "--model", "table", *node)
            assert answer["k_net_lower"] == pytest.approx(cell["lower"], rel=1e-12)
            assert answer["k_net_upper"] == pytest.approx(cell["upper"], rel=1e-12)


def test_a_table_of_bounds_follows_the_schema(soilctl, validate, tmp_path):
    file = tmp_path / "t.csv"
    grid = ["--alpha", "85:90:5", "--phi", "25:30:5", "--delta", "0:30:30"]
    built = soilctl.json("table", "build", *grid, "--max-elements", 700, "--max-gap", 0.2, "--out", file)
    merged = soilctl.json("table", "merge", file, file, "--out", tmp_path / "m.csv")
    for answer in (built, merged):
        validate(answer)
        assert answer["table"]["filled"] == 6
    assert (tmp_path / "m.csv").read_bytes() == file.read_bytes()
