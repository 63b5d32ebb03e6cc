use crate::ProcessError;

/// Bounds on the force near a fixed block over that without it, as `soilctl obstacle` proves them; `data/obstacle_ratios.json` tells how.
const SHIPPED: &str = include_str!("../../../../data/obstacle_ratios.csv");

/// Proven bounds at one place of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratio {
    /// Friction angle of the soil in deg.
    pub phi_deg: f64,
    /// Distance of the block ahead of the plate's lower edge, over the plate's depth.
    pub ahead_depths: f64,
    /// Depth of its top, over the plate's depth.
    pub top_depths: f64,
    /// Lower bound on the force over that without the block, at least 1.
    pub lower: f64,
    /// Upper bound; infinite where none was found.
    pub upper: f64,
}

/// Bounds at many places and some friction angles, of an upright plate in sand without cohesion, in plane strain.
///
/// The block reaches from its top further down than the plate and far ahead. One that is further away or deeper is a part of it, so the force is no more:
/// a lower bound holds for all that is nearer and higher, an upper bound for all that is further and deeper. Nothing is interpolated.
#[derive(Debug, Clone, PartialEq)]
pub struct Ratios {
    ratios: Vec<Ratio>,
    /// Ends of the friction angles in deg.
    phi_deg: [f64; 2],
}

impl Ratios {
    /// The table that comes with the program.
    ///
    /// # Panics
    /// Never: a test reads the same text.
    #[must_use]
    pub fn shipped() -> Self {
        match Self::from_csv(SHIPPED) {
            Some(ratios) => ratios,
            None => unreachable!("the table is read by a test"),
        }
    }

    /// The table in the columns `phi_deg`, `ahead_depths`, `top_depths`, `ratio_lower`, `ratio_upper`, the last empty where there is no bound;
    /// `None` if that is not what it is.
    #[must_use]
    fn from_csv(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        if lines.next()? != "phi_deg,ahead_depths,top_depths,ratio_lower,ratio_upper" {
            return None;
        }
        let number = |cell: &str| cell.parse().ok().filter(|value: &f64| value.is_finite() && *value > 0.0);
        let row = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            let &[phi, ahead, top, lower, upper] = cells.as_slice() else { return None };
            Some(Ratio {
                phi_deg: number(phi)?,
                ahead_depths: number(ahead)?,
                top_depths: number(top)?,
                lower: number(lower)?,
                upper: if upper.is_empty() { f64::INFINITY } else { number(upper)? },
            })
        };
        Self::new(lines.map(row).collect::<Option<_>>()?)
    }

    /// A table of bounds; `None` of none at all.
    #[must_use]
    pub fn new(ratios: Vec<Ratio>) -> Option<Self> {
        let phi = ratios.iter().map(|ratio| ratio.phi_deg);
        let phi_deg = [phi.clone().reduce(f64::min)?, phi.reduce(f64::max)?];
        Some(Self { ratios, phi_deg })
    }

    /// Ends of the friction angles in deg that there are bounds for.
    #[must_use]
    pub const fn phi_deg(&self) -> [f64; 2] {
        self.phi_deg
    }

    /// The highest top that there are bounds for, over the plate's depth.
    #[must_use]
    pub fn least_top_depths(&self) -> f64 {
        self.ratios.iter().map(|ratio| ratio.top_depths).fold(f64::INFINITY, f64::min)
    }

    /// All bounds.
    #[must_use]
    pub fn ratios(&self) -> &[Ratio] {
        &self.ratios
    }

    /// The friction angles of the table that are nearest to a range in deg from outside, and those between.
    ///
    /// # Errors
    /// [`ProcessError::OutOfRange`] of an end beyond those of the table.
    pub fn friction_angles_deg(&self, [low, high]: [f64; 2]) -> Result<Vec<f64>, ProcessError> {
        let [least, most] = self.phi_deg;
        for value in [low, high] {
            if !(least..=most).contains(&value) {
                let allowed =
                    "within the friction angles of the table of bounds, from the lower to the upper";
                return Err(ProcessError::OutOfRange { what: "friction angle", value, unit: "deg", allowed });
            }
        }
        let (low, high) = (low.min(high), low.max(high));
        let mut all: Vec<f64> = self.ratios.iter().map(|ratio| ratio.phi_deg).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let from = all.iter().rposition(|phi| *phi <= low).unwrap_or_default();
        let to = all.iter().position(|phi| *phi >= high).unwrap_or(all.len() - 1);
        Ok(all.get(from..=to.max(from)).unwrap_or_default().to_vec())
    }

    /// Between which ratios the force lies for any block with its face and its top within these ranges, in depths of the plate, in soil of any of
    /// these friction angles of the table.
    #[must_use]
    pub fn between(&self, phi_deg: &[f64], ahead: [f64; 2], top: [f64; 2]) -> [f64; 2] {
        // A block below the plate is in nobody's way.
        if top[0] >= 1.0 {
            return [1.0, 1.0];
        }
        let at = |phi: f64| {
            let of = self.ratios.iter().filter(move |ratio| ratio.phi_deg == phi);
            let nearer = of.clone().filter(|r| r.ahead_depths >= ahead[1] && r.top_depths >= top[1]);
            let further = of.filter(|r| r.ahead_depths <= ahead[0] && r.top_depths <= top[0]);
            (
                nearer.map(|r| r.lower).fold(1.0, f64::max),
                further.map(|r| r.upper).fold(f64::INFINITY, f64::min),
            )
        };
        let all: Vec<(f64, f64)> = phi_deg.iter().map(|phi| at(*phi)).collect();
        [
            all.iter().map(|one| one.0).fold(f64::INFINITY, f64::min).max(1.0),
            all.iter().map(|one| one.1).fold(1.0, f64::max),
        ]
    }
}
