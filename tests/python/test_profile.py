"""`soilctl profile`: whether the ground changes with depth.

Forces come from `data/profile/make.py`: wedges through layers of another mechanism than the sum of pressures by which the program reads them. What one soil may be is
found anew on a grid, with Coulomb's wedges of that generator.
"""

import csv
import importlib.util
import math

import numpy as np
import pytest
from conftest import strict_json

# With the friction on the plate known, what takes most of the time, a law of stress, takes a second.
OPTIONS = ["--model", "coulomb", "--delta", "20", "--delta-tol", "0", "--density", "1550", "--density-tol", "0.2"]


@pytest.fixture(scope="module")
def made(data):
    spec = importlib.util.spec_from_file_location("make_profile", data / "profile" / "make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write(path, rows):
    rows = list(rows)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return path


def ask(soilctl, path, *options, code=0):
    return strict_json(soilctl("profile", path, *options, "--format", "json", code=code).stdout)


def kinds(answer):
    return {one["kind"]: one for one in answer["hypotheses"]}


def inside(value, interval):
    return interval[0] <= value <= interval[1]


@pytest.fixture(scope="module")
def example(soilctl, data, tmp_path_factory):
    page = tmp_path_factory.mktemp("profile") / "page.html"
    return ask(soilctl, data / "profile" / "step.csv", *OPTIONS, "--report", page), page


def test_the_script_reproduces_the_example(made, data, tmp_path):
    again = write(tmp_path / "step.csv", made.strokes(made.loose_on_dense, 11))
    assert again.read_text(encoding="utf-8") == (data / "profile" / "step.csv").read_text(encoding="utf-8")


def test_a_loose_cover_is_not_one_soil_and_its_step_is_found(example, made, validate):
    answer, page = example
    validate(answer)
    found = kinds(answer)
    assert not found["one-soil"]["consistent"] and found["one-soil"]["p"] < 0.05 < 1.0 < found["one-soil"]["widening"]
    step = found["step"]
    assert step["consistent"] and inside(made.STEP_M, step["step_m"])
    (phi_top, density_top), (phi_bottom, density_bottom) = made.loose_on_dense(0.01), made.loose_on_dense(0.05)
    (there,) = [one["ranges"] for one in step["slices"] if inside(made.STEP_M, one["step_m"])]
    assert inside(phi_top, there["phi_top_deg"]) and inside(phi_bottom, there["phi_bottom_deg"])
    assert inside(density_top, there["density_top_kg_m3"]) and inside(density_bottom, there["density_bottom_kg_m3"])
    # At that depth the change of 7 deg is known to be one.
    assert inside(phi_bottom - phi_top, there["phi_growth_deg"])
    for level in step["profile"]:
        phi, density = made.loose_on_dense(level["depth_m"])
        assert inside(phi, level["phi_deg"]) and inside(density, level["density_kg_m3"])
    for stroke in answer["strokes"]:
        slant = stroke["depth_m"] / math.sin(math.radians(stroke["alpha_deg"]))
        expected = 2.0 * stroke["force_n"] / (made.GRAVITY_M_S2 * made.WIDTH_M * slant**2)
        assert stroke["normalised_kg_m3"] == pytest.approx(expected, rel=1e-9)
    assert "cannot be told apart" in answer["verdict"] and "next stroke tells most" in answer["verdict"]
    text = page.read_text(encoding="utf-8")
    assert "Does the ground change with depth?" in text and "Friction angle over depth" in text


def test_local_pressures_and_their_widening_hold_the_proven_bounds_of_layers(data):
    """Bounds of `data/profile/layers.csv`, coefficients by the bounds of one soil of each kind; the shares are those of `crates/ground/README.md`."""
    with open(data / "profile" / "layers.csv", newline="", encoding="utf-8") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    of_one = {}
    for row in rows:
        if row["phi_top_deg"] == row["phi_bottom_deg"] and row["weight_top_kn_m3"] == row["weight_bottom_kn_m3"]:
            key = row["alpha_deg"], row["delta_deg"], row["phi_top_deg"]
            of_one[key] = np.array([row["lower_kn_m"], row["upper_kn_m"]]) / row["weight_top_kn_m3"]
    checked = 0
    for row in rows:
        top, bottom = (of_one.get((row["alpha_deg"], row["delta_deg"], row[f"phi_{end}_deg"])) for end in ("top", "bottom"))
        if row["alpha_deg"] > 90.0 or top is None or bottom is None:
            continue
        step = min(row["step_over_depth"], 1.0)
        of_top, of_bottom = row["weight_top_kn_m3"], row["weight_bottom_kn_m3"]
        local = of_top * (top * step**2 + 2.0 * bottom * step * (1.0 - step)) + of_bottom * bottom * (1.0 - step) ** 2
        share, reach = (0.2, 1.05) if row["alpha_deg"] <= 81.0 else (0.35, 1.12)
        ratio = math.log(bottom.mean() / top.mean()) if row["step_over_depth"] < reach else 0.0
        off = sorted([share * ratio, -0.06 * ratio])
        low, high = local[0] * math.exp(off[0]) * 0.995, local[1] * math.exp(off[1]) * 1.005
        # The true force is somewhere between the bounds; their middle must be in what is allowed.
        middle = 0.5 * (row["lower_kn_m"] + row["upper_kn_m"])
        assert low <= middle <= high, row
        checked += 1
    assert checked >= 45


def test_what_one_soil_may_be_is_that_of_a_grid(soilctl, made, tmp_path):
    """Half widths of 6 %, friction on the plate known: friction angles for which some density explains every force, by the generator's wedges."""
    rows = list(made.strokes(lambda _: (36.0, 1550.0), 5, depths=(0.03, 0.06), angles=(50.0, 80.0), repeats=1))
    for row in rows:
        row["force_sd_n"] = f"{0.06 * float(row['force_n']):.6f}"
        row["depth_sd_m"] = "0"
    path = write(tmp_path / "one.csv", rows)
    answer = ask(soilctl, path, *OPTIONS, "--uncertainty", "bounds")
    found = kinds(answer)
    assert all(one["consistent"] and one["p"] is None for one in found.values())
    explained = []
    for phi in np.arange(25.0, 47.0, 0.2):
        unit = [made.force_n(lambda _, phi=phi: (phi, 1.0), float(row["alpha_deg"]), float(row["depth_m"])) for row in rows]
        read = np.array([float(row["force_n"]) for row in rows])
        low, high = np.max(0.94 * read / unit), np.min(1.06 * read / unit)
        if max(low, 1240.0) <= min(high, 1860.0):
            explained.append((phi, max(low, 1240.0), min(high, 1860.0)))
    explained = np.array(explained)
    one = found["one-soil"]["ranges"]
    # Told to 0.25 deg and 20 kg/m3, or 4 % of what is left; nothing is lost.
    slack = max(0.25, 0.04 * np.ptp(explained[:, 0])) + 0.25
    assert explained[0, 0] - slack <= one["phi_top_deg"][0] <= explained[0, 0] + 0.05
    assert explained[-1, 0] - 0.05 <= one["phi_top_deg"][1] <= explained[-1, 0] + slack
    assert one["density_top_kg_m3"][0] <= explained[:, 1].min() + 1.0 and one["density_top_kg_m3"][1] >= explained[:, 2].max() - 1.0
    # One soil is a gradient without slope and a step without change.
    for kind in ("gradient", "step"):
        wide = found[kind]["ranges"]
        assert wide["phi_top_deg"][0] <= one["phi_top_deg"][0] + 0.3 and wide["phi_top_deg"][1] >= one["phi_top_deg"][1] - 0.3
        assert inside(0.0, wide["phi_growth_deg"]) and inside(0.0, wide["density_growth_kg_m3"])


def test_friction_that_falls_with_stress_is_told_as_what_it_looks_like(soilctl, made, tmp_path):
    """One soil whose friction angle falls by 7 deg a decade; stress goes with depth."""
    rows = []
    for depth_m in (0.01, 0.03, 0.09):
        phi = 38.0 - 7.0 * math.log10(depth_m / 0.03)
        rows += made.strokes(lambda _, phi=phi: (phi, 1550.0), 2, depths=(depth_m,), angles=(50.0, 80.0), noise=0.0, repeats=1)
    for row in rows:
        row["force_sd_n"] = f"{0.05 * float(row['force_n']):.6f}"
    path = write(tmp_path / "law.csv", rows)
    answer = ask(soilctl, path, *OPTIONS[:-1], "0.1", "--uncertainty", "bounds")
    found = kinds(answer)
    assert not found["one-soil"]["consistent"] and found["gradient"]["consistent"]
    assert found["gradient"]["ranges"]["phi_growth_deg"][1] < 0.0
    law = answer["friction_law"]
    assert law["consistent"] and inside(7.0, law["left"])
    assert "But one soil with friction that falls with stress" in answer["verdict"]


def test_what_a_profile_cannot_be_is_refused(soilctl, made, tmp_path):
    rows = list(made.strokes(lambda _: (36.0, 1550.0), 5, depths=(0.03, 0.06), angles=(50.0, 80.0), repeats=1))
    both = write(tmp_path / "both.csv", rows)
    flat = write(tmp_path / "flat.csv", [row for row in rows if row["depth_m"] == "0.03"])
    steep = write(tmp_path / "steep.csv", [{**row, "alpha_deg": "110"} for row in rows])
    for path, options, words in [
        (both, ["--cohesion", "200"], "--cohesion is 200 Pa"),
        (both, ["--beta", "5"], "--beta is 5 deg"),
        (both, ["--next-depth", "0.3"], "1.5 times the deepest stroke"),
        (flat, [], "differ by a factor of 1.2"),
        (steep, [], "no stroke at a tool angle of at most 90 deg"),
    ]:
        done = soilctl("profile", path, *OPTIONS, *options, code=2)
        assert words in done.stderr, done.stderr
