"""Every use case as a function: its request as keyword arguments, its answer as an object with attributes.

Arguments and attributes have their units in their names. An answer can also be read as a mapping, ``answer["key"]``, with the keys of
the JSON answer of the command line.
"""

# Made by crates/py/generate from the schemas of the use cases.

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypedDict

from ._progress import Progress
from ._record import Answer, Record
from ._run import run
from ._table import PathLike, Table

__all__ = [
    "AheadAlarm",
    "AheadAnswer",
    "AheadLook",
    "AheadPlace",
    "AheadRegion",
    "AheadStroke",
    "ArmSkewingAnswer",
    "ArmSkewingRow",
    "ArmUrdfAnswer",
    "BoundAnswer",
    "BoundBending",
    "BoundContact",
    "BoundEnd",
    "BoundInputs",
    "BoundLevel",
    "BoundMember",
    "BoundResults",
    "BoundSolve",
    "BoundStretch",
    "BoundWidth",
    "CertifyAnswer",
    "CertifyChecked",
    "CertifySaid",
    "ClimbAnswer",
    "ClimbTrial",
    "ConvertAnswer",
    "ConvertLeftOut",
    "ConvertSoil",
    "DemoAnswer",
    "DemoDelta",
    "DemoEachStroke",
    "DemoFiles",
    "DemoForces",
    "DemoRegion",
    "DemoStrokeCount",
    "DemoTruth",
    "DesignAnswer",
    "DesignTried",
    "DiagnoseAnswer",
    "DiagnoseChannelGap",
    "DiagnoseEffect",
    "DiagnoseGap",
    "DiagnoseNearest",
    "DiagnoseNext",
    "DiagnoseParameter",
    "DiagnoseSelfTestAnswer",
    "DiagnoseSelfTestLogsAnswer",
    "DiagnoseSelfTestLogsEntry",
    "DiagnoseSelfTestLogsPart",
    "DiagnoseSelfTestLogsRate",
    "DiagnoseSelfTestLogsSaid",
    "DiagnoseSelfTestRate",
    "DiagnoseSignal",
    "DiagnoseTerm",
    "DiagnoseTestability",
    "DiagnoseWhere",
    "DoctorAnswer",
    "DoctorCheck",
    "EstimateAnswer",
    "EstimateCentre",
    "EstimateContourSection",
    "EstimateCost",
    "EstimateCrossing",
    "EstimateDisagreement",
    "EstimateExact",
    "EstimateLaw",
    "EstimateLawRange",
    "EstimateLawSlice",
    "EstimateLeftOut",
    "EstimateMeasured",
    "EstimateMinimum",
    "EstimateNextStroke",
    "EstimatePair",
    "EstimatePlaneStrain",
    "EstimatePoint",
    "EstimatePooled",
    "EstimateSection",
    "EstimateShearTest",
    "EstimateUnknown",
    "EstimateUnknowns",
    "ExcavateAngleRow",
    "ExcavateAnswer",
    "ExcavateDugRow",
    "ExcavateDugTrench",
    "ExcavateForceRow",
    "ExcavatePassRow",
    "HeightsAnswer",
    "HeightsBreak",
    "HeightsMap",
    "HeightsPicture",
    "HeightsPlate",
    "HeightsProfile",
    "HeightsShift",
    "HeightsVolume",
    "LogAnswer",
    "LogContent",
    "LogFound",
    "LogGap",
    "LogTopic",
    "LogWritten",
    "ObstacleAnswer",
    "ObstacleDistance",
    "ObstaclePiece",
    "ObstacleTool",
    "PlacesAnswer",
    "PlacesBetween",
    "PlacesCell",
    "PlacesCovariance",
    "PlacesGroup",
    "PlacesPair",
    "PlacesPlaceFound",
    "PredictAnswer",
    "PredictBracketEnds",
    "PredictInputs",
    "PredictLawPrediction",
    "PredictRange",
    "PredictSensitivity",
    "PredictStrokePrediction",
    "ProcessAnalysis",
    "ProcessAnswer",
    "ProcessArguments",
    "ProcessComparison",
    "ProcessContact",
    "ProcessEffect",
    "ProcessFound",
    "ProcessFreeAir",
    "ProcessFriction",
    "ProcessGroup",
    "ProcessLaw",
    "ProcessLift",
    "ProcessLogOutcome",
    "ProcessNoise",
    "ProcessRubbing",
    "ProcessScan",
    "ProcessSkipped",
    "ProcessStrokeRecord",
    "ProfileAlias",
    "ProfileAnswer",
    "ProfileHypothesis",
    "ProfileLevel",
    "ProfileNextDepth",
    "ProfilePredicted",
    "ProfileRanges",
    "ProfileStepSlice",
    "ProfileStroke",
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
    "SoilsAnswer",
    "SoilsSoil",
    "Solve",
    "SolveAnswer",
    "SolveBending",
    "SolveCase",
    "SolveCheckAnswer",
    "SolveCheckCheckedBoundary",
    "SolveCheckCheckedCase",
    "SolveCheckCheckedMember",
    "SolveCheckCheckedRegion",
    "SolveCheckHead",
    "SolveCheckSeepage",
    "SolveContact",
    "SolveHead",
    "SolveLevel",
    "SolveMember",
    "SolveResults",
    "SolveSeepage",
    "SolveStretch",
    "SolveTrial",
    "StabilityAnswer",
    "StabilitySlope",
    "StabilityTrial",
    "SurfaceAnswer",
    "SurfaceByForce",
    "SurfaceSaid",
    "SurfaceStroke",
    "TableAnswer",
    "TableBracketCell",
    "TableBracketFindings",
    "TableBuiltBounds",
    "TableCell",
    "TableContradiction",
    "TableEmptyNode",
    "TableGaps",
    "TableHead",
    "TablePlan",
    "TableViolation",
    "Tool",
    "ToolAnswer",
    "ToolBending",
    "ToolContact",
    "ToolDirection",
    "ToolEnds",
    "ToolForces",
    "ToolFront",
    "ToolLevel",
    "ToolMember",
    "ToolPiece",
    "ToolResults",
    "ToolRow",
    "ToolSolve",
    "ToolStretch",
    "ToolTable",
    "ahead",
    "arm_skewing",
    "arm_urdf",
    "bound",
    "certify",
    "climb",
    "convert",
    "demo",
    "design",
    "diagnose",
    "diagnose_self_test",
    "diagnose_self_test_logs",
    "doctor",
    "estimate",
    "excavate",
    "heights",
    "log_doctor",
    "log_export",
    "log_info",
    "log_recover",
    "obstacle",
    "places",
    "predict",
    "process",
    "profile",
    "replay",
    "shear",
    "simulate",
    "soils",
    "solve",
    "solve_check",
    "stability",
    "surface",
    "table_build",
    "table_check",
    "table_merge",
    "table_show",
    "tool",
]


@dataclass(frozen=True, repr=False, eq=False)
class PredictBracketEnds(Record):
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
class PredictLawPrediction(Record):
    """What a law of stress leaves open: ranges over its slopes, over what is known of the stress where the soil
    slips, and over the bracket of the model if it has one.

    Attributes:
        force_n: Failure force (N).
        phi_deg: Friction angle (deg) there; the coefficients, the force and the sensitivity of this answer are
            those of its middle.
        reference_stress_pa: Normal stress (Pa) at which the friction angle is the one of the inputs.
        slip_stress_pa: Normal stress (Pa) where the soil slips.
        slope_deg_per_decade: Slopes of the law (deg a decade).
    """

    force_n: list[float]
    """Failure force (N)."""
    phi_deg: list[float]
    """Friction angle (deg) there; the coefficients, the force and the sensitivity of this answer are those of its
    middle.
    """
    reference_stress_pa: float
    """Normal stress (Pa) at which the friction angle is the one of the inputs."""
    slip_stress_pa: list[float]
    """Normal stress (Pa) where the soil slips."""
    slope_deg_per_decade: list[float]
    """Slopes of the law (deg a decade)."""


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
        ends: Whether the plate has ends.
        force_n: Failure force in N with all loads; null without depth, width or density.
        friction_law: What a law of stress makes of it; null without one.
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
        width_ratio: Width over vertical depth; null in plane strain and where it comes from the strokes.
        k_net_lower: Lower end of the bracket on ``k_net``; only for the model ``table``.
        k_net_provenance: Where the ends of the bracket come from; only for the model ``table``.
        k_net_upper: Upper end of the bracket on ``k_net``; only for the model ``table``.
        strokes: One prediction a stroke; only with a stroke table.
    """

    schema: Literal["soilctl.predict/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    ends: Literal["finite", "none"]
    """Whether the plate has ends."""
    force_n: float | None
    """Failure force in N with all loads; null without depth, width or density."""
    friction_law: PredictLawPrediction | None
    """What a law of stress makes of it; null without one."""
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
    width_ratio: float | None
    """Width over vertical depth; null in plane strain and where it comes from the strokes."""
    k_net_lower: float | None = None
    """Lower end of the bracket on ``k_net``; only for the model ``table``."""
    k_net_provenance: PredictBracketEnds | None = None
    """Where the ends of the bracket come from; only for the model ``table``."""
    k_net_upper: float | None = None
    """Upper end of the bracket on ``k_net``; only for the model ``table``."""
    strokes: list[PredictStrokePrediction] | None = None
    """One prediction a stroke; only with a stroke table."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundBending(Record):
    """How a beam bends.

    Attributes:
        greatest_moment: The moment that is farthest from zero in the field of the lower bound, positive where it
            stretches the beam's right side.
        greatest_moment_at: Distance of that from its start.
        greatest_shear: The shear force that is farthest from zero, per unit width.
        hinges: Where it yields in the flow of the upper bound: distances from its start, and how fast it turns
            there, over the speed that others are compared with (1/length).
        moment: The moment along it: distances from its start, and the moment there.
        moment_strength: Greatest bending moment that it bears, per unit width (force).
        shear: The shear force along it, likewise.
        shear_strength: Greatest shear force that it bears, per unit width.
    """

    greatest_moment: float | None
    """The moment that is farthest from zero in the field of the lower bound, positive where it stretches the beam's
    right side.
    """
    greatest_moment_at: float | None
    """Distance of that from its start."""
    greatest_shear: float | None
    """The shear force that is farthest from zero, per unit width."""
    hinges: list[list[float]]
    """Where it yields in the flow of the upper bound: distances from its start, and how fast it turns there, over
    the speed that others are compared with (1/length).
    """
    moment: list[list[float]]
    """The moment along it: distances from its start, and the moment there."""
    moment_strength: float
    """Greatest bending moment that it bears, per unit width (force)."""
    shear: list[list[float]]
    """The shear force along it, likewise."""
    shear_strength: float
    """Greatest shear force that it bears, per unit width."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundContact(Record):
    """Contact stresses along a face.

    Attributes:
        centre: Distance of the pressure's resultant from the upper end, along the face; null if there is none.
        face: ``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried
            structure; numbered if there are several.
        greatest_pressure: Greatest pressure.
        length: Length of the face.
        normal_force: Resultant of the pressure, per unit width.
        shear_force: Resultant of the shear stress on the soil, per unit width; positive downwards along the face,
            from its upper end.
    """

    centre: float | None
    """Distance of the pressure's resultant from the upper end, along the face; null if there is none."""
    face: str
    """``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried structure;
    numbered if there are several.
    """
    greatest_pressure: float
    """Greatest pressure."""
    length: float
    """Length of the face."""
    normal_force: float
    """Resultant of the pressure, per unit width."""
    shear_force: float
    """Resultant of the shear stress on the soil, per unit width; positive downwards along the face, from its upper
    end.
    """


@dataclass(frozen=True, repr=False, eq=False)
class BoundEnd(Record):
    """What became of the stress field in space about the ends of a plate.

    Attributes:
        lower: Lower bound on the net coefficient that it proves for the width asked for; null if there is none.
        seconds: Time spent on it in s, also if there is none.
        tetrahedra: Tetrahedra of the field about one end; 0 if there is none.
        why_none: Why there is none, in words; null if there is one.
    """

    lower: float | None
    """Lower bound on the net coefficient that it proves for the width asked for; null if there is none."""
    seconds: float
    """Time spent on it in s, also if there is none."""
    tetrahedra: int
    """Tetrahedra of the field about one end; 0 if there is none."""
    why_none: str | None
    """Why there is none, in words; null if there is one."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundInputs(Record):
    """The inputs.

    Attributes:
        adhesion_pa: Adhesion.
        alpha_deg: Tool angle.
        beta_deg: Surface slope.
        cohesion_pa: Cohesion.
        delta_deg: Interface friction angle.
        density_kg_m3: Bulk density; null if not given.
        depth_m: Vertical depth of the lower edge; null if not given.
        friction_law: How much it falls a decade of normal stress (deg); null if it is the same at all stresses.
        gravity_m_s2: Gravity.
        phi_deg: Friction angle of the soil.
        reference_stress_pa: Normal stress at which it is ``phi_deg`` (Pa); null likewise.
        surcharge_pa: Surcharge.
        width_m: Width of the plate; null if not given.
    """

    adhesion_pa: float
    """Adhesion."""
    alpha_deg: float
    """Tool angle."""
    beta_deg: float
    """Surface slope."""
    cohesion_pa: float
    """Cohesion."""
    delta_deg: float
    """Interface friction angle."""
    density_kg_m3: float | None
    """Bulk density; null if not given."""
    depth_m: float | None
    """Vertical depth of the lower edge; null if not given."""
    friction_law: float | None
    """How much it falls a decade of normal stress (deg); null if it is the same at all stresses."""
    gravity_m_s2: float
    """Gravity."""
    phi_deg: float
    """Friction angle of the soil."""
    reference_stress_pa: float | None
    """Normal stress at which it is ``phi_deg`` (Pa); null likewise."""
    surcharge_pa: float
    """Surcharge."""
    width_m: float | None
    """Width of the plate; null if not given."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundLevel(Record):
    """One level of meshes.

    Attributes:
        identity_error: Gap of the two programs less the sum of its shares over all elements, relative to the upper
            bound; null without both bounds.
        lower: The lower bound on this level's mesh or one before; null if none was solved.
        upper: The upper bound on this level's mesh.
    """

    identity_error: float | None
    """Gap of the two programs less the sum of its shares over all elements, relative to the upper bound; null
    without both bounds.
    """
    lower: BoundSolve | None
    """The lower bound on this level's mesh or one before; null if none was solved."""
    upper: BoundSolve
    """The upper bound on this level's mesh."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundMember(Record):
    """A bar, a sheet or a beam. Forces are per unit width, tension positive; for a factor of safety those of soil
    whose strength is divided by its lower bound.

    Attributes:
        axial_force: The axial force along it: distances from its start, and the force there.
        bending: How a beam bends; null for a bar or a sheet.
        compressive_strength: Greatest compression that it bears.
        gets_longer: What it gets longer in the flow of the upper bound, over the speed that others are compared
            with; null if there is no flow. Not zero where it yields.
        gets_shorter: What it gets shorter, likewise.
        greatest_compression: Greatest compression likewise, as a positive number.
        greatest_tension: Greatest tension in the field of the lower bound; zero if there is none, null if there is
            no field.
        greatest_tension_at: Distance of that from its start.
        name: Its name.
        slip: The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they
            are pulled out. Null for sheets and beams.
        tensile_strength: Greatest tension that it bears.
        utilisation: The greatest of these over the strength for it: how far it is used; of a beam with its moment
            and shear force.
    """

    axial_force: list[list[float]]
    """The axial force along it: distances from its start, and the force there."""
    bending: BoundBending | None
    """How a beam bends; null for a bar or a sheet."""
    compressive_strength: float
    """Greatest compression that it bears."""
    gets_longer: float | None
    """What it gets longer in the flow of the upper bound, over the speed that others are compared with; null if
    there is no flow. Not zero where it yields.
    """
    gets_shorter: float | None
    """What it gets shorter, likewise."""
    greatest_compression: float | None
    """Greatest compression likewise, as a positive number."""
    greatest_tension: float | None
    """Greatest tension in the field of the lower bound; zero if there is none, null if there is no field."""
    greatest_tension_at: float | None
    """Distance of that from its start."""
    name: str
    """Its name."""
    slip: float | None
    """The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they are
    pulled out. Null for sheets and beams.
    """
    tensile_strength: float
    """Greatest tension that it bears."""
    utilisation: float | None
    """The greatest of these over the strength for it: how far it is used; of a beam with its moment and shear
    force.
    """


@dataclass(frozen=True, repr=False, eq=False)
class BoundResults(Record):
    """What the fields behind the bounds show.

    Attributes:
        contacts: The faces of structures, with the resultants of the lower bound's contact stresses.
        files: Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
        length_unit: Unit of lengths: ``m``, or ``L`` for slant lengths of the plate.
        members: Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the
            upper bound's flow.
        moving: The fraction of the speed from which on soil is said to move.
        moving_ground: Stretches of the ground that move in the upper bound's flow, by ascending x: at least at
            ``moving`` times the speed of the structure, or, if none moves, the greatest speed.
        stress_unit: Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have
            this times the unit of length.
    """

    contacts: list[BoundContact]
    """The faces of structures, with the resultants of the lower bound's contact stresses."""
    files: list[str]
    """Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given."""
    length_unit: str
    """Unit of lengths: ``m``, or ``L`` for slant lengths of the plate."""
    members: list[BoundMember]
    """Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the upper bound's
    flow.
    """
    moving: float
    """The fraction of the speed from which on soil is said to move."""
    moving_ground: list[BoundStretch]
    """Stretches of the ground that move in the upper bound's flow, by ascending x: at least at ``moving`` times the
    speed of the structure, or, if none moves, the greatest speed.
    """
    stress_unit: str
    """Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have this times the
    unit of length.
    """


@dataclass(frozen=True, repr=False, eq=False)
class BoundSolve(Record):
    """One solve.

    Attributes:
        elements: Triangles.
        iterations: Steps of the solver.
        proof_seconds: Time for repair and proof in s.
        proven: What was proven, in the units of the answer; null if nothing was.
        seconds: Time in the solver in s.
        status: How the solver ended; proves nothing.
    """

    elements: int
    """Triangles."""
    iterations: int
    """Steps of the solver."""
    proof_seconds: float
    """Time for repair and proof in s."""
    proven: float | None
    """What was proven, in the units of the answer; null if nothing was."""
    seconds: float
    """Time in the solver in s."""
    status: Literal["solved", "almost_solved", "infeasible", "unbounded", "stopped", "failed"]
    """How the solver ended; proves nothing."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundStretch(Record):
    """A stretch of ground, from its end at lesser x to that at greater x.

    Attributes:
        from_: First end, x and y.
        to: Last end, x and y.
    """

    from_: list[float] = field(metadata={"key": "from"})
    """First end, x and y."""
    to: list[float]
    """Last end, x and y."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundWidth(Record):
    """The bracket of one width. Bounds are on the net coefficient per slant length and width.

    Attributes:
        gap: ``(U - L) / ((U + L) / 2)``.
        lower: Lower bound.
        lower_proof: How the lower bound is proven.
        upper: Upper bound.
        upper_proof: How the upper bound is proven.
        width_ratio: Width over vertical depth; null in plane strain.
    """

    gap: float
    """``(U - L) / ((U + L) / 2)``."""
    lower: float
    """Lower bound."""
    lower_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the lower bound is proven."""
    upper: float
    """Upper bound."""
    upper_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the upper bound is proven."""
    width_ratio: float | None
    """Width over vertical depth; null in plane strain."""


@dataclass(frozen=True, repr=False, eq=False)
class BoundAnswer(Answer):
    """The answer of ``bound``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        certified: Whether both bounds are proven with interval arithmetic.
        end: The stress field in space about the plate's ends; null in plane strain.
        ended: Why the run ended.
        ends: Whether the plate has ends.
        force_lower_n: Lower bound on the force in N; null without depth, width or density.
        force_upper_n: Upper bound on the force in N; null likewise.
        gap: ``(U - L) / ((U + L) / 2)``.
        inputs: What was asked.
        levels: All levels, coarse to fine.
        lower: Lower bound on the net coefficient per slant length, ``2 F / (gamma L^2 w)``.
        lower_elements: Triangles of the mesh of the lower bound; each has three parts.
        lower_factorisation: What factorised the solver's systems behind the lower bound; its digits may depend on
            that, its proof does not.
        lower_proof: How the lower bound is proven.
        notes: Values of it that are possible but unusual, with what is usual and a likely cause.
        over_width: The same plate at other widths, narrow to wide, and plane strain last; empty if it has no ends.
        plane_strain: The bracket in plane strain, which elements and levels are about.
        results: What the fields behind the bounds show: x along the surface from the plate's top, y across it.
        seconds: Time spent in s.
        stopped_by: What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end
            elsewhere another time.
        upper: Upper bound on it.
        upper_elements: Triangles of the mesh of the upper bound.
        upper_factorisation: The same of the upper bound.
        upper_proof: How the upper bound is proven.
        wedge_ahead: How far the moving soil reaches along the surface ahead of the plate's top; in the unit of
            ``results``.
        wedge_behind: The same behind it.
        width_ratio: Width over vertical depth; null in plane strain.
        work: Work spent in element steps: elements of meshes times steps of the solver on them.
    """

    schema: Literal["soilctl.bound/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    certified: bool
    """Whether both bounds are proven with interval arithmetic."""
    end: BoundEnd | None
    """The stress field in space about the plate's ends; null in plane strain."""
    ended: Literal["gap", "time", "elements", "work", "memory", "stopped"]
    """Why the run ended."""
    ends: Literal["finite", "none"]
    """Whether the plate has ends."""
    force_lower_n: float | None
    """Lower bound on the force in N; null without depth, width or density."""
    force_upper_n: float | None
    """Upper bound on the force in N; null likewise."""
    gap: float
    """``(U - L) / ((U + L) / 2)``."""
    inputs: BoundInputs
    """What was asked."""
    levels: list[BoundLevel]
    """All levels, coarse to fine."""
    lower: float
    """Lower bound on the net coefficient per slant length, ``2 F / (gamma L^2 w)``."""
    lower_elements: int
    """Triangles of the mesh of the lower bound; each has three parts."""
    lower_factorisation: Literal["qdldl", "faer"]
    """What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does
    not.
    """
    lower_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the lower bound is proven."""
    notes: list[str]
    """Values of it that are possible but unusual, with what is usual and a likely cause."""
    over_width: list[BoundWidth]
    """The same plate at other widths, narrow to wide, and plane strain last; empty if it has no ends."""
    plane_strain: BoundWidth
    """The bracket in plane strain, which elements and levels are about."""
    results: BoundResults
    """What the fields behind the bounds show: x along the surface from the plate's top, y across it."""
    seconds: float
    """Time spent in s."""
    stopped_by: Literal["goal", "work", "memory", "seconds", "user"]
    """What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end elsewhere another
    time.
    """
    upper: float
    """Upper bound on it."""
    upper_elements: int
    """Triangles of the mesh of the upper bound."""
    upper_factorisation: Literal["qdldl", "faer"]
    """The same of the upper bound."""
    upper_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the upper bound is proven."""
    wedge_ahead: float
    """How far the moving soil reaches along the surface ahead of the plate's top; in the unit of ``results``."""
    wedge_behind: float
    """The same behind it."""
    width_ratio: float | None
    """Width over vertical depth; null in plane strain."""
    work: int
    """Work spent in element steps: elements of meshes times steps of the solver on them."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolBending(Record):
    """How a beam bends.

    Attributes:
        greatest_moment: The moment that is farthest from zero in the field of the lower bound, positive where it
            stretches the beam's right side.
        greatest_moment_at: Distance of that from its start.
        greatest_shear: The shear force that is farthest from zero, per unit width.
        hinges: Where it yields in the flow of the upper bound: distances from its start, and how fast it turns
            there, over the speed that others are compared with (1/length).
        moment: The moment along it: distances from its start, and the moment there.
        moment_strength: Greatest bending moment that it bears, per unit width (force).
        shear: The shear force along it, likewise.
        shear_strength: Greatest shear force that it bears, per unit width.
    """

    greatest_moment: float | None
    """The moment that is farthest from zero in the field of the lower bound, positive where it stretches the beam's
    right side.
    """
    greatest_moment_at: float | None
    """Distance of that from its start."""
    greatest_shear: float | None
    """The shear force that is farthest from zero, per unit width."""
    hinges: list[list[float]]
    """Where it yields in the flow of the upper bound: distances from its start, and how fast it turns there, over
    the speed that others are compared with (1/length).
    """
    moment: list[list[float]]
    """The moment along it: distances from its start, and the moment there."""
    moment_strength: float
    """Greatest bending moment that it bears, per unit width (force)."""
    shear: list[list[float]]
    """The shear force along it, likewise."""
    shear_strength: float
    """Greatest shear force that it bears, per unit width."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolContact(Record):
    """Contact stresses along a face.

    Attributes:
        centre: Distance of the pressure's resultant from the upper end, along the face; null if there is none.
        face: ``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried
            structure; numbered if there are several.
        greatest_pressure: Greatest pressure.
        length: Length of the face.
        normal_force: Resultant of the pressure, per unit width.
        shear_force: Resultant of the shear stress on the soil, per unit width; positive downwards along the face,
            from its upper end.
    """

    centre: float | None
    """Distance of the pressure's resultant from the upper end, along the face; null if there is none."""
    face: str
    """``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried structure;
    numbered if there are several.
    """
    greatest_pressure: float
    """Greatest pressure."""
    length: float
    """Length of the face."""
    normal_force: float
    """Resultant of the pressure, per unit width."""
    shear_force: float
    """Resultant of the shear stress on the soil, per unit width; positive downwards along the face, from its upper
    end.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ToolDirection(Record):
    """What the motion in one direction says of the forces of the tool on the soil.

    Attributes:
        direction_deg: Direction, from the level ahead, above 0 upwards (deg).
        force_n_per_m: A force that is borne, level ahead and upwards (N/m): that of the stresses behind the lower
            bound; null without them.
        lower_n_per_m: Lower bound on the greatest part along it of a force that is borne (N/m); null if none is
            proven.
        problem: Why a bound is missing; null if none is.
        upper_n_per_m: Upper bound on it: all forces with more fail (N/m); null if none is proven.
    """

    direction_deg: float
    """Direction, from the level ahead, above 0 upwards (deg)."""
    force_n_per_m: list[float] | None
    """A force that is borne, level ahead and upwards (N/m): that of the stresses behind the lower bound; null
    without them.
    """
    lower_n_per_m: float | None
    """Lower bound on the greatest part along it of a force that is borne (N/m); null if none is proven."""
    problem: str | None
    """Why a bound is missing; null if none is."""
    upper_n_per_m: float | None
    """Upper bound on it: all forces with more fail (N/m); null if none is proven."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolEnds(Record):
    """The bracket of a tool with ends.

    Attributes:
        front: The plate that the blocks of the upper bound are of; null where that is the tool itself.
        lower_n: Lower bound on the force of the whole tool (N).
        lower_proof: How the lower bound is proven.
        plane_gap: The gap in plane strain, which --max-gap is about; null if the bounds are on both sides of zero.
        plane_lower_n_per_m: Lower bound in plane strain, as without --width (N/m).
        plane_upper_n_per_m: Upper bound in plane strain (N/m), which is none with ends.
        side_plates: Whether it has side plates.
        upper_n: Upper bound on it (N).
        upper_proof: How the upper bound is proven.
        width_m: Width of the tool.
    """

    front: ToolFront | None
    """The plate that the blocks of the upper bound are of; null where that is the tool itself."""
    lower_n: float
    """Lower bound on the force of the whole tool (N)."""
    lower_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the lower bound is proven."""
    plane_gap: float | None
    """The gap in plane strain, which --max-gap is about; null if the bounds are on both sides of zero."""
    plane_lower_n_per_m: float
    """Lower bound in plane strain, as without --width (N/m)."""
    plane_upper_n_per_m: float
    """Upper bound in plane strain (N/m), which is none with ends."""
    side_plates: bool
    """Whether it has side plates."""
    upper_n: float
    """Upper bound on it (N)."""
    upper_proof: Literal["plane", "splice", "space", "mechanism"]
    """How the upper bound is proven."""
    width_m: float
    """Width of the tool."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolForces(Record):
    """Forces that the soil bears on a tool that does not turn, per metre of width.

    Attributes:
        directions: Each direction, from the level ahead upwards and round.
        limit_n_per_m: Corners of a polygon beyond which all forces fail, likewise; null where the bounds do not
            close it.
        safe_n_per_m: Corners of forces that are all borne, level ahead and upwards (N/m), against the clock: the
            hull of those of the directions.
    """

    directions: list[ToolDirection]
    """Each direction, from the level ahead upwards and round."""
    limit_n_per_m: list[list[float]] | None
    """Corners of a polygon beyond which all forces fail, likewise; null where the bounds do not close it."""
    safe_n_per_m: list[list[float]]
    """Corners of forces that are all borne, level ahead and upwards (N/m), against the clock: the hull of those of
    the directions.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ToolFront(Record):
    """A plate that stands for the tool in the upper bound: all of tool and side plates lie behind it, with soil
    that moves along, and it is as rough as the soil.

    Attributes:
        alpha_deg: Its tool angle.
        depth_m: Its vertical depth; more than the tool's where the tool's underside is flatter than the friction
            angle.
        width_m: Its width: that of the tool, and what soil beside it is dragged along.
    """

    alpha_deg: float
    """Its tool angle."""
    depth_m: float
    """Its vertical depth; more than the tool's where the tool's underside is flatter than the friction angle."""
    width_m: float
    """Its width: that of the tool, and what soil beside it is dragged along."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolLevel(Record):
    """One level of meshes.

    Attributes:
        identity_error: Gap of the two programs less the sum of its shares over all elements, relative to the upper
            bound; null without both bounds.
        lower: The lower bound on this level's mesh or one before; null if none was solved.
        upper: The upper bound on this level's mesh.
    """

    identity_error: float | None
    """Gap of the two programs less the sum of its shares over all elements, relative to the upper bound; null
    without both bounds.
    """
    lower: ToolSolve | None
    """The lower bound on this level's mesh or one before; null if none was solved."""
    upper: ToolSolve
    """The upper bound on this level's mesh."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolMember(Record):
    """A bar, a sheet or a beam. Forces are per unit width, tension positive; for a factor of safety those of soil
    whose strength is divided by its lower bound.

    Attributes:
        axial_force: The axial force along it: distances from its start, and the force there.
        bending: How a beam bends; null for a bar or a sheet.
        compressive_strength: Greatest compression that it bears.
        gets_longer: What it gets longer in the flow of the upper bound, over the speed that others are compared
            with; null if there is no flow. Not zero where it yields.
        gets_shorter: What it gets shorter, likewise.
        greatest_compression: Greatest compression likewise, as a positive number.
        greatest_tension: Greatest tension in the field of the lower bound; zero if there is none, null if there is
            no field.
        greatest_tension_at: Distance of that from its start.
        name: Its name.
        slip: The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they
            are pulled out. Null for sheets and beams.
        tensile_strength: Greatest tension that it bears.
        utilisation: The greatest of these over the strength for it: how far it is used; of a beam with its moment
            and shear force.
    """

    axial_force: list[list[float]]
    """The axial force along it: distances from its start, and the force there."""
    bending: ToolBending | None
    """How a beam bends; null for a bar or a sheet."""
    compressive_strength: float
    """Greatest compression that it bears."""
    gets_longer: float | None
    """What it gets longer in the flow of the upper bound, over the speed that others are compared with; null if
    there is no flow. Not zero where it yields.
    """
    gets_shorter: float | None
    """What it gets shorter, likewise."""
    greatest_compression: float | None
    """Greatest compression likewise, as a positive number."""
    greatest_tension: float | None
    """Greatest tension in the field of the lower bound; zero if there is none, null if there is no field."""
    greatest_tension_at: float | None
    """Distance of that from its start."""
    name: str
    """Its name."""
    slip: float | None
    """The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they are
    pulled out. Null for sheets and beams.
    """
    tensile_strength: float
    """Greatest tension that it bears."""
    utilisation: float | None
    """The greatest of these over the strength for it: how far it is used; of a beam with its moment and shear
    force.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ToolPiece(Record):
    """A straight piece of the tool, in the ground.

    Attributes:
        adhesion_pa: Adhesion between them.
        alpha_deg: Its tool angle from the horizontal.
        delta_deg: Friction angle between soil and piece.
        from_m: Its end towards the tip: along the surface, ahead of where the tool goes through it, and across,
            upwards (m).
        to_m: Its other end.
    """

    adhesion_pa: float
    """Adhesion between them."""
    alpha_deg: float
    """Its tool angle from the horizontal."""
    delta_deg: float
    """Friction angle between soil and piece."""
    from_m: list[float]
    """Its end towards the tip: along the surface, ahead of where the tool goes through it, and across, upwards (m).
    """
    to_m: list[float]
    """Its other end."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolResults(Record):
    """What the fields behind the bounds show.

    Attributes:
        contacts: The faces of structures, with the resultants of the lower bound's contact stresses.
        files: Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
        length_unit: Unit of lengths: ``m``, or ``L`` for slant lengths of the plate.
        members: Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the
            upper bound's flow.
        moving: The fraction of the speed from which on soil is said to move.
        moving_ground: Stretches of the ground that move in the upper bound's flow, by ascending x: at least at
            ``moving`` times the speed of the structure, or, if none moves, the greatest speed.
        stress_unit: Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have
            this times the unit of length.
    """

    contacts: list[ToolContact]
    """The faces of structures, with the resultants of the lower bound's contact stresses."""
    files: list[str]
    """Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given."""
    length_unit: str
    """Unit of lengths: ``m``, or ``L`` for slant lengths of the plate."""
    members: list[ToolMember]
    """Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the upper bound's
    flow.
    """
    moving: float
    """The fraction of the speed from which on soil is said to move."""
    moving_ground: list[ToolStretch]
    """Stretches of the ground that move in the upper bound's flow, by ascending x: at least at ``moving`` times the
    speed of the structure, or, if none moves, the greatest speed.
    """
    stress_unit: str
    """Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have this times the
    unit of length.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ToolRow(Record):
    """Bounds at one pair of friction angles.

    Attributes:
        coefficient_lower: Lower bound on the coefficient of that force, as in the answer.
        coefficient_upper: Upper bound on it.
        delta_deg: Friction angle between soil and tool, where the tool file says none; null if it says all.
        gap: Their gap; null as in the answer.
        lower_n_per_m: Lower bound on the force along the motion, per metre of width, with ends if a width is given;
            null if none is proven.
        phi_deg: Internal friction angle of the soil.
        problem: Why there are no bounds; null if there are.
        upper_n_per_m: Upper bound likewise.
    """

    coefficient_lower: float | None
    """Lower bound on the coefficient of that force, as in the answer."""
    coefficient_upper: float | None
    """Upper bound on it."""
    delta_deg: float | None
    """Friction angle between soil and tool, where the tool file says none; null if it says all."""
    gap: float | None
    """Their gap; null as in the answer."""
    lower_n_per_m: float | None
    """Lower bound on the force along the motion, per metre of width, with ends if a width is given; null if none is
    proven.
    """
    phi_deg: float
    """Internal friction angle of the soil."""
    problem: str | None
    """Why there are no bounds; null if there are."""
    upper_n_per_m: float | None
    """Upper bound likewise."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolSolve(Record):
    """One solve.

    Attributes:
        elements: Triangles.
        iterations: Steps of the solver.
        proof_seconds: Time for repair and proof in s.
        proven: What was proven, in the units of the answer; null if nothing was.
        seconds: Time in the solver in s.
        status: How the solver ended; proves nothing.
    """

    elements: int
    """Triangles."""
    iterations: int
    """Steps of the solver."""
    proof_seconds: float
    """Time for repair and proof in s."""
    proven: float | None
    """What was proven, in the units of the answer; null if nothing was."""
    seconds: float
    """Time in the solver in s."""
    status: Literal["solved", "almost_solved", "infeasible", "unbounded", "stopped", "failed"]
    """How the solver ended; proves nothing."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolStretch(Record):
    """A stretch of ground, from its end at lesser x to that at greater x.

    Attributes:
        from_: First end, x and y.
        to: Last end, x and y.
    """

    from_: list[float] = field(metadata={"key": "from"})
    """First end, x and y."""
    to: list[float]
    """Last end, x and y."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolTable(Record):
    """The table that was written.

    Attributes:
        file: Its file.
        kept_rows: Rows that an earlier run had made.
        rows: All rows, by friction angle of the soil and then of the interface.
    """

    file: str
    """Its file."""
    kept_rows: int
    """Rows that an earlier run had made."""
    rows: list[ToolRow]
    """All rows, by friction angle of the soil and then of the interface."""


@dataclass(frozen=True, repr=False, eq=False)
class Tool(Record):
    """The tool in its place.

    Attributes:
        chord_alpha_deg: Tool angle of the straight line from the tip to where the tool goes through the surface, or
            to the top of a buried tool.
        chord_m: Length of that line.
        cover_m: Depth of the highest point likewise; zero unless the tool is buried.
        depth_m: Depth of the lowest point below the surface, at right angles to it.
        off_arc_m: How far the straight pieces are from the arc that they stand for at most.
        pieces: What of it is in the ground, from the tip.
        title: What it is; null if the file does not say.
    """

    chord_alpha_deg: float
    """Tool angle of the straight line from the tip to where the tool goes through the surface, or to the top of a
    buried tool.
    """
    chord_m: float
    """Length of that line."""
    cover_m: float
    """Depth of the highest point likewise; zero unless the tool is buried."""
    depth_m: float
    """Depth of the lowest point below the surface, at right angles to it."""
    off_arc_m: float
    """How far the straight pieces are from the arc that they stand for at most."""
    pieces: list[ToolPiece]
    """What of it is in the ground, from the tip."""
    title: str | None
    """What it is; null if the file does not say."""


@dataclass(frozen=True, repr=False, eq=False)
class ToolAnswer(Answer):
    """The answer of ``tool``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        certified: Whether both bounds are proven with interval arithmetic.
        coefficient_lower: Lower bound on the coefficient of that force, ``2 F / (gamma L^2)``, with the length of
            the chord for L.
        coefficient_upper: Upper bound on it.
        direction_deg: Direction of the motion, from the horizontal.
        ended: Why the run ended.
        ends: What is proven of the whole tool with its ends; null without --width.
        forces: Forces that the soil bears, in all directions; null without --forces.
        gap: ``|(U - L) / ((U + L) / 2)|``; null if the bounds are on both sides of zero.
        levels: All levels, coarse to fine, in kN/m.
        lower_elements: Triangles of the mesh of the lower bound; each has three parts.
        lower_factorisation: What factorised the solver's systems behind the lower bound; its digits may depend on
            that, its proof does not.
        lower_n_per_m: Lower bound on the force of the tool on the soil along its motion, per metre of width (N/m):
            of a tool without ends, or of one with the width of ``ends``.
        notes: Values that are possible but unusual, and what else is to be kept in mind.
        results: What the fields behind the bounds show, along and across the surface.
        seconds: Time spent in s.
        slant_lower: Of a flat tool with one interface that moves horizontally: lower bound on the coefficient that
            ``bound`` answers, of the force inclined at delta to the normal; null for others, whose direction of
            force is not known.
        slant_upper: Upper bound on it; null likewise.
        stopped_by: What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end
            elsewhere another time.
        table: Bounds over friction angles; null without --table.
        tool: The tool.
        upper_elements: Triangles of the mesh of the upper bound.
        upper_factorisation: The same of the upper bound.
        upper_n_per_m: Upper bound on it (N/m).
        work: Work spent in element steps: elements of meshes times steps of the solver on them.
    """

    schema: Literal["soilctl.tool/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    certified: bool
    """Whether both bounds are proven with interval arithmetic."""
    coefficient_lower: float
    """Lower bound on the coefficient of that force, ``2 F / (gamma L^2)``, with the length of the chord for L."""
    coefficient_upper: float
    """Upper bound on it."""
    direction_deg: float
    """Direction of the motion, from the horizontal."""
    ended: Literal["gap", "time", "elements", "work", "memory", "stopped"]
    """Why the run ended."""
    ends: ToolEnds | None
    """What is proven of the whole tool with its ends; null without --width."""
    forces: ToolForces | None
    """Forces that the soil bears, in all directions; null without --forces."""
    gap: float | None
    """``|(U - L) / ((U + L) / 2)|``; null if the bounds are on both sides of zero."""
    levels: list[ToolLevel]
    """All levels, coarse to fine, in kN/m."""
    lower_elements: int
    """Triangles of the mesh of the lower bound; each has three parts."""
    lower_factorisation: Literal["qdldl", "faer"]
    """What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does
    not.
    """
    lower_n_per_m: float
    """Lower bound on the force of the tool on the soil along its motion, per metre of width (N/m): of a tool
    without ends, or of one with the width of ``ends``.
    """
    notes: list[str]
    """Values that are possible but unusual, and what else is to be kept in mind."""
    results: ToolResults
    """What the fields behind the bounds show, along and across the surface."""
    seconds: float
    """Time spent in s."""
    slant_lower: float | None
    """Of a flat tool with one interface that moves horizontally: lower bound on the coefficient that ``bound``
    answers, of the force inclined at delta to the normal; null for others, whose direction of force is not
    known.
    """
    slant_upper: float | None
    """Upper bound on it; null likewise."""
    stopped_by: Literal["goal", "work", "memory", "seconds", "user"]
    """What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end elsewhere another
    time.
    """
    table: ToolTable | None
    """Bounds over friction angles; null without --table."""
    tool: Tool
    """The tool."""
    upper_elements: int
    """Triangles of the mesh of the upper bound."""
    upper_factorisation: Literal["qdldl", "faer"]
    """The same of the upper bound."""
    upper_n_per_m: float
    """Upper bound on it (N/m)."""
    work: int
    """Work spent in element steps: elements of meshes times steps of the solver on them."""


@dataclass(frozen=True, repr=False, eq=False)
class ObstacleDistance(Record):
    """The force at one distance.

    Attributes:
        ahead_m: Distance from the tool's tip to the body along the surface (m).
        gap: ``(U - L) / ((U + L) / 2)`` of the forces; null without both.
        lower_is_without: Whether the lower bound is that without the body, which holds here too, as no field found
            here proves more.
        lower_n_per_m: Lower bound on the force along the motion, per metre of width (N/m); null if there is none.
        problem: Why bounds are missing; null if they are not.
        ratio_lower: Lower bound on the force over that without the body; null likewise.
        ratio_upper: Upper bound on that ratio; null likewise.
        upper_n_per_m: Upper bound on it; null likewise.
    """

    ahead_m: float
    """Distance from the tool's tip to the body along the surface (m)."""
    gap: float | None
    """``(U - L) / ((U + L) / 2)`` of the forces; null without both."""
    lower_is_without: bool
    """Whether the lower bound is that without the body, which holds here too, as no field found here proves more.
    """
    lower_n_per_m: float | None
    """Lower bound on the force along the motion, per metre of width (N/m); null if there is none."""
    problem: str | None
    """Why bounds are missing; null if they are not."""
    ratio_lower: float | None
    """Lower bound on the force over that without the body; null likewise."""
    ratio_upper: float | None
    """Upper bound on that ratio; null likewise."""
    upper_n_per_m: float | None
    """Upper bound on it; null likewise."""


@dataclass(frozen=True, repr=False, eq=False)
class ObstaclePiece(Record):
    """A straight piece of the tool, in the ground.

    Attributes:
        adhesion_pa: Adhesion between them.
        alpha_deg: Its tool angle from the horizontal.
        delta_deg: Friction angle between soil and piece.
        from_m: Its end towards the tip: along the surface, ahead of where the tool goes through it, and across,
            upwards (m).
        to_m: Its other end.
    """

    adhesion_pa: float
    """Adhesion between them."""
    alpha_deg: float
    """Its tool angle from the horizontal."""
    delta_deg: float
    """Friction angle between soil and piece."""
    from_m: list[float]
    """Its end towards the tip: along the surface, ahead of where the tool goes through it, and across, upwards (m).
    """
    to_m: list[float]
    """Its other end."""


@dataclass(frozen=True, repr=False, eq=False)
class ObstacleTool(Record):
    """The tool in its place.

    Attributes:
        chord_alpha_deg: Tool angle of the straight line from the tip to where the tool goes through the surface, or
            to the top of a buried tool.
        chord_m: Length of that line.
        cover_m: Depth of the highest point likewise; zero unless the tool is buried.
        depth_m: Depth of the lowest point below the surface, at right angles to it.
        off_arc_m: How far the straight pieces are from the arc that they stand for at most.
        pieces: What of it is in the ground, from the tip.
        title: What it is; null if the file does not say.
    """

    chord_alpha_deg: float
    """Tool angle of the straight line from the tip to where the tool goes through the surface, or to the top of a
    buried tool.
    """
    chord_m: float
    """Length of that line."""
    cover_m: float
    """Depth of the highest point likewise; zero unless the tool is buried."""
    depth_m: float
    """Depth of the lowest point below the surface, at right angles to it."""
    off_arc_m: float
    """How far the straight pieces are from the arc that they stand for at most."""
    pieces: list[ObstaclePiece]
    """What of it is in the ground, from the tip."""
    title: str | None
    """What it is; null if the file does not say."""


@dataclass(frozen=True, repr=False, eq=False)
class ObstacleAnswer(Answer):
    """The answer of ``obstacle``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        answer: Whether the force says that something is there.
        body: What the body does.
        body_height_m: Its height.
        body_length_m: Its length along the motion.
        body_top_m: Depth of its top below the surface.
        certified: Whether all bounds that are told are proven with interval arithmetic.
        direction_deg: Direction of the motion, from the horizontal.
        distances: The same at each distance, near to far.
        hidden_from_m: Least distance looked at from which on it is proven to be no more than that; null likewise.
        notes: Values that are possible but unusual, and what else is to be kept in mind.
        scatter: Relative scatter of measured forces.
        seconds: Time spent in s.
        shows_to_m: Greatest distance looked at up to which the force is proven to be more than the scatter above
            that without the body; null if there is none.
        stone_cohesion_pa: Cohesion of a stone, whose friction angle is that of the soil: the bounds are those of a
            stone of this strength, which is far above that of the soil; null for bodies that do not move.
        tool: The tool.
        verdict: The answer in words.
        without_lower_n_per_m: Lower bound on the force without the body, along the motion, per metre of width
            (N/m).
        without_upper_n_per_m: Upper bound on it (N/m).
        work: Work spent in element steps.
    """

    schema: Literal["soilctl.obstacle/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    answer: Literal["shows", "hidden", "open"]
    """Whether the force says that something is there."""
    body: Literal["fixed", "stone"]
    """What the body does."""
    body_height_m: float
    """Its height."""
    body_length_m: float
    """Its length along the motion."""
    body_top_m: float
    """Depth of its top below the surface."""
    certified: bool
    """Whether all bounds that are told are proven with interval arithmetic."""
    direction_deg: float
    """Direction of the motion, from the horizontal."""
    distances: list[ObstacleDistance]
    """The same at each distance, near to far."""
    hidden_from_m: float | None
    """Least distance looked at from which on it is proven to be no more than that; null likewise."""
    notes: list[str]
    """Values that are possible but unusual, and what else is to be kept in mind."""
    scatter: float
    """Relative scatter of measured forces."""
    seconds: float
    """Time spent in s."""
    shows_to_m: float | None
    """Greatest distance looked at up to which the force is proven to be more than the scatter above that without
    the body; null if there is none.
    """
    stone_cohesion_pa: float | None
    """Cohesion of a stone, whose friction angle is that of the soil: the bounds are those of a stone of this
    strength, which is far above that of the soil; null for bodies that do not move.
    """
    tool: ObstacleTool
    """The tool."""
    verdict: str
    """The answer in words."""
    without_lower_n_per_m: float
    """Lower bound on the force without the body, along the motion, per metre of width (N/m)."""
    without_upper_n_per_m: float
    """Upper bound on it (N/m)."""
    work: int
    """Work spent in element steps."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveBending(Record):
    """How a beam bends.

    Attributes:
        greatest_moment: The moment that is farthest from zero in the field of the lower bound, positive where it
            stretches the beam's right side.
        greatest_moment_at: Distance of that from its start.
        greatest_shear: The shear force that is farthest from zero, per unit width.
        hinges: Where it yields in the flow of the upper bound: distances from its start, and how fast it turns
            there, over the speed that others are compared with (1/length).
        moment: The moment along it: distances from its start, and the moment there.
        moment_strength: Greatest bending moment that it bears, per unit width (force).
        shear: The shear force along it, likewise.
        shear_strength: Greatest shear force that it bears, per unit width.
    """

    greatest_moment: float | None
    """The moment that is farthest from zero in the field of the lower bound, positive where it stretches the beam's
    right side.
    """
    greatest_moment_at: float | None
    """Distance of that from its start."""
    greatest_shear: float | None
    """The shear force that is farthest from zero, per unit width."""
    hinges: list[list[float]]
    """Where it yields in the flow of the upper bound: distances from its start, and how fast it turns there, over
    the speed that others are compared with (1/length).
    """
    moment: list[list[float]]
    """The moment along it: distances from its start, and the moment there."""
    moment_strength: float
    """Greatest bending moment that it bears, per unit width (force)."""
    shear: list[list[float]]
    """The shear force along it, likewise."""
    shear_strength: float
    """Greatest shear force that it bears, per unit width."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCase(Record):
    """What was found for one case of a problem file, or one value of its sweeps.

    Attributes:
        certified: Whether both bounds are proven.
        enough: Whether a factor is proven to be one or more: what the case asks for. Null if the bounds do not
            tell, and where forces or accelerations are bounded.
        gap: As that of the whole answer.
        lower: Lower bound, over the partial factor on resistance; null if there are no bounds.
        name: Its name: that of the case, and the values of the sweeps.
        problem: Why there are no bounds; null if there are.
        upper: Upper bound, likewise.
        values_: The values that it sets, by parameter.
    """

    certified: bool
    """Whether both bounds are proven."""
    enough: bool | None
    """Whether a factor is proven to be one or more: what the case asks for. Null if the bounds do not tell, and
    where forces or accelerations are bounded.
    """
    gap: float | None
    """As that of the whole answer."""
    lower: float | None
    """Lower bound, over the partial factor on resistance; null if there are no bounds."""
    name: str
    """Its name: that of the case, and the values of the sweeps."""
    problem: str | None
    """Why there are no bounds; null if there are."""
    upper: float | None
    """Upper bound, likewise."""
    values_: dict[str, float] = field(metadata={"key": "values"})
    """The values that it sets, by parameter."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveContact(Record):
    """Contact stresses along a face.

    Attributes:
        centre: Distance of the pressure's resultant from the upper end, along the face; null if there is none.
        face: ``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried
            structure; numbered if there are several.
        greatest_pressure: Greatest pressure.
        length: Length of the face.
        normal_force: Resultant of the pressure, per unit width.
        shear_force: Resultant of the shear stress on the soil, per unit width; positive downwards along the face,
            from its upper end.
    """

    centre: float | None
    """Distance of the pressure's resultant from the upper end, along the face; null if there is none."""
    face: str
    """``front``, ``back`` or ``side`` as seen along the structure's motion, ``around`` for a buried structure;
    numbered if there are several.
    """
    greatest_pressure: float
    """Greatest pressure."""
    length: float
    """Length of the face."""
    normal_force: float
    """Resultant of the pressure, per unit width."""
    shear_force: float
    """Resultant of the shear stress on the soil, per unit width; positive downwards along the face, from its upper
    end.
    """


@dataclass(frozen=True, repr=False, eq=False)
class SolveHead(Record):
    """What flows in at a given head.

    Attributes:
        head_m: The total head.
        inflow: What flows into the soil; negative where it flows out.
        name: Name of the entry; null if it has none.
    """

    head_m: float
    """The total head."""
    inflow: float
    """What flows into the soil; negative where it flows out."""
    name: str | None
    """Name of the entry; null if it has none."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveLevel(Record):
    """One level of meshes.

    Attributes:
        identity_error: Gap of the two programs less the sum of its shares over all elements, relative to the upper
            bound; null without both bounds.
        lower: The lower bound on this level's mesh or one before; null if none was solved.
        upper: The upper bound on this level's mesh.
    """

    identity_error: float | None
    """Gap of the two programs less the sum of its shares over all elements, relative to the upper bound; null
    without both bounds.
    """
    lower: Solve | None
    """The lower bound on this level's mesh or one before; null if none was solved."""
    upper: Solve
    """The upper bound on this level's mesh."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveMember(Record):
    """A bar, a sheet or a beam. Forces are per unit width, tension positive; for a factor of safety those of soil
    whose strength is divided by its lower bound.

    Attributes:
        axial_force: The axial force along it: distances from its start, and the force there.
        bending: How a beam bends; null for a bar or a sheet.
        compressive_strength: Greatest compression that it bears.
        gets_longer: What it gets longer in the flow of the upper bound, over the speed that others are compared
            with; null if there is no flow. Not zero where it yields.
        gets_shorter: What it gets shorter, likewise.
        greatest_compression: Greatest compression likewise, as a positive number.
        greatest_tension: Greatest tension in the field of the lower bound; zero if there is none, null if there is
            no field.
        greatest_tension_at: Distance of that from its start.
        name: Its name.
        slip: The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they
            are pulled out. Null for sheets and beams.
        tensile_strength: Greatest tension that it bears.
        utilisation: The greatest of these over the strength for it: how far it is used; of a beam with its moment
            and shear force.
    """

    axial_force: list[list[float]]
    """The axial force along it: distances from its start, and the force there."""
    bending: SolveBending | None
    """How a beam bends; null for a bar or a sheet."""
    compressive_strength: float
    """Greatest compression that it bears."""
    gets_longer: float | None
    """What it gets longer in the flow of the upper bound, over the speed that others are compared with; null if
    there is no flow. Not zero where it yields.
    """
    gets_shorter: float | None
    """What it gets shorter, likewise."""
    greatest_compression: float | None
    """Greatest compression likewise, as a positive number."""
    greatest_tension: float | None
    """Greatest tension in the field of the lower bound; zero if there is none, null if there is no field."""
    greatest_tension_at: float | None
    """Distance of that from its start."""
    name: str
    """Its name."""
    slip: float | None
    """The greatest speed at which bars of a row slip in the soil in that flow, likewise: near one where they are
    pulled out. Null for sheets and beams.
    """
    tensile_strength: float
    """Greatest tension that it bears."""
    utilisation: float | None
    """The greatest of these over the strength for it: how far it is used; of a beam with its moment and shear
    force.
    """


@dataclass(frozen=True, repr=False, eq=False)
class SolveResults(Record):
    """What the fields behind the bounds show.

    Attributes:
        contacts: The faces of structures, with the resultants of the lower bound's contact stresses.
        files: Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
        length_unit: Unit of lengths: ``m``, or ``L`` for slant lengths of the plate.
        members: Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the
            upper bound's flow.
        moving: The fraction of the speed from which on soil is said to move.
        moving_ground: Stretches of the ground that move in the upper bound's flow, by ascending x: at least at
            ``moving`` times the speed of the structure, or, if none moves, the greatest speed.
        stress_unit: Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have
            this times the unit of length.
    """

    contacts: list[SolveContact]
    """The faces of structures, with the resultants of the lower bound's contact stresses."""
    files: list[str]
    """Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given."""
    length_unit: str
    """Unit of lengths: ``m``, or ``L`` for slant lengths of the plate."""
    members: list[SolveMember]
    """Bars, sheets and beams: what they bear in the lower bound's field, and how they stretch in the upper bound's
    flow.
    """
    moving: float
    """The fraction of the speed from which on soil is said to move."""
    moving_ground: list[SolveStretch]
    """Stretches of the ground that move in the upper bound's flow, by ascending x: at least at ``moving`` times the
    speed of the structure, or, if none moves, the greatest speed.
    """
    stress_unit: str
    """Unit of stresses: ``kPa``, or ``γL`` for unit weight times slant length. Forces per width have this times the
    unit of length.
    """


@dataclass(frozen=True, repr=False, eq=False)
class SolveSeepage(Record):
    """A steady flow of ground water between given heads.

    Attributes:
        exit_at_m: Where that is in m.
        exit_gradient: Greatest loss of head over the way where water comes out; null if none does. At a sharp
            corner it grows without limit on finer triangles.
        found_within_kpa: Greatest difference of these, at the corners of the large triangles, from those of
            triangles four times as large.
        greatest_kpa: Greatest pore pressure at their corners.
        heads: What flows in at each given head.
        in_m2_per_s: Whether flows are in m3/s for a metre of width. If not, they are that over the permeability,
            which is not given: m.
        kept_within_kpa: Greatest difference between the pore pressures for which bounds are proven and those of
            triangles a sixty-fourth as large.
        out_in_air: What comes out of ground in air, in the unit of the others.
        triangles: Triangles with water in their pores, in each of which the pore pressure is linear.
    """

    exit_at_m: list[float] | None
    """Where that is in m."""
    exit_gradient: float | None
    """Greatest loss of head over the way where water comes out; null if none does. At a sharp corner it grows
    without limit on finer triangles.
    """
    found_within_kpa: float
    """Greatest difference of these, at the corners of the large triangles, from those of triangles four times as
    large.
    """
    greatest_kpa: float
    """Greatest pore pressure at their corners."""
    heads: list[SolveHead]
    """What flows in at each given head."""
    in_m2_per_s: bool
    """Whether flows are in m3/s for a metre of width. If not, they are that over the permeability, which is not
    given: m.
    """
    kept_within_kpa: float
    """Greatest difference between the pore pressures for which bounds are proven and those of triangles a
    sixty-fourth as large.
    """
    out_in_air: float
    """What comes out of ground in air, in the unit of the others."""
    triangles: int
    """Triangles with water in their pores, in each of which the pore pressure is linear."""


@dataclass(frozen=True, repr=False, eq=False)
class Solve(Record):
    """One solve.

    Attributes:
        elements: Triangles.
        iterations: Steps of the solver.
        proof_seconds: Time for repair and proof in s.
        proven: What was proven, in the units of the answer; null if nothing was.
        seconds: Time in the solver in s.
        status: How the solver ended; proves nothing.
    """

    elements: int
    """Triangles."""
    iterations: int
    """Steps of the solver."""
    proof_seconds: float
    """Time for repair and proof in s."""
    proven: float | None
    """What was proven, in the units of the answer; null if nothing was."""
    seconds: float
    """Time in the solver in s."""
    status: Literal["solved", "almost_solved", "infeasible", "unbounded", "stopped", "failed"]
    """How the solver ended; proves nothing."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveStretch(Record):
    """A stretch of ground, from its end at lesser x to that at greater x.

    Attributes:
        from_: First end, x and y.
        to: Last end, x and y.
    """

    from_: list[float] = field(metadata={"key": "from"})
    """First end, x and y."""
    to: list[float]
    """Last end, x and y."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveTrial(Record):
    """A factor that strength was divided by, and bounds on the factor on all that acts that the soil then bears.

    Attributes:
        borne_lower: Lower bound on that; null if none is proven.
        borne_upper: Upper bound on it; null likewise.
        factor: The factor.
    """

    borne_lower: float | None
    """Lower bound on that; null if none is proven."""
    borne_upper: float | None
    """Upper bound on it; null likewise."""
    factor: float
    """The factor."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveAnswer(Answer):
    """The answer of ``solve``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        cases: All cases of the file; empty if it has none.
        certified: Whether both bounds are proven with interval arithmetic, of cases those of all.
        ended: Why the run ended.
        gap: ``|(U - L) / ((U + L) / 2)|``; null if the bounds are on both sides of zero.
        governing: The case of the file with the least lower bound, whose fields and levels these are; null if the
            file has no cases.
        levels: All levels, coarse to fine; empty for a factor of safety.
        lower: Lower bound, of cases the least. A force is negative where the soil pushes the structure on.
        lower_elements: Triangles of the mesh of the lower bound; each has three parts.
        lower_factorisation: What factorised the solver's systems behind the lower bound; its digits may depend on
            that, its proof does not.
        notes: Values of the file that are possible but unusual, with what is usual and a likely cause.
        quantity: What is bounded.
        results: What the fields behind the bounds show, in the coordinates of the file. Those of a factor of safety
            are of soil whose strength is divided by its bounds.
        seconds: Time spent in s.
        seepage: How ground water flows between given heads, of cases in the governing one; null if it does not.
        stopped_by: What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end
            elsewhere another time.
        title: Title of the problem; null if it has none.
        trials: For a factor of safety, all factors that were tried; else empty.
        upper: Upper bound, likewise.
        upper_elements: Triangles of the mesh of the upper bound.
        upper_factorisation: The same of the upper bound.
        work: Work spent in element steps: elements of meshes times steps of the solver on them.
    """

    schema: Literal["soilctl.solve/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    cases: list[SolveCase]
    """All cases of the file; empty if it has none."""
    certified: bool
    """Whether both bounds are proven with interval arithmetic, of cases those of all."""
    ended: Literal["gap", "time", "elements", "work", "memory", "stopped"]
    """Why the run ended."""
    gap: float | None
    """``|(U - L) / ((U + L) / 2)|``; null if the bounds are on both sides of zero."""
    governing: str | None
    """The case of the file with the least lower bound, whose fields and levels these are; null if the file has no
    cases.
    """
    levels: list[SolveLevel]
    """All levels, coarse to fine; empty for a factor of safety."""
    lower: float
    """Lower bound, of cases the least. A force is negative where the soil pushes the structure on."""
    lower_elements: int
    """Triangles of the mesh of the lower bound; each has three parts."""
    lower_factorisation: Literal["qdldl", "faer"]
    """What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does
    not.
    """
    notes: list[str]
    """Values of the file that are possible but unusual, with what is usual and a likely cause."""
    quantity: Literal["force_kn_per_m", "load_factor", "weight_factor", "acceleration_over_g", "factor_of_safety"]
    """What is bounded."""
    results: SolveResults
    """What the fields behind the bounds show, in the coordinates of the file. Those of a factor of safety are of
    soil whose strength is divided by its bounds.
    """
    seconds: float
    """Time spent in s."""
    seepage: SolveSeepage | None
    """How ground water flows between given heads, of cases in the governing one; null if it does not."""
    stopped_by: Literal["goal", "work", "memory", "seconds", "user"]
    """What kind of limit that is. Only after ``seconds`` and ``user`` the same command may end elsewhere another
    time.
    """
    title: str | None
    """Title of the problem; null if it has none."""
    trials: list[SolveTrial]
    """For a factor of safety, all factors that were tried; else empty."""
    upper: float
    """Upper bound, likewise."""
    upper_elements: int
    """Triangles of the mesh of the upper bound."""
    upper_factorisation: Literal["qdldl", "faer"]
    """The same of the upper bound."""
    work: int
    """Work spent in element steps: elements of meshes times steps of the solver on them."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckCheckedBoundary(Record):
    """All boundary with one condition.

    Attributes:
        kind: The condition.
        length_m: Its length, of both faces for plates.
    """

    kind: Literal["free", "load", "fixed", "smooth", "far", "face"]
    """The condition."""
    length_m: float
    """Its length, of both faces for plates."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckCheckedCase(Record):
    """A case of the file.

    Attributes:
        factors: Its partial factors other than one.
        name: Its name, with the values of the sweeps.
        values_: The values that it sets, by parameter.
    """

    factors: dict[str, float]
    """Its partial factors other than one."""
    name: str
    """Its name, with the values of the sweeps."""
    values_: dict[str, float] = field(metadata={"key": "values"})
    """The values that it sets, by parameter."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckCheckedMember(Record):
    """A bar, a sheet or a beam.

    Attributes:
        attached: Whether its start and its end are attached to what is there, and so may bear a force.
        bond_factor: What each face bears of the shear strength of the soil beside it.
        compressive_kn_per_m: Greatest compression that it bears.
        free_length_m: Length from the start along which it hands bars nothing.
        length_m: Its length.
        moment_knm_per_m: Greatest bending moment that a beam bears; null for a bar or a sheet.
        name: Its name.
        pullout_kn_per_m2: What the soil that goes on between a row of bars hands to each metre, at the start and
            the end; null for sheets and beams, which have faces.
        shear_kn_per_m: Greatest shear force of a beam.
        tensile_kn_per_m: Greatest tension that it bears.
    """

    attached: list[bool]
    """Whether its start and its end are attached to what is there, and so may bear a force."""
    bond_factor: float
    """What each face bears of the shear strength of the soil beside it."""
    compressive_kn_per_m: float
    """Greatest compression that it bears."""
    free_length_m: float
    """Length from the start along which it hands bars nothing."""
    length_m: float
    """Its length."""
    moment_knm_per_m: float | None
    """Greatest bending moment that a beam bears; null for a bar or a sheet."""
    name: str
    """Its name."""
    pullout_kn_per_m2: list[float] | None
    """What the soil that goes on between a row of bars hands to each metre, at the start and the end; null for
    sheets and beams, which have faces.
    """
    shear_kn_per_m: float | None
    """Greatest shear force of a beam."""
    tensile_kn_per_m: float
    """Greatest tension that it bears."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckCheckedRegion(Record):
    """A region after cutting.

    Attributes:
        area_m2: Area in m2.
        cohesion_kpa: Least and greatest cohesion at its corners.
        phi_deg: Friction angle.
        pore_pressure_kpa: Least and greatest pore pressure at its corners.
        soil: Name of the soil.
        unit_weight_kn_m3: Unit weight.
    """

    area_m2: float
    """Area in m2."""
    cohesion_kpa: list[float]
    """Least and greatest cohesion at its corners."""
    phi_deg: float
    """Friction angle."""
    pore_pressure_kpa: list[float]
    """Least and greatest pore pressure at its corners."""
    soil: str
    """Name of the soil."""
    unit_weight_kn_m3: float
    """Unit weight."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckHead(Record):
    """What flows in at a given head.

    Attributes:
        head_m: The total head.
        inflow: What flows into the soil; negative where it flows out.
        name: Name of the entry; null if it has none.
    """

    head_m: float
    """The total head."""
    inflow: float
    """What flows into the soil; negative where it flows out."""
    name: str | None
    """Name of the entry; null if it has none."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckSeepage(Record):
    """A steady flow of ground water between given heads.

    Attributes:
        exit_at_m: Where that is in m.
        exit_gradient: Greatest loss of head over the way where water comes out; null if none does. At a sharp
            corner it grows without limit on finer triangles.
        found_within_kpa: Greatest difference of these, at the corners of the large triangles, from those of
            triangles four times as large.
        greatest_kpa: Greatest pore pressure at their corners.
        heads: What flows in at each given head.
        in_m2_per_s: Whether flows are in m3/s for a metre of width. If not, they are that over the permeability,
            which is not given: m.
        kept_within_kpa: Greatest difference between the pore pressures for which bounds are proven and those of
            triangles a sixty-fourth as large.
        out_in_air: What comes out of ground in air, in the unit of the others.
        triangles: Triangles with water in their pores, in each of which the pore pressure is linear.
    """

    exit_at_m: list[float] | None
    """Where that is in m."""
    exit_gradient: float | None
    """Greatest loss of head over the way where water comes out; null if none does. At a sharp corner it grows
    without limit on finer triangles.
    """
    found_within_kpa: float
    """Greatest difference of these, at the corners of the large triangles, from those of triangles four times as
    large.
    """
    greatest_kpa: float
    """Greatest pore pressure at their corners."""
    heads: list[SolveCheckHead]
    """What flows in at each given head."""
    in_m2_per_s: bool
    """Whether flows are in m3/s for a metre of width. If not, they are that over the permeability, which is not
    given: m.
    """
    kept_within_kpa: float
    """Greatest difference between the pore pressures for which bounds are proven and those of triangles a
    sixty-fourth as large.
    """
    out_in_air: float
    """What comes out of ground in air, in the unit of the others."""
    triangles: int
    """Triangles with water in their pores, in each of which the pore pressure is linear."""


@dataclass(frozen=True, repr=False, eq=False)
class SolveCheckAnswer(Answer):
    """The answer of ``solve_check``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        boundaries: Total length of boundary with each condition.
        cases: Cases, with the values of sweeps; empty if there are none.
        length_m: Unit of length of the solver in m.
        members: Bars and sheets.
        notes: Values that are possible but unusual, with what is usual and a likely cause.
        quantity: What ``solve`` would bound.
        regions: Regions of one soil after cutting; all of one soil as one where ground water flows.
        seepage: How ground water flows between given heads; null if it does not.
        stress_kpa: Unit of stress of the solver in kPa.
        title: Title of the problem; null if it has none.
    """

    schema: Literal["soilctl.solve-check/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    boundaries: list[SolveCheckCheckedBoundary]
    """Total length of boundary with each condition."""
    cases: list[SolveCheckCheckedCase]
    """Cases, with the values of sweeps; empty if there are none."""
    length_m: float
    """Unit of length of the solver in m."""
    members: list[SolveCheckCheckedMember]
    """Bars and sheets."""
    notes: list[str]
    """Values that are possible but unusual, with what is usual and a likely cause."""
    quantity: Literal["force_kn_per_m", "load_factor", "weight_factor", "acceleration_over_g", "factor_of_safety"]
    """What ``solve`` would bound."""
    regions: list[SolveCheckCheckedRegion]
    """Regions of one soil after cutting; all of one soil as one where ground water flows."""
    seepage: SolveCheckSeepage | None
    """How ground water flows between given heads; null if it does not."""
    stress_kpa: float
    """Unit of stress of the solver in kPa."""
    title: str | None
    """Title of the problem; null if it has none."""


@dataclass(frozen=True, repr=False, eq=False)
class ConvertLeftOut(Record):
    """What is not in the problem.

    Attributes:
        count: How often it is there.
        is_shape: Whether it could have been ground: an area or a line.
        layer: Its layer.
        what: What it is, as the file calls it.
        why: Why.
    """

    count: int
    """How often it is there."""
    is_shape: bool
    """Whether it could have been ground: an area or a line."""
    layer: str
    """Its layer."""
    what: str
    """What it is, as the file calls it."""
    why: str
    """Why."""


@dataclass(frozen=True, repr=False, eq=False)
class ConvertSoil(Record):
    """A soil and its areas.

    Attributes:
        area_m2: Their sizes together (m2).
        areas: How many areas it has.
        has_strength: Whether its strength and weight are known; otherwise they are zero in the problem file.
        name: Its name, that of its layer.
    """

    area_m2: float
    """Their sizes together (m2)."""
    areas: int
    """How many areas it has."""
    has_strength: bool
    """Whether its strength and weight are known; otherwise they are zero in the problem file."""
    name: str
    """Its name, that of its layer."""


@dataclass(frozen=True, repr=False, eq=False)
class ConvertAnswer(Answer):
    """The answer of ``convert``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        extent_m: Least and greatest x and y (m).
        has_water: Whether there is a water table.
        is_complete: Whether nothing is to be put in before it can be solved.
        joined: How many corners were moved onto others, or put into an edge that others are on.
        left_out: What of the drawing is not in the problem.
        notes: What to do, or to keep in mind.
        soils: The soils, in the order in which they were found.
        unit: Unit of the drawing's coordinates.
    """

    schema: Literal["soilctl.convert/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    extent_m: list[list[float]]
    """Least and greatest x and y (m)."""
    has_water: bool
    """Whether there is a water table."""
    is_complete: bool
    """Whether nothing is to be put in before it can be solved."""
    joined: int
    """How many corners were moved onto others, or put into an edge that others are on."""
    left_out: list[ConvertLeftOut]
    """What of the drawing is not in the problem."""
    notes: list[str]
    """What to do, or to keep in mind."""
    soils: list[ConvertSoil]
    """The soils, in the order in which they were found."""
    unit: str
    """Unit of the drawing's coordinates."""


@dataclass(frozen=True, repr=False, eq=False)
class DesignTried(Record):
    """A value that was tried.

    Attributes:
        case: The case of the file that has not enough, or else the first that is open; null if all have enough or
            the file has no cases.
        lower: Proven lower bound, no sharper than it takes to decide, of cases the least; null if one of them has
            none.
        upper: Proven upper bound, likewise; null if none of them has one.
        value: The value, or the part of the way between two files.
        verdict: What follows.
        why: How the run ended that leaves it open, or why it could not begin; null if it is not open.
    """

    case: str | None
    """The case of the file that has not enough, or else the first that is open; null if all have enough or the file
    has no cases.
    """
    lower: float | None
    """Proven lower bound, no sharper than it takes to decide, of cases the least; null if one of them has none."""
    upper: float | None
    """Proven upper bound, likewise; null if none of them has one."""
    value: float
    """The value, or the part of the way between two files."""
    verdict: Literal["enough", "not_enough", "open"]
    """What follows."""
    why: str | None
    """How the run ended that leaves it open, or why it could not begin; null if it is not open."""


@dataclass(frozen=True, repr=False, eq=False)
class DesignAnswer(Answer):
    """The answer of ``design``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        enough_at: The value that is proven to be enough and nearest to those that are not; null if none is.
        found: How the search ended.
        not_enough_at: The value that is proven not to be enough and nearest to that; null if none is.
        parameter: What changes; null if all numbers go from one file to another, and values are parts of that way.
        quantity: What must reach it.
        seconds: Time spent in s.
        title: Title of the problem; null if it has none.
        tried: All values that were tried, in ascending order.
        verdict: The answer in a sentence.
        wanted: What the quantity must reach.
    """

    schema: Literal["soilctl.design/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    enough_at: float | None
    """The value that is proven to be enough and nearest to those that are not; null if none is."""
    found: Literal["within", "open", "both_enough", "neither_enough", "not_in_order", "undecided"]
    """How the search ended."""
    not_enough_at: float | None
    """The value that is proven not to be enough and nearest to that; null if none is."""
    parameter: str | None
    """What changes; null if all numbers go from one file to another, and values are parts of that way."""
    quantity: Literal["force_kn_per_m", "load_factor", "weight_factor", "acceleration_over_g", "factor_of_safety"]
    """What must reach it."""
    seconds: float
    """Time spent in s."""
    title: str | None
    """Title of the problem; null if it has none."""
    tried: list[DesignTried]
    """All values that were tried, in ascending order."""
    verdict: str
    """The answer in a sentence."""
    wanted: float
    """What the quantity must reach."""


@dataclass(frozen=True, repr=False, eq=False)
class StabilitySlope(Record):
    """A lower bound with the soils of one slice of a law of stress.

    Attributes:
        lower: Proven lower bound on the factor; null if none was found.
        slope_deg_per_decade: By how much their friction falls (deg a decade of stress).
    """

    lower: float | None
    """Proven lower bound on the factor; null if none was found."""
    slope_deg_per_decade: list[float]
    """By how much their friction falls (deg a decade of stress)."""


@dataclass(frozen=True, repr=False, eq=False)
class StabilityTrial(Record):
    """Bounds with one friction angle.

    Attributes:
        lower: Proven lower bound on the factor, for all densities; null if none was asked for or found.
        phi_deg: Friction angle of the soil (deg).
        upper: Proven upper bound on the factor, for all densities; null likewise.
    """

    lower: float | None
    """Proven lower bound on the factor, for all densities; null if none was asked for or found."""
    phi_deg: float
    """Friction angle of the soil (deg)."""
    upper: float | None
    """Proven upper bound on the factor, for all densities; null likewise."""


@dataclass(frozen=True, repr=False, eq=False)
class StabilityAnswer(Answer):
    """The answer of ``stability``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        answer: Whether it stands.
        by_slope: Lower bounds by slices of the law of stress; empty without a law.
        certified: Whether both bounds are proven for soils of the friction and the densities told here. That the
            soil has this friction at the stresses of the problem is what strokes or publications say, not part of
            the proof. With a law of stress the field behind the lower bound is proven with interval arithmetic for
            layers or one friction angle, and held against the law in floating point.
        cohesion_pa: Its cohesion (Pa), if it is published; null where that of the problem file is kept.
        decisive_stress_pa: Mean stress (Pa) where the field behind the lower bound leaves least of the strength;
            null without a law of stress.
        density_kg_m3: Its densities (kg/m3).
        fails_to_phi_deg: Greatest friction angle with which it is proven to fail (deg); null if none was found.
        friction_basis: Where these come from.
        gravity_m_s2: Gravity at the problem (m/s2).
        lower: Proven lower bound on the factor with every one of the soils; null if there is none.
        phi_deg: Its friction angles (deg); with a law of stress those of the field behind the lower and of the
            mechanism behind the upper bound.
        quantity: What is bounded.
        required: Least factor with which it is said to stand, or least force (kN/m) that the soil must bear.
        seconds: Time spent (s).
        slip_stress_pa: Normal stresses at which the soil slips in the problem (Pa), were its friction the same
            everywhere; null if that was not found.
        soil: The soil of the problem that was asked about.
        stands_from_phi_deg: Least friction angle with which it is proven to stand (deg); null if none was found.
        title: Title of the problem; null if it has none.
        trials: The friction angles that were tried. With a law of stress a lower bound is what the field found for
            that angle proves of the law.
        tried_stress_pa: Normal stresses at which the soil was tried by strokes and tests (Pa); null if they were
            not published.
        upper: Proven upper bound on the factor with every one of the soils; null if there is none.
        verdict: The answer in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.stability/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    answer: Literal["stands", "fails", "depends"]
    """Whether it stands."""
    by_slope: list[StabilitySlope]
    """Lower bounds by slices of the law of stress; empty without a law."""
    certified: bool
    """Whether both bounds are proven for soils of the friction and the densities told here. That the soil has this
    friction at the stresses of the problem is what strokes or publications say, not part of the proof. With a
    law of stress the field behind the lower bound is proven with interval arithmetic for layers or one friction
    angle, and held against the law in floating point.
    """
    cohesion_pa: list[float] | None
    """Its cohesion (Pa), if it is published; null where that of the problem file is kept."""
    decisive_stress_pa: float | None
    """Mean stress (Pa) where the field behind the lower bound leaves least of the strength; null without a law of
    stress.
    """
    density_kg_m3: list[float]
    """Its densities (kg/m3)."""
    fails_to_phi_deg: float | None
    """Greatest friction angle with which it is proven to fail (deg); null if none was found."""
    friction_basis: Literal["law", "same_stress", "constant"]
    """Where these come from."""
    gravity_m_s2: float
    """Gravity at the problem (m/s2)."""
    lower: float | None
    """Proven lower bound on the factor with every one of the soils; null if there is none."""
    phi_deg: list[float]
    """Its friction angles (deg); with a law of stress those of the field behind the lower and of the mechanism
    behind the upper bound.
    """
    quantity: Literal["force_kn_per_m", "load_factor", "weight_factor", "acceleration_over_g", "factor_of_safety"]
    """What is bounded."""
    required: float
    """Least factor with which it is said to stand, or least force (kN/m) that the soil must bear."""
    seconds: float
    """Time spent (s)."""
    slip_stress_pa: list[float] | None
    """Normal stresses at which the soil slips in the problem (Pa), were its friction the same everywhere; null if
    that was not found.
    """
    soil: str
    """The soil of the problem that was asked about."""
    stands_from_phi_deg: float | None
    """Least friction angle with which it is proven to stand (deg); null if none was found."""
    title: str | None
    """Title of the problem; null if it has none."""
    trials: list[StabilityTrial]
    """The friction angles that were tried. With a law of stress a lower bound is what the field found for that
    angle proves of the law.
    """
    tried_stress_pa: list[float] | None
    """Normal stresses at which the soil was tried by strokes and tests (Pa); null if they were not published."""
    upper: float | None
    """Proven upper bound on the factor with every one of the soils; null if there is none."""
    verdict: str
    """The answer in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class ClimbTrial(Record):
    """Bounds on one slope.

    Attributes:
        lower: Proven lower bound on how many times its load a strip like the wheel's contact bears, with every one
            of the soils; null if none was found.
        slope_deg: The slope (deg).
        upper: Proven upper bound on it, with every one of the soils; null if none was found.
    """

    lower: float | None
    """Proven lower bound on how many times its load a strip like the wheel's contact bears, with every one of the
    soils; null if none was found.
    """
    slope_deg: float
    """The slope (deg)."""
    upper: float | None
    """Proven upper bound on it, with every one of the soils; null if none was found."""


@dataclass(frozen=True, repr=False, eq=False)
class ClimbAnswer(Answer):
    """The answer of ``climb``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        answer: Whether it climbs the slope that was asked about; null if none was.
        climbs_to_deg: Steepest of the slopes that were tried (deg) on which every one of the soils is proven to
            bear it; null if there is none.
        cohesion_pa: Their cohesion (Pa), if it is published; null where strokes say nothing of it, and there is
            none.
        density_kg_m3: Their densities (kg/m3).
        friction_basis: Where these come from.
        gives_way_from_deg: Least of them (deg) on which every one is proven to give way; null if there is none.
        gravity_m_s2: Gravity (m/s2).
        phi_deg: Friction angles of the soils (deg).
        pressure_pa: Mean pressure under the wheel on level ground (Pa).
        seconds: Time spent (s).
        slip_stress_pa: Normal stresses (Pa) at which the soil slips under the wheel on the first slope that was
            tried, when it gives way; null if that was not found.
        steepest_deg: Steepest slope (deg) that is looked at: the weakest soil falls by itself beyond, or 60 deg.
        trials: The slopes that were tried, growing.
        tried_stress_pa: Normal stresses (Pa) at which the soil was tried by strokes and tests; null if they were
            not published.
        verdict: The answer in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.climb/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    answer: Literal["stands", "fails", "depends"] | None
    """Whether it climbs the slope that was asked about; null if none was."""
    climbs_to_deg: float | None
    """Steepest of the slopes that were tried (deg) on which every one of the soils is proven to bear it; null if
    there is none.
    """
    cohesion_pa: list[float] | None
    """Their cohesion (Pa), if it is published; null where strokes say nothing of it, and there is none."""
    density_kg_m3: list[float]
    """Their densities (kg/m3)."""
    friction_basis: Literal["law", "same_stress", "constant"]
    """Where these come from."""
    gives_way_from_deg: float | None
    """Least of them (deg) on which every one is proven to give way; null if there is none."""
    gravity_m_s2: float
    """Gravity (m/s2)."""
    phi_deg: list[float]
    """Friction angles of the soils (deg)."""
    pressure_pa: float
    """Mean pressure under the wheel on level ground (Pa)."""
    seconds: float
    """Time spent (s)."""
    slip_stress_pa: list[float] | None
    """Normal stresses (Pa) at which the soil slips under the wheel on the first slope that was tried, when it gives
    way; null if that was not found.
    """
    steepest_deg: float
    """Steepest slope (deg) that is looked at: the weakest soil falls by itself beyond, or 60 deg."""
    trials: list[ClimbTrial]
    """The slopes that were tried, growing."""
    tried_stress_pa: list[float] | None
    """Normal stresses (Pa) at which the soil was tried by strokes and tests; null if they were not published."""
    verdict: str
    """The answer in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class SoilsSoil(Record):
    """A soil, and who published what about it. Friction and cohesion are those of one straight line of strength,
    fitted together.

    Attributes:
        body: Where it lies.
        cohesion_pa: Least and greatest cohesion (Pa).
        density_kg_m3: Least and greatest bulk density (kg/m3).
        gravity_m_s2: Gravity there (m/s2).
        method: How it was tested, or what it was concluded from.
        name: Its name here.
        note: What to keep in mind, such as what of it is not from this source.
        phi_deg: Least and greatest friction angle (deg).
        source: Where it was published.
        stress_pa: Normal stresses of the tests (Pa); null if they were not published.
        title: What it is.
    """

    body: Literal["earth", "moon", "mars"]
    """Where it lies."""
    cohesion_pa: list[float]
    """Least and greatest cohesion (Pa)."""
    density_kg_m3: list[float]
    """Least and greatest bulk density (kg/m3)."""
    gravity_m_s2: float
    """Gravity there (m/s2)."""
    method: str
    """How it was tested, or what it was concluded from."""
    name: str
    """Its name here."""
    note: str
    """What to keep in mind, such as what of it is not from this source."""
    phi_deg: list[float]
    """Least and greatest friction angle (deg)."""
    source: str
    """Where it was published."""
    stress_pa: list[float] | None
    """Normal stresses of the tests (Pa); null if they were not published."""
    title: str
    """What it is."""


@dataclass(frozen=True, repr=False, eq=False)
class SoilsAnswer(Answer):
    """The answer of ``soils``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        soils: In the order of the file: by body, then by name.
    """

    schema: Literal["soilctl.soils/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    soils: list[SoilsSoil]
    """In the order of the file: by body, then by name."""


@dataclass(frozen=True, repr=False, eq=False)
class CertifyChecked(Record):
    """One bound.

    Attributes:
        claimed: What the file claims.
        confirmed: Whether the proof reaches the claim.
        proven: What is proven, whatever is claimed; null if the field proves nothing.
        refusal: Why the field proves nothing; null if it does.
    """

    claimed: float
    """What the file claims."""
    confirmed: bool
    """Whether the proof reaches the claim."""
    proven: float | None
    """What is proven, whatever is claimed; null if the field proves nothing."""
    refusal: str | None
    """Why the field proves nothing; null if it does."""


@dataclass(frozen=True, repr=False, eq=False)
class CertifySaid(Record):
    """One thing that a statement says.

    Attributes:
        of: What of: ``soil``, ``gravity``, ``surface``, ``line``, ``member``, ``width``, ``bounded``, ``units``.
        says: What it says.
    """

    of: str
    """What of: ``soil``, ``gravity``, ``surface``, ``line``, ``member``, ``width``, ``bounded``, ``units``."""
    says: str
    """What it says."""


@dataclass(frozen=True, repr=False, eq=False)
class CertifyAnswer(Answer):
    """The answer of ``certify``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        certified: Whether every claim in the file is proven.
        description: What the file calls the problem, which nothing proves.
        files: Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
        lower: The lower bound; null if the file has none.
        statement: What the bounds are of, read from the statement that was proven.
        upper: The upper bound; null if the file has none.
        width: Width of the structure in the units of the file, where its ends are part of the problem; null in
            plane strain.
    """

    schema: Literal["soilctl.certify/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    certified: bool
    """Whether every claim in the file is proven."""
    description: str | None
    """What the file calls the problem, which nothing proves."""
    files: list[str]
    """Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given."""
    lower: CertifyChecked | None
    """The lower bound; null if the file has none."""
    statement: list[CertifySaid]
    """What the bounds are of, read from the statement that was proven."""
    upper: CertifyChecked | None
    """The upper bound; null if the file has none."""
    width: float | None
    """Width of the structure in the units of the file, where its ends are part of the problem; null in plane
    strain.
    """


@dataclass(frozen=True, repr=False, eq=False)
class TableBracketCell(Record):
    """A bracket at a node.

    Attributes:
        alpha_deg: Tool angle.
        certified: Whether both bounds are proven.
        delta_deg: Interface friction angle.
        ends_lower: Lower bound for plates with ends, of every width; null if the table does not know.
        ends_term: What a depth over width of one adds to that; null likewise.
        ends_upper: Upper bound for plates with ends, as the width goes to infinity; null likewise.
        gap: ``(U - L) / ((U + L) / 2)``.
        lower: Lower bound on the net coefficient per slant length.
        lower_elements: Triangles behind the lower bound.
        phi_deg: Friction angle.
        status: ``solved`` or ``interpolated``.
        upper: Upper bound on it.
        upper_elements: Triangles behind the upper bound.
    """

    alpha_deg: float
    """Tool angle."""
    certified: bool
    """Whether both bounds are proven."""
    delta_deg: float
    """Interface friction angle."""
    ends_lower: float | None
    """Lower bound for plates with ends, of every width; null if the table does not know."""
    ends_term: float | None
    """What a depth over width of one adds to that; null likewise."""
    ends_upper: float | None
    """Upper bound for plates with ends, as the width goes to infinity; null likewise."""
    gap: float
    """``(U - L) / ((U + L) / 2)``."""
    lower: float
    """Lower bound on the net coefficient per slant length."""
    lower_elements: int
    """Triangles behind the lower bound."""
    phi_deg: float
    """Friction angle."""
    status: str
    """``solved`` or ``interpolated``."""
    upper: float
    """Upper bound on it."""
    upper_elements: int
    """Triangles behind the upper bound."""


@dataclass(frozen=True, repr=False, eq=False)
class TableBracketFindings(Record):
    """What was found in a table of brackets, beside its growth.

    Attributes:
        contradicted: Bounds of another table that contradict a bracket.
        crossed: Nodes at which the lower bound is above the upper bound: alpha, phi and delta in degrees.
        gaps: Its gaps; null for an empty table.
    """

    contradicted: list[TableContradiction]
    """Bounds of another table that contradict a bracket."""
    crossed: list[list[float]]
    """Nodes at which the lower bound is above the upper bound: alpha, phi and delta in degrees."""
    gaps: TableGaps | None
    """Its gaps; null for an empty table."""


@dataclass(frozen=True, repr=False, eq=False)
class TableBuiltBounds(Record):
    """How far a table of bounds was built.

    Attributes:
        cases: Cases of the grid, or of the shard.
        empty: Cases without an answer.
        file: The table if it is finished, otherwise, or if no table was asked for, the journal or store from which
            the next run goes on.
        finished: Whether every case is done and the file, if one was asked for, is written.
        gaps: Its gaps; null while there is no case.
        table: What is in the table.
    """

    cases: int
    """Cases of the grid, or of the shard."""
    empty: list[TableEmptyNode]
    """Cases without an answer."""
    file: str
    """The table if it is finished, otherwise, or if no table was asked for, the journal or store from which the
    next run goes on.
    """
    finished: bool
    """Whether every case is done and the file, if one was asked for, is written."""
    gaps: TableGaps | None
    """Its gaps; null while there is no case."""
    table: TableHead
    """What is in the table."""


@dataclass(frozen=True, repr=False, eq=False)
class TableContradiction(Record):
    """A bound of another table that contradicts a bracket.

    Attributes:
        bound: Its bound.
        node: Node: alpha, phi and delta in degrees.
        proven: The bound of the bracket that it contradicts.
        table: The other table.
    """

    bound: float
    """Its bound."""
    node: list[float]
    """Node: alpha, phi and delta in degrees."""
    proven: float
    """The bound of the bracket that it contradicts."""
    table: str
    """The other table."""


@dataclass(frozen=True, repr=False, eq=False)
class TableEmptyNode(Record):
    """A case without an answer.

    Attributes:
        node: Alpha, phi and delta in degrees.
        reason: Why there is none.
    """

    node: list[float]
    """Alpha, phi and delta in degrees."""
    reason: str
    """Why there is none."""


@dataclass(frozen=True, repr=False, eq=False)
class TableGaps(Record):
    """How wide the brackets of a table are.

    Attributes:
        max_elements: Most elements that a case was given.
        max_gap: Gap at which a case was done.
        mean: Mean of the gaps.
        over_max_gap: Cases that ran out of elements before they reached the gap.
        uncertified: Brackets that are not proven.
        widest: The widest gap.
        widest_at: Where it is: alpha, phi and delta in degrees.
    """

    max_elements: int
    """Most elements that a case was given."""
    max_gap: float
    """Gap at which a case was done."""
    mean: float
    """Mean of the gaps."""
    over_max_gap: int
    """Cases that ran out of elements before they reached the gap."""
    uncertified: int
    """Brackets that are not proven."""
    widest: float
    """The widest gap."""
    widest_at: list[float]
    """Where it is: alpha, phi and delta in degrees."""


@dataclass(frozen=True, repr=False, eq=False)
class TableHead(Record):
    """What a table is.

    Attributes:
        alpha_deg: Nodes of the tool angle.
        delta_deg: Nodes of the interface friction angle.
        filled: Number of filled cells.
        interpolated: Of these, cells that were interpolated when the table was made.
        name: Name.
        nodes: Number of nodes.
        phi_deg: Nodes of the friction angle.
        quantity: ``estimate``, ``lower-bound``, ``upper-bound`` or ``bracket``.
        source: Where the numbers come from.
    """

    alpha_deg: list[float]
    """Nodes of the tool angle."""
    delta_deg: list[float]
    """Nodes of the interface friction angle."""
    filled: int
    """Number of filled cells."""
    interpolated: int
    """Of these, cells that were interpolated when the table was made."""
    name: str
    """Name."""
    nodes: int
    """Number of nodes."""
    phi_deg: list[float]
    """Nodes of the friction angle."""
    quantity: str
    """``estimate``, ``lower-bound``, ``upper-bound`` or ``bracket``."""
    source: str
    """Where the numbers come from."""


@dataclass(frozen=True, repr=False, eq=False)
class TablePlan(Record):
    """What a build would do.

    Attributes:
        cases: Cases of the grid, or of the shard.
        done: Of these, done already.
        measured: Number of cases of this table whose measured times the estimate rests on; 0: on times measured
            elsewhere.
        seconds: Estimated time for all that is left in s.
        seconds_per_case: Estimated time a case in s.
        threads: Cases solved at a time.
    """

    cases: int
    """Cases of the grid, or of the shard."""
    done: int
    """Of these, done already."""
    measured: int
    """Number of cases of this table whose measured times the estimate rests on; 0: on times measured elsewhere."""
    seconds: float
    """Estimated time for all that is left in s."""
    seconds_per_case: float
    """Estimated time a case in s."""
    threads: int
    """Cases solved at a time."""


@dataclass(frozen=True, repr=False, eq=False)
class TableCell(Record):
    """A filled cell.

    Attributes:
        alpha_deg: Tool angle.
        delta_deg: Interface friction angle.
        k_net: Net coefficient per slant length.
        phi_deg: Friction angle.
        status: ``solved`` or ``interpolated``.
    """

    alpha_deg: float
    """Tool angle."""
    delta_deg: float
    """Interface friction angle."""
    k_net: float
    """Net coefficient per slant length."""
    phi_deg: float
    """Friction angle."""
    status: str
    """``solved`` or ``interpolated``."""


@dataclass(frozen=True, repr=False, eq=False)
class TableViolation(Record):
    """Two neighbouring cells between which the coefficient does not grow.

    Attributes:
        along: The angle that grows: alpha, phi or delta.
        from_: First node: alpha, phi and delta in degrees.
        k_from: Coefficient at the first node; of a bracket, its lower bound.
        k_to: Coefficient at the second node; of a bracket, its upper bound.
        to: Second node.
    """

    along: str
    """The angle that grows: alpha, phi or delta."""
    from_: list[float] = field(metadata={"key": "from"})
    """First node: alpha, phi and delta in degrees."""
    k_from: float
    """Coefficient at the first node; of a bracket, its lower bound."""
    k_to: float
    """Coefficient at the second node; of a bracket, its upper bound."""
    to: list[float]
    """Second node."""


@dataclass(frozen=True, repr=False, eq=False)
class TableAnswer(Answer):
    """The answer of ``table_show``, ``table_build``, ``table_merge``, ``table_check``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        action: See its type.
        cells: Filled cells, by alpha, then phi, then delta.
        table: The table.
        gaps: Its gaps; null for an empty table.
        file: File that was written; its description is beside it, with ``.json`` added to the name.
        first_refusal: What the model said about the first node it has no answer for.
        cases: Cases of the grid, or of the shard.
        empty: Cases without an answer.
        finished: Whether every case is done and the file, if one was asked for, is written.
        done: Of these, done already.
        measured: Number of cases of this table whose measured times the estimate rests on; 0: on times measured
            elsewhere.
        seconds: Estimated time for all that is left in s.
        seconds_per_case: Estimated time a case in s.
        threads: Cases solved at a time.
        brackets: What else was checked of brackets; null for a table with one number a node.
        consistent: Whether nothing was found against it.
        empty_nodes: Nodes with delta up to phi that are not filled: alpha, phi and delta in degrees.
        violations: Neighbouring cells between which the coefficient does not grow, wherever it lies in a bracket.
    """

    schema: Literal["soilctl.table/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    action: Literal["show", "build", "plan", "merge", "check"]
    """See its type."""
    cells: list[TableCell] | list[TableBracketCell] | None = None
    """Filled cells, by alpha, then phi, then delta."""
    table: TableHead | None = None
    """The table."""
    gaps: TableGaps | None = None
    """Its gaps; null for an empty table."""
    file: str | None = None
    """File that was written; its description is beside it, with ``.json`` added to the name."""
    first_refusal: str | None = None
    """What the model said about the first node it has no answer for."""
    cases: int | None = None
    """Cases of the grid, or of the shard."""
    empty: list[TableEmptyNode] | None = None
    """Cases without an answer."""
    finished: bool | None = None
    """Whether every case is done and the file, if one was asked for, is written."""
    done: int | None = None
    """Of these, done already."""
    measured: int | None = None
    """Number of cases of this table whose measured times the estimate rests on; 0: on times measured elsewhere."""
    seconds: float | None = None
    """Estimated time for all that is left in s."""
    seconds_per_case: float | None = None
    """Estimated time a case in s."""
    threads: int | None = None
    """Cases solved at a time."""
    brackets: TableBracketFindings | None = None
    """What else was checked of brackets; null for a table with one number a node."""
    consistent: bool | None = None
    """Whether nothing was found against it."""
    empty_nodes: list[list[float]] | None = None
    """Nodes with delta up to phi that are not filled: alpha, phi and delta in degrees."""
    violations: list[TableViolation] | None = None
    """Neighbouring cells between which the coefficient does not grow, wherever it lies in a bracket."""


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
class EstimateCost(Record):
    """What an unknown costs.

    Attributes:
        density_width_kg_m3: Width of the range of the density if it is known (kg/m3); null if no soil is consistent
            then.
        name: The unknown.
        phi_width_deg: Width of the range of the friction angle if it is known (deg); null if no soil is consistent
            then.
        value: The value at which it is taken as known: the middle of what the measurements leave of it.
    """

    density_width_kg_m3: float | None
    """Width of the range of the density if it is known (kg/m3); null if no soil is consistent then."""
    name: Literal["phi_deg", "delta_deg", "beta_deg", "density_kg_m3", "cohesion_pa", "adhesion_pa", "surcharge_pa"]
    """The unknown."""
    phi_width_deg: float | None
    """Width of the range of the friction angle if it is known (deg); null if no soil is consistent then."""
    value: float
    """The value at which it is taken as known: the middle of what the measurements leave of it."""


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
class EstimateLaw(Record):
    """Friction as a law of stress: ``phi = phi_ref - slope log10(sigma / sigma_ref)``, and the soils that have it.

    Attributes:
        plates_alone: What the strokes say without the tests in direct shear; null without such tests.
        shear_alone: What the tests in direct shear say without the strokes; null without such tests, or if no law
            of the known slopes passes through all.
        shear_tests: Tests in direct shear that were taken.
        slices: The consistent soils by slices of the slope, growing; empty if there are none.
        slope_deg_per_decade: Consistent slopes (deg a decade); null if no soil is consistent.
        slope_known_deg_per_decade: What was known of the slope (deg a decade).
    """

    plates_alone: EstimateLawRange | None
    """What the strokes say without the tests in direct shear; null without such tests."""
    shear_alone: EstimateLawRange | None
    """What the tests in direct shear say without the strokes; null without such tests, or if no law of the known
    slopes passes through all.
    """
    shear_tests: list[EstimateShearTest]
    """Tests in direct shear that were taken."""
    slices: list[EstimateLawSlice]
    """The consistent soils by slices of the slope, growing; empty if there are none."""
    slope_deg_per_decade: list[float] | None
    """Consistent slopes (deg a decade); null if no soil is consistent."""
    slope_known_deg_per_decade: list[float]
    """What was known of the slope (deg a decade)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateLawRange(Record):
    """Ranges of the unknowns of a law.

    Attributes:
        phi_deg: Friction angle at the reference stress (deg).
        slope_deg_per_decade: Slope (deg a decade).
    """

    phi_deg: list[float]
    """Friction angle at the reference stress (deg)."""
    slope_deg_per_decade: list[float]
    """Slope (deg a decade)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateLawSlice(Record):
    """The consistent soils whose slope is in a slice.

    Attributes:
        density_kg_m3: Range of the density (kg/m3).
        phi_deg: Range of the friction angle at the reference stress (deg).
        region: Consistent [phi at the reference stress, density]: polygons, each an outer ring and its holes.
        slope_deg_per_decade: Slopes of the slice (deg a decade).
    """

    density_kg_m3: list[float]
    """Range of the density (kg/m3)."""
    phi_deg: list[float]
    """Range of the friction angle at the reference stress (deg)."""
    region: list[list[list[list[float]]]]
    """Consistent [phi at the reference stress, density]: polygons, each an outer ring and its holes."""
    slope_deg_per_decade: list[float]
    """Slopes of the slice (deg a decade)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateLeftOut(Record):
    """A stroke that does not count.

    Attributes:
        line: Its line in the stroke table.
        reason: Why.
        stroke_id: Its name; null if it has none.
    """

    line: int
    """Its line in the stroke table."""
    reason: str
    """Why."""
    stroke_id: str | None
    """Its name; null if it has none."""


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
        pooled: How the band came about, where strokes of one kind are taken together; otherwise null.
        slip_stress_pa: Equivalent normal stress on its slip surfaces (Pa), at which the soil has the friction that
            it measured; null if no soil is consistent, or no mechanism fits the tool angle, or loads or slope are
            unknowns.
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
    pooled: EstimatePooled | None
    """How the band came about, where strokes of one kind are taken together; otherwise null."""
    slip_stress_pa: list[float] | None
    """Equivalent normal stress on its slip surfaces (Pa), at which the soil has the friction that it measured; null
    if no soil is consistent, or no mechanism fits the tool angle, or loads or slope are unknowns.
    """
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
        width_m: Plate width (m).
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
    width_m: float
    """Plate width (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimatePair(Record):
    """What is left of two quantities together.

    Attributes:
        polygons: Consistent [x, y]: polygons, each an outer ring and its holes. Of two quantities that are no
            angles it is the convex hull.
        x: The first coordinate of its points.
        y: The second one.
    """

    polygons: list[list[list[list[float]]]]
    """Consistent [x, y]: polygons, each an outer ring and its holes. Of two quantities that are no angles it is the
    convex hull.
    """
    x: Literal["phi_deg", "delta_deg", "beta_deg", "density_kg_m3", "cohesion_pa", "adhesion_pa", "surcharge_pa"]
    """The first coordinate of its points."""
    y: Literal["phi_deg", "delta_deg", "beta_deg", "density_kg_m3", "cohesion_pa", "adhesion_pa", "surcharge_pa"]
    """The second one."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimatePlaneStrain(Record):
    """What the same measurements say if ends are forgotten: plates as parts of endless ones.

    Attributes:
        consistent: Whether any soil explains all measurements.
        density_kg_m3: Range of the density (kg/m3); null if inconsistent.
        phi_deg: Range of the friction angle (deg); null if inconsistent.
        region: Consistent [phi, density]: polygons, each an outer ring and its holes.
    """

    consistent: bool
    """Whether any soil explains all measurements."""
    density_kg_m3: list[float] | None
    """Range of the density (kg/m3); null if inconsistent."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg); null if inconsistent."""
    region: list[list[list[list[float]]]]
    """Consistent [phi, density]: polygons, each an outer ring and its holes."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimatePoint(Record):
    """A single soil.

    Attributes:
        delta_deg: Interface friction (deg).
        density_kg_m3: Bulk density (kg/m3).
        misfit: Sum of squared relative force errors (Hong 2001, eq. 7.1).
        phi_deg: Friction angle (deg).
        slope_deg_per_decade: Fall of the friction angle (deg a decade of stress); null without a law of stress.
    """

    delta_deg: float
    """Interface friction (deg)."""
    density_kg_m3: float
    """Bulk density (kg/m3)."""
    misfit: float
    """Sum of squared relative force errors (Hong 2001, eq. 7.1)."""
    phi_deg: float
    """Friction angle (deg)."""
    slope_deg_per_decade: float | None
    """Fall of the friction angle (deg a decade of stress); null without a law of stress."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimatePooled(Record):
    """How a band of strokes of one kind came about. Deviations are relative.

    Attributes:
        common: Standard deviation of what the strokes share: the sensor's gain, the datum of depths, density, the
            soil ahead.
        deviations: So many of both together the band reaches on either side, in the logarithm of the force.
        mean: Standard error of the mean.
        scatter: Standard deviation of one stroke by the scatter of these; null of a single stroke.
        stated: Standard deviation of one stroke by what the table says of force, depth and friction on the plate;
            null if it says nothing.
    """

    common: float
    """Standard deviation of what the strokes share: the sensor's gain, the datum of depths, density, the soil
    ahead.
    """
    deviations: float
    """So many of both together the band reaches on either side, in the logarithm of the force."""
    mean: float
    """Standard error of the mean."""
    scatter: float | None
    """Standard deviation of one stroke by the scatter of these; null of a single stroke."""
    stated: float | None
    """Standard deviation of one stroke by what the table says of force, depth and friction on the plate; null if it
    says nothing.
    """


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
class EstimateShearTest(Record):
    """A test in direct shear.

    Attributes:
        friction_deg: Friction angles that it allows (deg).
        stress_pa: Normal stress (Pa).
    """

    friction_deg: list[float]
    """Friction angles that it allows (deg)."""
    stress_pa: float
    """Normal stress (Pa)."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateUnknown(Record):
    """A quantity that is not known.

    Attributes:
        known: What was known of it.
        name: Its name, which ends with its unit.
        range: What the measurements leave of it; null if no soil is consistent.
    """

    known: list[float]
    """What was known of it."""
    name: Literal["phi_deg", "delta_deg", "beta_deg", "density_kg_m3", "cohesion_pa", "adhesion_pa", "surcharge_pa"]
    """Its name, which ends with its unit."""
    range: list[float] | None
    """What the measurements leave of it; null if no soil is consistent."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateUnknowns(Record):
    """What is left of all unknowns together.

    Attributes:
        costs: What each unknown costs; null unless asked for.
        pairs: What is left of each pair of them; empty if no soil is consistent.
        quantities: The quantities that are not known.
    """

    costs: list[EstimateCost] | None
    """What each unknown costs; null unless asked for."""
    pairs: list[EstimatePair]
    """What is left of each pair of them; empty if no soil is consistent."""
    quantities: list[EstimateUnknown]
    """The quantities that are not known."""


@dataclass(frozen=True, repr=False, eq=False)
class EstimateAnswer(Answer):
    """The answer of ``estimate``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        area_deg_kg_m3: Area of the region (deg kg/m3).
        best_estimate: Soil of least misfit inside the region; null where loads or slope are unknowns.
        centre: Centroid of the region.
        confidence: Probability with which all bands together hold their true forces; null if strokes of one kind
            are not taken together.
        confidence_each: Probability of each band, by Šidák's correction; null if strokes of one kind are not taken
            together.
        consistent: Whether any soil explains all measurements.
        cut_by: Limits of the search that the region touches: it may reach further.
        delta_deg: What was known of delta (deg).
        delta_density: Consistent [delta, density], the same form; empty if delta is known exactly.
        density_kg_m3: Range of the density (kg/m3) over the whole interval of delta; null if inconsistent.
        density_known_kg_m3: What was known of the density (kg/m3).
        disagreement: What breaks consistency; null if nothing does.
        end_factor: Consistent values of the end factor that strokes share, the part of what ends add at most; null
            if they share none, or no soil is consistent.
        ends: Whether plates have ends.
        exact: Results for exact data; null unless ``--exact``.
        friction_law: Friction as a law of stress; null unless asked for.
        gravity_m_s2: Gravity (m/s2) under which the strokes were made.
        left_out: Strokes in which the soil did not fail as models have it; empty unless strokes of one kind are
            taken together.
        measurements: The measurements.
        model: Force model.
        next_strokes: Strokes that would shrink the region most, the best first; null if not asked for.
        optimisers: What local optimisers find; null if not asked for.
        phi_deg: Range of the friction angle (deg) over the whole interval of delta; null if inconsistent. With a
            law of stress it is that at ``reference_stress_pa``, otherwise that at the stresses of
            ``slip_stress_pa``.
        phi_delta: Consistent [phi, delta], the same form; empty if delta is known exactly.
        plane_strain: The same without ends, for comparison; null if plates have none, and for exact data.
        reference_stress_pa: Normal stress (Pa) at which ``phi_deg`` holds under a law of stress; null without one.
        region: Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi,
            density].
        regions: Sections at chosen deltas; empty if inconsistent, or where loads or slope are unknowns.
        scatter_over_stated: Scatter of repeated strokes over what the table states of them; above 1 the bands are
            wider for it. Null if nothing was repeated, stated, or taken together.
        slip_stress_pa: Least and greatest normal stress (Pa) on slip surfaces of all strokes; null as that of a
            measurement.
        unknowns: What is left of cohesion, adhesion, surcharge, slope and all others together; null if those four
            are known.
        verdict: The result in words.
        volume_deg2_kg_m3: Volume of the consistent set (deg2 kg/m3); null with a law of stress or other unknowns
            more.
        warnings: What to keep in mind.
        width_ratio: Least and greatest width of a plate over its vertical depth.
    """

    schema: Literal["soilctl.estimate/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    area_deg_kg_m3: float
    """Area of the region (deg kg/m3)."""
    best_estimate: EstimatePoint | None
    """Soil of least misfit inside the region; null where loads or slope are unknowns."""
    centre: EstimateCentre | None
    """Centroid of the region."""
    confidence: float | None
    """Probability with which all bands together hold their true forces; null if strokes of one kind are not taken
    together.
    """
    confidence_each: float | None
    """Probability of each band, by Šidák's correction; null if strokes of one kind are not taken together."""
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
    end_factor: list[float] | None
    """Consistent values of the end factor that strokes share, the part of what ends add at most; null if they share
    none, or no soil is consistent.
    """
    ends: Literal["finite", "none"]
    """Whether plates have ends."""
    exact: EstimateExact | None
    """Results for exact data; null unless ``--exact``."""
    friction_law: EstimateLaw | None
    """Friction as a law of stress; null unless asked for."""
    gravity_m_s2: float
    """Gravity (m/s2) under which the strokes were made."""
    left_out: list[EstimateLeftOut]
    """Strokes in which the soil did not fail as models have it; empty unless strokes of one kind are taken
    together.
    """
    measurements: list[EstimateMeasured]
    """The measurements."""
    model: str
    """Force model."""
    next_strokes: list[EstimateNextStroke] | None
    """Strokes that would shrink the region most, the best first; null if not asked for."""
    optimisers: list[EstimateMinimum] | None
    """What local optimisers find; null if not asked for."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg) over the whole interval of delta; null if inconsistent. With a law of
    stress it is that at ``reference_stress_pa``, otherwise that at the stresses of ``slip_stress_pa``.
    """
    phi_delta: list[list[list[list[float]]]]
    """Consistent [phi, delta], the same form; empty if delta is known exactly."""
    plane_strain: EstimatePlaneStrain | None
    """The same without ends, for comparison; null if plates have none, and for exact data."""
    reference_stress_pa: float | None
    """Normal stress (Pa) at which ``phi_deg`` holds under a law of stress; null without one."""
    region: list[list[list[list[float]]]]
    """Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi, density]."""
    regions: list[EstimateSection]
    """Sections at chosen deltas; empty if inconsistent, or where loads or slope are unknowns."""
    scatter_over_stated: float | None
    """Scatter of repeated strokes over what the table states of them; above 1 the bands are wider for it. Null if
    nothing was repeated, stated, or taken together.
    """
    slip_stress_pa: list[float] | None
    """Least and greatest normal stress (Pa) on slip surfaces of all strokes; null as that of a measurement."""
    unknowns: EstimateUnknowns | None
    """What is left of cohesion, adhesion, surcharge, slope and all others together; null if those four are known.
    """
    verdict: str
    """The result in words."""
    volume_deg2_kg_m3: float | None
    """Volume of the consistent set (deg2 kg/m3); null with a law of stress or other unknowns more."""
    warnings: list[str]
    """What to keep in mind."""
    width_ratio: list[float]
    """Least and greatest width of a plate over its vertical depth."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesBetween(Record):
    """What lies between places.

    Attributes:
        cell_m: Side of a cell (m).
        cells: Cells, along x first.
        density_covariances: Covariances of the density (kg/m3).
        deviations: Standard deviations that an interval reaches beyond what places know.
        hull: Convex hull of the places: [x, y] (m).
        is_variation_open: Whether the greatest variation over the ground that was tried, fifteen times that of the
            places, is still plausible: then it may be more, and intervals wider.
        next_places: Where a further place would tell most, the best first: [x, y] (m).
        phi_covariances: Covariances of the friction angle (deg).
    """

    cell_m: float
    """Side of a cell (m)."""
    cells: list[PlacesCell]
    """Cells, along x first."""
    density_covariances: list[PlacesCovariance]
    """Covariances of the density (kg/m3)."""
    deviations: float
    """Standard deviations that an interval reaches beyond what places know."""
    hull: list[list[float]]
    """Convex hull of the places: [x, y] (m)."""
    is_variation_open: bool
    """Whether the greatest variation over the ground that was tried, fifteen times that of the places, is still
    plausible: then it may be more, and intervals wider.
    """
    next_places: list[list[float]]
    """Where a further place would tell most, the best first: [x, y] (m)."""
    phi_covariances: list[PlacesCovariance]
    """Covariances of the friction angle (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesCell(Record):
    """A cell of the ground.

    Attributes:
        density_kg_m3: Range of the density (kg/m3) at its middle.
        density_sd_kg_m3: The same of the density (kg/m3).
        inside: Whether it is among the places, in their convex hull; beyond it the ground is carried on, not
            interpolated.
        phi_deg: Range of the friction angle (deg) at its middle.
        phi_sd_deg: Standard deviation of what kriging errs by in the friction angle (deg), at most.
        x_m: Its middle along x (m).
        y_m: Its middle along y (m).
    """

    density_kg_m3: list[float]
    """Range of the density (kg/m3) at its middle."""
    density_sd_kg_m3: float
    """The same of the density (kg/m3)."""
    inside: bool
    """Whether it is among the places, in their convex hull; beyond it the ground is carried on, not interpolated.
    """
    phi_deg: list[float]
    """Range of the friction angle (deg) at its middle."""
    phi_sd_deg: float
    """Standard deviation of what kriging errs by in the friction angle (deg), at most."""
    x_m: float
    """Its middle along x (m)."""
    y_m: float
    """Its middle along y (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesCovariance(Record):
    """A covariance ``sd^2 exp(-distance / length)`` that the places leave plausible.

    Attributes:
        length_m: Its length (m).
        sd: Greatest plausible standard deviation over the ground for that length, in the unit of the quantity.
    """

    length_m: float
    """Its length (m)."""
    sd: float
    """Greatest plausible standard deviation over the ground for that length, in the unit of the quantity."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesGroup(Record):
    """Places whose soils are not found to differ, together.

    Attributes:
        density_kg_m3: Range of the density (kg/m3) if they have one soil.
        phi_deg: Range of the friction angle (deg) if they have one soil.
        places: Their names.
        region: Consistent [phi, density] if they have one soil, as that of a place.
    """

    density_kg_m3: list[float]
    """Range of the density (kg/m3) if they have one soil."""
    phi_deg: list[float]
    """Range of the friction angle (deg) if they have one soil."""
    places: list[str]
    """Their names."""
    region: list[list[list[list[float]]]]
    """Consistent [phi, density] if they have one soil, as that of a place."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesPair(Record):
    """Two places beside each other.

    Attributes:
        by: What they were compared by.
        differ: Whether the soils differ.
        force_ratio: Forces at the first over those at the second, of strokes of one kind: their geometric mean;
            null without such strokes.
        kinds: Kinds of strokes that both have.
        p: Probability that places of one soil differ so much by chance, at most; null without a probability.
        places: Their names.
        tellable_ratio: Least ratio above 1 that would have been told as a difference, of this pair alone; null
            without a probability.
    """

    by: Literal["forces", "sets", "nothing"]
    """What they were compared by."""
    differ: bool
    """Whether the soils differ."""
    force_ratio: float | None
    """Forces at the first over those at the second, of strokes of one kind: their geometric mean; null without such
    strokes.
    """
    kinds: int
    """Kinds of strokes that both have."""
    p: float | None
    """Probability that places of one soil differ so much by chance, at most; null without a probability."""
    places: list[str]
    """Their names."""
    tellable_ratio: float | None
    """Least ratio above 1 that would have been told as a difference, of this pair alone; null without a
    probability.
    """


@dataclass(frozen=True, repr=False, eq=False)
class PlacesPlaceFound(Record):
    """What was found at a place.

    Attributes:
        consistent: Whether any soil explains all of them.
        delta_deg: What is known of the friction on the plate there (deg).
        density_kg_m3: Range of the density (kg/m3); null if inconsistent.
        group: Place of its group in ``groups``, from 0; null if inconsistent.
        name: Its name.
        phi_deg: Range of the friction angle (deg); null if inconsistent.
        region: Consistent [phi, density]: polygons, each an outer ring and its holes.
        strokes: Its strokes.
        x_m: Where it is along x (m); null if the table does not say.
        y_m: Where it is along y (m).
    """

    consistent: bool
    """Whether any soil explains all of them."""
    delta_deg: list[float]
    """What is known of the friction on the plate there (deg)."""
    density_kg_m3: list[float] | None
    """Range of the density (kg/m3); null if inconsistent."""
    group: int | None
    """Place of its group in ``groups``, from 0; null if inconsistent."""
    name: str
    """Its name."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg); null if inconsistent."""
    region: list[list[list[list[float]]]]
    """Consistent [phi, density]: polygons, each an outer ring and its holes."""
    strokes: int
    """Its strokes."""
    x_m: float | None
    """Where it is along x (m); null if the table does not say."""
    y_m: float | None
    """Where it is along y (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class PlacesAnswer(Answer):
    """The answer of ``places``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        between: What lies between places; null if they are too few or have no coordinates.
        confidence: Probability with which the set of a place holds its soil; null for bounds, which hold it for
            sure.
        ends: Whether plates have ends.
        false_discovery: Part of the differences that are told which may be none; null for bounds.
        groups: Groups of places whose soils are not found to differ.
        model: Force model.
        pairs: Pairs of places.
        places: Places in the order in which they first appear.
        verdict: The result in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.places/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    between: PlacesBetween | None
    """What lies between places; null if they are too few or have no coordinates."""
    confidence: float | None
    """Probability with which the set of a place holds its soil; null for bounds, which hold it for sure."""
    ends: Literal["finite", "none"]
    """Whether plates have ends."""
    false_discovery: float | None
    """Part of the differences that are told which may be none; null for bounds."""
    groups: list[PlacesGroup]
    """Groups of places whose soils are not found to differ."""
    model: str
    """Force model."""
    pairs: list[PlacesPair]
    """Pairs of places."""
    places: list[PlacesPlaceFound]
    """Places in the order in which they first appear."""
    verdict: str
    """The result in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileAlias(Record):
    """One soil of another kind, which looks like ground that changes.

    Attributes:
        allowed: What was allowed, in the unit of the alias: degrees a decade of stress, or Pa.
        consistent: Whether it explains all strokes; null if it was not asked, for the model has no such term.
        left: What the strokes leave of that; null if it explains nothing, or one soil without it explains them, so
            that it was not asked.
        phi_deg: Range of the friction angle (deg) then, under a law of stress at its reference; null as before.
    """

    allowed: list[float]
    """What was allowed, in the unit of the alias: degrees a decade of stress, or Pa."""
    consistent: bool | None
    """Whether it explains all strokes; null if it was not asked, for the model has no such term."""
    left: list[float] | None
    """What the strokes leave of that; null if it explains nothing, or one soil without it explains them, so that it
    was not asked.
    """
    phi_deg: list[float] | None
    """Range of the friction angle (deg) then, under a law of stress at its reference; null as before."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileHypothesis(Record):
    """A way in which ground may go with depth, and what the strokes leave of it.

    Attributes:
        consistent: Whether some such ground explains all strokes.
        is_certain: Whether that is for sure: false if the search ended before it found one, and before all were
            excluded.
        is_sharp: Whether ranges are as narrow as the data allow, to 0.25 deg and 20 kg/m3; otherwise the search
            ended before, and they are wider.
        kind: The way.
        p: Probability that strokes in such ground are so far off by chance, at most; null if it is consistent, and
            for bounds.
        profile: Ranges over depth, from the surface to the deepest stroke; empty if inconsistent.
        ranges: What is left; null if inconsistent.
        slices: What is left for steps at depths of an interval, growing; empty for other kinds.
        step_m: Depth of the step (m); null if inconsistent, and of other kinds.
        widening: By which factor bands must be widened until some such ground explains them; 1 if it does, null if
            not even ten is enough.
    """

    consistent: bool
    """Whether some such ground explains all strokes."""
    is_certain: bool
    """Whether that is for sure: false if the search ended before it found one, and before all were excluded."""
    is_sharp: bool
    """Whether ranges are as narrow as the data allow, to 0.25 deg and 20 kg/m3; otherwise the search ended before,
    and they are wider.
    """
    kind: Literal["one-soil", "gradient", "step"]
    """The way."""
    p: float | None
    """Probability that strokes in such ground are so far off by chance, at most; null if it is consistent, and for
    bounds.
    """
    profile: list[ProfileLevel]
    """Ranges over depth, from the surface to the deepest stroke; empty if inconsistent."""
    ranges: ProfileRanges | None
    """What is left; null if inconsistent."""
    slices: list[ProfileStepSlice]
    """What is left for steps at depths of an interval, growing; empty for other kinds."""
    step_m: list[float] | None
    """Depth of the step (m); null if inconsistent, and of other kinds."""
    widening: float | None
    """By which factor bands must be widened until some such ground explains them; 1 if it does, null if not even
    ten is enough.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ProfileLevel(Record):
    """Ranges at a depth.

    Attributes:
        density_kg_m3: Density (kg/m3).
        depth_m: Depth below the surface (m).
        phi_deg: Friction angle (deg).
    """

    density_kg_m3: list[float]
    """Density (kg/m3)."""
    depth_m: float
    """Depth below the surface (m)."""
    phi_deg: list[float]
    """Friction angle (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileNextDepth(Record):
    """What a next stroke at a depth would tell.

    Attributes:
        alpha_deg: Tool angle (deg).
        depth_m: Depth (m).
        forces: Forces by each consistent hypothesis.
        tells: Forces that some hypothesis allows and another does not, over what a band spans: the mean over pairs,
            or with one hypothesis all that it allows. Above 1 such a stroke may tell them apart.
        width_m: Width of the plate (m).
    """

    alpha_deg: float
    """Tool angle (deg)."""
    depth_m: float
    """Depth (m)."""
    forces: list[ProfilePredicted]
    """Forces by each consistent hypothesis."""
    tells: float
    """Forces that some hypothesis allows and another does not, over what a band spans: the mean over pairs, or with
    one hypothesis all that it allows. Above 1 such a stroke may tell them apart.
    """
    width_m: float
    """Width of the plate (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfilePredicted(Record):
    """A force at a depth by a hypothesis.

    Attributes:
        force_n: Forces (N) that it allows; the upper one is null where there is no end to them.
        kind: The hypothesis.
    """

    force_n: list[float | None]
    """Forces (N) that it allows; the upper one is null where there is no end to them."""
    kind: Literal["one-soil", "gradient", "step"]
    """The hypothesis."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileRanges(Record):
    """What is left of the ground.

    Attributes:
        density_bottom_kg_m3: Density (kg/m3) at the bottom.
        density_growth_kg_m3: By how much the density is greater at the bottom (kg/m3).
        density_top_kg_m3: Density (kg/m3) at the top.
        phi_bottom_deg: Friction angle (deg) at the deepest stroke, or below the step.
        phi_growth_deg: By how much the friction angle is greater at the bottom (deg).
        phi_top_deg: Friction angle (deg) at the surface, or above the step.
    """

    density_bottom_kg_m3: list[float]
    """Density (kg/m3) at the bottom."""
    density_growth_kg_m3: list[float]
    """By how much the density is greater at the bottom (kg/m3)."""
    density_top_kg_m3: list[float]
    """Density (kg/m3) at the top."""
    phi_bottom_deg: list[float]
    """Friction angle (deg) at the deepest stroke, or below the step."""
    phi_growth_deg: list[float]
    """By how much the friction angle is greater at the bottom (deg)."""
    phi_top_deg: list[float]
    """Friction angle (deg) at the surface, or above the step."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileStepSlice(Record):
    """Grounds with a step within an interval of depths.

    Attributes:
        ranges: What is left of such ground.
        step_m: Depths of the step (m).
    """

    ranges: ProfileRanges
    """What is left of such ground."""
    step_m: list[float]
    """Depths of the step (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class ProfileStroke(Record):
    """What a measurement says of its force.

    Attributes:
        alpha_deg: Tool angle (deg).
        band_n: Its band (N).
        count: Strokes taken together in it.
        depth_m: Depth (m).
        force_n: Force (N).
        label: Tool angle and depth.
        normalised_band_kg_m3: Its band (kg/m3).
        normalised_kg_m3: Density times coefficient (kg/m3), 2F/(g w L2) with the slant length L: in one soil
            without ends it is the same at all depths for one tool angle.
    """

    alpha_deg: float
    """Tool angle (deg)."""
    band_n: list[float]
    """Its band (N)."""
    count: int
    """Strokes taken together in it."""
    depth_m: float
    """Depth (m)."""
    force_n: float
    """Force (N)."""
    label: str
    """Tool angle and depth."""
    normalised_band_kg_m3: list[float]
    """Its band (kg/m3)."""
    normalised_kg_m3: float
    """Density times coefficient (kg/m3), 2F/(g w L2) with the slant length L: in one soil without ends it is the
    same at all depths for one tool angle.
    """


@dataclass(frozen=True, repr=False, eq=False)
class ProfileAnswer(Answer):
    """The answer of ``profile``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        cohesion: One soil with some cohesion.
        confidence: Probability with which all bands together hold their true forces; null for bounds, which hold
            them for sure. A way in which the ground does go is excluded with a probability of at most one minus
            this.
        delta_deg: What is known of the friction on the plate (deg).
        density_searched_kg_m3: Densities that were looked at (kg/m3), at all depths.
        depths_m: Least and greatest depth of a stroke (m).
        ends: Whether plates have ends.
        friction_law: One soil whose friction angle falls with stress.
        hypotheses: The ways in which ground may go with depth.
        model: Force model.
        next: Place in ``next_depths`` of the one that tells most; null if none tells anything.
        next_depths: What a next stroke would tell, by depth; empty if no hypothesis is consistent.
        phi_searched_deg: Friction angles that were looked at (deg): those that the model covers. A range that ends
            there may be wider in truth.
        step_searched_m: Depths at which a step was looked for (m).
        strokes: The measurements.
        verdict: The result in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.profile/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    cohesion: ProfileAlias
    """One soil with some cohesion."""
    confidence: float | None
    """Probability with which all bands together hold their true forces; null for bounds, which hold them for sure.
    A way in which the ground does go is excluded with a probability of at most one minus this.
    """
    delta_deg: list[float]
    """What is known of the friction on the plate (deg)."""
    density_searched_kg_m3: list[float]
    """Densities that were looked at (kg/m3), at all depths."""
    depths_m: list[float]
    """Least and greatest depth of a stroke (m)."""
    ends: Literal["finite", "none"]
    """Whether plates have ends."""
    friction_law: ProfileAlias
    """One soil whose friction angle falls with stress."""
    hypotheses: list[ProfileHypothesis]
    """The ways in which ground may go with depth."""
    model: str
    """Force model."""
    next: int | None
    """Place in ``next_depths`` of the one that tells most; null if none tells anything."""
    next_depths: list[ProfileNextDepth]
    """What a next stroke would tell, by depth; empty if no hypothesis is consistent."""
    phi_searched_deg: list[float]
    """Friction angles that were looked at (deg): those that the model covers. A range that ends there may be wider
    in truth.
    """
    step_searched_m: list[float]
    """Depths at which a step was looked for (m)."""
    strokes: list[ProfileStroke]
    """The measurements."""
    verdict: str
    """The result in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class SurfaceByForce(Record):
    """What forces say.

    Attributes:
        density_kg_m3: Range of the density (kg/m3); null if no soil explains the forces.
        model: Force model.
        phi_deg: Range of the friction angle (deg); null if no soil explains the forces.
    """

    density_kg_m3: list[float] | None
    """Range of the density (kg/m3); null if no soil explains the forces."""
    model: str
    """Force model."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg); null if no soil explains the forces."""


@dataclass(frozen=True, repr=False, eq=False)
class SurfaceSaid(Record):
    """What a model of the surface says.

    Attributes:
        agreement: Whether forces agree.
        density_both_kg_m3: Densities (kg/m3) that forces leave for these; null if there are none.
        phi_both_deg: Friction angles (deg) that explain forces and break distances; null if there are none.
        phi_deg: Friction angles (deg) that explain all break distances; null if none does.
        surface: The model.
    """

    agreement: Literal["agrees", "nearer", "farther", "no-friction", "no-force"]
    """Whether forces agree."""
    density_both_kg_m3: list[float] | None
    """Densities (kg/m3) that forces leave for these; null if there are none."""
    phi_both_deg: list[float] | None
    """Friction angles (deg) that explain forces and break distances; null if there are none."""
    phi_deg: list[float] | None
    """Friction angles (deg) that explain all break distances; null if none does."""
    surface: Literal["coulomb", "log-spiral", "chen", "chen-without-dilation"]
    """The model."""


@dataclass(frozen=True, repr=False, eq=False)
class SurfaceStroke(Record):
    """A stroke with a break distance.

    Attributes:
        distance_m: Measured distance (m) along the surface, from the plate's face to where the ground broke.
        label: Its name, tool angle and depth.
        line: Its line in the table.
        predicted_m: What each of ``models`` predicts (m), from least to most, for the friction angles that forces
            leave, or if they leave none, that the surface leaves; null where the model has no answer.
        sd_m: Its standard deviation (m).
    """

    distance_m: float
    """Measured distance (m) along the surface, from the plate's face to where the ground broke."""
    label: str
    """Its name, tool angle and depth."""
    line: int
    """Its line in the table."""
    predicted_m: list[list[float] | None]
    """What each of ``models`` predicts (m), from least to most, for the friction angles that forces leave, or if
    they leave none, that the surface leaves; null where the model has no answer.
    """
    sd_m: float
    """Its standard deviation (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class SurfaceAnswer(Answer):
    """The answer of ``surface``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        confidence: Probability with which all bands of break distances together hold their true values; null for
            bounds.
        delta_deg: What is known of the friction on the plate (deg).
        deviations: Standard deviations that a band reaches on either side.
        force: What forces say.
        models: What models of the surface say.
        not_measured: How many strokes have none.
        strokes: Strokes with a break distance.
        verdict: The result in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.surface/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    confidence: float | None
    """Probability with which all bands of break distances together hold their true values; null for bounds."""
    delta_deg: list[float]
    """What is known of the friction on the plate (deg)."""
    deviations: float
    """Standard deviations that a band reaches on either side."""
    force: SurfaceByForce
    """What forces say."""
    models: list[SurfaceSaid]
    """What models of the surface say."""
    not_measured: int
    """How many strokes have none."""
    strokes: list[SurfaceStroke]
    """Strokes with a break distance."""
    verdict: str
    """The result in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsBreak(Record):
    """Where the ground broke.

    Attributes:
        again_m: Where the ground rises once more farther ahead (m); null if it does not.
        distance_m: Distance along the surface from the plate's face (m).
        parts_m: The distance by each fifth of the plate's middle half, from right to left (m); null where it does
            not show.
        resolution_m: Half of the distance between neighbouring heights (m), within which the edge may be anywhere.
        sd_m: Its standard deviation (m): noise, raggedness over the plate's width, and the plate's place.
        table_sd_m: What stands in a stroke table as ``break_distance_sd_m`` (m): standard deviation and resolution
            together, so that a band of any number of deviations holds both.
        within_m: Two standard deviations and the resolution to either side (m).
    """

    again_m: float | None
    """Where the ground rises once more farther ahead (m); null if it does not."""
    distance_m: float
    """Distance along the surface from the plate's face (m)."""
    parts_m: list[float | None]
    """The distance by each fifth of the plate's middle half, from right to left (m); null where it does not show.
    """
    resolution_m: float
    """Half of the distance between neighbouring heights (m), within which the edge may be anywhere."""
    sd_m: float
    """Its standard deviation (m): noise, raggedness over the plate's width, and the plate's place."""
    table_sd_m: float
    """What stands in a stroke table as ``break_distance_sd_m`` (m): standard deviation and resolution together, so
    that a band of any number of deviations holds both.
    """
    within_m: list[float]
    """Two standard deviations and the resolution to either side (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsMap(Record):
    """A map.

    Attributes:
        cell_m: Side of a square as large as a cell (m).
        file: Its file.
        format: What it was read from.
        frame: The frame that a cloud names; empty if there is none.
        missing_points: Points without finite coordinates, left out.
        points: Points that were put into cells; null if heights came in cells.
        points_per_cell: Median of how many points are in a cell that has some; null likewise.
        seen: Cells that were seen.
        size: Cells in a row, and rows, of what is within reach.
        time_s: When a cloud was taken (s since 1970 by its stamp, or whatever its clock counts from); null for
            others.
    """

    cell_m: float
    """Side of a square as large as a cell (m)."""
    file: str
    """Its file."""
    format: Literal["geotiff", "ascii-grid", "table", "scattered-table", "cloud"]
    """What it was read from."""
    frame: str
    """The frame that a cloud names; empty if there is none."""
    missing_points: int
    """Points without finite coordinates, left out."""
    points: int | None
    """Points that were put into cells; null if heights came in cells."""
    points_per_cell: int | None
    """Median of how many points are in a cell that has some; null likewise."""
    seen: int
    """Cells that were seen."""
    size: list[int]
    """Cells in a row, and rows, of what is within reach."""
    time_s: float | None
    """When a cloud was taken (s since 1970 by its stamp, or whatever its clock counts from); null for others."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsPicture(Record):
    """Change of height around the plate, in the plate's directions and in cells that are coarser than those of the
    maps if these are many.

    Attributes:
        ahead_m: Centres ahead of the plate's face (m).
        cell_m: Side of the cells (m).
        change_m: Mean change (m), a list for each place to the left; null where it was not seen.
        left_m: Centres to the left of its middle (m).
    """

    ahead_m: list[float]
    """Centres ahead of the plate's face (m)."""
    cell_m: float
    """Side of the cells (m)."""
    change_m: list[list[float | None]]
    """Mean change (m), a list for each place to the left; null where it was not seen."""
    left_m: list[float]
    """Centres to the left of its middle (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsPlate(Record):
    """The plate as its stroke ended.

    Attributes:
        depth_m: Its depth (m); null if it is not known.
        heading_deg: Where it pushed to (deg), counter-clockwise from the x axis.
        sd_m: Standard deviation of that along the heading (m).
        width_m: Its width (m).
        x_m: Middle of its face at the surface (m), in the frame of the maps: as given, or that of the arm's root.
        y_m: The same along y (m).
    """

    depth_m: float | None
    """Its depth (m); null if it is not known."""
    heading_deg: float
    """Where it pushed to (deg), counter-clockwise from the x axis."""
    sd_m: float
    """Standard deviation of that along the heading (m)."""
    width_m: float
    """Its width (m)."""
    x_m: float
    """Middle of its face at the surface (m), in the frame of the maps: as given, or that of the arm's root."""
    y_m: float
    """The same along y (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsProfile(Record):
    """Change of height ahead of the plate's middle half.

    Attributes:
        ahead_m: Distance ahead of the plate's face on the map (m).
        lines: Lines over the plate's width.
        noise_m: Standard deviation of such a mean where nothing happened (m).
        rise_m: Mean change of height (m); null where it was not seen.
    """

    ahead_m: list[float]
    """Distance ahead of the plate's face on the map (m)."""
    lines: int
    """Lines over the plate's width."""
    noise_m: float
    """Standard deviation of such a mean where nothing happened (m)."""
    rise_m: list[float | None]
    """Mean change of height (m); null where it was not seen."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsShift(Record):
    """How the second map was moved to lie on unchanged ground of the first.

    Attributes:
        sideways_m: Sideways along x and y (m); 0 where no slopes of the ground show it.
        tilt_deg: Tilt along x and y (deg).
        up_m: Upwards at the plate (m).
        up_sd_m: Its standard deviation (m).
    """

    sideways_m: list[float]
    """Sideways along x and y (m); 0 where no slopes of the ground show it."""
    tilt_deg: list[float]
    """Tilt along x and y (deg)."""
    up_m: float
    """Upwards at the plate (m)."""
    up_sd_m: float
    """Its standard deviation (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsVolume(Record):
    """Soil that rose or sank.

    Attributes:
        cells: Cells.
        hidden_cells: Cells in or beside it that were not seen.
        most_m: The largest change of height (m).
        off_map: Whether it reaches the edge of the map, so that there may be more.
        sd_m3: Its standard deviation (m3).
        volume_m3: Volume (m3).
    """

    cells: int
    """Cells."""
    hidden_cells: int
    """Cells in or beside it that were not seen."""
    most_m: float
    """The largest change of height (m)."""
    off_map: bool
    """Whether it reaches the edge of the map, so that there may be more."""
    sd_m3: float
    """Its standard deviation (m3)."""
    volume_m3: float
    """Volume (m3)."""


@dataclass(frozen=True, repr=False, eq=False)
class HeightsAnswer(Answer):
    """The answer of ``heights``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        clumping: Variance of sums over many cells of noise, over that of as many independent cells.
        deviations: Standard deviations of the noise that a change must have to count.
        elsewhere_cells: Cells that changed elsewhere, and are not counted.
        furrow: What sank.
        ground_break: Where the ground broke; null if that cannot be said.
        heap: What rose.
        maps: The maps before and after.
        no_break_because: Why it cannot be said; null if it can.
        noise_m: Standard deviation of the change of a cell where nothing happened (m).
        picture: Change of height around the plate.
        plate: The plate as its stroke ended.
        profile: Change of height ahead of the plate.
        pushed_m: Length of a furrow of the plate's width and depth with as much volume (m); null if the depth is
            not given.
        shift: How the second map was moved.
        slope_deg: Slope of the ground ahead of the plate before the stroke (deg), positive where it rises.
        swelling: Heap over furrow: how much soil swells as it is moved; null without a furrow that stands out of
            the noise.
        swelling_sd: Its standard deviation.
        unchanged_cells: Cells of unchanged ground.
        verdict: The result in words.
        warnings: What to keep in mind.
        written: The stroke table that was written; null if none was asked for.
    """

    schema: Literal["soilctl.heights/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    clumping: float
    """Variance of sums over many cells of noise, over that of as many independent cells."""
    deviations: float
    """Standard deviations of the noise that a change must have to count."""
    elsewhere_cells: int
    """Cells that changed elsewhere, and are not counted."""
    furrow: HeightsVolume
    """What sank."""
    ground_break: HeightsBreak | None
    """Where the ground broke; null if that cannot be said."""
    heap: HeightsVolume
    """What rose."""
    maps: list[HeightsMap]
    """The maps before and after."""
    no_break_because: str | None
    """Why it cannot be said; null if it can."""
    noise_m: float
    """Standard deviation of the change of a cell where nothing happened (m)."""
    picture: HeightsPicture
    """Change of height around the plate."""
    plate: HeightsPlate
    """The plate as its stroke ended."""
    profile: HeightsProfile
    """Change of height ahead of the plate."""
    pushed_m: float | None
    """Length of a furrow of the plate's width and depth with as much volume (m); null if the depth is not given."""
    shift: HeightsShift
    """How the second map was moved."""
    slope_deg: float
    """Slope of the ground ahead of the plate before the stroke (deg), positive where it rises."""
    swelling: float | None
    """Heap over furrow: how much soil swells as it is moved; null without a furrow that stands out of the noise."""
    swelling_sd: float | None
    """Its standard deviation."""
    unchanged_cells: int
    """Cells of unchanged ground."""
    verdict: str
    """The result in words."""
    warnings: list[str]
    """What to keep in mind."""
    written: str | None
    """The stroke table that was written; null if none was asked for."""


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
class ExcavateAngleRow(Record):
    """What a stroke at a tool angle takes at most, in the strongest of all soils.

    Attributes:
        alpha_deg: Tool angle at the insertion (deg).
        bears_n: Failure force (N) at the begin that every soil bears for certain; null where no lower bound is
            proven.
        end_alpha_deg: Tool angle at the end of the stroke (deg): the wrist stays, so that the plate turns with the
            forearm.
        fails_n: Failure force (N) at the begin that is enough in every soil.
        heat_a2: Greatest sum of squared currents on the way (A2): heat (W) for each ohm of winding.
        share: Greatest share of a torque limit on the way.
        work_kj_m3: Work on the soil for each volume that is moved (kJ/m3).
    """

    alpha_deg: float
    """Tool angle at the insertion (deg)."""
    bears_n: float | None
    """Failure force (N) at the begin that every soil bears for certain; null where no lower bound is proven."""
    end_alpha_deg: float
    """Tool angle at the end of the stroke (deg): the wrist stays, so that the plate turns with the forearm."""
    fails_n: float
    """Failure force (N) at the begin that is enough in every soil."""
    heat_a2: float
    """Greatest sum of squared currents on the way (A2): heat (W) for each ohm of winding."""
    share: float
    """Greatest share of a torque limit on the way."""
    work_kj_m3: float
    """Work on the soil for each volume that is moved (kJ/m3)."""


@dataclass(frozen=True, repr=False, eq=False)
class ExcavateDugRow(Record):
    """A pass that was dug.

    Attributes:
        density_kg_m3: Densities that are possible after it (kg/m3).
        depth_m: Depth that was reached at the end of the insertion and of the stroke (m), in truth.
        failure: Why it was not made to its end; null if it was.
        floor_m: Depth below the level surface that it cut to where it began (m), by the controller's sensors.
        heat_a2s: Squared currents over the time of insertion and stroke (A2 s): heat (J) for each ohm of winding.
        learned: What its measurement said.
        peak_force_n: Greatest force of the soil in the stroke (N), in truth.
        peak_share: Greatest share of a torque limit in insertion and stroke, of means over 0.1 s.
        phi_deg: Friction angles that are possible after it (deg).
        planned: As it was planned.
        swept_m3: Soil that the plate swept (m3).
        time_s: Time of insertion and stroke (s).
        travel_m: Way of the plate (m).
        work_j: Mechanical work of the motors in insertion and stroke (J).
    """

    density_kg_m3: list[float]
    """Densities that are possible after it (kg/m3)."""
    depth_m: list[float]
    """Depth that was reached at the end of the insertion and of the stroke (m), in truth."""
    failure: str | None
    """Why it was not made to its end; null if it was."""
    floor_m: float
    """Depth below the level surface that it cut to where it began (m), by the controller's sensors."""
    heat_a2s: float
    """Squared currents over the time of insertion and stroke (A2 s): heat (J) for each ohm of winding."""
    learned: Literal["region", "contradicts", "known", "no_failure", "heap", "outside_model", "not_asked"]
    """What its measurement said."""
    peak_force_n: float
    """Greatest force of the soil in the stroke (N), in truth."""
    peak_share: list[float]
    """Greatest share of a torque limit in insertion and stroke, of means over 0.1 s."""
    phi_deg: list[float]
    """Friction angles that are possible after it (deg)."""
    planned: ExcavatePassRow
    """As it was planned."""
    swept_m3: float
    """Soil that the plate swept (m3)."""
    time_s: float
    """Time of insertion and stroke (s)."""
    travel_m: float
    """Way of the plate (m)."""
    work_j: float
    """Mechanical work of the motors in insertion and stroke (J)."""


@dataclass(frozen=True, repr=False, eq=False)
class ExcavateDugTrench(Record):
    """A trench that was dug on the simulated arm.

    Attributes:
        depth_m: Depth of its floor at the far end (m), by the controller's sensors.
        ended: Why it ended.
        heat_a2s: Squared currents over time (A2 s): heat (J) for each ohm of winding.
        heat_a2s_per_l: The same for the volume swept (A2 s for a litre); null if none was.
        manner: How.
        passes: Passes in order.
        peak_share: Greatest share of a torque limit in any pass.
        swept_m3: Soil that was swept (m3).
        time_s: Time of insertions and strokes (s).
        work_j: Mechanical work of the motors (J).
        work_kj_m3: The same for the volume swept (kJ/m3); null if none was.
    """

    depth_m: float
    """Depth of its floor at the far end (m), by the controller's sensors."""
    ended: Literal["complete", "too_strong", "stroke_failed", "too_many_passes", "stopped"]
    """Why it ended."""
    heat_a2s: float
    """Squared currents over time (A2 s): heat (J) for each ohm of winding."""
    heat_a2s_per_l: float | None
    """The same for the volume swept (A2 s for a litre); null if none was."""
    manner: Literal["learning", "planned", "fixed"]
    """How."""
    passes: list[ExcavateDugRow]
    """Passes in order."""
    peak_share: float
    """Greatest share of a torque limit in any pass."""
    swept_m3: float
    """Soil that was swept (m3)."""
    time_s: float
    """Time of insertions and strokes (s)."""
    work_j: float
    """Mechanical work of the motors (J)."""
    work_kj_m3: float | None
    """The same for the volume swept (kJ/m3); null if none was."""


@dataclass(frozen=True, repr=False, eq=False)
class ExcavateForceRow(Record):
    """What all soils bear of forces of one inclination.

    Attributes:
        bears_n: Force (N) that every soil bears for certain; null where nothing is proven.
        fails_n: Force (N) that fails every soil for certain; null beyond what the plate transmits.
        inclination_deg: Inclination of the plate's force to its normal (deg), positive downwards.
        plate: What becomes of the plate.
        share: Greatest share of a torque limit at the force that fails; null without one.
    """

    bears_n: float | None
    """Force (N) that every soil bears for certain; null where nothing is proven."""
    fails_n: float | None
    """Force (N) that fails every soil for certain; null beyond what the plate transmits."""
    inclination_deg: float
    """Inclination of the plate's force to its normal (deg), positive downwards."""
    plate: Literal["sticks", "open", "slips_up", "dives"]
    """What becomes of the plate."""
    share: float | None
    """Greatest share of a torque limit at the force that fails; null without one."""


@dataclass(frozen=True, repr=False, eq=False)
class ExcavatePassRow(Record):
    """A pass as it was planned.

    Attributes:
        alpha_deg: Tool angle at the insertion (deg).
        depth_m: Depth below the surface where the plate goes in (m).
        fails_n: Force (N) at the begin that is enough to fail every soil that was possible.
        share: Greatest share of a torque limit on the way, in the strongest soil.
    """

    alpha_deg: float
    """Tool angle at the insertion (deg)."""
    depth_m: float
    """Depth below the surface where the plate goes in (m)."""
    fails_n: float
    """Force (N) at the begin that is enough to fail every soil that was possible."""
    share: float
    """Greatest share of a torque limit on the way, in the strongest soil."""


@dataclass(frozen=True, repr=False, eq=False)
class ExcavateAnswer(Answer):
    """The answer of ``excavate``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        angles: Tool angles; those that the arm does not reach are missing.
        at: Tool angle (deg) and depth (m) for which forces and tool angles are told: those of the first pass, or of
            the least pass if none keeps the share.
        complete: Whether these passes make the whole depth.
        delta_deg: Friction on the plate that is possible (deg).
        density_kg_m3: Densities that are possible (kg/m3).
        dug: Trenches that were dug on the simulated arm; empty if none was asked for.
        files: Files that were written.
        forces: Forces by their inclination.
        least: What is to be least.
        passes: Passes as they are planned, without what they will teach.
        phi_deg: Friction angles that are possible (deg).
        share: Share of the torque limits that a pass may take.
        soil: The soil of the simulated box.
        verdict: The answer in words.
        warnings: What to keep in mind.
    """

    schema: Literal["soilctl.excavate/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    angles: list[ExcavateAngleRow]
    """Tool angles; those that the arm does not reach are missing."""
    at: list[float]
    """Tool angle (deg) and depth (m) for which forces and tool angles are told: those of the first pass, or of the
    least pass if none keeps the share.
    """
    complete: bool
    """Whether these passes make the whole depth."""
    delta_deg: list[float]
    """Friction on the plate that is possible (deg)."""
    density_kg_m3: list[float]
    """Densities that are possible (kg/m3)."""
    dug: list[ExcavateDugTrench]
    """Trenches that were dug on the simulated arm; empty if none was asked for."""
    files: list[str]
    """Files that were written."""
    forces: list[ExcavateForceRow]
    """Forces by their inclination."""
    least: Literal["torque", "heat", "work"]
    """What is to be least."""
    passes: list[ExcavatePassRow]
    """Passes as they are planned, without what they will teach."""
    phi_deg: list[float]
    """Friction angles that are possible (deg)."""
    share: float
    """Share of the torque limits that a pass may take."""
    soil: str
    """The soil of the simulated box."""
    verdict: str
    """The answer in words."""
    warnings: list[str]
    """What to keep in mind."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessAnalysis(Record):
    """What the strokes say together.

    Attributes:
        base_angle: Whether forces depend on the base angle; null if it does not vary.
        comparison: What the model's forces were compared for; null without --density.
        depth_laws: Force as a power of depth, for each tool angle with several depths.
        friction: Interface friction by the lift at failure; null without a sweep.
        groups: Forces by tool angle, at that slant length.
        no_friction: Why there is none.
        radius: Whether forces depend on the radius; null if it does not vary.
        rubbing: The check by rubbing; null without such a log.
        slant_m: Slant length to which forces are scaled in m.
    """

    base_angle: ProcessEffect | None
    """Whether forces depend on the base angle; null if it does not vary."""
    comparison: ProcessComparison | None
    """What the model's forces were compared for; null without --density."""
    depth_laws: list[ProcessLaw]
    """Force as a power of depth, for each tool angle with several depths."""
    friction: ProcessFriction | None
    """Interface friction by the lift at failure; null without a sweep."""
    groups: list[ProcessGroup]
    """Forces by tool angle, at that slant length."""
    no_friction: str | None
    """Why there is none."""
    radius: ProcessEffect | None
    """Whether forces depend on the radius; null if it does not vary."""
    rubbing: ProcessRubbing | None
    """The check by rubbing; null without such a log."""
    slant_m: float
    """Slant length to which forces are scaled in m."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessComparison(Record):
    """What model forces are for.

    Attributes:
        delta_deg: Interface friction in deg.
        density_kg_m3: Density in kg/m3.
        model: Name of the model.
        phi_deg: Friction angle in deg of ``model_n``; null without --phi.
    """

    delta_deg: float
    """Interface friction in deg."""
    density_kg_m3: float
    """Density in kg/m3."""
    model: str
    """Name of the model."""
    phi_deg: float | None
    """Friction angle in deg of ``model_n``; null without --phi."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessContact(Record):
    """A contact of the plate, or a window that was given.

    Attributes:
        depth_m: Greatest depth of the edge below the surface in m; negative above it; null where the posture is
            unknown.
        from_s: Begin in s.
        highest_n: Greatest force beside the tare in N, over a block; null without a tare.
        kind: What became of it.
        reason: Why it is no stroke with a failure force; null if it is one.
        to_s: End in s.
    """

    depth_m: float | None
    """Greatest depth of the edge below the surface in m; negative above it; null where the posture is unknown."""
    from_s: float
    """Begin in s."""
    highest_n: float | None
    """Greatest force beside the tare in N, over a block; null without a tare."""
    kind: Literal["stroke", "no_failure", "refused", "no_stroke"]
    """What became of it."""
    reason: str | None
    """Why it is no stroke with a failure force; null if it is one."""
    to_s: float
    """End in s."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessEffect(Record):
    """How forces depend on the arm's configuration.

    Attributes:
        effect_rel: Relative change of force from the least to the greatest value.
        effect_se: Its standard error.
        p: Probability of such an effect by chance.
        range: Least and greatest value, in m or deg.
        verdict: In words.
    """

    effect_rel: float
    """Relative change of force from the least to the greatest value."""
    effect_se: float
    """Its standard error."""
    p: float
    """Probability of such an effect by chance."""
    range: list[float]
    """Least and greatest value, in m or deg."""
    verdict: str
    """In words."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessFound(Record):
    """What was found in a log of another program, beside its strokes.

    Attributes:
        clock_origin_s: Where the clock of all times begins, in s of the stamps.
        contacts: All contacts of the plate.
        free_air: What free air told of the sensor; null if there was none.
    """

    clock_origin_s: int
    """Where the clock of all times begins, in s of the stamps."""
    contacts: list[ProcessContact]
    """All contacts of the plate."""
    free_air: ProcessFreeAir | None
    """What free air told of the sensor; null if there was none."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessFreeAir(Record):
    """What free air told.

    Attributes:
        bias: Reading without weight at the middle of the log, in N and N m.
        bias_sd: Its standard deviations.
        centre_m: Its centre of mass in the sensor's frame in m, if the weight is well known.
        drift_n_per_s: Drift of the forces in N/s.
        drift_sd_n_per_s: Their standard deviations.
        left_out: Pieces of free air that did not fit and were left out.
        noise: Noise; ``None`` if a tare was given and no free air was found.
        postures_deg: Largest angle between the directions of gravity in the sensor's frame, in deg.
        seconds: Time in free air that was used, in s.
        weight_n: Weight of what the sensor carries in N.
        weight_sd_n: Its standard deviation.
    """

    bias: list[float]
    """Reading without weight at the middle of the log, in N and N m."""
    bias_sd: list[float]
    """Its standard deviations."""
    centre_m: list[float] | None
    """Its centre of mass in the sensor's frame in m, if the weight is well known."""
    drift_n_per_s: list[float]
    """Drift of the forces in N/s."""
    drift_sd_n_per_s: list[float]
    """Their standard deviations."""
    left_out: int
    """Pieces of free air that did not fit and were left out."""
    noise: ProcessNoise | None
    """Noise; ``None`` if a tare was given and no free air was found."""
    postures_deg: float
    """Largest angle between the directions of gravity in the sensor's frame, in deg."""
    seconds: float
    """Time in free air that was used, in s."""
    weight_n: float
    """Weight of what the sensor carries in N."""
    weight_sd_n: float
    """Its standard deviation."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessFriction(Record):
    """Interface friction by a sweep of set-points.

    Attributes:
        above_deg: Highest set-point with a significant lift; friction is above it.
        below_deg: Lowest set-point above that without one; friction is below it.
        delta_deg: Estimate in deg.
        left_out: Strokes at other tool angles, or without a measured lift.
        lift_per_deg: Lift for each degree that the set-point is too low.
        sd_deg: Its standard deviation in deg.
        strokes: Strokes at 80 to 90 deg, which count.
    """

    above_deg: float | None
    """Highest set-point with a significant lift; friction is above it."""
    below_deg: float | None
    """Lowest set-point above that without one; friction is below it."""
    delta_deg: float
    """Estimate in deg."""
    left_out: list[str]
    """Strokes at other tool angles, or without a measured lift."""
    lift_per_deg: float
    """Lift for each degree that the set-point is too low."""
    sd_deg: float
    """Its standard deviation in deg."""
    strokes: list[ProcessLift]
    """Strokes at 80 to 90 deg, which count."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessGroup(Record):
    """Forces at one tool angle.

    Attributes:
        alpha_deg: Tool angle in deg.
        coefficient_of_variation: Standard deviation over mean.
        matched_phi_deg: Friction angle at which the model gives the mean in deg; null if none does.
        mean_n: Mean without outliers in N.
        model_difference: Mean over that force, minus 1.
        model_n: Force of the model for the given friction angle in N.
        outliers: Strokes that do not belong (generalised extreme Studentised deviate test, 5 %).
        sd_n: Standard deviation without outliers in N; null of one stroke.
        strokes: Strokes, outliers included.
    """

    alpha_deg: float
    """Tool angle in deg."""
    coefficient_of_variation: float | None
    """Standard deviation over mean."""
    matched_phi_deg: float | None
    """Friction angle at which the model gives the mean in deg; null if none does."""
    mean_n: float
    """Mean without outliers in N."""
    model_difference: float | None
    """Mean over that force, minus 1."""
    model_n: float | None
    """Force of the model for the given friction angle in N."""
    outliers: list[str]
    """Strokes that do not belong (generalised extreme Studentised deviate test, 5 %)."""
    sd_n: float | None
    """Standard deviation without outliers in N; null of one stroke."""
    strokes: int
    """Strokes, outliers included."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessLaw(Record):
    """Force as a power of depth.

    Attributes:
        agrees_with_square: Whether the interval holds 2.
        alpha_deg: Tool angle in deg.
        exponent: The power; 2 in soil without cohesion.
        exponent_95: Ends of its 95 % confidence interval.
        quadratic_n_per_m2: F/H^2 of the fit through zero in N/m2.
        strokes: Strokes.
    """

    agrees_with_square: bool
    """Whether the interval holds 2."""
    alpha_deg: float
    """Tool angle in deg."""
    exponent: float
    """The power; 2 in soil without cohesion."""
    exponent_95: list[float]
    """Ends of its 95 % confidence interval."""
    quadratic_n_per_m2: float
    """F/H^2 of the fit through zero in N/m2."""
    strokes: int
    """Strokes."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessLift(Record):
    """Lift at failure of one stroke.

    Attributes:
        lift_deg: Lift in deg.
        lift_sd_deg: Its standard deviation in deg.
        set_deg: Set-point of the interface friction in deg.
        significance: Lift over its standard deviation.
        stroke_id: Name of the stroke.
    """

    lift_deg: float
    """Lift in deg."""
    lift_sd_deg: float
    """Its standard deviation in deg."""
    set_deg: float
    """Set-point of the interface friction in deg."""
    significance: float
    """Lift over its standard deviation."""
    stroke_id: str
    """Name of the stroke."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessLogOutcome(Record):
    """What became of a log.

    Attributes:
        damage: Damaged parts, which were left out.
        error: Why nothing could be made of it; null if something could.
        found: What else was found in a log of another program; null for a log of soilctl.
        is_partial: Whether data that matter are missing: a stroke could not be weighed, or has a gap where the
            force rises, or clouds that were asked for cannot be used.
        log: The file.
        own: Whether soilctl wrote it.
        scans: What clouds of points before and after each stroke say of where the ground broke; empty if there are
            none.
        skipped: What gave none, and why.
        status: ``done`` or ``failed``.
        strokes: Strokes with a failure force.
        unusable: Messages that could not be used, or whose times had to be mended.
    """

    damage: list[str]
    """Damaged parts, which were left out."""
    error: str | None
    """Why nothing could be made of it; null if something could."""
    found: ProcessFound | None
    """What else was found in a log of another program; null for a log of soilctl."""
    is_partial: bool
    """Whether data that matter are missing: a stroke could not be weighed, or has a gap where the force rises, or
    clouds that were asked for cannot be used.
    """
    log: str
    """The file."""
    own: bool
    """Whether soilctl wrote it."""
    scans: list[ProcessScan]
    """What clouds of points before and after each stroke say of where the ground broke; empty if there are none."""
    skipped: list[ProcessSkipped]
    """What gave none, and why."""
    status: str
    """``done`` or ``failed``."""
    strokes: int
    """Strokes with a failure force."""
    unusable: list[str]
    """Messages that could not be used, or whose times had to be mended."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessNoise(Record):
    """What the sensor reads without cause.

    Attributes:
        corner_hz: Corner frequency in Hz of the noise of the forces, as of a filter of first order; ``None`` if it
            is white up to half the rate of samples.
        sd: Standard deviation of one sample: force in N, torque in N m.
    """

    corner_hz: float | None
    """Corner frequency in Hz of the noise of the forces, as of a filter of first order; ``None`` if it is white up
    to half the rate of samples.
    """
    sd: list[float]
    """Standard deviation of one sample: force in N, torque in N m."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessRubbing(Record):
    """The check by rubbing a sand-covered plate.

    Attributes:
        peak_deg: Median of the peaks of the friction angle in deg.
        peaks: How many peaks.
        range_deg: Range that holds two thirds of the peaks in deg.
    """

    peak_deg: float
    """Median of the peaks of the friction angle in deg."""
    peaks: int
    """How many peaks."""
    range_deg: list[float]
    """Range that holds two thirds of the peaks in deg."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessScan(Record):
    """What the scans before and after a stroke say.

    Attributes:
        after_s: When the one after it was taken; null likewise.
        before_s: When the cloud before it was taken (s on the log's clock); null if there is none in which the
            plate is out of the ground.
        break_distance_m: Distance along the surface from the plate's face to where the ground broke (m); null if
            that cannot be said.
        break_distance_sd_m: Its standard deviation and resolution together (m).
        reason: Why there is no distance; null if there is one.
        stroke_id: Name of the stroke.
        warnings: What to keep in mind about the maps.
    """

    after_s: float | None
    """When the one after it was taken; null likewise."""
    before_s: float | None
    """When the cloud before it was taken (s on the log's clock); null if there is none in which the plate is out of
    the ground.
    """
    break_distance_m: float | None
    """Distance along the surface from the plate's face to where the ground broke (m); null if that cannot be said.
    """
    break_distance_sd_m: float | None
    """Its standard deviation and resolution together (m)."""
    reason: str | None
    """Why there is no distance; null if there is one."""
    stroke_id: str
    """Name of the stroke."""
    warnings: list[str]
    """What to keep in mind about the maps."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessSkipped(Record):
    """A part of a log that gave no failure force.

    Attributes:
        from_s: Begin on the log's clock in s.
        outcome: ``no_stroke``, ``refused`` if it cannot be weighed, or what is indiscernible about the failure:
            ``no_force``, ``no_travel``, ``no_break``, ``incomplete``, ``uncertain``.
        reason: Why, in words.
        stroke_id: Name of the stroke; null if it is none.
        to_s: End in s.
    """

    from_s: float
    """Begin on the log's clock in s."""
    outcome: str
    """``no_stroke``, ``refused`` if it cannot be weighed, or what is indiscernible about the failure: ``no_force``,
    ``no_travel``, ``no_break``, ``incomplete``, ``uncertain``.
    """
    reason: str
    """Why, in words."""
    stroke_id: str | None
    """Name of the stroke; null if it is none."""
    to_s: float
    """End in s."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessStrokeRecord(Record):
    """A stroke of a log: its row of the stroke table, and what its failure was like.

    Attributes:
        air_across_n: Free-air reading before the stroke across the plate, weight and zero of the sensor in it (N).
        air_along_n: The same along the plate (N).
        alpha_deg: Tool angle, from the ground ahead to the plate (deg).
        base_deg: Base angle at which the stroke was made (deg).
        batch: Name of the preparation the stroke was made in (text).
        break_distance_m: From the plate's face at the surface, along the surface ahead, to where the ground broke
            at failure (m).
        break_distance_sd_m: Standard deviation of ``break_distance_m`` (m).
        cmd_minus_force_n: Force from the motor torques minus that of the sensor, before failure (N).
        delta_set_deg: Interface friction angle that the controller was set to (deg).
        density_kg_m3: Bulk density weighed for the batch (kg/m3).
        depth_m: Vertical depth of the plate's lower edge below the surface where the soil failed (m).
        depth_sd_m: Standard deviation of ``depth_m``: how well surface and edge are known (m).
        displacement_at_failure_m: Displacement at failure, compensated for flexion (m).
        elbow_loop_deg: The same of the elbow (deg).
        failure: ``drastic`` or ``gradual`` (text).
        failure_time_s: Time of the failure on the clock of the log (s).
        flags: What to keep in mind, words parted by blanks; empty if nothing (text).
        force_n: Failure force: magnitude of the in-plane resultant, tare removed (N).
        force_sd_n: Standard deviation of the failure force (N).
        friction_angle_deg: Measured friction angle just before failure (deg).
        friction_angle_sd_deg: Standard deviation of ``friction_angle_deg`` (deg).
        gap_prior_m: Edge distance to the nearest earlier stroke in this preparation (m).
        insertion_force_n: Mean force along the plate over the way of its insertion, work over way (N).
        lift_deg: Inclination of the force while failed soil slips along the plate, above the set-point, or without
            one above that before the failure (deg).
        lift_sd_deg: Standard deviation of ``lift_deg`` (deg).
        log: The log (text).
        method: How the failure was found: ``drop``, ``run_away`` or ``saturation`` (text).
        mobilised: Share of the limit force that was mobilised at the end of a gradual failure (1).
        motor_angle_deg: Inclination of the force by the motor torques minus that by the sensor, before failure
            (deg).
        motor_ext_gap_m: Motor-side minus external position before failure (m).
        order: Order within the preparation, from 1 (1).
        post_slope_norm: Slope after the break, ``(dF/du) H/F`` (1).
        radius_m: Radius from the base axis at which the stroke was made (m).
        residual_ratio: Force half a depth after failure over the failure force (1).
        shoulder_loop_deg: Motor minus external angle of the shoulder before failure, above that in free air before
            the stroke (deg).
        speed_mps: Mean speed of the plate up to failure (m/s).
        stroke_id: Name of the stroke; no other stroke of the table has it (text).
        tare_after_n: Free-air reading after the stroke, along the force (N).
        tare_before_n: Free-air reading before the stroke, along the force (N).
        time_s: Time of the stroke on the clock of the campaign (s).
        touch_z_m: Height of the surface where the plate met it, above that which the log states (m).
        turned_deg: How far the tool angle had grown at failure, since the arm turns the plate while it pulls (deg).
        two_lines_force_n: Force where two lines fitted to the curve meet, the usual rule for gradual failures (N).
        wall_m: From the edge of the plate to the nearest wall (m).
        width_m: Width of the plate (m).
        x_step_m: Usual step of the external encoders at the plate (m).
        z_drift_m: Drift of the plate's lower edge up to failure, up positive (m).
    """

    air_across_n: float | None
    """Free-air reading before the stroke across the plate, weight and zero of the sensor in it (N)."""
    air_along_n: float | None
    """The same along the plate (N)."""
    alpha_deg: float
    """Tool angle, from the ground ahead to the plate (deg)."""
    base_deg: float | None
    """Base angle at which the stroke was made (deg)."""
    batch: str | None
    """Name of the preparation the stroke was made in (text)."""
    break_distance_m: float | None
    """From the plate's face at the surface, along the surface ahead, to where the ground broke at failure (m)."""
    break_distance_sd_m: float | None
    """Standard deviation of ``break_distance_m`` (m)."""
    cmd_minus_force_n: float | None
    """Force from the motor torques minus that of the sensor, before failure (N)."""
    delta_set_deg: float | None
    """Interface friction angle that the controller was set to (deg)."""
    density_kg_m3: float | None
    """Bulk density weighed for the batch (kg/m3)."""
    depth_m: float
    """Vertical depth of the plate's lower edge below the surface where the soil failed (m)."""
    depth_sd_m: float | None
    """Standard deviation of ``depth_m``: how well surface and edge are known (m)."""
    displacement_at_failure_m: float | None
    """Displacement at failure, compensated for flexion (m)."""
    elbow_loop_deg: float | None
    """The same of the elbow (deg)."""
    failure: str
    """``drastic`` or ``gradual`` (text)."""
    failure_time_s: float | None
    """Time of the failure on the clock of the log (s)."""
    flags: str
    """What to keep in mind, words parted by blanks; empty if nothing (text)."""
    force_n: float
    """Failure force: magnitude of the in-plane resultant, tare removed (N)."""
    force_sd_n: float | None
    """Standard deviation of the failure force (N)."""
    friction_angle_deg: float | None
    """Measured friction angle just before failure (deg)."""
    friction_angle_sd_deg: float | None
    """Standard deviation of ``friction_angle_deg`` (deg)."""
    gap_prior_m: float | None
    """Edge distance to the nearest earlier stroke in this preparation (m)."""
    insertion_force_n: float | None
    """Mean force along the plate over the way of its insertion, work over way (N)."""
    lift_deg: float | None
    """Inclination of the force while failed soil slips along the plate, above the set-point, or without one above
    that before the failure (deg).
    """
    lift_sd_deg: float | None
    """Standard deviation of ``lift_deg`` (deg)."""
    log: str
    """The log (text)."""
    method: str
    """How the failure was found: ``drop``, ``run_away`` or ``saturation`` (text)."""
    mobilised: float | None
    """Share of the limit force that was mobilised at the end of a gradual failure (1)."""
    motor_angle_deg: float | None
    """Inclination of the force by the motor torques minus that by the sensor, before failure (deg)."""
    motor_ext_gap_m: float | None
    """Motor-side minus external position before failure (m)."""
    order: int | None
    """Order within the preparation, from 1 (1)."""
    post_slope_norm: float | None
    """Slope after the break, ``(dF/du) H/F`` (1)."""
    radius_m: float | None
    """Radius from the base axis at which the stroke was made (m)."""
    residual_ratio: float | None
    """Force half a depth after failure over the failure force (1)."""
    shoulder_loop_deg: float | None
    """Motor minus external angle of the shoulder before failure, above that in free air before the stroke (deg)."""
    speed_mps: float | None
    """Mean speed of the plate up to failure (m/s)."""
    stroke_id: str
    """Name of the stroke; no other stroke of the table has it (text)."""
    tare_after_n: float | None
    """Free-air reading after the stroke, along the force (N)."""
    tare_before_n: float | None
    """Free-air reading before the stroke, along the force (N)."""
    time_s: float | None
    """Time of the stroke on the clock of the campaign (s)."""
    touch_z_m: float | None
    """Height of the surface where the plate met it, above that which the log states (m)."""
    turned_deg: float | None
    """How far the tool angle had grown at failure, since the arm turns the plate while it pulls (deg)."""
    two_lines_force_n: float | None
    """Force where two lines fitted to the curve meet, the usual rule for gradual failures (N)."""
    wall_m: float | None
    """From the edge of the plate to the nearest wall (m)."""
    width_m: float
    """Width of the plate (m)."""
    x_step_m: float | None
    """Usual step of the external encoders at the plate (m)."""
    z_drift_m: float | None
    """Drift of the plate's lower edge up to failure, up positive (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class ProcessAnswer(Answer):
    """The answer of ``process``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        analysis: What the strokes say together.
        logs: What became of each log.
        reused: Logs that were taken over from an earlier run, since they are as they were.
        stopped: Whether the work was stopped before the last log.
        strokes: Strokes with a failure force, in the order of the logs.
        written: Files that were written.
    """

    schema: Literal["soilctl.process/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    analysis: ProcessAnalysis
    """What the strokes say together."""
    logs: list[ProcessLogOutcome]
    """What became of each log."""
    reused: int
    """Logs that were taken over from an earlier run, since they are as they were."""
    stopped: bool
    """Whether the work was stopped before the last log."""
    strokes: list[ProcessStrokeRecord]
    """Strokes with a failure force, in the order of the logs."""
    written: list[str]
    """Files that were written."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadAlarm(Record):
    """An alarm.

    Attributes:
        from_the_beginning: Whether it is more from the first look on, by comparison with other strokes; else it
            rose since.
        last_region: Where a fixed block may be by all looks, seen from the plate at the last; null likewise.
        last_way_m: Way of the plate at the last look (m).
        ratio: Force over what the soil explains, at the look that alarms.
        ratio_range: Between these the ratio lies by the scatter of the others.
        region: Where a fixed block may be by the looks up to the alarm, seen from the plate then; null where bounds
            do not apply, since the plate is not upright.
        time_s: When it came, in s on the clock of the log's stroke.
        way_m: Way of the plate at the alarm (m).
    """

    from_the_beginning: bool
    """Whether it is more from the first look on, by comparison with other strokes; else it rose since."""
    last_region: AheadRegion | None
    """Where a fixed block may be by all looks, seen from the plate at the last; null likewise."""
    last_way_m: float
    """Way of the plate at the last look (m)."""
    ratio: float
    """Force over what the soil explains, at the look that alarms."""
    ratio_range: list[float]
    """Between these the ratio lies by the scatter of the others."""
    region: AheadRegion | None
    """Where a fixed block may be by the looks up to the alarm, seen from the plate then; null where bounds do not
    apply, since the plate is not upright.
    """
    time_s: float
    """When it came, in s on the clock of the log's stroke."""
    way_m: float
    """Way of the plate at the alarm (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadLook(Record):
    """One look at a stroke.

    Attributes:
        limit: Ratio above which a stroke alarms.
        ratio: Force over what the soil explains: at the first look by the other strokes, later by these and the
            force at the first.
        way_m: Way of the plate when the look was possible.
    """

    limit: float
    """Ratio above which a stroke alarms."""
    ratio: float
    """Force over what the soil explains: at the first look by the other strokes, later by these and the force at
    the first.
    """
    way_m: float
    """Way of the plate when the look was possible."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadPlace(Record):
    """A part of the region.

    Attributes:
        ahead_m: Distance from the plate's lower edge ahead to the block, from and to (m).
        top_m: Depth of its top below the surface, from and to (m).
    """

    ahead_m: list[float]
    """Distance from the plate's lower edge ahead to the block, from and to (m)."""
    top_m: list[float]
    """Depth of its top below the surface, from and to (m)."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadRegion(Record):
    """Where a fixed block may be.

    Attributes:
        ahead_m: Distances still ahead, from and to (m); null if no block goes with the stroke.
        is_open: Whether it may be still further ahead than what was looked at.
        places: All parts.
        top_m: Depths of its top below the surface, from and to (m); null likewise.
    """

    ahead_m: list[float] | None
    """Distances still ahead, from and to (m); null if no block goes with the stroke."""
    is_open: bool
    """Whether it may be still further ahead than what was looked at."""
    places: list[AheadPlace]
    """All parts."""
    top_m: list[float] | None
    """Depths of its top below the surface, from and to (m); null likewise."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadStroke(Record):
    """A stroke.

    Attributes:
        alarm: The alarm; null if it is none.
        alpha_deg: Tool angle (deg).
        depth_m: Depth of the plate at the beginning (m).
        looks: The looks.
        looks_planned: Looks over which the probability of a false alarm is shared out.
        reason: Why it is not judged; null if it is.
        references: Strokes it was compared with.
        start_s: When it began, in s on the log's clock.
        stroke_id: Its name: that of the log, and its number in it.
        verdict: What became of it.
    """

    alarm: AheadAlarm | None
    """The alarm; null if it is none."""
    alpha_deg: float
    """Tool angle (deg)."""
    depth_m: float
    """Depth of the plate at the beginning (m)."""
    looks: list[AheadLook]
    """The looks."""
    looks_planned: int
    """Looks over which the probability of a false alarm is shared out."""
    reason: str | None
    """Why it is not judged; null if it is."""
    references: int
    """Strokes it was compared with."""
    start_s: float
    """When it began, in s on the log's clock."""
    stroke_id: str
    """Its name: that of the log, and its number in it."""
    verdict: Literal["alarm", "quiet", "not_judged"]
    """What became of it."""


@dataclass(frozen=True, repr=False, eq=False)
class AheadAnswer(Answer):
    """The answer of ``ahead``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        alarms: Strokes that alarm.
        confidence: Probability that a region holds what bounds and scatter allow.
        false_alarms: Probability that a stroke with nothing ahead alarms.
        not_judged: Strokes that are not judged.
        notes: What else is to be kept in mind.
        phi_deg: Friction angles of the soil for which regions hold (deg).
        problems: Logs that cannot be used, and what is missing in others.
        quiet: Strokes that do not.
        references: Strokes with nothing ahead, by the logs of ``reference``; null without such logs.
        strokes: The strokes, by log.
        verdict: The answer in words.
    """

    schema: Literal["soilctl.ahead/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    alarms: int
    """Strokes that alarm."""
    confidence: float
    """Probability that a region holds what bounds and scatter allow."""
    false_alarms: float
    """Probability that a stroke with nothing ahead alarms."""
    not_judged: int
    """Strokes that are not judged."""
    notes: list[str]
    """What else is to be kept in mind."""
    phi_deg: list[float]
    """Friction angles of the soil for which regions hold (deg)."""
    problems: list[str]
    """Logs that cannot be used, and what is missing in others."""
    quiet: int
    """Strokes that do not."""
    references: int | None
    """Strokes with nothing ahead, by the logs of ``reference``; null without such logs."""
    strokes: list[AheadStroke]
    """The strokes, by log."""
    verdict: str
    """The answer in words."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseChannelGap(Record):
    """The gap of a column, in standard deviations of the prediction with effects.

    Attributes:
        after: The same with effects.
        before: Normalised root mean square without effects; the square is chi-square a reading.
        channel: Column of the stroke table, or of the traces.
        delta_elpd: Gain in log predictive density, summed over readings.
        delta_elpd_se: Its standard error.
        readings: Readings.
    """

    after: float
    """The same with effects."""
    before: float
    """Normalised root mean square without effects; the square is chi-square a reading."""
    channel: str
    """Column of the stroke table, or of the traces."""
    delta_elpd: float
    """Gain in log predictive density, summed over readings."""
    delta_elpd_se: float
    """Its standard error."""
    readings: int
    """Readings."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseEffect(Record):
    """One effect.

    Attributes:
        id: Id in the catalogue.
        log_bayes_factor: ln Bayes factor over the explanation without it.
        parameters: Parameters by name.
    """

    id: str
    """Id in the catalogue."""
    log_bayes_factor: float
    """ln Bayes factor over the explanation without it."""
    parameters: dict[str, DiagnoseParameter]
    """Parameters by name."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseGap(Record):
    """Root mean squares of ln force; chi-square and log density are of batches that were left out.

    Attributes:
        after: With effects.
        before: Without effects.
        chi2_per_n_after: chi-square a stroke with effects.
        chi2_per_n_before: chi-square a stroke without effects.
        delta_elpd: Gain in expected log predictive density.
        delta_elpd_se: Its standard error.
        heldout_after: With effects, each batch predicted from the others.
        heldout_before: Without effects, each batch predicted from the others; null with fewer than two batches.
    """

    after: float
    """With effects."""
    before: float
    """Without effects."""
    chi2_per_n_after: float | None
    """chi-square a stroke with effects."""
    chi2_per_n_before: float | None
    """chi-square a stroke without effects."""
    delta_elpd: float | None
    """Gain in expected log predictive density."""
    delta_elpd_se: float | None
    """Its standard error."""
    heldout_after: float | None
    """With effects, each batch predicted from the others."""
    heldout_before: float | None
    """Without effects, each batch predicted from the others; null with fewer than two batches."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseNearest(Record):
    """An effect that comes near.

    Attributes:
        id: Id in the catalogue.
        log_bayes_factor: ln Bayes factor of it alone.
    """

    id: str
    """Id in the catalogue."""
    log_bayes_factor: float
    """ln Bayes factor of it alone."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseNext(Record):
    """The next experiment.

    Attributes:
        design_csv: File with the strokes to make.
        no_plan_because: Why not, where there could have been one; null otherwise.
        plan: Plan of the campaign with these strokes after its own, for ``simulate`` and ``run``; null if the
            campaign was not compared with the simulated arm, or a plan cannot say them.
        power: Chance that it settles the question.
        text: What to do and why.
    """

    design_csv: str
    """File with the strokes to make."""
    no_plan_because: str | None
    """Why not, where there could have been one; null otherwise."""
    plan: str | None
    """Plan of the campaign with these strokes after its own, for ``simulate`` and ``run``; null if the campaign was
    not compared with the simulated arm, or a plan cannot say them.
    """
    power: float
    """Chance that it settles the question."""
    text: str
    """What to do and why."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseParameter(Record):
    """A parameter.

    Attributes:
        sd: Standard deviation.
        unit: Unit, ``1`` for a number without.
        value: Value; for a choice among force models, its index.
    """

    sd: float
    """Standard deviation."""
    unit: str
    """Unit, ``1`` for a number without."""
    value: float
    """Value; for a choice among force models, its index."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSignal(Record):
    """The gap of a signal to the simulated arm, in standard deviations of its scatter from stroke to stroke.

    Attributes:
        gap_after: The same with the effects that were found; null if they were not simulated.
        gap_before: Root mean square of measured minus simulated without effects.
        heldout_after: The same with effects.
        heldout_before: Batches that were left out, predicted without effects, in standard deviations of the
            prediction; null without such a prediction.
        phase: Phase of the stroke, for readings of traces: loading or after; null for the column itself.
        signal: Column of the stroke table, or of the traces; the force goes as its logarithm.
        strokes: Strokes that have it.
    """

    gap_after: float | None
    """The same with the effects that were found; null if they were not simulated."""
    gap_before: float
    """Root mean square of measured minus simulated without effects."""
    heldout_after: float | None
    """The same with effects."""
    heldout_before: float | None
    """Batches that were left out, predicted without effects, in standard deviations of the prediction; null without
    such a prediction.
    """
    phase: str | None
    """Phase of the stroke, for readings of traces: loading or after; null for the column itself."""
    signal: str
    """Column of the stroke table, or of the traces; the force goes as its logarithm."""
    strokes: int
    """Strokes that have it."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseTerm(Record):
    """A change of the force over one condition of the strokes or two, without a name.

    Attributes:
        at: Values of each of these, ascending, in the unit of the column; of ``batch`` its place, from 0.
        ln_force: Change of ln force there, those of the last condition one after the other; linear between, and
            held beyond.
        log_bayes_factor: ln Bayes factor over the explanation without it.
        over: Columns of the stroke table.
        sd: Standard deviation of each.
    """

    at: list[list[float]]
    """Values of each of these, ascending, in the unit of the column; of ``batch`` its place, from 0."""
    ln_force: list[float]
    """Change of ln force there, those of the last condition one after the other; linear between, and held beyond.
    """
    log_bayes_factor: float
    """ln Bayes factor over the explanation without it."""
    over: list[str]
    """Columns of the stroke table."""
    sd: list[float]
    """Standard deviation of each."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseTestability(Record):
    """What the design could show of an effect.

    Attributes:
        id: Id of the effect.
        lambda_: Expected squared signal-to-noise ratio at a typical amplitude.
        lambda_largest: The same at the largest plausible amplitude.
        verdict: yes, if large, absorbed by soil and interface, masked by baselines, or not varied by the design.
    """

    id: str
    """Id of the effect."""
    lambda_: float = field(metadata={"key": "lambda"})
    """Expected squared signal-to-noise ratio at a typical amplitude."""
    lambda_largest: float
    """The same at the largest plausible amplitude."""
    verdict: str
    """yes, if large, absorbed by soil and interface, masked by baselines, or not varied by the design."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseWhere(Record):
    """One disagreement.

    Attributes:
        channel: Column of the stroke table, or of the traces.
        covariate: Covariate; ``all`` if all strokes are off what a simulated arm reads.
        p_adjusted: Probability of as much by chance, adjusted for the number of tests.
        phase: Phase of the stroke, for readings of traces: loading or after; null for the column itself.
    """

    channel: str
    """Column of the stroke table, or of the traces."""
    covariate: str
    """Covariate; ``all`` if all strokes are off what a simulated arm reads."""
    p_adjusted: float
    """Probability of as much by chance, adjusted for the number of tests."""
    phase: str | None
    """Phase of the stroke, for readings of traces: loading or after; null for the column itself."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseAnswer(Answer):
    """The answer of ``diagnose``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        beyond_known: That strokes lie beyond those from which the empirical terms of that file were made; null if
            none does.
        density_kg_m3: Recalibrated density with the effects, kg/m3.
        disagreements: Where readings of interface friction, zero or surface say what the verdict does not have,
            each with the reason.
        effects: Effects of the best explanation, best first; empty unless named, ambiguous or provisional.
        empirical: What takes the place of effects where the status is unknown: a change of the force over
            conditions of the strokes, which ``patch`` has. Empty otherwise.
        equivalence_set: What the data do not tell apart, best first; ids of effects, or ``unknown:<covariate>``.
        gap: How far model and measurement are apart.
        gap_by_channel: The gap of forces and of each column, on batches that were left out, forces first; empty
            with fewer than two batches. ``gap.csv`` has it along each condition.
        known_effects: Effects of that file, which were taken as known, and its empirical terms as ``a term over``
            their conditions; ``patch`` has them before those that were found.
        model: The force model without effects.
        model_file: The model file that the campaign was held against; null without one.
        nearest: Effects of the catalogue that come nearest where the status is unknown, best first, at most three;
            empty otherwise.
        next_experiment: The follow-up that would tell most; null if nothing on the menu would.
        not_resimulated_because: Why logs that are there cannot be simulated again; null otherwise.
        patch: Model file for ``--model-file``.
        phi_deg: Recalibrated friction angle with the effects, deg.
        report: HTML page; null if none was made.
        resimulated: Whether they were, or why not.
        scatter: Scatter of ln force of one stroke about the baseline.
        signals: The gap of each signal to the same strokes on the simulated arm; empty if they were not simulated.
        status: none, named, ambiguous, provisional, unknown or not_testable; only ``named`` is firm.
        strokes: Strokes.
        testability: What the design could show of each effect, before the forces were looked at.
        traces: Strokes whose trace was used.
        twin: The same for ``simulate``, with the soil that all signals ask for, where ``patch`` has the one with
            which the formulas come nearest to the forces; null if signals were not compared with those of the
            simulated arm.
        where: Disagreements of the recalibrated baseline that are more than chance.
    """

    schema: Literal["soilctl.diagnose/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    beyond_known: str | None
    """That strokes lie beyond those from which the empirical terms of that file were made; null if none does."""
    density_kg_m3: float
    """Recalibrated density with the effects, kg/m3."""
    disagreements: list[str]
    """Where readings of interface friction, zero or surface say what the verdict does not have, each with the
    reason.
    """
    effects: list[DiagnoseEffect]
    """Effects of the best explanation, best first; empty unless named, ambiguous or provisional."""
    empirical: list[DiagnoseTerm]
    """What takes the place of effects where the status is unknown: a change of the force over conditions of the
    strokes, which ``patch`` has. Empty otherwise.
    """
    equivalence_set: list[str]
    """What the data do not tell apart, best first; ids of effects, or ``unknown:<covariate>``."""
    gap: DiagnoseGap
    """How far model and measurement are apart."""
    gap_by_channel: list[DiagnoseChannelGap]
    """The gap of forces and of each column, on batches that were left out, forces first; empty with fewer than two
    batches. ``gap.csv`` has it along each condition.
    """
    known_effects: list[str]
    """Effects of that file, which were taken as known, and its empirical terms as ``a term over`` their conditions;
    ``patch`` has them before those that were found.
    """
    model: str
    """The force model without effects."""
    model_file: str | None
    """The model file that the campaign was held against; null without one."""
    nearest: list[DiagnoseNearest]
    """Effects of the catalogue that come nearest where the status is unknown, best first, at most three; empty
    otherwise.
    """
    next_experiment: DiagnoseNext | None
    """The follow-up that would tell most; null if nothing on the menu would."""
    not_resimulated_because: str | None
    """Why logs that are there cannot be simulated again; null otherwise."""
    patch: str
    """Model file for ``--model-file``."""
    phi_deg: float
    """Recalibrated friction angle with the effects, deg."""
    report: str | None
    """HTML page; null if none was made."""
    resimulated: Literal["compared", "no_logs", "not_wanted", "not_possible", "stopped"]
    """Whether they were, or why not."""
    scatter: float
    """Scatter of ln force of one stroke about the baseline."""
    signals: list[DiagnoseSignal]
    """The gap of each signal to the same strokes on the simulated arm; empty if they were not simulated."""
    status: str
    """none, named, ambiguous, provisional, unknown or not_testable; only ``named`` is firm."""
    strokes: int
    """Strokes."""
    testability: list[DiagnoseTestability]
    """What the design could show of each effect, before the forces were looked at."""
    traces: int
    """Strokes whose trace was used."""
    twin: str | None
    """The same for ``simulate``, with the soil that all signals ask for, where ``patch`` has the one with which the
    formulas come nearest to the forces; null if signals were not compared with those of the simulated arm.
    """
    where: list[DiagnoseWhere]
    """Disagreements of the recalibrated baseline that are more than chance."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestRate(Record):
    """A rate.

    Attributes:
        name: What is counted.
        of: Campaigns behind it.
        rate: The rate; null without campaigns.
    """

    name: str
    """What is counted."""
    of: int
    """Campaigns behind it."""
    rate: float | None
    """The rate; null without campaigns."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestAnswer(Answer):
    """The answer of ``diagnose_self_test``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        campaigns: Campaigns diagnosed.
        confusion: How often each hidden effect (lambda of at least 25) was answered by which first effect or
            status.
        model: Force model.
        rates: Rates by name, each with the number of campaigns behind it.
        seed: Seed.
    """

    schema: Literal["soilctl.diagnose-self-test/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    campaigns: int
    """Campaigns diagnosed."""
    confusion: dict[str, dict[str, int]]
    """How often each hidden effect (lambda of at least 25) was answered by which first effect or status."""
    model: str
    """Force model."""
    rates: list[DiagnoseSelfTestRate]
    """Rates by name, each with the number of campaigns behind it."""
    seed: int
    """Seed."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestLogsEntry(Record):
    """One hidden campaign, and what was said of it.

    Attributes:
        equivalence_set: What was not told apart.
        follow_up: What it gave with the strokes that were proposed; null if none were, or they were not made.
        found: Amplitudes that were found of hidden effects, each with its standard deviation, by effect.
        gap: Root mean square of all readings of batches that were left out, in standard deviations, without and
            with the effects that were given; null with fewer than two batches.
        given: Effects that were given, best first.
        hidden: What was hidden: effects, or ``outside_`` and a kind that no effect is; empty for nothing.
        number: Its number, from 0.
        soil: Preset of the soil.
        status: Status of the diagnosis; ``no_failures`` if no stroke failed the soil.
        strokes: Strokes that failed the soil.
    """

    equivalence_set: list[str]
    """What was not told apart."""
    follow_up: DiagnoseSelfTestLogsSaid | None
    """What it gave with the strokes that were proposed; null if none were, or they were not made."""
    found: dict[str, list[Any]]
    """Amplitudes that were found of hidden effects, each with its standard deviation, by effect."""
    gap: list[Any] | None
    """Root mean square of all readings of batches that were left out, in standard deviations, without and with the
    effects that were given; null with fewer than two batches.
    """
    given: list[str]
    """Effects that were given, best first."""
    hidden: list[DiagnoseSelfTestLogsPart]
    """What was hidden: effects, or ``outside_`` and a kind that no effect is; empty for nothing."""
    number: int
    """Its number, from 0."""
    soil: str
    """Preset of the soil."""
    status: str
    """Status of the diagnosis; ``no_failures`` if no stroke failed the soil."""
    strokes: int
    """Strokes that failed the soil."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestLogsPart(Record):
    """A part of what was hidden.

    Attributes:
        amplitude: Amplitude of the effect in the unit of its parameter, or the largest change of ln force.
        name: An effect, or ``outside_`` and a kind that no effect is.
    """

    amplitude: float
    """Amplitude of the effect in the unit of its parameter, or the largest change of ln force."""
    name: str
    """An effect, or ``outside_`` and a kind that no effect is."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestLogsRate(Record):
    """A rate.

    Attributes:
        name: What is counted.
        of: Campaigns behind it.
        rate: The rate; null without campaigns.
    """

    name: str
    """What is counted."""
    of: int
    """Campaigns behind it."""
    rate: float | None
    """The rate; null without campaigns."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestLogsSaid(Record):
    """What a diagnosis said.

    Attributes:
        equivalence_set: What was not told apart.
        found: Amplitudes that were found of hidden effects, each with its standard deviation, by effect.
        gap: Root mean square of all readings of batches that were left out, in standard deviations, without and
            with the effects that were given; null with fewer than two batches.
        given: Effects that were given, best first.
        status: Status of the diagnosis; ``no_failures`` if no stroke failed the soil.
        strokes: Strokes that failed the soil.
    """

    equivalence_set: list[str]
    """What was not told apart."""
    found: dict[str, list[Any]]
    """Amplitudes that were found of hidden effects, each with its standard deviation, by effect."""
    gap: list[Any] | None
    """Root mean square of all readings of batches that were left out, in standard deviations, without and with the
    effects that were given; null with fewer than two batches.
    """
    given: list[str]
    """Effects that were given, best first."""
    status: str
    """Status of the diagnosis; ``no_failures`` if no stroke failed the soil."""
    strokes: int
    """Strokes that failed the soil."""


@dataclass(frozen=True, repr=False, eq=False)
class DiagnoseSelfTestLogsAnswer(Answer):
    """The answer of ``diagnose_self_test_logs``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        campaigns: Campaigns that are diagnosed, by number.
        confusion: How often each hidden effect, or ``none``, was answered by which status and first effect.
        model: Force model.
        rates: Rates by name, each with the number of campaigns behind it. Campaigns in which no stroke failed the
            soil count nowhere.
        seed: Seed.
    """

    schema: Literal["soilctl.diagnose-self-test-logs/2"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    campaigns: list[DiagnoseSelfTestLogsEntry]
    """Campaigns that are diagnosed, by number."""
    confusion: dict[str, dict[str, int]]
    """How often each hidden effect, or ``none``, was answered by which status and first effect."""
    model: str
    """Force model."""
    rates: list[DiagnoseSelfTestLogsRate]
    """Rates by name, each with the number of campaigns behind it. Campaigns in which no stroke failed the soil
    count nowhere.
    """
    seed: int
    """Seed."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoDelta(Record):
    """Interface friction from the sweep of set-points.

    Attributes:
        above_deg: Highest set-point with a significant lift (deg).
        below_deg: Lowest set-point above that without one (deg).
        delta_deg: Estimate (deg).
        determined: Whether the sweep tells: a set-point lifts significantly, and the standard deviation is at most
            2 deg.
        error_deg: Estimate minus truth (deg).
        holds_truth: Whether the truth lies in the interval.
        interval_deg: Two standard deviations on either side, at least 1 (deg).
        sd_deg: Its standard deviation (deg).
    """

    above_deg: float | None
    """Highest set-point with a significant lift (deg)."""
    below_deg: float | None
    """Lowest set-point above that without one (deg)."""
    delta_deg: float
    """Estimate (deg)."""
    determined: bool
    """Whether the sweep tells: a set-point lifts significantly, and the standard deviation is at most 2 deg."""
    error_deg: float
    """Estimate minus truth (deg)."""
    holds_truth: bool
    """Whether the truth lies in the interval."""
    interval_deg: list[float]
    """Two standard deviations on either side, at least 1 (deg)."""
    sd_deg: float
    """Its standard deviation (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoEachStroke(Record):
    """A stroke of the plan.

    Attributes:
        alpha_deg: Tool angle (deg).
        batch: Preparation, from 1.
        delta_set_deg: Set-point of the interface friction (deg).
        depth_m: Depth that was wanted (m).
        error: The force that was found over that, minus 1.
        force_n: Failure force that was found (N).
        force_sd_n: Its standard deviation (N).
        limit_force_n: The most that the soil bore where and when the failure was found (N).
        measured_depth_m: Depth that was measured (m).
        number: Number in the plan, from 1.
        stroke_id: Its name in the stroke table; null if it has no failure force.
        true_depth_m: Depth at which the soil failed in truth (m).
        true_force_n: Force of the soil when it failed in truth (N); null if it did not fail.
        used_for_delta: Whether it was used for the interface friction.
        used_for_phi: Whether it was used for friction angle and density.
        why_none: Why it has no failure force; null if it has one.
    """

    alpha_deg: float
    """Tool angle (deg)."""
    batch: int
    """Preparation, from 1."""
    delta_set_deg: float
    """Set-point of the interface friction (deg)."""
    depth_m: float
    """Depth that was wanted (m)."""
    error: float | None
    """The force that was found over that, minus 1."""
    force_n: float | None
    """Failure force that was found (N)."""
    force_sd_n: float | None
    """Its standard deviation (N)."""
    limit_force_n: float | None
    """The most that the soil bore where and when the failure was found (N)."""
    measured_depth_m: float | None
    """Depth that was measured (m)."""
    number: int
    """Number in the plan, from 1."""
    stroke_id: str | None
    """Its name in the stroke table; null if it has no failure force."""
    true_depth_m: float | None
    """Depth at which the soil failed in truth (m)."""
    true_force_n: float | None
    """Force of the soil when it failed in truth (N); null if it did not fail."""
    used_for_delta: bool
    """Whether it was used for the interface friction."""
    used_for_phi: bool
    """Whether it was used for friction angle and density."""
    why_none: str | None
    """Why it has no failure force; null if it has one."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoFiles(Record):
    """Where everything is.

    Attributes:
        estimates: The estimates in JSON.
        figures: The figures.
        folder: The folder.
        logs: The logs.
        measurements: What of it the estimate used, with its error budget; null without an estimate.
        plan: The campaign plan.
        report: The page; null if the work was stopped before it.
        strokes: The stroke table; null without a failure force.
    """

    estimates: list[str]
    """The estimates in JSON."""
    figures: list[str]
    """The figures."""
    folder: str
    """The folder."""
    logs: list[str]
    """The logs."""
    measurements: str | None
    """What of it the estimate used, with its error budget; null without an estimate."""
    plan: str
    """The campaign plan."""
    report: str | None
    """The page; null if the work was stopped before it."""
    strokes: str | None
    """The stroke table; null without a failure force."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoForces(Record):
    """Failure forces against the truth.

    Attributes:
        compared: Strokes that were compared.
        median_error: Median of the relative errors' sizes.
        median_signed_error: Median of the relative errors with their sign.
        percentile_95_error: Their 95th percentile.
        share_within_10_percent: Share of the strokes that are within 10 %.
        share_within_one_sd: Share of the errors that are within one stated standard deviation; 0.68 if they are
            calibrated.
    """

    compared: int
    """Strokes that were compared."""
    median_error: float
    """Median of the relative errors' sizes."""
    median_signed_error: float
    """Median of the relative errors with their sign."""
    percentile_95_error: float
    """Their 95th percentile."""
    share_within_10_percent: float
    """Share of the strokes that are within 10 %."""
    share_within_one_sd: float
    """Share of the errors that are within one stated standard deviation; 0.68 if they are calibrated."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoRegion(Record):
    """Every soil that explains the forces.

    Attributes:
        confidence: Probability with which all bands together hold their true forces.
        consistent: Whether any soil does.
        density_holds_truth: Whether the true density lies in its range.
        density_kg_m3: Range of the density (kg/m3); null if inconsistent.
        density_known_kg_m3: What was known of the density (kg/m3).
        holds_truth: Whether true friction angle and density together lie in the region.
        phi_deg: Range of the friction angle (deg); null if inconsistent.
        phi_holds_truth: Whether the true friction angle lies in its range.
        verdict: The result in words.
    """

    confidence: float | None
    """Probability with which all bands together hold their true forces."""
    consistent: bool
    """Whether any soil does."""
    density_holds_truth: bool
    """Whether the true density lies in its range."""
    density_kg_m3: list[float] | None
    """Range of the density (kg/m3); null if inconsistent."""
    density_known_kg_m3: list[float] | None
    """What was known of the density (kg/m3)."""
    holds_truth: bool
    """Whether true friction angle and density together lie in the region."""
    phi_deg: list[float] | None
    """Range of the friction angle (deg); null if inconsistent."""
    phi_holds_truth: bool
    """Whether the true friction angle lies in its range."""
    verdict: str
    """The result in words."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoStrokeCount(Record):
    """How many strokes there are.

    Attributes:
        asked: In the plan.
        made: Made by the arm to their end.
        used_for_delta: Used for the interface friction.
        used_for_phi: Used for friction angle and density.
        with_force: With a failure force.
    """

    asked: int
    """In the plan."""
    made: int
    """Made by the arm to their end."""
    used_for_delta: int
    """Used for the interface friction."""
    used_for_phi: int
    """Used for friction angle and density."""
    with_force: int
    """With a failure force."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoTruth(Record):
    """What is true of the soil.

    Attributes:
        cohesion_pa: Cohesion (Pa); the estimate takes it as known.
        delta_deg: Friction angle between soil and plate (deg).
        density_kg_m3: Bulk density (kg/m3).
        end_factor: Part of what the plate's ends add at most, by the proven bounds, that they add; 0 in plane
            strain.
        gravity_m_s2: Gravity (m/s2); the estimate takes it as known.
        phi_deg: Friction angle (deg).
    """

    cohesion_pa: float
    """Cohesion (Pa); the estimate takes it as known."""
    delta_deg: float
    """Friction angle between soil and plate (deg)."""
    density_kg_m3: float
    """Bulk density (kg/m3)."""
    end_factor: float
    """Part of what the plate's ends add at most, by the proven bounds, that they add; 0 in plane strain."""
    gravity_m_s2: float
    """Gravity (m/s2); the estimate takes it as known."""
    phi_deg: float
    """Friction angle (deg)."""


@dataclass(frozen=True, repr=False, eq=False)
class DemoAnswer(Answer):
    """The answer of ``demo``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        complete: Whether everything ran to its end; otherwise the same command goes on.
        delta: Interface friction from the sweep; null if there is none.
        delta_guess_deg: Published interface friction (deg), around which the set-points lie. The estimate from the
            sweep does not use it.
        delta_used_deg: Interval of the interface friction (deg): from the sweep if it tells, else around the
            published one; null if there is no estimate. The estimate takes the inclination of each stroke's force
            at failure, up to the end of the interval.
        density_unknown: Friction angle and density from the forces, nothing known of the density; null if there is
            no estimate.
        density_weighed: The same with the density that was weighed; null if there is no estimate.
        each: Every stroke of the plan.
        files: Where everything is.
        forces: Failure forces against the truth; null without a stroke to compare.
        found: What was found, beside the truth, in words; empty if the work was stopped.
        model: Force model of the simulated soil and of the estimate.
        no_delta: Why there is none, or why it does not count; null if it does.
        no_estimate: Why there is no estimate.
        not_recovered: What was not recovered, in words; empty if everything was.
        seed: Seed of noise and scatter.
        soil: Name of the soil.
        strokes: What became of the strokes.
        title: The soil in words.
        true_forces: The estimate that the same strokes would give with the forces and depths that are true and the
            density unknown: what is lost by reading them from the logs; null if there is none.
        truth: What is true of the soil. Only comparisons use it.
    """

    schema: Literal["soilctl.demo/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    complete: bool
    """Whether everything ran to its end; otherwise the same command goes on."""
    delta: DemoDelta | None
    """Interface friction from the sweep; null if there is none."""
    delta_guess_deg: float
    """Published interface friction (deg), around which the set-points lie. The estimate from the sweep does not use
    it.
    """
    delta_used_deg: list[float] | None
    """Interval of the interface friction (deg): from the sweep if it tells, else around the published one; null if
    there is no estimate. The estimate takes the inclination of each stroke's force at failure, up to the end of
    the interval.
    """
    density_unknown: DemoRegion | None
    """Friction angle and density from the forces, nothing known of the density; null if there is no estimate."""
    density_weighed: DemoRegion | None
    """The same with the density that was weighed; null if there is no estimate."""
    each: list[DemoEachStroke]
    """Every stroke of the plan."""
    files: DemoFiles
    """Where everything is."""
    forces: DemoForces | None
    """Failure forces against the truth; null without a stroke to compare."""
    found: str
    """What was found, beside the truth, in words; empty if the work was stopped."""
    model: str
    """Force model of the simulated soil and of the estimate."""
    no_delta: str | None
    """Why there is none, or why it does not count; null if it does."""
    no_estimate: str | None
    """Why there is no estimate."""
    not_recovered: list[str]
    """What was not recovered, in words; empty if everything was."""
    seed: int
    """Seed of noise and scatter."""
    soil: str
    """Name of the soil."""
    strokes: DemoStrokeCount
    """What became of the strokes."""
    title: str
    """The soil in words."""
    true_forces: DemoRegion | None
    """The estimate that the same strokes would give with the forces and depths that are true and the density
    unknown: what is lost by reading them from the logs; null if there is none.
    """
    truth: DemoTruth
    """What is true of the soil. Only comparisons use it."""


@dataclass(frozen=True, repr=False, eq=False)
class LogContent(Record):
    """What is in a log.

    Attributes:
        attachments: Names of the attachments.
        end_s: Log time of the last message in s, or the latest time.
        keyframes: Key frames, from which a replay can begin.
        missing_steps: Steps that are missing between them.
        session: What made the log, as the log says: version, seed, model.
        start_s: Log time of the first message in s, of a recording of another program the earliest time on its
            clock; null if there is none.
        steps: Steps of the controller.
        strokes: Boundaries and settings of the strokes, as the log says.
        topics: Topics.
        found: What else was found; only of recordings of other programs.
    """

    attachments: list[str]
    """Names of the attachments."""
    end_s: float | None
    """Log time of the last message in s, or the latest time."""
    keyframes: int
    """Key frames, from which a replay can begin."""
    missing_steps: int
    """Steps that are missing between them."""
    session: dict[str, str]
    """What made the log, as the log says: version, seed, model."""
    start_s: float | None
    """Log time of the first message in s, of a recording of another program the earliest time on its clock; null if
    there is none.
    """
    steps: int
    """Steps of the controller."""
    strokes: list[dict[str, str]]
    """Boundaries and settings of the strokes, as the log says."""
    topics: list[LogTopic]
    """Topics."""
    found: LogFound | None = None
    """What else was found; only of recordings of other programs."""


@dataclass(frozen=True, repr=False, eq=False)
class LogFound(Record):
    """What else was found in a recording of another program.

    Attributes:
        clock_origin_s: Where the times of this answer begin, in s of the stamps: a whole second of a wall clock, or
            0. It is the clock of ``process --strokes``.
        compression: Compressions of its chunks, messages or file; empty if nothing is compressed.
        container: What it is kept in, such as ``MCAP`` or ``ROS 1 bag``.
        duration_s: From the earliest to the latest time in s.
        has_urdf: Whether there is a URDF in it.
        implausible: Numbers that cannot be in the units of ROS.
        library: What wrote it, as it says; may be empty.
        oddities: What is odd about the messages of joint states and wrenches, such as clocks that were set.
    """

    clock_origin_s: int
    """Where the times of this answer begin, in s of the stamps: a whole second of a wall clock, or 0. It is the
    clock of ``process --strokes``.
    """
    compression: list[str]
    """Compressions of its chunks, messages or file; empty if nothing is compressed."""
    container: str
    """What it is kept in, such as ``MCAP`` or ``ROS 1 bag``."""
    duration_s: float
    """From the earliest to the latest time in s."""
    has_urdf: bool
    """Whether there is a URDF in it."""
    implausible: list[str]
    """Numbers that cannot be in the units of ROS."""
    library: str
    """What wrote it, as it says; may be empty."""
    oddities: list[str]
    """What is odd about the messages of joint states and wrenches, such as clocks that were set."""


@dataclass(frozen=True, repr=False, eq=False)
class LogGap(Record):
    """A time without messages.

    Attributes:
        from_s: Time of the message before it in s.
        to_s: Time of the message after it in s.
    """

    from_s: float
    """Time of the message before it in s."""
    to_s: float
    """Time of the message after it in s."""


@dataclass(frozen=True, repr=False, eq=False)
class LogTopic(Record):
    """A topic.

    Attributes:
        messages: How many there are.
        topic: Its name.
        type: Type of its messages.
        end_s: Latest time in s.
        gaps: Times between two messages that are longer than five medians.
        kind: What they tell: ``joints``, ``wrench``, ``text`` or ``points``, if one of these. This and what follows
            is there only of recordings of other programs.
        longest_gaps: The longest of them, ten at most, in order of time.
        problem: Why the messages cannot be read, if they cannot.
        rate_hz: Messages a second, by the median of the times between two; missing for fewer than three of these.
        start_s: Earliest time in s.
    """

    messages: int
    """How many there are."""
    topic: str
    """Its name."""
    type: str
    """Type of its messages."""
    end_s: float | None = None
    """Latest time in s."""
    gaps: int | None = None
    """Times between two messages that are longer than five medians."""
    kind: str | None = None
    """What they tell: ``joints``, ``wrench``, ``text`` or ``points``, if one of these. This and what follows is
    there only of recordings of other programs.
    """
    longest_gaps: list[LogGap] | None = None
    """The longest of them, ten at most, in order of time."""
    problem: str | None = None
    """Why the messages cannot be read, if they cannot."""
    rate_hz: float | None = None
    """Messages a second, by the median of the times between two; missing for fewer than three of these."""
    start_s: float | None = None
    """Earliest time in s."""


@dataclass(frozen=True, repr=False, eq=False)
class LogWritten(Record):
    """What was written.

    Attributes:
        columns: Columns of the table; null for ``recover``.
        file: The file.
        rows: Messages, or rows of the table.
        topic: The exported topic; null for ``recover``.
        clock_origin_s: Where ``time_s`` begins, in s of the stamps; only of recordings of other programs.
    """

    columns: int | None
    """Columns of the table; null for ``recover``."""
    file: str
    """The file."""
    rows: int
    """Messages, or rows of the table."""
    topic: str | None
    """The exported topic; null for ``recover``."""
    clock_origin_s: int | None = None
    """Where ``time_s`` begins, in s of the stamps; only of recordings of other programs."""


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
class DoctorCheck(Record):
    """Something that was looked for. Nothing of it is needed for predictions, bounds, estimates and diagnoses.

    Attributes:
        detail: Where it is, or how to get it.
        found: Whether it is there.
        needed_for: What it is needed for.
        what: What.
    """

    detail: str
    """Where it is, or how to get it."""
    found: bool
    """Whether it is there."""
    needed_for: str
    """What it is needed for."""
    what: Literal["browser", "viewer", "python-package", "real-time"]
    """What."""


@dataclass(frozen=True, repr=False, eq=False)
class DoctorAnswer(Answer):
    """The answer of ``doctor``.

    Attributes:
        schema: Id of this schema.
        version: Version of the program.
        checks: What was looked for, in order.
        processors: Processors that work is shared out to.
        program: The program that answers.
    """

    schema: Literal["soilctl.doctor/1"]
    """Id of this schema."""
    version: str
    """Version of the program."""
    checks: list[DoctorCheck]
    """What was looked for, in order."""
    processors: int
    """Processors that work is shared out to."""
    program: str | None
    """The program that answers."""


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
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "chen",
    model_table: PathLike | None = None,
    alpha_deg: float | None = None,
    model_file: PathLike | None = None,
    phi_deg: float | None = None,
    friction_law: Sequence[Any] | None = None,
    reference_stress_pa: float | None = None,
    delta_deg: Literal["column"] | float | None = None,
    density_kg_m3: Literal["column"] | float | None = None,
    depth_m: float | None = None,
    width_m: float | None = None,
    ends: Literal["finite", "none"] | None = None,
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
        model: Force model.
        model_table: A table file (.csv or .parquet) as the model.
        alpha_deg: Tool angle from the horizontal (deg).
        model_file: A model file, such as the patch of ``diagnose``: force model, soil and effects; ``phi_deg``,
            ``delta_deg`` and ``density_kg_m3`` replace its values.
        phi_deg: Internal friction angle of the soil (deg).
        friction_law: Friction falls with stress: by so many degrees a decade of normal stress, between LOW and
            HIGH. ``phi_deg`` is then the friction angle at ``reference_stress_pa``.
        reference_stress_pa: Normal stress (Pa) at which ``phi_deg`` is the friction angle, with ``friction_law``.
            Above 0.
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for delta_set_deg of ``strokes``.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of ``strokes``.
        depth_m: Vertical depth of the plate's lower edge below the surface (m).
        width_m: Width of the plate (m).
        ends: Whether the plate has ends; by default it has them for the models that know ends: mckyes, perumpral,
            godwin-spoor, ovesen and blocks-3d, which then take width and depth, and ``table`` where these are
            given.
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


def bound(
    alpha_deg: float,
    phi_deg: float,
    delta_deg: float,
    *,
    friction_law: float | None = None,
    reference_stress_pa: float | None = None,
    density_kg_m3: float | None = None,
    depth_m: float | None = None,
    width_m: float | None = None,
    width_ratio: float | None = None,
    ends: Literal["finite", "none"] | None = None,
    tetrahedra: int = 400,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    save: PathLike | None = None,
    progress: Progress = None,
) -> BoundAnswer:
    """Proven lower and upper bounds on a plate's force, by limit analysis.

    Args:
        alpha_deg: Tool angle from the horizontal (deg), 10 to 170.
        phi_deg: Internal friction angle of the soil (deg), above 0 and below 70.
        delta_deg: Friction angle between soil and plate (deg), at most phi.
        friction_law: Friction falls with stress: by so many degrees a decade of normal stress, 0.1 to 8.
            ``phi_deg`` is then the friction angle at ``reference_stress_pa``. At least 0.1 and at most 8.
        reference_stress_pa: Normal stress (Pa) at which ``phi_deg`` is the friction angle, with ``friction_law``.
            Above 0.
        density_kg_m3: Bulk density (kg/m3); needed for forces, and with cohesion, adhesion or surcharge.
        depth_m: Vertical depth of the plate's lower edge below the surface (m); likewise.
        width_m: Width of the plate (m); needed for forces, and with it the plate has ends.
        width_ratio: Width over vertical depth, where neither is given in metres. Above 0.
        ends: Whether the plate has ends: ``finite`` for one with a width unless it is said otherwise, ``none`` for
            plane strain.
        tetrahedra: About how many tetrahedra the stress field about an end of a plate has, which bounds from below
            what ends add: more take longer and narrow the bracket; 0 for none. At least 0 and at most 10000.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        save: Saves the fields that prove the bounds, for ``soilctl certify``.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("bound", bound, locals(), BoundAnswer)


def tool(
    file: str,
    phi_deg: float,
    density_kg_m3: float,
    *,
    alpha_deg: float | None = None,
    alpha_of: Literal["chord", "tip"] = "chord",
    delta_deg: float | None = None,
    depth_m: float | None = None,
    direction_deg: float = 0.0,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    width_m: float | None = None,
    forces: int | None = None,
    phis_deg: str | None = None,
    deltas_deg: str | None = None,
    table: PathLike | None = None,
    save: PathLike | None = None,
    problem: PathLike | None = None,
    progress: Progress = None,
) -> ToolAnswer:
    """Proven lower and upper bounds on the force of a curved blade, a bucket, or any other tool in section, by
    limit analysis.

    Args:
        file: Tool file, .toml, .json or .csv: points from tip to top, or an arc.
        phi_deg: Internal friction angle of the soil (deg), above 0 and below 70. Above 0 and below 70.
        density_kg_m3: Bulk density (kg/m3). Above 0.
        alpha_deg: Turns the tool so that it has this tool angle from the horizontal (deg), below 90 with the tip
            ahead; as drawn if not given. At least -180 and at most 180.
        alpha_of: What ``alpha_deg`` is the angle of.
        delta_deg: Friction angle between soil and tool (deg), at most phi, where the tool file says none. At least
            0.
        depth_m: Vertical depth of the tool's lowest point below the surface (m); with its highest point at the
            surface if not given. Above 0.
        direction_deg: Direction in which the tool moves, from the horizontal (deg): above 0 upwards. At least -90
            and at most 90.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        width_m: Width of the tool (m): bounds are of a tool with ends, and with the side plates of its file; a tool
            without ends, per metre, if not given. Above 0.
        forces: Also bounds the forces that the soil bears on the tool held against turning, with motions in so many
            directions; 12 take twelve times as long. At least 3 and at most 72.
        phis_deg: Friction angles of the soil for ``table`` (deg); ``phi_deg`` alone if not given.
        deltas_deg: Friction angles of interfaces that the tool file leaves out, for ``table`` (deg); ``delta_deg``
            alone if not given.
        table: Also writes the bounds over friction angles as a table (.csv or .parquet); what it was made from goes
            beside it, with .json added, and a table that was broken off is gone on with.
        save: Saves the fields that prove the bounds, for ``soilctl certify``; with ``width_m`` the upper one in a
            file beside, NAME.front.json or NAME.blocks.json; with ``forces`` NAME.1.json and so on for the other
            directions.
        problem: Writes the problem as a problem file (.toml), to be changed and solved by ``soilctl solve``.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("tool", tool, locals(), ToolAnswer)


def obstacle(
    file: str,
    phi_deg: float,
    density_kg_m3: float,
    body_top_m: float,
    body_height_m: float,
    *,
    alpha_deg: float | None = None,
    alpha_of: Literal["chord", "tip"] = "chord",
    delta_deg: float | None = None,
    depth_m: float | None = None,
    direction_deg: float = 0.0,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    ahead_m: Sequence[float] = (),
    body_length_m: float | None = None,
    body: Literal["fixed", "stone"] = "fixed",
    scatter: float = 0.1,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    save: PathLike | None = None,
    problem: PathLike | None = None,
    table: PathLike | None = None,
    progress: Progress = None,
) -> ObstacleAnswer:
    """From what distance on the force of a tool says that something is buried ahead: proven bounds near a rigid
    body, over its distance.

    Args:
        file: Tool file, .toml, .json or .csv: points from tip to top, or an arc.
        phi_deg: Internal friction angle of the soil (deg), above 0 and below 70. Above 0 and below 70.
        density_kg_m3: Bulk density (kg/m3). Above 0.
        body_top_m: Depth of the body's top below the surface (m). Above 0.
        body_height_m: Its height (m). Above 0.
        alpha_deg: Turns the tool so that it has this tool angle from the horizontal (deg), below 90 with the tip
            ahead; as drawn if not given. At least -180 and at most 180.
        alpha_of: What ``alpha_deg`` is the angle of.
        delta_deg: Friction angle between soil and tool (deg), at most phi, where the tool file says none. At least
            0.
        depth_m: Vertical depth of the tool's lowest point below the surface (m); with its highest point at the
            surface if not given. Above 0.
        direction_deg: Direction in which the tool moves, from the horizontal (deg): above 0 upwards. At least -90
            and at most 90.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        ahead_m: Distances from the tool's tip ahead to the body, along the surface (m); by default 0.25, 0.5, 1,
            1.5, 2, 3 and 4 times what of the tool is in the ground. At least 1e-06.
        body_length_m: Its length along the motion (m); as long as high if not given. Above 0.
        body: What the body does.
        scatter: Relative scatter of measured forces: the body shows where it adds more than that. At least 0 and at
            most 10.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        save: Saves the fields that prove the bounds, for ``soilctl certify``: without the body as
            NAME.without.json, by distance as NAME.1.json and so on.
        problem: Writes the problems as problem files likewise (.toml).
        table: Writes the table over the distance (.csv or .parquet).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("obstacle", obstacle, locals(), ObstacleAnswer)


def solve(
    file: PathLike,
    *,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    save: PathLike | None = None,
    progress: Progress = None,
) -> SolveAnswer:
    """Proven bounds for any plane-strain collapse problem described in a file.

    Args:
        file: Problem file, .toml or .json.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        save: Saves the fields that prove the bounds, for ``soilctl certify``; for a factor of safety several files.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("solve", solve, locals(), SolveAnswer)


def solve_check(
    file: PathLike,
    *,
    progress: Progress = None,
) -> SolveCheckAnswer:
    """Reads a problem file and says what it was understood to mean.

    Args:
        file: Problem file, .toml or .json.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("solve check", solve_check, locals(), SolveCheckAnswer)


def convert(
    file: str,
    out: PathLike,
    *,
    replace: bool = False,
    soils: str | None = None,
    unit: str | None = None,
    water: str | None = None,
    leave_out: Sequence[str] = (),
    holes: Sequence[str] = (),
    join_m: float = 0.001,
    chord_m: float = 0.01,
    progress: Progress = None,
) -> ConvertAnswer:
    """Makes a problem file of a drawing, or a drawing of a problem file.

    Args:
        file: A drawing (.dxf, .geojson, .csv), boreholes (.ags), or a problem file (.toml, .json).
        out: What is written: a problem file of a drawing, a drawing of a problem file.
        replace: Write over a file that is there.
        soils: Strengths and weights (.csv) with the columns name, ``phi_deg``, ``unit_weight_kn_m3`` and, if
            wanted, other keys of a problem's soil; a name is that of a layer.
        unit: Unit of the drawing's coordinates, whatever it says itself: mm, cm, dm, m, km, in or ft.
        water: Layer of the water table; by default one whose name says so, such as water, groundwater, phreatic or
            gwl.
        leave_out: Layers that are no part of the section (a list with commas).
        holes: Boreholes of an AGS file that the section goes through, in this order (a list with commas); by
            default all.
        join_m: Corners and ends of lines that are as near as this are one, and a corner that is as near to an edge
            is on it (m). At least 0 and at most 1.
        chord_m: How far chords may be from their arcs (m). At least 0.0001 and at most 10.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("convert", convert, locals(), ConvertAnswer)


def design(
    file: PathLike,
    *,
    other: PathLike | None = None,
    parameter: str | None = None,
    from_value: float | None = None,
    to_value: float | None = None,
    wanted: float = 1.0,
    within: float | None = None,
    most: int = 12,
    out: PathLike | None = None,
    replace: bool = False,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    progress: Progress = None,
) -> DesignAnswer:
    """The least of something that is enough, by proven bounds: an anchor's strength, a length, a slope, a water
    level.

    Args:
        file: The problem file, .toml or .json.
        other: A second problem file with the same entries, to go towards: all numbers go from the first to this one
            at once, as of a steeper slope or a longer wall, and values are parts of that way.
        parameter: What changes, instead of a second file: a parameter as in ``[[sweep]]``, such as
            ``member.nail.tensile_kn_per_m`` or ``head.reservoir.head_m``.
        from_value: One end of the values of the parameter.
        to_value: The other end.
        wanted: What the bounded quantity must reach in all cases of the file: a factor, a force in kN/m, or an
            acceleration over gravity.
        within: How near to each other a value that is enough and one that is not shall be. Above 0.
        most: Most values to try. At least 2 and at most 100.
        out: Writes the problem file with the value that is enough (.toml).
        replace: Write over a file that is there.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("design", design, locals(), DesignAnswer)


def stability(
    region: str,
    problem: str,
    *,
    soil: str | None = None,
    required: float | None = None,
    gravity_m_s2: float | None = None,
    keep_weight: bool = False,
    constant_friction: bool = False,
    trials: int = 4,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    progress: Progress = None,
) -> StabilityAnswer:
    """Whether what a problem file describes stands for every soil that explains the strokes, or that was published.

    Args:
        region: The soils: the JSON answer of ``soilctl estimate``, or of ``soilctl soils NAME``.
        problem: The problem file, .toml or .json, which asks for a factor of safety, a factor on live loads or
            weights, or the force of a structure.
        soil: Which soil of the problem is the one that is asked about; needed if it has several.
        required: Least factor with which it is said to stand, 1 if not given; of a structure the least force (kN/m)
            that the soil must bear, which has to be given. Above 0.
        gravity_m_s2: Gravity at the problem (m/s2), which makes the unit weight of the soil: 3.71 on Mars, 1.62 on
            the Moon; by default that of the Earth, or of where the published soil is. Above 0 and at most 1000.
        keep_weight: Keep the unit weight of the problem file, as where the soil is wet there and the strokes were
            made in dry soil.
        constant_friction: Take the friction angle, and the cohesion if it is published, at any stress. Without a
            law of stress a problem whose stresses are others is refused otherwise, since friction falls with
            stress.
        trials: Further soils to try, between the weakest and the strongest, where the answer depends on the soil.
            At least 0 and at most 100.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("stability", stability, locals(), StabilityAnswer)


def climb(
    region: str,
    wheel_load_n: float,
    contact_length_m: float,
    wheel_width_m: float,
    *,
    slope_deg: float | None = None,
    bond_factor: float = 1.0,
    within_deg: float = 0.5,
    gravity_m_s2: float | None = None,
    constant_friction: bool = False,
    max_gap: float = 0.01,
    max_elements: int = 20000,
    max_work: int = 3000000,
    max_seconds: float | None = None,
    max_memory_mb: int | None = None,
    threads: int = 1,
    factorisation: Literal["auto", "qdldl", "faer"] = "auto",
    segments: int | None = None,
    dump: PathLike | None = None,
    progress: Progress = None,
) -> ClimbAnswer:
    """Up to which slope a wheel or a track climbs on every soil that explains the strokes, or that was published.

    Args:
        region: The soils: the JSON answer of ``soilctl estimate``, or of ``soilctl soils NAME``.
        wheel_load_n: Weight (N) that one wheel bears on level ground there. Above 0.
        contact_length_m: Length (m) over which it touches the ground, along its way. At least 0.001 and at most
            100.
        wheel_width_m: Width (m) of the wheel. At least 0.001 and at most 100.
        slope_deg: Asks about this slope (deg) alone. At least 0 and at most 60.
        bond_factor: Part of the soil's strength that the wheel's face has, 1 with grousers. Above 0 and at most 1.
        within_deg: Slopes are told to this (deg). At least 0.05 and at most 20.
        gravity_m_s2: Gravity (m/s2), which makes the weight of the soil: 3.71 on Mars, 1.62 on the Moon; by default
            that of the Earth, or of where the published soil is. Above 0 and at most 1000.
        constant_friction: Take the friction angle, and the cohesion if it is published, at any stress. A wheel
            under which stresses are others is refused otherwise, since friction falls with stress.
        max_gap: Gap (U - L) / ((U + L) / 2) at which to stop. Above 0.
        max_elements: Most elements of a mesh. At least 1000 and at most 1e+06.
        max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
            machine. At least 1.
        max_seconds: Time that may be spent (s); where the run ends then depends on the machine, and the answer says
            so. Above 0.
        max_memory_mb: Memory that may be used (MB): a mesh whose programs may need more is not made. At least 100.
        threads: Threads; the bounds are the same for any number. At least 1 and at most 1024.
        factorisation: What factorises the systems of the solver's steps: bounds differ in their last digits;
            ``auto`` goes by the size of the programs.
        segments: Solves with strength linearised to so many sides, from inside, instead of cones: for comparison,
            slower and wider. At least 3 and at most 1000.
        dump: Existing folder for programs on which the solver failed, to reproduce that from.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("climb", climb, locals(), ClimbAnswer)


def soils(
    *,
    name: str | None = None,
    body: Literal["earth", "moon", "mars"] | None = None,
    progress: Progress = None,
) -> SoilsAnswer:
    """Soils with strength and density as published.

    Args:
        name: One soil by its name; all of them if not given.
        body: Those of one body only.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("soils", soils, locals(), SoilsAnswer)


def certify(
    file: PathLike,
    *,
    progress: Progress = None,
) -> CertifyAnswer:
    """Proves the bounds of a saved solution anew.

    Args:
        file: A solution saved with ``soilctl bound --save``.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("certify", certify, locals(), CertifyAnswer)


def table_show(
    table: str,
    *,
    progress: Progress = None,
) -> TableAnswer:
    """Prints a table.

    Args:
        table: A table file (.csv or .parquet, with its .json beside it) or a built-in table: appendix-c-coulomb,
            appendix-c-log-spiral, appendix-c-chen, appendix-c-caquot, appendix-c-num-ub, appendix-c-num-lb,
            plate-bounds.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("table show", table_show, locals(), TableAnswer)


def table_build(
    *,
    model: str = "bounds",
    grid: Literal["appendix-c", "wide"] = "appendix-c",
    alpha_deg: str | None = None,
    phi_deg: str | None = None,
    delta_deg: str | None = None,
    out: PathLike | None = None,
    max_gap: float | None = None,
    max_elements: int | None = None,
    threads: int | None = None,
    shard: str | None = None,
    store: PathLike | None = None,
    save: PathLike | None = None,
    dry_run: bool = False,
    progress: Progress = None,
) -> TableAnswer:
    """Fills a table, with proven bounds or from another model; fills what is missing in one that is there.

    Args:
        model: Model: bounds (lower and upper bound by limit analysis, both proven), or coulomb, log-spiral,
            log-spiral-thesis, caquot, chen, thesis-ub, thesis-lb, table.
        grid: Grid: appendix-c, the 287 sets of the thesis, or wide.
        alpha_deg: Nodes of the tool angle (deg).
        phi_deg: Nodes of the friction angle of the soil (deg).
        delta_deg: Nodes of the interface friction angle (deg).
        out: File to write (.csv, or .parquet if it is not bounds); its description goes beside it, with .json
            added. Not needed with ``store``.
        max_gap: Bounds: gap (U - L) / ((U + L) / 2) at which a case is done. Above 0.
        max_elements: Bounds: most elements that a case is given. At least 600 and at most 1e+06.
        threads: Bounds: cases solved at a time; the table is the same for any number. At least 1 and at most 1024.
        shard: Bounds: only each N-th case, starting with the I-th; all shards may fill one ``store``, or ``table
            merge`` unites their files.
        store: Bounds: folder where each solved case is a file of its own, for any number of runs and machines at a
            time; what is there is not solved again.
        save: Bounds: folder for the fields that prove each case, for ``soilctl certify``.
        dry_run: Bounds: only says how many cases there are and how long they will take.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("table build", table_build, locals(), TableAnswer)


def table_merge(
    files: Sequence[PathLike],
    out: PathLike,
    *,
    progress: Progress = None,
) -> TableAnswer:
    """Unites the tables of bounds that ``build --shard`` made.

    Args:
        files: Files to unite, built by the same version with the same --max-gap and --max-elements.
        out: File to write (.csv).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("table merge", table_merge, locals(), TableAnswer)


def table_check(
    table: str,
    *,
    against: Sequence[str] = (),
    progress: Progress = None,
) -> TableAnswer:
    """Checks a table; it is inconsistent if a coefficient does not grow with alpha, phi or delta.

    Args:
        table: A table file (.csv or .parquet, with its .json beside it) or a built-in table: appendix-c-coulomb,
            appendix-c-log-spiral, appendix-c-chen, appendix-c-caquot, appendix-c-num-ub, appendix-c-num-lb,
            plate-bounds.
        against: With a table of bounds: another table of lower or upper bounds, whose errors it proves; may be
            repeated.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("table check", table_check, locals(), TableAnswer)


def estimate(
    file: Table,
    delta_deg: Literal["column"] | float = "column",
    *,
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "table",
    ends: Literal["finite", "none"] | None = None,
    end_tolerance: float = 0.1,
    model_file: PathLike | None = None,
    delta_tol_deg: float = 1.0,
    density_kg_m3: Literal["column"] | float | None = None,
    density_tol: float = 0.04,
    confidence: float | None = None,
    sigma: float | None = None,
    uncertainty: Literal["sigma", "bounds"] = "sigma",
    adjust_high_angles: float = 0.0,
    friction_law: Sequence[Any] | None = None,
    reference_stress_pa: float | None = None,
    shear_box: Table | None = None,
    shear_soil: str | None = None,
    shear_tol_deg: float = 2.0,
    phi_range_deg: Sequence[Any] | None = None,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    cohesion_range_pa: Sequence[Any] | None = None,
    adhesion_range_pa: Sequence[Any] | None = None,
    adhesion_share: Sequence[Any] | None = None,
    surcharge_range_pa: Sequence[Any] | None = None,
    beta_range_deg: Sequence[Any] | None = None,
    costs: bool = False,
    sections_deg: Sequence[float] = (),
    next_strokes: bool = False,
    next_alpha_deg: Sequence[float] = (40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 110.0),
    next_depth_m: Sequence[float] = (),
    next_width_m: Sequence[float] = (),
    force_limit_n: float | None = None,
    exact: bool = False,
    compare: bool = False,
    progress: Progress = None,
) -> EstimateAnswer:
    """Every soil that could have produced the measured forces.

    Args:
        file: Stroke table (CSV).
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for what the table says: the measured
            friction_angle_deg where strokes of one kind are taken together, otherwise delta_set_deg.
        model: Force model; ``table`` is the bracket of proven bounds.
        ends: Whether plates have ends, each its own width: the force is then above that of plane strain. By default
            they have them for the models that know ends (table, mckyes, perumpral, godwin-spoor, ovesen); the other
            models are of plane strain.
        end_tolerance: By how much the end factor of a stroke may differ from one that all strokes share. It is the
            part of what ends add at most, by the proven bracket of ``table``, that the ends of a plate do add. At 1
            strokes share nothing. At least 0 and at most 1.
        model_file: A model file, such as the patch of ``diagnose``: its effects are taken out of the measured
            forces first, at the soil of the file.
        delta_tol_deg: Half width of what is known of delta (deg). At least 0.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of the table; left out: unknown.
        density_tol: Relative half width of what is known of the density. At least 0 and below 1.
        confidence: Probability with which all bands together hold their true forces, where strokes of one kind are
            taken together. Left out, they are if the table says how forces scatter: if strokes are repeated, or it
            has depth_sd_m. Above 0 and below 1.
        sigma: Standard deviations that a band reaches on either side of the force; each stroke with force_sd_n has
            a band of its own then. Above 0.
        uncertainty: What the uncertainty of a force means.
        adjust_high_angles: Allow that forces at tool angles of 90 deg and more were read low by up to this
            fraction, because friction was not fully mobilised when failure was read (0.1 in Hong 2001, section
            7.5.1). At least 0.
        friction_law: Take friction as a law of stress: it falls by so many degrees a decade of normal stress, known
            to lie between LOW and HIGH (````friction_law```` alone: 0:8). phi is then the friction angle at the
            reference stress.
        reference_stress_pa: Normal stress at which phi is told (Pa), with a law of stress; default: the middle of
            the stresses in the strokes.
        shear_box: Tests of the same soil in direct shear (a table of friction angles against normal stress), with a
            law of stress.
        shear_soil: The soil in the table of direct shear; needed if it has several.
        shear_tol_deg: Half width of what a test in direct shear says of the friction angle (deg): its scatter, and
            what the box itself may be off by. Above 0.
        phi_range_deg: Friction angles to search (deg), LOW:HIGH.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        cohesion_range_pa: Cohesion of the soil (Pa) as an unknown between LOW and HIGH, instead of
            ````cohesion_pa````.
        adhesion_range_pa: Adhesion between soil and plate (Pa) as an unknown between LOW and HIGH, instead of
            ````adhesion_pa````.
        adhesion_share: Adhesion as an unknown part of the cohesion between LOW and HIGH, 0 to 1, instead of
            ````adhesion_pa````.
        surcharge_range_pa: Vertical pressure on the surface (Pa) as an unknown between LOW and HIGH, instead of
            ````surcharge_pa````.
        beta_range_deg: Slope of the surface (deg) as an unknown between LOW and HIGH, such as an inclinometer tells
            it, instead of ````beta_deg````.
        costs: Also tell what each unknown costs: the widths of friction angle and density, were it known. Needs one
            of the intervals above.
        sections_deg: Values of delta at which sections are shown (deg); default: the ends and the middle.
        next_strokes: Rank the next strokes by how much they would shrink the region.
        next_alpha_deg: Tool angles to consider for the next stroke (deg).
        next_depth_m: Depths to consider for the next stroke (m); default: the depths of the table.
        next_width_m: Plate widths to consider for the next stroke (m); default: the widths of the table.
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
    return run("estimate", estimate, locals(), EstimateAnswer, tables=("file", "shear_box",))


def places(
    file: Table,
    *,
    false_discovery: float = 0.05,
    cell_m: float | None = None,
    next_places: int = 3,
    origin_deg: Sequence[float] | None = None,
    geojson: PathLike | None = None,
    cells: PathLike | None = None,
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "table",
    ends: Literal["finite", "none"] | None = None,
    delta_deg: Literal["column"] | float = "column",
    delta_tol_deg: float = 1.0,
    density_kg_m3: Literal["column"] | float | None = None,
    density_tol: float = 0.04,
    uncertainty: Literal["sigma", "bounds"] = "sigma",
    confidence: float = 0.95,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    progress: Progress = None,
) -> PlacesAnswer:
    """Whether the soil is the same at several places, what it is at each, and what lies between.

    Args:
        file: Stroke table (CSV) with the columns ``place``, or ``place_x_m`` and ``place_y_m``, or all three.
        false_discovery: Part of the differences that are told which may be none, on average (Benjamini and
            Hochberg); without meaning for bounds. Above 0 and below 1.
        cell_m: Side of the cells between places (m). Above 0.
        next_places: How many places to name where a stroke would tell most. At least 0 and at most 20.
        origin_deg: Latitude and longitude (deg, WGS 84) of x = 0 and y = 0, x to the east: coordinates of
            ``geojson`` are then geographic, as programs expect them.
        geojson: Writes places and cells as GeoJSON.
        cells: Writes the cells as a table (CSV).
        model: Force model; ``table`` is the bracket of proven bounds.
        ends: Whether plates have ends, each its own width; by default they have them for the models that know ends.
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for what the table says.
        delta_tol_deg: Half width of what is known of delta (deg). At least 0.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of the table; left out: unknown.
        density_tol: Relative half width of what is known of the density. At least 0 and below 1.
        uncertainty: What uncertainties of measurements mean; as bounds, a deviation is a half width.
        confidence: Probability with which all bands together hold their true values, at each place; that of
            intervals between places too. Above 0 and below 1.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("places", places, locals(), PlacesAnswer, tables=("file",))


def profile(
    file: Table,
    *,
    next_depth_m: Sequence[float] = (),
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "table",
    ends: Literal["finite", "none"] | None = None,
    delta_deg: Literal["column"] | float = "column",
    delta_tol_deg: float = 1.0,
    density_kg_m3: Literal["column"] | float | None = None,
    density_tol: float = 0.04,
    uncertainty: Literal["sigma", "bounds"] = "sigma",
    confidence: float = 0.95,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    progress: Progress = None,
) -> ProfileAnswer:
    """Whether the ground changes with depth, by strokes at several depths.

    Args:
        file: Stroke table (CSV) with strokes at two depths or more, best each at the same tool angles.
        next_depth_m: Depths to consider for the next stroke (m), up to 1.5 times the deepest one; default: six,
            from half the least depth on.
        model: Force model; ``table`` is the bracket of proven bounds.
        ends: Whether plates have ends, each its own width; by default they have them for the models that know ends.
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for what the table says.
        delta_tol_deg: Half width of what is known of delta (deg). At least 0.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of the table; left out: unknown.
        density_tol: Relative half width of what is known of the density. At least 0 and below 1.
        uncertainty: What uncertainties of measurements mean; as bounds, a deviation is a half width.
        confidence: Probability with which all bands together hold their true values, at each place; that of
            intervals between places too. Above 0 and below 1.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("profile", profile, locals(), ProfileAnswer, tables=("file",))


def surface(
    file: Table,
    *,
    break_sd_m: float | None = None,
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "table",
    ends: Literal["finite", "none"] | None = None,
    delta_deg: Literal["column"] | float = "column",
    delta_tol_deg: float = 1.0,
    density_kg_m3: Literal["column"] | float | None = None,
    density_tol: float = 0.04,
    uncertainty: Literal["sigma", "bounds"] = "sigma",
    confidence: float = 0.95,
    cohesion_pa: float = 0.0,
    adhesion_pa: float = 0.0,
    surcharge_pa: float = 0.0,
    gravity_m_s2: float = 9.80665,
    beta_deg: float = 0.0,
    progress: Progress = None,
) -> SurfaceAnswer:
    """What the crack ahead of the plate says of the soil, beside what the force says.

    Args:
        file: Stroke table (CSV) with the columns ``break_distance_m`` and ``break_distance_sd_m``.
        break_sd_m: Standard deviation of break distances (m) where the table does not say. Above 0.
        model: Force model; ``table`` is the bracket of proven bounds.
        ends: Whether plates have ends, each its own width; by default they have them for the models that know ends.
        delta_deg: Friction angle between soil and plate (deg), or ``column`` for what the table says.
        delta_tol_deg: Half width of what is known of delta (deg). At least 0.
        density_kg_m3: Bulk density (kg/m3), or ``column`` for density_kg_m3 of the table; left out: unknown.
        density_tol: Relative half width of what is known of the density. At least 0 and below 1.
        uncertainty: What uncertainties of measurements mean; as bounds, a deviation is a half width.
        confidence: Probability with which all bands together hold their true values, at each place; that of
            intervals between places too. Above 0 and below 1.
        cohesion_pa: Cohesion of the soil (Pa), at least 0.
        adhesion_pa: Adhesion between soil and plate (Pa), at least 0.
        surcharge_pa: Vertical pressure on the surface, on both sides of the plate (Pa), at least 0.
        gravity_m_s2: Gravity (m/s2), above 0.
        beta_deg: Slope of the surface (deg), positive when it rises ahead of the plate.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("surface", surface, locals(), SurfaceAnswer, tables=("file",))


def heights(
    before: PathLike,
    after: PathLike,
    *,
    plate_x_m: float | None = None,
    plate_y_m: float | None = None,
    heading_deg: float | None = None,
    plate_sd_m: float | None = None,
    width_m: float | None = None,
    depth_m: float | None = None,
    height_sd_m: float | None = None,
    deviations: float = 3.0,
    reach_m: float | None = None,
    cell_m: float | None = None,
    topic: str | None = None,
    before_at_s: float | None = None,
    after_at_s: float | None = None,
    plate_frame: str | None = None,
    urdf: PathLike | None = None,
    joint_topic: str | None = None,
    strokes: PathLike | None = None,
    stroke: str | None = None,
    out: PathLike | None = None,
    replace: bool = False,
    progress: Progress = None,
) -> HeightsAnswer:
    """What height maps before and after a stroke say: where the ground broke ahead of the plate, heap and furrow.

    Args:
        before: The ground before the stroke: a GeoTIFF, an ESRI ASCII grid, a CSV table with x_m, y_m, z_m, or a
            recording with clouds of points (sensor_msgs/PointCloud2), in m, with z upwards.
        after: The ground after the stroke, in the same frame; a recording may be the same one.
        plate_x_m: Middle of the plate's face at the surface where the stroke ended (m), in the frame of the maps;
            without it, what the arm in the recording tells. At least -1e+08 and at most 1e+08.
        plate_y_m: The same along y (m). At least -1e+08 and at most 1e+08.
        heading_deg: Where the plate pushed to (deg), counter-clockwise from the x axis; without it, where the arm
            moved the plate between the clouds. At least -360 and at most 360.
        plate_sd_m: Standard deviation of the plate's place along its heading (m); without it half a cell is taken.
            At least 0 and at most 10.
        width_m: Width of the plate (m); of the stroke in ``strokes``, if it is not given. At least 0.0001 and at
            most 100.
        depth_m: Depth of the plate (m), which tells how far the furrow says that it pushed; of the stroke in
            ``strokes`` or of the arm, if it is not given. Above 0 and at most 100.
        height_sd_m: Standard deviation of heights (m), if it is known; noise is taken to be no less. At least 0 and
            at most 10.
        deviations: Standard deviations of the noise that a change must have to count. At least 1 and at most 10.
        reach_m: Ground farther than this from the plate is left out (m); without it ten widths of the plate. Above
            0 and at most 10000.
        cell_m: Side of the cells (m) that clouds of points and scattered tables are put into; without it, of cells
            that have some five points. At least 1e-06 and at most 1000.
        topic: Topic of the clouds in recordings; without it the only one there is.
        before_at_s: Of a recording before the stroke, the last cloud up to this time (s) after the first; without
            it the first. At least 0.
        after_at_s: Of a recording after the stroke, the last cloud up to this time (s) after the first; without it
            the last. At least 0.
        plate_frame: Link at the plate's lower edge, its z axis down along the plate, of the arm in the recording.
        urdf: URDF of that arm.
        joint_topic: Topic of its joint states.
        strokes: Stroke table (CSV) that the stroke is in.
        stroke: Its ``stroke_id`` there.
        out: Writes the stroke table with ``break_distance_m`` and ``break_distance_sd_m`` of the stroke, for
            ``surface``.
        replace: Writes over a file that is there.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("heights", heights, locals(), HeightsAnswer)


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


def excavate(
    *,
    soil: str = "ticino_loose",
    phi_deg: Sequence[float] | None = None,
    delta_deg: Sequence[float] | None = None,
    density_kg_m3: Sequence[float] | None = None,
    strokes: Table | None = None,
    model: Literal["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d", "table"] = "table",
    radius_m: float = 0.36,
    base_deg: float = 0.0,
    length_m: float = 0.05,
    depth_m: float = 0.028,
    pass_depth_m: float = 0.028,
    share: float = 0.7,
    alpha_deg: Sequence[float] = (70.0, 100.0),
    least: Literal["torque", "heat", "work"] = "torque",
    dig: bool = False,
    seed: int = 1,
    out: PathLike | None = None,
    table: PathLike | None = None,
    progress: Progress = None,
) -> ExcavateAnswer:
    """A trench in passes that keep to a share of the torque limits: how the plate fails the soil at least cost to
    the motors.

    Args:
        soil: Soil of the simulated box that is dug in: a preset of data/plant/soils.toml without cohesion.
        phi_deg: Friction angles that are thought possible (deg): one, or a least and a greatest.
        delta_deg: Friction on the plate that is thought possible (deg).
        density_kg_m3: Densities that are thought possible (kg/m3).
        strokes: Stroke table (CSV) whose estimate says which soils are possible, as ``soilctl estimate`` finds it
            with the friction on the plate of the table.
        model: Force model whose lower bounds count as borne and whose upper bounds as enough to fail.
        radius_m: Radius of the far end of the trench from the base axis (m). Above 0 and at most 10.
        base_deg: Base angle of the trench (deg). At least -180 and at most 180.
        length_m: Length of the trench towards the base (m), which is that of each pass. At least 0.01 and at most
            0.5.
        depth_m: Depth of the trench (m). At least 0.015 and at most 0.5.
        pass_depth_m: Greatest depth of a pass (m). At least 0.015 and at most 0.5.
        share: Share of the torque limits of joints and motors that a pass may take, in every soil that is possible.
            Above 0 and at most 1.
        alpha_deg: Tool angles that may be used (deg): a least and a greatest, 45 to 135.
        least: What is to be least, among tool angles that keep the share.
        dig: Digs the trench on the simulated arm: replanned by what each pass taught, without learning, and with
            the same passes at a fixed tool angle of 90 deg.
        seed: Seed of noise and scatter of the simulation. At least 0.
        out: Folder for plan.toml and controller.toml, which ``soilctl simulate`` runs; made if it is not there.
        table: Writes the passes that were planned, or dug, as a table (.csv or .parquet).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("excavate", excavate, locals(), ExcavateAnswer, tables=("strokes",))


def process(
    logs: Sequence[PathLike],
    *,
    out: PathLike | None = None,
    threads: int | None = None,
    shard: str | None = None,
    trace_rate_hz: float = 50.0,
    joint_topic: str | None = None,
    wrench_topic: str | None = None,
    urdf: PathLike | None = None,
    sensor_frame: str | None = None,
    surface_z_m: float | None = None,
    plate_frame: str | None = None,
    alpha_deg: float | None = None,
    width_m: float | None = None,
    delta_set_deg: float | None = None,
    tare: Sequence[float] | None = None,
    tool_weight_n: float | None = None,
    scan_topic: str | None = None,
    wrench_sense: Literal["soil-on-plate", "plate-on-soil"] = "soil-on-plate",
    strokes: Table | None = None,
    slant_m: float = 0.0254,
    rubbing: Sequence[PathLike] = (),
    density_kg_m3: float | None = None,
    phi_deg: float | None = None,
    delta_deg: float | None = None,
    gravity_m_s2: float = 9.80665,
    model: str = "table",
    progress: Progress = None,
) -> ProcessAnswer:
    """Failure forces of the strokes in logs, and what they say together.

    Args:
        logs: Logs (.mcap, .db3, .bag, or the folder of a split bag), or folders with logs.
        out: Stroke table to write (.csv or .parquet).
        threads: Logs that are read at a time; the answer does not depend on it. At least 1 and at most 1024.
        shard: Reads only each N-th log, starting with the I-th, and writes no table: the same command without this
            one then takes what all shards have read, wherever they ran.
        trace_rate_hz: Samples a second in traces.csv. Above 0 and at most 1e+06.
        joint_topic: Topic of the joint states.
        wrench_topic: Topic of the wrenches of soil on plate.
        urdf: URDF of the arm.
        sensor_frame: Link of the wrenches.
        surface_z_m: Height of the soil in the URDF's root frame (m).
        plate_frame: Link at the plate's lower edge, its z axis down along the plate.
        alpha_deg: Tool angle (deg).
        width_m: Width of the plate (m).
        delta_set_deg: Interface friction that the controller was set to (deg).
        tare: Readings in free air: FX,FY,FZ or FX,FY,FZ,MX,MY,MZ (N, N m).
        tool_weight_n: Weight of what the sensor carries (N); it turns with the sensor.
        scan_topic: Topic of clouds of points (sensor_msgs/PointCloud2): those before and after each stroke tell
            where the ground broke, in the columns ``break_distance_m`` and ``break_distance_sd_m``.
        wrench_sense: What the wrenches are, if not the force of the soil on the plate: then all readings,
            ````tare```` too, change their sign.
        strokes: CSV with the columns start and end of each push (s, on the clock of the stamps).
        slant_m: Slant length to which forces are scaled (m).
        rubbing: Logs of rubbing a sand-covered plate: the check of the interface friction.
        density_kg_m3: Density of the soil (kg/m3): matches a friction angle to the mean force of each tool angle.
            Above 0.
        phi_deg: Friction angle (deg) for which the model's forces are compared; needs ``density_kg_m3``.
        delta_deg: Interface friction for the comparison (deg).
        gravity_m_s2: Gravity for the comparison (m/s2). Above 0.
        model: Force model for the comparison.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("process", process, locals(), ProcessAnswer, tables=("strokes",))


class ProcessArguments(TypedDict, total=False):
    """Keyword arguments of :func:`process`, which tells what they mean."""

    alpha_deg: float | None
    delta_deg: float | None
    delta_set_deg: float | None
    density_kg_m3: float | None
    gravity_m_s2: float | None
    joint_topic: str | None
    model: str | None
    phi_deg: float | None
    plate_frame: str | None
    rubbing: Sequence[PathLike] | None
    scan_topic: str | None
    sensor_frame: str | None
    slant_m: float | None
    strokes: Table | None
    surface_z_m: float | None
    tare: Sequence[float] | None
    threads: int | None
    tool_weight_n: float | None
    trace_rate_hz: float | None
    urdf: PathLike | None
    width_m: float | None
    wrench_sense: Literal["soil-on-plate", "plate-on-soil"] | None
    wrench_topic: str | None


def ahead(
    logs: Sequence[PathLike],
    *,
    reference: Sequence[PathLike] = (),
    false_alarms: float = 0.02,
    confidence: float = 0.95,
    phi_deg: Sequence[float] = (),
    threads: int | None = None,
    table: PathLike | None = None,
    joint_topic: str | None = None,
    wrench_topic: str | None = None,
    urdf: PathLike | None = None,
    sensor_frame: str | None = None,
    surface_z_m: float | None = None,
    plate_frame: str | None = None,
    alpha_deg: float | None = None,
    width_m: float | None = None,
    delta_set_deg: float | None = None,
    tare: Sequence[float] | None = None,
    tool_weight_n: float | None = None,
    scan_topic: str | None = None,
    wrench_sense: Literal["soil-on-plate", "plate-on-soil"] = "soil-on-plate",
    strokes: Table | None = None,
    progress: Progress = None,
) -> AheadAnswer:
    """Whether something is buried ahead of strokes: where their force rises beyond what the soil explains, and
    where a rigid block may be then.

    Args:
        logs: Logs (.mcap, .db3, .bag, or the folder of a split bag), or folders with logs: the strokes to judge.
        reference: Logs, or folders with logs, of the same plate in the same soil with nothing ahead: what the soil
            explains. Without them each stroke is compared with the others of its kind that do not alarm.
        false_alarms: Probability that a stroke with nothing ahead alarms. At least 1e-06 and at most 0.2.
        confidence: Probability that the region of an alarm holds what bounds and scatter allow. At least 0.5 and at
            most 0.9999.
        phi_deg: Friction angle of the soil, from and to (deg), for the region; by default all of the table of
            bounds, 30,44.
        threads: Logs that are read at a time; the answer does not depend on it. At least 1 and at most 1024.
        table: Writes the looks at all strokes as a table (.csv or .parquet).
        joint_topic: Topic of the joint states.
        wrench_topic: Topic of the wrenches of soil on plate.
        urdf: URDF of the arm.
        sensor_frame: Link of the wrenches.
        surface_z_m: Height of the soil in the URDF's root frame (m).
        plate_frame: Link at the plate's lower edge, its z axis down along the plate.
        alpha_deg: Tool angle (deg).
        width_m: Width of the plate (m).
        delta_set_deg: Interface friction that the controller was set to (deg).
        tare: Readings in free air: FX,FY,FZ or FX,FY,FZ,MX,MY,MZ (N, N m).
        tool_weight_n: Weight of what the sensor carries (N); it turns with the sensor.
        scan_topic: Topic of clouds of points (sensor_msgs/PointCloud2): those before and after each stroke tell
            where the ground broke, in the columns ``break_distance_m`` and ``break_distance_sd_m``.
        wrench_sense: What the wrenches are, if not the force of the soil on the plate: then all readings,
            ````tare```` too, change their sign.
        strokes: CSV with the columns start and end of each push (s, on the clock of the stamps).
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("ahead", ahead, locals(), AheadAnswer, tables=("strokes",))


def diagnose(
    dir: PathLike,
    *,
    model: str = "table",
    model_file: PathLike | None = None,
    traces: PathLike | None = None,
    logs: PathLike | None = None,
    no_resimulate: bool = False,
    out: PathLike | None = None,
    progress: Progress = None,
) -> DiagnoseAnswer:
    """Where model and measurement disagree, which effect is missing, and the gap after it is added.

    Args:
        dir: Folder with strokes.csv and, beside it, campaign.json and traces.csv.
        model: Force model without effects: table (the bracket of bounds), chen, log-spiral, caquot, coulomb, ...
        model_file: A model file instead, such as the patch of an earlier diagnosis: its force model, and its
            effects as known ones.
        traces: Traces of the strokes.
        logs: Folder of the campaign's logs, if they are soilctl's: the same commands are run on the simulated arm,
            without and with what is found, and signals are compared.
        no_resimulate: Diagnose the table alone: nothing is simulated, also where logs are there.
        out: Folder to write to.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("diagnose", diagnose, locals(), DiagnoseAnswer)


def diagnose_self_test(
    *,
    model: str = "table",
    rounds: int = 1,
    seed: int = 1,
    progress: Progress = None,
) -> DiagnoseSelfTestAnswer:
    """Diagnoses hidden campaigns, and counts how often that is right.

    Args:
        model: Force model without effects.
        rounds: Rounds of the self-test; one round is about 80 campaigns. At least 0.
        seed: Seed of the self-test. At least 0.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("diagnose self-test", diagnose_self_test, locals(), DiagnoseSelfTestAnswer)


def diagnose_self_test_logs(
    folder: PathLike,
    *,
    model: str = "table",
    campaigns: int = 3,
    strokes: Literal["12", "24", "48"] = "12",
    hidden: str | None = None,
    soil: str | None = None,
    follow_up: bool = False,
    seed: int = 1,
    progress: Progress = None,
) -> DiagnoseSelfTestLogsAnswer:
    """Hides effects in logs of simulated arms that the twin does not know, diagnoses them with the twin, and counts
    how often that is right.

    Args:
        folder: Folder for the campaigns; a run that was ended goes on from there.
        model: Force model without effects.
        campaigns: Hidden campaigns; every third hides nothing, the others an effect in turn. At least 1 and at most
            10000.
        strokes: Strokes of a campaign.
        hidden: Hide this effect in all of them, or ``none``, or ``two``: in turn six pairs of effects, or
            ``outside``: in turn six kinds that no effect is, which takes 24 strokes or 48.
        soil: Preset of the sand of all of them, instead of four in turn.
        follow_up: Where an answer leaves several effects open, run the plan that it proposes on the same arm and
            diagnose that, too.
        seed: Seed. At least 0.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("diagnose self-test-logs", diagnose_self_test_logs, locals(), DiagnoseSelfTestLogsAnswer)


def demo(
    *,
    soil: str = "ticino_rained",
    out: PathLike | None = None,
    seed: int = 1,
    threads: int | None = None,
    model: str | None = None,
    ends: Literal["finite", "none"] | None = None,
    end_factor: float = 0.5,
    quick: bool = False,
    progress: Progress = None,
) -> DemoAnswer:
    """A simulated campaign from the soil to the estimate, compared with the truth.

    Args:
        soil: The soil: ticino_rained, ticino_loose, nevada_fine, glass_beads, or mars_drift, mars_crusty,
            mars_blocky, mars_pathfinder under the gravity of Mars, or moon_0_15cm under that of the Moon.
        out: Folder for all files; made if it is not there, otherwise it must be empty or hold this demonstration.
        seed: Seed of noise and scatter. At least 0.
        threads: Batches and logs at a time; results are the same for any number. At least 1 and at most 1024.
        model: Force model of the simulated soil and of the estimate.
        ends: Whether the plate has ends, in the simulated soil and for the estimate.
        end_factor: Part of what ends add at most that they add in the simulated soil; the estimate does not know
            it. At least 0 and at most 1.
        quick: Four strokes instead of sixteen: every step in a quarter of the time, but too few to tell much.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("demo", demo, locals(), DemoAnswer)


def log_info(
    log: PathLike,
    *,
    progress: Progress = None,
) -> LogAnswer:
    """Says what is in a log.

    Args:
        log: A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag).
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
    """Checks a log: whole, checksums, types, quality of service, missing steps, key frames; of another program
    gaps, clocks, units.

    Args:
        log: A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag).
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
        log: A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag).
        out: File to write (.csv or .parquet).
        topic: The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or
            /truth/soil; of another program's recording any topic.
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("log export", log_export, locals(), LogAnswer)


def doctor(
    *,
    progress: Progress = None,
) -> DoctorAnswer:
    """Tells what is there: browser, viewer, Python package, real-time rights.

    Args:
        progress: Called with the steps done and of all steps, if the work has any; or True for a bar of tqdm.

    Returns:
        The answer, with ``exit_code``: 0 done, 1 done and the answer is negative, 3 done in part.

    Raises:
        InputError: If a value makes no sense, is missing or outside its range; the message names it.
        FileError: If a file cannot be read or written.
    """
    return run("doctor", doctor, locals(), DoctorAnswer)


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
