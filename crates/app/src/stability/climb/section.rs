//! The ground under a wheel on a slope, as a problem.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, MemberEntry, PROBLEM_SCHEMA, Profile, RegionEntry, Seismic, Side, SoilEntry,
};

use super::Request;

/// Half the length of the ground, and its depth, in lengths of the contact.
const HALF_LENGTH: f64 = 12.0;
const DEPTH: f64 = 6.0;
/// How many times its load the contact bears, so that it is rigid.
const RIGID: f64 = 100.0;
const SOIL: &str = "soil";

/// The section along the slope, in axes along and across the surface, which rises along x. Weight and acceleration together are gravity, which is turned;
/// the unit weight across the surface is for who knows the density. The wheel is a rigid strip whose load leans by the slope.
pub(super) fn section(request: &Request, slope_deg: f64) -> Description {
    let (sin, cos) = slope_deg.to_radians().sin_cos();
    let length = request.contact_length_m;
    let pressure_kpa = 1e-3 * request.pressure_pa();
    let force = RIGID * pressure_kpa * length;
    let [far, deep] = [HALF_LENGTH * length, -DEPTH * length];
    let contact = vec![[0.5 * length, 0.0], [-0.5 * length, 0.0]];
    Description {
        schema: Some(PROBLEM_SCHEMA.into()),
        title: Some(format!("wheel on a slope of {slope_deg} deg")),
        default_boundary: Some(Kind::Free),
        objective: Aim::Load {},
        seismic: (slope_deg != 0.0).then(|| Seismic { kh: -sin / cos, kv: 0.0 }),
        soils: vec![SoilEntry {
            name: SOIL.into(),
            phi_deg: Some(30.0),
            unit_weight_kn_m3: 1.0,
            ..SoilEntry::default()
        }],
        regions: vec![RegionEntry {
            name: None,
            soil: SOIL.into(),
            polygon: vec![[-far, deep], [far, deep], [far, 0.0], [-far, 0.0]],
        }],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Left, Side::Right, Side::Bottom]),
            BoundaryEntry {
                pressure_kpa: Some(Profile::Uniform(pressure_kpa * cos)),
                shear_kpa: Some(Profile::Uniform(pressure_kpa * sin)),
                live: true,
                ..BoundaryEntry::on_line(Kind::Load, &contact)
            },
        ],
        members: vec![MemberEntry {
            name: "wheel".into(),
            line: contact.into_iter().rev().collect(),
            tensile_kn_per_m: force,
            compressive_kn_per_m: force,
            bond_factor: request.bond_factor,
            moment_knm_per_m: Some(force * length),
            shear_kn_per_m: Some(force),
            ..MemberEntry::default()
        }],
        ..Description::default()
    }
}
