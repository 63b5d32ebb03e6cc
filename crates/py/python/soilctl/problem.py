"""Problem files from Python: each call adds an entry, with its units in the names of its arguments.

    from soilctl.problem import Problem

    cut = (
        Problem("cut in clay", default_boundary="fixed")
        .soil("clay", phi_deg=0, unit_weight_kn_m3=18, cohesion_kpa=20)
        .region("clay", [[-9, 3], [-9, -4], [6, -4], [6, 0], [0, 0], [0, 3]])
        .boundary("free", line=[[-9, 3], [0, 3], [0, 0], [6, 0]])
        .objective_strength_reduction()
    )
    soilctl.solve(cut)

The keys are those of problem files, which docs/problem-file.md explains. A problem is never changed: each call makes another one, so a
part that several have in common can be kept.
"""

# Made by crates/py/generate from the schema of problem files.

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, TypeAlias, TypedDict

from ._problem import Entries, Points

__all__ = ["Anisotropy", "Factors", "Interface", "Problem", "SoilInterface"]


class Anisotropy(TypedDict, total=False):
    """Undrained strength that depends on the direction of the stress, an ellipse in plane strain: strengths over
    the active one, ``cohesion_kpa``.
    """

    passive: float
    """Passive strength, where the greatest pressure is level, over the active one; 0.1 to 10."""
    shear: float
    """Greatest shear stress on level and upright planes over the active strength, 0.1 to 10; what direct simple
    shear finds.
    """


class Factors(TypedDict, total=False):
    """Partial factors, one where nothing else says what they are."""

    cohesion: float
    """Divides the cohesion and tension of soils with friction, and the adhesion of faces with friction."""
    friction: float
    """Divides the tangents of friction angles, of soils and of faces."""
    permanent: float
    """Multiplies permanent loads."""
    resistance: float
    """Divides the bounds."""
    undrained: float
    """Divides the undrained shear strength of soils without friction, and the adhesion of faces without."""
    variable: float
    """Multiplies variable loads."""
    water: float
    """Multiplies the unit weight of water; that of soils if left out, since both are one action."""
    weight: float
    """Multiplies the unit weights of soils."""


class Interface(TypedDict, total=False):
    """What a face bears: shear stress up to ``adhesion + pressure * tan(delta)``."""

    adhesion_kpa: float
    """Adhesion."""
    delta_deg: float
    """Friction angle."""


class SoilInterface(TypedDict, total=False):
    """What a face bears against one soil."""

    adhesion_kpa: float
    """Adhesion."""
    delta_deg: float
    """Friction angle."""
    soil: str
    """Name of the soil."""


class PointsStrength(TypedDict, total=False):
    """Through points, straight between them; before the first and beyond the last as between the nearest two."""

    kind: Literal["points"]
    """Which kind it is."""
    points_kpa: Points
    """Normal stress and shear strength, at least two; both grow, and the slope does not."""

class PowerStrength(TypedDict, total=False):
    """``factor (sigma + tension_kpa)^exponent``."""

    exponent: float
    """0.3 to 0.999."""
    factor: float
    """The shear strength in kPa where ``sigma + tension_kpa`` is 1 kPa: 0.01 to 1e4."""
    kind: Literal["power"]
    """Which kind it is."""
    tension_kpa: float
    """The tension at which there is no strength left."""
    up_to_kpa: float
    """The normal stress up to which the curve is followed; a multiple of what the weight and the loads make if it
    is left out.
    """

class FrictionLawStrength(TypedDict, total=False):
    """``sigma tan(phi)`` with a friction angle that falls with the logarithm of stress, ``phi_deg - slope
    log10(sigma / reference)``, and is at most ``greatest_phi_deg``: sand, as estimates with a law of stress tell
    it. It is followed down to a third of ``phi_deg``; beyond, strength does not fall.
    """

    greatest_phi_deg: float
    """Friction angle in degrees where stress is small; from ``phi_deg`` to 69.9."""
    kind: Literal["friction-law"]
    """Which kind it is."""
    phi_deg: float
    """Friction angle in degrees at the reference stress, 15 to 69.9."""
    reference_kpa: float
    """The reference, 0.001 to 1e6 kPa."""
    slope_deg_per_decade: float
    """Fall of the friction angle in degrees a decade of stress, 0.1 to 8."""
    up_to_kpa: float
    """The normal stress up to which the curve is followed; a multiple of what the weight and the loads make if it
    is left out.
    """

class HoekBrownStrength(TypedDict, total=False):
    """Rock after Hoek, Carranza-Torres and Corkum (2002): ``sigma_1 = sigma_3 + ucs (m_b sigma_3/ucs + s)^a``."""

    disturbance: float
    """Disturbance factor, 0 to 1."""
    gsi: float
    """Geological strength index, 5 to 100."""
    kind: Literal["hoek-brown"]
    """Which kind it is."""
    mi: float
    """The constant of the intact rock, 1 to 50."""
    ucs_mpa: float
    """Uniaxial compressive strength of the intact rock, 0.01 to 1000 MPa."""
    up_to_kpa: float
    """The least principal stress up to which the curve is followed; a multiple of what the weight and the loads
    make if it is left out.
    """


#: How the shear strength of a soil grows with the effective normal stress. Stresses are in kPa.
StrengthLaw: TypeAlias = PointsStrength | PowerStrength | FrictionLawStrength | HoekBrownStrength


class Problem(Entries):
    """A problem file in the making.

    Args:
        title: What it is, in words.
        default_boundary: What holds on outline that no boundary entry names.
        surcharge_action: What kind of action the surcharge is, for the partial factors of cases.
        surcharge_kpa: Pressure on all free boundaries and on the ground beyond far ones.
    """

    def __init__(
        self,
        title: str | None = None,
        *,
        default_boundary: Literal["fixed", "smooth", "symmetric", "free", "far", "load"] | None = None,
        surcharge_action: Literal["permanent", "variable", "favourable"] | None = None,
        surcharge_kpa: float | None = None,
    ) -> None:
        super().__init__({"title": title, "default_boundary": default_boundary, "surcharge_action": surcharge_action, "surcharge_kpa": surcharge_kpa})

    def boundary(
        self,
        kind: Literal["fixed", "smooth", "symmetric", "free", "far", "load"],
        *,
        action: Literal["permanent", "variable", "favourable"] | None = None,
        line: Points | None = None,
        live: bool | None = None,
        name: str | None = None,
        pressure_kpa: float | Sequence[float] | None = None,
        shear_kpa: float | Sequence[float] | None = None,
        sides: Sequence[Literal["left", "right", "bottom", "top"]] | None = None,
    ) -> Problem:
        """What holds on a part of the outline.

        Args:
            kind: What holds.
            action: What kind of action a load is, for the partial factors of cases.
            line: Where: along these points, all on the outline.
            live: Whether the objective ``load`` multiplies it.
            name: Its name, for messages, cases and sweeps.
            pressure_kpa: Pressure of a load, in place of the surcharge: everywhere, or at the start and the end of
                ``line``.
            shear_kpa: Shear stress on the soil in the direction of ``line``, likewise.
            sides: Where: whole sides. A line of another entry takes precedence.
        """
        return self._add("boundary", {"kind": kind, "action": action, "line": line, "live": live, "name": name, "pressure_kpa": pressure_kpa, "shear_kpa": shear_kpa, "sides": sides})

    def case(
        self,
        name: str,
        *,
        approach: Literal["da1-1", "da1-2", "da2", "da3", "da3-slope"] | None = None,
        factors: Factors | None = None,
        set: Mapping[str, float | Points | Sequence[float]] | None = None,
        soil_weight: Literal["favourable", "unfavourable"] | None = None,
    ) -> Problem:
        """A load case: the problem with other values, and with partial factors on actions and strengths.

        Args:
            name: Its name.
            approach: A design approach, which says all partial factors that ``factors`` does not.
            factors: Partial factors.
            set: Values in place of those of the file, by parameter: ``"soil.sand.phi_deg" = 34``.
            soil_weight: What the weight of the soil does. Needed with an approach that multiplies unfavourable
                permanent actions.
        """
        return self._add("case", {"name": name, "approach": approach, "factors": factors, "set": set, "soil_weight": soil_weight})

    def head(
        self,
        line: Points,
        *,
        head_m: float,
        name: str | None = None,
    ) -> Problem:
        """Ground at which the head of the water is given, and open water where that is above the ground.

        Args:
            line: Points along the outline of the soil.
            head_m: The total head: the y up to which water would rise in a standpipe there.
            name: Its name, for messages, cases and sweeps.
        """
        return self._add("head", {"line": line, "head_m": head_m, "name": name})

    def member(
        self,
        name: str,
        line: Points,
        *,
        tensile_kn_per_m: float,
        attached: Sequence[Literal["start", "end"]] | None = None,
        bond_factor: float | None = None,
        compressive_kn_per_m: float | None = None,
        free_length_m: float | None = None,
        moment_knm_per_m: float | None = None,
        pullout_kn_per_m2: float | Sequence[float] | None = None,
        shear_kn_per_m: float | None = None,
    ) -> Problem:
        """A straight bar or sheet inside the soil, thin and perfectly flexible: a geogrid, a nail, a strip. It bears an
        axial force and takes the soil along. A sheet parts the soil, and the soil slides along its faces; with a
        pullout resistance it is a row of bars (nails, strips, anchors, piles along themselves), between which the
        soil goes on. With a moment it is a beam, such as a sheet pile or a raft, which may also lie along the
        outline of the soil. Forces are per metre of width.

        Args:
            name: Its name.
            line: Its start and its end.
            tensile_kn_per_m: Greatest tension.
            attached: Ends that are attached to the boundary, structure or beam there: they bear a force, others do not.
                Ends of beams are clamped.
            bond_factor: Shear stress that each face bears, over what the soil beside it bears at the same effective
                normal stress; above 0, at most 1.
            compressive_kn_per_m: Greatest compression; a sheet bears none.
            free_length_m: Length from the start along which the soil hands a row of bars nothing, such as the free
                length of anchors.
            moment_knm_per_m: Greatest bending moment of a beam.
            pullout_kn_per_m2: Instead of a bond factor, of a row of bars between which the soil goes on: greatest force
                from the soil for each metre of bar, that of one bar over the spacing; everywhere, or at the start and
                the end. Zero is a tie that the soil hands nothing.
            shear_kn_per_m: Greatest shear force of a beam.
        """
        return self._add("member", {"name": name, "line": line, "tensile_kn_per_m": tensile_kn_per_m, "attached": attached, "bond_factor": bond_factor, "compressive_kn_per_m": compressive_kn_per_m, "free_length_m": free_length_m, "moment_knm_per_m": moment_knm_per_m, "pullout_kn_per_m2": pullout_kn_per_m2, "shear_kn_per_m": shear_kn_per_m})

    def objective_structure(
        self,
        name: str,
        direction: Sequence[float],
    ) -> Problem:
        """The force of a structure or plate on the soil along its motion, in kN per metre of width.

        Args:
            name: Name of the structures and plates that move, as one.
            direction: Direction of motion; any length.
        """
        return self._set("objective", {"kind": "structure", "name": name, "direction": direction})

    def objective_load(self) -> Problem:
        """The factor on all live loads."""
        return self._set("objective", {"kind": "load"})

    def objective_unit_weight(self) -> Problem:
        """The factor on all unit weights."""
        return self._set("objective", {"kind": "unit-weight"})

    def objective_seismic(
        self,
        *,
        leftwards: bool | None = None,
    ) -> Problem:
        """The horizontal acceleration over gravity that is added to the given one.

        Args:
            leftwards: Whether it pushes the soil towards negative x.
        """
        return self._set("objective", {"kind": "seismic", "leftwards": leftwards})

    def objective_strength_reduction(self) -> Problem:
        """The factor by which cohesion and the tangents of all friction angles can be divided: the factor of safety."""
        return self._set("objective", {"kind": "strength-reduction"})

    def plate(
        self,
        name: str,
        line: Points,
        *,
        adhesion_kpa: float | None = None,
        delta_deg: float | None = None,
        held: Literal["fixed", "smooth"] | None = None,
        in_soil: Sequence[SoilInterface] | None = None,
        left: Interface | None = None,
        right: Interface | None = None,
    ) -> Problem:
        """A thin rigid plate with a face on each side that has soil. What sticks out of the soil is left out.

        Args:
            name: Its name; parts of one structure share it.
            line: Its points; a curved plate has many.
            adhesion_kpa: Adhesion of both faces.
            delta_deg: Friction angle of both faces.
            held: How it is held, if it does not move.
            in_soil: Against some soils, on both faces, if it differs there.
            left: The face on the left of ``line``, if it differs.
            right: The face on the right of ``line``, if it differs.
        """
        return self._add("plate", {"name": name, "line": line, "adhesion_kpa": adhesion_kpa, "delta_deg": delta_deg, "held": held, "in_soil": in_soil, "left": left, "right": right})

    def region(
        self,
        soil: str,
        polygon: Points,
        *,
        name: str | None = None,
    ) -> Problem:
        """An area of one soil.

        Args:
            soil: Name of its soil.
            polygon: Corners, either way round; the last is joined to the first. Regions may share edges, not area.
            name: Its name, for messages.
        """
        return self._add("region", {"soil": soil, "polygon": polygon, "name": name})

    def seepage(
        self,
        *,
        unit_weight_kn_m3: float = 9.81,
    ) -> Problem:
        """Ground water that flows between given heads.

        Args:
            unit_weight_kn_m3: Unit weight of water.
        """
        return self._set("seepage", {"unit_weight_kn_m3": unit_weight_kn_m3})

    def seismic(
        self,
        *,
        kh: float | None = None,
        kv: float | None = None,
    ) -> Problem:
        """Earthquake as a steady acceleration, in units of gravity.

        Args:
            kh: Force on the soil towards positive x over its weight.
            kv: Force upwards likewise, below 1.
        """
        return self._set("seismic", {"kh": kh, "kv": kv})

    def soil(
        self,
        name: str,
        *,
        unit_weight_kn_m3: float,
        anisotropy: Anisotropy | None = None,
        cohesion_gradient_kpa_per_m: float | None = None,
        cohesion_kpa: float | None = None,
        cohesion_level_m: float | None = None,
        dilation_deg: float | None = None,
        permeability_m_per_s: float | None = None,
        permeability_ratio: float | None = None,
        phi_deg: float | None = None,
        pore_pressure_ratio: float | None = None,
        strength: StrengthLaw | None = None,
        strength_factor: float | None = None,
        tension_kpa: float | None = None,
    ) -> Problem:
        """A soil: of Mohr and Coulomb's strength, or of a curved one.

        Args:
            name: Its name, by which regions refer to it.
            unit_weight_kn_m3: Unit weight, with the water in the pores.
            anisotropy: How the strength of clay (``phi_deg`` 0) depends on the direction of the stress;
                ``cohesion_kpa`` is that under the greatest pressure upright then.
            cohesion_gradient_kpa_per_m: What it grows by with each metre of depth.
            cohesion_kpa: Cohesion, at the reference level if it varies.
            cohesion_level_m: The y at which the cohesion is ``cohesion_kpa``; needed with a gradient.
            dilation_deg: Dilation angle, 0 up to ``phi_deg``, of soil that dilates less than the flow rule says: its
                strength is lessened after Davis (1968), which is an approximation, and bounds are proven for what is
                left. As much as the flow rule says if left out.
            permeability_m_per_s: Permeability to water, downwards, 1e-15 to 1e3; needed where water flows through
                several soils.
            permeability_ratio: Permeability along x over that downwards, 1e-3 to 1e3; 1 if left out.
            phi_deg: Friction angle, 0 up to (not including) 90. Every soil has it or a ``strength``.
            pore_pressure_ratio: Pore pressure over the weight of the soil vertically above, 0 to 1.
            strength: Strength that grows less and less with pressure, in place of ``phi_deg`` and cohesion.
            strength_factor: What ``strength`` is multiplied by, 0.01 to 100; 1 if left out.
            tension_kpa: Greatest effective tension; left out: what friction and cohesion allow.
        """
        return self._add("soil", {"name": name, "unit_weight_kn_m3": unit_weight_kn_m3, "anisotropy": anisotropy, "cohesion_gradient_kpa_per_m": cohesion_gradient_kpa_per_m, "cohesion_kpa": cohesion_kpa, "cohesion_level_m": cohesion_level_m, "dilation_deg": dilation_deg, "permeability_m_per_s": permeability_m_per_s, "permeability_ratio": permeability_ratio, "phi_deg": phi_deg, "pore_pressure_ratio": pore_pressure_ratio, "strength": strength, "strength_factor": strength_factor, "tension_kpa": tension_kpa})

    def structure(
        self,
        name: str,
        *,
        adhesion_kpa: float | None = None,
        delta_deg: float | None = None,
        edge: Points | None = None,
        held: Literal["fixed", "smooth"] | None = None,
        in_soil: Sequence[SoilInterface] | None = None,
        polygon: Points | None = None,
    ) -> Problem:
        """A rigid body: a polygon, cut out of the soil where it covers it; or the line along which it meets the soil.

        Args:
            name: Its name; parts of one structure share it.
            adhesion_kpa: Adhesion of its faces.
            delta_deg: Friction angle of its faces.
            edge: Instead: points along the outline of the soil.
            held: How it is held, if it does not move.
            in_soil: Against some soils, if it differs there.
            polygon: Its corners, either way round.
        """
        return self._add("structure", {"name": name, "adhesion_kpa": adhesion_kpa, "delta_deg": delta_deg, "edge": edge, "held": held, "in_soil": in_soil, "polygon": polygon})

    def sweep(
        self,
        parameter: str,
        *,
        count: int | None = None,
        from_: float | None = None,
        to: float | None = None,
        values: Sequence[float] | None = None,
    ) -> Problem:
        """A parameter that takes several values: a list of them, or ``count`` from ``from`` to ``to``.

        Args:
            parameter: The parameter, such as ``soil.sand.phi_deg``, ``boundary.traffic.pressure_kpa`` or
                ``seismic.kh``.
            count: How many values at equal distances, both ends included: 2 or more.
            from_: First value.
            to: Last value.
            values: The values.
        """
        return self._add("sweep", {"parameter": parameter, "count": count, "from": from_, "to": to, "values": values})

    def water(
        self,
        table: Points,
        *,
        rise_m: float | None = None,
        unit_weight_kn_m3: float = 9.81,
    ) -> Problem:
        """Ground water: hydrostatic below its table, none above; open water where the table is above the ground.

        Args:
            table: Points of the water table from left to right; level beyond its ends.
            rise_m: How much higher than these points the table is, for cases and sweeps.
            unit_weight_kn_m3: Unit weight of water.
        """
        return self._set("water", {"table": table, "rise_m": rise_m, "unit_weight_kn_m3": unit_weight_kn_m3})
