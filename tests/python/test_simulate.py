"""`soilctl simulate`: whole campaigns on the simulated arm."""

import json

import pytest

PLAN = """
version = 1
design = "two tool angles"
soil = "ticino_loose"
model = "chen"

[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = -15.0, alpha_deg = 80.0, depth_m = 0.012, delta_set_deg = 23.0 }]

[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = 15.0, alpha_deg = 90.0, depth_m = 0.012, delta_set_deg = 23.0 }]
"""


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "plan.toml"
    path.write_text(PLAN, encoding="utf-8")
    return path


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_threads_and_resuming_change_no_byte(soilctl, plan, tmp_path):
    one, two = tmp_path / "one", tmp_path / "two"
    done = soilctl("simulate", plan, "--out", one, "--seed", 3, "--threads", 1, "--format", "json", code=0)
    answer = json.loads(done.stdout)
    assert answer["schema"] == "soilctl.simulate/1"
    assert answer["complete"] and answer["strokes_done"] == answer["strokes"] == 2
    assert "batch 1 of 2" in done.stderr
    soilctl("simulate", plan, "--out", two, "--seed", 3, "--threads", 2, "--quiet", code=0)
    assert contents(one) == contents(two)
    # A tenth of a degree at the shoulder, with what the elbow's angle follows, is 1.7 mm at the plate.
    instrument = json.loads((one / "campaign.json").read_text(encoding="utf-8"))["instrument"]
    assert 0.0015 < instrument["encoder_step_m"] < 0.002

    before = contents(one)
    (one / "batch_001.mcap").unlink()
    again = soilctl("simulate", plan, "--out", one, "--seed", 3, "--format", "json", code=0)
    assert json.loads(again.stdout)["resumed_batches"] == 1
    assert contents(one) == before

    log = one / "batch_000.mcap"
    soilctl("log", "doctor", log, code=0)
    assert json.loads(soilctl("replay", log, "--format", "json", code=0).stdout)["identical"]
    refused = soilctl("simulate", plan, "--out", one, "--seed", 4, code=2)
    assert "another seed" in refused.stderr


def test_what_is_refused(soilctl, plan, tmp_path):
    plan.write_text(PLAN.replace("ticino_loose", "ticino"), encoding="utf-8")
    assert "there is no soil `ticino`" in soilctl("simulate", plan, "--out", tmp_path / "x", code=2).stderr
    assert not (tmp_path / "x").exists()
    plan.write_text(PLAN.replace("depth_m = 0.012", "depth_m = 0.9"), encoding="utf-8")
    assert "stroke 1 cannot be reached" in soilctl("simulate", plan, "--out", tmp_path / "x", code=2).stderr
