"""`soilctl tool --width`, against blocks built and measured here, and what a plate with ends has elsewhere."""

import json
import math

import numpy as np
import pytest
from conftest import DATA
from reference import GRAVITY_M_S2

DENSITY = 1600.0
GAMMA = DENSITY * GRAVITY_M_S2
PHI = math.radians(35)
SOIL = ["--phi", 35, "--density", DENSITY]
QUICK = ["--max-gap", 0.3, "--max-elements", 1000]
RANKINE = math.tan(math.pi / 4 + PHI / 2) ** 2


def tool(folder, text, name="tool.toml"):
    path = folder / name
    path.write_text(text)
    return path


def with_ends(soilctl, file, width_m, *words):
    return soilctl.json("tool", file, *SOIL, "--width", width_m, *QUICK, *words, code=None)


def one_block(depth_m, width_m, delta_deg, count=400):
    """
    Force in N of an upright plate that pushes one block ahead, least over its direction; the soil behind stays.

    The block is all that lies in a cone of half-angle phi about its velocity from some point of the plate, so that it separates from the rest at phi
    or more. How far it reaches beyond the plate's end is measured point by point.
    """
    delta = math.radians(delta_deg)
    best = math.inf
    for heading in np.linspace(0.02, math.pi / 2 - max(PHI, delta) - 0.02, 40):
        # Its lower boundary leaves the tip at heading - phi from the level, and must come out of the ground.
        lowest = heading - PHI
        if lowest <= 0.05:
            continue
        length = depth_m / math.tan(lowest)
        step = [length / count, depth_m / 200]
        x = (np.arange(count) + 0.5) * step[0]
        z = -(np.arange(200) + 0.5) * step[1]
        x, z = np.meshgrid(x, z)
        reach = np.full(x.shape, -1.0)
        for start in np.linspace(-depth_m, 0, 41):
            ahead = x * math.cos(heading) + (z - start) * math.sin(heading)
            off = -x * math.sin(heading) + (z - start) * math.cos(heading)
            square = (ahead * math.tan(PHI)) ** 2 - off**2
            inside = (ahead > 0) & (square >= 0)
            reach[inside] = np.maximum(reach[inside], np.sqrt(square[inside]))
        volume = np.sum((reach >= 0) * (width_m + 2 * np.maximum(reach, 0))) * step[0] * step[1]
        speed = math.cos(delta) / math.cos(heading + delta)
        best = min(best, GAMMA * volume * speed * math.sin(heading))
    return best


@pytest.mark.parametrize("delta", [0, 20])
def test_an_upright_plate_with_ends(soilctl, delta):
    answer = with_ends(soilctl, DATA / "tools/plate.toml", 0.3, "--delta", delta)
    ends = answer["ends"]
    assert ends["front"] is None and not ends["side_plates"]
    # The same blocks as those of the model, whose polyhedra only rounding separates from what is proven.
    words = ["--model", "blocks-3d", "--alpha", 90, "--delta", delta, *SOIL, "--depth", 0.1, "--width", 0.3]
    assert answer["slant_upper"] == pytest.approx(soilctl.json("predict", *words)["k_net"], rel=1e-5)
    hand = one_block(0.1, 0.3, delta)
    assert ends["lower_n"] <= ends["upper_n"] <= 1.01 * hand
    assert answer["lower_n_per_m"] == pytest.approx(ends["lower_n"] / 0.3)
    if delta == 0:
        # In plane strain it is Rankine's, and with ends no less.
        exact = 0.5 * GAMMA * 0.1**2 * (RANKINE - 1 / RANKINE)
        assert ends["lower_n"] <= 0.3 * exact <= ends["upper_n"]
        assert ends["lower_n"] >= 0.95 * 0.3 * exact


@pytest.fixture(scope="module")
def bucket(soilctl, tmp_path_factory):
    """The folder and the answers of the bucket at two widths."""
    folder = tmp_path_factory.mktemp("ends")
    file = tool(folder, "points_m = [[0.06, 0], [0, 0], [0, 0.1]]\ndelta_deg = 20\nside_plates = true\n")
    save = ["--save", folder / "proof.json", "--report", folder / "page.html"]
    return folder, with_ends(soilctl, file, 0.3, *save), with_ends(soilctl, file, 0.6)


def test_a_bucket_lies_behind_a_front(bucket, validate):
    answer = bucket[1]
    validate(answer)
    ends = answer["ends"]
    assert ends["side_plates"] and ends["lower_n"] < ends["upper_n"]
    # Whoever chooses an upright front at its tip has soil dragged along 60 mm, that widens to both sides and downwards at phi.
    drag = 0.06 * math.tan(PHI)
    hand = one_block(0.1 + drag, 0.3 + 2 * drag, 35)
    assert ends["lower_n"] <= ends["upper_n"] <= 1.01 * hand
    front = ends["front"]
    assert front["depth_m"] > 0.1 and front["width_m"] > 0.3
    # No less than a smooth plate of its depth in plane strain.
    assert ends["upper_n"] >= 0.3 * 0.5 * GAMMA * 0.1**2 * (RANKINE - 1 / RANKINE)


def test_wider_buckets_need_more_but_less_for_each_metre(bucket):
    narrow, wide = bucket[1], bucket[2]
    assert narrow["ends"]["upper_n"] < wide["ends"]["upper_n"]
    assert narrow["upper_n_per_m"] > wide["upper_n_per_m"]
    assert wide["lower_n_per_m"] == pytest.approx(narrow["lower_n_per_m"], rel=1e-9)


def test_both_proofs_are_saved(bucket, soilctl):
    folder, answer, _ = bucket
    found = [soilctl.json("certify", folder / name) for name in ("proof.json", "proof.front.json")]
    assert all(one["certified"] for one in found)
    assert found[0]["upper"] is None and found[1]["lower"] is None
    assert "that the tool does is not part of this file" in found[1]["description"]
    units = [json.loads((folder / name).read_text())["scale"] for name in ("proof.json", "proof.front.json")]
    newtons = [one["length_m"] ** 2 * one["unit_weight_n_per_m3"] for one in units]
    ends = answer["ends"]
    assert found[0]["lower"]["proven"] * newtons[0] * 0.3 == pytest.approx(ends["lower_n"], rel=1e-9)
    upper = found[1]["upper"]["proven"] * newtons[1] * ends["front"]["width_m"]
    assert upper == pytest.approx(ends["upper_n"], rel=1e-9)


def test_larger_side_plates_hold_more_soil(soilctl, tmp_path, bucket):
    text = "points_m = [[0.06, 0], [0, 0], [0, 0.1]]\ndelta_deg = 20\nside_plates_m = [[0.12, 0], [-0.05, 0], [-0.05, 0.2]]\n"
    answer = with_ends(soilctl, tool(tmp_path, text), 0.3)
    assert answer["ends"]["upper_n"] > bucket[1]["ends"]["upper_n"]
    assert answer["ends"]["lower_n"] == pytest.approx(bucket[1]["ends"]["lower_n"], rel=1e-9)


@pytest.mark.parametrize("seed", range(1))
def test_brackets_of_random_tools_are_brackets(soilctl, tmp_path, seed):
    random = np.random.default_rng(seed)
    steps = np.stack([-random.uniform(-0.02, 0.05, 3), random.uniform(0.01, 0.05, 3)], axis=1)
    points = np.vstack([[0, 0], np.cumsum(steps, axis=0)]).round(4).tolist()
    phi = round(float(random.uniform(20, 42)), 1)
    words = ["--phi", phi, "--delta", round(0.5 * phi, 1), "--density", DENSITY, "--width", 0.2]
    answer = soilctl.json("tool", tool(tmp_path, f"points_m = {points}"), *words, *QUICK, code=None)
    assert answer["ends"]["lower_n"] < answer["ends"]["upper_n"]
    assert answer["ends"]["plane_lower_n_per_m"] <= answer["ends"]["plane_upper_n_per_m"]


def test_what_is_refused_and_noted(soilctl, tmp_path):
    plate = DATA / "tools/plate.toml"
    words = [*SOIL, "--delta", 20, "--width", 0.2]
    for more, text in [(["--cohesion", 100], "--cohesion is 100 Pa"), (["--beta", 5], "--beta is 5 deg"),
                       (["--direction", 10], "--direction is 10 deg"), (["--surcharge", 9], "--surcharge is 9 Pa")]:
        soilctl.refuses("tool", plate, *words, *more, mentions=[text, "--width"])
    soilctl.refuses("tool", plate, *SOIL, "--delta", 20, "--width", 0, mentions=["width"])
    sided = tool(tmp_path, "points_m = [[0, 0], [0, 0.1]]\nside_plates_m = [[0, 0], [0.05, 0], [0, 0.1]]")
    answer = soilctl.json("tool", sided, *SOIL, "--delta", 20, *QUICK, code=None)
    assert answer["ends"] is None and any("side plates are left out" in note for note in answer["notes"])
