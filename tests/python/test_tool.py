"""`soilctl tool` and `obstacle`, against wedges computed here: any wedge that may move bounds the force from above, whoever computes it."""

import csv
import json
import math
import tomllib

import numpy as np
import pytest
from conftest import DATA
from reference import GRAVITY_M_S2, coulomb_k_depth

DENSITY = 1600.0
SOIL = ["--phi", 35, "--density", DENSITY]
QUICK = ["--max-gap", 0.05, "--max-elements", 2000]
PHI = math.radians(35)
RANKINE = math.tan(math.pi / 4 + PHI / 2) ** 2


def half_weight(length_m):
    """1/2 gamma L^2 in N/m."""
    return 0.5 * DENSITY * GRAVITY_M_S2 * length_m**2


def along(alpha_deg, delta_deg, depth_m):
    """Passive and active forces of a plate along the level, by Coulomb, in N/m."""
    factor = half_weight(depth_m) * math.sin(math.radians(alpha_deg + delta_deg))
    return [factor * float(k) for k in coulomb_k_depth(alpha_deg, 35, delta_deg)]


def written(folder, text, name="tool.toml"):
    path = folder / name
    path.write_text(text)
    return path


def bounds(answer):
    return answer["lower_n_per_m"], answer["upper_n_per_m"]


@pytest.fixture(scope="module")
def bucket(soilctl, tmp_path_factory):
    """The folder and the answer of a bucket with a smooth bottom, with all its files."""
    folder = tmp_path_factory.mktemp("bucket")
    tool = written(folder, "points_m = [[0.06, 0], [0, 0], [0, 0.1]]\npiece = [{ number = 1, delta_deg = 0 }]\n")
    files = ["--save", "proof.json", "--problem", "problem.toml", "--report", "page.html", "--plot", "plot.svg"]
    answer = soilctl.json("tool", tool, *SOIL, "--delta", 20, *QUICK, *files, cwd=folder, code=None)
    return folder, answer


def test_a_bucket_needs_no_more_than_with_the_soil_in_it_as_a_wedge_that_moves_along(bucket):
    lower, upper = bounds(bucket[1])
    # Ahead of the soil in the bucket, soil on soil; behind its back a wedge follows; its smooth bottom slides.
    passive = along(math.degrees(math.atan2(0.1, 0.06)), 35, 0.1)[0]
    active = along(90, 20, 0.1)[1]
    assert 0 < lower < upper
    assert lower <= passive - active


def test_the_answer_follows_its_schema_and_is_proven(bucket, soilctl, validate):
    folder, answer = bucket
    validate(answer)
    tool = answer["tool"]
    assert tool["chord_m"] == pytest.approx(math.hypot(0.1, 0.06)) and tool["depth_m"] == pytest.approx(0.1)
    assert [piece["delta_deg"] for piece in tool["pieces"]] == [0, 20]
    assert answer["slant_lower"] is None
    assert answer["coefficient_lower"] == pytest.approx(answer["lower_n_per_m"] / half_weight(tool["chord_m"]))
    proof = soilctl.json("certify", folder / "proof.json")
    scale = json.loads((folder / "proof.json").read_text())["scale"]
    newtons = scale["length_m"] ** 2 * scale["unit_weight_n_per_m3"]
    assert [proof[key]["proven"] * newtons for key in ("lower", "upper")] == pytest.approx(bounds(answer), rel=1e-9)
    assert all((folder / name).stat().st_size > 0 for name in answer["results"]["files"])


def test_the_problem_file_is_the_same_problem(bucket, soilctl):
    folder, answer = bucket
    problem = tomllib.loads((folder / "problem.toml").read_text())
    assert problem["objective"]["name"] == "tool" and len(problem["plate"]) == 2
    solved = soilctl.json("solve", folder / "problem.toml", *QUICK, code=None)
    assert [1e3 * solved[key] for key in ("lower", "upper")] == pytest.approx(bounds(answer), rel=1e-12)


@pytest.mark.parametrize(("alpha", "beta"), [(60, 0), (75, 10)])
def test_a_flat_tool_in_two_pieces_is_the_plate_of_bound(soilctl, tmp_path, alpha, beta):
    tool = written(tmp_path, "points_m = [[0, 0], [0, 0.04], [0, 0.1]]")
    words = ["--alpha", alpha, "--delta", 20, "--phi", 35, "--beta", beta, *QUICK]
    answer = soilctl.json("tool", tool, *words, "--density", DENSITY, code=None)
    plate = soilctl.json("bound", *words, code=None)
    assert answer["slant_lower"] <= plate["upper"] and plate["lower"] <= answer["slant_upper"]
    assert answer["tool"]["chord_alpha_deg"] == pytest.approx(alpha)
    # Each is as near to the other as its own gap allows.
    middle = [sum(x) / 2 for x in ((answer["slant_lower"], answer["slant_upper"]), (plate["lower"], plate["upper"]))]
    assert middle[0] == pytest.approx(middle[1], rel=0.05)


def test_a_smooth_upright_blade_is_rankines(soilctl):
    answer = soilctl.json("tool", DATA / "tools/plate.toml", *SOIL, "--delta", 0, *QUICK, code=None)
    exact = half_weight(0.1) * (RANKINE - 1 / RANKINE)
    lower, upper = bounds(answer)
    assert lower <= exact * (1 + 1e-12) and upper >= exact * (1 - 1e-12)
    assert answer["coefficient_lower"] == pytest.approx(answer["slant_lower"])


def test_a_piece_as_rough_as_the_soil_takes_nothing(soilctl, tmp_path):
    # Where the soil would shear, it shears along the new piece as hard as before.
    leg = written(tmp_path, "points_m = [[0, 0], [0, 0.1]]", "leg.toml")
    shoe = written(tmp_path, "points_m = [[0.04, 0], [0, 0], [0, 0.1]]", "shoe.toml")
    rough = [*SOIL, "--delta", 35, *QUICK]
    assert bounds(soilctl.json("tool", shoe, *rough, code=None))[1] >= bounds(soilctl.json("tool", leg, *rough, code=None))[0]


def test_a_buried_blade_needs_no_more_than_one_that_reaches_the_surface(soilctl):
    answer = soilctl.json("tool", DATA / "tools/plate.toml", *SOIL, "--delta", 35, "--depth", 0.15, *QUICK, code=None)
    assert answer["tool"]["cover_m"] == pytest.approx(0.05) and answer["slant_lower"] is None
    passive, active = along(90, 35, 0.15)
    assert 0 < answer["lower_n_per_m"] <= passive - active


def test_what_is_refused(soilctl, tmp_path):
    plates = written(tmp_path, "points_m = [[0, 0], [0, 1]]\nside_plates_m = [[0, 0], [1, 0]]")
    soilctl.refuses("tool", plates, *SOIL, "--delta", 20, mentions=["it has 2 side_plates_m"])
    plate = DATA / "tools/plate.toml"
    soilctl.refuses("tool", plate, *SOIL, mentions=["--delta"])
    soilctl.refuses("tool", plate, *SOIL, "--delta", 40, mentions=["more than that of the soil"])
    soilctl.refuses("tool", plate, *SOIL, "--delta", 20, "--problem", tmp_path / "a.json", mentions=[".toml"])
    soilctl.refuses("tool", plate, "--phi", 35, "--density", -1, "--delta", 20, mentions=["density"])
    near = ["--body-top", 0.02, "--body-height", 0.05]
    soilctl.refuses("obstacle", plate, *SOIL, "--delta", 0, *near, "--ahead", 0, mentions=["--ahead is 0 m"])
    soilctl.refuses("obstacle", plate, *SOIL, "--delta", 0, "--alpha", 120, *near, "--ahead", 0.02, mentions=["meets the tool"])


@pytest.mark.parametrize("name", ["plate.toml", "blade.toml", "bucket.toml", "moldboard.csv"])
def test_examples_are_tools(soilctl, name):
    answer = soilctl.json("tool", DATA / "tools" / name, *SOIL, "--delta", 20, "--max-gap", 0.3, "--max-elements", 1500, code=None)
    assert answer["certified"] and 0 < answer["lower_n_per_m"] < answer["upper_n_per_m"]


def wedge(depth_m, theta, delta_deg):
    """Force of an upright plate that moves the soil above a plane, N/m along the level, less what follows it: an upper bound for any plane that may slip."""
    delta = math.radians(delta_deg)
    push = half_weight(depth_m) / math.tan(theta) * math.sin(theta + PHI) / math.cos(theta + PHI + delta) * math.cos(delta)
    return push - along(90, delta_deg, depth_m)[1]


@pytest.fixture(scope="module")
def rock(soilctl, tmp_path_factory):
    """A fixed block ahead of an upright plate."""
    folder = tmp_path_factory.mktemp("rock")
    words = ["--delta", 15, "--body-top", 0.03, "--body-height", 0.2, "--ahead", "0.1,0.3"]
    files = ["--table", "table.csv", "--save", "proof.json", "--plot", "plot.svg", "--report", "page.html"]
    answer = soilctl.json("obstacle", DATA / "tools/plate.toml", *SOIL, *words, *QUICK, *files, cwd=folder, code=None)
    return folder, answer


def test_near_a_fixed_body_the_force_is_between_that_without_and_the_wedge_that_passes_it(rock, validate):
    answer = rock[1]
    validate(answer)
    passive, active = along(90, 15, 0.1)
    assert answer["without_lower_n_per_m"] <= passive - active
    for one in answer["distances"]:
        # Planes from the tip that pass above the body: it is in soil that stays.
        flattest = math.atan((0.1 - 0.03) / one["ahead_m"])
        angles = np.linspace(max(flattest, 0.01), math.pi / 2 - PHI - math.radians(15) - 1e-3, 2000)
        passing = min(wedge(0.1, theta, 15) for theta in angles)
        assert answer["without_lower_n_per_m"] <= one["lower_n_per_m"] <= passing * (1 + 1e-12)
        assert one["ratio_lower"] >= 1
    near, far = answer["distances"]
    assert near["ratio_lower"] > 1.1 and far["ratio_upper"] < 1.1
    assert answer["answer"] == "shows" and (answer["shows_to_m"], answer["hidden_from_m"]) == (0.1, 0.3)


def test_its_table_and_its_proofs_say_the_same(rock, soilctl):
    folder, answer = rock
    rows = list(csv.DictReader((folder / "table.csv").read_text().splitlines()))
    assert [float(row["ratio_upper"]) for row in rows] == [one["ratio_upper"] for one in answer["distances"]]
    for name in ("without", "1", "2"):
        assert soilctl.json("certify", folder / f"proof.{name}.json")["certified"]
    assert (folder / "plot.svg").stat().st_size > 0 and "<svg" in (folder / "page.html").read_text()


def test_a_body_below_all_that_moves_is_not_felt(soilctl):
    words = ["--delta", 15, "--body-top", 0.11, "--body-height", 0.05, "--ahead", 0.02, "--body-length", 0.3]
    answer = soilctl.json("obstacle", DATA / "tools/plate.toml", *SOIL, *words, *QUICK, code=None)
    only = answer["distances"][0]
    # Coulomb's wedge comes out of the ground without passing it.
    passive, active = along(90, 15, 0.1)
    assert answer["without_lower_n_per_m"] <= only["lower_n_per_m"] <= passive - active
    assert answer["answer"] == "hidden"


def test_a_stone_resists_no_more_than_a_fixed_body_and_no_less_than_soil(soilctl, rock):
    words = ["--delta", 15, "--body-top", 0.03, "--body-height", 0.2, "--ahead", 0.1, "--body", "stone"]
    answer = soilctl.json("obstacle", DATA / "tools/plate.toml", *SOIL, *words, *QUICK, code=None)
    stone, fixed = answer["distances"][0], rock[1]["distances"][0]
    assert stone["lower_n_per_m"] <= fixed["upper_n_per_m"]
    assert stone["upper_n_per_m"] >= answer["without_lower_n_per_m"]
    assert answer["stone_cohesion_pa"] == pytest.approx(100 * DENSITY * GRAVITY_M_S2 * 0.23)


def test_predict_takes_tools_too(soilctl):
    words = [*SOIL, "--delta", 0]
    tool = DATA / "tools/plate.toml"
    [one, other] = [soilctl.json(*verb, *words, code=None) for verb in (("predict", "--tool", tool), ("tool", tool))]
    assert bounds(one) == bounds(other)
    soilctl.refuses("predict", "--tool", tool, "--phi", 35, mentions=["--density"])
