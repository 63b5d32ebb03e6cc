"""From a simulated campaign to its logs, failure forces and diagnosis."""

import csv
import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import counting

import soilctl

DATA = Path(__file__).parents[3] / "data"
PLAN = """
version = 1
design = "one stroke"
soil = "ticino_loose"
model = "chen"

[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.020, delta_set_deg = 23.0 }]
"""


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    folder = tmp_path_factory.mktemp("campaign")
    plan = folder / "plan.toml"
    plan.write_text(PLAN)
    answer = soilctl.simulate(plan, out=folder / "logs", seed=3, threads=1)
    assert answer["complete"] and answer["exit_code"] == 0
    return folder


@pytest.fixture(scope="module")
def log(campaign):
    return campaign / "logs" / "batch_000.mcap"


def test_a_log_tells_what_it_holds_and_replays_bit_for_bit(log):
    info = soilctl.log_info(log)
    assert info["damage"] == [] == info["problems"] and len(info["strokes"]) == 1
    assert info["topics"]["/controller/step"]["messages"] == info["steps"] > 1000
    found = soilctl.replay(log)
    assert found["identical"] and found["steps"] == info["steps"] and found["first_difference"] is None
    later = soilctl.replay(log, from_keyframe=2)
    assert later["identical"] and later["steps"] == info["steps"] - 1000
    with pytest.raises(soilctl.NoAnswerError, match="key frame"):
        soilctl.replay(log, from_keyframe=10_000)
    with pytest.raises(soilctl.InputError, match="from_keyframe is -1; it must be at least 0"):
        soilctl.replay(log, from_keyframe=-1)


def test_tables_of_a_log_are_those_that_are_exported(log, tmp_path):
    for topic in ("/controller/step", "/joint_states"):
        table = soilctl.log_table(log, topic)
        out = tmp_path / "table.csv"
        soilctl.answer("log", "export", log, "--out", out, "--topic", topic)
        with out.open(newline="") as file:
            rows = list(csv.DictReader(file))
        assert list(table) == list(rows[0])
        for name, column in table.items():
            text = [row[name] for row in rows]
            if isinstance(column, list):
                assert column == text
            elif column.dtype == bool:
                assert [str(value).lower() for value in column.tolist()] == text
            else:
                np.testing.assert_array_equal(column, np.array(text, dtype=column.dtype))


def test_the_logged_arm_is_where_its_joints_say(log):
    table = soilctl.log_table(log)
    assert np.allclose(np.diff(table["time_s"]), 0.002)
    joints, poses, forces = (
        np.column_stack([table[f"{name}_{i}"] for i in range(count)])
        for name, count in (("external_joints_rad", 5), ("pose", 5), ("force_rtz_n", 3))
    )
    known = np.isfinite(poses).all(axis=1) & (poses != 0).any(axis=1)
    assert known.sum() > 1000
    apart = np.linalg.norm(soilctl.Arm().forward(joints[known])[:, :3] - poses[known][:, :3], axis=1)
    # Behind the encoders the elbow gives way by 1/130 rad a Nm, and neither lever is longer than 0.6 m.
    assert (apart <= 0.6**2 / 130 * np.linalg.norm(forces[known], axis=1) + 1e-6).all()


def test_a_damaged_log_is_saved_as_far_as_it_goes(log, tmp_path):
    broken, saved = tmp_path / "broken.mcap", tmp_path / "saved.mcap"
    data = log.read_bytes()
    broken.write_bytes(data[: len(data) // 2])
    assert soilctl.log_info(broken)["damage"]
    found = soilctl.log_recover(broken, out=saved)
    info = soilctl.log_info(saved)
    assert found["damage"] and not info["damage"] and 0 < info["steps"] == found["steps"]
    steps = soilctl.log_table(saved)["step"]
    np.testing.assert_array_equal(steps, np.arange(len(steps)))
    with pytest.raises(soilctl.InputError, match="itself"):
        soilctl.log_recover(broken, out=broken)


@pytest.fixture(scope="module")
def long_log(log, tmp_path_factory):
    """The log many times over behind one header, as far as a reader can tell: seconds of work for whoever reads all of it."""
    path = tmp_path_factory.mktemp("long") / "long.mcap"
    magic, data = 8, log.read_bytes()
    records = data[magic:]
    # Up to the end of the data: what follows is an index, which a reader from the beginning does not need.
    end, place = 0, 0
    while place < len(records) - magic:
        length = int.from_bytes(records[place + 1 : place + 9], "little")
        if records[place] == 0x0F:
            end = place
            break
        place += 9 + length
    header = 9 + int.from_bytes(records[1:9], "little")
    assert records[0] == 0x01 and end > header
    path.write_bytes(data[:magic] + records[:header] + 25 * records[header:end])
    return path


@pytest.mark.parametrize("name", ["log_info", "log_recover", "log_table", "replay", "answer"])
def test_control_c_ends_the_reading_of_a_log(name, long_log, tmp_path):
    calls = {
        "log_info": lambda: soilctl.log_info(long_log),
        "log_recover": lambda: soilctl.log_recover(long_log, out=tmp_path / "saved.mcap"),
        "log_table": lambda: soilctl.log_table(long_log),
        "replay": lambda: soilctl.replay(long_log),
        "answer": lambda: soilctl.answer("log", "doctor", long_log),
    }
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    begin = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        calls[name]()
    timer.join()
    print(f"{name}: ended {time.monotonic() - begin - 0.3:.2f} s after Ctrl-C")
    # Nothing half done is left behind, and the package works on.
    assert list(tmp_path.iterdir()) == []


def test_other_threads_run_while_a_log_is_read(long_log):
    with counting() as counted:
        soilctl.log_info(long_log)
    assert counted[0] > 1000, "the lock is free"


def test_progress_is_told(campaign, tmp_path):
    plan, told = campaign / "plan.toml", []
    soilctl.simulate(plan, out=tmp_path / "logs", seed=4, progress=lambda *at: told.append(at))
    assert told[-1] == (1, 1) and told == sorted(told)
    told.clear()
    soilctl.process(tmp_path / "logs", out=tmp_path / "strokes.csv", progress=lambda *at: told.append(at))
    assert told[-1] == (1, 1)
    table = ["table", "build", "--model", "coulomb", "--grid", "appendix-c", "--out", tmp_path / "table.csv"]
    told.clear()
    soilctl.answer(*table, progress=lambda *at: told.append(at))
    # Seven tool angles, six friction angles, seven of the interface.
    assert told[-1] == (294, 294)
    # Without steps to count nothing is told.
    told.clear()
    soilctl.answer("shear", DATA / "direct_shear.csv", progress=lambda *at: told.append(at))
    assert told == []

    def enough(done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        soilctl.simulate(plan, out=tmp_path / "others", seed=5, progress=enough)


def test_progress_is_a_bar(campaign, capfd):
    pytest.importorskip("tqdm")
    soilctl.process(campaign / "logs", progress=True)
    assert "1/1" in capfd.readouterr().err


def test_a_log_has_named_axes(log):
    xarray = pytest.importorskip("xarray")
    from soilctl.xarray import log_table

    table, found = soilctl.log_table(log), log_table(log)
    assert isinstance(found, xarray.Dataset) and found.sizes["time_s"] == len(table["time_s"])
    assert found["motor_counts"].dims == ("time_s", "motor_counts_index") and found["wrench"].shape[1] == 6
    for name, column in table.items():
        base, _, index = name.rpartition("_")
        there = found[base][:, int(index)] if index.isdigit() else found[name]
        np.testing.assert_array_equal(there, column)
    half = found.sel(time_s=slice(1.0, 2.0))
    assert half.sizes["time_s"] == pytest.approx(501, abs=1)


def test_logs_that_are_none_are_refused(log, tmp_path):
    path = tmp_path / "log.mcap"
    for call in (soilctl.log_info, soilctl.log_table, soilctl.replay):
        with pytest.raises(soilctl.FileError, match="log.mcap"):
            call(path)
    path.write_bytes(b"not a log")
    for call in (soilctl.log_info, soilctl.log_table, soilctl.replay):
        with pytest.raises(soilctl.FileError, match="MCAP"):
            call(path)
    with pytest.raises(soilctl.InputError, match="cannot be exported"):
        soilctl.log_table(log, "/tf")
    with pytest.raises(TypeError):
        soilctl.log_info(5)


def test_strokes_are_processed(campaign, log):
    out = campaign / "strokes.csv"
    answer = soilctl.process(log, out=out, threads=1)
    assert answer["exit_code"] == 0
    with out.open(newline="") as file:
        (row,) = csv.DictReader(file)
    assert float(row["alpha_deg"]) == pytest.approx(80.0, abs=1.0)
    assert float(row["force_n"]) > 0
    again = soilctl.process([log], out=out, threads=1)
    assert {**again, "reused": None} == {**answer, "reused": None} or again["exit_code"] == 0
    with pytest.raises(soilctl.InputError):
        soilctl.process(campaign / "plan.toml", out=out)
    with pytest.raises(soilctl.InputTypeError, match="surface_z is unknown.*surface_z_m"):
        soilctl.process(log, surface_z=0.1)
    with pytest.raises(soilctl.InputError, match="threads is 0"):
        soilctl.process(log, threads=0)


def test_shards_are_united_by_the_same_call(campaign, log, tmp_path):
    logs = [tmp_path / f"{letter}.mcap" for letter in "abc"]
    for path in logs:
        path.write_bytes(log.read_bytes())
    whole, shared = tmp_path / "whole" / "strokes.csv", tmp_path / "shared" / "strokes.csv"
    for out in (whole, shared):
        out.parent.mkdir()
    soilctl.process(logs, out=whole)
    for i in (2, 1):
        found = soilctl.process(logs, out=shared, shard=(i, 2))
        assert len(found["strokes"]) == 3 - i
    assert not shared.exists()
    assert soilctl.process(logs, out=shared)["reused"] == 3
    for name in ("strokes.csv", "traces.csv", "campaign.json"):
        assert shared.with_name(name).read_bytes() == whole.with_name(name).read_bytes()
    for bad in ((0, 2), (3, 2), (1,), ("a", "b"), "1/2", 1, (1, 2, 3), (1.0, 2.0)):
        with pytest.raises(soilctl.InputError, match=r"shard is .*\(i, n\)"):
            soilctl.process(logs, out=shared, shard=bad)


def test_answers_are_tables_in_notebooks(campaign):
    found = soilctl.process(campaign / "logs", report=campaign / "page.html")
    html = found._repr_html_()
    assert html.startswith("<table>") and "page.html</a>" in html
    found = soilctl.answer("shear", DATA / "direct_shear.csv")
    assert isinstance(found, dict) and "<script" not in found._repr_html_()
    # Whatever its user puts into it.
    found.update({"array": np.arange(3), "path": [campaign], 5: object()})
    assert "<td>" in found._repr_html_()


def test_a_missing_effect_is_named(tmp_path):
    found = soilctl.diagnose(DATA / "campaigns" / "campaign_a", out=tmp_path)
    assert found["gap"]["after"] < found["gap"]["before"] and found["effects"]
    assert {path.name for path in tmp_path.iterdir()} >= {"patch.json", "predictions.csv", "report.html"}
    with pytest.raises(soilctl.SoilctlError, match=r"strokes\.csv"):
        soilctl.diagnose(tmp_path / "none")
    # What it found is known to the next one.
    again = soilctl.diagnose(DATA / "campaigns" / "campaign_a", model_file=found["patch"], out=tmp_path / "again")
    assert again["known_effects"] == [effect["id"] for effect in found["effects"]]
    assert (again["status"], again["effects"]) == ("none", [])
    with pytest.raises(soilctl.InputError, match="model_file"):
        soilctl.diagnose(DATA / "campaigns" / "campaign_a", model="chen", model_file=found["patch"], out=tmp_path)


def test_a_diagnosis_takes_traces_and_logs(tmp_path):
    campaign = DATA / "campaigns" / "campaign_a"
    with (campaign / "strokes.csv").open(newline="") as file:
        strokes = list(csv.DictReader(file))
    traces = tmp_path / "elsewhere.csv"
    head = "stroke_id,t_s,x_ext_m,x_mtr_m,force_n\n"
    curve = np.linspace(0.0, 1.0, 100)
    lines = [
        f"{row['stroke_id']},{2 * x:.4f},{0.01 * x:.6f},{0.01 * x:.6f},{float(row['force_n']) * min(1.0, 3 * x):.4f}\n"
        for row in strokes
        for x in curve
    ]
    traces.write_text(head + "".join(lines))
    assert soilctl.diagnose(campaign, out=tmp_path / "plain")["traces"] == 0
    assert soilctl.diagnose(campaign, traces=traces, out=tmp_path / "with")["traces"] == len(strokes)
    traces.write_text(head + lines[0] + lines[0])
    with pytest.raises(soilctl.InputError, match=r"elsewhere\.csv.*line 3"):
        soilctl.diagnose(campaign, traces=traces, out=tmp_path / "bad")
    # Logs are needed to run the campaign again.
    with pytest.raises(soilctl.InputError, match=r"\.mcap"):
        soilctl.diagnose(campaign, logs=tmp_path, out=tmp_path / "again")


def test_angles_of_shear_tests_follow_their_power_law():
    stress = np.array([200.0, 500.0, 1200.0, 3000.0, 8000.0])
    angle = 40.0 * (stress / 1000.0) ** -0.05
    found = soilctl.shear(
        {"normal_stress_pa": stress, "friction_angle_deg": angle}, stress_pa=[700.0], fit_limit_pa=1e4
    )
    (soil,) = found["soils"]
    assert soil["power_law"]["b"] == pytest.approx(-0.05, abs=1e-9)
    psi = 4.4482216152605 / 0.0254**2
    assert soil["power_law"]["a_deg_at_1_psi"] == pytest.approx(40.0 * (psi / 1000.0) ** -0.05, rel=1e-9)
    file = soilctl.shear(DATA / "direct_shear.csv", soils=["nevada_fine"])
    assert [one["soil"] for one in file["soils"]] == ["nevada_fine"]
    # One is not several letters, nor several numbers.
    for one in (700, 700.0, np.float64(700.0), np.array(700.0), [700.0]):
        assert soilctl.shear(DATA / "direct_shear.csv", soils="nevada_fine", stress_pa=one)["soils"][0]["soil"] == "nevada_fine"
    for bad in ("700", ["x"], None, [None]):
        with pytest.raises(soilctl.InputTypeError, match="stress_pa"):
            soilctl.shear(DATA / "direct_shear.csv", stress_pa=bad)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ({"normal_stress_pa": [1.0, 2.0], "friction_angle_deg": [30.0]}, "length"),
        ({"normal_stress_pa": [1.0, np.nan, 3.0], "friction_angle_deg": [30.0, 31.0, 32.0]}, "line 3"),
        ({"normal_stress_pa": [], "friction_angle_deg": []}, ""),
        ({"friction_angle_deg": [30.0]}, "normal_stress"),
    ],
)
def test_bad_points_are_refused(points, words):
    with pytest.raises(soilctl.InputError) as caught:
        soilctl.shear(points)
    assert words in str(caught.value)
    with pytest.raises(soilctl.InputTypeError):
        soilctl.shear([30.0, 31.0])
