"""`soilctl tool --forces`: forces that the soil bears on a tool, against Rankine, Coulomb, mirrors, and each against all others."""

import math

import numpy as np
import pytest
from conftest import DATA
from reference import GRAVITY_M_S2, coulomb_k_depth

DENSITY = 1600.0
PLATE = DATA / "tools/plate.toml"
HALF_WEIGHT = 0.5 * DENSITY * GRAVITY_M_S2 * 0.1**2
SOIL = ["--phi", 35, "--density", DENSITY]
QUICK = ["--max-gap", 0.3, "--max-elements", 1000]
RANKINE = math.tan(math.radians(62.5)) ** 2


@pytest.fixture(scope="module")
def rough(soilctl, tmp_path_factory):
    """The folder and the answer of a rough upright plate, with all its files."""
    folder = tmp_path_factory.mktemp("forces")
    files = ["--save", "proof.json", "--forces-plot", "plot.svg", "--report", "page.html"]
    return folder, soilctl.json("tool", PLATE, *SOIL, "--delta", 20, "--forces", 6, *QUICK, *files, cwd=folder, code=None)


def direction(one):
    angle = math.radians(one["direction_deg"])
    return np.array([math.cos(angle), math.sin(angle)])


def test_a_smooth_plate_bears_rankines_force_and_none_along_itself(soilctl):
    answer = soilctl.json("tool", PLATE, *SOIL, "--delta", 0, "--forces", 4, *QUICK, code=None)
    exact = HALF_WEIGHT * (RANKINE - 1 / RANKINE)
    ahead, up, back, down = answer["forces"]["directions"]
    for one in (ahead, back):
        assert one["lower_n_per_m"] <= exact * (1 + 1e-9) and one["upper_n_per_m"] >= exact * (1 - 1e-9)
    for one in (up, down):
        assert abs(one["lower_n_per_m"]) < 1e-9 and 0 <= one["upper_n_per_m"] < 0.01 * exact
    for x, z in answer["forces"]["safe_n_per_m"]:
        assert abs(x) <= exact * (1 + 1e-9) and abs(z) < 1e-9


def test_no_safe_force_is_beyond_the_limit_of_any_direction(rough, validate):
    answer = rough[1]
    validate(answer)
    directions = answer["forces"]["directions"]
    for one in directions:
        force = np.array(one["force_n_per_m"])
        # The field was made for this direction, and found to bear this much along it.
        assert force @ direction(one) == pytest.approx(one["lower_n_per_m"], rel=1e-9)
        # Other directions were solved on other meshes by other programs.
        for other in directions:
            assert force @ direction(other) <= other["upper_n_per_m"]
    limit = np.array(answer["forces"]["limit_n_per_m"])
    assert np.max(limit[:, 0]) == pytest.approx(directions[0]["upper_n_per_m"], rel=1e-6)


def test_an_upright_plate_is_its_own_mirror(rough):
    directions = rough[1]["forces"]["directions"]
    for a, b in [(0, 3), (1, 2), (5, 4)]:
        one, other = directions[a], directions[b]
        assert one["lower_n_per_m"] <= other["upper_n_per_m"] and other["lower_n_per_m"] <= one["upper_n_per_m"]


def test_pushed_ahead_it_is_below_coulombs_wedges_and_what_tool_says(rough):
    answer = rough[1]
    ahead = answer["forces"]["directions"][0]
    passive, active = [HALF_WEIGHT * math.cos(math.radians(20)) * float(k) for k in coulomb_k_depth(90, 35, 20)]
    assert ahead["lower_n_per_m"] <= passive - active
    assert (ahead["lower_n_per_m"], ahead["upper_n_per_m"]) == (answer["lower_n_per_m"], answer["upper_n_per_m"])
    # Friction holds each face by tan(delta) times what presses on it at most; ahead that is no more than the passive force, behind it is what is left.
    level, upwards = ahead["force_n_per_m"]
    assert abs(upwards) <= math.tan(math.radians(20)) * (2 * passive - level)


def test_every_direction_has_its_proof(rough, soilctl):
    folder, answer = rough
    proof = soilctl.json("certify", folder / "proof.4.json")
    assert proof["certified"]
    bounded = next(said["says"] for said in proof["statement"] if said["of"] == "bounded")
    assert "-0.5" in bounded and "-0.866" in bounded
    assert (folder / "plot.svg").stat().st_size > 0 and "Forces in all directions" in (folder / "page.html").read_text()


def test_what_is_refused(soilctl):
    words = [*SOIL, "--delta", 20]
    soilctl.refuses("tool", PLATE, *words, "--forces", 8, "--direction", 10, mentions=["--direction is 10 deg"])
    soilctl.refuses("tool", PLATE, *words, "--forces", 8, "--width", 1, mentions=["--width"])
    soilctl.refuses("tool", PLATE, *words, "--forces", 2, mentions=["--forces"])
