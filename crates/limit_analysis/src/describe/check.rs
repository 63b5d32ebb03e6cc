//! Numbers, names and amounts, before any geometry.

use super::error::DescriptionError;
use super::input::{Aim, AnisotropyEntry, Description, SoilEntry};
use super::parts::{Interface, Kind, Profile, SoilInterface};

/// Most points of all polygons and lines together.
const MAX_POINTS: usize = 2000;

/// Most entries of one kind.
const MAX_ENTRIES: usize = 256;

/// Coordinates and stresses beyond this are a mistake.
const LARGEST: f64 = 1e9;

/// How an entry is called: `region 2 ("clay")`.
pub(super) fn title(kind: &str, index: usize, name: &str) -> String {
    let number = index + 1;
    if name.is_empty() { format!("{kind} {number}") } else { format!("{kind} {number} (\"{name}\")") }
}

impl Description {
    pub(super) fn soil_title(&self, index: usize) -> String {
        title("soil", index, &self.soils[index].name)
    }

    pub(super) fn region_title(&self, index: usize) -> String {
        let region = &self.regions[index];
        title("region", index, region.name.as_ref().unwrap_or(&region.soil))
    }

    pub(super) fn boundary_title(&self, index: usize) -> String {
        title("boundary", index, self.boundaries[index].name.as_deref().unwrap_or(""))
    }

    pub(super) fn plate_title(&self, index: usize) -> String {
        title("plate", index, &self.plates[index].name)
    }

    pub(super) fn structure_title(&self, index: usize) -> String {
        title("structure", index, &self.structures[index].name)
    }

    pub(super) fn head_title(&self, index: usize) -> String {
        title("head", index, self.heads[index].name.as_deref().unwrap_or(""))
    }

    pub(super) fn member_title(&self, index: usize) -> String {
        title("member", index, &self.members[index].name)
    }

    /// Index of a soil by its name.
    pub(super) fn soil_index(&self, entry: &str, name: &str) -> Result<usize, DescriptionError> {
        self.soils.iter().position(|s| s.name == name).ok_or_else(|| DescriptionError::Unknown {
            entry: entry.to_owned(),
            key: "soil",
            name: name.to_owned(),
            known: list(self.soils.iter().map(|s| s.name.as_str())),
        })
    }

    /// Checks everything but the geometry.
    pub(crate) fn check(&self) -> Result<(), DescriptionError> {
        self.check_amount()?;
        number("the problem", "surcharge_kpa", self.surcharge_kpa, STRESS)?;
        for (i, soil) in self.soils.iter().enumerate() {
            let entry = self.soil_title(i);
            check_soil(&entry, soil)?;
            if self.soils[..i].iter().any(|s| s.name == soil.name) {
                return Err(DescriptionError::entry(entry, "an earlier soil has the same name; rename one"));
            }
        }
        for (i, region) in self.regions.iter().enumerate() {
            let entry = self.region_title(i);
            self.soil_index(&entry, &region.soil)?;
            check_line(&entry, "polygon", &region.polygon, 3)?;
        }
        self.check_structures()?;
        self.check_members()?;
        self.check_boundaries()?;
        self.check_water()?;
        self.check_seepage()?;
        if let Some(seismic) = self.seismic {
            number("seismic", "kh", seismic.kh, Range { low: -10.0, high: 10.0, words: "-10 to 10" })?;
            number(
                "seismic",
                "kv",
                seismic.kv,
                Range { low: -10.0, high: BELOW_ONE, words: "-10 to below 1" },
            )?;
        }
        self.check_aim()
    }

    fn check_amount(&self) -> Result<(), DescriptionError> {
        let counts = [
            ("soils", self.soils.len()),
            ("regions", self.regions.len()),
            ("boundaries", self.boundaries.len()),
            ("plates", self.plates.len()),
            ("structures", self.structures.len()),
            ("members", self.members.len()),
            ("heads", self.heads.len()),
        ];
        for (what, count) in counts {
            if count > MAX_ENTRIES {
                return Err(DescriptionError::TooMuch { what, count, limit: MAX_ENTRIES });
            }
        }
        if self.regions.is_empty() {
            return Err(DescriptionError::entry(
                "the problem",
                "it has no soil; add [[soil]] and [[region]]",
            ));
        }
        let points = self.regions.iter().map(|r| r.polygon.len()).sum::<usize>()
            + self.boundaries.iter().map(|b| b.line.len()).sum::<usize>()
            + self.plates.iter().map(|p| p.line.len()).sum::<usize>()
            + self.structures.iter().map(|s| s.polygon.len() + s.edge.len()).sum::<usize>()
            + self.members.iter().map(|m| m.line.len()).sum::<usize>()
            + self.heads.iter().map(|h| h.line.len()).sum::<usize>()
            + self.water.iter().map(|w| w.table.len()).sum::<usize>();
        if points > MAX_POINTS {
            return Err(DescriptionError::TooMuch { what: "points", count: points, limit: MAX_POINTS });
        }
        Ok(())
    }

    fn check_structures(&self) -> Result<(), DescriptionError> {
        for (i, plate) in self.plates.iter().enumerate() {
            let entry = self.plate_title(i);
            check_line(&entry, "line", &plate.line, 2)?;
            let both = Interface { delta_deg: plate.delta_deg, adhesion_kpa: plate.adhesion_kpa };
            for face in [Some(both), plate.left, plate.right].into_iter().flatten() {
                check_interface(&entry, face)?;
            }
            self.check_in_soil(&entry, &plate.in_soil)?;
        }
        for (i, s) in self.structures.iter().enumerate() {
            let entry = self.structure_title(i);
            match (s.polygon.is_empty(), s.edge.is_empty()) {
                (false, true) => check_line(&entry, "polygon", &s.polygon, 3)?,
                (true, false) => check_line(&entry, "edge", &s.edge, 2)?,
                _ => return Err(DescriptionError::entry(entry, "give either polygon or edge")),
            }
            check_interface(&entry, Interface { delta_deg: s.delta_deg, adhesion_kpa: s.adhesion_kpa })?;
            self.check_in_soil(&entry, &s.in_soil)?;
        }
        Ok(())
    }

    fn check_members(&self) -> Result<(), DescriptionError> {
        for (i, member) in self.members.iter().enumerate() {
            let entry = self.member_title(i);
            check_line(&entry, "line", &member.line, 2)?;
            if member.line.len() > 2 {
                let problem =
                    "a member is straight: its line has a start and an end; make one of each straight part";
                return Err(DescriptionError::entry(entry, problem));
            }
            number(&entry, "tensile_kn_per_m", member.tensile_kn_per_m, FORCE)?;
            number(&entry, "compressive_kn_per_m", member.compressive_kn_per_m, FORCE)?;
            number(&entry, "bond_factor", member.bond_factor, BOND)?;
            super::pullout::check(&entry, member)?;
            if member.moment_knm_per_m.is_some() != member.shear_kn_per_m.is_some() {
                let problem =
                    "a beam has both moment_knm_per_m and shear_kn_per_m; a bar or a sheet has neither";
                return Err(DescriptionError::entry(entry, problem));
            }
            if let (Some(moment), Some(shear)) = (member.moment_knm_per_m, member.shear_kn_per_m) {
                for (key, most) in [
                    ("moment_knm_per_m", moment),
                    ("shear_kn_per_m", shear),
                    ("tensile_kn_per_m", member.tensile_kn_per_m),
                    ("compressive_kn_per_m", member.compressive_kn_per_m),
                ] {
                    number(&entry, key, most, BENDING)?;
                }
            }
            if self.members[..i].iter().any(|m| m.name == member.name) {
                return Err(DescriptionError::entry(
                    entry,
                    "an earlier member has the same name; rename one",
                ));
            }
        }
        Ok(())
    }

    fn check_in_soil(&self, entry: &str, faces: &[SoilInterface]) -> Result<(), DescriptionError> {
        for face in faces {
            self.soil_index(entry, &face.soil)?;
            let face = Interface { delta_deg: face.delta_deg, adhesion_kpa: face.adhesion_kpa };
            check_interface(entry, face)?;
        }
        Ok(())
    }

    fn check_boundaries(&self) -> Result<(), DescriptionError> {
        if self.default_boundary == Some(Kind::Load) {
            let problem = "default_boundary cannot be a load; add a [[boundary]] with its pressure";
            return Err(DescriptionError::entry("the problem", problem));
        }
        for (i, b) in self.boundaries.iter().enumerate() {
            let entry = self.boundary_title(i);
            let wrong = |problem: &str| Err(DescriptionError::entry(entry.clone(), problem));
            if b.sides.is_empty() == b.line.is_empty() {
                return wrong("give either sides, such as [\"left\", \"right\"], or a line of points");
            }
            if !b.line.is_empty() {
                check_line(&entry, "line", &b.line, 2)?;
            }
            let loads = [("pressure_kpa", b.pressure_kpa), ("shear_kpa", b.shear_kpa)];
            for (key, profile) in loads {
                let Some(profile) = profile else { continue };
                if b.kind != Kind::Load {
                    return wrong("only kind = \"load\" has pressure_kpa or shear_kpa");
                }
                for value in profile.ends() {
                    number(&entry, key, value, Range { low: -LARGEST, ..STRESS })?;
                }
                if b.line.is_empty() && matches!(profile, Profile::Linear(_)) {
                    return wrong("a load that varies needs a line, not sides");
                }
            }
            if b.line.is_empty() && b.shear_kpa.is_some() {
                return wrong("shear_kpa acts along a line; give line, not sides");
            }
            if b.kind == Kind::Load && b.pressure_kpa.is_none() && b.shear_kpa.is_none() {
                return wrong("a load needs pressure_kpa or shear_kpa");
            }
            if b.live && b.kind != Kind::Load {
                return wrong("only kind = \"load\" can be live");
            }
            if b.action.is_some() && b.kind != Kind::Load {
                return wrong("only kind = \"load\" has an action");
            }
        }
        Ok(())
    }

    fn check_water(&self) -> Result<(), DescriptionError> {
        let Some(water) = &self.water else { return Ok(()) };
        check_line("water", "table", &water.table, 1)?;
        number("water", "rise_m", water.rise_m, COORDINATE)?;
        number("water", "unit_weight_kn_m3", water.unit_weight_kn_m3, WATER)?;
        if water.table.windows(2).any(|w| w[1][0] <= w[0][0]) {
            return Err(DescriptionError::entry(
                "water",
                "the points of the table must run from left to right",
            ));
        }
        match self.soils.iter().position(|s| s.pore_pressure_ratio > 0.0) {
            Some(soil) => {
                let problem = "pore_pressure_ratio and a water table exclude each other; keep one";
                Err(DescriptionError::entry(self.soil_title(soil), problem))
            }
            None => Ok(()),
        }
    }

    fn check_seepage(&self) -> Result<(), DescriptionError> {
        let wrong = |entry: String, problem: &str| Err(DescriptionError::entry(entry, problem));
        if self.heads.is_empty() {
            return match self.seepage {
                Some(_) => wrong("seepage".into(), "no head is given; add [[head]] with line and head_m"),
                None => Ok(()),
            };
        }
        number("seepage", "unit_weight_kn_m3", self.seepage.unwrap_or_default().unit_weight_kn_m3, WATER)?;
        if self.water.is_some() {
            let problem = "a water table is ground water at rest, and [[head]] is water that flows; keep one";
            return wrong("water".into(), problem);
        }
        for (i, head) in self.heads.iter().enumerate() {
            let entry = self.head_title(i);
            check_line(&entry, "line", &head.line, 2)?;
            number(&entry, "head_m", head.head_m, COORDINATE)?;
        }
        let used = |soil: &SoilEntry| self.regions.iter().any(|r| r.soil == soil.name);
        let several = self.soils.iter().filter(|s| used(s)).count() > 1;
        for (i, soil) in self.soils.iter().enumerate() {
            if soil.pore_pressure_ratio > 0.0 {
                let problem = "pore_pressure_ratio and water that flows exclude each other; keep one";
                return wrong(self.soil_title(i), problem);
            }
            if several && used(soil) && soil.permeability_m_per_s.is_none() {
                let problem = "water flows through several soils, so each needs permeability_m_per_s";
                return wrong(self.soil_title(i), problem);
            }
        }
        Ok(())
    }

    fn check_aim(&self) -> Result<(), DescriptionError> {
        let wrong = |problem: &str| Err(DescriptionError::entry("objective", problem));
        match &self.objective {
            Aim::Structure { name, direction } => {
                for x in direction {
                    number("objective", "direction", *x, Range { low: -LARGEST, ..STRESS })?;
                }
                if *direction == [0.0; 2] {
                    return wrong("direction is [0, 0]; say where the structure moves");
                }
                let known = || {
                    let plates = self.plates.iter().map(|p| (p.name.as_str(), p.held));
                    plates.chain(self.structures.iter().map(|s| (s.name.as_str(), s.held)))
                };
                if !known().any(|(n, _)| n == name) {
                    return Err(DescriptionError::Unknown {
                        entry: "objective".into(),
                        key: "name",
                        name: name.clone(),
                        known: list(known().map(|(n, _)| n)),
                    });
                }
                if known().any(|(n, held)| n == name && held.is_some()) {
                    return wrong("the structure that moves is held; leave out held");
                }
                match known().find(|(n, held)| n != name && held.is_none()) {
                    Some((other, _)) => {
                        wrong(&format!("\"{other}\" does not move; say held = \"fixed\" or \"smooth\" there"))
                    }
                    None => Ok(()),
                }
            }
            Aim::Load {} if !self.boundaries.iter().any(|b| b.live) => {
                wrong("there is no live load to multiply; mark one with live = true")
            }
            Aim::UnitWeight {} | Aim::Seismic { .. } | Aim::StrengthReduction {}
                if self.soils.iter().all(|s| s.unit_weight_kn_m3 == 0.0) =>
            {
                wrong("no soil has weight, so nothing depends on it")
            }
            _ => Ok(()),
        }
    }
}

fn check_soil(entry: &str, soil: &SoilEntry) -> Result<(), DescriptionError> {
    let ratio = Range { low: 0.0, high: 1.0, words: "0 to 1" };
    let weight = Range { low: 0.0, high: 1e6, words: "0 to 1e6 kN/m3" };
    check_strength(entry, soil)?;
    check_anisotropy(entry, soil)?;
    number(entry, "cohesion_kpa", soil.cohesion_kpa, STRESS)?;
    let gradient = ("cohesion_gradient_kpa_per_m", soil.cohesion_gradient_kpa_per_m);
    number(entry, gradient.0, gradient.1, Range { low: -LARGEST, ..STRESS })?;
    number(entry, "unit_weight_kn_m3", soil.unit_weight_kn_m3, weight)?;
    number(entry, "tension_kpa", soil.tension_kpa.unwrap_or(0.0), STRESS)?;
    number(entry, "pore_pressure_ratio", soil.pore_pressure_ratio, ratio)?;
    number(entry, "permeability_m_per_s", soil.permeability_m_per_s.unwrap_or(1.0), PERMEABILITY)?;
    number(entry, "permeability_ratio", soil.permeability_ratio.unwrap_or(1.0), RATIO)?;
    number(entry, "cohesion_level_m", soil.cohesion_level_m.unwrap_or(0.0), COORDINATE)?;
    if gradient.1 != 0.0 && soil.cohesion_level_m.is_none() {
        let problem =
            "cohesion_gradient_kpa_per_m needs cohesion_level_m, the y where the cohesion is cohesion_kpa";
        return Err(DescriptionError::entry(entry, problem));
    }
    Ok(())
}

/// Strength that depends on the direction is that of clay whose tension is not limited.
fn check_anisotropy(entry: &str, soil: &SoilEntry) -> Result<(), DescriptionError> {
    let Some(AnisotropyEntry { passive, shear }) = soil.anisotropy else { return Ok(()) };
    let ratio = Range { low: 0.1, high: 10.0, words: "0.1 to 10, over cohesion_kpa" };
    number(entry, "anisotropy.passive", passive, ratio)?;
    number(entry, "anisotropy.shear", shear, ratio)?;
    if soil.phi_deg == Some(0.0) && soil.tension_kpa.is_none() {
        return Ok(());
    }
    let problem = "anisotropy goes with phi_deg = 0, and without strength and tension_kpa";
    Err(DescriptionError::entry(entry, problem))
}

/// A soil has a friction angle or a law of strength, not both.
fn check_strength(entry: &str, soil: &SoilEntry) -> Result<(), DescriptionError> {
    let wrong = |problem: &str| Err(DescriptionError::entry(entry, problem));
    let factor = Range { low: 0.01, high: 100.0, words: "0.01 to 100" };
    number(entry, "strength_factor", soil.strength_factor.unwrap_or(1.0), factor)?;
    match (soil.phi_deg, &soil.strength) {
        (None, None) => wrong("it has neither phi_deg, which is 0 for undrained clay, nor strength"),
        (Some(_), Some(_)) => wrong("it has phi_deg and strength; leave out one of them"),
        (Some(phi_deg), None) => {
            number(entry, "phi_deg", phi_deg, ANGLE)?;
            if soil.strength_factor.is_some() {
                return wrong("strength_factor goes with strength");
            }
            let dilation = Range { low: 0.0, high: phi_deg, words: "0 to phi_deg" };
            number(entry, "dilation_deg", soil.dilation_deg.unwrap_or(0.0), dilation)
        }
        (None, Some(law)) => {
            if soil.cohesion_kpa != 0.0
                || soil.cohesion_gradient_kpa_per_m != 0.0
                || soil.dilation_deg.is_some()
            {
                return wrong(
                    "with strength there is no cohesion_kpa, cohesion_gradient_kpa_per_m or dilation_deg",
                );
            }
            law.check(entry)
        }
    }
}

fn check_interface(entry: &str, face: Interface) -> Result<(), DescriptionError> {
    number(entry, "delta_deg", face.delta_deg, ANGLE)?;
    number(entry, "adhesion_kpa", face.adhesion_kpa, STRESS)
}

fn check_line(entry: &str, key: &str, points: &[[f64; 2]], least: usize) -> Result<(), DescriptionError> {
    if points.len() < least {
        let problem = format!("{key} has {} points, at least {least} are needed", points.len());
        return Err(DescriptionError::entry(entry, problem));
    }
    for p in points {
        number(entry, "x", p[0], COORDINATE)?;
        number(entry, "y", p[1], COORDINATE)?;
    }
    Ok(())
}

#[derive(Clone, Copy)]
pub(super) struct Range {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) words: &'static str,
}

/// The greatest number below one.
const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;
const ANGLE: Range = Range { low: 0.0, high: 90.0 * BELOW_ONE, words: "0 up to, but not including, 90 deg" };
pub(super) const STRESS: Range =
    Range { low: 0.0, high: LARGEST, words: "a finite number, at least 0 and at most 1e9 kPa" };
const FORCE: Range = Range { low: 0.0, high: 1e6, words: "0 to 1e6 kN/m" };
const BENDING: Range = Range { low: 1e-6, high: 1e6, words: "1e-6 to 1e6 kNm/m or kN/m for a beam" };
const WATER: Range = Range { low: f64::MIN_POSITIVE, high: 100.0, words: "above 0, at most 100 kN/m3" };
const PERMEABILITY: Range = Range { low: 1e-15, high: 1e3, words: "1e-15 to 1e3 m/s" };
const RATIO: Range = Range { low: 1e-3, high: 1e3, words: "0.001 to 1000" };
const BOND: Range = Range { low: 1e-3, high: 1.0, words: "0.001 to 1" };
const COORDINATE: Range =
    Range { low: -LARGEST, high: LARGEST, words: "a finite number of metres up to 1e9" };

pub(super) fn number(
    entry: &str,
    key: &'static str,
    value: f64,
    range: Range,
) -> Result<(), DescriptionError> {
    if (range.low..=range.high).contains(&value) {
        return Ok(());
    }
    // The same range serves quantities that may be negative.
    let signed = range.low == -LARGEST && range.words == STRESS.words;
    let allowed = if signed { "a finite number up to 1e9" } else { range.words };
    Err(DescriptionError::Number { entry: entry.to_owned(), key, value, allowed })
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|n| format!("\"{n}\"")).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
