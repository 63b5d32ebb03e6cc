"""`soilctl shear`: the curves of the four soils, and independent fits of the same points."""

import csv

import numpy as np
import pytest
import reference

PA_PER_PSI = 4.4482216152605 / 0.0254**2
# ln(phi in deg) = ln A + b ln(sigma in psi) through the four lowest loads.
POWER_LAWS = {
    "ticino_loose": (37.647, -0.0538),
    "nevada_fine": (34.020, -0.0694),
    "ticino_rained": (43.139, -0.0475),
    "glass_beads": (26.462, -0.0683),
}
STROKE = dict(alpha=90, depth=0.0254, width=0.127, density=1430, delta=15, force=7.1)


def points_of(data):
    """Stress in psi and friction angle in degrees of each soil, by stress."""
    points = {}
    with open(data / "direct_shear.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            pair = float(row["normal_stress_psi"]), float(row["friction_angle_deg"])
            points.setdefault(row["soil"], []).append(pair)
    return {soil: np.array(sorted(pairs)).T for soil, pairs in points.items()}


def options(values):
    return [word for key, value in values.items() for word in (f"--{key}", value)]


@pytest.fixture(scope="module")
def answer(soilctl, data):
    stroke = [*options(STROKE), "--carry-to", 100000]
    return soilctl.json("shear", data / "direct_shear.csv", "--stress", "800,3000", "--stress", 50000, *stroke)


@pytest.fixture(scope="module")
def soils(answer):
    return {soil["soil"]: soil for soil in answer["soils"]}


def test_answer_follows_the_schema(answer, validate):
    validate(answer)
    assert answer["schema"] == "soilctl.shear/1"
    assert [soil["soil"] for soil in answer["soils"]] == list(POWER_LAWS)


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_power_laws_are_those_of_an_independent_fit(soils, data, soil):
    stress, phi = points_of(data)[soil]
    low = stress < 2.5
    x, y = np.log(stress[low]), np.log(phi[low])
    b, ln_a = np.polyfit(x, y, 1)
    assert [np.exp(ln_a), b] == pytest.approx(POWER_LAWS[soil], rel=1e-3)
    fit = soils[soil]["power_law"]
    assert [fit["a_deg_at_1_psi"], fit["b"]] == pytest.approx([np.exp(ln_a), b], rel=1e-9)
    design = np.column_stack([np.ones_like(x), x])
    residuals = y - design @ [ln_a, b]
    errors = np.sqrt(np.diag(np.linalg.inv(design.T @ design)) * (residuals @ residuals) / (len(x) - 2))
    assert [fit["ln_a_standard_error"], fit["b_standard_error"]] == pytest.approx(errors, rel=1e-9)
    misfit = phi[low] - np.exp(design @ [ln_a, b])
    assert fit["rms_deg"] == pytest.approx(np.sqrt(np.mean(misfit**2)), rel=1e-9)
    assert fit["stress_range_pa"] == pytest.approx([0.18 * PA_PER_PSI, 2.33 * PA_PER_PSI], rel=1e-9)


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_no_break_of_a_grid_fits_better_than_slope_and_floor(soils, data, soil):
    stress, phi = points_of(data)[soil]
    x = np.log10(stress)
    least = np.inf
    for at in np.linspace(x[0], x[-1], 2001)[1:]:
        design = np.column_stack([np.ones_like(x), np.maximum(0, at - x)])
        found = np.linalg.lstsq(design, phi, rcond=None)[0]
        if found[1] >= 0:
            least = min(least, np.sqrt(np.mean((phi - design @ found) ** 2)))
    fit = soils[soil]["slope_floor"]
    assert fit["rms_deg"] <= least + 1e-9
    assert fit["rms_deg"] == pytest.approx(least, rel=1e-4)
    decades = np.maximum(0, np.log10(fit["floor_stress_pa"] / PA_PER_PSI) - x)
    curve = fit["floor_deg"] + fit["slope_deg_per_decade"] * decades
    assert [point["slope_floor_deg"] for point in soils[soil]["points"]] == pytest.approx(curve, rel=1e-9)
    worst = max(phi - curve, key=abs)
    assert fit["worst_residual_deg"] == pytest.approx(worst, rel=1e-9)


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_constants_are_means(soils, data, soil):
    _, phi = points_of(data)[soil]
    fit = soils[soil]["constant"]
    assert [fit["friction_angle_deg"], fit["rms_deg"]] == pytest.approx([np.mean(phi), np.std(phi)], rel=1e-9)


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_extrapolation_is_flagged(soils, answer, soil):
    flags = {(at["normal_stress_pa"], at["curve"]): at["extrapolated"] for at in soils[soil]["at"]}
    assert flags == {
        (800, "power law"): True,
        (800, "slope and floor"): True,
        (3000, "power law"): False,
        (3000, "slope and floor"): False,
        (50000, "power law"): True,
        (50000, "slope and floor"): False,
    }
    assert any(soil in text and "lowest tested load" in text for text in answer["warnings"])


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_stresses_of_the_stroke_touch_the_failure_line(soils, soil):
    stroke = soils[soil]["stroke"]
    assert len(stroke["points"]) == 4
    for point in stroke["points"]:
        overburden = STROKE["density"] * reference.GRAVITY_M_S2 * point["point_depth_m"]
        phi = np.radians(point["friction_at_low_stress_deg"])
        low = overburden * (1 + np.sin(phi)) * np.cos(phi)
        assert point["low_stress_pa"] == pytest.approx(low, rel=1e-9)
        # The circle through the stresses on the plate that is tangent to the failure line at sigma_U.
        phi, delta = np.radians([point["friction_at_high_stress_deg"], STROKE["delta"]])
        pressure = 2 * STROKE["force"] * point["point_fraction"] / (STROKE["width"] * STROKE["depth"])
        assert point["plate_pressure_pa"] == pytest.approx(pressure, rel=1e-9)
        centre = point["high_stress_pa"] / np.cos(phi) ** 2
        normal = (1 - np.sin(phi)) * overburden + pressure * np.cos(delta)
        radius = np.hypot(normal - centre, pressure * np.sin(delta))
        assert radius == pytest.approx(centre * np.sin(phi), rel=1e-6)
    assert all(shift["shift_deg"] < 0 for shift in stroke["carried"])


@pytest.mark.parametrize("with_loop", [True, False])
def test_raw_records_give_their_truth_back(soilctl, data, validate, with_loop):
    folder = data / "direct_shear_raw"
    loop = ["--loop", folder / "loop.csv"] if with_loop else []
    answer = soilctl.json("shear", "--raw", folder / "runs.csv", *loop, "--bias", 0.85, "--soil-name", "synthetic")
    validate(answer)
    soil, raw = answer["soils"][0], answer["raw"]
    assert soil["soil"] == "synthetic"
    assert len(raw["loads"]) == 7
    assert len(raw["runs"]) == 19
    assert (raw["machine_friction_n"] is None) != with_loop
    for point in soil["points"]:
        truth = 32 + 6 * max(0, np.log10(34474 / point["normal_stress_pa"]))
        assert point["friction_angle_deg"] == pytest.approx(truth, abs=0.3 if with_loop else 1.1)


def test_too_few_points_give_null_and_a_warning(soilctl, tmp_path, validate):
    file = tmp_path / "shear.csv"
    file.write_text("normal_stress_pa,friction_angle_deg\n1000,40\n2000,39\n", encoding="utf-8")
    answer = soilctl.json("shear", file)
    validate(answer)
    assert answer["soils"][0]["soil"] is None
    assert answer["soils"][0]["slope_floor"] is None
    assert any("at least 3" in text for text in answer["warnings"])


@pytest.mark.parametrize(
    ("content", "mentions"),
    [
        (b"", []),
        (b"soil,normal_stress_psi\na,1\n", ["friction_angle_deg"]),
        (b"soil,normal_stress_psi,friction_angle_deg\na,1,x\n", ["friction_angle_deg", "x", "line 2"]),
        (b"soil,normal_stress_psi,friction_angle_deg\na,-1,30\n", ["normal_stress_psi", "-1", "line 2"]),
        (b"soil,normal_stress_psi,friction_angle_deg\na,0,30\n", ["normal_stress_psi", "0", "line 2"]),
        (b"soil,normal_stress_psi,friction_angle_deg\na,1,95\n", ["friction_angle_deg", "95", "line 2"]),
        (b"soil,normal_stress_psi,friction_angle_deg\na,1,30\n", ["no curve can be fitted"]),
        (b"soil,normal_stress_psi,friction_angle_deg\n\xff,1,30\n", ["line 2", "UTF-8"]),
    ],
)
def test_bad_files_are_refused(soilctl, tmp_path, content, mentions):
    file = tmp_path / "shear.csv"
    file.write_bytes(content)
    soilctl.refuses("shear", file, mentions=["shear.csv", *mentions])
