use crate::allowed::Allowed::{
    self, AtLeastZero, Deviation, InterfaceAngle, Positive, Signed, ToolAngle, Whole,
};
use crate::{StrokeRow, TextColumn};

/// A column of numbers that this crate knows by name.
pub(crate) struct NumberColumn {
    pub(crate) name: &'static str,
    pub(crate) allowed: Allowed,
    pub(crate) required: bool,
    pub(crate) get: fn(&StrokeRow) -> Option<f64>,
    pub(crate) set: fn(&mut StrokeRow, f64),
}

macro_rules! required {
    ($field:ident, $allowed:expr) => {
        NumberColumn {
            name: stringify!($field),
            allowed: $allowed,
            required: true,
            get: |row| Some(row.$field),
            set: |row, value| row.$field = value,
        }
    };
}

macro_rules! optional {
    ($field:ident, $allowed:expr) => {
        NumberColumn {
            name: stringify!($field),
            allowed: $allowed,
            required: false,
            get: |row| row.$field,
            set: |row, value| row.$field = Some(value),
        }
    };
}

/// Names of the text columns, written before all others.
pub(crate) const TEXTS: [&str; 2] = ["stroke_id", "batch"];

/// Number columns in the order in which a new table is written.
pub(crate) static NUMBERS: [NumberColumn; 25] = [
    NumberColumn {
        name: "order",
        allowed: Whole,
        required: false,
        get: |row| row.order.map(f64::from),
        // In range because `Whole` was checked before.
        set: |row, value| row.order = Some(value as u32),
    },
    optional!(time_s, Signed("s")),
    required!(alpha_deg, ToolAngle),
    required!(depth_m, Positive("m")),
    required!(width_m, Positive("m")),
    optional!(speed_mps, AtLeastZero("m/s")),
    optional!(radius_m, AtLeastZero("m")),
    optional!(base_deg, Signed("deg")),
    optional!(gap_prior_m, AtLeastZero("m")),
    optional!(wall_m, AtLeastZero("m")),
    optional!(density_kg_m3, Positive("kg/m3")),
    optional!(delta_set_deg, InterfaceAngle),
    required!(force_n, Positive("N")),
    optional!(force_sd_n, Deviation),
    optional!(tare_before_n, Signed("N")),
    optional!(tare_after_n, Signed("N")),
    optional!(cmd_minus_force_n, Signed("N")),
    optional!(friction_angle_deg, Signed("deg")),
    optional!(z_drift_m, Signed("m")),
    optional!(displacement_at_failure_m, Signed("m")),
    optional!(post_slope_norm, Signed("")),
    optional!(residual_ratio, Signed("")),
    optional!(heap_height_m, Signed("m")),
    optional!(motor_ext_gap_m, Signed("m")),
    optional!(x_step_m, AtLeastZero("m")),
];

/// A column with its cells.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Column {
    /// An entry of [`NUMBERS`] by its place there; NaN where nothing was measured.
    Number(usize, Vec<f64>),
    /// Text, one of [`TEXTS`] or unknown.
    Text(TextColumn),
}

impl Column {
    /// An empty column of this name.
    pub(crate) fn new(name: &str) -> Self {
        match NUMBERS.iter().position(|column| column.name == name) {
            Some(index) => Self::Number(index, Vec::new()),
            None => Self::Text(TextColumn::new(name)),
        }
    }

    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Number(index, _) => NUMBERS[*index].name,
            Self::Text(column) => column.name(),
        }
    }
}
