"""Sweeps: resume, name failures, same bytes whatever runs them."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import threading
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from cells import (
    Tripler,
    contradicts,
    deadly,
    fails_without_words,
    healed,
    not_finite,
    of_other_shape,
    poisoned,
    square,
    told_again,
)

import soilctl


class Serial(Executor):
    """Runs everything at once, in this process, and counts."""

    def __init__(self):
        self.submitted = 0

    def submit(self, function, /, *args, **kwargs):
        self.submitted += 1
        future = Future()
        try:
            future.set_result(function(*args, **kwargs))
        except Exception as problem:
            future.set_exception(problem)
        return future


class Forgetful(Serial):
    """Loses the results of its first calls, as a cluster may that loses a worker."""

    def __init__(self, lost):
        super().__init__()
        self.lost = lost

    def submit(self, function, /, *args, **kwargs):
        future = super().submit(function, *args, **kwargs)
        if self.submitted > self.lost:
            return future
        lost = Future()
        lost.set_exception(ValueError("lost"))
        return lost


def files(store):
    """Bytes of all results by name; nothing else may lie beside them."""
    results = Path(store) / "results"
    found = {str(path.relative_to(results)): path.read_bytes() for path in results.rglob("*") if path.is_file()}
    assert all(name.endswith(".json") and "/." not in name for name in found)
    return found


def test_results_come_in_the_order_of_the_cells(tmp_path):
    cells = [{"number": n} for n in (3, 1, 2, 3)]
    calls = []
    found = soilctl.sweep(square, cells, store=tmp_path, executor=Serial(), progress=lambda *at: calls.append(at))
    assert [result["square"] for result in found] == [9, 1, 4, 9]
    np.testing.assert_array_equal(found[2]["values"], [0.0, 2.0, 4.0])
    assert found.submitted == 3, "equal cells are run once"
    assert calls == [(1, 3), (2, 3), (3, 3)]
    assert "4 of 4 cells done" in found._repr_html_()


def test_nothing_is_run_twice(tmp_path):
    first, second = Serial(), Serial()
    soilctl.sweep(square, [{"number": 1}], store=tmp_path, executor=first)
    again = soilctl.sweep(square, [{"number": 1}, {"number": 2}], store=tmp_path, executor=second)
    assert (first.submitted, second.submitted) == (1, 1)
    assert again[0]["square"] == 1 and again[1]["square"] == 4


def test_version_name_and_parameters_make_other_results(tmp_path):
    store = soilctl.Store
    keys = {
        store.key("a", "", {"number": 1}),
        store.key("b", "", {"number": 1}),
        store.key("a", "2", {"number": 1}),
        store.key("a", "", {"number": 1.0}),
        store.key("a", "", {"number": [1]}),
    }
    assert len(keys) == 5
    assert store.key("a", "", {"x": 1, "y": 2}) == store.key("a", "", {"y": 2, "x": 1})
    serial = Serial()
    for version in ("1", "2", "1"):
        soilctl.sweep(square, [{"number": 1}], store=tmp_path, executor=serial, version=version)
    assert serial.submitted == 2


def test_files_can_be_found_and_checked_without_soilctl(tmp_path):
    cell = {"small": 1e-05, "large": 1.5e16, "whole": 10**30, "text": "\u00e9\n\x01\x7f", "list": [None, True, -0.0]}

    def text(value):
        return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)

    asked = {"format": "soilctl.sweep/1", "function": "f", "version": "1", "cell": cell}
    key = hashlib.sha256(text(asked).encode()).hexdigest()
    store = soilctl.Store(tmp_path)
    assert store.key("f", "1", cell) == key
    store.publish(key, "f", "1", cell, text([1, 2.5]).encode())
    file = tmp_path / "results" / key[:2] / f"{key}.json"
    assert store.path(key) == file and store.read(key) == [1, 2.5]
    found = json.loads(file.read_bytes())
    assert hashlib.sha256(found["result"].encode()).hexdigest() == found["sha256"]
    assert file.read_text() == text(found) + "\n" and found["cell"] == cell
    with pytest.raises(soilctl.MissingFileError) as missing:
        store.read("0" * 64)
    assert missing.value.filename == str(store.path("0" * 64))


def test_failures_are_named_and_tried_again(tmp_path):
    cells = [{"number": n} for n in range(60)]
    found = soilctl.sweep(poisoned, cells, store=tmp_path, executor=ThreadPoolExecutor(4), name="n")
    assert [f.cell for f in found.failures] == [{"number": 7}, {"number": 37}]
    assert found.failures[1].error == "ValueError: poison 37"
    assert len(list(found)) == 58
    with pytest.raises(soilctl.SweepError, match="poison 37"):
        found.raise_for_failures()
    with pytest.raises(soilctl.SweepError, match="poison 7"):
        found[7]
    assert len(list((tmp_path / "failed").iterdir())) == 2
    again = Serial()
    healthy = soilctl.sweep(healed, cells, store=tmp_path, executor=again, name="n")
    assert again.submitted == 2 and healthy.submitted == 2 and not healthy.failures
    assert not list((tmp_path / "failed").iterdir())


def test_all_executors_leave_the_same_bytes(tmp_path):
    cells = [{"number": n, "offset": 0.1 * n} for n in range(20)]
    executors = {"serial": Serial(), "threads": ThreadPoolExecutor(3), "processes": None}
    stores = []
    for name, executor in executors.items():
        soilctl.sweep(square, cells, store=tmp_path / name, executor=executor).raise_for_failures()
        stores.append(files(tmp_path / name))
    assert len(stores[0]) == 20
    assert stores[0] == stores[1] == stores[2]


def test_a_cell_that_kills_its_process_is_named(tmp_path):
    cells = [{"number": n} for n in range(12)]
    found = soilctl.sweep(deadly, cells, store=tmp_path)
    assert [f.cell for f in found.failures] == [{"number": 5}]
    assert "process died" in found.failures[0].error
    assert list(found) == [n for n in range(12) if n != 5]


def test_results_go_on_a_grid_with_named_axes(tmp_path):
    xarray = pytest.importorskip("xarray")
    cells = [{"number": n, "offset": o} for n in (3, 1, 2) for o in (0.5, 0.0)]
    found = soilctl.sweep(square, cells[:-1], store=tmp_path, executor=Serial()).to_xarray()
    assert isinstance(found, xarray.Dataset) and dict(found.sizes) == {"number": 3, "offset": 2, "values_0": 3}
    assert found["square"].sel(number=3, offset=0.5) == 9.5
    np.testing.assert_array_equal(found["values"].sel(number=3, offset=0.0), [0.0, 3.0, 6.0])
    assert np.isnan(found["square"].sel(number=2, offset=0.0)), "the cell that was left out"
    frame = soilctl.sweep(square, cells, store=tmp_path, executor=Serial()).to_pandas()
    series = frame.set_index(["number", "offset"])["square"].sort_index()
    grid = soilctl.sweep(square, cells, store=tmp_path, executor=Serial()).to_xarray()["square"]
    xarray.testing.assert_equal(grid.astype(float), series.astype(float).to_xarray())
    empty = soilctl.sweep(square, [], store=tmp_path, executor=Serial()).to_xarray()
    assert not empty.sizes
    mixed = soilctl.sweep(square, [{"number": 1}, {"number": 2, "offset": 1.0}], store=tmp_path, executor=Serial())
    with pytest.raises(soilctl.InputError, match="parameters"):
        mixed.to_xarray()
    array = soilctl.sweep(square, [{"number": np.ones(3)}], store=tmp_path, executor=Serial())
    with pytest.raises(soilctl.InputError, match="number of cell 0"):
        array.to_xarray()


def test_results_may_repeat_their_parameters(tmp_path):
    cells = [{"number": n} for n in (1, 2, 3)]
    found = soilctl.sweep(told_again, cells, store=tmp_path, executor=Serial())
    frame = found.to_pandas()
    assert list(frame.columns) == ["number", "half"]
    # None is missing, on a grid.
    grid = found.to_xarray()
    assert list(grid.data_vars) == ["half"] and np.isnan(grid["half"].sel(number=3))
    other = soilctl.sweep(contradicts, cells, store=tmp_path, executor=Serial())
    for call in (other.to_pandas, other.to_xarray):
        with pytest.raises(soilctl.InputError, match="key 'number'"):
            call()
    changing = soilctl.sweep(of_other_shape, cells, store=tmp_path, executor=Serial())
    with pytest.raises(soilctl.InputError, match="shape"):
        changing.to_xarray()


def test_results_of_scripts_and_methods_are_told_apart(tmp_path):
    with pytest.raises(soilctl.InputError, match="name="):
        soilctl.sweep(Tripler().run, [{"number": 1}], store=tmp_path, executor=Serial())
    named = soilctl.sweep(Tripler().run, [{"number": 1}], store=tmp_path, executor=Serial(), name="triple")
    assert list(named) == [3]
    script = """
import soilctl
def cell(number):
    return {factor} * number
if __name__ == "__main__":
    print(list(soilctl.sweep(cell, [{{"number": 1}}], store="store", executor=__import__("concurrent.futures").futures.ThreadPoolExecutor(1))))
"""
    for name, factor in (("one", 10), ("two", 20), ("one", 10)):
        (tmp_path / f"{name}.py").write_text(script.format(factor=factor))
        done = subprocess.run([sys.executable, f"{name}.py"], cwd=tmp_path, capture_output=True, text=True, check=True)
        assert done.stdout.strip() == f"[{factor}]"
    assert len(files(tmp_path / "store")) == 2


def test_the_command_line_fills_the_same_kind_of_store(tmp_path):
    grid = ["--alpha", "85:90:5", "--phi", "25:30:5", "--delta", "0:30:30", "--max-elements", 700, "--max-gap", 0.2]
    for shard in ("1/2", "2/2"):
        soilctl.answer("table", "build", *grid, "--store", tmp_path, "--shard", shard)
    assert len(files(tmp_path)) == 6
    store, version = soilctl.Store(tmp_path), f"{soilctl.__version__} --max-gap 0.2 --max-elements 700"
    cell = {"alpha_deg": 90.0, "phi_deg": 30.0, "delta_deg": 0.0}
    found = store.read(store.key("soilctl table build", version, cell))["solved"]
    assert found["lower"] <= 3.0 - 1.0 / 3.0 <= found["upper"] and found["certified"]


def test_progress_is_a_bar(tmp_path, capfd):
    pytest.importorskip("tqdm")
    soilctl.sweep(square, [{"number": n} for n in range(7)], store=tmp_path, executor=Serial(), progress=True)
    assert "7/7" in capfd.readouterr().err


def test_damaged_results_are_made_again(tmp_path):
    found = soilctl.sweep(square, [{"number": 2}], store=tmp_path, executor=Serial())
    path = found.store.path(found.keys[0])
    path.write_bytes(path.read_bytes().replace(b'\\"square\\":4', b'\\"square\\":5'))
    with pytest.raises(soilctl.FileError, match="damaged"):
        found[0]
    again = soilctl.sweep(square, [{"number": 2}], store=tmp_path, executor=Serial())
    assert again.submitted == 1 and again[0]["square"] == 4


def test_an_interrupted_sweep_goes_on(tmp_path):
    cells = [{"number": n} for n in range(10)]

    def stop(done, total):
        if done == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        soilctl.sweep(square, cells, store=tmp_path, executor=Serial(), progress=stop)
    assert len(files(tmp_path)) == 4
    rest = soilctl.sweep(square, cells, store=tmp_path, executor=Serial())
    assert rest.submitted == 6 and [r["square"] for r in rest] == [n**2 for n in range(10)]


def test_what_cannot_be_stored_is_a_failure(tmp_path):
    found = soilctl.sweep(not_finite, [{"number": 1}], store=tmp_path, executor=Serial())
    assert "only finite numbers" in found.failures[0].error
    silent = soilctl.sweep(fails_without_words, [{"number": 1}], store=tmp_path, executor=Serial())
    assert silent.failures[0].error == "RuntimeError"


@pytest.mark.parametrize(
    ("cells", "error"),
    [
        ([3], soilctl.InputTypeError),
        ([{"number": object()}], soilctl.InputTypeError),
        ([{"number": float("inf")}], soilctl.InputError),
        ([{"number": {1: 2}}], soilctl.InputTypeError),
        ([{"number": np.array([1j])}], soilctl.InputTypeError),
    ],
)
def test_bad_cells_are_refused(tmp_path, cells, error):
    with pytest.raises(error):
        soilctl.sweep(square, cells, store=tmp_path)


def test_a_function_without_a_name_needs_one(tmp_path):
    with pytest.raises(soilctl.InputError, match="name="):
        soilctl.sweep(lambda number: number, [{"number": 1}], store=tmp_path)
    with pytest.raises(soilctl.InputTypeError):
        soilctl.sweep(3, [{"number": 1}], store=tmp_path)


def test_a_store_that_cannot_be_written_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(soilctl.FileError):
        soilctl.sweep(square, [{"number": 1}], store=tmp_path / "file", executor=Serial())


def test_what_an_executor_loses_is_run_a_second_time(tmp_path):
    found = soilctl.sweep(square, [{"number": n} for n in range(4)], store=tmp_path, executor=(once := Forgetful(3)))
    assert not found.failures and once.submitted == 7
    found = soilctl.sweep(square, [{"number": 9}], store=tmp_path, executor=(twice := Forgetful(2)))
    assert [f.error for f in found.failures] == ["ValueError: lost"] and twice.submitted == 2


def test_results_are_sliced_and_shown_in_short(tmp_path):
    cells = [{"number": n} for n in range(40)]
    found = soilctl.sweep(poisoned, cells, store=tmp_path, executor=ThreadPoolExecutor(8), name="n")
    assert [one["square"] for one in found[1:7:2]] == [1, 9, 25] and found[40:] == []
    assert [one["square"] for one in found[:-3:-1]] == [39**2, 38**2]
    with pytest.raises(soilctl.SweepError, match="poison 7"):
        found[5:9]
    assert repr(found) == f"SweepResult(40 cells, 2 failed, 40 run now, store={str(tmp_path)!r})"
    assert repr(found.store) == f"Store({str(tmp_path)!r})"
    for kind, name in ((soilctl.SweepResult, "failures"), (soilctl.Failure, "error"), (soilctl.Store, "folder")):
        assert f"    {name}: " in kind.__doc__


UNGUARDED = """
import multiprocessing
import soilctl
from cells import square

multiprocessing.set_start_method("{method}", force=True)
done = soilctl.sweep(square, [{{"number": n}} for n in range(9)], store="store")
print(*(failure.error for failure in done.failures), sep="\\n")
"""
GUARDED = """
import multiprocessing
import soilctl

def cell(number):
    return 3 * number

if __name__ == "__main__":
    multiprocessing.set_start_method("{method}")
    print(sum(soilctl.sweep(cell, [{{"number": n}} for n in range(9)], store="store")))
"""


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_a_script_without_a_guard_is_told_of_it(tmp_path, method):
    words = {"cwd": tmp_path, "capture_output": True, "text": True, "timeout": 120, "check": True}
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parent)}
    (tmp_path / "script.py").write_text(UNGUARDED.format(method=method))
    errors = subprocess.run([sys.executable, "script.py"], env=environment, **words).stdout.splitlines()
    assert len(errors) == 9 and all('if __name__ == "__main__":' in error for error in errors)
    (tmp_path / "script.py").write_text(GUARDED.format(method=method))
    assert subprocess.run([sys.executable, "script.py"], env=environment, **words).stdout.strip() == "108"


def test_a_process_for_each_core_that_may_be_used():
    if not hasattr(os, "sched_setaffinity"):
        pytest.skip("cores cannot be chosen here")
    script = "import os; os.sched_setaffinity(0, {min(os.sched_getaffinity(0))}); from soilctl._sweep import _cores; print(_cores())"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "1"


def test_a_dask_cluster_loses_a_worker_and_no_result(tmp_path):
    distributed = pytest.importorskip("distributed")
    cells = [{"number": n} for n in range(300)]
    soilctl.sweep(poisoned, cells, store=tmp_path / "serial", executor=ThreadPoolExecutor(8))
    options = {"n_workers": 3, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    folder = str(Path(__file__).parent)
    with distributed.LocalCluster(**options, local_directory=str(tmp_path)) as cluster:
        with distributed.Client(cluster) as client:
            client.run(__import__("sys").path.insert, 0, folder)
            victim = min(client.run(os.getpid).values())
            killed = threading.Event()

            def progress(done, total):
                if done >= 100 and not killed.is_set():
                    os.kill(victim, signal.SIGKILL)
                    killed.set()

            executor = client.get_executor()
            store = tmp_path / "dask"
            found = soilctl.sweep(poisoned, cells, store=store, executor=executor, progress=progress)
            assert killed.is_set()
            assert found.submitted == 300
            assert [f.cell["number"] for f in found.failures] == list(range(7, 300, 30))
            assert all(f.error == f"ValueError: poison {f.cell['number']}" for f in found.failures)
            again = soilctl.sweep(poisoned, cells, store=store, executor=executor)
            assert again.submitted == 10 and len(again.failures) == 10
    assert len(files(store)) == 290
    assert files(store) == files(tmp_path / "serial")
