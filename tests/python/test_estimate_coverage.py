"""`soilctl estimate` without an option: the region holds the true soil in at least 95 of 100 campaigns.

The strokes come from a generator that shares nothing with the program but the published tables: forces interpolated in
`data/plate_bounds.csv`, or Coulomb's closed form.
"""

import csv
import json
import math

import numpy as np
import pytest
import reference
from scipy.interpolate import RegularGridInterpolator

WIDTH_M = 0.127
GRAVITY_M_S2 = 9.80665


class Bounds:
    """Coefficients between the proven bounds, their logarithms interpolated in between, and a part of what ends add at most."""

    angles = (70.0, 80.0, 90.0, 100.0)
    options = ()

    def __init__(self, data):
        with open(data / "plate_bounds.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        axes = [sorted({float(row[key]) for row in rows}) for key in ("alpha_deg", "phi_deg", "delta_deg")]
        grid = np.full([*map(len, axes), 4], np.nan)
        for row in rows:
            place = [axis.index(float(row[key])) for axis, key in zip(axes, ("alpha_deg", "phi_deg", "delta_deg"), strict=True)]
            grid[tuple(place)] = np.log([float(row[key]) for key in ("lower", "upper", "ends_upper", "ends_term")])
        self.of = RegularGridInterpolator(axes, grid, method="linear")

    def force_n(self, alpha_deg, soil, delta_deg, depth_m):
        low, high, wide, term = self.of([alpha_deg, soil["phi_deg"], delta_deg])[0]
        slant_m = depth_m / math.sin(math.radians(alpha_deg))
        most = math.exp(wide) + math.exp(term) * depth_m / WIDTH_M - math.exp(high)
        coefficient = math.exp(low + soil["place"] * (high - low)) + soil["end_factor"] * most
        return 0.5 * soil["density_kg_m3"] * GRAVITY_M_S2 * slant_m**2 * WIDTH_M * coefficient


class Coulomb:
    """Coulomb's formula, a point model: nothing but the bands leaves room."""

    angles = (50.0, 65.0, 80.0, 90.0)
    options = ("--model", "coulomb")

    def __init__(self, data):
        pass

    def force_n(self, alpha_deg, soil, delta_deg, depth_m):
        return float(reference.coulomb_force_n(alpha_deg, soil["phi_deg"], delta_deg, soil["density_kg_m3"], depth_m, WIDTH_M))


def campaign(model, random, *, repeats, stated):
    """A soil and the table of its strokes.

    Each stroke has noise, a depth that is off, and friction on the plate about the set-point; all share the sensor's gain, the datum of
    depths, and what the soil ahead makes the forces of one kind differ from the model.
    """
    soil = {
        "phi_deg": random.uniform(30.0, 44.0),
        "density_kg_m3": random.uniform(1350.0, 1700.0),
        "place": random.uniform(0.0, 1.0),
        "end_factor": random.uniform(0.0, 1.0),
    }
    set_deg = random.uniform(14.0, 22.0)
    gain, datum_m = 1.0 + random.normal(0.0, 0.01), random.normal(0.0, 0.0002)
    rows = []
    for alpha_deg in model.angles:
        ahead = math.exp(random.normal(0.0, 0.02))
        for _ in range(repeats):
            true_depth_m = 0.025 * math.sin(math.radians(alpha_deg)) + random.normal(0.0, 0.0005)
            friction_deg = set_deg + random.normal(0.0, 0.7)
            force_n = gain * ahead * model.force_n(alpha_deg, soil, friction_deg, true_depth_m) * (1 + random.normal(0.0, 0.02))
            row = {
                "alpha_deg": alpha_deg,
                "depth_m": true_depth_m + datum_m + random.normal(0.0, 0.0006),
                "width_m": WIDTH_M,
                "delta_set_deg": set_deg,
                "force_n": force_n,
            }
            if stated:
                more = {"depth_sd_m": 0.0006, "force_sd_n": 0.02 * force_n, "friction_angle_deg": friction_deg + random.normal(0.0, 0.7)}
                row.update(more)
            rows.append(row)
    return soil, rows


def holds(answer, soil):
    """Whether the point is in the region, by the parity of boundary crossings."""
    x, y = soil["phi_deg"], soil["density_kg_m3"]
    crossings = 0
    for ring in (ring for polygon in answer["region"] for ring in polygon):
        for (x0, y0), (x1, y1) in zip(ring, [*ring[1:], ring[0]], strict=True):
            if (y0 > y) != (y1 > y):
                crossings += x0 + (y - y0) / (y1 - y0) * (x1 - x0) > x
    return crossings % 2 == 1


# Each call takes a fifth of a second, with bounds more.
@pytest.mark.parametrize("campaigns", [20, pytest.param(200, marks=pytest.mark.long)])
@pytest.mark.parametrize(("kind", "repeats", "stated"), [(Bounds, 4, True), (Coulomb, 3, True), (Coulomb, 5, False)])
def test_regions_hold_the_truth(soilctl, data, tmp_path, kind, repeats, stated, campaigns):
    model, random = kind(data), np.random.default_rng(2001)
    held, widths = 0, []
    for number in range(campaigns):
        soil, rows = campaign(model, random, repeats=repeats, stated=stated)
        file = tmp_path / f"{number}" / "strokes.csv"
        file.parent.mkdir()
        lines = [",".join(rows[0]), *(",".join(repr(float(value)) for value in row.values()) for row in rows)]
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = soilctl("estimate", file, *model.options, "--format", "json", "--quiet")
        answer = json.loads(done.stdout)
        assert answer["confidence"] == 0.95
        if answer["consistent"]:
            held += holds(answer, soil)
            ends = (*answer["phi_deg"], *answer["density_kg_m3"])
            widths.append((ends[1] - ends[0], (ends[3] - ends[2]) / soil["density_kg_m3"]))
    width = np.median(widths, axis=0)
    print(f"{kind.__name__}, {repeats} strokes a kind: {held} of {campaigns}, median widths {width[0]:.1f} deg, {100 * width[1]:.0f} %")
    assert held >= 0.95 * campaigns
    assert width[0] < 25.0
