"""Water that flows, against exact flow nets and finite elements of another formulation."""

import csv
import math

import numpy as np
import pytest
from conftest import DATA
from scipy.interpolate import LinearNDInterpolator
from scipy.optimize import minimize
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve
from scipy.special import ellipk

LAYER = """
default_boundary = "smooth"
objective = {{kind = "strength-reduction"}}
[[soil]]
name = "sand"
phi_deg = 34
cohesion_kpa = 1
unit_weight_kn_m3 = 20
permeability_m_per_s = 2e-5
[[region]]
soil = "sand"
polygon = [[-40, -10], [40, -10], [40, 0], [-40, 0]]
[[boundary]]
kind = "free"
sides = ["top"]
[[plate]]
name = "wall"
line = [[0, 0], [0, {foot}]]
held = "fixed"
[[head]]
name = "above"
line = [[-40, 0], [0, 0]]
head_m = 3
[[head]]
name = "below"
line = [[0, 0], [40, 0]]
head_m = 1
"""

SILT = """
[[soil]]
name = "silt"
phi_deg = 28
cohesion_kpa = 2
unit_weight_kn_m3 = 20
"""
SILT_BELOW = """
[[region]]
soil = "silt"
polygon = [[-40, -12], [40, -12], [40, -10], [-40, -10]]
"""


@pytest.mark.parametrize("depth", [1.0, 2.5, 5.0, 7.5])
def test_flow_around_a_sheet_pile(soilctl, tmp_path, depth):
    """Harr (1962): q / (k h) = K' / (2 K) with the modulus sin(pi s / 2 T)."""
    file = tmp_path / "layer.toml"
    file.write_text(LAYER.format(foot=-depth))
    seepage = soilctl.json("solve", file, "--check")["seepage"]
    m = math.sin(math.pi * depth / 20) ** 2
    exact = 2e-5 * 2 * ellipk(1 - m) / (2 * ellipk(m))
    if depth == 1.0:
        # In ground without end the gradient beside the pile is h / (pi s).
        assert seepage["exit_gradient"] == pytest.approx(2 / math.pi, rel=0.03)
    above, below = (head["inflow"] for head in seepage["heads"])
    assert seepage["in_m2_per_s"]
    assert above == pytest.approx(exact, rel=0.02)
    assert above + below == pytest.approx(0, abs=1e-9 * exact)
    # Half of the loss is on either side, and the pressure is least certain at the foot, where it has a square root.
    assert seepage["kept_within_kpa"] < 0.1 * 9.81 * 2
    assert seepage["found_within_kpa"] < 0.05 * 9.81 * 2


def extended_pressure(outline, level, size):
    """Pressure heads in a dam on rock by the extended pressure method: zero above the free surface, weight of the water there taken
    away by a step that is smoothed (Brezis, Kinderlehrer and Stampacchia). A mapped grid, x along the base; returns points, triangles and
    pressures."""
    (left, right), (crest_left, crest_right), high = outline
    nx, ny = int((right - left) / size), int(2 * high / size)
    eta = np.linspace(0, 1, ny + 1)
    up = right + (crest_right - right) * eta
    low = left + (crest_left - left) * eta
    s = np.linspace(0, 1, nx + 1)
    x = low[None, :] + s[:, None] * (up - low)[None, :]
    y = np.broadcast_to(high * eta, x.shape)
    points = np.c_[x.ravel(), y.ravel()]
    index = np.arange(points.shape[0]).reshape(nx + 1, ny + 1)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    triangles = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    p = points[triangles]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    area = 0.5 * (e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0])
    roll = [(p[:, (k + 1) % 3], p[:, (k + 2) % 3]) for k in range(3)]
    g = np.stack([np.stack([q[:, 1] - r[:, 1], r[:, 0] - q[:, 0]], -1) for q, r in roll], 1) / (2 * area)[:, None, None]
    stiffness = np.einsum("eai,ebi,e->eab", g, g, area)
    rows, columns = np.repeat(triangles, 3, 1).ravel(), np.tile(triangles, (1, 3)).ravel()
    count = len(points)
    whole = csr_matrix((stiffness.ravel(), (rows, columns)), (count, count))
    fixed = {}
    for j in range(ny + 1):
        fixed[index[0, j]] = max(0.0, level - points[index[0, j], 1])
        fixed[index[nx, j]] = 0.0
    for i in range(nx + 1):
        fixed.setdefault(index[i, ny], 0.0)
    held = np.array(sorted(fixed))
    free = np.setdiff1d(np.arange(count), held)
    pressure = np.maximum(0, 0.6 * level - points[:, 1])
    pressure[held] = [fixed[k] for k in held]
    step = np.ptp(p[:, :, 1], axis=1)
    down = g[:, :, 1]

    def parts(pressure):
        mean = pressure[triangles].mean(1)
        return np.clip(mean / step, 0, 1), ((mean > 0) & (mean < step)) / step / 3

    def residual(pressure):
        found = whole @ pressure
        np.add.at(found, triangles.ravel(), (down * (parts(pressure)[0] * area)[:, None]).ravel())
        return found

    for _ in range(60):
        now = residual(pressure)
        norm = np.linalg.norm(now[free])
        if norm < 1e-9:
            break
        growth = np.einsum("ea,e->ea", down, parts(pressure)[1] * area)[:, :, None] * np.ones(3)
        jacobian = whole + csr_matrix((growth.ravel(), (rows, columns)), (count, count))
        change = spsolve(jacobian[free][:, free].tocsc(), -now[free])
        part = 1.0
        while part > 1e-3:
            tried = pressure.copy()
            tried[free] += part * change
            if np.linalg.norm(residual(tried)[free]) < (1 - 0.1 * part) * norm:
                break
            part /= 2
        pressure = tried
    assert norm < 1e-9
    inflow = residual(pressure)[index[0]].sum()
    return x, y, pressure.reshape(x.shape), inflow


def test_a_dam_by_another_formulation(soilctl, tmp_path):
    figure = tmp_path / "dam.csv"
    answer = soilctl.json("solve", DATA / "problems/dam_seepage.toml", "--check", "--plot", figure)
    seepage = answer["seepage"]
    x, y, pressure, inflow = extended_pressure(((0, 24), (10, 14), 5), 4, 0.2)
    assert seepage["heads"][0]["inflow"] == pytest.approx(1e-6 * inflow, rel=0.03)
    assert seepage["out_in_air"] == pytest.approx(seepage["heads"][0]["inflow"], rel=1e-6)
    assert seepage["greatest_kpa"] == pytest.approx(4 * 9.81, rel=1e-9)
    with figure.open(encoding="utf-8") as file:
        named = [row for row in csv.DictReader(file) if row["name"] == "phreatic surface"]
    surface = [(float(row["x"]), float(row["y"])) for row in named]
    assert len(surface) > 20
    for at in (11.0, 13.0, 15.0, 17.0):
        column = np.argmin(np.abs(x - at), axis=0)
        heights = y[column, np.arange(y.shape[1])]
        wet = pressure[column, np.arange(y.shape[1])] > 0.05
        theirs = heights[wet].max()
        ours = min(surface, key=lambda p: abs(p[0] - at))[1]
        assert ours == pytest.approx(theirs, abs=0.2), at


def bishop(circle, water, friction, cohesion, weight):
    """Bishop's simplified factor of safety of the dam for a circle through its ground at two x, with the depth of the arc below the chord; what is
    below the rock slides along it."""
    start, end, depth = circle
    ground = [np.interp(at, [0, 10, 14, 24], [0, 5, 5, 0]) for at in (start, end)]
    chord = np.array([end - start, ground[1] - ground[0]])
    length = np.hypot(*chord)
    radius = (length**2 / 4 + depth**2) / (2 * depth)
    normal = np.array([-chord[1], chord[0]]) / length
    centre = np.array([start, ground[0]]) + chord / 2 + normal * (radius - depth)
    ends = np.linspace(start, end, 61)
    x, width = (ends[1:] + ends[:-1]) / 2, np.diff(ends)
    sine = (centre[0] - x) / radius
    bottom = centre[1] - radius * np.sqrt(np.maximum(1 - sine**2, 0))
    height = np.interp(x, [0, 10, 14, 24], [0, 5, 5, 0]) - np.maximum(bottom, 0)
    if (abs(sine) > 0.98).any() or height.min() < 0:
        return 9.0
    on_rock = bottom <= 0
    sine = np.where(on_rock, 0, sine)
    cosine = np.sqrt(1 - sine**2)
    pressure = np.maximum(water(np.c_[x, np.maximum(bottom, 0)]), 0)
    heavy, tangent, factor = weight * height * width, math.tan(math.radians(friction)), 1.5
    for _ in range(60):
        borne = (cohesion * width + (heavy - pressure * width) * tangent) / (cosine + sine * tangent / factor)
        factor = borne.sum() / (heavy * sine).sum()
    return factor


def test_a_proof_with_seepage_is_proven_again_and_levels_are_swept(soilctl, tmp_path):
    file = tmp_path / "dam.toml"
    text = (DATA / "problems/dam_seepage.toml").read_text()
    file.write_text(text + '\n[[sweep]]\nparameter = "head.reservoir.head_m"\nvalues = [2, 4]\n')
    proof = tmp_path / "dam.json"
    answer = soilctl.json("solve", file, "--max-gap", 0.15, "--save", proof)
    low, high = answer["cases"]
    # More water, less safety; the one with more of it governs.
    assert high["upper"] < low["lower"]
    assert answer["seepage"]["heads"][0]["head_m"] == 4
    assert soilctl.json("certify", tmp_path / "dam.2.lower.json")["certified"]
    # Slices of another author's method, with pressures of another formulation.
    x, y, pressure, _ = extended_pressure(((0, 24), (10, 14), 5), 4, 0.4)
    water = LinearNDInterpolator(np.c_[x.ravel(), y.ravel()], 9.81 * pressure.ravel(), fill_value=0)
    found = minimize(lambda circle: bishop(circle, water, 32, 5, 19), (13, 23.9, 1.8), method="Nelder-Mead", options={"maxfev": 60})
    assert 0.97 * high["lower"] < found.fun < 1.03 * high["upper"]
    words = soilctl("solve", file, "--check", code=0).stdout
    assert "flows in, m3/s per m" in words and "linear in" in words


def test_ground_that_needs_a_permeability_is_asked_for_it(soilctl, tmp_path):
    file = tmp_path / "layer.toml"
    file.write_text(LAYER.format(foot=-5).replace("permeability_m_per_s = 2e-5\n", "") + "[water]\ntable = [[0, 0]]\n")
    soilctl.refuses("solve", file, "--check", mentions=["keep one"])
    stiff = LAYER.format(foot=-5).replace("permeability_m_per_s = 2e-5\n", "").replace("[[region]]", SILT + "[[region]]", 1)
    file.write_text(stiff + SILT_BELOW)
    soilctl.refuses("solve", file, "--check", mentions=["each needs permeability_m_per_s"])


def test_any_water_level_can_be_cut(soilctl, tmp_path):
    # At the first of these levels lines that run together along the slope seemed to cross.
    text = (DATA / "problems/dam_seepage.toml").read_text()
    for head_m in [3.6125, *np.linspace(1, 4.8, 6)]:
        file = tmp_path / "dam.toml"
        file.write_text(text.replace("head_m = 4", f"head_m = {head_m}"))
        assert soilctl.json("solve", file, "--check")["seepage"]["heads"][0]["head_m"] == head_m
