"""Beams: footings under any load and walls that bend, against exact and published values that know nothing of this code."""

import math

import meshio
import pytest
from scipy.optimize import brentq

FOOTING = """
default_boundary = "free"
objective = {{kind = "load"}}
[[soil]]
name = "clay"
phi_deg = 0
cohesion_kpa = 10
unit_weight_kn_m3 = 0
{tension}
[[region]]
soil = "clay"
polygon = [[-6, -4], [6, -4], [6, 0], [-6, 0]]
[[boundary]]
kind = "fixed"
sides = ["left", "right", "bottom"]
[[boundary]]
kind = "load"
line = [[1, 0], [-1, 0]]
pressure_kpa = {pressure}
shear_kpa = {shear}
live = true
[[member]]
name = "footing"
line = [[-1, 0], [1, 0]]
moment_knm_per_m = 500
shear_kn_per_m = 1000
tensile_kn_per_m = 1000
compressive_kn_per_m = 1000
"""


def solved(soilctl, tmp_path, text, *more):
    file = tmp_path / "problem.toml"
    file.write_text(text)
    answer = soilctl.json("solve", file, *more)
    assert answer["certified"] is True and answer["lower"] <= answer["upper"]
    return answer


def footing(soilctl, tmp_path, pressure, shear=0.0, tension=""):
    text = FOOTING.format(pressure=pressure, shear=shear, tension=tension)
    return solved(soilctl, tmp_path, text, "--max-gap", "0.04", "--max-elements", "4000")


def test_leaning_loads_on_clay(soilctl):
    """Green (1954): V / (B c) = 1 + pi / 2 + acos(h) + sqrt(1 - h^2) with h = H / (B c)."""
    answer = soilctl.json("solve", "data/problems/footing_loads.toml", "--max-gap", "0.04", "--max-elements", "4000")
    cases = {case["name"]: case for case in answer["cases"]}
    for name, h in {"H/V 0": 0, "H/V 0.0626": 0.3, "H/V 0.1396": 0.6, "H/V 0.2603": 0.9}.items():
        v = 1 + math.pi / 2 + math.acos(h) + math.sqrt(1 - h * h)
        assert float(name.split()[1]) == pytest.approx(h / v, abs=1e-4)
        case = cases.pop(name)
        assert case["lower"] <= 10 * v * 1.001 and case["upper"] >= 10 * v * 0.999
        assert case["gap"] < 0.045
    # Off the middle nothing is borne that is not borne there.
    assert len(cases) == 3 and all(case["lower"] < answer["cases"][0]["upper"] for case in cases.values())


@pytest.mark.parametrize("eccentricity", [1 / 3, 0.2])
def test_eccentric_load_that_lifts_off(soilctl, tmp_path, eccentricity):
    """Meyerhof (1953): without tension the load is borne by a strip around it, V = (2 + pi) c (B - 2 e)."""
    p, slope = 1.0, 6 * eccentricity / 2
    answer = footing(soilctl, tmp_path, [p + slope, p - slope], tension="tension_kpa = 0.01")
    exact = (2 + math.pi) * 10 * (2 - 2 * eccentricity) / 2
    assert answer["lower"] <= exact * 1.002 and answer["upper"] >= exact * 0.999
    assert answer["gap"] < 0.06


WALL = """
default_boundary = "free"
objective = {{kind = "load"}}
[[soil]]
name = "sand"
phi_deg = 34
unit_weight_kn_m3 = 18
[[region]]
soil = "sand"
polygon = [[-8, -3], [-8, -9], [10, -9], [10, 0], [0, 0], [0, -3]]
[[boundary]]
kind = "fixed"
sides = ["bottom"]
[[boundary]]
kind = "smooth"
sides = ["left", "right"]
[[boundary]]
kind = "load"
line = [[10, 0], [0, 0]]
pressure_kpa = 10
live = true
[[member]]
name = "wall"
line = [[0, 0], [0, -7.5]]
moment_knm_per_m = {moment}
shear_kn_per_m = 1000
tensile_kn_per_m = 1000
compressive_kn_per_m = 1000
bond_factor = 0.001
"""


def hinged(moment, h=3.0, phi=34.0, gamma=18.0):
    """The load on the ground at which a smooth wall in sand bends, if it goes deep enough: exact, for above the hinge Rankine's pressures act
    in front and behind, and wedges that shear evenly go with a wall that turns about the hinge. That is where the shear force vanishes."""
    ka = math.tan(math.radians(45 - phi / 2)) ** 2
    kp = 1 / ka

    def greatest(q):
        x = brentq(lambda x: kp * gamma * x**2 / 2 - ka * (gamma * (h + x) ** 2 / 2 + q * (h + x)), 0.01, 50)
        return ka * (gamma * (h + x) ** 3 / 6 + q * (h + x) ** 2 / 2) - kp * gamma * x**3 / 6

    return brentq(lambda q: greatest(q) - moment, 0, 500)


@pytest.mark.parametrize("moment", [100, 150])
def test_a_smooth_wall_bends_at_its_moment(soilctl, tmp_path, moment):
    text = WALL.format(moment=moment)
    answer = solved(soilctl, tmp_path, text, "--max-gap", "0.15", "--max-elements", "6000", "--vtu", tmp_path / "wall.vtu")
    exact = hinged(moment) / 10
    # The faces are smooth but for a thousandth.
    assert answer["lower"] <= exact * 1.01 and answer["upper"] >= exact, (answer["lower"], exact, answer["upper"])
    assert answer["gap"] < 0.16
    (wall,) = answer["results"]["members"]
    bending = wall["bending"]
    assert abs(bending["greatest_moment"]) <= bending["moment_strength"] == pytest.approx(moment)
    assert bending["hinges"] and wall["utilisation"] > 0.95
    drawn = meshio.read(tmp_path / "wall.members.vtu")
    assert [block.type for block in drawn.cells] == ["line"]
    ends = drawn.points[drawn.cells[0].data]
    moments, shear = (drawn.point_data[name][drawn.cells[0].data] for name in ("moment", "shear_force"))
    assert ends[:, :, 0] == pytest.approx(0) and ends[0, 0, 1] == pytest.approx(0) and ends[-1, 1, 1] == pytest.approx(-7.5)
    assert abs(moments).max() <= moment and abs(moments).max() > 0.95 * moment
    # What a shear force that changes little along a line adds to the moment; the ends of the wall are free.
    gained = shear.mean(axis=1) * (ends[:, 0, 1] - ends[:, 1, 1])
    assert moments[:, 1] - moments[:, 0] == pytest.approx(gained, abs=0.01 * moment)
    assert moments[0, 0] == pytest.approx(0, abs=0.01 * moment) and moments[-1, 1] == pytest.approx(0, abs=0.01 * moment)
