"""Figures of soilctl.plot: that they show what they are given."""

import numpy as np
import pytest

import soilctl

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
plot = pytest.importorskip("soilctl.plot")

FORCES = {"tool_angle_deg": [70.0, 90.0], "depth_m": 0.025, "width_m": 0.127, "model": "chen"}


@pytest.fixture(autouse=True)
def closed():
    yield
    matplotlib.pyplot.close("all")


def test_a_region_is_drawn_where_it_is():
    found = soilctl.estimate(**FORCES, force_n=[4.0, 8.9], force_error_n=0.7, interface_friction_deg=(22.0, 24.0))
    axes = plot.region(found, label="all strokes")
    (patch,) = axes.patches
    box = patch.get_path().get_extents()
    assert (box.x0, box.x1) == pytest.approx(found.friction_angle_deg)
    assert (box.y0, box.y1) == pytest.approx(found.density_kg_m3)
    assert "degrees" in axes.get_xlabel() and "kg/m" in axes.get_ylabel()


def test_no_soil_is_said():
    found = soilctl.estimate(**FORCES, force_n=[4.0, 80.0], force_error_n=0.01, interface_friction_deg=(22.0, 24.0))
    assert [text.get_text() for text in plot.region(found).texts] == ["no soil is consistent"]


def test_brackets_and_meshes_are_drawn(tmp_path):
    angles = [80.0, 60.0]
    found = [
        soilctl.bound(tool_angle_deg=a, friction_angle_deg=30.0, interface_friction_deg=10.0, max_gap=0.1)
        for a in angles
    ]
    axes = plot.brackets(angles, found)
    low = axes.lines[0].get_ydata()
    np.testing.assert_array_equal(low, [found[1].lower, found[0].lower])
    for bound in ("upper", "lower"):
        axes = plot.mesh(found[0].solution, bound=bound)
        axes.figure.savefig(tmp_path / f"{bound}.png")
        assert (tmp_path / f"{bound}.png").stat().st_size > 5000
