use soilctl_strokes::StrokeRow;

/// A reading that comes from the trace of a stroke and not from its failure force: a column of the stroke table, or, if only a
/// trace itself has it, a number a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Channel {
    /// Free-air reading before the stroke, N.
    TareBefore,
    /// Free-air reading after the stroke, N.
    TareAfter,
    /// Force from the motor torques minus that of the sensor, N.
    CmdMinusForce,
    /// Friction angle just before failure, deg.
    FrictionAngle,
    /// Vertical drift of the tip, up positive, m.
    ZDrift,
    /// Displacement at failure, m.
    Displacement,
    /// Slope after the break, `(dF/du) H/F`.
    PostSlope,
    /// Force half a depth after failure over the failure force.
    ResidualRatio,
    /// Height of the heap before the stroke, m.
    HeapHeight,
    /// Motor-side minus external position, m.
    MotorExtGap,
    /// Smallest repeated encoder step, m.
    XStep,
    /// Change of motor-side minus external position with the force while it rises, m/N; no column has it.
    GapSlope,
    /// Friction angle after failure, while failed soil slips along the plate, deg; no column has it.
    SlipAngle,
    /// Free-air reading before the stroke across the plate, N.
    AirAcross,
    /// The same along the plate, N.
    AirAlong,
    /// Height of the surface where it was touched above that which the log states, m.
    TouchHeight,
    /// Mean force along the plate while it was inserted, N.
    InsertionForce,
    /// Inclination of the force by the motors minus that by the sensor, deg.
    MotorAngle,
    /// Motor minus external angle of the shoulder before failure, above that in free air, deg.
    ShoulderLoop,
    /// The same of the elbow, deg.
    ElbowLoop,
}

impl Channel {
    /// All channels.
    pub const ALL: [Self; 20] = [
        Self::TareBefore,
        Self::TareAfter,
        Self::CmdMinusForce,
        Self::FrictionAngle,
        Self::ZDrift,
        Self::Displacement,
        Self::PostSlope,
        Self::ResidualRatio,
        Self::HeapHeight,
        Self::MotorExtGap,
        Self::XStep,
        Self::GapSlope,
        Self::SlipAngle,
        Self::AirAcross,
        Self::AirAlong,
        Self::TouchHeight,
        Self::InsertionForce,
        Self::MotorAngle,
        Self::ShoulderLoop,
        Self::ElbowLoop,
    ];

    /// Whether nobody can say what it reads without an effect but who simulates the same stroke: zero, weight and play of an arm are its own.
    #[must_use]
    pub const fn is_compared_only(self) -> bool {
        match self {
            Self::AirAcross
            | Self::AirAlong
            | Self::TouchHeight
            | Self::InsertionForce
            | Self::MotorAngle
            | Self::ShoulderLoop
            | Self::ElbowLoop => true,
            Self::TareBefore
            | Self::TareAfter
            | Self::CmdMinusForce
            | Self::FrictionAngle
            | Self::ZDrift
            | Self::Displacement
            | Self::PostSlope
            | Self::ResidualRatio
            | Self::HeapHeight
            | Self::MotorExtGap
            | Self::XStep
            | Self::GapSlope
            | Self::SlipAngle => false,
        }
    }

    /// Name of the column in the stroke table, or of what only traces have.
    #[must_use]
    pub const fn column(self) -> &'static str {
        match self {
            Self::TareBefore => "tare_before_n",
            Self::TareAfter => "tare_after_n",
            Self::CmdMinusForce => "cmd_minus_force_n",
            Self::FrictionAngle => "friction_angle_deg",
            Self::ZDrift => "z_drift_m",
            Self::Displacement => "displacement_at_failure_m",
            Self::PostSlope => "post_slope_norm",
            Self::ResidualRatio => "residual_ratio",
            Self::HeapHeight => "heap_height_m",
            Self::MotorExtGap => "motor_ext_gap_m",
            Self::XStep => "x_step_m",
            Self::GapSlope => "motor_ext_gap_slope_m_per_n",
            Self::SlipAngle => "slip_angle_deg",
            Self::AirAcross => "air_across_n",
            Self::AirAlong => "air_along_n",
            Self::TouchHeight => "touch_z_m",
            Self::InsertionForce => "insertion_force_n",
            Self::MotorAngle => "motor_angle_deg",
            Self::ShoulderLoop => "shoulder_loop_deg",
            Self::ElbowLoop => "elbow_loop_deg",
        }
    }

    /// The cell of a stroke; `None` if it is empty, or if no column has it.
    #[must_use]
    pub const fn of(self, row: &StrokeRow) -> Option<f64> {
        match self {
            Self::TareBefore => row.tare_before_n,
            Self::TareAfter => row.tare_after_n,
            Self::CmdMinusForce => row.cmd_minus_force_n,
            Self::FrictionAngle => row.friction_angle_deg,
            Self::ZDrift => row.z_drift_m,
            Self::Displacement => row.displacement_at_failure_m,
            Self::PostSlope => row.post_slope_norm,
            Self::ResidualRatio => row.residual_ratio,
            Self::HeapHeight => row.heap_height_m,
            Self::MotorExtGap => row.motor_ext_gap_m,
            Self::XStep => row.x_step_m,
            Self::AirAcross => row.air_across_n,
            Self::AirAlong => row.air_along_n,
            Self::TouchHeight => row.touch_z_m,
            Self::InsertionForce => row.insertion_force_n,
            Self::MotorAngle => row.motor_angle_deg,
            Self::ShoulderLoop => row.shoulder_loop_deg,
            Self::ElbowLoop => row.elbow_loop_deg,
            Self::GapSlope | Self::SlipAngle => None,
        }
    }

    /// Puts a reading into an empty cell of a stroke; nothing happens to one that is not empty, or if no column has it.
    pub fn fill(self, row: &mut StrokeRow, value: f64) {
        if self.of(row).is_none() {
            self.put(row, Some(value));
        }
    }

    /// Puts a reading, or none, into the cell of a stroke; nothing happens if no column has it.
    pub fn put(self, row: &mut StrokeRow, value: Option<f64>) {
        let cell = match self {
            Self::TareBefore => &mut row.tare_before_n,
            Self::TareAfter => &mut row.tare_after_n,
            Self::CmdMinusForce => &mut row.cmd_minus_force_n,
            Self::FrictionAngle => &mut row.friction_angle_deg,
            Self::ZDrift => &mut row.z_drift_m,
            Self::Displacement => &mut row.displacement_at_failure_m,
            Self::PostSlope => &mut row.post_slope_norm,
            Self::ResidualRatio => &mut row.residual_ratio,
            Self::HeapHeight => &mut row.heap_height_m,
            Self::MotorExtGap => &mut row.motor_ext_gap_m,
            Self::XStep => &mut row.x_step_m,
            Self::AirAcross => &mut row.air_across_n,
            Self::AirAlong => &mut row.air_along_n,
            Self::TouchHeight => &mut row.touch_z_m,
            Self::InsertionForce => &mut row.insertion_force_n,
            Self::MotorAngle => &mut row.motor_angle_deg,
            Self::ShoulderLoop => &mut row.shoulder_loop_deg,
            Self::ElbowLoop => &mut row.elbow_loop_deg,
            Self::GapSlope | Self::SlipAngle => return,
        };
        *cell = value;
    }
}
