"""Recordings of other arms, from a bag to its soil, with keyword arguments and tables in memory."""

from pathlib import Path

import pytest
import soilctl

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "data" / "other_arm"
ARM = {"urdf": FOLDER / "arm.urdf", "plate_frame": "blade_edge", "surface_z_m": 0.08, "width_m": 0.1}


@pytest.fixture(scope="module")
def found():
    return soilctl.process(FOLDER / "bag", **ARM)


def test_a_bag_leads_to_its_soil(found):
    pandas = pytest.importorskip("pandas")
    strokes = pandas.DataFrame(found.strokes)
    assert len(strokes) == 9 and set(strokes["alpha_deg"]) == {70.0, 80.0, 90.0}
    soil = soilctl.estimate(strokes, delta_deg=20)
    # As the recording's README has it.
    assert soil.consistent and soil.phi_deg[0] < 35.0 < soil.phi_deg[1] and soil.density_kg_m3[0] < 1500.0 < soil.density_kg_m3[1]


@pytest.mark.parametrize("kind", ["dict", "pandas"])
def test_windows_may_be_a_table(found, kind):
    contacts = found.logs[0].found.contacts[:2]
    windows = {"start": [c.from_s for c in contacts], "end": [c.to_s for c in contacts]}
    if kind == "pandas":
        windows = pytest.importorskip("pandas").DataFrame(windows)
    again = soilctl.process(FOLDER / "bag", strokes=windows, **ARM)
    assert [s.force_n for s in again.strokes] == pytest.approx([s.force_n for s in found.strokes[:2]], rel=0.01)
    with pytest.raises(soilctl.InputError, match="the table, line 2: end is 1 s, not after start, 2 s"):
        soilctl.process(FOLDER / "bag", strokes={"start": [2], "end": [1]}, **ARM)


def test_the_sense_of_the_wrench_is_an_argument():
    # All of it turned, the soil would push the plate ahead.
    found = soilctl.process(FOLDER / "bag", wrench_sense="plate-on-soil", **ARM)
    assert found.exit_code == 3 and not found.strokes
    reasons = [contact.reason for contact in found.logs[0].found.contacts]
    assert all("pushes the plate ahead" in reason for reason in reasons)
