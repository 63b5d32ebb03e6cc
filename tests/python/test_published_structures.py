"""Published structures of `data/published` whose values follow from statics, circles, planes or slip lines: all of these are computed anew, by
`scipy` and with nothing of ours, and compared with the files, with the values that stand beside them, and with the bounds of
`docs/verification/published.csv`, which `cargo xtask verify published` writes.
"""

import csv
import math
import tomllib
from pathlib import Path

import pytest
from scipy.integrate import quad
from scipy.optimize import brentq, minimize
from test_curved_strength import of_hoek_brown

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "data" / "published"


def rows(path):
    return {row["problem"]: row for row in csv.DictReader(path.read_text(encoding="utf-8").splitlines())}


PUBLISHED, FOUND = rows(FOLDER / "published.csv"), rows(ROOT / "docs" / "verification" / "published.csv")
WATER = 9.81


def problem(name):
    return tomllib.loads((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))


def published(name):
    return float(PUBLISHED[name]["published"])


def bounds(name):
    return float(FOUND[name]["lower"]), float(FOUND[name]["upper"])


class Rankine:
    """A smooth wall: active pressure behind it and passive pressure in front, of effective stress; water is as high on both sides."""

    def __init__(self, phi_deg, dry, wet, dug, water, load=0.0):
        self.active = math.tan(math.radians(45 - phi_deg / 2)) ** 2
        self.dry, self.wet, self.dug, self.water, self.load = dry, wet, dug, water, load

    def weight(self, top, z):
        """Effective weight between two depths."""
        above = lambda z: self.dry * min(z, self.water) + (self.wet - WATER) * max(z - self.water, 0)
        return above(z) - above(top)

    def net(self, z):
        behind = self.active * (self.load + self.weight(0, z))
        return behind - (self.weight(self.dug, z) / self.active if z > self.dug else 0)

    def force(self, z):
        return quad(self.net, 0, z, points=[min(self.water, z), min(self.dug, z)], limit=200)[0]

    def moment(self, z, about):
        """Of the pressures down to z about a depth."""
        return quad(lambda x: self.net(x) * (x - about), 0, z, points=[min(self.water, z), min(self.dug, z)], limit=200)[0]

    def free_earth(self, tie):
        """Length of a wall that turns about its tie, the tie's force, and the greatest moment."""
        length = brentq(lambda z: self.moment(z, tie), self.dug + 0.1, 5 * self.dug)
        force = self.force(length)
        hinge = brentq(lambda z: self.force(z) - force, tie, length - 0.5)
        return length, force, force * (hinge - tie) + self.moment(hinge, hinge)

    def cantilever(self):
        """The greatest moment of a wall that nothing holds but the ground."""
        hinge = brentq(self.force, self.dug + 0.1, 5 * self.dug)
        return -self.moment(hinge, hinge)


def test_the_tied_sheet_pile_of_the_textbook():
    """Its statics need the length, the anchor and the moment of the file; the book has 2.7 m below the point without pressure, and 344.9 kNm/m."""
    wall = Rankine(30, 16, 19.5, dug=9.15, water=3.05)
    length, force, moment = wall.free_earth(1.53)
    pile, tie = problem("das_anchored")["member"]
    assert -pile["line"][1][1] == pytest.approx(length, abs=2e-3)
    assert tie["tensile_kn_per_m"] == pytest.approx(force, abs=0.05)
    assert pile["moment_knm_per_m"] == pytest.approx(moment, abs=0.1) and moment == pytest.approx(344.9, rel=0.03)
    unpressed = brentq(wall.net, 9.15, 13)
    assert length - unpressed == pytest.approx(2.7, abs=0.05)
    lower, upper = bounds("das_anchored")
    assert lower <= published("das_anchored") <= upper < 1.04


def test_the_cantilever_sheet_pile_of_the_textbook():
    """The book has 209.39 kNm/m. Cohesion of 0.01 kPa adds less to the factor than the bounds are apart."""
    moment = Rankine(32, 15.9, 19.33, dug=5, water=2).cantilever()
    assert moment == pytest.approx(209.39, rel=2e-3)
    (pile,) = problem("das_cantilever")["member"]
    assert pile["moment_knm_per_m"] == pytest.approx(moment, abs=0.02)
    lower, upper = bounds("das_cantilever")
    assert lower <= published("das_cantilever") <= upper < 1.04


def test_the_tied_sheet_pile_by_eurocode_7():
    """DA1-2: tan(phi) over 1.25, variable loads times 1.3."""
    phi_d = math.degrees(math.atan(math.tan(math.radians(35)) / 1.25))
    length, force, moment = Rankine(phi_d, 18, 18, dug=5, water=100, load=13).free_earth(1)
    pile, tie = problem("ec7_sheet_pile")["member"]
    assert 0 <= -pile["line"][1][1] - length < 0.005
    assert 0 <= tie["tensile_kn_per_m"] - force < 0.2 and 0 <= pile["moment_knm_per_m"] - moment < 0.2
    lower, upper = bounds("ec7_sheet_pile")
    assert lower <= 1.005 and 1 <= upper < 1.04


def test_anchors():
    """Planes that lean out by the friction angle, and slip lines about a thin strip."""
    assert published("murray_geddes_sand") == pytest.approx(16 * 3 * (1 + 3 * math.tan(math.pi / 6)), abs=0.01)
    assert published("merifield_clay") == pytest.approx(10 * 2.56 * math.log(6), abs=0.01)
    assert published("rowe_deep_clay") == pytest.approx(10 * (3 * math.pi + 2), abs=0.01)
    # What is an upper bound is above what is proven from below; the two others are approximate, and exact for an endless depth.
    assert bounds("murray_geddes_sand")[0] <= published("murray_geddes_sand") <= bounds("murray_geddes_sand")[1] * 1.01
    lower, upper = bounds("rowe_deep_clay")
    assert lower <= published("rowe_deep_clay") <= upper
    # A column of clay that is lifted by shear along its sides.
    assert published("merifield_clay") * 0.98 <= bounds("merifield_clay")[0] <= 2 * 3 * 10


def circles(strengths, depth, width):
    """The least of all circles through an edge of a strip, in units of stress (Button 1953)."""
    upper, lower = strengths

    def pressure(centre):
        x, y = centre
        if y <= 0 or x <= width / 2:
            return math.inf
        radius = math.hypot(x, y)
        whole = math.acos(y / radius)
        inner = math.acos((y + depth) / radius) if radius > y + depth else 0.0
        return 2 * radius**2 * (upper * (whole - inner) + lower * inner) / (width * (x - width / 2))

    starts = [(a * width, b * width) for a in (0.7, 1, 1.5, 2) for b in (0.1, 0.4, 1, 2)]
    return min(minimize(pressure, start, method="Nelder-Mead", options={"maxiter": 4000, "fatol": 1e-10}).fun for start in starts)


def test_a_strip_on_two_layers_of_clay():
    assert circles([1, 1], 100, 1) == pytest.approx(5.52, abs=0.005)
    row = PUBLISHED["button_two_layers"]
    assert float(row["high"]) == pytest.approx(circles([20, 10], 0.5, 1), abs=0.01)
    assert float(row["low"]) == pytest.approx(20 * (1.5 * 0.5 + 5.14 * 0.5), abs=0.01)
    lower, upper = bounds("button_two_layers")
    assert float(row["low"]) < lower <= upper < float(row["high"])


def test_a_strip_on_rock():
    assert published("serrano_rock") == pytest.approx(2 * of_hoek_brown(2000, 25, 6, 0), abs=0.01)
    lower, upper = bounds("serrano_rock")
    assert lower <= published("serrano_rock") <= upper

