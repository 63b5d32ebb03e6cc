"""Every use case as a function: its request as keyword arguments, its answer as an object with attributes.

Arguments and attributes have their units in their names. An answer can also be read as a mapping, ``answer["key"]``, with the keys of
the JSON answer of the command line.
"""

# Made by crates/py/generate from the schemas of the use cases.

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from ._progress import Progress
from ._record import Answer, Record
from ._run import run
from ._table import PathLike, Table

__all__ = [
    "ArmSkewingAnswer",
    "ArmSkewingRow",
    "ArmUrdfAnswer",
    "EstimateAnswer",
    "EstimateCentre",
    "EstimateContourSection",
    "EstimateCrossing",
    "EstimateDisagreement",
    "EstimateExact",
    "EstimateMeasured",
    "EstimateMinimum",
    "EstimateNextStroke",
    "EstimatePoint",
    "EstimateSection",
    "LogAnswer",
    "LogContent",
    "LogTopic",
    "LogWritten",
    "PredictAnswer",
    "PredictEnds",
    "PredictInputs",
    "PredictRange",
    "PredictSensitivity",
    "PredictStrokePrediction",
    "ReplayAnswer",
    "ReplayFirstDifference",
    "ShearAngleAt",
    "ShearAnswer",
    "ShearCarried",
    "ShearConstant",
    "ShearInputs",
    "ShearLoad",
    "ShearPoint",
    "ShearPowerLaw",
    "ShearRaw",
    "ShearRun",
    "ShearSlopeFloor",
    "ShearSoil",
    "ShearStroke",
    "ShearStrokePoint",
    "SimulateAnswer",
    "SimulateBatchReport",
    "arm_skewing",
    "arm_urdf",
    "estimate",
    "log_doctor",
    "log_export",
    "log_info",
    "log_recover",
    "predict",
    "replay",
    "shear",
    "simulate",
]


@dataclass(frozen=True, repr=False, eq=False)
class PredictEnds(Record):
    """Where the ends of a bracket come from.

    Attributes:
        lower: The lower end.
        upper: The upper end.
    """

    lower: str
    """The lower end."""
    upper: str
    """The upper end."""


@dataclass(frozen=True, repr=False, eq=False)
class PredictInputs(Record):
    """The inputs of a prediction.

    Attributes:
        adhesion_pa: Adhesion.
        alpha_deg: Tool angle; null if it comes from the strokes.
        beta_deg: Surface slope.
        cohesion_pa: Cohesion.
        delta_deg: Interface friction angle; null if it comes from the strokes.
        density_kg_m3: Bulk density; null if not given or if it comes from the strokes.
        depth_m: Vertical depth of the lower edge; null if not given or if it comes from the strokes.
        gravity_m_s2: Gravity.
        phi_deg: Friction angle of the soil.
        surcharge_pa: Surcharge.
        width_m: Width of the plate; null if not given or if it comes from the strokes.
    """

    adhesion_pa: float
    """Adhesion."""
    alpha_deg: float | None
    """Tool angle; null if it comes from the strokes."""
    beta_deg: float
    """Surface slope."""
    cohesion_pa: float
    """Cohesion."""
    delta_deg: float | None
    """Interface friction angle; null if it comes from the strokes."""
    density_kg_m3: float | None
    """Bulk density; null if not given or if it comes from the strokes."""
    depth_m: float | None
    """Vertical depth of the lower edge; null if not given or if it comes from the strokes."""
    gravity_m_s2: float
    """Gravity."""
    phi_deg: float
    """Friction angle of the soil."""
    surcharge_pa: float
    """Surcharge."""
    width_m: float | None
    """Width of the plate; null if not given or if it comes from the strokes."""


@dataclass(frozen=True, repr=False, eq=False)
class PredictRange(Record):
    """Angles for which a model answers, lowest and highest, in degrees. Interface friction is at most the friction
    of the soil as well.

    Attributes:
        alpha_deg: Tool angle.
        beta_deg: Surface slope.
        delta_deg: Interface friction angle.
        phi_deg: Friction angle of the soil.
    """

    alpha_deg: list[float]
    """Tool angle."""
    beta_deg: list[float]
    """Surface slope."""
    delta_deg: list[float]
    """Interface friction angle."""
    phi_deg: list[float]
    """Friction angle of the soil."""


@dataclass(frozen=True, repr=False, eq=False)
class PredictSensitivity(Record):
    """Sensitivity to each angle; null where the model has no answer a degree further.

    Attributes:
        alpha: To the tool angle.
        beta: To the surface slope.
        delta: To the interface friction angle.
        phi: To the friction angle of the soil.
    """

    alpha: float | None
    """To the tool angle."""
    beta: float | None
    """To the surface slope."""
    delta: float | None
    """To the interface friction angle."""
    phi: float | None
    """To the friction angle of the soil."""


@dataclass(frozen=True, repr=False, eq=False)
class PredictStrokePrediction(Record):
    """The prediction of one stroke.

    Attributes:
        alpha_deg: Tool angle.
        depth_m: Vertical depth of the lower edge.
        force_n: Predicted force; null without density.
        k_net: Net coefficient per slant length.
        line: Line in the file.
        measured_n: Measured force.
        ratio: Predicted over measured force; null without density.
        stroke_id: Name of the stroke.
    """

    alpha_deg: float
    """Tool angle."""
    depth_m: float
    """Vertical depth of the lower edge."""
    force_n: float | None
    """Predicted force; null without density."""
    k_net: float
    """Net coefficient per slant length."""
    line: int
    """Line in the file."""
    measured_n: float
    """Measured force."""
    ratio: float | None
    """Predicted over measured force; null without density."""
    stroke_id: str | None
    """Name of the stroke."""


@dataclass(frozen=True, repr=False, eq=False)
class PredictAnswer(Answer):
    """The answer of ``predict``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        force_n: Failure force in N with all loads; null without depth, width or density.
        inputs: What was asked.
        interpolation_margin: By how much, relatively, interpolation in a table may be wrong (the largest over the
            strokes); 0 for a formula or a solved cell.
        k_active: Active coefficient per slant length; null where a table has no split.
        k_net: Passive minus active, per slant length; for the bracket, the geometric mean of its ends.
        k_net_depth: The same per vertical depth, ``2 F / (gamma H^2 w)``.
        k_passive: Passive coefficient per slant length, ``2 F / (gamma L^2 w)``; null where a table has no split.
        model: Id of the model.
        notes: What to know about these numbers.
        reference: Where the model comes from.
        sensitivity_percent_per_deg: Change of ``k_net`` in per cent when one angle grows by 1 deg and the others
            stay; null with a stroke table.
        valid_range: Angles for which the model answers.
        k_net_lower: Lower end of the bracket on ``k_net``; only for the model ``table``.
        k_net_provenance: Where the ends of the bracket come from; only for the model ``table``.
        k_net_upper: Upper end of the bracket on ``k_net``; only for the model ``table``.
        strokes: One prediction a stroke; only with a stroke table.
    """

    schema: Literal["soilctl.predict/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    force_n: float | None
    """Failure force in N with all loads; null without depth, width or density."""
    inputs: PredictInputs
    """What was asked."""
    interpolation_margin: float
    """By how much, relatively, interpolation in a table may be wrong (the largest over the strokes); 0 for a
    formula or a solved cell.
    """
    k_active: float | None
    """Active coefficient per slant length; null where a table has no split."""
    k_net: float | None
    """Passive minus active, per slant length; for the bracket, the geometric mean of its ends."""
    k_net_depth: float | None
    """The same per vertical depth, ``2 F / (gamma H^2 w)``."""
    k_passive: float | None
    """Passive coefficient per slant length, ``2 F / (gamma L^2 w)``; null where a table has no split."""
    model: str
    """Id of the model."""
    notes: list[str]
    """What to know about these numbers."""
    reference: str
    """Where the model comes from."""
    sensitivity_percent_per_deg: PredictSensitivity | None
    """Change of ``k_net`` in per cent when one angle grows by 1 deg and the others stay; null with a stroke table.
    """
    valid_range: PredictRange
    """Angles for which the model answers."""
    k_net_lower: float | None = None
    """Lower end of the bracket on ``k_net``; only for the model ``table``."""
    k_net_provenance: PredictEnds | None = None
    """Where the ends of the bracket come from; only for the model ``table``."""
    k_net_upper: float | None = None
    """Upper end of the bracket on ``k_net``; only for the model ``table``."""
    strokes: list[PredictStrokePrediction] | None = None
    """One prediction a stroke; only with a stroke table."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateCentre(Record):
    """Centroid of the region and how far the region reaches from it.

    Attributes:
        density_half_width_kg_m3: Half width that covers the region (kg/m3).
        density_kg_m3: Bulk density (kg/m3).
        phi_deg: Friction angle (deg).
        phi_half_width_deg: Half width that covers the region (deg).
    """

    density_half_width_kg_m3: float
    """Half width that covers the region (kg/m3)."""
    density_kg_m3: float
    """Bulk density (kg/m3)."""
    phi_deg: float
    """Friction angle (deg)."""
    phi_half_width_deg: float
    """Half width that covers the region (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateContourSection(Record):
    """Contours at one delta.

    Attributes:
        contours: One polyline of [phi (deg), density (kg/m3)] a measurement.
        delta_deg: Interface friction (deg).
        ellipse_area: Its area (deg kg/m3).
        ellipse_centre: Centre [phi, density] of the smallest ellipse around the crossings.
        ellipse_semi_axes: Its semi-axes as vectors, the longer first.
        intersections: Where pairs of contours cross.
    """

    contours: list[list[list[float]]]
    """One polyline of [phi (deg), density (kg/m3)] a measurement."""
    delta_deg: float
    """Interface friction (deg)."""
    ellipse_area: float | None
    """Its area (deg kg/m3)."""
    ellipse_centre: list[float] | None
    """Centre [phi, density] of the smallest ellipse around the crossings."""
    ellipse_semi_axes: list[list[float]] | None
    """Its semi-axes as vectors, the longer first."""
    intersections: list[EstimateCrossing]
    """Where pairs of contours cross."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateCrossing(Record):
    """Two contours that cross.

    Attributes:
        density_kg_m3: Density (kg/m3).
        of: The two measurements.
        phi_deg: Friction angle (deg).
    """

    density_kg_m3: float
    """Density (kg/m3)."""
    of: list[str]
    """The two measurements."""
    phi_deg: float
    """Friction angle (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateDisagreement(Record):
    """What breaks consistency; names of measurements.

    Attributes:
        alone: Measurements that no soil explains even alone.
        culprits: Measurements without which all others agree.
        pairs: Pairs that no soil explains together.
        uncertainty_factor: Factor on all uncertainties at which the measurements just agree; null if 10 is not
            enough.
    """

    alone: list[str]
    """Measurements that no soil explains even alone."""
    culprits: list[str]
    """Measurements without which all others agree."""
    pairs: list[list[str]]
    """Pairs that no soil explains together."""
    uncertainty_factor: float | None
    """Factor on all uncertainties at which the measurements just agree; null if 10 is not enough."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateExact(Record):
    """Answer for exact data.

    Attributes:
        best: The delta with the smallest ellipse, within what is known of it; null if no contours cross.
        sections: Sections at chosen deltas.
    """

    best: EstimateContourSection | None
    """The delta with the smallest ellipse, within what is known of it; null if no contours cross."""
    sections: list[EstimateContourSection]
    """Sections at chosen deltas."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateMeasured(Record):
    """One measurement as the estimator saw it.

    Attributes:
        alpha_deg: Tool angle (deg).
        depth_m: Vertical depth (m).
        force_high_n: Upper end of its interval (N).
        force_low_n: Lower end of its interval (N).
        force_n: Failure force (N).
        label: Name.
        strokes: Strokes behind it.
    """

    alpha_deg: float
    """Tool angle (deg)."""
    depth_m: float
    """Vertical depth (m)."""
    force_high_n: float
    """Upper end of its interval (N)."""
    force_low_n: float
    """Lower end of its interval (N)."""
    force_n: float
    """Failure force (N)."""
    label: str
    """Name."""
    strokes: int
    """Strokes behind it."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateMinimum(Record):
    """Where a local optimiser started and ended.

    Attributes:
        end: End.
        inside: Whether the end lies in the consistent region.
        optimiser: ``downhill-simplex`` or ``levenberg-marquardt``.
        start: Start: phi (deg), density (kg/m3), delta (deg).
    """

    end: EstimatePoint
    """End."""
    inside: bool
    """Whether the end lies in the consistent region."""
    optimiser: str
    """``downhill-simplex`` or ``levenberg-marquardt``."""
    start: list[float]
    """Start: phi (deg), density (kg/m3), delta (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateNextStroke(Record):
    """A stroke that might be made next.

    Attributes:
        alpha_deg: Tool angle (deg).
        area_left: Expected area of the region after it, relative to now.
        density_width_kg_m3: Expected width of the density range after it (kg/m3).
        depth_m: Vertical depth (m).
        force_n: Force to expect at most (N).
        model: Model that predicts it.
        phi_width_deg: Expected width of the friction range after it (deg).
    """

    alpha_deg: float
    """Tool angle (deg)."""
    area_left: float
    """Expected area of the region after it, relative to now."""
    density_width_kg_m3: float
    """Expected width of the density range after it (kg/m3)."""
    depth_m: float
    """Vertical depth (m)."""
    force_n: float
    """Force to expect at most (N)."""
    model: str
    """Model that predicts it."""
    phi_width_deg: float
    """Expected width of the friction range after it (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimatePoint(Record):
    """A single soil.

    Attributes:
        delta_deg: Interface friction (deg).
        density_kg_m3: Bulk density (kg/m3).
        misfit: Sum of squared relative force errors (Hong 2001, eq. 7.1).
        phi_deg: Friction angle (deg).
    """

    delta_deg: float
    """Interface friction (deg)."""
    density_kg_m3: float
    """Bulk density (kg/m3)."""
    misfit: float
    """Sum of squared relative force errors (Hong 2001, eq. 7.1)."""
    phi_deg: float
    """Friction angle (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateSection(Record):
    """A section of the consistent set at one interface friction.

    Attributes:
        delta_deg: Interface friction (deg).
        polygons: Rings of [phi (deg), density (kg/m3)], by the even-odd rule; the first point is not repeated.
    """

    delta_deg: float
    """Interface friction (deg)."""
    polygons: list[list[list[float]]]
    """Rings of [phi (deg), density (kg/m3)], by the even-odd rule; the first point is not repeated."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateAnswer(Answer):
    """The answer of ``estimate``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        area_deg_kg_m3: Area of the region (deg kg/m3).
        best_estimate: Soil of least misfit inside the region.
        centre: Centroid of the region.
        consistent: Whether any soil explains all measurements.
        cut_by: Limits of the search that the region touches: it may reach further.
        delta_deg: What was known of delta (deg).
        delta_density: Consistent [delta, density], the same form; empty if delta is known exactly.
        density_kg_m3: Range of the density (kg/m3) over the whole interval of delta; null if inconsistent.
        density_known_kg_m3: What was known of the density (kg/m3).
        disagreement: What breaks consistency; null if nothing does.
        exact: Results for exact data; null unless ``--exact``.
        measurements: The measurements.
        model: Force model.
        next_strokes: Strokes that would shrink the region most, the best first; null if not asked for.
        optimisers: What local optimisers find; null if not asked for.
        phi_deg: Range of the friction angle (deg) over the whole interval of delta; null if inconsistent.
        phi_delta: Consistent [phi, delta], the same form; empty if delta is known exactly.
        region: Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi,
            density].
        regions: Sections at chosen deltas; empty if inconsistent.
        verdict: The result in words.
        volume_deg2_kg_m3: Volume of the consistent set (deg2 kg/m3).
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.estimate/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    area_deg_kg_m3: float
    """Area of the region (deg kg/m3)."""
    best_estimate: EstimatePoint | None
    """Soil of least misfit inside the region."""
    centre: EstimateCentre | None
    """Centroid of the region."""
    consistent: bool
    """Whether any soil explains all measurements."""
    cut_by: list[str]
    """Limits of the search that the region touches: it may reach further."""
    delta_deg: list[float]
    """What was known of delta (deg)."""
    delta_density: list[list[list[list[float]]]]
    """Consistent [delta, density], the same form; empty if delta is known exactly."""
    density_kg_m3: list[float] | None
    """Range of the density (kg/m3) over the whole interval of delta; null if inconsistent."""
    density_known_kg_m3: list[float] | None
    """What was known of the density (kg/m3)."""
    disagreement: EstimateDisagreement | None
    """What breaks consistency; null if nothing does."""
    exact: EstimateExact | None
    """Results for exact data; null unless ``--exact``."""
    measurements: list[EstimateMeasured]
    """The measurements."""
    model: str
    """Force model."""
    next_strokes: list[EstimateNextStroke] | None
    """Strokes that would shrink the region most, the best first; null if not asked for."""
    optimisers: list[EstimateMinimum] | None
    """What local optimisers find; null if not asked for."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg) over the whole interval of delta; null if inconsistent."""
    phi_delta: list[list[list[list[float]]]]
    """Consistent [phi, delta], the same form; empty if delta is known exactly."""
    region: list[list[list[list[float]]]]
    """Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi, density]."""
    regions: list[EstimateSection]
    """Sections at chosen deltas; empty if inconsistent."""
    verdict: str
    """The result in words."""
    volume_deg2_kg_m3: float
    """Volume of the consistent set (deg2 kg/m3)."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearAngleAt(Record):
    """The friction angle that a curve gives at a normal stress.

    Attributes:
        curve: ``power law`` or ``slope and floor``; ``constant angle`` if neither could be fitted.
        extrapolated: Whether the stress lies outside those that the curve was fitted to.
        friction_angle_deg: The angle there.
        normal_stress_pa: The normal stress asked for.
        standard_error_deg: Standard error of predicting one further test there from the scatter about the curve;
            null where there is no theory for it. Extrapolated, the true error is larger.
    """

    curve: str
    """``power law`` or ``slope and floor``; ``constant angle`` if neither could be fitted."""
    extrapolated: bool
    """Whether the stress lies outside those that the curve was fitted to."""
    friction_angle_deg: float
    """The angle there."""
    normal_stress_pa: float
    """The normal stress asked for."""
    standard_error_deg: float | None
    """Standard error of predicting one further test there from the scatter about the curve; null where there is no
    theory for it. Extrapolated, the true error is larger.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ShearCarried(Record):
    """The shift of the friction angle from a stress of the stroke to another one (Hong 2001, section 6.7.3).

    Attributes:
        curve: The curve: the one with a floor if it could be fitted, because a power law falls for ever.
        from_: ``sigma_L`` or ``sigma_U``.
        measured_extrapolated: Whether the stress of the stroke lies outside those of the curve.
        measured_stress_pa: Stress of the stroke.
        point_fraction: Depth of the point as a fraction of the plate's depth.
        shift_deg: To be added to the angle of the stroke.
        used_extrapolated: Whether the stress of use lies outside those of the curve.
        used_stress_pa: Stress at which the angle is to be used.
        warning: The same in words.
    """

    curve: str
    """The curve: the one with a floor if it could be fitted, because a power law falls for ever."""
    from_: str = field(metadata={"key": "from"})
    """``sigma_L`` or ``sigma_U``."""
    measured_extrapolated: bool
    """Whether the stress of the stroke lies outside those of the curve."""
    measured_stress_pa: float
    """Stress of the stroke."""
    point_fraction: float
    """Depth of the point as a fraction of the plate's depth."""
    shift_deg: float
    """To be added to the angle of the stroke."""
    used_extrapolated: bool
    """Whether the stress of use lies outside those of the curve."""
    used_stress_pa: float
    """Stress at which the angle is to be used."""
    warning: str
    """The same in words."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearConstant(Record):
    """One angle for every stress.

    Attributes:
        friction_angle_deg: The angle.
        points: Number of points fitted.
        rms_deg: Root mean square of the residuals.
        stress_range_pa: Lowest and highest fitted stress.
        worst_residual_deg: Residual of largest size, measured minus fitted.
    """

    friction_angle_deg: float
    """The angle."""
    points: int
    """Number of points fitted."""
    rms_deg: float
    """Root mean square of the residuals."""
    stress_range_pa: list[float]
    """Lowest and highest fitted stress."""
    worst_residual_deg: float
    """Residual of largest size, measured minus fitted."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearInputs(Record):
    """A stroke of a plate in a level, cohesionless soil.

    Attributes:
        alpha_deg: Tool angle.
        delta_deg: Interface friction angle.
        density_kg_m3: Bulk density.
        depth_m: Vertical depth of the lower edge.
        force_n: Failure force.
        gravity_m_s2: Gravity.
        phi_deg: Friction angle that the stresses were computed with; null if angle and stress were made consistent.
        width_m: Width of the plate.
    """

    alpha_deg: float
    """Tool angle."""
    delta_deg: float
    """Interface friction angle."""
    density_kg_m3: float
    """Bulk density."""
    depth_m: float
    """Vertical depth of the lower edge."""
    force_n: float
    """Failure force."""
    gravity_m_s2: float
    """Gravity."""
    phi_deg: float | None
    """Friction angle that the stresses were computed with; null if angle and stress were made consistent."""
    width_m: float
    """Width of the plate."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearLoad(Record):
    """The kept runs of one load.

    Attributes:
        dropped: Names of the dropped runs.
        friction_angle_deg: Mean peak friction angle of the kept runs.
        kept: Names of the kept runs.
        load_kg: Load.
        normal_stress_pa: Normal stress.
        spread_deg: Largest minus smallest kept angle.
        standard_deviation_deg: Standard deviation of the kept runs; null for one run.
    """

    dropped: list[str]
    """Names of the dropped runs."""
    friction_angle_deg: float
    """Mean peak friction angle of the kept runs."""
    kept: list[str]
    """Names of the kept runs."""
    load_kg: float
    """Load."""
    normal_stress_pa: float
    """Normal stress."""
    spread_deg: float
    """Largest minus smallest kept angle."""
    standard_deviation_deg: float | None
    """Standard deviation of the kept runs; null for one run."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearPoint(Record):
    """One test, or the mean of the tests at one load.

    Attributes:
        friction_angle_deg: Measured friction angle.
        normal_stress_pa: Normal stress.
        power_law_deg: Angle of the power law there, extrapolated or not; null without power law.
        slope_floor_deg: Angle of slope and floor there; null without them.
    """

    friction_angle_deg: float
    """Measured friction angle."""
    normal_stress_pa: float
    """Normal stress."""
    power_law_deg: float | None
    """Angle of the power law there, extrapolated or not; null without power law."""
    slope_floor_deg: float | None
    """Angle of slope and floor there; null without them."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearPowerLaw(Record):
    """``phi = a sigma^b`` with phi in degrees and sigma in psi.

    Attributes:
        a_deg_at_1_psi: Friction angle at 1 psi.
        b: Exponent.
        b_standard_error: Standard error of b; null with two loads.
        ln_a_standard_error: Standard error of ln a, which is the relative one of a; null with two loads.
        points: Number of points fitted.
        rms_deg: Root mean square of the residuals.
        stress_range_pa: Lowest and highest fitted stress.
        worst_residual_deg: Residual of largest size, measured minus fitted.
    """

    a_deg_at_1_psi: float
    """Friction angle at 1 psi."""
    b: float
    """Exponent."""
    b_standard_error: float | None
    """Standard error of b; null with two loads."""
    ln_a_standard_error: float | None
    """Standard error of ln a, which is the relative one of a; null with two loads."""
    points: int
    """Number of points fitted."""
    rms_deg: float
    """Root mean square of the residuals."""
    stress_range_pa: list[float]
    """Lowest and highest fitted stress."""
    worst_residual_deg: float
    """Residual of largest size, measured minus fitted."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearRaw(Record):
    """What raw records show.

    Attributes:
        bias_n: Reading of the load cell without load.
        box_area_m2: Area of the shear plane.
        box_gravity_m_s2: Gravity where the box stands.
        loads: One entry a load; they are the points of the soil.
        low_load_limit_pa: Forces below this normal stress were smoothed.
        machine_friction_n: Half the height of the friction loop; null without one.
        runs: One entry a run.
    """

    bias_n: float
    """Reading of the load cell without load."""
    box_area_m2: float
    """Area of the shear plane."""
    box_gravity_m_s2: float
    """Gravity where the box stands."""
    loads: list[ShearLoad]
    """One entry a load; they are the points of the soil."""
    low_load_limit_pa: float
    """Forces below this normal stress were smoothed."""
    machine_friction_n: float | None
    """Half the height of the friction loop; null without one."""
    runs: list[ShearRun]
    """One entry a run."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearRun(Record):
    """What one run shows.

    Attributes:
        dilation_angle_deg: Dilation angle at the peak, positive when the soil expands; null if it was not recorded.
        friction_angle_deg: Peak friction angle.
        load_kg: Load.
        loop_correction_deg: By how much machine friction would raise the peak angle; 0 without a friction loop.
        normal_stress_pa: Normal stress.
        peak_at_end: Whether the peak is the last reading.
        peak_displacement_m: Displacement at the peak.
        peak_vertical_m: Vertical movement up to the peak, upward positive; null if it was not recorded.
        run_id: Name of the run.
        smoothed: Whether the force was smoothed.
    """

    dilation_angle_deg: float | None
    """Dilation angle at the peak, positive when the soil expands; null if it was not recorded."""
    friction_angle_deg: float
    """Peak friction angle."""
    load_kg: float
    """Load."""
    loop_correction_deg: float
    """By how much machine friction would raise the peak angle; 0 without a friction loop."""
    normal_stress_pa: float
    """Normal stress."""
    peak_at_end: bool
    """Whether the peak is the last reading."""
    peak_displacement_m: float
    """Displacement at the peak."""
    peak_vertical_m: float | None
    """Vertical movement up to the peak, upward positive; null if it was not recorded."""
    run_id: str
    """Name of the run."""
    smoothed: bool
    """Whether the force was smoothed."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearSlopeFloor(Record):
    """``phi = floor + slope max(0, log10(floor stress / sigma))``.

    Attributes:
        floor_deg: Friction angle at and above the floor stress.
        floor_stress_pa: Stress above which the angle is constant.
        floor_stress_settled: Whether the tests settle the floor stress.
        points: Number of points fitted.
        rms_deg: Root mean square of the residuals.
        slope_deg_per_decade: Fall of the friction angle for each factor of ten in stress.
        stress_range_pa: Lowest and highest fitted stress.
        worst_residual_deg: Residual of largest size, measured minus fitted.
    """

    floor_deg: float
    """Friction angle at and above the floor stress."""
    floor_stress_pa: float
    """Stress above which the angle is constant."""
    floor_stress_settled: bool
    """Whether the tests settle the floor stress."""
    points: int
    """Number of points fitted."""
    rms_deg: float
    """Root mean square of the residuals."""
    slope_deg_per_decade: float
    """Fall of the friction angle for each factor of ten in stress."""
    stress_range_pa: list[float]
    """Lowest and highest fitted stress."""
    worst_residual_deg: float
    """Residual of largest size, measured minus fitted."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearSoil(Record):
    """The tests of one soil and the curves through them; a curve that cannot be fitted is null.

    Attributes:
        at: Angles at the stresses asked for, one entry a stress and curve.
        best: Which curve describes all loads best, in words; null if they are too few to compare.
        constant: One angle for all loads, for comparison.
        points: The tests, in increasing order of stress.
        power_law: ``phi = a sigma^b``, sigma in psi, through the loads below ``fit_limit_pa``.
        slope_floor: A fall with the logarithm of stress down to a floor, through all loads. With raw records a load
            counts as often as runs were kept, here and in the constant.
        soil: Name of the soil; null if it has none.
        stroke: Angles at the stresses of a plate's stroke; null if it was not asked for or no curve gives an
            answer.
    """

    at: list[ShearAngleAt]
    """Angles at the stresses asked for, one entry a stress and curve."""
    best: str | None
    """Which curve describes all loads best, in words; null if they are too few to compare."""
    constant: ShearConstant | None
    """One angle for all loads, for comparison."""
    points: list[ShearPoint]
    """The tests, in increasing order of stress."""
    power_law: ShearPowerLaw | None
    """``phi = a sigma^b``, sigma in psi, through the loads below ``fit_limit_pa``."""
    slope_floor: ShearSlopeFloor | None
    """A fall with the logarithm of stress down to a floor, through all loads. With raw records a load counts as
    often as runs were kept, here and in the constant.
    """
    soil: str | None
    """Name of the soil; null if it has none."""
    stroke: ShearStroke | None
    """Angles at the stresses of a plate's stroke; null if it was not asked for or no curve gives an answer."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearStroke(Record):
    """Friction angles at the normal stresses of a stroke (Hong 2001, section 6.6.1).

    Attributes:
        inputs: The stroke.
        points: One entry a point beside the plate and curve.
        carried: What happens to the angles at another stress; only with such a stress.
    """

    inputs: ShearInputs
    """The stroke."""
    points: list[ShearStrokePoint]
    """One entry a point beside the plate and curve."""
    carried: list[ShearCarried] | None = None
    """What happens to the angles at another stress; only with such a stress."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearStrokePoint(Record):
    """Stresses and angles at one point beside the plate.

    Attributes:
        curve: The curve that the angles are read from.
        friction_at_high_stress_deg: Friction angle at ``sigma_U``.
        friction_at_low_stress_deg: Friction angle at ``sigma_L``.
        high_extrapolated: Whether ``sigma_U`` lies outside the stresses of the curve.
        high_stress_pa: ``sigma_U``: normal stress on the failure surface beside the plate.
        iterations: Iterations until angle and stress agreed; 0 with a given angle.
        low_extrapolated: Whether ``sigma_L`` lies outside the stresses of the curve.
        low_stress_pa: ``sigma_L``: normal stress on the failure surface far from the plate.
        note: What to keep in mind with these numbers.
        plate_pressure_pa: Pressure of the plate at that depth, along the resultant.
        point_depth_m: Depth of the point.
        point_fraction: Depth of the point as a fraction of the plate's depth.
    """

    curve: str
    """The curve that the angles are read from."""
    friction_at_high_stress_deg: float
    """Friction angle at ``sigma_U``."""
    friction_at_low_stress_deg: float
    """Friction angle at ``sigma_L``."""
    high_extrapolated: bool
    """Whether ``sigma_U`` lies outside the stresses of the curve."""
    high_stress_pa: float
    """``sigma_U``: normal stress on the failure surface beside the plate."""
    iterations: int
    """Iterations until angle and stress agreed; 0 with a given angle."""
    low_extrapolated: bool
    """Whether ``sigma_L`` lies outside the stresses of the curve."""
    low_stress_pa: float
    """``sigma_L``: normal stress on the failure surface far from the plate."""
    note: str
    """What to keep in mind with these numbers."""
    plate_pressure_pa: float
    """Pressure of the plate at that depth, along the resultant."""
    point_depth_m: float
    """Depth of the point."""
    point_fraction: float
    """Depth of the point as a fraction of the plate's depth."""


@dataclass(frozen=True, repr=False, eq=False)
class ShearAnswer(Answer):
    """The answer of ``shear``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        fit_limit_pa: The power laws are fitted to the loads below this normal stress.
        soils: One entry a soil, in the order of the file.
        warnings: What to know about these numbers.
        raw: What the raw records show; only with raw records.
    """

    schema: Literal["soilctl.shear/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    fit_limit_pa: float
    """The power laws are fitted to the loads below this normal stress."""
    soils: list[ShearSoil]
    """One entry a soil, in the order of the file."""
    warnings: list[str]
    """What to know about these numbers."""
    raw: ShearRaw | None = None
    """What the raw records show; only with raw records."""


@dataclass(frozen=True, repr=False, eq=False)
class SimulateBatchReport(Record):
    """What a batch came to.

    Attributes:
        batch: Number of the batch, from 0.
        failures: Why strokes failed, in words.
        log: Name of its log in the folder.
        steps: Steps in the log.
        strokes: Strokes of the plan.
        strokes_done: Strokes that were made to their end.
    """

    batch: int
    """Number of the batch, from 0."""
    failures: list[str]
    """Why strokes failed, in words."""
    log: str
    """Name of its log in the folder."""
    steps: int
    """Steps in the log."""
    strokes: int
    """Strokes of the plan."""
    strokes_done: int
    """Strokes that were made to their end."""


@dataclass(frozen=True, repr=False, eq=False)
class SimulateAnswer(Answer):
    """The answer of ``simulate``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        batches: Finished batches in order.
        complete: Whether all batches of the plan are finished.
        out: The folder with the logs.
        resumed_batches: Batches that were finished by an earlier run.
        seed: Seed of noise and scatter.
        strokes: Strokes of the plan.
        strokes_done: Strokes that were made to their end.
    """

    schema: Literal["soilctl.simulate/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    batches: list[SimulateBatchReport]
    """Finished batches in order."""
    complete: bool
    """Whether all batches of the plan are finished."""
    out: str
    """The folder with the logs."""
    resumed_batches: int
    """Batches that were finished by an earlier run."""
    seed: int
    """Seed of noise and scatter."""
    strokes: int
    """Strokes of the plan."""
    strokes_done: int
    """Strokes that were made to their end."""


@dataclass(frozen=True, repr=False, eq=False)
class LogContent(Record):
    """What is in a log.

    Attributes:
        attachments: Names of the attachments.
        end_s: Log time of the last message in s.
        keyframes: Key frames, from which a replay can begin.
        missing_steps: Steps that are missing between them.
        session: What made the log, as the log says: version, seed, model.
        start_s: Log time of the first message in s; null if there is none.
        steps: Steps of the controller.
        strokes: Boundaries and settings of the strokes, as the log says.
        topics: Topics.
    """

    attachments: list[str]
    """Names of the attachments."""
    end_s: float | None
    """Log time of the last message in s."""
    keyframes: int
    """Key frames, from which a replay can begin."""
    missing_steps: int
    """Steps that are missing between them."""
    session: dict[str, str]
    """What made the log, as the log says: version, seed, model."""
    start_s: float | None
    """Log time of the first message in s; null if there is none."""
    steps: int
    """Steps of the controller."""
    strokes: list[dict[str, str]]
    """Boundaries and settings of the strokes, as the log says."""
    topics: list[LogTopic]
    """Topics."""


@dataclass(frozen=True, repr=False, eq=False)
class LogTopic(Record):
    """A topic.

    Attributes:
        messages: How many there are.
        topic: Its name.
        type: Type of its messages.
    """

    messages: int
    """How many there are."""
    topic: str
    """Its name."""
    type: str
    """Type of its messages."""


@dataclass(frozen=True, repr=False, eq=False)
class LogWritten(Record):
    """What was written.

    Attributes:
        columns: Columns of the table; null for ``recover``.
        file: The file.
        rows: Messages, or rows of the table.
        topic: The exported topic; null for ``recover``.
    """

    columns: int | None
    """Columns of the table; null for ``recover``."""
    file: str
    """The file."""
    rows: int
    """Messages, or rows of the table."""
    topic: str | None
    """The exported topic; null for ``recover``."""


@dataclass(frozen=True, repr=False, eq=False)
class LogAnswer(Answer):
    """The answer of ``log_info``, ``log_doctor``, ``log_recover``, ``log_export``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        action: ``info``, ``doctor``, ``recover`` or ``export``.
        content: What is in the log; of ``recover``, in the new one. Null for ``export``.
        damage: What is wrong with the file; empty if it is whole.
        problems: What is wrong with the content; only ``doctor`` fills it.
        whole: Whether the file is whole and its checksums hold.
        written: What was written; null for ``info`` and ``doctor``.
    """

    schema: Literal["soilctl.log/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    action: str
    """``info``, ``doctor``, ``recover`` or ``export``."""
    content: LogContent | None
    """What is in the log; of ``recover``, in the new one. Null for ``export``."""
    damage: list[str]
    """What is wrong with the file; empty if it is whole."""
    problems: list[str]
    """What is wrong with the content; only ``doctor`` fills it."""
    whole: bool
    """Whether the file is whole and its checksums hold."""
    written: LogWritten | None
    """What was written; null for ``info`` and ``doctor``."""


@dataclass(frozen=True, repr=False, eq=False)
class ReplayFirstDifference(Record):
    """An output that is not what the log says.

    Attributes:
        field: Field of the message on /controller/step, or ``state`` for a key frame.
        logged: What the log says, as text, since it may be NaN.
        replayed: What the replay gave.
        step: Number of the step, from 0.
        tick: The tick that it answered.
    """

    field: str
    """Field of the message on /controller/step, or ``state`` for a key frame."""
    logged: str
    """What the log says, as text, since it may be NaN."""
    replayed: str
    """What the replay gave."""
    step: int
    """Number of the step, from 0."""
    tick: int
    """The tick that it answered."""


@dataclass(frozen=True, repr=False, eq=False)
class ReplayAnswer(Answer):
    """The answer of ``replay``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        damage: What is wrong with the file; empty if it is whole.
        different_steps: Steps with an output of other bits.
        first_difference: The first output that differs; null if none does.
        identical: Whether every bit of every output and of every key frame is the same.
        keyframes: Key frames that were compared with the state of the replay.
        skipped_steps: Steps of the log that could not be run again, because steps before them are missing.
        steps: Steps that were run again and compared.
    """

    schema: Literal["soilctl.replay/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    damage: list[str]
    """What is wrong with the file; empty if it is whole."""
    different_steps: int
    """Steps with an output of other bits."""
    first_difference: ReplayFirstDifference | None
    """The first output that differs; null if none does."""
    identical: bool
    """Whether every bit of every output and of every key frame is the same."""
    keyframes: int
    """Key frames that were compared with the state of the replay."""
    skipped_steps: int
    """Steps of the log that could not be run again, because steps before them are missing."""
    steps: int
    """Steps that were run again and compared."""


@dataclass(frozen=True, repr=False, eq=False)
class ArmSkewingRow(Record):
    """One error of the tip.

    Attributes:
        error_deg: Direction of the error in degrees: 0 outwards, 90 up.
        pid_deg: From the error to the force under the joint PID, positive from outwards to upwards, in degrees.
        radius_m: Radius of the tip in m.
        stiffness_deg: The same under Cartesian stiffness.
    """

    error_deg: float
    """Direction of the error in degrees: 0 outwards, 90 up."""
    pid_deg: float
    """From the error to the force under the joint PID, positive from outwards to upwards, in degrees."""
    radius_m: float
    """Radius of the tip in m."""
    stiffness_deg: float
    """The same under Cartesian stiffness."""


@dataclass(frozen=True, repr=False, eq=False)
class ArmSkewingAnswer(Answer):
    """The answer of ``arm_skewing``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        alpha_deg: Tool angle in degrees.
        height_m: Height of the tip over the base in m.
        rows: One row a radius and direction.
        worst_pid_deg: Largest angle between force and error under the joint PID in degrees.
        worst_stiffness_deg: The same under Cartesian stiffness.
    """

    schema: Literal["soilctl.arm-skewing/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    alpha_deg: float
    """Tool angle in degrees."""
    height_m: float
    """Height of the tip over the base in m."""
    rows: list[ArmSkewingRow]
    """One row a radius and direction."""
    worst_pid_deg: float
    """Largest angle between force and error under the joint PID in degrees."""
    worst_stiffness_deg: float
    """The same under Cartesian stiffness."""


@dataclass(frozen=True, repr=False, eq=False)
class ArmUrdfAnswer(Answer):
    """The answer of ``arm_urdf``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        urdf: The URDF document.
    """

    schema: Literal["soilctl.arm-urdf/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    urdf: str
    """The URDF document."""


def predict(
    *,
    model: str = "chen",
    model_table: PathLike | None = None,
    alpha_deg: float | None = None,
    model_file: PathLike | None = None,
    phi_deg: float | None = None,
    delta_deg: Literal["column"] | float | None = None,
    density_kg_m3: Literal["column"] | float | None = None,
    depth_m: float | None = None,
    width_m: float | None = None,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    strokes: Table | None = None,
    progress: Progress = None,
) -> PredictAnswer:
    """Force and coefficients of a plate from a named model.

    Args:
        model: Model: coulomb, log-spiral, log-spiral-thesis, caquot, chen, thesis-ub, thesis-lb, table.
        model_table: A table file (.csv or .parquet) as the model.
        alpha_deg: Tool angle from the horizontal (deg).
        model_file: A model file, such as the patch of ``diagnose``: force model, soil and effects; ``phi_deg``,
            ``delta_deg`` and ``density_kg_m3`` replace its values.
        phi_deg: Internal friction angle of the soil (deg).
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for delta_set_deg of ``strokes``.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of ``strokes``.
        depth_m: Vertical depth of the plate's lower edge below the surface (m).
        width_m: Width of the plate (m).
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        strokes: A stroke table: one prediction a row, with alpha, depth and width from the file.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("predict", predict, locals(), PredictAnswer, tables=("strokes",))


def estimate(
    file: Table,
    delta_deg: Literal["column"] | float,
    *,
    model: str = "table",
    model_file: PathLike | None = None,
    delta_tol_deg: float = 1.0,
    density_kg_m3: Literal["column"] | float | None = None,
    density_tol: float = 0.04,
    sigma: float | None = None,
    uncertainty: Literal["sigma", "bounds"] = "sigma",
    adjust_high_angles: float = 0.0,
    phi_range_deg: Sequence[Any] | None = None,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    sections_deg: Sequence[float] = (),
    next_strokes: bool = False,
    next_alpha_deg: Sequence[float] = (40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 110.0),
    next_depth_m: Sequence[float] = (),
    force_limit_n: float | None = None,
    exact: bool = False,
    compare: bool = False,
    progress: Progress = None,
) -> EstimateAnswer:
    """Every soil that could have produced the measured forces.

    Args:
        file: Stroke table (CSV).
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for delta_set_deg of the table.
        model: Model: table (the bracket of bounds), thesis-ub, thesis-lb, chen, caquot, log-spiral,
            log-spiral-thesis, coulomb.
        model_file: A model file, such as the patch of ``diagnose``: its effects are taken out of the measured
            forces first, at the soil of the file.
        delta_tol_deg: Half width of what is known of delta (deg). At least 0.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of the table; left out: unknown.
        density_tol: Relative half width of what is known of the density. At least 0 and below 1.
        sigma: Standard deviations that a band reaches on either side of the force. Above 0.
        uncertainty: What the uncertainty of a force means.
        adjust_high_angles: Allow that forces at tool angles of 90 deg and more were read low by up to this
            fraction, because friction was not fully mobilised when failure was read (0.1 in Hong 2001, section
            7.5.1). At least 0.
        phi_range_deg: Friction angles to search (deg), LOW:HIGH.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        sections_deg: Values of delta at which sections are shown (deg); default: the ends and the middle.
        next_strokes: Rank the next strokes by how much they would shrink the region.
        next_alpha_deg: Tool angles to consider for the next stroke (deg).
        next_depth_m: Depths to consider for the next stroke (m); default: the depths of the table.
        force_limit_n: Greatest force the arm can exert (N); dearer strokes are left out.
        exact: Take the forces as exact: contour lines instead of bands.
        compare: Also run what one would otherwise use, downhill simplex and Levenberg-Marquardt from many starts.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("estimate", estimate, locals(), EstimateAnswer, tables=("file",))


def shear(
    *,
    file: Table | None = None,
    soil: Sequence[str] = (),
    fit_limit_pa: float | None = None,
    stress_pa: Sequence[float] = (),
    raw: PathLike | None = None,
    friction_loop: PathLike | None = None,
    soil_name: str | None = None,
    box_area_m2: float = 0.00356,
    box_gravity_m_s2: float = 9.80665,
    bias_n: float = 0.0,
    low_load_limit_pa: float | None = None,
    keep: int = 3,
    alpha_deg: float | None = None,
    depth_m: float | None = None,
    width_m: float | None = None,
    density_kg_m3: float | None = None,
    gravity_m_s2: float = 9.80665,
    delta_deg: float | None = None,
    force_n: float | None = None,
    phi_deg: float | None = None,
    point_fraction: Sequence[float] = (0.5, 0.6667),
    carry_to_pa: float | None = None,
    progress: Progress = None,
) -> ShearAnswer:
    """The friction angle of direct-shear tests against normal stress.

    Args:
        file: Table of friction angles against normal stress.
        soil: Only this soil of FILE.
        fit_limit_pa: The power law is fitted to the loads below this normal stress (Pa); 2.5 psi = 17237 Pa if not
            given. Above 0.
        stress_pa: Gives the friction angle at this normal stress (Pa).
        raw: Raw records instead of FILE: run_id, load_kg, displacement_mm, shear_force_n, vertical_mm (optional).
        friction_loop: Record of the empty box in both directions: displacement_mm, shear_force_n, direction.
        soil_name: Name of the soil in the raw records.
        box_area_m2: Area of the shear plane (m2).
        box_gravity_m_s2: Gravity where the box stands (m/s2).
        bias_n: Reading of the load cell without load (N), subtracted from every shear force.
        low_load_limit_pa: Forces are smoothed below this normal stress (Pa); 2.5 psi = 17237 Pa if not given.
        keep: Of more runs than this at a load, the closest ones are kept. At least 0.
        alpha_deg: Tool angle from the horizontal (deg); ``alpha_deg``, ``depth_m``, ``width_m``, ``density_kg_m3``,
            ``delta_deg`` and ``force_n`` go together.
        depth_m: Vertical depth of the plate's lower edge below the surface (m).
        width_m: Width of the plate (m).
        density_kg_m3: Bulk density (kg/m3).
        gravity_m_s2: Gravity at the stroke (m/s2).
        delta_deg: Friction angle between soil and plate (deg).
        force_n: Failure force of the stroke (N).
        phi_deg: Friction angle to compute the stresses with (deg); if not given, angle and stress are made
            consistent.
        point_fraction: Depth of the point considered as a fraction of the plate's depth.
        carry_to_pa: Warns of the shift when the friction angle of the stroke is used at this normal stress (Pa).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("shear", shear, locals(), ShearAnswer, tables=("file",))


def simulate(
    file: PathLike,
    out: PathLike,
    *,
    seed: int | None = None,
    threads: int | None = None,
    model_file: PathLike | None = None,
    progress: Progress = None,
) -> SimulateAnswer:
    """Runs a campaign on the simulated arm and soil, a log for each batch.

    Args:
        file: A campaign plan (.toml).
        out: Folder for the logs; made if it is not there.
        seed: Seed of noise and scatter. At least 0.
        threads: Batches that run at a time; results are the same for any number. At least 1 and at most 1024.
        model_file: Model file whose soil, force model and effects replace those of the plan.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("simulate", simulate, locals(), SimulateAnswer)


def log_info(
    log: PathLike,
    *,
    progress: Progress = None,
) -> LogAnswer:
    """Says what is in a log.

    Args:
        log: A log (.mcap).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("log info", log_info, locals(), LogAnswer)


def log_doctor(
    log: PathLike,
    *,
    progress: Progress = None,
) -> LogAnswer:
    """Checks a log: whole, checksums, types, quality of service, missing steps, key frames.

    Args:
        log: A log (.mcap).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("log doctor", log_doctor, locals(), LogAnswer)


def log_recover(
    log: PathLike,
    out: PathLike,
    *,
    progress: Progress = None,
) -> LogAnswer:
    """Copies what can be read of a damaged log into a new, whole one.

    Args:
        log: The damaged log (.mcap).
        out: File to write (.mcap).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("log recover", log_recover, locals(), LogAnswer)


def log_export(
    log: PathLike,
    out: PathLike,
    *,
    topic: str = "/controller/step",
    progress: Progress = None,
) -> LogAnswer:
    """Writes the messages of a topic as a table, one row a message.

    Args:
        log: A log (.mcap).
        out: File to write (.csv or .parquet).
        topic: The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or
            /truth/soil.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("log export", log_export, locals(), LogAnswer)


def replay(
    log: PathLike,
    *,
    from_keyframe: int = 0,
    progress: Progress = None,
) -> ReplayAnswer:
    """Runs the controller again on a log's inputs and compares every output bit.

    Args:
        log: A log (.mcap).
        from_keyframe: Begin at the key frame of this number; 0 is the beginning, there is one every 500 steps. At
            least 0.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("replay", replay, locals(), ReplayAnswer)


def arm_skewing(
    *,
    arm: PathLike | None = None,
    controller: PathLike | None = None,
    radius_m: Sequence[float] = (0.2032, 0.3048, 0.4318),
    height_m: float = -0.3175,
    alpha_deg: float = 90.0,
    progress: Progress = None,
) -> ArmSkewingAnswer:
    """Directions of the tip's force against the errors that it answers.

    Args:
        arm: Arm file (.toml).
        controller: Settings of the controller (.toml).
        radius_m: Radii of the tip (m); 8, 12 and 17 in if not given.
        height_m: Height of the tip over the base (m).
        alpha_deg: Tool angle (deg).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("arm skewing", arm_skewing, locals(), ArmSkewingAnswer)


def arm_urdf(
    *,
    arm: PathLike | None = None,
    progress: Progress = None,
) -> ArmUrdfAnswer:
    """The arm as a URDF.

    Args:
        arm: Arm file (.toml).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("arm urdf", arm_urdf, locals(), ArmUrdfAnswer)
