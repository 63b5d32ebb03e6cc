"""Estimates from arrays of measurements."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import soilctl

ALPHA = np.array([70.0, 80.0, 90.0, 100.0])
GEOMETRY = {"tool_angle_deg": ALPHA, "depth_m": 0.0254 * np.sin(np.radians(ALPHA)), "width_m": 0.127}


def forces(friction_angle_deg, density_kg_m3, interface_friction_deg=23.0):
    soil = {"friction_angle_deg": friction_angle_deg, "density_kg_m3": density_kg_m3}
    return soilctl.predict("chen", **GEOMETRY, **soil, interface_friction_deg=interface_friction_deg).force_n


def estimate(force_n, **more):
    options = {"force_error_n": 0.08 * force_n, "interface_friction_deg": (22.0, 24.0), "model": "chen", **more}
    return soilctl.estimate(**GEOMETRY, force_n=force_n, **options)


def test_the_true_soil_is_in_the_region():
    found = estimate(forces(41.0, 1600.0), density_kg_m3=(1500.0, 1700.0))
    assert found.consistent and found.contains(41.0, 1600.0) and not found.contains(20.0, 1600.0)
    low, high = found.friction_angle_deg
    assert low < 41.0 < high and found.area > 0
    assert found.best_fit["friction_angle_deg"] == pytest.approx(41.0, abs=1.5)


def test_the_region_is_geojson():
    found = estimate(forces(41.0, 1600.0))
    shape = found.__geo_interface__
    assert shape["type"] == "MultiPolygon"
    rings = [np.array(ring) for polygon in shape["coordinates"] for ring in polygon]
    assert all((ring[0] == ring[-1]).all() for ring in rings), "rings are closed"
    # The shoelace formula, holes negative.
    area = sum(0.5 * np.sum(r[:-1, 0] * r[1:, 1] - r[1:, 0] * r[:-1, 1]) for r in rings)
    assert area == pytest.approx(found.area, rel=1e-6)
    assert found._repr_svg_().startswith("<svg") and "consistent soils" in found._repr_html_()
    table = found.to_pandas()
    corners = table[["friction_angle_deg", "density_kg_m3"]].to_numpy()
    np.testing.assert_array_equal(corners, np.concatenate([ring[:-1] for ring in rings]))
    assert (table["ring"] == 0).any() and len(table) == sum(len(ring) - 1 for ring in rings)


def test_a_band_is_where_the_model_gives_the_measured_force():
    force = forces(41.0, 1600.0)
    found = estimate(force)
    bands = found.bands(23.0)
    assert len(bands) == len(ALPHA)
    for alpha, measured, band in zip(ALPHA, force, bands, strict=True):
        plate = {"tool_angle_deg": alpha, "depth_m": 0.0254 * np.sin(np.radians(alpha)), "width_m": 0.127}
        rings = [np.array(ring) for polygon in band["coordinates"] for ring in polygon]
        inside = [r for ring in rings for r in ring if 5.5 < r[0] < 59.5 and 110 < r[1] < 4900]
        phi, density = np.array(inside).T
        soil = {"friction_angle_deg": phi, "density_kg_m3": density, "interface_friction_deg": np.minimum(23.0, phi)}
        there = soilctl.predict("chen", **plate, **soil).force_n
        # Corners lie on either edge of the band, at most 0.03 % outside.
        off = np.minimum(abs(there / measured / 1.08 - 1), abs(there / measured / 0.92 - 1))
        assert off.max() < 1e-3
    section = np.array(found.section(23.0)["coordinates"][0][0])
    low, high = found.friction_angle_deg
    assert section[:, 0].min() >= low - 1e-6 and section[:, 0].max() <= high + 1e-6


def test_the_next_stroke_shrinks_the_region():
    found = estimate(forces(41.0, 1600.0))
    menu = {"tool_angle_deg": [50.0, 100.0], "depth_m": [0.02, 0.03], "width_m": 0.127}
    strokes = found.next_strokes(**menu)
    left = [stroke["area_left"] for stroke in strokes]
    assert len(strokes) == 4 and left == sorted(left) and 0 < left[0] < 1
    weak = found.next_strokes(**menu, force_limit_n=5.0)
    assert len(weak) < 4 and all(stroke["force_n"] <= 5.0 for stroke in weak)
    assert found.agreement_factor() < 1
    with pytest.raises(soilctl.InputError, match="empty"):
        found.next_strokes(**{**menu, "depth_m": []})
    with pytest.raises(soilctl.InputError, match="one axis"):
        found.next_strokes(**{**menu, "depth_m": [[0.02]]})


def test_the_region_is_that_of_the_command_line(tmp_path):
    force = forces(41.0, 1600.0)
    lines = ["stroke_id,alpha_deg,depth_m,width_m,force_n,force_sd_n"]
    for i, (alpha, measured) in enumerate(zip(ALPHA, force, strict=True)):
        depth = 0.0254 * np.sin(np.radians(alpha))
        lines.append(f"s{i},{alpha},{depth},0.127,{measured},{0.08 * measured}")
    path = tmp_path / "strokes.csv"
    path.write_text("\n".join(lines) + "\n")
    known = ["--delta", 23, "--delta-tol", 1, "--density", 1600, "--density-tol", 0.0625, "--uncertainty", "bounds"]
    there = soilctl.answer("estimate", path, "--model", "chen", *known)
    found = estimate(force, density_kg_m3=(1500.0, 1700.0))
    assert there["consistent"] and found.consistent
    assert there["phi_deg"] == pytest.approx(found.friction_angle_deg, rel=1e-9)
    assert there["density_kg_m3"] == pytest.approx(found.density_kg_m3, rel=1e-9)


def test_measurements_that_disagree_are_named():
    force = forces(41.0, 1600.0)
    force[2] *= 1.6
    found = estimate(force, density_kg_m3=(1500.0, 1700.0))
    assert not found.consistent and found.friction_angle_deg is None and found._repr_svg_() is None
    assert found.conflict["culprits"] == [2] or [2] in found.conflict["alone"] or found.conflict["pairs"]
    assert "no soil" in repr(found)


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"force_n": []}, soilctl.InputError, "empty"),
        ({"force_n": -1.0}, soilctl.InputError, "force"),
        ({"force_n": np.nan}, soilctl.InputError, "nan"),
        ({"force_n": [1.0, 2.0, 3.0]}, soilctl.InputError, "broadcasting"),
        ({"interface_friction_deg": (24.0, 22.0)}, soilctl.InputError, "delta"),
        ({"interface_friction_deg": 23.0}, TypeError, "interface_friction_deg"),
        ({"interface_friction_deg": [22.0, 23.0, 24.0]}, soilctl.InputError, "two numbers"),
        ({"interface_friction_deg": {22.0, 24.0}}, soilctl.InputTypeError, "real numbers"),
        ({"density_kg_m3": [1500.0]}, soilctl.InputError, "two numbers"),
        ({"density_kg_m3": "ab"}, soilctl.InputTypeError, "real numbers"),
        ({"friction_search_deg": [[20.0, 50.0]]}, soilctl.InputError, "two numbers"),
        ({"friction_search_deg": (20.0, np.nan)}, soilctl.InputError, r"friction_search_deg\[1\] is nan"),
        ({"tool_angle_deg": [[80.0], [90.0]]}, soilctl.InputError, "one axis"),
        ({"force_n": ["5"]}, soilctl.InputTypeError, "real numbers"),
        ({"model": "none"}, soilctl.InputError, "no force model"),
    ],
)
def test_bad_input_is_refused(change, error, words):
    sound = {"force_n": 5.0, "force_error_n": 0.4, "interface_friction_deg": (22.0, 24.0), "model": "chen"}
    with pytest.raises(error, match=words):
        soilctl.estimate(**{**GEOMETRY, **sound, **change})


def test_intervals_are_any_two_numbers():
    force = forces(41.0, 1600.0)
    ends = {"interface_friction_deg": (22.0, 24.0), "density_kg_m3": (1500.0, 1700.0), "friction_search_deg": (20.0, 50.0)}
    expected = estimate(force, **ends).to_dict()
    for kind in (list, np.array, lambda pair: np.array(pair, dtype=np.int32), lambda pair: [np.float32(end) for end in pair]):
        found = estimate(force, **{name: kind(pair) for name, pair in ends.items()})
        assert found.to_dict() == expected


def test_control_c_ends_an_estimate():
    # Many strokes whose bands hardly differ: seconds of work.
    count = 400
    alpha = np.linspace(70.0, 100.0, count)
    plate = {"tool_angle_deg": alpha, "depth_m": np.linspace(0.02, 0.05, count), "width_m": 0.127}
    soil = {"friction_angle_deg": 41.0, "density_kg_m3": 1600.0, "interface_friction_deg": 23.0}
    force = soilctl.predict("chen", **plate, **soil).force_n
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        while time.monotonic() < begin + 60.0:
            soilctl.estimate(
                **plate, force_n=force, force_error_n=0.1 * force, interface_friction_deg=(20.0, 26.0), model="chen"
            )
    timer.join()
    print(f"ended {time.monotonic() - begin - 0.5:.2f} s after Ctrl-C")
    assert estimate(forces(41.0, 1600.0)).consistent
