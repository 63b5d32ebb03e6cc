"""Many cells, any executor, one store."""

from __future__ import annotations

import multiprocessing
import os
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    wait,
)
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from types import ModuleType
from typing import Any, overload

from ._canonical import decode, encode
from ._progress import Progress, callback
from ._store import Store
from .errors import InputError, InputTypeError, SweepError

Cell = Mapping[str, Any]


@dataclass(frozen=True)
class Failure:
    """A cell that failed.

    Attributes:
        index: Place of the cell among those given.
        cell: The cell.
        error: Type and message of the exception.
    """

    index: int
    cell: dict[str, Any]
    error: str


@dataclass(frozen=True, repr=False)
class SweepResult:
    """What a sweep did. Results are read from the store when they are asked for.

    Indexing gives the result of a cell, in the order in which cells were given, and a slice a list of them; iterating gives those
    that there are.

    Attributes:
        cells: The cells, in the order given.
        keys: Addresses of their results in the store.
        store: Where the results are, a :class:`Store`.
        failures: Cells that failed, in the order given, each a :class:`Failure`. They are tried again the next time.
        submitted: Number of the cells that were handed to the executor in this run.
    """

    cells: list[dict[str, Any]]
    keys: list[str]
    store: Store
    failures: list[Failure] = field(default_factory=list)
    submitted: int = 0

    def __repr__(self) -> str:
        return (
            f"SweepResult({len(self)} cells, {len(self.failures)} failed, {self.submitted} run now, "
            f"store={str(self.store.folder)!r})"
        )

    def __len__(self) -> int:
        """Number of cells."""
        return len(self.cells)

    @overload
    def __getitem__(self, index: int) -> Any: ...
    @overload
    def __getitem__(self, index: slice) -> list[Any]: ...
    def __getitem__(self, index: int | slice) -> Any:
        """The result of the cell at this place, or a list of those in a slice.

        Raises:
            SweepError: If one of them failed.
        """
        if isinstance(index, slice):
            return [self[place] for place in range(len(self))[index]]
        cell = self.cells[index]
        for failure in self.failures:
            if failure.index == index % len(self.cells):
                raise SweepError(f"cell {cell} failed: {failure.error}")
        return self.store.read(self.keys[index])

    def __iter__(self) -> Iterator[Any]:
        """The results of all cells that did not fail, in the order given."""
        failed = {failure.index for failure in self.failures}
        return (self.store.read(key) for index, key in enumerate(self.keys) if index not in failed)

    def raise_for_failures(self) -> None:
        """Raises if a cell failed.

        Raises:
            SweepError: Names the failed cells with their errors.
        """
        if self.failures:
            lines = [f"  {failure.cell}: {failure.error}" for failure in self.failures]
            raise SweepError(f"{len(lines)} of {len(self)} cells failed:\n" + "\n".join(lines))

    def to_pandas(self) -> Any:
        """A ``pandas.DataFrame``: one row a cell that did not fail, its parameters and then its result.

        A result that is a dict becomes several columns, any other one the column ``result``.

        Raises:
            InputError: If a result has a key that is a parameter, too, with another value.
        """
        import pandas

        failed = {failure.index for failure in self.failures}
        rows = []
        for index, cell in enumerate(self.cells):
            if index not in failed:
                rows.append({**cell, **self.columns(index)})
        return pandas.DataFrame(rows)

    def columns(self, index: int) -> dict[str, Any]:
        """The result of a cell by name, without what repeats a parameter: ``{"result": ...}`` if it is no dict.

        Raises:
            SweepError: If the cell failed.
            InputError: If the result has a key that is a parameter, too, with another value.
        """
        result, cell = self[index], self.cells[index]
        if not isinstance(result, dict):
            return {"result": result}
        for key in result.keys() & cell.keys():
            if encode(result[key], key) != encode(cell[key], key):
                raise InputError(f"the result of cell {index} has the key {key!r} of a parameter, with another value; rename one")
        return {key: value for key, value in result.items() if key not in cell}

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset``: the parameters of the cells are its axes, a result that is a dict becomes several variables.

        Cells need not fill the grid: what is missing, failed or None is NaN. Arrays in results, all of one shape, have axes of their
        own behind those of the parameters (``curve_0`` and so on).

        Raises:
            InputError: If parameters are no numbers or texts, differ from cell to cell by name, or results differ in form.
        """
        from .xarray import of_sweep

        return of_sweep(self)

    def _repr_html_(self) -> str:
        done = len(self) - len(self.failures)
        lines = [f"<p>Sweep: {done} of {len(self)} cells done, {self.submitted} run now.</p>"]
        if self.failures:
            rows = "".join(
                f"<tr><td>{escape(str(f.cell))}</td><td>{escape(f.error)}</td></tr>" for f in self.failures
            )
            lines.append(f"<table><tr><th>failed cell</th><th>error</th></tr>{rows}</table>")
        return "".join(lines)


def sweep(
    function: Callable[..., Any],
    cells: Iterable[Cell],
    *,
    store: str | os.PathLike[str],
    executor: Executor | None = None,
    name: str | None = None,
    version: str = "",
    progress: Progress = None,
) -> SweepResult:
    """Calls ``function(**cell)`` for every cell whose result is not in the store yet.

    A sweep that was broken off, by Ctrl-C, an error or a killed worker, goes on where it was when it is called again.
    Results are stored in a canonical form, so the files are the same bytes whatever executor made them.

    Args:
        function: What to call. It must be importable by workers (no lambda), and its result must consist of finite
            numbers, text, lists, dicts and numpy arrays, or have ``to_dict()``.
        cells: Keyword arguments, one mapping a cell, of the same kinds of values.
        store: Folder for the results; made if it is not there.
        executor: Any ``concurrent.futures.Executor``; by default one process a core that this one may use. For a cluster give
            ``dask.distributed.Client(...).get_executor()``. Where processes are spawned rather than forked, a script must call this
            under ``if __name__ == "__main__":``.
        name: Name under which results are stored; by default the function's module (of a script, its file's name) and qualified
            name. Methods of objects need one, and so do notebooks that share a store and have functions of the same name.
        version: Change it when the function changes its answers; older results then no longer count.
        progress: Called with the number of cells that are done and of all cells, after each; or True for a bar of tqdm.

    Returns:
        The results, with the failures by name. Nothing is raised because of a failed cell; see
        :meth:`SweepResult.raise_for_failures`. What the executor itself loses is run a second time before it counts as failed.

    Raises:
        InputError: If a cell is no mapping or has values without a canonical form.
        FileError: If the store cannot be written.
    """
    name = _name(function, name)
    plain = [_cell(cell, index) for index, cell in enumerate(cells)]
    shelf = Store(store)
    keys = [shelf.key(name, version, cell) for cell in plain]
    # The first cell of each key; a dict keeps their order.
    first: dict[str, int] = {}
    for index, key in enumerate(keys):
        first.setdefault(key, index)
    todo = {key: plain[index] for key, index in first.items() if not shelf.has(key)}
    with callback(progress, "cells") as report:
        run = _Run(function, name, version, shelf, len(first) - len(todo), len(first), report)
        if todo:
            run.go(todo, executor)
    failures = [
        Failure(index, plain[index], run.errors[key]) for index, key in enumerate(keys) if key in run.errors
    ]
    return SweepResult(plain, keys, shelf, failures, len(todo))


def _name(function: Callable[..., Any], name: str | None) -> str:
    if not callable(function):
        raise InputTypeError(f"function is of type {type(function).__name__}; it must be callable")
    if name is not None:
        return name
    found = getattr(function, "__qualname__", None)
    # A method says nothing of its object, whose attributes may decide on the result; builtins have their module there.
    bound = getattr(function, "__self__", None)
    if found is None or "<" in found or not (bound is None or isinstance(bound, ModuleType)):
        raise InputError(
            f"{function!r} has no name that stands for it alone; give name=, or use a function at the top of a module"
        )
    module = function.__module__
    if module == "__main__":
        # Scripts that share a store are told apart by their names; notebooks have none.
        script = getattr(sys.modules["__main__"], "__file__", None)
        module = module if script is None else Path(script).stem
    return f"{module}.{found}"


def _cell(cell: Cell, index: int) -> dict[str, Any]:
    if not isinstance(cell, Mapping):
        raise InputTypeError(f"cell {index} is of type {type(cell).__name__}; it must be a mapping of keyword arguments")
    return dict(cell)


def _call(function: Callable[..., Any], cell: bytes) -> tuple[bool, bytes]:
    """Runs in the worker. Errors come back as text: not every exception survives the way."""
    try:
        return True, encode(function(**decode(cell)), "the result")
    except Exception as problem:
        text = str(problem)
        kind = type(problem).__name__
        return False, (f"{kind}: {text}" if text else kind).encode("utf-8", "replace")


def _cores() -> int:
    """Cores that this process may use, which may be fewer than there are."""
    count = getattr(os, "process_cpu_count", None)
    if count is not None:
        return count() or 1
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


#: Said of every cell if not even a process without a cell lives.
_UNGUARDED = (
    "its process died, as does every other one that is started; a script must call sweep under "
    'if __name__ == "__main__":, since each process imports it anew'
)


def _processes_live() -> bool:
    """Whether a process can be started at all: an unguarded script that is imported by it would start others, and dies."""
    if multiprocessing.get_start_method() == "fork":
        return True
    with ProcessPoolExecutor(1) as pool:
        return not isinstance(pool.submit(os.getpid).exception(), BrokenExecutor)


def _problem(future: Future[tuple[bool, bytes]]) -> BaseException | None:
    """What the executor says went wrong, not the cell."""
    try:
        return future.exception()
    except CancelledError as cancelled:
        return cancelled


class _Run:
    """One run of a sweep: cells in flight, results to the store, errors by key."""

    def __init__(
        self,
        function: Callable[..., Any],
        name: str,
        version: str,
        store: Store,
        done: int,
        total: int,
        progress: Callable[[int, int], object] | None,
    ) -> None:
        self.function = function
        self.name = name
        self.version = version
        self.store = store
        self.done = done
        self.total = total
        self.progress = progress
        self.errors: dict[str, str] = {}

    def go(self, todo: dict[str, dict[str, Any]], executor: Executor | None) -> None:
        if executor is not None:
            if self.through(executor, todo, in_flight=1024):
                for key in [key for key in todo if not self.settled(key)]:
                    self.failed(key, todo[key], "the executor broke before it was done")
            return
        workers = _cores()
        left = todo
        while left:
            with ProcessPoolExecutor(min(workers, len(left))) as pool:
                suspects = self.through(pool, left, in_flight=2 * workers)
            if suspects and not _processes_live():
                for key in [key for key in left if not self.settled(key)]:
                    self.failed(key, todo[key], _UNGUARDED)
                return
            # A worker died, and took the pool along. Whose fault it was shows when each is alone.
            for key in suspects:
                with ProcessPoolExecutor(1) as alone:
                    if self.through(alone, {key: todo[key]}, in_flight=1):
                        self.failed(key, todo[key], "its process died (killed, out of memory, or crashed)")
            left = {} if not suspects else {k: c for k, c in left.items() if not self.settled(k)}

    def settled(self, key: str) -> bool:
        return key in self.errors or self.store.has(key)

    def through(self, executor: Executor, todo: dict[str, dict[str, Any]], in_flight: int) -> list[str]:
        """Runs cells until all are done or the executor breaks; what was in flight then.

        Errors of a cell itself are results. One of the executor's own gets the cell a second try: a cluster that loses a
        worker with finished results on it may give up a task, or say "lost" of one whose result it holds in its hands.
        """
        waiting = deque(todo)
        second: set[str] = set()
        running: dict[Future[tuple[bool, bytes]], str] = {}
        broken: list[str] = []
        try:
            while running or (waiting and not broken):
                while waiting and len(running) < in_flight and not broken:
                    key = waiting.popleft()
                    try:
                        future = executor.submit(_call, self.function, encode(todo[key], "the cell"))
                    except BrokenExecutor:
                        broken.append(key)
                        break
                    running[future] = key
                finished, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in finished:
                    key = running.pop(future)
                    problem = _problem(future)
                    if isinstance(problem, BrokenExecutor):
                        # That says nothing about the cell.
                        broken.append(key)
                    elif problem is None:
                        self.take(key, todo[key], future)
                    elif key in second:
                        self.failed(key, todo[key], f"{type(problem).__name__}: {problem}")
                    else:
                        second.add(key)
                        waiting.append(key)
        finally:
            # After Ctrl-C or a full disk nothing more is started.
            for future in running:
                future.cancel()
        return broken

    def take(self, key: str, cell: dict[str, Any], future: Future[tuple[bool, bytes]]) -> None:
        fine, data = future.result()
        if not fine:
            self.failed(key, cell, data.decode("utf-8"))
            return
        self.store.publish(key, self.name, self.version, cell, data)
        self.step()

    def failed(self, key: str, cell: dict[str, Any], error: str) -> None:
        self.errors[key] = error
        self.store.note_failure(key, self.name, self.version, cell, error)
        self.step()

    def step(self) -> None:
        self.done += 1
        if self.progress is not None:
            self.progress(self.done, self.total)
