"""Force models from Python: numbers, arrays, what is refused."""

import math
import threading

import numpy as np
import pytest

import soilctl

SOUND = {"tool_angle_deg": 80.0, "friction_angle_deg": 40.0, "interface_friction_deg": 25.0}
PLATE = {"density_kg_m3": 1600.0, "depth_m": 0.0254, "width_m": 0.127}


def rankine(friction_angle_deg):
    """Passive minus active coefficient of a smooth upright plate, for which all sound models agree."""
    n = math.tan(math.radians(45.0 + friction_angle_deg / 2)) ** 2
    return n - 1.0 / n


def test_a_smooth_upright_plate_has_rankines_coefficient():
    found = soilctl.predict("coulomb", tool_angle_deg=90, friction_angle_deg=30, interface_friction_deg=0)
    assert isinstance(found.coefficient, float)
    assert found.coefficient == pytest.approx(rankine(30.0), rel=1e-8)
    assert found.lower == found.coefficient == found.upper
    assert found.force_n is None and found.interpolation_margin is None


def test_force_is_half_gamma_l_squared_w_k():
    found = soilctl.predict("coulomb", **SOUND, **PLATE)
    slant = 0.0254 / math.sin(math.radians(80.0))
    assert found.force_n == pytest.approx(0.5 * 1600.0 * 9.80665 * slant**2 * 0.127 * found.coefficient)


def test_all_loads_add_up():
    plain = soilctl.predict("coulomb", **SOUND, **PLATE).force_n
    loads = {"cohesion_pa": 100.0, "adhesion_pa": 50.0, "surcharge_pa": 200.0}
    one_by_one = [soilctl.predict("coulomb", **SOUND, **PLATE, **{k: v}).force_n - plain for k, v in loads.items()]
    together = soilctl.predict("coulomb", **SOUND, **PLATE, **loads).force_n
    assert together == pytest.approx(plain + sum(one_by_one))
    with pytest.raises(soilctl.InputError, match="no term for cohesion"):
        soilctl.predict("table", **SOUND, **PLATE, cohesion_pa=10.0)


@pytest.mark.parametrize("model", soilctl.MODELS)
def test_an_array_gives_what_each_number_gives(model):
    alpha, phi = np.array([[80.0], [90.0]]), np.array([30.0, 35.0, 40.0])
    alpha = np.clip(alpha, *soilctl.valid_range(model)["tool_angle_deg"])
    found = soilctl.predict(model, tool_angle_deg=alpha, friction_angle_deg=phi, interface_friction_deg=20.0, **PLATE)
    assert found.coefficient.shape == found.force_n.shape == found.lower.shape == (2, 3)
    for (i, j), value in np.ndenumerate(found.coefficient):
        one = soilctl.predict(
            model, tool_angle_deg=alpha[i, 0], friction_angle_deg=phi[j], interface_friction_deg=20, **PLATE
        )
        assert (one.coefficient, one.force_n) == (value, found.force_n[i, j])
        assert one.lower <= one.coefficient <= one.upper
        assert one.force_lower_n <= one.force_n <= one.force_upper_n


def test_strides_byte_order_and_other_types_do_not_matter():
    phi = np.linspace(20.0, 45.0, 64)
    expected = soilctl.predict("coulomb", **{**SOUND, "friction_angle_deg": phi, "interface_friction_deg": 10})
    packed = np.zeros(64, dtype=[("pad", "i1"), ("phi", "f8")])
    packed["phi"] = phi
    read_only = phi.copy()
    read_only.flags.writeable = False
    forms = {
        "strided": np.repeat(phi, 2)[::2],
        "reversed": phi[::-1][::-1],
        "big-endian": phi.astype(">f8"),
        "unaligned": packed["phi"],
        "read-only": read_only,
        "list": phi.tolist(),
    }
    for name, form in forms.items():
        found = soilctl.predict("coulomb", **{**SOUND, "friction_angle_deg": form, "interface_friction_deg": 10})
        np.testing.assert_array_equal(found.coefficient, expected.coefficient, err_msg=name)
    fortran = np.asfortranarray(np.arange(60.0, 72.0).reshape(3, 4))
    found = soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": fortran})
    same = soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": np.ascontiguousarray(fortran)})
    np.testing.assert_array_equal(found.coefficient, same.coefficient)
    whole = soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": np.array([80, 90], dtype=np.int16)})
    np.testing.assert_array_equal(
        whole.coefficient, soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": [80.0, 90.0]}).coefficient
    )


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"tool_angle_deg": []}, soilctl.InputError, "tool_angle_deg is empty"),
        ({"tool_angle_deg": np.zeros((3, 0))}, soilctl.InputError, "empty"),
        ({"tool_angle_deg": math.nan}, soilctl.InputError, "tool_angle_deg is nan"),
        ({"tool_angle_deg": [[80.0, math.inf]]}, soilctl.InputError, r"tool_angle_deg\[0, 1\] is inf"),
        ({"tool_angle_deg": ["a"]}, soilctl.InputTypeError, "real numbers"),
        ({"tool_angle_deg": 1j}, soilctl.InputTypeError, "real numbers"),
        ({"tool_angle_deg": None}, soilctl.InputTypeError, "real numbers"),
        ({"tool_angle_deg": True}, soilctl.InputTypeError, "bool"),
        ({"tool_angle_deg": [[80.0], [80.0, 90.0]]}, soilctl.InputError, "no array"),
        ({"tool_angle_deg": [80, 90], "friction_angle_deg": [30, 40, 35]}, soilctl.InputError, "broadcasting"),
        ({"tool_angle_deg": [80, 300]}, soilctl.InputError, r"element \[1\]: model coulomb covers alpha"),
        ({"interface_friction_deg": 41.0}, soilctl.InputError, "delta"),
        ({"model": "rankine"}, soilctl.InputError, "no force model called"),
        ({"depth_m": 0.1}, soilctl.InputError, "all or none"),
        ({**PLATE, "width_m": -1.0}, soilctl.InputError, "width"),
        ({"tool_angle_deg": 100, "friction_angle_deg": 50, "interface_friction_deg": 30}, soilctl.NoAnswerError, "q"),
    ],
)
def test_bad_input_is_refused_with_words(change, error, words):
    with pytest.raises(error, match=words) as caught:
        soilctl.predict(**{"model": "coulomb", **SOUND, **change})
    assert isinstance(caught.value, soilctl.SoilctlError)
    assert not type(caught.value).__name__.startswith("Panic")


def test_errors_are_the_built_in_ones_too():
    assert issubclass(soilctl.InputError, ValueError)
    assert issubclass(soilctl.InputTypeError, TypeError)
    assert issubclass(soilctl.FileError, OSError)
    assert issubclass(soilctl.NoAnswerError, ArithmeticError)
    assert issubclass(soilctl.Interrupted, KeyboardInterrupt)


def test_the_first_bad_element_is_named_among_many():
    alpha = np.full((100, 1000), 80.0)
    alpha[61, 5] = alpha[99, 999] = 500.0
    with pytest.raises(soilctl.InputError, match=r"element \[61, 5\]"):
        soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": alpha})


def test_other_threads_run_meanwhile():
    """The interpreter's lock is released: a thread counts while a long prediction runs."""
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    soilctl.predict("chen", **{**SOUND, "friction_angle_deg": np.linspace(30.0, 45.0, 20_000)})
    during = counted[0] - before
    done.set()
    thread.join()
    assert during > 0


def test_who_changes_one_array_means_one():
    alpha = np.array([70.0, 80.0])
    found = soilctl.predict("coulomb", **{**SOUND, "tool_angle_deg": alpha}, **PLATE)
    before = {key: np.copy(value) for key, value in found.to_dict().items() if key != "model"}
    found.lower[:] = found.upper[:] = found.force_lower_n[:] = found.force_upper_n[:] = 0.0
    for key, value in before.items():
        np.testing.assert_array_equal(getattr(found, key), value, err_msg=key)
    assert (alpha == [70.0, 80.0]).all()


def test_tables_say_how_far_they_may_be_off_also_at_their_nodes():
    # Every angle is a node of the table.
    node = {"tool_angle_deg": 80.0, "friction_angle_deg": 40.0, "interface_friction_deg": 20.0}
    assert soilctl.predict("table", **node).interpolation_margin == 0.0
    between = soilctl.predict("table", **{**node, "friction_angle_deg": 42.0}).interpolation_margin
    assert between > 0.0 and soilctl.predict("chen", **node).interpolation_margin is None


@pytest.mark.parametrize("name", ["cohesion_pa", "adhesion_pa", "surcharge_pa", "gravity_m_s2"])
def test_loads_need_sizes(name):
    with pytest.raises(soilctl.InputError, match=f"{name} changes forces only"):
        soilctl.predict(**SOUND, **{name: 1.0})


def test_notebooks_show_a_table():
    html = soilctl.predict("table", **SOUND, **PLATE)._repr_html_()
    assert html.startswith("<table>") and "force_upper_n" in html


def test_failure_surfaces_start_at_the_tip_and_end_at_the_ground():
    line = soilctl.failure_surface("coulomb", **SOUND)
    assert line.shape == (2, 2) and (line[0] == 0.0).all()
    assert line[-1, 1] == pytest.approx(math.sin(math.radians(80.0)))
    assert soilctl.failure_surface("table", **SOUND) is None


def test_the_valid_range_is_told():
    assert soilctl.valid_range("coulomb")["tool_angle_deg"] == (20.0, 140.0)
    assert set(soilctl.predict(**SOUND).to_dict()) == {"model", "coefficient", "lower", "upper"}


def test_grids_have_named_axes():
    xarray = pytest.importorskip("xarray")
    from soilctl.xarray import predict

    alpha, phi = np.array([70.0, 80.0, 90.0]), [30.0, 40.0]
    sizes = {"density_kg_m3": 1600.0, "depth_m": 0.025, "width_m": 0.127}
    found = predict("table", tool_angle_deg=alpha, friction_angle_deg=phi, interface_friction_deg=20.0, **sizes)
    assert dict(found.sizes) == {"tool_angle_deg": 3, "friction_angle_deg": 2} and found.attrs["model"] == "table"
    one = soilctl.predict("table", tool_angle_deg=80.0, friction_angle_deg=40.0, interface_friction_deg=20.0, **sizes)
    there = found.sel(tool_angle_deg=80.0, friction_angle_deg=40.0)
    assert float(there["force_n"]) == one.force_n and there["force_n"].attrs["units"] == "N"
    assert float(there["lower"]) == one.lower and "units" in there["upper"].attrs
    # Axes of one's own, and arrays over the same axis.
    strokes = xarray.DataArray([0.01, 0.02], dims="stroke", coords={"stroke": ["a", "b"]})
    angles = xarray.DataArray([70.0, 90.0], dims="stroke", coords={"stroke": ["a", "b"]})
    pairs = predict(tool_angle_deg=angles, depth_m=strokes, friction_angle_deg=35.0, interface_friction_deg=20.0,
                    density_kg_m3=1600.0, width_m=0.127)
    assert pairs["force_n"].dims == ("stroke",) and float(pairs["force_n"].sel(stroke="b")) > float(pairs["force_n"][0])
    single = predict(tool_angle_deg=80.0, friction_angle_deg=35.0, interface_friction_deg=20.0)
    assert single["coefficient"].dims == ()
    with pytest.raises(soilctl.InputTypeError, match="without names"):
        predict(tool_angle_deg=np.ones((2, 2)), friction_angle_deg=35.0, interface_friction_deg=20.0)
    with pytest.raises(soilctl.InputError):
        predict(tool_angle_deg=80.0, friction_angle_deg=np.nan, interface_friction_deg=20.0)
