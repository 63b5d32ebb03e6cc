"""Results are pickled and copied, as processes and clusters do with what they send."""

import copy
import inspect
import multiprocessing
import pickle
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from cells import bracket as bracket_of
from test_limits import cut, strip

import soilctl

DATA = Path(__file__).parents[3] / "data"
PLATE = {"tool_angle_deg": 80.0, "friction_angle_deg": 30.0, "interface_friction_deg": 10.0}
SIZES = {"density_kg_m3": 1600.0, "depth_m": 0.02, "width_m": 0.1}
STROKES = {"tool_angle_deg": [70.0, 80.0, 90.0], "depth_m": [0.024, 0.025, 0.026], "width_m": 0.127, "model": "chen"}
FORCES = {"force_n": [4.0, 6.0, 8.9], "force_error_n": 0.7, "interface_friction_deg": (22.0, 24.0)}
CLAY = strip(20.0, at=(100.0, 7.0))


def estimate(**more):
    return soilctl.estimate(**STROKES, **{**FORCES, **more})


MADE = {
    "numbers": lambda: soilctl.predict(**PLATE),
    "arrays": lambda: soilctl.predict("table", **{**PLATE, "tool_angle_deg": [70.0, 80.0]}, **SIZES),
    "point model": lambda: soilctl.predict("coulomb", **PLATE, **SIZES),
    "plate": lambda: soilctl.bound(**PLATE, **SIZES, max_gap=0.3),
    "problem": lambda: soilctl.solve(CLAY, max_gap=0.3),
    "safety": lambda: soilctl.solve(cut(), max_gap=0.5, max_elements=1500),
    "solution": lambda: soilctl.solve(CLAY, max_gap=0.3).solution,
    "certificate": lambda: soilctl.certify(soilctl.bound(**PLATE, max_gap=0.3).solution),
    "estimate": estimate,
    "bounded": lambda: estimate(density_kg_m3=(1500, 1700), friction_search_deg=(20, 50), surcharge_pa=10.0),
    "no soil": lambda: estimate(force_n=[4.0, 60.0, 8.9], density_kg_m3=(1500, 1700)),
    "sensed": lambda: soilctl.Plant("ticino_loose").step(np.full(5, 0.1)),
    "arm": soilctl.Arm,
}


@pytest.fixture(scope="module", params=MADE)
def made(request):
    return MADE[request.param]()


def attributes(thing):
    """All that a result tells of itself without being asked for something."""
    names = [name for name in dir(type(thing)) if not name.startswith("_") or name == "__geo_interface__"]
    values = {}
    for name in names:
        if not inspect.isroutine(getattr(type(thing), name)):
            try:
                values[name] = getattr(thing, name)
            except soilctl.NoAnswerError as problem:
                values[name] = str(problem)
    return values


def same(one, other):
    if type(one) is not type(other):
        return False
    if isinstance(one, dict):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and bool((one == other).all())
    return bool(one == other)


@pytest.mark.parametrize("copied", [lambda thing: pickle.loads(pickle.dumps(thing)), copy.deepcopy, copy.copy])
def test_a_copy_is_the_same_in_all_that_it_tells(made, copied):
    again = copied(made)
    assert type(again) is type(made) and repr(again) == repr(made)
    told = attributes(made)
    assert told and same(told, attributes(again))


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_every_protocol_does(protocol):
    found = soilctl.predict(**PLATE, **SIZES)
    assert same(attributes(pickle.loads(pickle.dumps(found, protocol))), attributes(found))


def test_copies_work_as_the_originals_do(tmp_path):
    bracket = soilctl.solve(CLAY, max_gap=0.3)
    again = pickle.loads(pickle.dumps(bracket))
    assert again.solution.vtu() == bracket.solution.vtu() and soilctl.certify(again.solution)
    found = estimate()
    back = pickle.loads(pickle.dumps(found))
    assert back.section(23.0) == found.section(23.0) and back.agreement_factor() == found.agreement_factor()
    text = (DATA / "arm" / "thesis.toml").read_text().replace('name = "', 'name = "other_', 1)
    path = tmp_path / "arm.toml"
    path.write_text(text)
    arms = [soilctl.Arm(path), soilctl.Arm.from_toml(text)]
    path.unlink()
    for arm in arms:
        assert pickle.loads(pickle.dumps(arm)).urdf() == arm.urdf()


def test_arrays_of_a_deep_copy_are_its_own():
    found = soilctl.predict(**{**PLATE, "tool_angle_deg": [70.0, 80.0]})
    deep = copy.deepcopy(found)
    deep.coefficient[:] = 0.0
    assert (found.coefficient > 0.0).all()


def test_equal_is_what_has_the_same_content():
    first, second = (soilctl.bound(**PLATE, max_gap=0.3) for _ in range(2))
    other = soilctl.bound(**{**PLATE, "tool_angle_deg": 81.0}, max_gap=0.3)
    assert first == second and hash(first) == hash(second) and first != other
    assert first.solution == second.solution and len({first.solution, second.solution, other.solution}) == 2
    assert soilctl.certify(first.solution) == soilctl.certify(second.solution) != soilctl.certify(other.solution)
    assert len({first, second, other}) == 2 and first != 1 and first.solution != first


def test_processes_send_brackets():
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        found = pool.submit(bracket_of, 80.0).result(timeout=120)
    assert found == bracket_of(80.0) and soilctl.certify(found.solution)


def test_a_plant_says_that_it_cannot_be_copied():
    for call in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match="simulation"):
            call(soilctl.Plant())


def test_errors_of_files_are_pickled_with_all_they_have(tmp_path):
    with pytest.raises(soilctl.FileError) as caught:
        soilctl.certify(tmp_path / "none.json")
    again = pickle.loads(pickle.dumps(caught.value))
    assert (type(again), str(again)) == (type(caught.value), str(caught.value))
    assert (again.errno, again.filename) == (caught.value.errno, caught.value.filename)
