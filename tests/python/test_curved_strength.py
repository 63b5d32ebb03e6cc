"""Strength that grows less and less with pressure, against slip lines by quadrature and a method of slices."""

import json
import math
import re

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq, minimize

STRIP = """
surcharge_kpa = {surcharge}
default_boundary = "free"
objective = {{kind = "structure", name = "footing", direction = [0, -1]}}
[[soil]]
name = "ground"
strength = {strength}
unit_weight_kn_m3 = 0
[[region]]
soil = "ground"
polygon = [[-14, -9], [14, -9], [14, 0], [-14, 0]]
[[boundary]]
kind = "fixed"
sides = ["left", "right", "bottom"]
[[structure]]
name = "footing"
edge = [[-1, 0], [1, 0]]
delta_deg = 20
"""


def prandtl(p, radius, dp, cos, from_, surcharge):
    """Pressure under a strip on weightless ground: p + R under it, where the integral of cos(phi)/(2 R) dp over the fan is a right angle.

    All are functions of one measure of pressure, which begins where p - R is the surcharge."""
    start = brentq(lambda x: p(x) - radius(x) - surcharge, *from_)
    turned = lambda end: (
        quad(lambda x: cos(x) / (2 * radius(x)) * dp(x), start, end, limit=500, epsrel=1e-11)[0] - math.pi / 2
    )
    far = 2 * start + 1
    while turned(far) < 0:
        far *= 2
    end = brentq(turned, start, far)
    return p(end) + radius(end)


def of_power(factor, exponent, tension, surcharge):
    """By the normal stress on the planes that slip."""
    tau = lambda x: factor * (x + tension) ** exponent
    slope = lambda x: exponent * tau(x) / (x + tension)
    bend = lambda x: (exponent - 1) * slope(x) / (x + tension)
    return prandtl(
        p=lambda x: x + tau(x) * slope(x),
        radius=lambda x: tau(x) * math.hypot(1, slope(x)),
        dp=lambda x: 1 + slope(x) ** 2 + tau(x) * bend(x),
        cos=lambda x: 1 / math.hypot(1, slope(x)),
        from_=(-tension + 1e-9 * (surcharge + tension), 1e4 * (surcharge + tension)),
        surcharge=surcharge,
    )


def of_friction_law(phi_deg, slope_deg, reference, most_deg, surcharge):
    """By the normal stress on the planes that slip."""
    k = math.radians(slope_deg) / math.log(10)
    kink = reference * math.exp(math.radians(phi_deg - most_deg) / k)
    phi = lambda x: math.radians(phi_deg) - k * math.log(x / reference)
    tau = lambda x: x * math.tan(phi(x))
    slope = lambda x: math.tan(phi(x)) - k / math.cos(phi(x)) ** 2
    bend = lambda x: -k / x / math.cos(phi(x)) ** 2 * (1 - 2 * k * math.tan(phi(x)))
    return prandtl(
        p=lambda x: x + tau(x) * slope(x),
        radius=lambda x: tau(x) * math.hypot(1, slope(x)),
        dp=lambda x: 1 + slope(x) ** 2 + tau(x) * bend(x),
        cos=lambda x: 1 / math.hypot(1, slope(x)),
        # The whole fan has stresses above the kink.
        from_=(1.001 * kink, 1e3 * surcharge),
        surcharge=surcharge,
    )


def of_hoek_brown(ucs, gsi, mi, disturbance):
    """By the least principal stress."""
    mb = mi * math.exp((gsi - 100) / (28 - 14 * disturbance))
    s = math.exp((gsi - 100) / (9 - 3 * disturbance))
    a = 0.5 + (math.exp(-gsi / 15) - math.exp(-20 / 3)) / 6
    radius = lambda x: 0.5 * ucs * (mb * x / ucs + s) ** a
    grows = lambda x: 0.5 * a * mb * (mb * x / ucs + s) ** (a - 1)
    return prandtl(
        p=lambda x: x + radius(x),
        radius=radius,
        dp=lambda x: 1 + grows(x),
        cos=lambda x: math.sqrt(1 - (grows(x) / (1 + grows(x))) ** 2),
        from_=(-1e-6 * s * ucs / mb, 1e-6 * ucs),
        surcharge=0,
    )


def test_the_quadrature_is_prandtl_s_for_a_straight_line():
    phi, cohesion = math.radians(25), 12.0
    nq = math.tan(math.pi / 4 + phi / 2) ** 2 * math.exp(math.pi * math.tan(phi))
    found = prandtl(
        p=lambda x: x,
        radius=lambda x: cohesion * math.cos(phi) + x * math.sin(phi),
        dp=lambda x: 1,
        cos=lambda x: math.cos(phi),
        from_=(0, 1e3),
        surcharge=7,
    )
    assert found == pytest.approx(7 * nq + cohesion * (nq - 1) / math.tan(phi), rel=1e-9)


@pytest.mark.parametrize(
    ("strength", "surcharge", "exact", "apart"),
    [
        ('{kind = "power", factor = 1.2, exponent = 0.85}', 10, of_power(1.2, 0.85, 0, 10), 0.08),
        (
            '{kind = "friction-law", phi_deg = 30, slope_deg_per_decade = 5, reference_kpa = 100, greatest_phi_deg = 45}',
            10,
            of_friction_law(30, 5, 100, 45, 10),
            0.08,
        ),
        ('{kind = "power", factor = 3, exponent = 0.6, tension_kpa = 5}', 0, of_power(3, 0.6, 5, 0), 0.08),
        ('{kind = "hoek-brown", ucs_mpa = 2, gsi = 25, mi = 6}', 0, of_hoek_brown(2000, 25, 6, 0), 0.18),
    ],
)
def test_strips_on_weightless_ground(soilctl, tmp_path, strength, surcharge, exact, apart):
    problem = tmp_path / "strip.toml"
    problem.write_text(STRIP.format(strength=strength, surcharge=surcharge))
    found = soilctl.json("solve", problem, "--max-gap", 0.02, "--max-work", 400_000, code=3)
    lower, upper = found["lower"], found["upper"]
    assert lower < 2 * exact < upper, (lower, 2 * exact, upper)
    assert upper - lower < apart * 2 * exact, (lower, 2 * exact, upper)


SLOPE = """
default_boundary = "free"
objective = {kind = "strength-reduction"}
[[soil]]
name = "fill"
strength = {kind = "points", points_kpa = [[0, 6], [40, 33], [120, 75], [400, 195]]}
unit_weight_kn_m3 = 19
[[region]]
soil = "fill"
polygon = [[0, 0], [30, 0], [30, 15], [20, 15], [5, 5], [0, 5]]
[[boundary]]
kind = "fixed"
sides = ["bottom"]
[[boundary]]
kind = "smooth"
sides = ["left", "right"]
"""


def bishop(out, into, bulge):
    """The factor of safety on a circle from (out, 5) to (into, 15) that bulges by so much below its chord, by Bishop's simplified method."""
    if not (0 < out <= 5 and 20 <= into < 30 and bulge > 0):
        return 99.0
    (x0, y0), (x1, y1) = (out, 5.0), (into, 15.0)
    chord = math.hypot(x1 - x0, y1 - y0)
    radius = (chord**2 / 4 + bulge**2) / (2 * bulge)
    middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2])
    up = np.array([y0 - y1, x1 - x0]) / chord
    cx, cy = middle + (radius - bulge) * up
    edges = np.linspace(x0, x1, 121)
    x, width = (edges[1:] + edges[:-1]) / 2, edges[1] - edges[0]
    base = cy - np.sqrt(radius**2 - (x - cx) ** 2)
    ground = np.interp(x, [0, 5, 20, 30], [5, 5, 15, 15])
    if np.any(base < 0) or np.any(base > ground + 1e-9):
        return 99.0
    sin, weight = (x - cx) / radius, 19 * (ground - base) * width
    cos = np.sqrt(1 - sin**2)
    strength = lambda sigma: np.interp(sigma, [-20, 0, 40, 120, 400], [-7.5, 6, 33, 75, 195])
    factor, shear = 1.5, np.zeros_like(x)
    for _ in range(200):
        shear = strength((weight - shear * width / cos * sin / factor) / cos / (width / cos))
        factor = np.sum(shear * width / cos) / np.sum(weight * sin)
    return factor


def test_a_slope_against_slices(soilctl, tmp_path):
    problem = tmp_path / "slope.toml"
    problem.write_text(SLOPE)
    found = soilctl.json("solve", problem, "--max-gap", 0.03)
    starts = [(4.5, 22.0, 3.0), (5.0, 24.0, 4.0), (4.9, 21.5, 2.5)]
    slices = min(minimize(lambda v: bishop(*v), start, method="Nelder-Mead").fun for start in starts)
    assert 0.98 * found["lower"] < slices < 1.02 * found["upper"], (found["lower"], slices, found["upper"])


def test_soil_after_davis_says_that_it_is_an_approximation(soilctl, tmp_path):
    problem = tmp_path / "slope.toml"
    soil = "phi_deg = 35\ncohesion_kpa = 8\ndilation_deg = 5"
    text = re.sub("strength = \\{.*", soil, SLOPE, count=1)
    problem.write_text(text)
    done = soilctl("solve", problem, "--check", code=0)
    assert "Davis" in done.stdout + done.stderr and "approximation" in done.stdout + done.stderr
    problem.write_text(text.replace("strength-reduction", "unit-weight"))
    soilctl("solve", problem, "--max-gap", 0.3, "--save", tmp_path / "slope.json", code=0)
    # What is proven is the lessened strength: tan(phi) times cos(psi) cos(phi)/(1 - sin(psi) sin(phi)).
    part = math.cos(math.radians(5)) / (1 - math.sin(math.radians(5)) * math.sin(math.radians(35)))
    material = json.loads((tmp_path / "slope.json").read_text())["statement"]["regions"][0]["material"]
    assert math.tan(math.radians(material["phi_deg"])) == pytest.approx(part * math.sin(math.radians(35)), rel=1e-12)


def test_what_is_certified_of_a_curved_strength_is_shown(soilctl, tmp_path):
    problem, saved = tmp_path / "slope.toml", tmp_path / "slope.lower.json"
    problem.write_text(SLOPE)
    soilctl("solve", problem, "--max-gap", 0.3, "--save", tmp_path / "slope.json", code=0)
    shown = soilctl("certify", saved, code=0).stdout
    assert "no more than these lines of friction and cohesion bear" in shown
    statement = json.loads(saved.read_text())
    for region in statement["statement"]["regions"]:
        region["material"]["envelope"]["inside"][0]["cohesion"] *= 0.5
    saved.write_text(json.dumps(statement))
    assert soilctl("certify", saved).returncode != 0
