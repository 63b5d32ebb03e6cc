"""Types of the compiled part; `stubtest` compares them with it."""

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Final, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Floats: TypeAlias = float | NDArray[np.float64]
_Path: TypeAlias = str | os.PathLike[str]

__all__ = [
    "MODELS",
    "VERSION",
    "Arm",
    "Bracket",
    "Certificate",
    "Estimate",
    "Plant",
    "Prediction",
    "Progress",
    "Sensed",
    "Solution",
    "_restore_arm",
    "_restore_bracket",
    "_restore_certificate",
    "_restore_prediction",
    "_restore_sensed",
    "_restore_solution",
    "answer_command",
    "bound",
    "estimate",
    "failure_surface",
    "log_info",
    "log_recover",
    "log_table",
    "predict",
    "run_command",
    "run_use_case",
    "soil_names",
    "solve",
    "store_has",
    "store_key",
    "store_note_failure",
    "store_paths",
    "store_publish",
    "store_read",
    "use_case_schemas",
    "valid_range",
]

MODELS: Final[list[str]]
VERSION: Final[str]

@final
class Prediction:
    """Coefficients of a plate, and its failure force if all that it needs was given.

    Attributes are floats if all arguments were numbers, and otherwise arrays of their common shape. Coefficients are
    normalised by the slant length L: ``F = 1/2 gamma L^2 w K``.
    """
    @property
    def model(self) -> str:
        """Id of the model."""
    @property
    def reference(self) -> str:
        """Where the model comes from."""
    @property
    def coefficient(self) -> _Floats:
        """Net coefficient (passive minus active); the geometric mean of the ends of a bracket."""
    @property
    def lower(self) -> _Floats:
        """Lower end of the bracket on the net coefficient; that itself for a point model."""
    @property
    def upper(self) -> _Floats:
        """Upper end of it."""
    @property
    def interpolation_margin(self) -> _Floats | None:
        """By how much, relatively, interpolation in a table may be wrong; None for a formula."""
    @property
    def force_n(self) -> _Floats | None:
        """Failure force in N with all loads; None without density, depth and width."""
    @property
    def force_lower_n(self) -> _Floats | None:
        """Lower end of the bracket on the force in N."""
    @property
    def force_upper_n(self) -> _Floats | None:
        """Upper end of it."""
    def to_dict(self) -> dict[str, Any]:
        """Everything as a dict of numbers and arrays."""
    def _repr_html_(self) -> str: ...

def predict(
    model: str = "chen",
    *,
    tool_angle_deg: ArrayLike,
    friction_angle_deg: ArrayLike,
    interface_friction_deg: ArrayLike,
    surface_slope_deg: ArrayLike | None = None,
    density_kg_m3: ArrayLike | None = None,
    depth_m: ArrayLike | None = None,
    width_m: ArrayLike | None = None,
    cohesion_pa: ArrayLike | None = None,
    adhesion_pa: ArrayLike | None = None,
    surcharge_pa: ArrayLike | None = None,
    gravity_m_s2: ArrayLike | None = None,
    ends: str | None = None,
) -> Prediction:
    """Coefficients and forces of a flat plate that fails soil, by a named model.

    All numbers may be arrays; they are broadcast against each other. The work is done without the interpreter's lock, on all
    cores, and Ctrl-C ends it.

    Args:
        model: One of ``soilctl.MODELS``.
        tool_angle_deg: Plate from the horizontal.
        friction_angle_deg: Internal friction of the soil.
        interface_friction_deg: Friction between soil and plate, at most that of the soil.
        surface_slope_deg: Slope of the ground, positive when it rises ahead of the plate.
        density_kg_m3: Bulk density; for forces, with depth and width.
        depth_m: Vertical depth of the plate's lower edge.
        width_m: Width of the plate.
        cohesion_pa: Cohesion of the soil.
        adhesion_pa: Adhesion between soil and plate.
        surcharge_pa: Vertical pressure on the surface.
        gravity_m_s2: Gravity.
        ends: ``finite`` for a plate with ends, whose force is above that of plane strain, ``none`` for plane strain. By default a
            plate has ends if the model knows them and the plate has a width.

    Raises:
        InputError: If a number is out of the model's range, not finite, or a shape does not go with the others.
        NoAnswerError: If there is no finite answer. The message names the first element that has none.
    """
def valid_range(model: str) -> dict[str, tuple[float, float]]:
    """Angles in degrees for which a model answers, ends included, by the name of the argument of ``predict``.

    Raises:
        InputError: If there is no such model.
    """
def failure_surface(
    model: str = "chen",
    *,
    tool_angle_deg: float,
    friction_angle_deg: float,
    interface_friction_deg: float,
    surface_slope_deg: float = 0.0,
) -> NDArray[np.float64] | None:
    """Failure surface ahead of a plate of unit slant length: points of shape (n, 2) from the tip to the ground.

    The tip is the origin, x points ahead and y up; the plate has no ends. None for tables, which know no surface.

    Raises:
        InputError, NoAnswerError: As ``predict``.
    """

@final
class Arm:
    """A digging arm of five joints: base, shoulder, elbow, twist, wrist.

    Joint angles are in rad in arrays whose last axis has length 5. A pose is ``x, y, z`` of the middle of the plate's lower
    edge in m, the pitch ``n1`` and the angle out of the arm's plane ``n2`` in rad. All methods take arrays of any shape
    before the last axis.
    """
    def __new__(cls, file: _Path | None = None) -> Arm: ...
    @staticmethod
    def from_toml(text: str) -> Arm:
        """An arm from the text of a TOML file.

        Raises:
            InputError: If the text describes no arm; the message names the key.
        """
    @property
    def limits_rad(self) -> NDArray[np.float64]:
        """Least and greatest joint angles in rad, shape (2, 5)."""
    def forward(self, joint_angles_rad: ArrayLike) -> NDArray[np.float64]:
        """Poses of the plate, shape (..., 5), for joint angles of shape (..., 5). Limits are not checked.

        Raises:
            InputError: If an angle is not finite or beyond 1000 rad.
        """
    def inverse(self, pose: ArrayLike) -> NDArray[np.float64]:
        """Joint angles in rad, shape (..., 5), that bring the plate to poses of shape (..., 5), in closed form.

        Raises:
            NoAnswerError: If a pose is out of reach, singular, or needs a joint beyond its limits. The message names the
                first such pose.
            InputError: If a number is out of range.
        """
    def jacobian(self, joint_angles_rad: ArrayLike) -> NDArray[np.float64]:
        """Derivatives of the pose with respect to the joints, shape (..., 5, 5): rows x, y, z, n1, n2, columns
        joints.

        Raises:
            NoAnswerError: Where the hand is at right angles to the arm's plane, and the pitch has no derivative.
            InputError: If an angle is not finite or beyond 1000 rad.
        """
    def velocity(
        self, joint_angles_rad: ArrayLike, joint_velocities_rad_s: ArrayLike
    ) -> NDArray[np.float64]:
        """Velocities of the pose, shape (..., 5), for joint angles and velocities (rad/s), each of shape (..., 5);
        one for all
        of the other will do.

        Raises:
            InputError, NoAnswerError: As ``jacobian``.
        """
    def joint_torques(self, joint_angles_rad: ArrayLike, force: ArrayLike) -> NDArray[np.float64]:
        """Joint torques in N m, shape (..., 5), that press with a force at the tip (N, and N m for n1 and n2); one
        posture or one
        force for all of the other will do.

        Raises:
            InputError, NoAnswerError: As ``jacobian``.
        """
    def stiffness_torques(
        self,
        joint_angles_rad: ArrayLike,
        displacement: ArrayLike,
        *,
        stiffness: ArrayLike,
        wrist_locked: bool = False,
    ) -> NDArray[np.float64]:
        """Joint torques in N m of springs at the plate, shape (5,): ``J^T K dx`` at one posture.

        Args:
            joint_angles_rad: The posture, shape (5,).
            displacement: Wanted minus actual pose, shape (5,), m and rad.
            stiffness: Along r, t, z (N/m) and against n1, n2 (N m/rad), where r and t turn with the base: shape (5,), or
                (5, 5) for coupled ones.
            wrist_locked: The wrist is switched off and held by its worm gear; n1 and n2 do not count.

        Raises:
            InputError, NoAnswerError: As ``jacobian``.
        """
    def gravity_torques(self, joint_angles_rad: ArrayLike) -> NDArray[np.float64]:
        """Joint torques in N m that hold the arm against gravity, shape (..., 5).

        Raises:
            InputError: If an angle is not finite or beyond 1000 rad.
        """
    def motor_angles(self, joint_angles_rad: ArrayLike) -> NDArray[np.float64]:
        """Motor angles in rad for joint angles, shape (..., 5); elbow and twist share a differential.

        Raises:
            InputError: If an angle is not finite or beyond 1000 rad.
        """
    def joint_angles(self, motor_angles_rad: ArrayLike) -> NDArray[np.float64]:
        """Joint angles in rad for motor angles, shape (..., 5): the inverse of ``motor_angles``.

        Raises:
            InputError: If an angle is not finite or beyond 1000 rad.
        """
    @staticmethod
    def digging_pose(
        *, radius_m: float, height_m: float, tool_angle_deg: float, base_angle_deg: float = 0.0
    ) -> NDArray[np.float64]:
        """Pose, shape (5,), of a plate with a level lower edge, ready for a stroke towards the base.

        Args:
            radius_m: From the base's axis to the middle of the lower edge.
            height_m: Of the lower edge, in the base frame.
            tool_angle_deg: Plate from the horizontal; below 90 the lower edge is nearer to the base.
            base_angle_deg: Where the arm points.

        Raises:
            InputError: If a number is not finite or out of range.
        """
    def check_limits(self, joint_angles_rad: ArrayLike) -> None:
        """Refuses joint angles, shape (..., 5), outside the limits.

        Raises:
            NoAnswerError: Names the first element and the joint that is outside.
        """
    def urdf(self) -> str:
        """The arm as URDF."""

@final
class Bracket:
    """Proven bounds: the true value for rigid-plastic soil with associated flow lies between them."""
    @property
    def lower(self) -> float:
        """The lower bound, in ``unit``."""
    @property
    def upper(self) -> float:
        """The upper bound, in ``unit``."""
    @property
    def quantity(self) -> str:
        """What is bounded."""
    @property
    def unit(self) -> str:
        """Its unit; empty for pure numbers."""
    @property
    def ended(self) -> str:
        """Why the run ended: gap, elements, work, memory, time or stopped."""
    @property
    def stopped_by(self) -> str:
        """What kind of limit that is: goal, work, memory, seconds or user. Only after the last two the same call
        may end
        elsewhere another time.
        """
    @property
    def work(self) -> int:
        """Work spent: elements of meshes times steps of the solver on them."""
    @property
    def factorisation(self) -> tuple[str | None, str | None]:
        """What factorised the solver's systems behind the lower and the upper bound."""
    @property
    def seconds(self) -> float:
        """Time spent in s."""
    @property
    def force_n(self) -> tuple[float, float] | None:
        """Bounds on the force in N; None without depth, width and density."""
    @property
    def elements(self) -> tuple[int, int]:
        """Triangles of the meshes of lower and upper bound."""
    @property
    def gap(self) -> float | None:
        """``|(U - L) / ((U + L) / 2)|``; None if the bounds are on both sides of zero."""
    @property
    def solution(self) -> Solution:
        """The fields that prove the bounds: to look at, to save, and to prove anew.

        Raises:
            NoAnswerError: For a factor of safety, whose bounds are of soils of different strength: see ``solutions``.
        """
    @property
    def solutions(self) -> dict[str, Solution]:
        """All solutions by name: ``both``, or ``lower`` and ``upper`` for a factor of safety."""
    def __contains__(self, value: float, /) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Bracket: ...
    def __deepcopy__(self, _memo: Any, /) -> Bracket: ...
    def to_dict(self) -> dict[str, Any]:
        """The numbers as a dict."""
    def _repr_html_(self) -> str: ...

@final
class Progress:
    """One level of meshes, as ``progress`` gets it."""
    @property
    def elements(self) -> int:
        """Triangles of the level's mesh."""
    @property
    def gap(self) -> float | None:
        """Gap of the best bounds so far; None before the first pair."""
    @property
    def factor(self) -> float | None:
        """What strength was divided by, in the search of a factor of safety; else None."""

def bound(
    *,
    tool_angle_deg: float,
    friction_angle_deg: float,
    interface_friction_deg: float,
    surface_slope_deg: float = 0.0,
    density_kg_m3: float | None = None,
    depth_m: float | None = None,
    width_m: float | None = None,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    width_ratio: float | None = None,
    ends: str | None = None,
    tetrahedra: int = 400,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int | None = None,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: str = "auto",
    progress: Callable[[Progress], object] | bool | None = None,
) -> Bracket:
    """Proven bounds on the net force coefficient of an embedded plate, per slant length: ``K = 2 F / (gamma L^2
    w)``.

    Args:
        tool_angle_deg: Plate from the horizontal, 10 to 170.
        friction_angle_deg: Internal friction of the soil, above 0 and below 70.
        interface_friction_deg: Friction between soil and plate, at most that of the soil.
        surface_slope_deg: Slope of the ground, positive when it rises ahead of the plate.
        density_kg_m3: Bulk density; for forces, and with cohesion, adhesion or surcharge.
        depth_m: Vertical depth of the plate's lower edge; likewise.
        width_m: Width of the plate; for forces, and with it and a depth the plate has ends.
        width_ratio: Width over vertical depth, where neither is given in metres.
        ends: ``finite`` for a plate with ends, whose force is above that of plane strain, ``none`` for plane strain. By default
            a plate with a width has ends.
        cohesion_pa: Cohesion of the soil.
        adhesion_pa: Adhesion between soil and plate.
        surcharge_pa: Vertical pressure on the surface.
        gravity_m_s2: Gravity; by default the standard one.
        tetrahedra: About how many tetrahedra the stress field about an end of an upright plate on level ground has, which bounds from
            below what ends add to the force of soil with weight alone: more take longer and narrow the bracket; 0 for none.
        max_gap: Gap at which to stop.
        max_elements: Most elements of a mesh.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine; by default three million.
        max_seconds: Time that may be spent, if it is to be limited: where the run ends then depends on the machine, and
            ``stopped_by`` says ``seconds``.
        max_memory_mb: Memory that may be used: a mesh whose programs may need more is not made.
        threads: The bounds are the same for any number.
        factorisation: What factorises the systems of the solver's steps: ``qdldl``, ``faer``, or ``auto`` for the choice by the
            size of each program. The last digits depend on it.
        progress: Called after each level with an object that has ``elements`` and ``gap``; if it raises, the run
            ends. Or True for a bar of tqdm.

    Raises:
        InputError: If a number is out of its range.
        NoAnswerError: If no pair of bounds was proven within the budget.
        Interrupted: At Ctrl-C; the best bounds so far are in its ``best``.
    """
def solve(
    problem: _Path | Mapping[str, Any],
    *,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int | None = None,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: str = "auto",
    progress: Callable[[Progress], object] | bool | None = None,
) -> Bracket:
    """Proven bounds for a plane-strain collapse problem that is described in a file or a dict.

    What is bounded is what the description's objective asks for: a force, a factor on loads or weights, an acceleration,
    or a factor of safety (see ``Bracket.quantity``). Descriptions with cases or sweeps are for ``soilctl.use_cases.solve``.

    Args:
        problem: Path of a problem file (.toml or .json), or the description as a dict or another mapping, whose numbers may be
            numpy's.
        max_gap, max_elements, max_work, max_seconds, max_memory_mb, threads, factorisation, progress: As for ``bound``.

    Raises:
        InputError: If the description makes no sense.
        FileError: If the file cannot be read.
        NoAnswerError: If there is no collapse load, or no pair of bounds was proven within the budget.
        Interrupted: At Ctrl-C; the best bounds so far are in its ``best``.
    """

@final
class Solution:
    """A lower and an upper bound with the fields that prove them.

    Lengths are in units of ``length_m``, stresses of ``stress_pa``, velocities of the structure's.
    """
    @staticmethod
    def read(path: _Path) -> Solution:
        """A solution from a file that ``write`` or ``soilctl bound --save`` has written.

        Raises:
            FileError: If the file cannot be read.
            InputError: If it is no solution.
        """
    def write(self, path: _Path) -> None:
        """Writes a file for ``read`` and ``soilctl certify``.

        Raises:
            FileError: If it cannot be written.
        """
    def certify(self) -> Certificate:
        """Proves both bounds anew, with interval arithmetic and without the solver.

        Raises:
            ProofError: If the checker proves bounds that exclude each other, which is a fault of its own.
        """
    @property
    def description(self) -> str | None:
        """What the problem is, in words; None if the file does not say."""
    @property
    def length_m(self) -> float | None:
        """One unit of length in m; None if the file does not say."""
    @property
    def stress_pa(self) -> float | None:
        """One unit of stress in Pa; None if the file does not say."""
    @property
    def width(self) -> float | None:
        """Width of the structure in units of length; None in plane strain. A structure with ends has no flow in the
        plane: its upper
        bound is proven by blocks in space.
        """
    @property
    def origin_m(self) -> tuple[float, float]:
        """Where the fields' origin is in the coordinates of the problem, in m: a point of the fields is at
        ``origin_m + length_m * point`` there. (0, 0) for plates, whose origin is the plate's top, and for solutions that were read.
        """
    def triangles(self, bound: str = "upper") -> NDArray[np.float64]:
        """Corners of the triangles of a bound's mesh, counter-clockwise, shape (n, 3, 2).

        Args:
            bound: ``"upper"`` or ``"lower"``: each has a mesh of its own.

        Raises:
            NoAnswerError: If the solution has no such bound.
        """
    def velocity(self, points: ArrayLike) -> NDArray[np.float64]:
        """Velocities of the upper bound at points of shape (..., 2), in units of the structure's, same shape.

        Raises:
            NoAnswerError: If a point is outside the soil, or there is no upper bound.
        """
    def stress(self, points: ArrayLike) -> NDArray[np.float64]:
        """Total stresses ``xx, yy, xy`` of the lower bound at points of shape (..., 2), tension positive, shape
        (..., 3).

        Raises:
            NoAnswerError: If a point is outside the soil, or there is no lower bound.
        """
    def shear_rate(self) -> NDArray[np.float64]:
        """Greatest shear strain rate of each triangle of the upper bound (velocity over length), shape (n,).

        Raises:
            NoAnswerError: If there is no upper bound.
        """
    def failure_surface(self) -> list[NDArray[np.float64]]:
        """The boundary of the soil that moves: a list of lines, each of shape (n, 2).

        Raises:
            NoAnswerError: If there is no upper bound.
        """
    def contacts(self) -> list[dict[str, NDArray[np.float64]]]:
        """Stresses between structure and soil, of the lower bound: one dict a face, with the arrays ``arc``,
        ``points``,
        ``pressure`` and ``shear``, two entries an edge of the mesh.

        Raises:
            NoAnswerError: If there is no lower bound.
        """
    def vtu(self) -> str:
        """The solution in ParaView's format, in the coordinates of the problem: velocities, stresses, dissipation,
        soil.

        Raises:
            NoAnswerError: If there is neither an upper nor a lower bound.
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Solution: ...
    def __deepcopy__(self, _memo: Any, /) -> Solution: ...
    def _repr_svg_(self) -> str | None:
        """The mesh of the upper bound; the faster the soil moves, the darker. Without one, that of the lower bound;
        None without
        either.
        """

@final
class Certificate:
    """What a solution proves, whatever it claims."""
    @property
    def certified(self) -> bool:
        """Whether every claim is proven."""
    @property
    def lower_claimed(self) -> float | None:
        """Claimed lower bound, in the units of the solution; None if there is none."""
    @property
    def lower_proven(self) -> float | None:
        """Proven lower bound; None if the field proves nothing."""
    @property
    def lower_refusal(self) -> str | None:
        """Why the field proves no lower bound."""
    @property
    def upper_claimed(self) -> float | None:
        """Claimed upper bound; None if there is none."""
    @property
    def upper_proven(self) -> float | None:
        """Proven upper bound; None if the field proves nothing."""
    @property
    def upper_refusal(self) -> str | None:
        """Why the field proves no upper bound."""
    def __bool__(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def _repr_html_(self) -> str: ...

@final
class Estimate:
    """Every soil that could have produced the measurements.

    The region encloses the consistent soils: its boundary lies outside of the true one by at most 0.03 % in density.
    """
    @property
    def consistent(self) -> bool:
        """Whether any soil is consistent with all measurements."""
    @property
    def friction_angle_deg(self) -> tuple[float, float] | None:
        """Least and greatest friction angle in degrees; None if no soil is consistent."""
    @property
    def density_kg_m3(self) -> tuple[float, float] | None:
        """Least and greatest bulk density in kg/m3; None if no soil is consistent."""
    @property
    def end_factor(self) -> tuple[float, float] | None:
        """Least and greatest end factor that strokes may share: the part of what ends add at most that they do add.
        None if they share none, or no soil is consistent.
        """
    @property
    def area(self) -> float:
        """Area of the region in deg kg/m3."""
    @property
    def cut_by_search(self) -> bool:
        """Whether a limit of the search rather than a measurement cuts the region, so that it may be larger."""
    @property
    def best_fit(self) -> dict[str, float] | None:
        """The soil that fits best: a dict of friction angle, density, interface friction and misfit; None if there
        is none.
        """
    @property
    def conflict(self) -> dict[str, Any]:
        """What breaks the consistency, by the places of measurements: ``culprits`` without which all others agree,
        ``pairs``
        that no soil explains together, and those that none explains ``alone``.
        """
    def agreement_factor(self) -> float | None:
        """Factor by which all force intervals must grow (or, below 1, may shrink) until the measurements only just
        agree; None
        if ten times the uncertainty is not enough.
        """
    def section(self, interface_friction_deg: float) -> dict[str, Any]:
        """The consistent soils at one interface friction, as a GeoJSON geometry like ``__geo_interface__``.

        Args:
            interface_friction_deg: Within the interval that the estimate was made for, or any that the model covers.

        Raises:
            InputError: If the angle is out of range.
        """
    def bands(self, interface_friction_deg: float) -> list[dict[str, Any]]:
        """What each measurement alone would allow at one interface friction: GeoJSON geometries in the order of the
        measurements.

        Raises:
            InputError: If the angle is out of range.
        """
    def next_strokes(
        self,
        *,
        tool_angle_deg: ArrayLike,
        depth_m: ArrayLike,
        width_m: ArrayLike,
        force_scatter: float = 0.05,
        depth_error_m: float = 0.0005,
        force_limit_n: float | None = None,
    ) -> list[dict[str, Any]]:
        """Strokes that would shrink the region most, the best first: dicts of ``tool_angle_deg``, ``depth_m``,
        ``width_m``, ``area_left`` (relative to now), ``friction_angle_width_deg``, ``density_width_kg_m3``, ``force_n`` and ``model``.

        Args:
            tool_angle_deg: Angles to consider, shape (n,).
            depth_m: Depths to consider, shape (m,).
            width_m: Widths of plates to consider, a number or shape (k,).
            force_scatter: Relative scatter of the force from stroke to stroke, one half width.
            depth_error_m: Uncertainty of the depth, one half width.
            force_limit_n: Greatest force of the arm; strokes above it are left out. None for any.

        Raises:
            NoAnswerError: If no soil is consistent, or there is nothing to choose from.
            InputError: If a number is out of its range.
        """
    def to_dict(self) -> dict[str, Any]:
        """The numbers as a dict."""
    def to_pandas(self) -> Any:
        """The boundary of the region as a pandas DataFrame: a row a corner, with the columns ``polygon``, ``ring``
        (0 is the
        outline, the others are holes), ``friction_angle_deg`` and ``density_kg_m3``.

        Raises:
            ImportError: If pandas is not installed.
        """
    def contains(self, friction_angle_deg: float, density_kg_m3: float) -> bool:
        """Whether a soil, whatever its interface friction, is consistent.

        Raises:
            InputError: If a number is not finite.
        """
    def __copy__(self) -> Estimate: ...
    def __deepcopy__(self, _memo: Any, /) -> Estimate: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...
    def _repr_html_(self) -> str: ...
    def _repr_svg_(self) -> str | None:
        """The region; x is the friction angle, y the density."""

def estimate(
    *,
    tool_angle_deg: ArrayLike,
    depth_m: ArrayLike,
    width_m: ArrayLike,
    force_n: ArrayLike,
    force_error_n: ArrayLike,
    interface_friction_deg: ArrayLike,
    surface_slope_deg: ArrayLike | None = None,
    density_kg_m3: ArrayLike | None = None,
    friction_search_deg: ArrayLike | None = None,
    model: str = "table",
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    ends: str | None = None,
    end_tolerance: float = 0.1,
) -> Estimate:
    """Every soil that could have produced measured failure forces.

    Measurements are arrays of shape (n,), or numbers that hold for all of them.

    Args:
        tool_angle_deg: Plate from the horizontal.
        depth_m: Vertical depth of the plate's lower edge.
        width_m: Width of the plate.
        force_n: Measured failure force.
        force_error_n: Half width of its interval.
        interface_friction_deg: Friction between soil and plate, known to lie between these two. Any sequence of two numbers,
            here and below.
        surface_slope_deg: Slope of the ground.
        density_kg_m3: Bulk density, known to lie between these two; None if nothing is known.
        friction_search_deg: Friction angles to search between; None for 5 to 60, as far as the model reaches.
        model: Force model, one of ``soilctl.MODELS``.
        cohesion_pa, adhesion_pa, surcharge_pa, gravity_m_s2: Known.
        ends: ``finite`` for plates with ends, each of its own width, ``none`` for plane strain. By default plates have ends if the
            model knows them.
        end_tolerance: By how much the end factor of a measurement may differ from one that all share, 0 to 1; 1 if they share
            nothing.

    Raises:
        InputError: If there is no measurement, a number is out of its range, or the model does not cover it.
    """

@final
class Sensed:
    """What the sensors report for one tick of 2 ms."""
    @property
    def tick(self) -> int:
        """Number of the tick, from 1."""
    @property
    def motor_counts(self) -> NDArray[np.int64]:
        """Counts of the motor encoders, shape (5,)."""
    @property
    def external_counts(self) -> NDArray[np.int64]:
        """Counts of the external encoders, in the motors' coordinates, shape (5,)."""
    @property
    def wrench(self) -> NDArray[np.float64]:
        """Force (N) and moment (N m) of the soil on the plate in the sensor's frame, bias included, shape (6,)."""
    @property
    def wrench_overload(self) -> bool:
        """Whether the force sensor reports an overload."""
    @property
    def amplifier_current_a(self) -> NDArray[np.float64]:
        """Currents that the amplifiers report in A, shape (5,)."""
    @property
    def amplifier_voltage_v(self) -> NDArray[np.float64]:
        """Supply voltages that the amplifiers report in V, shape (5,)."""

@final
class Plant:
    """The simulated digging arm with drives, sensors and, if a soil is named, a box of sand.

    One step is a tick of 2 ms. The same arguments and torques give the same bits on every machine.

    Args:
        soil: One of ``soilctl.SOILS``; without one there is neither sand nor box.
        joint_angles_deg: Where the arm starts, at rest, shape (5,).
        model: Force model of the sand, one of ``soilctl.MODELS``.
        surface_z_m: Height of the sand's surface in the base frame.
        seed: Of the noise of sensors and soil.
        file: Plant file; by default the arm of Hong (2001).

    Raises:
        InputError: If a name is unknown or a number out of its range.
        FileError: If the file cannot be read.
        NoAnswerError: If the joints cannot be there, or the model has no force for this soil.
    """
    def __new__(
        cls,
        soil: str | None = None,
        *,
        joint_angles_deg: ArrayLike | None = None,
        model: str = "chen",
        surface_z_m: float = -0.3302,
        seed: int = 1,
        file: _Path | None = None,
    ) -> Plant: ...
    def step(self, motor_torques_nm: ArrayLike, *, amplifiers_enabled: bool = True) -> Sensed:
        """Lets the motors act for one tick of 2 ms, then reads the sensors.

        Args:
            motor_torques_nm: Torques of the motors, shape (5,).
            amplifiers_enabled: If not, the torques count as zero.

        Raises:
            InputError: If a torque is not finite or beyond 1e4 N m. The plant is as it was before.
            SimulationError: If the arm left all bounds, or another thread is using the plant.
        """
    def run(self, controller: Any, *, ticks: int) -> Sensed:
        """Runs a controller for some ticks: each tick its ``step(sensed)`` gives the motor torques, shape (5,), in
        N m.

        A callable does instead of an object with ``step``. It gets the readings of the tick before: a plant that has none yet
        runs its first tick with amplifiers off, so that the controller is called once less than there are ticks. Two runs of 500
        ticks are thus the same as one of 1000.

        Returns:
            The last readings.

        Raises:
            InputError: If a torque is not finite; the message names the tick whose readings the controller had, the plant is as
                it was after that.
            SimulationError: If the arm left all bounds, or another thread is using the plant.
        """
    def prepare_soil(self) -> None:
        """Level sand again, with a density that scatters as the soil's does. To be called while the plate is out of
        it.

        Raises:
            InputError: If there is no soil.
            SimulationError: If another thread is using the plant.
        """
    @property
    def soil(self) -> dict[str, float] | None:
        """The sand: a dict of ``friction_angle_deg``, ``interface_friction_deg``, ``cohesion_pa``,
        ``density_kg_m3`` (of the
        present preparation) and ``gravity_m_s2``; None without sand.
        """
    @property
    def ticks(self) -> int:
        """Ticks run since the plant was made."""
    @property
    def truth(self) -> dict[str, Any]:
        """What no sensor tells, as of the last tick: a dict of true joint angles, tip, wrench and soil."""
    @property
    def energy_j(self) -> float:
        """Energy of links, rotors and stretch in J.

        Raises:
            SimulationError: If the arm is lost.
        """

def soil_names() -> list[str]:
    """Names of the soils that a plant can have."""
def _restore_arm(text: str | None) -> Arm:
    """An arm as `__reduce__` has taken it apart: from the text of a file."""
def _restore_bracket(
    summary: tuple[float, float, str, str, str, float, int],
    force_n: tuple[float, float] | None,
    elements: tuple[int, int],
    solutions: Sequence[tuple[str, Solution]],
) -> Bracket:
    """A bracket as `__reduce__` has taken it apart: lower, upper, quantity, unit, why it ended, seconds, work; and
    what else there is.
    """
def _restore_certificate(
    certified: bool,
    lower: tuple[float | None, float | None, str | None],
    upper: tuple[float | None, float | None, str | None],
) -> Certificate:
    """A certificate as `__reduce__` has taken it apart: what is claimed of each bound, what is proven, and why it
    is not.
    """
def _restore_prediction(
    named: tuple[str, str],
    coefficient: Any,
    ends: Any,
    interpolation_margin: Any,
    force_n: Any,
) -> Prediction:
    """A prediction as `__reduce__` has taken it apart."""
def _restore_sensed(tick: int, motors: Any, external: Any, wrench: Any, amplifiers: Any) -> Sensed:
    """Readings as `__reduce__` has taken them apart."""
def _restore_solution(path: _Path, origin_m: tuple[float, float]) -> Solution:
    """A saved solution with the origin that its file does not say."""
def log_info(path: _Path) -> dict[str, Any]:
    """What is in a log, or in a recording of any program (.mcap, .db3, .bag, or the folder of a bag): topics,
    times, strokes, problems.
    Ctrl-C ends the reading.

    Returns:
        A dict with ``topics`` (messages and type by name), ``start_ns``, ``end_ns``, ``steps``, ``missing_steps``,
        ``keyframes``, ``session``, ``strokes``, ``attachments``, ``problems`` and ``damage``. Of another program's recording
        ``problems`` are gaps, clocks and units; topics also have ``kind``, ``start_s``, ``end_s``, ``rate_hz``, ``gaps`` and
        ``longest_gaps``, and there are ``container``, ``compression``, ``clock_origin_s``, from which times in s count, and ``has_urdf``.

    Raises:
        FileError: If it cannot be read, or is no log.
    """
def log_recover(path: _Path, *, out: _Path) -> dict[str, Any]:
    """Copies what can be read of a damaged log into a new, whole one. After Ctrl-C there is no new one.

    Returns:
        A dict with ``messages`` and ``steps`` that were saved, and ``damage``, empty if nothing is lost.

    Raises:
        FileError: If nothing can be read, or the new file cannot be written.
        InputError: If both names are of the same file.
    """
def log_table(path: _Path, topic: str = "/controller/step") -> dict[str, Any]:
    """The messages of a topic as a table, a row a message.

    Args:
        path: The log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag).
        topic: ``/controller/step``, ``/joint_states``, ``/motor_states``, ``/wrench``, ``/truth/joint_states`` or
            ``/truth/soil``; of another program's recording any topic.

    Returns:
        A dict of columns by name, in order: first ``time_s``, the log time in s, then the fields of the message; elements of
        arrays have columns of their own (``motor_counts_0`` ...). Numbers and flags are arrays of shape (n,), texts lists.
        ``pandas.DataFrame`` takes it as it is. Of a damaged log, what can be read: ``log_info`` tells the damage. Times of another
        program's recording count from its ``clock_origin_s`` in ``log_info``, as those of ``process``; what a message does not have
        is NaN or an empty text.

    Raises:
        FileError: If it cannot be read, or is no log.
        InputError: If there is no such table.
        NoAnswerError: If the log has no message of the topic.
    """
def store_has(folder: _Path, key: str) -> bool:
    """Whether there is a sound result of a key."""
def store_key(name: str, version: str, cell: str) -> str:
    """The address of the result of a function of this name and version for a cell, given in canonical JSON."""
def store_note_failure(folder: _Path, name: str, version: str, cell: str, error: str) -> None:
    """Notes the error of a cell.

    Raises:
        FileError: If it cannot be written.
    """
def store_paths(folder: _Path, key: str) -> tuple[Path, Path]:
    """Where the result of a key is, and where its error is noted."""
def store_publish(folder: _Path, name: str, version: str, cell: str, result: str) -> None:
    """Stores the canonical JSON of a result.

    Raises:
        FileError: If it cannot be written.
    """
def store_read(folder: _Path, key: str) -> str:
    """The canonical JSON of the result of a key.

    Raises:
        FileError: If it is not there, or not what was written.
    """
def run_command(args: Sequence[str]) -> int:
    """Runs a command line, the program's name first, as the program `soilctl` does. The exit code."""
def answer_command(
    args: Sequence[str], progress: Callable[[int, int], object] | None = None
) -> tuple[int, str]:
    """Exit code and JSON of a command line, the program's name first; `progress` is called with the steps done and
    of all steps,
    from time to time and at the end.
    """
def run_use_case(
    name: str,
    request: str,
    progress: Callable[[int, int], object] | None = None,
    page: _Path | None = None,
) -> tuple[int, str]:
    """Runs a use case; `progress` is called with the steps done and of all steps, from time to time and at the end.

    Args:
        name: Its name, such as ``shear`` or ``log info``.
        request: A JSON object with the fields of its request; those that are left out have their defaults.
        progress: Called with the number of steps that are done and of all.
        page: Of ``process`` the HTML page to write. A diagnosis writes its page whatever is said here.

    Returns:
        The exit code of the command line, 0 done, 1 done and the answer is negative, 3 done in part; and the answer in JSON.
    """
def use_case_schemas() -> list[tuple[str, str, str, str]]:
    """Names, ids and JSON schemas of all use cases, from which typed functions are generated.

    Returns:
        Of each its name, the id of the schema of its answer, and the JSON schemas of request and answer.
    """
