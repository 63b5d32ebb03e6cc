"""Meshes and fields of solutions for meshio (``pip install soilctl[mesh]``) and PyVista."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._native import Solution

__all__ = ["to_arrays", "to_meshio", "to_pyvista"]


def to_arrays(solution: Solution) -> dict[str, Any]:
    """The mesh of the upper bound with its flow, as arrays.

    Returns:
        ``points`` (3 n, 2), three a triangle, since velocities may jump; ``triangles`` (n, 3), indices into them;
        ``velocity`` (n, 2) in the middle of each triangle, and ``shear_rate`` (n,).

    Raises:
        NoAnswerError: If the solution has no upper bound.
    """
    corners = solution.triangles("upper")
    return {
        "points": corners.reshape(-1, 2),
        "triangles": np.arange(3 * len(corners)).reshape(-1, 3),
        "velocity": solution.velocity(corners.mean(axis=1)),
        "shear_rate": solution.shear_rate(),
    }


def to_meshio(solution: Solution) -> Any:
    """The same as a ``meshio.Mesh``, for any format that meshio writes.

    Raises:
        NoAnswerError: If the solution has no upper bound.
    """
    import meshio

    arrays = to_arrays(solution)
    data = {"velocity": [arrays["velocity"]], "shear_rate": [arrays["shear_rate"]]}
    return meshio.Mesh(arrays["points"], [("triangle", arrays["triangles"])], cell_data=data)


def to_pyvista(solution: Solution) -> dict[str, Any]:
    """What ``pyvista.PolyData.from_regular_faces(**...)`` takes, with the data of the cells under ``cell_data``.

    ``parts = to_pyvista(s); data = parts.pop("cell_data"); mesh = pyvista.PolyData.from_regular_faces(**parts);
    mesh.cell_data.update(data)``

    Raises:
        NoAnswerError: If the solution has no upper bound.
    """
    arrays = to_arrays(solution)

    def in_space(plane: Any) -> Any:
        return np.column_stack([plane, np.zeros(len(plane))])

    return {
        "points": in_space(arrays["points"]),
        "faces": arrays["triangles"],
        "cell_data": {"velocity": in_space(arrays["velocity"]), "shear_rate": arrays["shear_rate"]},
    }
