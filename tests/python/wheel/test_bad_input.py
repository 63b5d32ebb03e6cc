"""Whatever a caller hands over, there is an exception that says so, or an answer; the interpreter lives on."""

import numpy as np
import pytest

import soilctl

WHATEVER = [
    None,
    float("nan"),
    float("inf"),
    -1,
    0,
    "x",
    b"x",
    [],
    [[]],
    {},
    object(),
    1e308,
    10**400,
    True,
    np.array([1 + 2j]),
    np.array(["a"]),
    np.zeros((2, 2)),
    np.zeros((0, 3)),
    (3.0, 2.0),
    (5.0, float("nan")),
]
PLATE = {"tool_angle_deg": 80.0, "friction_angle_deg": 30.0, "interface_friction_deg": 10.0}
SIZES = {"density_kg_m3": 1600.0, "depth_m": 0.02, "width_m": 0.1}
LOADS = {"cohesion_pa": 0.0, "adhesion_pa": 0.0, "surcharge_pa": 0.0, "gravity_m_s2": 9.81, "surface_slope_deg": 0.0}
STROKES = {
    "tool_angle_deg": [70.0, 80.0],
    "depth_m": 0.02,
    "width_m": 0.1,
    "force_n": [4.0, 5.0],
    "force_error_n": 0.5,
    "interface_friction_deg": (10.0, 12.0),
    "model": "chen",
}
MENU = {"tool_angle_deg": [60.0], "depth_m": [0.02], "width_m": 0.1, "force_scatter": 0.05, "depth_error_m": 0.001}
# Limits that no test can wait for.
BUDGET = {"max_gap": 0.5, "max_elements": 1000, "max_seconds": 1e-3, "threads": 1, "max_memory_mb": 200, "progress": None}


def one_by_one(function, sound):
    """Calls that each have one argument replaced."""
    return [
        pytest.param(function, {**sound, name: bad}, id=f"{function.__name__}-{name}-{place}")
        for name in sound
        for place, bad in enumerate(WHATEVER)
        if not (function is soilctl.bound and name == "max_seconds" and not isinstance(bad, (str, bytes)))
    ]


CASES = [
    *one_by_one(soilctl.predict, {"model": "chen", **PLATE, **SIZES, **LOADS}),
    *one_by_one(soilctl.bound, {**PLATE, **SIZES, **LOADS, **BUDGET}),
    *one_by_one(soilctl.estimate, {**STROKES, "density_kg_m3": (1500.0, 1700.0), "friction_search_deg": (20.0, 50.0)}),
]


def numbers(value):
    """All numbers and arrays of numbers in an answer."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, (list, tuple)):
        return [number for part in value for number in numbers(part)]
    return [value] if isinstance(value, (float, np.ndarray)) else []


@pytest.mark.parametrize(("function", "words"), CASES)
def test_arguments(function, words):
    try:
        answer = function(**words)
    except (soilctl.SoilctlError, TypeError, OverflowError) as problem:
        assert str(problem) and "panick" not in str(problem)
    else:
        assert all(np.isfinite(number).all() for number in numbers(answer.to_dict()))


@pytest.mark.parametrize("value", [-1, 2**64, 10**400, -(10**400)])
def test_whole_numbers_out_of_range_are_no_overflow(value, tmp_path):
    calls = [
        lambda: soilctl.Plant(seed=value),
        lambda: soilctl.Plant().run(lambda sensed: np.zeros(5), ticks=value),
        lambda: soilctl.bound(**PLATE, max_elements=value),
        lambda: soilctl.bound(**PLATE, threads=value),
        lambda: soilctl.bound(**PLATE, max_memory_mb=value),
        lambda: soilctl.solve({}, max_elements=value),
        lambda: soilctl.replay(tmp_path / "log.mcap", from_keyframe=value),
    ]
    for call in calls:
        with pytest.raises(soilctl.InputError, match="out of range|must be at least 0"):
            call()


class Raising:
    """What has no array, for a reason of its own."""

    def __init__(self, problem):
        self.problem = problem

    def __array__(self, dtype=None, copy=None):
        raise self.problem


@pytest.mark.parametrize("problem", [KeyboardInterrupt(), MemoryError("full"), ZeroDivisionError("x")])
def test_what_is_no_matter_of_the_argument_comes_through(problem):
    with pytest.raises(type(problem)) as caught:
        soilctl.predict(**{**PLATE, "tool_angle_deg": Raising(problem)})
    assert caught.value is problem


@pytest.mark.parametrize(
    ("problem", "error"), [(ValueError("odd"), soilctl.InputError), (TypeError("odd"), soilctl.InputTypeError)]
)
def test_what_numpy_refuses_is_the_cause(problem, error):
    with pytest.raises(error, match="tool_angle_deg is no array: odd") as caught:
        soilctl.predict(**{**PLATE, "tool_angle_deg": Raising(problem)})
    assert type(caught.value) is error and caught.value.__cause__ is problem


def test_more_axes_than_there_may_be_are_refused():
    for axes in (32, 33, 64):
        with pytest.raises(soilctl.InputError, match=f"{axes} axes; it must have at most 31"):
            soilctl.predict(**{**PLATE, "tool_angle_deg": np.full([1] * axes, 80.0)})
    found = soilctl.predict(**{**PLATE, "tool_angle_deg": np.full([1] * 31, 80.0)})
    assert found.coefficient.shape == (1,) * 31


def test_masked_elements_have_no_value():
    angles = np.ma.array([80.0, 85.0, 90.0], mask=[False, True, False])
    with pytest.raises(soilctl.InputError, match="tool_angle_deg has masked elements"):
        soilctl.predict(**{**PLATE, "tool_angle_deg": angles})
    with pytest.raises(soilctl.InputError, match="masked"):
        soilctl.predict(**{**PLATE, "tool_angle_deg": np.ma.masked})
    with pytest.raises(soilctl.InputError, match="force_n has masked elements"):
        soilctl.estimate(**{**STROKES, "force_n": np.ma.array([4.0, 5.0], mask=[True, False])})
    # Without one that is masked, they are arrays.
    whole = soilctl.predict(**{**PLATE, "tool_angle_deg": np.ma.array([80.0, 85.0])}).coefficient
    np.testing.assert_array_equal(whole, soilctl.predict(**{**PLATE, "tool_angle_deg": [80.0, 85.0]}).coefficient)


def test_masked_elements_have_no_axis_and_no_file():
    xarray = pytest.importorskip("soilctl.xarray")
    with pytest.raises(soilctl.InputError, match="masked"):
        xarray.predict(**{**PLATE, "tool_angle_deg": np.ma.array([80.0, 85.0], mask=[False, True])})
    with pytest.raises(soilctl.InputError, match="masked"):
        soilctl.Store.key("f", "", {"x": np.ma.array([1.0, 2.0], mask=[False, True])})


def test_sizes_beyond_all_bounds_are_no_answer():
    for name in SIZES:
        with pytest.raises(soilctl.NoAnswerError, match="double precision"):
            soilctl.predict(**PLATE, **{**SIZES, name: 1e308})
    with pytest.raises(soilctl.NoAnswerError, match="double precision"):
        soilctl.bound(**PLATE, **{**SIZES, "depth_m": 1e200})
    with pytest.raises(soilctl.NoAnswerError, match=r"element \[1\]: .*double precision"):
        soilctl.predict(**PLATE, **{**SIZES, "depth_m": [0.1, 1e200]})


def test_methods(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    estimate = soilctl.estimate(**STROKES)
    solution = soilctl.bound(**PLATE, max_gap=0.5).solution
    plant = soilctl.Plant()
    calls = [
        lambda bad: estimate.contains(bad, 1600.0),
        estimate.section,
        estimate.bands,
        *(lambda bad, name=name: estimate.next_strokes(**{**MENU, name: bad}) for name in MENU),
        solution.triangles,
        solution.velocity,
        solution.stress,
        soilctl.Solution.read,
        plant.step,
        lambda bad: plant.run(bad, ticks=3),
        lambda bad: plant.run(lambda sensed: bad, ticks=3),
        soilctl.Plant,
        lambda bad: soilctl.Plant(joint_angles_deg=bad),
        lambda bad: soilctl.Plant("ticino_loose", surface_z_m=bad),
        lambda bad: soilctl.Plant("ticino_loose", model=bad),
        lambda bad: soilctl.Plant(seed=bad),
        lambda bad: soilctl.Plant(file=bad),
        soilctl.solve,
        soilctl.certify,
        soilctl.log_info,
        soilctl.log_table,
        soilctl.replay,
        lambda bad: soilctl.log_recover("x", out=bad),
        soilctl.answer,
        soilctl.shear,
        lambda bad: soilctl.simulate(bad, out=tmp_path / "logs"),
    ]
    refused = 0
    for call in calls:
        for bad in WHATEVER:
            try:
                call(bad)
            except (soilctl.SoilctlError, TypeError, ValueError, OverflowError) as problem:
                assert "panick" not in str(problem)
                refused += 1
    assert refused > 0.9 * len(calls) * len(WHATEVER)
    assert not (tmp_path / "logs").exists()
