"""`log`, `view` and their like on recordings of other programs, written by `rosbags`."""

import csv
import math
import shutil
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest
from test_process import BIAS, motion, write_bag
from test_view import Recording

DATA = Path(__file__).resolve().parents[2] / "crates" / "bag" / "tests" / "data"
START_S = 1_700_000_000

pytestmark = pytest.mark.filterwarnings("ignore:RRD file has no footer")


@pytest.fixture(scope="module")
def bag(tmp_path_factory):
    return write_bag(tmp_path_factory.mktemp("bag"), description=True)


def test_info_of_another_program(soilctl, bag):
    """Counts, rates and times as they were written; nothing is wrong with it."""
    found = soilctl.json("log", "info", bag)
    content = found["content"]
    topics = {topic["topic"]: topic for topic in content["topics"]}
    wrench, joints = topics["/cell/wrench"], topics["/gantry/joints"]
    assert (wrench["messages"], wrench["kind"], wrench["gaps"]) == (3000, "wrench", 0)
    assert (joints["messages"], joints["kind"], joints["gaps"]) == (960, "joints", 0)
    assert wrench["rate_hz"] == pytest.approx(250, rel=1e-6) and joints["rate_hz"] == pytest.approx(80, rel=1e-6)
    assert content["found"]["clock_origin_s"] == START_S and content["found"]["has_urdf"]
    assert (wrench["start_s"], joints["start_s"]) == pytest.approx((0.001, 0.0), abs=1e-6)
    assert content["end_s"] == pytest.approx(12 - 1 / 250 + 0.001, abs=1e-6)
    doctor = soilctl.json("log", "doctor", bag)
    assert doctor["problems"] == doctor["damage"] == []
    assert "the log is well" in soilctl("log", "doctor", bag).stdout


@pytest.mark.parametrize("name", ["none.mcap", "zstd.mcap", "bz2.bag", "sqlite", "split"])
def test_every_container(soilctl, name, tmp_path):
    content = soilctl.json("log", "info", DATA / name)["content"]
    assert {topic["topic"]: topic["messages"] for topic in content["topics"]}["/wrench"] == 16
    assert content["found"]["clock_origin_s"] == START_S
    assert soilctl.json("log", "doctor", DATA / name)["problems"] == []
    out = tmp_path / "wrench.csv"
    soilctl.json("log", "export", DATA / name, "--topic", "/wrench", "--out", out)
    with out.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    # By `make.py`: x / 8 every 10 ms, stamped 500 ns late.
    for k, row in enumerate(rows):
        assert float(row["time_s"]) == pytest.approx(k * 0.01 + 5e-7, abs=1e-9)
        assert float(row["wrench_force_x"]) == k / 8
    assert len(rows) == 16


def test_damage_is_said(soilctl, bag, tmp_path):
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(bag.read_bytes()[: bag.stat().st_size // 2])
    assert soilctl.json("log", "doctor", cut, code=3)["damage"]


def test_export_of_any_topic(soilctl, bag, tmp_path):
    out = tmp_path / "joints.parquet"
    written = soilctl.json("log", "export", bag, "--topic", "/gantry/joints", "--out", out)["written"]
    assert (written["rows"], written["clock_origin_s"]) == (960, START_S)
    table = pyarrow.parquet.read_table(out).to_pydict()
    times = np.array(table["time_s"])
    assert times == pytest.approx(np.arange(960) / 80, abs=1e-6)
    assert np.array(table["cart_x_position"]) == pytest.approx([motion(t)[0] for t in times], abs=1e-6)
    soilctl.refuses("log", "export", bag, "--topic", "/none", "--out", out, mentions=["/none", "/gantry/joints"])


def test_view_of_another_program(soilctl, bag, tmp_path):
    """Arm, force and joints in Rerun are where formulas say."""
    log = shutil.copy(bag, tmp_path / "bag.mcap")
    answer = soilctl.json("view", log, "--plate-frame", "blade_edge", "--no-open")
    assert (answer["clock_origin_s"], answer["damage"]) == (START_S, [])
    shown = Recording(Path(answer["recording"]))
    assert {"/end_point", "/force_sensor", "/joints/sliding", "/world/force"} <= set(shown.rows)
    rows = {entity["entity"]: entity["rows"] for entity in answer["entities"]}
    assert (rows["/force_sensor"], rows["/end_point"]) == (3000, 960)
    times = np.array(shown.times["/end_point"]) / 1e9
    assert times == pytest.approx(np.arange(960) / 80, abs=1e-6)
    points = np.array(shown.rows["/end_point"]["Scalars:scalars"])
    assert points == pytest.approx(np.array([[x, 0.0, z] for x, z, _ in map(motion, times)]), abs=1e-6)
    # At the beginning nothing acts: the sensor reads its bias, turned by 30 deg about y.
    _, arrows = shown.vectors("/world/force")
    first, turn = arrows[:200].mean(axis=0), math.radians(30)
    root = [math.cos(turn) * BIAS[0] + math.sin(turn) * BIAS[2], BIAS[1], -math.sin(turn) * BIAS[0] + math.cos(turn) * BIAS[2]]
    assert first / np.linalg.norm(first) == pytest.approx(np.array(root) / np.linalg.norm(root), abs=0.01)
