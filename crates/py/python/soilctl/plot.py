"""Figures with Matplotlib (``pip install soilctl[plot]``).

Every function draws into the given axes, or into new ones, and returns them.
"""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.path import Path
from matplotlib.patches import PathPatch

from ._native import Bracket, Estimate, Solution

__all__ = ["brackets", "mesh", "region"]


def _axes(axes: Axes | None) -> Axes:
    return plt.subplots(layout="constrained")[1] if axes is None else axes


def region(estimate: Estimate, *, axes: Axes | None = None, **options: Any) -> Axes:
    """The consistent soils: friction angle against density.

    Args:
        estimate: What :func:`soilctl.estimate` found. A region without any soil leaves empty axes, which say so.
        axes: Where to draw.
        options: For ``matplotlib.patches.PathPatch``, such as ``facecolor`` or ``label``.
    """
    axes = _axes(axes)
    axes.set_xlabel("friction angle in degrees")
    axes.set_ylabel("density in kg/m³")
    if not estimate.consistent:
        axes.text(0.5, 0.5, "no soil is consistent", ha="center", va="center", transform=axes.transAxes)
        return axes
    rings = [ring for polygon in estimate.__geo_interface__["coordinates"] for ring in polygon]
    path = Path.make_compound_path(*(Path(np.array(ring), closed=True) for ring in rings))
    axes.add_patch(PathPatch(path, **{"alpha": 0.5, **options}))
    axes.autoscale_view()
    return axes


def brackets(at: Any, found: list[Bracket], *, axes: Axes | None = None, **options: Any) -> Axes:
    """Lower and upper bounds as a band.

    Args:
        at: Abscissae, one a bracket, such as tool angles.
        found: The brackets, all of the same quantity.
        axes: Where to draw.
        options: For ``Axes.fill_between``.
    """
    axes = _axes(axes)
    order = np.argsort(np.asarray(at, dtype=float))
    x = np.asarray(at, dtype=float)[order]
    lower = np.array([bracket.lower for bracket in found])[order]
    upper = np.array([bracket.upper for bracket in found])[order]
    axes.fill_between(x, lower, upper, **{"alpha": 0.4, **options})
    axes.plot(x, lower, "k_", x, upper, "k_", markersize=6)
    if found:
        unit = f" in {found[0].unit}" if found[0].unit else ""
        axes.set_ylabel(found[0].quantity + unit)
    return axes


def mesh(solution: Solution, *, bound: str = "upper", axes: Axes | None = None, **options: Any) -> Axes:
    """The mesh of a bound; that of the upper bound is coloured by the speed of the soil, and shows what moves.

    Lengths are in m, in the coordinates of the problem, or in the solution's own if it does not say how long they are. A plate's top
    is at (0, 0), with x along the surface.

    Args:
        solution: ``bracket.solution``, or one that was read.
        bound: ``"upper"`` or ``"lower"``.
        axes: Where to draw.
        options: For ``Axes.tripcolor`` (upper) or ``Axes.triplot`` (lower).
    """
    axes = _axes(axes)
    triangles = solution.triangles(bound)
    # In m where it is known, in the coordinates of the problem.
    scale, origin = solution.length_m or 1.0, np.array(solution.origin_m)
    corners = origin + scale * triangles.reshape(-1, 2)
    index = np.arange(len(corners)).reshape(-1, 3)
    if bound == "upper":
        speed = np.hypot(*solution.velocity(triangles.mean(axis=1)).T)
        style = {"cmap": "Blues", "edgecolors": "0.5", "linewidth": 0.2, "vmin": 0.0, **options}
        drawn = axes.tripcolor(corners[:, 0], corners[:, 1], index, facecolors=speed, **style)
        axes.figure.colorbar(drawn, ax=axes, label="speed over that of the structure", shrink=0.7)
        for line in solution.failure_surface():
            axes.plot(*(origin + scale * line).T, color="tab:red", linewidth=1.0)
    else:
        axes.triplot(corners[:, 0], corners[:, 1], index, **{"color": "0.4", "linewidth": 0.3, **options})
    unit = "m" if solution.length_m is not None else "slant lengths"
    axes.set_xlabel(f"x in {unit}")
    axes.set_ylabel(f"y in {unit}")
    axes.set_aspect("equal")
    return axes
