"""Meshes and fields of solutions for meshio (``pip install soilctl[mesh]``) and PyVista.

Lengths are in m, in the coordinates of the problem, and stresses in Pa; in the solution's own units if it does not say how large
they are.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ._native import Solution

__all__ = ["to_arrays", "to_meshio", "to_pyvista"]


def to_arrays(solution: Solution, bound: str = "upper") -> dict[str, Any]:
    """The mesh of a bound with its field, as arrays.

    Args:
        solution: ``bracket.solution``, or one that was read.
        bound: ``"upper"`` or ``"lower"``.

    Returns:
        ``points`` (3 n, 2), three a triangle, since fields may jump, and ``triangles`` (n, 3), indices into them. Of the upper
        bound ``velocity`` (n, 2) in the middle of each triangle, over that of the structure, and ``shear_rate`` (n,), velocity over
        length; of the lower bound ``stress`` (n, 3) there: xx, yy, xy, tension positive.

    Raises:
        NoAnswerError: If the solution has no such bound.
        InputError: If there is no bound of this name.
    """
    corners = solution.triangles(bound)
    length, middles = solution.length_m or 1.0, corners.mean(axis=1)
    arrays = {
        "points": np.array(solution.origin_m) + length * corners.reshape(-1, 2),
        "triangles": np.arange(3 * len(corners)).reshape(-1, 3),
    }
    if bound == "upper":
        return {**arrays, "velocity": solution.velocity(middles), "shear_rate": solution.shear_rate() / length}
    return {**arrays, "stress": (solution.stress_pa or 1.0) * solution.stress(middles)}


def to_meshio(solution: Solution, bound: str = "upper") -> Any:
    """The same as a ``meshio.Mesh`` in the plane z = 0, for any format that meshio writes.

    Raises:
        NoAnswerError, InputError: As :func:`to_arrays`.
    """
    import meshio

    arrays = _in_space(to_arrays(solution, bound))
    points, triangles = arrays.pop("points"), arrays.pop("triangles")
    return meshio.Mesh(points, [("triangle", triangles)], cell_data={name: [data] for name, data in arrays.items()})


def to_pyvista(solution: Solution, bound: str = "upper") -> dict[str, Any]:
    """What ``pyvista.PolyData.from_regular_faces(**...)`` takes, with the data of the cells under ``cell_data``.

    ``parts = to_pyvista(s); data = parts.pop("cell_data"); mesh = pyvista.PolyData.from_regular_faces(**parts);
    mesh.cell_data.update(data)``

    Raises:
        NoAnswerError, InputError: As :func:`to_arrays`.
    """
    arrays = _in_space(to_arrays(solution, bound))
    return {"points": arrays.pop("points"), "faces": arrays.pop("triangles"), "cell_data": arrays}


def _in_space(arrays: dict[str, Any]) -> dict[str, Any]:
    """With a third component of points and velocities, which files and viewers expect."""
    flat = {name: array for name, array in arrays.items() if name in ("points", "velocity")}
    return {**arrays, **{name: np.column_stack([array, np.zeros(len(array))]) for name, array in flat.items()}}
