"""`soilctl design`: the least that is enough, against what holds exactly."""

import json
import math
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


def slope(run):
    """Dry sand, 4 m high on rock: its factor of safety is the ratio of tangents."""
    return f"""
title = "slope with a run of {run} m"
default_boundary = "free"
objective = {{ kind = "strength-reduction" }}
soil = [{{ name = "sand", phi_deg = 36, cohesion_kpa = 0, unit_weight_kn_m3 = 18 }}]
region = [{{ soil = "sand", polygon = [[-8, 0], [{run}, 0], [0, 4], [-8, 4]] }}]
boundary = [{{ kind = "fixed", sides = ["bottom"] }}, {{ kind = "smooth", sides = ["left"] }}]
"""


def test_the_cohesion_that_a_cut_needs(soilctl, tmp_path):
    file, out = tmp_path / "cut.toml", tmp_path / "found.toml"
    file.write_text(CUT)
    words = ["design", file, "--parameter", "soil.clay.cohesion_kpa", "--from", 10, "--to", 20, "--within", 0.6, "--max-gap", 0.04]
    answer = soilctl.json(*words, "--out", out)
    # Martin (2011): 3.7764 to 3.7776 is what a cut's weight over its cohesion may be.
    exact = 54 / 3.777
    assert answer["found"] == "within"
    assert answer["not_enough_at"] < exact < answer["enough_at"] <= answer["not_enough_at"] + 0.6
    for one in answer["tried"]:
        assert one["lower"] <= one["value"] / exact * 1.001 and one["value"] / exact <= one["upper"] * 1.001
        assert one["verdict"] == ("enough" if one["lower"] >= 1 else "not_enough" if one["upper"] < 1 else "open")
    written = tomllib.loads(out.read_text())
    assert written["soil"][0]["cohesion_kpa"] == answer["enough_at"] and "sweep" not in written
    assert f"{answer['enough_at']:g}" in soilctl(*words, code=0).stdout
    soilctl.refuses(*words, "--out", out, mentions=["--replace"])


def test_how_steep_a_slope_may_be(soilctl, tmp_path):
    steep, flat = tmp_path / "steep.toml", tmp_path / "flat.toml"
    steep.write_text(slope(4))
    flat.write_text(slope(12))
    answer = soilctl.json("design", steep, flat, "--wanted", 1.3, "--within", 0.06, "--max-gap", 0.04)
    assert answer["parameter"] is None
    exact = (1.3 * 4 / math.tan(math.radians(36)) - 4) / 8
    assert answer["not_enough_at"] < exact < answer["enough_at"] <= answer["not_enough_at"] + 0.15
    assert answer["tried"][0]["value"] == 0 and answer["tried"][0]["verdict"] == "not_enough"
    # From the other side it is the same way turned.
    other = soilctl.json("design", flat, steep, "--wanted", 1.3, "--within", 0.3, "--max-gap", 0.04)
    assert other["enough_at"] < 1 - exact < other["not_enough_at"]


@pytest.mark.parametrize(("wanted", "found", "code"), [(0.5, "both_enough", 0), (9, "neither_enough", 1)])
def test_ends_may_tell_alone(soilctl, tmp_path, wanted, found, code):
    file = tmp_path / "cut.toml"
    file.write_text(CUT)
    words = ["--parameter", "soil.clay.cohesion_kpa", "--from", 15, "--to", 20, "--max-gap", 0.2]
    answer = soilctl.json("design", file, *words, "--wanted", wanted, code=code)
    assert answer["found"] == found and len(answer["tried"]) == 2


def test_all_cases_must_have_enough(soilctl, tmp_path):
    file = tmp_path / "cut.toml"
    cases = '\n[[case]]\nname = "as given"\n\n[[case]]\nname = "partial factor"\nfactors = { undrained = 1.4 }\n'
    file.write_text(CUT + cases)
    answer = soilctl.json("design", file, "--parameter", "soil.clay.cohesion_kpa", "--from", 10, "--to", 30, "--within", 3, "--max-gap", 0.05)
    assert answer["not_enough_at"] < 1.4 * 54 / 3.777 < answer["enough_at"]
    assert {one["case"] for one in answer["tried"]} == {"partial factor, soil.clay.cohesion_kpa = " + f"{v:g}" for v in (one["value"] for one in answer["tried"])}


def test_what_cannot_be_searched_is_refused(soilctl, tmp_path):
    file, other, json_file = tmp_path / "cut.toml", tmp_path / "other.toml", tmp_path / "other.json"
    file.write_text(CUT)
    other.write_text(CUT.replace('"clay"', '"loam"'))
    json_file.write_text(json.dumps(tomllib.loads(CUT)))
    parameter = ["--parameter", "soil.clay.cohesion_kpa"]
    soilctl.refuses("design", file, mentions=["--parameter"])
    soilctl.refuses("design", file, *parameter, "--from", 1, "--to", 1, mentions=["one value"])
    soilctl.refuses("design", file, other, mentions=["soil.1.name", "numbers alone"])
    soilctl.refuses("design", file, json_file, mentions=["say the same"])
    soilctl.refuses("design", file, other, *parameter, mentions=["without --parameter"])
    soilctl.refuses("design", file, "--parameter", "soil.loam.phi_deg", "--from", 1, "--to", 2, mentions=["there is no soil"])
    soilctl.refuses("design", file, *parameter, "--from", 20, "--to", -1, mentions=["at -1", "cohesion_kpa"])
    soilctl.refuses("design", DATA / "problems/slope.toml", file, mentions=["in one file"])
