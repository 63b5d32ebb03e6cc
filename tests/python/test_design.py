"""`soilctl design`: the least that is enough, against what holds exactly."""

import json
import tomllib

import pytest
from conftest import DATA

CUT = """
default_boundary = "fixed"
objective = { kind = "strength-reduction" }
soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 20, unit_weight_kn_m3 = 18 }]
region = [{ soil = "clay", polygon = [[-9, 3], [-9, -4.5], [6, -4.5], [6, 0], [0, 0], [0, 3]] }]
boundary = [{ kind = "free", line = [[-9, 3], [0, 3], [0, 0], [6, 0]] }]
"""

# Bounds some tenth apart, in seconds.
QUICK = ["--max-gap", 0.15, "--max-elements", 1500]


def cut(high):
    """A cut of some height in the clay of `CUT`."""
    return f"""
title = "cut of {high} m"
default_boundary = "fixed"
objective = {{ kind = "strength-reduction" }}
soil = [{{ name = "clay", phi_deg = 0, cohesion_kpa = 20, unit_weight_kn_m3 = 18 }}]
region = [{{ soil = "clay", polygon = [[-{3 * high}, {high}], [-{3 * high}, -{high}], [{2 * high}, -{high}], [{2 * high}, 0], [0, 0], [0, {high}]] }}]
boundary = [{{ kind = "free", line = [[-{3 * high}, {high}], [0, {high}], [0, 0], [{2 * high}, 0]] }}]
"""


def test_the_cohesion_that_a_cut_needs(soilctl, tmp_path):
    file, out = tmp_path / "cut.toml", tmp_path / "found.toml"
    file.write_text(CUT)
    words = ["design", file, "--parameter", "soil.clay.cohesion_kpa", "--from", 10, "--to", 20, "--within", 3, *QUICK]
    answer = soilctl.json(*words, "--out", out)
    # Martin (2011): 3.7764 to 3.7776 is what a cut's weight over its cohesion may be.
    exact = 54 / 3.777
    assert answer["found"] == "within" and answer["title"] is None
    assert answer["not_enough_at"] < exact < answer["enough_at"] <= answer["not_enough_at"] + 3
    for one in answer["tried"]:
        factor = one["value"] / exact
        assert (one["lower"] or 0) <= factor * 1.001 and factor <= (one["upper"] or 9) * 1.001
        # No sharper than it takes: one side decides.
        decided = {"enough": (1, None), "not_enough": (None, pytest.approx(1)), "open": (None, None)}
        assert (one["lower"], one["upper"]) == decided[one["verdict"]]
    written = tomllib.loads(out.read_text())
    assert written["soil"][0]["cohesion_kpa"] == answer["enough_at"] and "sweep" not in written
    soilctl.refuses(*words, "--out", out, mentions=["--replace"])


def test_how_high_a_cut_may_be(soilctl, tmp_path):
    low, high = tmp_path / "low.toml", tmp_path / "high.toml"
    low.write_text(cut(3))
    high.write_text(cut(6))
    answer = soilctl.json("design", low, high, "--within", 0.2, *QUICK, code=3)
    assert answer["parameter"] is None and answer["title"] == "cut of 3 m"
    exact = (3.777 * 20 / 18 - 3) / 3
    assert answer["enough_at"] < exact < answer["not_enough_at"] <= answer["enough_at"] + 0.5
    # From the other side it is the same way turned.
    other = soilctl.json("design", high, low, "--within", 0.2, *QUICK, code=3)
    assert other["not_enough_at"] < 1 - exact < other["enough_at"]
    assert len(other["tried"]) == len(answer["tried"])


@pytest.mark.parametrize(("wanted", "found", "code"), [(0.5, "both_enough", 0), (9, "neither_enough", 1)])
def test_ends_may_tell_alone(soilctl, tmp_path, wanted, found, code):
    file = tmp_path / "cut.toml"
    file.write_text(CUT)
    words = ["--parameter", "soil.clay.cohesion_kpa", "--from", 15, "--to", 20, *QUICK]
    answer = soilctl.json("design", file, *words, "--wanted", wanted, code=code)
    assert answer["found"] == found and len(answer["tried"]) == 2


def test_all_cases_must_have_enough(soilctl, tmp_path):
    file = tmp_path / "cut.toml"
    cases = '\n[[case]]\nname = "as given"\n\n[[case]]\nname = "partial factor"\nfactors = { undrained = 1.4 }\n'
    file.write_text(CUT + cases)
    answer = soilctl.json("design", file, "--parameter", "soil.clay.cohesion_kpa", "--from", 10, "--to", 30, "--within", 11, *QUICK, code=3)
    assert answer["not_enough_at"] < 1.4 * 54 / 3.777 < answer["enough_at"]
    # The first that has not enough, which at 10 is the one without a factor, or is open; none where all have enough.
    cases = {one["value"]: (one["verdict"], one["case"] and one["case"].partition(",")[0]) for one in answer["tried"]}
    assert cases == {10: ("not_enough", "as given"), 20: ("open", "partial factor"), 30: ("enough", None)}


def test_what_cannot_be_searched_is_refused(soilctl, tmp_path):
    file, other, json_file = tmp_path / "cut.toml", tmp_path / "other.toml", tmp_path / "other.json"
    file.write_text(CUT)
    other.write_text(CUT.replace('"clay"', '"loam"'))
    json_file.write_text(json.dumps(tomllib.loads(CUT)))
    parameter = ["--parameter", "soil.clay.cohesion_kpa"]
    soilctl.refuses("design", file, mentions=["--parameter"])
    soilctl.refuses("design", file, *parameter, "--from", 1, "--to", 1, mentions=["one value"])
    soilctl.refuses("design", file, other, mentions=["region.1.soil", "numbers alone"])
    soilctl.refuses("design", file, json_file, mentions=["say the same"])
    soilctl.refuses("design", file, other, *parameter, mentions=["without --parameter"])
    soilctl.refuses("design", file, "--parameter", "soil.loam.phi_deg", "--from", 1, "--to", 2, mentions=["there is no soil"])
    soilctl.refuses("design", file, *parameter, "--from", 20, "--to", -1, mentions=["at -1", "cohesion_kpa"])
    soilctl.refuses("design", DATA / "problems/slope.toml", file, mentions=["in one file"])
