"""`soilctl process` on bags of other arms, made by a generator that shares nothing with it: right, or refused for the right reason."""

import csv
import dataclasses
import json

import pytest
from conftest import DATA
from foreign import bags, example, score


BASE = bags.Case(seed=5, strokes=3, noise=0.1, wrench_hz=500.0, force=(5.0, 30.0), tool_n=3.0)


@pytest.fixture(scope="module")
def made():
    """One bag of three strokes for each arm; what goes wrong is chosen when it is written."""
    known = {}

    def get(arm, seed=5):
        if (arm, seed) not in known:
            known[arm, seed] = bags.make(dataclasses.replace(BASE, arm=arm, seed=seed))
        return known[arm, seed]

    return get


def run(soilctl, tmp_path, bag, *more, container="mcap-zstd", trouble=(), name="bag"):
    bag.case = dataclasses.replace(bag.case, container=container, trouble=trouble)
    path = bags.write(bag, tmp_path, name)
    done = soilctl("process", path, *map(str, score.options(bag, path)), *map(str, more), "--format", "json", "--quiet")
    return done, json.loads(done.stdout) if done.stdout else None


def reasons(answer):
    return [contact["reason"] or "" for contact in answer["logs"][0]["found"]["contacts"]]


@pytest.mark.parametrize("seed", [2, 7, 12, 19, 33])
def test_strokes_of_any_arm_are_found_and_weighed(soilctl, tmp_path, seed):
    bag = bags.make(bags.any_case(seed))
    done, answer = run(soilctl, tmp_path, bag, container=bag.case.container, trouble=bag.case.trouble)
    assert answer, done.stderr
    pairs, invented = score.match(bag, answer)
    assert not invented
    assert all(pair.is_right for pair in pairs), [(pair.truth, pair.row) for pair in pairs if not pair.is_right]
    assert all(abs(pair.sds) < 4 for pair in pairs)


@pytest.mark.parametrize("container", ["mcap-lz4", "mcap-none", "mcap-plain", "db3", "ros1-", "ros1-lz4", "ros1-bz2"])
def test_every_container_gives_the_same_strokes(soilctl, tmp_path, made, container):
    bag = made("gantry")
    _, expected = run(soilctl, tmp_path, bag, name="expected")
    done, answer = run(soilctl, tmp_path, bag, container=container)
    assert answer, done.stderr
    same = ["force_n", "force_sd_n", "depth_m", "alpha_deg", "failure_time_s", "flags"]
    assert [[row[key] for key in same] for row in answer["strokes"]] == [[row[key] for key in same] for row in expected["strokes"]]
    assert len(answer["strokes"]) == 3


def test_free_air_tells_noise_weight_and_drift(soilctl, tmp_path, made):
    bag = made("seven")
    _, answer = run(soilctl, tmp_path, bag)
    air = answer["logs"][0]["found"]["free_air"]
    assert air["noise"]["sd"][:3] == pytest.approx([0.1] * 3, rel=0.05)
    assert air["noise"]["corner_hz"] is None
    assert abs(air["weight_n"] - 3.0) < 3 * air["weight_sd_n"] < 0.1
    assert air["centre_m"] == pytest.approx(bag.case.tool_at, abs=1e-3)
    drift = sum(part**2 for part in air["drift_n_per_s"]) ** 0.5
    assert drift == pytest.approx(bag.case.drift, abs=3 * max(air["drift_sd_n_per_s"]) + 2e-4)


def test_one_posture_is_said_and_does_no_harm_where_it_stays(soilctl, tmp_path, made):
    bag = made("gantry")
    done, answer = run(soilctl, tmp_path, bag)
    air = answer["logs"][0]["found"]["free_air"]
    assert air["postures_deg"] < 0.1 and air["weight_sd_n"] > 10
    assert done.returncode == 0 and len(answer["strokes"]) == 3
    words = soilctl("process", tmp_path / "bag.mcap", *map(str, score.options(bag, tmp_path / "bag.mcap")), "--quiet")
    assert "one posture" in words.stdout and "free air" in words.stdout


@pytest.mark.parametrize("wall", [False, True])
def test_windows_may_begin_in_air_or_seated(soilctl, tmp_path, made, wall):
    bag = made("hung")
    origin = int(bag.case.wall_s)
    starts = [bag.contacts[0][0] - 2.0, bag.truth[1].start_s - 0.5, bag.truth[2].start_s + 0.1]
    ends = [bag.contacts[0][1] + 0.3, bag.truth[1].end_s + 0.5, bag.truth[2].end_s]
    with open(tmp_path / "windows.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["start", "end"])
        table.writerows([[start + origin * wall, end + origin * wall] for start, end in zip(starts, ends)])
    done, answer = run(soilctl, tmp_path, bag, "--strokes", tmp_path / "windows.csv")
    assert done.returncode == 0, done.stderr
    pairs, invented = score.match(bag, answer)
    assert not invented and all(pair.is_right for pair in pairs)


@pytest.mark.parametrize(
    ("trouble", "exit_code", "words"),
    [
        ("clipped", 3, "end of their range"),
        ("sign", 3, "pushes the plate ahead"),
        ("no_air", 3, "free air"),
        ("dead", 2, "the same"),
        ("degrees", 2, "degrees"),
        ("slow", 2, "record faster"),
        ("joint_missing", 2, "lbr_a2"),
    ],
)
def test_what_cannot_be_weighed_is_refused_with_its_reason(soilctl, tmp_path, made, trouble, exit_code, words):
    done, answer = run(soilctl, tmp_path, made("seven"), trouble=(trouble,))
    assert done.returncode == exit_code, done.stderr
    if exit_code == 2:
        assert words in done.stderr and answer is None
    else:
        assert answer["strokes"] == []
        assert all(words in reason for reason in reasons(answer)), reasons(answer)


def test_wrenches_of_the_plate_on_the_soil_change_their_sign(soilctl, tmp_path, made):
    bag = made("gantry")
    done, answer = run(soilctl, tmp_path, bag, "--wrench-sense", "plate-on-soil", trouble=("sign",))
    assert done.returncode == 0, done.stderr
    pairs, invented = score.match(bag, answer)
    assert not invented and all(pair.is_right for pair in pairs)
    # A tare has the sign that its sensor has.
    forces = []
    for sign, more, trouble in [(1, [], ()), (-1, ["--wrench-sense", "plate-on-soil"], ("sign",))]:
        tare = ",".join(str(sign * mean) for mean in bag.wrench[:500].mean(0))
        _, answer = run(soilctl, tmp_path, bag, f"--tare={tare}", *more, trouble=trouble)
        forces.append([row["force_n"] for row in answer["strokes"]])
        # It does not drift as the sensor does; how far it is off by then is part of what is stated.
        pairs, invented = score.match(bag, answer)
        assert not invented and len(forces[-1]) == 3
        assert all(abs(pair.sds) < 3 for pair in pairs), [(pair.truth, pair.row) for pair in pairs]
    assert forces[0] == pytest.approx(forces[1], rel=1e-9)


def test_a_tare_that_free_air_contradicts_is_refused(soilctl, tmp_path, made):
    bag = made("gantry")
    tare = bag.wrench[:500].mean(0) + [20, 0, 0, 0, 0, 0]
    done, answer = run(soilctl, tmp_path, bag, "--tare=" + ",".join(map(str, tare)))
    assert done.returncode == 3 and any("--tare lies that far" in reason for reason in reasons(answer)), reasons(answer)


def test_the_example_leads_from_a_bag_to_its_soil(soilctl, tmp_path):
    folder, table = DATA / "other_arm", tmp_path / "strokes.csv"
    options = ["--plate-frame", "blade_edge", "--surface-z", 0.08, "--width", example.WIDTH, "--out", table]
    found = soilctl.json("process", folder / "bag", "--urdf", folder / "arm.urdf", *options)
    rows = found["strokes"]
    assert sorted(row["alpha_deg"] for row in rows) == sorted(example.ALPHAS * example.REPEATS)
    for row in rows:
        assert row["force_n"] == pytest.approx(example.force_n(row["alpha_deg"]), rel=0.06)
        assert row["depth_m"] == pytest.approx(example.DEPTH, abs=1e-4) and row["flags"] == ""
        assert row["batch"] == "bag"  # Nobody prepared the soil anew while it was recorded.
    assert [group["strokes"] for group in found["analysis"]["groups"]] == [example.REPEATS] * len(example.ALPHAS)


@pytest.mark.parametrize(("by", "words"), [(0.3, "never above the surface"), (-0.2, "above the surface as given")])
def test_a_wrong_surface_is_told(soilctl, tmp_path, made, by, words):
    bag = made("seven")
    right = bag.arm.surface_z
    try:
        bag.arm.surface_z = right + by
        done, answer = run(soilctl, tmp_path, bag)
    finally:
        bag.arm.surface_z = right
    assert done.returncode in (1, 3) and answer["strokes"] == []
    assert all(words in reason for reason in reasons(answer))


def test_a_gap_while_the_force_rises_is_flagged(soilctl, tmp_path, made):
    done, answer = run(soilctl, tmp_path, made("gantry"), trouble=("hole",))
    assert done.returncode == 3
    assert answer["strokes"] and all("gap" in row["flags"] for row in answer["strokes"])


@pytest.mark.parametrize("level", [False, True])
def test_a_press_is_no_stroke(soilctl, tmp_path, level):
    bag = bags.press(seed=3, level=level)
    done, answer = run(soilctl, tmp_path, bag)
    assert done.returncode == 1, done.stderr
    found = answer["logs"][0]["found"]
    assert answer["strokes"] == [] and len(found["contacts"]) == 1
    if level:
        # It moves, but the force falls only while it stands still.
        assert found["contacts"][0]["kind"] == "no_failure"
        return
    contact = found["contacts"][0]
    assert "nothing travelled" in contact["reason"] and "along the ground" in contact["reason"]
    # It touches the soil 15 cm on its way down at 1 cm/s from 8 s on.
    assert contact["from_s"] == pytest.approx(23.0, abs=0.2)
    tare = found["free_air"]["bias"]
    assert tare[0] == pytest.approx(bag.case.bias[0], abs=0.03) and tare[1] == pytest.approx(bag.case.bias[1], abs=0.03)
    assert any("without joint states" in words for words in answer["logs"][0]["unusable"])
