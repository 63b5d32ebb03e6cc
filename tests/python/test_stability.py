"""`soilctl stability`: slopes against exact factors, and against the method of slices with friction that depends on stress."""

import json
import math

import numpy as np
import pytest

HEIGHT_M = 5.0
STRESS_PA = 500.0


def slope_file(path, run_over_rise, **more):
    """A slope of sand of 5 m, as a problem file."""
    crest = 10.0 + HEIGHT_M * run_over_rise
    ground = [[0, 0], [10, 0], [crest, HEIGHT_M], [crest + 10, HEIGHT_M]]
    problem = {
        "schema": "soilctl.problem/1",
        "objective": {"kind": "strength-reduction"},
        "default_boundary": "fixed",
        "soil": [{"name": "sand", "phi_deg": 30.0, "unit_weight_kn_m3": 16.0}],
        "region": [{"soil": "sand", "polygon": [[0, -5], [crest + 10, -5], *ground[::-1]]}],
        "boundary": [{"kind": "free", "line": ground}],
        **more,
    }
    path.write_text(json.dumps(problem), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def regions(soilctl, data, tmp_path_factory):
    """What `estimate` says of rained Ticino sand, without and with a law of stress."""
    folder = tmp_path_factory.mktemp("regions")
    strokes = [data / "soils" / "ticino_rained" / "strokes.csv", "--delta", 23, "--density", 1600]
    found = {}
    for name, options in {"constant": [], "law": ["--friction-law=3:6"]}.items():
        found[name] = folder / f"{name}.json"
        found[name].write_text(json.dumps(soilctl.json("estimate", *strokes, *options)), encoding="utf-8")
    return found


def exact_factor(phi_deg, run_over_rise):
    """Of dry sand: a thin slice that slides along the slope."""
    return math.tan(math.radians(phi_deg)) * run_over_rise


@pytest.mark.parametrize(("run_over_rise", "answer", "code"), [(2.0, "stands", 0), (0.8, "fails", 1)])
def test_slopes_of_sand_stand_or_fail_by_proof(soilctl, regions, tmp_path, run_over_rise, answer, code):
    problem = slope_file(tmp_path / "slope.json", run_over_rise)
    options = ["--constant-friction", "--max-gap", 0.05]
    found = soilctl.json("stability", regions["constant"], problem, *options, code=code)
    assert found["answer"] == answer
    assert found["certified"]
    low, high = json.loads(regions["constant"].read_text(encoding="utf-8"))["phi_deg"]
    assert found["phi_deg"] == [low, high]
    assert 0.94 < found["lower"] / exact_factor(low, run_over_rise) <= 1.0
    assert 1.0 <= found["upper"] / exact_factor(high, run_over_rise) < 1.06


def test_where_it_begins_to_stand_is_found(soilctl, regions, tmp_path):
    problem = slope_file(tmp_path / "slope.json", 1.15)
    options = ["--constant-friction", "--trials", 2, "--max-gap", 0.02]
    found = soilctl.json("stability", regions["constant"], problem, *options, code=3)
    assert found["answer"] == "depends"
    exact = math.degrees(math.atan(1.0 / 1.15))
    assert found["phi_deg"][0] < exact < found["phi_deg"][1]
    assert (found["fails_to_phi_deg"] or 0.0) <= exact <= (found["stands_from_phi_deg"] or 90.0)
    assert found["fails_to_phi_deg"] or found["stands_from_phi_deg"]


def test_friction_of_small_plates_is_not_carried_to_a_slope(soilctl, regions, tmp_path):
    problem = slope_file(tmp_path / "slope.json", 2.0)
    soilctl.refuses("stability", regions["constant"], problem, mentions=["--friction-law", "--constant-friction", "kPa"])


def test_files_that_make_no_sense_are_refused(soilctl, regions, tmp_path):
    problem = slope_file(tmp_path / "slope.json", 2.0)
    good = json.loads(regions["constant"].read_text(encoding="utf-8"))
    bad = tmp_path / "bad.json"
    for change, words in [
        ({"schema": "soilctl.bound/1"}, "soilctl estimate"),
        ({"consistent": False}, "no soil explains"),
        ({"phi_deg": [40.0, 30.0]}, "phi_deg is 40 to 30"),
        ({"density_kg_m3": [-1.0, 1600.0]}, "density_kg_m3"),
        ({"slip_stress_pa": None}, "slip_stress_pa is missing"),
    ]:
        bad.write_text(json.dumps({**good, **change}), encoding="utf-8")
        soilctl.refuses("stability", bad, problem, mentions=["bad.json", words])
    bad.write_text("soil", encoding="utf-8")
    soilctl.refuses("stability", bad, problem, mentions=["bad.json"])
    pushed = slope_file(tmp_path / "pushed.json", 2.0, objective={"kind": "seismic"})
    soilctl.refuses("stability", regions["constant"], pushed, mentions=["acceleration", "strength-reduction"])
    wet = slope_file(tmp_path / "wet.json", 2.0, water={"table": [[0, -1], [30, -1]]})
    soilctl.refuses("stability", regions["constant"], wet, mentions=["water", "--keep-weight"])
    soilctl.refuses("stability", regions["law"], wet, "--keep-weight", mentions=["dry"])
    sides = [{"kind": "free", "line": [[0, 0], [10, 0], [20, 5], [30, 5]]}, {"kind": "far", "sides": ["left", "right"]}]
    far = slope_file(tmp_path / "far.json", 2.0, boundary=sides)
    soilctl.refuses("stability", regions["law"], far, mentions=["far sides", "fixed or smooth"])
    soilctl.refuses("stability", regions["constant"], problem, "--soil", "clay", mentions=["--soil", "sand"])


def weakest_deg(region, stress_pa):
    """The least friction angle of all soils of a law at normal stresses; not above that at the least stress tried."""
    stress = np.maximum(stress_pa, region["slip_stress_pa"][0])
    decades = np.log10(stress / region["reference_stress_pa"])
    slices = region["friction_law"]["slices"]
    return np.min([s["phi_deg"][0] - slope * decades for s in slices for slope in s["slope_deg_per_decade"]], axis=0)


def bishop(region, run_over_rise, unit_weight_n_m3):
    """The least factor of safety by Bishop's simplified method over circles, with friction by the normal stress on each base."""
    crest = HEIGHT_M * run_over_rise

    def ground(x):
        return np.clip(x / run_over_rise, 0.0, HEIGHT_M)

    least = math.inf
    for start in np.linspace(-0.5, 0.5 * crest, 7):
        for end in np.linspace(0.6 * crest, crest + 4.0, 9):
            a, b = np.array([start, ground(start)]), np.array([end, ground(end)])
            chord = b - a
            length = np.hypot(*chord)
            for sag in (0.05, 0.1, 0.2, 0.3):
                radius = (length / 8.0) / sag + 0.5 * sag * length
                up = np.array([-chord[1], chord[0]]) / length
                centre = 0.5 * (a + b) + (radius - sag * length) * up
                edges = np.linspace(start, end, 41)
                x, width = 0.5 * (edges[1:] + edges[:-1]), edges[1] - edges[0]
                base = centre[1] - np.sqrt(radius**2 - (x - centre[0]) ** 2)
                height = ground(x) - base
                if np.any(height < -1e-9):
                    continue
                alpha = np.arcsin((x - centre[0]) / radius)
                weight = unit_weight_n_m3 * np.maximum(height, 0.0) * width
                factor, tan = 1.0, np.full(x.shape, 0.6)
                for _ in range(60):
                    normal = weight / (np.cos(alpha) + np.sin(alpha) * tan / factor)
                    stress = np.maximum(normal * np.cos(alpha) / width, 1.0)
                    tan = np.tan(np.radians(weakest_deg(region, stress)))
                    factor = np.sum(normal * tan) / np.sum(weight * np.sin(alpha))
                least = min(least, factor)
    return least


def test_a_law_of_stress_makes_deep_slides_decide(soilctl, regions, tmp_path):
    problem = slope_file(tmp_path / "slope.json", 2.0)
    region = json.loads(regions["law"].read_text(encoding="utf-8"))
    coarse = ["--max-gap", 0.2, "--max-elements", 2000]
    earth = soilctl.json("stability", regions["law"], problem, *coarse)
    assert earth["answer"] == "stands"
    assert earth["friction_basis"] == "law"
    # Deep below the slope, at stresses that no plate tried.
    assert earth["decisive_stress_pa"] > 3.0 * earth["tried_stress_pa"][1]
    # A circle is a mechanism, or nearly so: what is proven to stand cannot be above it. The field is made for layers, and loses by that.
    slices = bishop(region, 2.0, 9.80665 * region["density_kg_m3"][1])
    assert 0.8 * slices < earth["lower"] <= slices, (earth["lower"], slices)
    # Under the gravity of Mars stresses are smaller, and friction is greater.
    mars = soilctl.json("stability", regions["law"], problem, *coarse, "--gravity", 3.71)
    assert mars["lower"] > earth["lower"]
    assert any("gravity of 3.71" in warning for warning in mars["warnings"])


def test_published_soils_bring_cohesion_and_gravity(soilctl, validate, tmp_path):
    """Weightless soil under a strip load: Prandtl's c N_c is exact, and the corners of the published ranges bound it."""
    published = soilctl.json("soils", "mars_viking_drift")
    validate(published)
    region = tmp_path / "mars.json"
    region.write_text(json.dumps(published), encoding="utf-8")
    problem = tmp_path / "strip.json"
    loaded = {"kind": "load", "line": [[-1, 0], [1, 0]], "pressure_kpa": 10.0, "live": True}
    text = {
        "objective": {"kind": "load"},
        "default_boundary": "free",
        "soil": [{"name": "drift", "phi_deg": 30.0, "cohesion_kpa": 99.0, "unit_weight_kn_m3": 0.0}],
        "region": [{"soil": "drift", "polygon": [[-10, -6], [10, -6], [10, 0], [-10, 0]]}],
        "boundary": [{"kind": "fixed", "sides": ["left", "right", "bottom"]}, loaded],
    }
    problem.write_text(json.dumps(text), encoding="utf-8")
    words = ["not published", "--constant-friction"]
    soilctl.refuses("stability", region, problem, "--keep-weight", mentions=words)
    options = ["--keep-weight", "--constant-friction", "--trials", 0, "--max-gap", 0.04]
    found = soilctl.json("stability", region, problem, *options, code=3)
    validate(found)
    assert found["gravity_m_s2"] == 3.71
    [soil] = published["soils"]
    assert found["cohesion_pa"] == soil["cohesion_pa"] == [700, 3000]

    def exact(phi_deg, cohesion_pa):
        phi = math.radians(phi_deg)
        n_q = math.exp(math.pi * math.tan(phi)) * math.tan(math.pi / 4 + phi / 2) ** 2
        return 1e-3 * cohesion_pa * (n_q - 1) / math.tan(phi) / 10.0

    low, high = (exact(*corner) for corner in zip(soil["phi_deg"], soil["cohesion_pa"], strict=True))
    assert 0.95 < found["lower"] / low <= 1.0
    assert 1.0 <= found["upper"] / high < 1.05
    assert "cohesion 700 to 3000 Pa" in found["verdict"]


def test_published_soils_are_listed_by_body_and_asked_for_by_name(soilctl, tmp_path):
    every = soilctl.json("soils")["soils"]
    moon = soilctl.json("soils", "--body", "moon")["soils"]
    assert 0 < len(moon) < len(every) and all(soil["gravity_m_s2"] == 1.62 for soil in moon)
    soilctl.refuses("soils", "cheese", mentions=["moon_0_15cm"])
    soilctl.refuses("soils", "moon_0_15cm", "--body", "mars", mentions=["--body"])
    several = tmp_path / "several.json"
    several.write_text(json.dumps(soilctl.json("soils")), encoding="utf-8")
    soilctl.refuses("stability", several, slope_file(tmp_path / "slope.json", 2.0), mentions=["soilctl soils NAME"])
    text = soilctl("soils", "mars_rover_trenches", code=0).stdout
    assert "Sullivan" in text and "0 to 2000 Pa" in text


def test_a_footing_bears_a_force_on_every_sand_of_a_region(soilctl, tmp_path):
    """Rough strip on sand without cohesion or surcharge: N_gamma is 14.7543 at 30 and 34.4761 at 35 degrees (Martin 2005)."""
    region, problem = tmp_path / "region.json", tmp_path / "footing.json"
    sand = {"phi_deg": [30, 35], "density_kg_m3": [1600, 1600], "slip_stress_pa": [300, 900]}
    region.write_text(json.dumps({"schema": "soilctl.estimate/1", "consistent": True, **sand}), encoding="utf-8")
    text = {
        "objective": {"kind": "structure", "name": "footing", "direction": [0, -1]},
        "default_boundary": "free",
        "soil": [{"name": "sand", "phi_deg": 30.0, "unit_weight_kn_m3": 16.0}],
        "region": [{"soil": "sand", "polygon": [[-9, -5], [9, -5], [9, 0], [-9, 0]]}],
        "boundary": [{"kind": "fixed", "sides": ["left", "right", "bottom"]}],
        "structure": [{"name": "footing", "edge": [[-1, 0], [1, 0]], "delta_deg": 30.0}],
    }
    problem.write_text(json.dumps(text), encoding="utf-8")
    soilctl.refuses("stability", region, problem, "--constant-friction", mentions=["--required", "kN/m"])
    options = ["--constant-friction", "--trials", 0, "--max-gap", 0.15, "--required", 300]
    found = soilctl.json("stability", region, problem, *options, code=0)
    force = 0.5 * 1.6 * 9.80665 * 2.0**2
    assert 300 < found["lower"] <= force * 14.7543
    # With 35 degrees in the sand the face has its 30 all the same, which can only take from what is borne.
    assert found["upper"] < 1.2 * force * 34.4761
    assert "kN/m is required" in found["verdict"]
