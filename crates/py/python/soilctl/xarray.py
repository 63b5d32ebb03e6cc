"""Results with named axes (``pip install soilctl[xarray]``)."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from ._native import log_table as _columns
from ._native import predict as _predict
from ._units import attributes
from .errors import InputError, InputTypeError

if TYPE_CHECKING:
    from ._sweep import SweepResult

__all__ = ["log_table", "predict"]

_MEMBER = re.compile(r"(.+)_(\d+)$")


def predict(model: str = "chen", **arguments: Any) -> xarray.Dataset:
    """:func:`soilctl.predict` on a grid.

    Args:
        model: One of ``soilctl.MODELS``.
        arguments: Those of :func:`soilctl.predict`. A ``DataArray`` keeps its axes, a list or an array of one axis becomes an axis
            with the name of the argument, and a number holds everywhere.

    Returns:
        ``coefficient``, ``lower``, ``upper`` and, with density, depth and width, ``force_n`` and its ends, over all the axes. All of
        them have ``units`` and ``long_name``.

    Raises:
        InputTypeError: If an array of several axes has no names for them.
        InputError, NoAnswerError: As :func:`soilctl.predict`.
    """
    given = {name: _named(name, value) for name, value in arguments.items()}
    full = xarray.broadcast(*given.values())
    found = _predict(model, **{name: array.values for name, array in zip(given, full, strict=True)})
    values = found.to_dict()
    values.pop("model")
    variables = {key: (full[0].dims, value) for key, value in values.items()}
    return _described(xarray.Dataset(variables, full[0].coords, {"model": found.model, "reference": found.reference}))


def _described(found: xarray.Dataset) -> xarray.Dataset:
    """The same with ``units`` and ``long_name`` of all that has none."""
    for name, variable in found.variables.items():
        variable.attrs = {**attributes(str(name)), **variable.attrs}
    return found


def _named(name: str, value: Any) -> xarray.DataArray:
    if isinstance(value, xarray.DataArray):
        return value
    if np.ma.is_masked(value):
        raise InputError(f"{name} has masked elements, which have no value; leave them out or fill them")
    array = np.asarray(value)
    if array.ndim > 1:
        raise InputTypeError(f"{name} has {array.ndim} axes without names; give an xarray.DataArray")
    return xarray.DataArray(array, {name: array}, (name,)) if array.ndim else xarray.DataArray(array)


def log_table(path: str | os.PathLike[str], topic: str = "/controller/step") -> xarray.Dataset:
    """:func:`soilctl.log_table` over time: elements of an array are one variable, with the second axis ``<name>_index``.

    Raises:
        FileError, InputError, NoAnswerError: As :func:`soilctl.log_table`.
    """
    table = _columns(path, topic)
    time = table.pop("time_s")
    groups: dict[str, list[Any]] = {}
    for column in table:
        member = _MEMBER.match(column)
        # Elements come in order and from 0.
        if member and int(member[2]) == len(groups.get(member[1], [])):
            groups.setdefault(member[1], []).append(table[column])
        else:
            groups[column] = [table[column]]
    variables: dict[str, tuple[tuple[str, ...], Any]] = {}
    for name, columns in groups.items():
        if f"{name}_0" in table:
            variables[name] = (("time_s", f"{name}_index"), np.column_stack(columns))
        else:
            variables[name] = (("time_s",), np.asarray(columns[0]))
    return _described(xarray.Dataset(variables, {"time_s": ("time_s", time)}, {"topic": topic}))


def of_sweep(done: SweepResult) -> xarray.Dataset:
    """What :meth:`soilctl.SweepResult.to_xarray` gives."""
    names = list(done.cells[0]) if done.cells else []
    cells = [_parameters(index, cell, names) for index, cell in enumerate(done.cells)]
    axes = {
        name: sorted({cell[name] for cell in cells}, key=lambda value: (isinstance(value, str), value)) for name in names
    }
    failed = {failure.index for failure in done.failures}
    variables: dict[str, tuple[tuple[str, ...], Any]] = {}
    shapes: dict[str, tuple[int, ...]] = {}
    for index, cell in enumerate(cells):
        if index in failed:
            continue
        at = tuple(axes[name].index(cell[name]) for name in names)
        for key, value in done.columns(index).items():
            if value is None:
                continue
            array = np.asarray(value)
            if shapes.setdefault(key, array.shape) != array.shape:
                raise InputError(f"{key} of cell {index} has shape {array.shape}, earlier ones {shapes[key]}")
            if key not in variables:
                shape = (*(len(axis) for axis in axes.values()), *array.shape)
                own = (f"{key}_{axis}" for axis in range(array.ndim))
                kind = float if array.dtype.kind in "biuf" else object
                variables[key] = ((*names, *own), np.full(shape, np.nan, kind))
            place = variables[key][1]
            if place.dtype == float and array.dtype.kind not in "biuf":
                raise InputError(f"{key} of cell {index} is no number, earlier ones are")
            place[at] = array if array.ndim else value
    return _described(xarray.Dataset(variables, axes))


def _parameters(index: int, cell: dict[str, Any], names: list[str]) -> dict[str, Any]:
    if set(cell) != set(names):
        raise InputError(f"cell {index} has the parameters {sorted(cell)}, the first one {sorted(names)}")
    plain = {name: value.item() if isinstance(value, np.generic) else value for name, value in cell.items()}
    for name, value in plain.items():
        if not isinstance(value, (int, float, str)):
            raise InputError(f"{name} of cell {index} is of type {type(value).__name__}; an axis takes numbers and texts")
    return plain
