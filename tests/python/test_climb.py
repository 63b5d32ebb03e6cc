"""`soilctl climb`: slopes that a wheel climbs, against slip lines under leaning loads."""

import json
import math

import pytest
from scipy.optimize import brentq


def region(soilctl, tmp_path, phi, cohesion, density):
    """Soils within ranges, as `soils` tells published ones."""
    answer = soilctl.json("soils", "moon_under_wheels")
    answer["soils"][0] |= {"phi_deg": phi, "cohesion_pa": cohesion, "density_kg_m3": density, "gravity_m_s2": 9.81}
    path = tmp_path / "region.json"
    path.write_text(json.dumps(answer))
    return path


def strip_kpa(phi_deg, cohesion_kpa, lean_deg):
    """Pressure across a rough strip on weightless soil whose load leans from its normal: exact (slip lines around a fan, with the stress
    c cot(phi) added everywhere).

    Under the strip the greater principal stress leans by psi, sin(2 psi - d) sin(phi) = sin(d), with d by how much the stress leans that
    has c cot(phi) in it; from the free surface it turns by a right angle less psi, and the mean stress grows by exp(2 angle tan(phi))."""
    phi = math.radians(phi_deg)
    added = cohesion_kpa / math.tan(phi)

    def normal(d):
        twice = d + math.asin(math.sin(d) / math.sin(phi))
        mean = added / (1 - math.sin(phi)) * math.exp((math.pi - twice) * math.tan(phi))
        return mean * (1 + math.sin(phi) * math.cos(twice))

    def leans(d):
        return normal(d) * math.tan(d) - (normal(d) - added) * math.tan(math.radians(lean_deg))

    d = 0.0 if lean_deg == 0 else brentq(leans, 1e-9, phi - 1e-9)
    return normal(d) - added


def test_the_exact_pressure_is_prandtl_s_upright():
    phi = math.radians(30)
    nq = math.tan(math.pi / 4 + phi / 2) ** 2 * math.exp(math.pi * math.tan(phi))
    assert strip_kpa(30, 2, 0) == pytest.approx(2 * (nq - 1) / math.tan(phi), rel=1e-12)


@pytest.mark.parametrize(("phi", "slope"), [(20, 0), (35, 10), (25, 20)])
def test_loads_that_lean_are_borne_as_slip_lines_say(soilctl, validate, tmp_path, phi, slope):
    """Next to no weight, so that a slope is a load that leans."""
    soils = region(soilctl, tmp_path, [phi, phi], [1000, 1000], [1, 1])
    load_n = 1e3 * strip_kpa(phi, 1, slope) / math.cos(math.radians(slope)) * 0.2 * 0.5
    for part, answer, code in [(0.85, "stands", 0), (1.15, "fails", 1)]:
        wheel = ["--wheel-load", part * load_n, "--contact-length", 0.2, "--wheel-width", 0.5]
        found = soilctl.json("climb", soils, *wheel, "--slope", slope, "--constant-friction", code=code)
        validate(found)
        assert found["answer"] == answer, found
        (trial,) = found["trials"]
        assert trial["lower"] <= 1.001 / part
        assert trial["upper"] is None or trial["upper"] >= 0.999 / part


def test_the_steepest_slope_is_between_soils(soilctl, validate, tmp_path):
    soils = region(soilctl, tmp_path, [32, 36], [300, 500], [1400, 1600])
    wheel = ["--wheel-load", 250, "--contact-length", 0.2, "--wheel-width", 0.25, "--constant-friction"]
    found = soilctl.json("climb", soils, *wheel, "--gravity", 3.71, "--within", 4)
    validate(found)
    climbs, gives_way = found["climbs_to_deg"], found["gives_way_from_deg"]
    assert 0 < climbs < gives_way < 60
    slopes = [trial["slope_deg"] for trial in found["trials"]]
    assert slopes == sorted(slopes)
    for trial in found["trials"]:
        assert (trial["lower"] is not None and trial["lower"] >= 1) == (trial["slope_deg"] <= climbs)
        assert (trial["upper"] is not None and trial["upper"] < 1) == (trial["slope_deg"] >= gives_way)
    assert f"up to {climbs:.1f} deg" in found["verdict"]
    assert any("in plane strain" in warning for warning in found["warnings"])


def test_a_slope_that_falls_by_itself_and_friction_at_other_stresses_are_refused(soilctl, tmp_path):
    soils = region(soilctl, tmp_path, [32, 36], [0, 0], [1400, 1600])
    wheel = ["--wheel-load", 250, "--contact-length", 0.2, "--wheel-width", 0.25]
    found = soilctl("climb", soils, *wheel, "--slope", 33, "--constant-friction", code=2)
    assert "falls by itself from 31.75 deg" in found.stderr
    found = soilctl("climb", soils, *wheel, "--slope", 5, code=2)
    assert "--constant-friction" in found.stderr
    found = soilctl("climb", soils, "--wheel-load", 0, *wheel[2:], code=2)
    assert "--wheel-load is 0 N" in found.stderr
    region_of_law = soilctl.json("estimate", "data/places/one_place.csv", "--delta", 20, "--friction-law", "--ends", "none", code=None)
    soils.write_text(json.dumps(region_of_law))
    assert "law of stress" in soilctl("climb", soils, *wheel, code=2).stderr
