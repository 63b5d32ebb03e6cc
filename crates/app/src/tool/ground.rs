//! A tool in the ground as the description of a problem.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, PlateEntry, RegionEntry, Seismic, Side, SoilEntry,
};
use soilctl_soil::{Angle, Interface, Plate, Soil};

use super::file::ToolFile;
use super::request::Setting;
use super::shape::{Point, Shape};
use crate::AppError;

/// The name of the tool in descriptions.
const TOOL: &str = "tool";
/// The name of the soil.
pub(crate) const SOIL: &str = "soil";

/// How far the soil is meshed behind and below, in units of the size of what is in the ground; beyond is the soil beyond far sides. As
/// for plates: reaches ahead grow with the friction angle.
const AROUND: f64 = 8.0;

/// A tool in its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placed {
    pub(super) file: ToolFile,
    /// In axes along and across the surface.
    pub(super) shape: Shape,
    /// Unit weight in kN/m3.
    pub(crate) unit_weight_kn_m3: f64,
    beta_deg: f64,
}

impl Placed {
    /// Reads the tool and puts it into the ground.
    pub(crate) fn new(setting: &Setting) -> Result<Self, AppError> {
        let file = ToolFile::read(&setting.file)?;
        Self::of_file(file, setting)
    }

    pub(super) fn of_file(file: ToolFile, setting: &Setting) -> Result<Self, AppError> {
        let loads = &setting.loads;
        let beta_deg = loads.beta_deg;
        let drawn = file.shape(setting.delta_deg, loads.adhesion_pa)?;
        let turned = setting.alpha_deg.map(|alpha| drawn.turned_to(alpha, setting.alpha_of));
        let shape = turned.unwrap_or(drawn).placed(setting.depth_m, beta_deg)?;
        // The types refuse what is out of range.
        let soil = Soil::new(Angle::from_degrees(setting.phi_deg), setting.density_kg_m3)?
            .with_cohesion(loads.cohesion_pa)?
            .with_gravity(loads.gravity_m_s2)?;
        Plate::new(Angle::from_degrees(90.0), Angle::from_degrees(beta_deg), 1.0, 1.0)?;
        if loads.surcharge_pa < 0.0 {
            return Err(AppError::Request(format!(
                "the surcharge is {} Pa; it must be at least 0 Pa",
                loads.surcharge_pa
            )));
        }
        if beta_deg.abs() >= setting.phi_deg {
            return Err(AppError::Request(format!(
                "the surface slopes by {beta_deg} deg, but soil with a friction angle of {} deg stands less steeply; give a --beta below it",
                setting.phi_deg
            )));
        }
        for (index, piece) in shape.pieces().iter().enumerate() {
            Interface::new(Angle::from_degrees(piece.delta_deg), piece.adhesion_pa)?;
            let problem = if piece.delta_deg > setting.phi_deg {
                format!(
                    "its friction angle is {} deg, more than that of the soil, {} deg",
                    piece.delta_deg, setting.phi_deg
                )
            } else if piece.delta_deg == 0.0 && piece.adhesion_pa > 0.0 {
                format!(
                    "it has an adhesion of {} Pa without friction; give it a friction angle above 0",
                    piece.adhesion_pa
                )
            } else {
                continue;
            };
            return Err(AppError::Request(format!(
                "piece {} of the tool in the ground: {problem}",
                index + 1
            )));
        }
        Ok(Self { file, shape, unit_weight_kn_m3: 1e-3 * soil.unit_weight_n_m3(), beta_deg })
    }

    /// The greatest of depth, length and height of what is in the ground.
    pub(crate) fn size_m(&self) -> f64 {
        let points = || self.shape.points();
        let over =
            |pick: fn(f64, f64) -> f64, axis: usize, from: f64| points().map(|p| p[axis]).fold(from, pick);
        let length = over(f64::max, 0, f64::NEG_INFINITY) - over(f64::min, 0, f64::INFINITY);
        let depth = -over(f64::min, 1, 0.0);
        length.max(depth).max(self.shape.chord_m())
    }

    /// The tip, and every straight piece.
    pub(crate) fn tip(&self) -> Point {
        self.shape.tip()
    }

    pub(crate) fn lines(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        self.shape.pieces().iter().map(|piece| piece.ends)
    }

    /// Whether soil slides freely along some of it.
    pub(crate) fn has_smooth_face(&self) -> bool {
        self.shape.pieces().iter().any(|piece| piece.delta_deg == 0.0)
    }

    /// Left, right and bottom of the soil that is meshed, for something of this size.
    pub(crate) fn extents(&self, phi_deg: f64, size_m: f64) -> [f64; 3] {
        let reach = 1.0 + 1.5 * (phi_deg / 25.0).powi(3);
        [-AROUND * size_m, (AROUND + 4.0 * reach) * size_m, -AROUND * size_m]
    }

    /// A unit weight in the axes of the surface, in which a slope turns gravity: what acts across the surface.
    pub(crate) fn across_surface(&self, unit_weight_kn_m3: f64) -> f64 {
        if self.beta_deg == 0.0 {
            unit_weight_kn_m3
        } else {
            unit_weight_kn_m3 * self.beta_deg.to_radians().cos()
        }
    }

    /// The problem, with the given pieces of soil around the tool.
    pub(crate) fn description(&self, setting: &Setting, regions: Vec<RegionEntry>) -> Description {
        let loads = &setting.loads;
        let turn = (setting.direction_deg - self.beta_deg).to_radians();
        let plate = |(piece, line): (super::shape::Piece, Vec<Point>)| PlateEntry {
            name: TOOL.into(),
            line,
            delta_deg: piece.delta_deg,
            adhesion_kpa: 1e-3 * piece.adhesion_pa,
            ..PlateEntry::default()
        };
        let slope = if self.beta_deg == 0.0 {
            String::new()
        } else {
            format!(", axes along a surface that rises by {} deg", self.beta_deg)
        };
        let name = self.file.title.clone().unwrap_or_else(|| "tool".into());
        Description {
            schema: Some(soilctl_limit_analysis::describe::PROBLEM_SCHEMA.into()),
            title: Some(format!("{name}{slope}")),
            surcharge_kpa: 1e-3 * loads.surcharge_pa,
            default_boundary: Some(Kind::Free),
            objective: Aim::Structure { name: TOOL.into(), direction: [turn.cos(), turn.sin()] },
            seismic: (self.beta_deg != 0.0)
                .then(|| Seismic { kh: -self.beta_deg.to_radians().tan(), kv: 0.0 }),
            soils: vec![SoilEntry {
                name: SOIL.into(),
                phi_deg: Some(setting.phi_deg),
                cohesion_kpa: 1e-3 * loads.cohesion_pa,
                unit_weight_kn_m3: self.across_surface(self.unit_weight_kn_m3),
                ..SoilEntry::default()
            }],
            regions,
            boundaries: vec![BoundaryEntry::on_sides(Kind::Far, &[Side::Left, Side::Right, Side::Bottom])],
            plates: self.shape.runs().into_iter().map(plate).collect(),
            ..Description::default()
        }
    }

    /// The problem of the tool alone.
    pub(crate) fn alone(&self, setting: &Setting) -> Description {
        let [left, right, bottom] = self.extents(setting.phi_deg, self.size_m());
        let polygon = vec![[left, bottom], [right, bottom], [right, 0.0], [left, 0.0]];
        self.description(setting, vec![RegionEntry { name: None, soil: SOIL.into(), polygon }])
    }
}

#[cfg(test)]
mod tests {
    use soilctl_certificate::Objective;
    use soilctl_limit_analysis::EmbeddedPlate;

    use super::*;
    use crate::request::Loads;

    fn flat(points_m: Vec<[f64; 2]>) -> ToolFile {
        ToolFile { points_m, ..ToolFile::default() }
    }

    /// The statement of a flat tool says what that of the same plate does: of gravity, motion, materials and loads.
    #[test]
    fn a_flat_tool_on_a_slope_is_the_plate() {
        let loads = Loads {
            beta_deg: 10.0,
            cohesion_pa: 300.0,
            surcharge_pa: 150.0,
            adhesion_pa: 90.0,
            ..Loads::default()
        };
        let setting = Setting {
            alpha_deg: Some(50.0),
            phi_deg: 35.0,
            delta_deg: Some(20.0),
            density_kg_m3: 1600.0,
            loads,
            ..Setting::default()
        };
        let placed = Placed::of_file(flat(vec![[0.0, 0.0], [0.0, 0.2]]), &setting).unwrap();
        let found = placed.alone(&setting).described().unwrap();
        let scale = 0.2 * 1600.0 * loads.gravity_m_s2;
        let plate = EmbeddedPlate {
            alpha_deg: 50.0,
            beta_deg: 10.0,
            phi_deg: 35.0,
            delta_deg: 20.0,
            cohesion: loads.cohesion_pa / scale,
            adhesion: loads.adhesion_pa / scale,
            surcharge: loads.surcharge_pa / scale,
        };
        let problem = plate.problem().unwrap();
        let wanted = problem.statement();
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} is not {b}");
        let (size, stress) = (found.length_m / 0.2, 1e3 * found.stress_kpa / scale);
        let own = found.statement;
        let weight = own.regions[0].material.unit_weight * stress / size;
        for axis in 0..2 {
            close(weight * own.gravity[axis], wanted.gravity[axis]);
        }
        close(own.surcharge * stress, plate.surcharge);
        close(own.regions[0].material.cohesion.at([0.0; 2]) * stress, plate.cohesion);
        let (Objective::Structure { velocity: a }, Objective::Structure { velocity: b }) =
            (&own.objective, &wanted.objective)
        else {
            panic!("both are pushed");
        };
        close(a[0], b[0]);
        close(a[1], b[1]);
        // The tip is as far from the top, in the same direction.
        let tip = wanted.points[EmbeddedPlate::TIP];
        close(placed.tip()[0] / 0.2, tip[0]);
        close(placed.tip()[1] / 0.2, tip[1]);
    }

    #[test]
    fn interfaces_that_no_proof_covers_are_refused() {
        let setting =
            Setting { phi_deg: 30.0, delta_deg: Some(31.0), density_kg_m3: 1600.0, ..Setting::default() };
        let refused = |setting: &Setting| {
            Placed::of_file(flat(vec![[0.0, 0.0], [0.0, 0.2]]), setting).unwrap_err().to_string()
        };
        assert!(refused(&setting).contains("more than that of the soil"));
        let sticky = Loads { adhesion_pa: 10.0, ..Loads::default() };
        assert!(
            refused(&Setting { delta_deg: Some(0.0), loads: sticky, ..setting.clone() })
                .contains("without friction")
        );
        let steep = Loads { beta_deg: 30.0, ..Loads::default() };
        assert!(
            refused(&Setting { delta_deg: Some(10.0), loads: steep, ..setting }).contains("slopes by 30 deg")
        );
    }
}
