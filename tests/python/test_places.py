"""`soilctl places`: places whose soils differ, what lies between them, and the files that are written.

Forces come from a generator of `data/places/make.py` that shares nothing with the program but the published table of bounds. Kriging is solved
anew with numpy, geographic coordinates by way of the earth's axes.
"""

import csv
import importlib.util
import io
import json
import math

import numpy as np
import pytest
from conftest import strict_json
from shapely.geometry import Point, shape

COLUMNS = ["place", "place_x_m", "place_y_m", "alpha_deg", "depth_m", "width_m", "force_n", "force_sd_n", "delta_set_deg"]


@pytest.fixture(scope="module")
def ground(data):
    spec = importlib.util.spec_from_file_location("make_places", data / "places" / "make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def example(soilctl, data, tmp_path_factory):
    folder = tmp_path_factory.mktemp("map")
    files = ["--geojson", folder / "map.geojson", "--cells", folder / "cells.csv", "--origin-deg", "48.15,11.57"]
    done = soilctl("places", data / "places" / "strokes.csv", "--delta", 20, *files, "--format", "json", code=0)
    return folder, strict_json(done.stdout)


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    return path


def strokes_of(bounds, random, name, at, phi_deg, density, *, angles=(70.0, 80.0, 90.0, 100.0), noise=0.02, ends=0.5):
    """One stroke at each tool angle."""
    for alpha_deg in angles:
        depth_m = 0.0254 * math.sin(math.radians(alpha_deg))
        force_n = bounds.force_n(alpha_deg, phi_deg, 20.0, density, depth_m, ends=ends) * (1.0 + random.normal(0.0, noise))
        yield {
            "place": name, "place_x_m": at[0], "place_y_m": at[1], "alpha_deg": alpha_deg, "depth_m": depth_m,
            "width_m": 0.127, "force_n": force_n, "force_sd_n": noise * force_n, "delta_set_deg": 20.0,
        }  # fmt: skip


def test_the_two_sands_of_the_example_are_told_apart(example, validate, ground):
    _, answer = example
    validate(answer)
    groups = [set(group["places"]) for group in answer["groups"]]
    assert groups == [{f"A{i}" for i in range(1, 8)}, {f"B{i}" for i in range(1, 8)}]
    for place in answer["places"]:
        phi_deg, density = ground.soil_at(place["x_m"], place["y_m"])
        assert place["phi_deg"][0] <= phi_deg <= place["phi_deg"][1]
        assert place["density_kg_m3"][0] <= density <= place["density_kg_m3"][1]
    for pair in answer["pairs"]:
        assert pair["by"] == "forces" and pair["kinds"] == 4
        assert pair["differ"] == (pair["places"][0][0] != pair["places"][1][0])


def test_the_script_reproduces_the_example(ground, data):
    text = io.StringIO()
    writer = csv.DictWriter(text, ground.UNITS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(ground.rows())
    assert text.getvalue() == (data / "places" / "strokes.csv").read_text(encoding="utf-8")
    lines = text.getvalue().splitlines()
    assert (data / "places" / "one_place.csv").read_text(encoding="utf-8").splitlines() == [lines[0], *(x for x in lines if ",A2," in x)]


def test_false_discoveries_are_those_of_benjamini_and_hochberg(example):
    """Their rule, with the p-values of the answer."""
    _, answer = example
    p = np.array([pair["p"] for pair in answer["pairs"]])
    limits = answer["false_discovery"] * np.arange(1, len(p) + 1) / len(p)
    below = np.nonzero(np.sort(p) <= limits)[0]
    threshold = np.sort(p)[below[-1]]
    assert [pair["differ"] for pair in answer["pairs"]] == list(p <= threshold)


@pytest.mark.parametrize("quantity, key", [("phi_deg", "phi_covariances"), ("density_kg_m3", "density_covariances")])
def test_cells_are_kriging_solved_anew(example, quantity, key):
    """Cressie's system with the variogram and a Lagrange multiplier, by numpy, for every covariance of the answer."""
    _, answer = example
    between = answer["between"]
    at = np.array([[place["x_m"], place["y_m"]] for place in answer["places"]])
    ends = np.array([place[quantity] for place in answer["places"]])
    n = len(at)
    apart = np.linalg.norm(at[:, None] - at[None], axis=2)
    assert between["deviations"] == pytest.approx(1.959964, abs=1e-6)
    for cell in between["cells"][:: max(1, len(between["cells"]) // 60)]:
        low, high = np.inf, -np.inf
        for covariance in between[key]:
            gamma = lambda h, a=covariance["length_m"]: 1.0 - np.exp(-h / a)  # noqa: E731
            matrix = np.ones((n + 1, n + 1))
            matrix[:n, :n], matrix[n, n] = gamma(apart), 0.0
            right = np.append(gamma(np.linalg.norm(at - [cell["x_m"], cell["y_m"]], axis=1)), 1.0)
            solved = np.linalg.solve(matrix, right)
            reach = between["deviations"] * covariance["sd"] * math.sqrt(max(solved @ right, 0.0))
            products = solved[:n, None] * ends
            low = min(low, products.min(axis=1).sum() - reach)
            high = max(high, products.max(axis=1).sum() + reach)
        limits = (5.0, 60.0) if quantity == "phi_deg" else (100.0, 5000.0)
        expected = np.clip([low, high], *limits)
        # At a place the variance is the root of a rounded 0.
        assert cell[quantity] == pytest.approx(expected, rel=1e-5)


def test_files_hold_what_the_answer_says(example):
    folder, answer = example
    document = strict_json((folder / "map.geojson").read_text(encoding="utf-8"))
    features = document["features"]
    kinds = [feature["properties"]["kind"] for feature in features]
    between = answer["between"]
    assert kinds == ["place"] * 14 + ["cell"] * len(between["cells"]) + ["next-place"] * 3
    shapes = [shape(feature["geometry"]) for feature in features]
    assert all(one.is_valid for one in shapes)
    for kind, one, feature in zip(kinds, shapes, features, strict=True):
        x, y = feature["properties"]["x_m"], feature["properties"]["y_m"]
        assert np.allclose([one.centroid.x, one.centroid.y], geographic(48.15, 11.57, x, y), atol=2e-7), kind
    hull = shape({"type": "Polygon", "coordinates": [between["hull"]]})
    for cell in between["cells"]:
        assert cell["inside"] == hull.buffer(1e-9).contains(Point(cell["x_m"], cell["y_m"]))
    with open(folder / "cells.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["phi_low_deg"]) for row in rows] == [cell["phi_deg"][0] for cell in between["cells"]]
    assert all(hull.buffer(1e-9).contains(Point(*at)) for at in between["next_places"])


def geographic(latitude, longitude, east_m, north_m):
    """Longitude and latitude of a point in the plane that touches the ellipsoid, by the earth's axes and Bowring's formula."""
    a, f = 6378137.0, 1.0 / 298.257223563
    e2 = f * (2.0 - f)
    lat, lon = math.radians(latitude), math.radians(longitude)
    normal = a / math.sqrt(1.0 - e2 * math.sin(lat) ** 2)
    origin = np.array([normal * math.cos(lat) * math.cos(lon), normal * math.cos(lat) * math.sin(lon), normal * (1 - e2) * math.sin(lat)])
    east = np.array([-math.sin(lon), math.cos(lon), 0.0])
    north = np.array([-math.sin(lat) * math.cos(lon), -math.sin(lat) * math.sin(lon), math.cos(lat)])
    x, y, z = origin + east_m * east + north_m * north
    p, b = math.hypot(x, y), a * (1.0 - f)
    theta = math.atan2(z * a, p * b)
    second = e2 / (1.0 - e2)
    found = math.atan2(z + second * b * math.sin(theta) ** 3, p - e2 * a * math.cos(theta) ** 3)
    return math.degrees(math.atan2(y, x)), math.degrees(found)


def test_uncertainty_grows_away_from_places(example):
    _, answer = example
    at = np.array([[place["x_m"], place["y_m"]] for place in answer["places"]])
    cells = answer["between"]["cells"]
    nearest = [np.linalg.norm(at - [cell["x_m"], cell["y_m"]], axis=1).min() for cell in cells]
    near = [cell["phi_sd_deg"] for cell, d in zip(cells, nearest, strict=True) if d < 1.5]
    far = [cell["phi_sd_deg"] for cell, d in zip(cells, nearest, strict=True) if d > 4.0]
    assert max(near) < min(far) or np.median(near) < 0.7 * np.median(far)


@pytest.mark.parametrize("soils", [1, 2])
def test_false_alarms_and_missed_differences_of_random_ground(soilctl, tmp_path, ground, soils):
    """Six places of one sand, or of two that differ by three degrees; ends, noise and soils at random.

    The campaign says that nothing but the noise of forces is off, as is so here. With its defaults (depths within 0.5 mm, and more that strokes
    of a place share) single strokes tell forces apart from about a third on, and none of these pairs.
    """
    exact = {"depth_sd_m": 1e-5, "depth_common_sd_m": 0.0, "soil_sd_rel": 0.0, "density_sd_rel": 0.0, "instrument": {"force_gain_sd": 0.0}}
    (tmp_path / "campaign.json").write_text(json.dumps(exact), encoding="utf-8")
    bounds = ground.Bounds()
    random = np.random.default_rng(30 + soils)
    told, false, missed, held, count = 0, 0, 0, 0, 0
    campaigns = 6
    for campaign in range(campaigns):
        phi, density, ends = random.uniform(31.0, 38.0), random.uniform(1400.0, 1650.0), random.uniform(0.0, 1.0)
        of = [phi + 3.0 * (soils == 2 and place >= 3) for place in range(6)]
        rows = []
        for place in range(6):
            at = random.uniform(0.0, 20.0, 2)
            rows += strokes_of(bounds, random, f"P{place}", at, of[place], density, ends=ends)
        path = write(tmp_path / f"{campaign}.csv", rows)
        answer = strict_json(soilctl("places", path, "--delta", 20, "--format", "json", code=0).stdout)
        for pair in answer["pairs"]:
            apart = of[int(pair["places"][0][1])] != of[int(pair["places"][1][1])]
            told += pair["differ"]
            false += pair["differ"] and not apart
            missed += apart and not pair["differ"]
        for place in answer["places"]:
            count += 1
            held += place["phi_deg"][0] <= of[int(place["name"][1])] <= place["phi_deg"][1]
    print(f"told {told}, false {false}, missed {missed}, held {held} of {count}")
    assert held >= 0.95 * count
    # One that is none of so few pairs may be by chance.
    assert false <= 0.05 * told + 1
    if soils == 2:
        assert missed <= 0.5 * 9 * campaigns


def test_a_place_that_contradicts_itself_is_said(soilctl, tmp_path, ground):
    bounds, random = ground.Bounds(), np.random.default_rng(4)
    rows = [row for i in range(5) for row in strokes_of(bounds, random, f"P{i}", (3.0 * i, i % 2), 35.0, 1500.0)]
    for row in rows[:2]:
        row["force_n"] *= 3.0
    done = soilctl("places", write(tmp_path / "s.csv", rows), "--delta", 20, "--format", "json", code=3)
    answer = strict_json(done.stdout)
    assert [place["consistent"] for place in answer["places"]] == [False, True, True, True, True]
    assert answer["places"][0]["group"] is None and any("no soil explains the strokes of P0" in w for w in answer["warnings"])


def test_bounds_tell_by_sets_and_places_without_coordinates_have_nothing_between(soilctl, tmp_path, ground):
    bounds, random = ground.Bounds(), np.random.default_rng(5)
    rows = [row for name, phi in (("A", 33.0), ("B", 33.0), ("C", 41.0)) for row in strokes_of(bounds, random, name, ("", ""), phi, 1500.0)]
    path = write(tmp_path / "s.csv", rows)
    done = soilctl("places", path, "--delta", 20, "--uncertainty", "bounds", "--model", "chen", "--format", "json")
    answer = strict_json(done.stdout)
    assert answer["confidence"] is None and answer["between"] is None
    assert any("no coordinates" in warning for warning in answer["warnings"])
    assert all(pair["p"] is None for pair in answer["pairs"])


def test_places_of_other_kinds_of_strokes_are_compared_by_sets(soilctl, tmp_path, ground):
    bounds, random = ground.Bounds(), np.random.default_rng(6)
    rows = list(strokes_of(bounds, random, "A", (0, 0), 34.0, 1500.0, angles=(70.0, 90.0)))
    rows += strokes_of(bounds, random, "B", (5, 0), 34.0, 1500.0, angles=(80.0, 100.0))
    answer = strict_json(soilctl("places", write(tmp_path / "s.csv", rows), "--delta", 20, "--format", "json", code=0).stdout)
    [pair] = answer["pairs"]
    assert pair["by"] == "sets" and pair["kinds"] == 0 and pair["p"] > 0.9 and not pair["differ"]
    assert answer["groups"][0]["places"] == ["A", "B"]


@pytest.mark.parametrize(
    "change, words",
    [
        ({"place": ""}, "line 2: the stroke has no place"),
        ({"place_x_m": "50"}, "more than 2 m"),
        ({"place_x_m": "x"}, "place_x_m"),
    ],
)
def test_what_makes_no_sense_is_refused(soilctl, tmp_path, ground, change, words):
    bounds, random = ground.Bounds(), np.random.default_rng(7)
    rows = [row for i in range(2) for row in strokes_of(bounds, random, f"P{i}", (3.0 * i, 0), 35.0, 1500.0)]
    rows[0].update(change)
    if change == {"place": ""}:
        rows[0]["place_x_m"] = ""
    done = soilctl("places", write(tmp_path / "s.csv", rows), "--delta", 20, code=2)
    assert words in done.stderr


def test_two_places_at_one_point_and_a_single_place_are_refused(soilctl, tmp_path, ground):
    bounds, random = ground.Bounds(), np.random.default_rng(8)
    rows = [row for i in range(5) for row in strokes_of(bounds, random, f"P{i}", (3.0 * min(i, 3), 0), 35.0, 1500.0)]
    done = soilctl("places", write(tmp_path / "s.csv", rows), "--delta", 20, code=2)
    assert "two places are at (9, 0) m" in done.stderr
    done = soilctl("places", write(tmp_path / "one.csv", rows[:4]), "--delta", 20, code=2)
    assert "one place" in done.stderr


def test_the_page_opens(soilctl, data, tmp_path, open_page):
    page = tmp_path / "map.html"
    soilctl("places", data / "places" / "strokes.csv", "--delta", 20, "--report", page, code=0)
    opened = open_page(page)
    assert opened.locator("h1").inner_text() == "Is the soil the same everywhere?"
    assert opened.locator("figure").count() == 6
