"""Cases and sweeps of problem files, shared out: the bounds of the command line, whoever solves them."""

import json
import threading
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import soilctl
from soilctl import use_cases
from soilctl.problem import Problem

ROOT = Path(__file__).parents[3]
BUDGET = {"max_gap": 0.3, "max_elements": 1000}


def cut(cohesion=20):
    return (
        Problem("cut in clay", default_boundary="fixed")
        .soil("clay", phi_deg=0, unit_weight_kn_m3=18, cohesion_kpa=cohesion)
        .region("clay", [[-9, 3], [-9, -4], [6, -4], [6, 0], [0, 0], [0, 3]])
        .boundary("free", line=[[-9, 3], [0, 3], [0, 0], [6, 0]])
        .objective_unit_weight()
    )


def swept():
    return (
        cut()
        .case("plain")
        .case("weaker", factors={"undrained": 1.4})
        .sweep("soil.clay.cohesion_kpa", values=[10, 20, 30.5])
        .sweep("soil.clay.unit_weight_kn_m3", **{"from_": 17, "to": 19, "count": 2})
    )


def expected(problem, folder, **budget):
    path = folder / "whole.json"
    path.write_text(problem.to_json())
    return use_cases.solve(path, **budget).cases


def bounds(found):
    return [(one["lower"], one["upper"], one["gap"], one["certified"], one["enough"]) for one in found]


def test_each_case_goes_with_each_value_and_has_the_bounds_of_the_command_line(tmp_path):
    problem = swept()
    done = soilctl.solve_cases(problem, store=tmp_path / "store", executor=ThreadPoolExecutor(2), **BUDGET)
    whole = expected(problem, tmp_path, **BUDGET)
    assert len(done) == len(whole) == 12 and done.failures == []
    assert bounds(done) == [(one.lower, one.upper, one.gap, one.certified, one.enough) for one in whole]
    names = [f"{cell['case']}, " + ", ".join(f"{key} = {value:g}" for key, value in cell.items() if key != "case") for cell in done.cells]
    assert names == [one.name for one in whole]
    # Undrained clay bears weight as its strength: three times the strength, three times the weight.
    table = done.to_pandas().set_index(["case", "soil.clay.cohesion_kpa", "soil.clay.unit_weight_kn_m3"])
    assert table.loc[("plain", 20, 17), "lower"] < table.loc[("plain", 30.5, 17), "upper"]
    assert done.to_xarray()["upper"].shape == (2, 3, 2)
    # Nothing is solved twice, and another budget is another result.
    assert soilctl.solve_cases(problem, store=tmp_path / "store", **BUDGET).submitted == 0


FILE = """
title = "cut"
default_boundary = "free"
objective = {kind = "unit-weight"}
[[soil]]
name = "clay"
phi_deg = 25
cohesion_kpa = 10
unit_weight_kn_m3 = 19
[[region]]
soil = "clay"
polygon = [[0, -4], [24, -4], [24, 0], [14, 0], [8, 4], [0, 4]]
[[boundary]]
kind = "fixed"
sides = ["bottom"]
[[boundary]]
name = "road"
kind = "load"
line = [[2, 4], [7, 4]]
pressure_kpa = 10
action = "variable"
[[case]]
name = "DA1-1"
approach = "da1-1"
soil_weight = "unfavourable"
[[case]]
name = "DA1-2"
approach = "da1-2"
[[sweep]]
parameter = "boundary.road.pressure_kpa"
from = 5
to = 10
count = 3
"""


def test_a_file_is_solved_as_the_command_line_does(tmp_path):
    path = tmp_path / "cut.toml"
    path.write_text(FILE)
    done = soilctl.solve_cases(path, store=tmp_path / "store", executor=ThreadPoolExecutor(2), **BUDGET)
    whole = use_cases.solve(path, **BUDGET).cases
    assert bounds(done) == [(one.lower, one.upper, one.gap, one.certified, one.enough) for one in whole]
    assert [cell["case"] for cell in done.cells] == ["DA1-1"] * 3 + ["DA1-2"] * 3
    assert [cell["boundary.road.pressure_kpa"] for cell in done.cells] == [5, 7.5, 10] * 2
    as_mapping = soilctl.solve_cases(tomllib.loads(FILE), store=tmp_path / "store", **BUDGET)
    assert as_mapping.submitted == 0 and bounds(as_mapping) == bounds(done)


def test_a_case_without_bounds_is_a_failure_by_name(tmp_path):
    problem = cut().sweep("soil.clay.unit_weight_kn_m3", values=[18, 0])
    done = soilctl.solve_cases(problem, store=tmp_path / "store", executor=ThreadPoolExecutor(1), **BUDGET)
    (failure,) = done.failures
    assert failure.cell == {"soil.clay.unit_weight_kn_m3": 0} and "no soil has weight" in failure.error
    assert done[0]["lower"] <= done[0]["upper"]
    with pytest.raises(soilctl.SweepError, match="unit_weight"):
        done[1]


def test_what_is_one_problem_or_none_is_refused(tmp_path):
    with pytest.raises(soilctl.InputError, match=r"soilctl\.solve"):
        soilctl.solve_cases(cut(), store=tmp_path)
    with pytest.raises(soilctl.InputError, match="from, to and count"):
        soilctl.solve_cases(cut().sweep("soil.clay.cohesion_kpa", count=3), store=tmp_path)
    unknown = soilctl.solve_cases(cut().sweep("soil.clay.cohesion_mpa", values=[1, 2]), store=tmp_path, executor=ThreadPoolExecutor(1))
    assert len(unknown.failures) == 2 and all("cohesion_mpa" in failure.error for failure in unknown.failures)
    (tmp_path / "broken.toml").write_text("title = ")
    with pytest.raises(soilctl.InputError, match="broken.toml"):
        soilctl.solve_cases(tmp_path / "broken.toml", store=tmp_path)
    with pytest.raises(soilctl.MissingFileError):
        soilctl.solve_cases(tmp_path / "nothing.toml", store=tmp_path)


def test_a_dask_cluster_solves_them(tmp_path):
    distributed = pytest.importorskip("distributed")
    problem = swept()
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options, local_directory=str(tmp_path)) as cluster, distributed.Client(cluster) as client:
        seen, told = [], threading.Event()

        def progress(done, total):
            seen.append((done, total))
            told.set()

        found = soilctl.solve_cases(problem, store=tmp_path / "dask", executor=client.get_executor(), progress=progress, **BUDGET)
        assert told.is_set() and seen[-1] == (12, 12) and found.submitted == 12
    here = soilctl.solve_cases(problem, store=tmp_path / "here", executor=ThreadPoolExecutor(1), **BUDGET)
    assert bounds(found) == bounds(here)
    # The same bytes in the store.
    kept = [{path.name: path.read_bytes() for path in (tmp_path / name).rglob("*") if path.is_file()} for name in ("dask", "here")]
    assert kept[0] == kept[1] and len(kept[0]) >= 12


def test_results_are_plain(tmp_path):
    done = soilctl.solve_cases(cut().sweep("soil.clay.cohesion_kpa", values=[20]), store=tmp_path / "store", executor=ThreadPoolExecutor(1), **BUDGET)
    assert json.loads(json.dumps(done[0])) == done[0] and done.cells == [{"soil.clay.cohesion_kpa": 20}]
