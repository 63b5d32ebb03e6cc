"""`soilctl shear`: the power laws of the four soils, and an independent fit of the same points."""

import csv

import numpy as np
import pytest

# ln(phi in deg) = ln A + b ln(sigma in psi) through the four lowest loads.
POWER_LAWS = {
    "ticino_loose": (37.647, -0.0538),
    "nevada_fine": (34.020, -0.0694),
    "ticino_rained": (43.139, -0.0475),
    "glass_beads": (26.462, -0.0683),
}


def low_loads(data):
    """Stress in psi and friction angle in degrees of the four lowest loads of each soil."""
    points = {}
    with open(data / "direct_shear.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            pair = float(row["normal_stress_psi"]), float(row["friction_angle_deg"])
            points.setdefault(row["soil"], []).append(pair)
    return {soil: np.array(sorted(pairs)[:4]) for soil, pairs in points.items()}


def numbers_of(value):
    """Every number inside a JSON value."""
    if isinstance(value, dict):
        return [n for inner in value.values() for n in numbers_of(inner)]
    if isinstance(value, list):
        return [n for inner in value for n in numbers_of(inner)]
    return [value] if isinstance(value, (int, float)) and not isinstance(value, bool) else []


def part_of(value, soil):
    """The part of a JSON value that belongs to a soil: under its name, or with its name among the values."""
    if isinstance(value, dict):
        if soil in value:
            return value[soil]
        if soil in value.values():
            return value
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
    return next((found for v in inner if (found := part_of(v, soil)) is not None), None)


@pytest.fixture(scope="module")
def answer(soilctl, data):
    return soilctl.json("shear", data / "direct_shear.csv")


def test_answer_follows_the_schema(answer, validate):
    validate(answer)
    assert answer["schema"] == "soilctl.shear/1"


@pytest.mark.parametrize("soil", POWER_LAWS)
def test_power_laws_are_those_of_an_independent_fit(answer, data, soil):
    stress, phi = low_loads(data)[soil].T
    b, ln_a = np.polyfit(np.log(stress), np.log(phi), 1)
    assert [np.exp(ln_a), b] == pytest.approx(POWER_LAWS[soil], rel=1e-3)
    part = part_of(answer, soil)
    assert part is not None, f"{soil} is not in the answer"
    for expected in (np.exp(ln_a), b):
        assert any(n == pytest.approx(expected, rel=1e-3) for n in numbers_of(part)), (expected, part)


@pytest.mark.parametrize(
    ("content", "mentions"),
    [
        ("", []),
        ("soil,normal_stress_psi\na,1\n", ["friction_angle_deg"]),
        ("soil,normal_stress_psi,friction_angle_deg\na,1,x\n", ["friction_angle_deg", "x", "line 2"]),
        ("soil,normal_stress_psi,friction_angle_deg\na,-1,30\n", ["normal_stress_psi", "-1", "line 2"]),
        ("soil,normal_stress_psi,friction_angle_deg\na,1,95\n", ["friction_angle_deg", "95", "line 2"]),
    ],
)
def test_bad_files_are_refused(soilctl, tmp_path, content, mentions):
    file = tmp_path / "shear.csv"
    file.write_text(content, encoding="utf-8")
    soilctl.refuses("shear", file, mentions=["shear.csv", *mentions])
