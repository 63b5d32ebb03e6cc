//! Value and slopes of the stress function at a vertex, in as few unknowns as the conditions there leave.

use soilctl_certificate::Jet;
use soilctl_conic::Form;

use crate::vector::turned;

/// An unknown of the program and the size of its unit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Unknown {
    pub(crate) index: usize,
    pub(crate) unit: f64,
}

impl Unknown {
    pub(crate) fn form(self) -> Form {
        Form::unknown(self.index, self.unit)
    }

    pub(crate) fn value(self, x: &[f64]) -> f64 {
        self.unit * x[self.index]
    }
}

/// What is known about a vertex copy; the same kinds as [`Jet`], with unknowns in place of numbers.
#[derive(Debug, Clone)]
pub(crate) enum UnknownJet {
    /// On a free or loaded boundary: the gauge's affine function and what the loads demand.
    Gauge { gauge: usize, demanded: [Form; 3] },
    /// The affine function of the gauge `base`.
    Zero { base: usize },
    /// No condition.
    Free { base: usize, f: Unknown, fx: Unknown, fy: Unknown },
    /// Next to one apex, at `r` from it. `turn` is unknown or follows from a line of given shear.
    OneApex { base: usize, apex: usize, r: [f64; 2], f: Unknown, turn: Turn },
    /// Next to several apexes on a line with normal `n`, whose product with the way from that line is `away`.
    ManyApexes { base: usize, f: Unknown, n: [f64; 2], away: f64 },
    /// On a line with normal `n` (not of unit length) and the slope across it.
    OneLine { line: usize, n: [f64; 2], across: Form, f: Unknown, along: Unknown },
    /// On two lines.
    TwoLines { normals: [[f64; 2]; 2], across: [Form; 2], f: Unknown },
    /// On a member with normal `n`, on the other side of which a copy has the jet `beyond`: there is a jump if the member bears a force
    /// there.
    Kinked { copy: usize, base: usize, beyond: [Form; 3], line: usize, n: [f64; 2], jump: Option<Unknown> },
}

/// The free slope next to an apex.
#[derive(Debug, Clone)]
pub(crate) enum Turn {
    Unknown(Unknown),
    Given(Form),
}

impl UnknownJet {
    /// The gauge whose affine function the values are relative to.
    pub(crate) fn base(&self) -> usize {
        match self {
            Self::Gauge { gauge, .. } => *gauge,
            Self::Zero { base }
            | Self::OneApex { base, .. }
            | Self::ManyApexes { base, .. }
            | Self::Kinked { base, .. }
            | Self::Free { base, .. } => *base,
            Self::OneLine { .. } | Self::TwoLines { .. } => 0,
        }
    }

    /// The same unknowns relative to another gauge; `same` finds the apex with the same vertex.
    pub(crate) fn on(&self, base: usize, same: impl Fn(usize) -> Option<usize>) -> Self {
        let mut shape = self.clone();
        match &mut shape {
            Self::Gauge { gauge: b, .. }
            | Self::Zero { base: b }
            | Self::ManyApexes { base: b, .. }
            | Self::Free { base: b, .. } => *b = base,
            Self::OneApex { base: b, apex, .. } => (*b, *apex) = (base, same(*apex).unwrap_or(*apex)),
            Self::OneLine { .. } | Self::TwoLines { .. } | Self::Kinked { .. } => {}
        }
        shape
    }

    /// Value and slopes relative to [`Self::base`] and to the polynomial of the surface that it is next to.
    pub(crate) fn jet(&self) -> [Form; 3] {
        let zero = Form::default;
        match self {
            Self::Gauge { demanded, .. } => demanded.clone(),
            Self::Zero { .. } => [zero(), zero(), zero()],
            Self::Free { f, fx, fy, .. } => [f.form(), fx.form(), fy.form()],
            Self::OneApex { r, f, turn, .. } => {
                let f = f.form();
                let turn = match turn {
                    Turn::Unknown(u) => u.form(),
                    Turn::Given(form) => form.clone(),
                };
                let rr = r[0] * r[0] + r[1] * r[1];
                let t = turned(*r);
                let slope = |i: usize| zero().plus(3.0 * r[i] / rr, &f).plus(t[i], &turn);
                [f.clone(), slope(0), slope(1)]
            }
            Self::ManyApexes { f, n, away, .. } => {
                let f = f.form();
                let slope = |i: usize| zero().plus(3.0 * n[i] / away, &f);
                [f.clone(), slope(0), slope(1)]
            }
            Self::Kinked { beyond: [f, fx, fy], n, jump, .. } => match jump {
                None => [f.clone(), fx.clone(), fy.clone()],
                Some(jump) => {
                    let jump = jump.form();
                    [f.clone(), fx.clone().plus(n[0], &jump), fy.clone().plus(n[1], &jump)]
                }
            },
            Self::OneLine { n, across, f, along, .. } => {
                let nn = n[0] * n[0] + n[1] * n[1];
                let along = along.form();
                [
                    f.form(),
                    zero().plus(n[0] / nn, across).plus(n[1], &along),
                    zero().plus(n[1] / nn, across).plus(-n[0], &along),
                ]
            }
            Self::TwoLines { normals: [n, m], across: [g, h], f } => {
                let det = n[0] * m[1] - n[1] * m[0];
                [
                    f.form(),
                    zero().plus(m[1] / det, g).plus(-n[1] / det, h),
                    zero().plus(-m[0] / det, g).plus(n[0] / det, h),
                ]
            }
        }
    }

    /// The jet of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, x: &[f64]) -> Jet {
        match self {
            Self::Gauge { gauge, .. } => Jet::Gauge { gauge: *gauge },
            Self::Zero { base } => Jet::Zero { base: *base },
            Self::Free { base, f, fx, fy } => {
                Jet::Free { base: *base, f: f.value(x), fx: fx.value(x), fy: fy.value(x) }
            }
            Self::OneApex { base, apex, f, turn, .. } => Jet::OneApex {
                base: *base,
                apex: *apex,
                f: f.value(x),
                turn: match turn {
                    Turn::Unknown(u) => u.value(x),
                    Turn::Given(_) => 0.0,
                },
            },
            Self::ManyApexes { base, f, .. } => Jet::ManyApexes { base: *base, f: f.value(x) },
            Self::OneLine { line, f, along, .. } => {
                Jet::OneLine { line: *line, f: f.value(x), along: along.value(x) }
            }
            Self::TwoLines { f, .. } => Jet::TwoLines { f: f.value(x) },
            Self::Kinked { copy, line, jump, .. } => {
                Jet::Kinked { copy: *copy, line: *line, jump: jump.map_or(0.0, |jump| jump.value(x)) }
            }
        }
    }
}
