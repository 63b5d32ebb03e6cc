"""`soilctl estimate` with cohesion, adhesion, surcharge and slope as unknowns, against wedges and counts of its own."""

import functools

import numpy as np
import pytest
import reference
import shapely
from scipy.optimize import minimize_scalar

WIDTH_M = 0.127
ALPHAS_DEG = [60.0, 75.0, 90.0]
DEPTHS_M = [0.015, 0.03, 0.06]
TRUTH = {"phi_deg": 35.0, "delta_deg": 20.0, "density_kg_m3": 1600.0, "cohesion_pa": 150.0, "surcharge_pa": 40.0, "beta_deg": 0.5}
SD_REL = 0.04


def wedge_n_per_m(alpha, beta, phi, delta, theta, weight, surcharge, cohesion):
    """Force of a plate of slant length 1 on the wedge above a plane that rises at theta, by the balance of forces; all in rad and SI.

    With negative friction and cohesion it is the thrust of a wedge that gives way.
    """
    plate, plane = np.array([-np.cos(alpha), np.sin(alpha)]), np.array([np.cos(theta), np.sin(theta)])
    surface = np.array([np.cos(beta), np.sin(beta)])
    # plate + r surface = s plane
    r, s = np.linalg.solve(np.column_stack([-surface, plane]), plate)
    area = 0.5 * abs(plate[0] * plane[1] - plate[1] * plane[0]) * s
    force = np.array([np.sin(alpha), np.cos(alpha)]) * np.cos(delta) - plate * np.sin(delta)
    normal = np.array([-np.sin(theta), np.cos(theta)]) - np.tan(phi) * plane
    other = cohesion * s * plane + np.array([0.0, weight * area + surcharge * r])
    return np.linalg.solve(np.column_stack([force, normal]), other)[0]


@functools.cache
def factors(alpha_deg, beta_deg, phi_deg, delta_deg):
    """Net factors of weight (per unit weight), surcharge and cohesion on the planes that are critical for the weight."""
    alpha, beta, phi, delta = np.radians([alpha_deg, beta_deg, phi_deg, delta_deg])
    sides = []
    for sign, a, b in ((1.0, alpha, beta), (-1.0, np.pi - alpha, -beta)):
        p, d = sign * phi, sign * delta
        high = np.pi - alpha - delta - phi if sign > 0 else alpha
        by_weight = lambda theta: sign * wedge_n_per_m(a, b, p, d, theta, 1.0, 0.0, 0.0)
        grid = np.linspace(b + 1e-3, high - 1e-3, 60)
        values = np.array([by_weight(theta) for theta in grid])
        values[values * sign <= 0] = np.inf
        best = int(np.argmin(values))
        bracket = grid[max(best - 1, 0)], grid[min(best + 1, 59)]
        theta = minimize_scalar(by_weight, bounds=bracket, method="bounded", options={"xatol": 1e-10}).x
        sides.append(
            np.array([
                wedge_n_per_m(a, b, p, d, theta, 1.0, 0.0, 0.0),
                wedge_n_per_m(a, b, p, d, theta, 0.0, 1.0, 0.0),
                wedge_n_per_m(a, b, p, d, theta, 0.0, 0.0, sign),
            ])
        )
    return sides[0] - sides[1]


def force_n(alpha_deg, depth_m, beta_deg, phi_deg, delta_deg, density, surcharge, cohesion):
    length = depth_m / np.sin(np.radians(alpha_deg))
    weight, on_top, sticking = factors(alpha_deg, beta_deg, phi_deg, delta_deg)
    pressure = density * reference.GRAVITY_M_S2 * length * weight + surcharge * on_top + cohesion * sticking
    return pressure * length * WIDTH_M


def write(path, depths_m, off, cohesion=TRUTH["cohesion_pa"], surcharge=TRUTH["surcharge_pa"], beta=TRUTH["beta_deg"]):
    rows = ["alpha_deg,depth_m,width_m,force_n,force_sd_n"]
    strokes = [(alpha, depth) for depth in depths_m for alpha in ALPHAS_DEG]
    for (alpha, depth), e in zip(strokes, off, strict=False):
        true = force_n(alpha, depth, beta, TRUTH["phi_deg"], TRUTH["delta_deg"], TRUTH["density_kg_m3"], surcharge, cohesion)
        rows.append(f"{alpha!r},{depth!r},{WIDTH_M},{float(true * (1 + e * SD_REL))!r},{float(true * SD_REL * (1 + SD_REL))!r}")
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return path


OFF = [0.6, -0.4, 0.1, -0.8, 0.3, 0.9, -0.2, 0.5, -0.7]
COMMON = ["--model", "coulomb", "--delta", 20, "--sigma", 1, "--phi-range", "20:50"]


@pytest.fixture(scope="module")
def ladder(tmp_path_factory):
    return write(tmp_path_factory.mktemp("unknowns") / "strokes.csv", DEPTHS_M, OFF)


def test_the_wedge_has_coulombs_weight():
    for alpha, phi, delta, beta in ((60, 35, 20, 0), (90, 30, 10, 4), (75, 40, 25, -3)):
        published = reference.coulomb_k_net_slant(alpha, phi, delta, beta)
        assert 2 * factors(alpha, beta, phi, delta)[0] == pytest.approx(published, rel=1e-6)


def shapes(answer):
    return {
        (pair["x"], pair["y"]): shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in pair["polygons"]])
        for pair in answer["unknowns"]["pairs"]
    }


def test_the_truth_is_in_every_range_and_pair(soilctl, validate, ladder):
    answer = soilctl.json(
        "estimate", ladder, *COMMON, "--cohesion-range", "0:400", "--surcharge-range", "0:100", "--beta-range=-1:2", "--costs"
    )
    validate(answer)
    names = [quantity["name"] for quantity in answer["unknowns"]["quantities"]]
    assert names == ["phi_deg", "delta_deg", "beta_deg", "density_kg_m3", "cohesion_pa", "surcharge_pa"]
    for quantity in answer["unknowns"]["quantities"]:
        low, high = quantity["range"]
        assert low <= TRUTH[quantity["name"]] <= high
        assert quantity["known"][0] - 1e-6 <= low <= high <= quantity["known"][1] + 1e-6
    found = shapes(answer)
    assert len(found) == 15
    for (x, y), shape in found.items():
        assert shape.contains(shapely.Point(TRUTH[x], TRUTH[y])), (x, y)
    assert answer["phi_deg"] == answer["unknowns"]["quantities"][0]["range"]
    # To know one of them never widens the others by more than the cover leaves open.
    width = answer["phi_deg"][1] - answer["phi_deg"][0]
    costs = {cost["name"]: cost for cost in answer["unknowns"]["costs"]}
    assert set(costs) == set(names) - {"phi_deg"}
    assert all(cost["phi_width_deg"] < 1.02 * width for cost in costs.values())
    assert answer["best_estimate"] is None and answer["volume_deg2_kg_m3"] is None and answer["slip_stress_pa"] is None


def test_the_region_is_the_one_that_is_counted(soilctl, ladder, tmp_path):
    """With friction on the plate, slope and surcharge known, cohesion at each friction angle and density is an interval: no cover is needed."""
    known = write(tmp_path / "strokes.csv", DEPTHS_M, OFF, surcharge=0.0, beta=0.0)
    answer = soilctl.json("estimate", known, *COMMON, "--delta-tol", 0, "--cohesion-range", "0:400")
    region = shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in answer["region"]])
    rows = np.genfromtxt(known, delimiter=",", names=True)
    phis = np.arange(20.05, 48.0, 0.1)
    densities = np.arange(101.0, 5000.0, 2.0)
    area, missed, columns = 0.0, 0, []
    for phi in phis:
        low, high = np.zeros_like(densities), np.full_like(densities, 400.0)
        for row in rows:
            weight, _, sticking = factors(float(row["alpha_deg"]), 0.0, float(phi), 20.0)
            length = row["depth_m"] / np.sin(np.radians(row["alpha_deg"]))
            area_m2 = length * WIDTH_M
            by_weight = densities * reference.GRAVITY_M_S2 * length * weight * area_m2
            low = np.fmax(low, (row["force_n"] - row["force_sd_n"] - by_weight) / (area_m2 * sticking))
            high = np.fmin(high, (row["force_n"] + row["force_sd_n"] - by_weight) / (area_m2 * sticking))
        inside = densities[low <= high]
        area += 2.0 * 0.1 * len(inside)
        columns += [(phi, density) for density in inside[[0, -1]]] if len(inside) else []
        missed += sum(not region.contains(shapely.Point(phi, density)) for density in inside)
    assert missed == 0
    # Each piece of the region is an octagon, a little larger than the slanting band that it encloses; its extent is that of the count.
    assert 0.99 * area < region.area < 1.15 * area, (region.area, area)
    counted = np.array(columns)
    assert np.allclose(answer["phi_deg"], [counted[:, 0].min(), counted[:, 0].max()], atol=0.2)
    assert np.allclose(answer["density_kg_m3"], [counted[:, 1].min(), counted[:, 1].max()], atol=20.0)


def test_one_depth_tells_no_cohesion_from_weight_and_it_is_said(soilctl, tmp_path):
    file = write(tmp_path / "strokes.csv", [0.03], OFF)
    answer = soilctl.json("estimate", file, *COMMON, "--cohesion-range", "0:400", "--surcharge-range", "0:100")
    said = " ".join(answer["warnings"])
    assert "strokes of one depth (30 to 30 mm) can hardly tell" in said and "cannot be told apart by depth" in said
    text = soilctl("estimate", file, *COMMON, "--cohesion-range", "0:400").stdout
    assert "unknown" in text and "cohesion (Pa)" in text


def test_what_contradicts_itself_is_said_with_what_was_known(soilctl, ladder):
    answer = soilctl.json("estimate", ladder, *COMMON, "--cohesion-range", "1000:2000", code=1)
    assert answer["consistent"] is False and "cohesion 1000 to 2000 Pa" in answer["verdict"]
    assert all(quantity["range"] is None for quantity in answer["unknowns"]["quantities"])


def test_what_takes_them_as_known_refuses_in_words(soilctl, ladder):
    for words, said in (
        (["--cohesion-range", "0:400", "--model", "table"], "no term for cohesion"),
        (["--beta-range=-2:2", "--model", "mckyes"], "beta"),
        (["--beta-range=-30:2"], "steeper than the friction angle"),
        (["--cohesion-range", "5:1"], "LOW must be at most HIGH"),
        (["--cohesion-range=-5:1"], "the cohesion is known as -5 to 1 Pa"),
        (["--cohesion-range", "0:9", "--cohesion", "3"], "cannot be used with"),
        (["--cohesion-range", "0:9", "--next-strokes"], "--next-strokes takes cohesion"),
        (["--cohesion-range", "0:9", "--friction-law"], "--friction-law takes cohesion"),
        (["--costs"], "--costs tells"),
    ):
        options = [word for word in COMMON if "--model" not in words or word not in ("--model", "coulomb")]
        done = soilctl("estimate", ladder, *options, *words, code=2)
        assert said in done.stderr, (words, done.stderr)
