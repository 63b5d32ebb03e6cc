/// Where an effect acts. Everything that shows, simulates or hides effects matches this, so a new place is handled by all
/// of them or does not compile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Site {
    /// The soil itself.
    Soil(SoilSite),
    /// Friction between soil and plate.
    Interface,
    /// The soil's surface.
    Surface(SurfaceSite),
    /// What is read.
    Sensor(SensorSite),
    /// Between the motors and the plate.
    Drive(DriveSite),
    /// The force model, not the experiment.
    Model,
}

/// What of the soil is different.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SoilSite {
    /// The force at which it fails.
    Strength,
    /// The way over which its friction is mobilised, and with it the force at failure.
    Mobilisation,
    /// Its density about the plate, and with it its friction angle.
    Loosening,
}

/// What of the surface is different.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfaceSite {
    /// Its height, and so the depth of the plate.
    Height,
    /// Its slope.
    Slope,
    /// A load on it.
    Load,
}

/// Which reading is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SensorSite {
    /// Zero of the force sensor.
    ForceZero,
    /// The same, from the first stroke to the last.
    ForceZeroDrift,
    /// Gain of the force sensor.
    ForceGain,
    /// Force along the plate, by a part of that across it.
    Crosstalk,
    /// Angle of the plate.
    ToolAngle,
    /// Step of the external encoders.
    EncoderStep,
}

/// What of the drives is different.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DriveSite {
    /// Stretch under load.
    Stretch,
    /// Free play between motor and joint.
    FreePlay,
    /// Friction between motor and joint.
    Friction,
}

impl Site {
    /// Whether the failure force that is read depends on it; what does not shows in other channels only.
    #[must_use]
    pub const fn acts_on_force(self) -> bool {
        match self {
            Self::Soil(SoilSite::Strength | SoilSite::Mobilisation | SoilSite::Loosening)
            | Self::Interface
            | Self::Surface(SurfaceSite::Height | SurfaceSite::Slope | SurfaceSite::Load)
            | Self::Sensor(
                SensorSite::ForceZero
                | SensorSite::ForceZeroDrift
                | SensorSite::ForceGain
                | SensorSite::Crosstalk
                | SensorSite::ToolAngle,
            )
            | Self::Model => true,
            Self::Sensor(SensorSite::EncoderStep)
            | Self::Drive(DriveSite::Stretch | DriveSite::FreePlay | DriveSite::Friction) => false,
        }
    }

    /// Whether what a stroke shows of it depends on what controller and drives make of it, so that a formula for the force alone says
    /// little of an arm's logs.
    #[must_use]
    pub const fn passes_the_controller(self) -> bool {
        match self {
            Self::Interface
            | Self::Soil(SoilSite::Mobilisation)
            | Self::Sensor(
                SensorSite::ForceZero
                | SensorSite::ForceZeroDrift
                | SensorSite::ForceGain
                | SensorSite::Crosstalk
                | SensorSite::ToolAngle,
            )
            | Self::Drive(DriveSite::Stretch | DriveSite::FreePlay | DriveSite::Friction) => true,
            Self::Soil(SoilSite::Strength | SoilSite::Loosening)
            | Self::Surface(SurfaceSite::Height | SurfaceSite::Slope | SurfaceSite::Load)
            | Self::Sensor(SensorSite::EncoderStep)
            | Self::Model => false,
        }
    }

    /// Name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Soil(_) => "soil",
            Self::Interface => "interface",
            Self::Surface(_) => "surface",
            Self::Sensor(_) => "sensor",
            Self::Drive(_) => "drive",
            Self::Model => "model",
        }
    }
}
