//! Problems that are asked for again and again.

use super::input::{Aim, Description, RegionEntry, SoilEntry};
use super::parts::{BoundaryEntry, Kind, PlateEntry, Profile, Side, StructureEntry};

/// How far the soil goes on around what moves, in units of its size; beyond is the soil beyond far sides.
const AROUND: f64 = 8.0;

impl Description {
    /// A rectangle of one soil with its surface at y = 0, far on both sides and below.
    #[must_use]
    pub fn level_ground(soil: SoilEntry, half_width_m: f64, depth_m: f64) -> Self {
        let (w, d) = (half_width_m, depth_m);
        let polygon = vec![[-w, 0.0], [-w, -d], [w, -d], [w, 0.0]];
        Self {
            default_boundary: Some(Kind::Free),
            regions: vec![RegionEntry { name: None, soil: soil.name.clone(), polygon }],
            soils: vec![soil],
            boundaries: vec![BoundaryEntry::on_sides(Kind::Far, &[Side::Left, Side::Right, Side::Bottom])],
            ..Self::default()
        }
    }

    /// A flexible strip of the given width on level ground, loaded by a uniform pressure of 1 kPa that is live: the factor
    /// is the bearing capacity in kPa.
    #[must_use]
    pub fn strip_load(soil: SoilEntry, width_m: f64) -> Self {
        let half = 0.5 * width_m;
        let mut it = Self::level_ground(soil, AROUND * width_m, AROUND * width_m);
        it.boundaries.push(BoundaryEntry {
            pressure_kpa: Some(Profile::Uniform(1.0)),
            live: true,
            ..BoundaryEntry::on_line(Kind::Load, &[[half, 0.0], [-half, 0.0]])
        });
        it
    }

    /// A rigid strip footing on level ground, pushed downwards.
    #[must_use]
    pub fn strip_footing(soil: SoilEntry, width_m: f64, delta_deg: f64, adhesion_kpa: f64) -> Self {
        let half = 0.5 * width_m;
        let mut it = Self::level_ground(soil, AROUND * width_m, AROUND * width_m);
        it.structures.push(StructureEntry {
            name: "footing".into(),
            edge: vec![[-half, 0.0], [half, 0.0]],
            delta_deg,
            adhesion_kpa,
            ..StructureEntry::default()
        });
        it.objective = Aim::Structure { name: "footing".into(), direction: [0.0, -1.0] };
        it
    }

    /// A straight plate from the surface of level ground down to a depth, leaning forwards (tip ahead) below 90 degrees,
    /// pushed towards positive x.
    #[must_use]
    pub fn embedded_plate(soil: SoilEntry, alpha_deg: f64, slant_length_m: f64, delta_deg: f64) -> Self {
        let (sin, cos) = alpha_deg.to_radians().sin_cos();
        let size = 2.0 * AROUND * slant_length_m;
        let mut it = Self::level_ground(soil, size, 0.5 * size);
        it.plates.push(PlateEntry {
            name: "plate".into(),
            line: vec![[0.0, 0.0], [slant_length_m * cos, -slant_length_m * sin]],
            delta_deg,
            ..PlateEntry::default()
        });
        it.objective = Aim::Structure { name: "plate".into(), direction: [1.0, 0.0] };
        it
    }

    /// A slope that rises to the right, on a fixed base as far below its toe as it is high; the factor of safety is asked
    /// for. At 90 degrees it is a vertical cut.
    #[must_use]
    pub fn slope(soil: SoilEntry, height_m: f64, angle_deg: f64) -> Self {
        let h = height_m;
        // Upright must be upright.
        let run = if angle_deg == 90.0 { 0.0 } else { h / angle_deg.to_radians().tan() };
        let [left, right] = [-3.0 * h, run + 4.0 * h];
        let polygon = vec![[left, 0.0], [left, -h], [right, -h], [right, h], [run, h], [0.0, 0.0]];
        Self {
            default_boundary: Some(Kind::Free),
            objective: Aim::StrengthReduction {},
            regions: vec![RegionEntry { name: None, soil: soil.name.clone(), polygon }],
            soils: vec![soil],
            boundaries: vec![
                BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
                BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left, Side::Right]),
            ],
            ..Self::default()
        }
    }
}
