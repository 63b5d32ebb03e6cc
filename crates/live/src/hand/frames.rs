use soilctl_controller::HandTarget;

use crate::frame::{FRAME_VERSION, FrameError, Reader, Writer};

/// Length of a frame of a hand in bytes.
pub const HAND_BYTES: usize = 48;
/// Length of a frame of what the hand touches in bytes.
pub const TOUCH_BYTES: usize = 80;
/// The hand of a device, in commands and logs.
pub const DEVICE_HAND: u32 = u32::MAX;

const HAND_MAGIC: [u8; 4] = *b"SCHD";
const TOUCH_MAGIC: [u8; 4] = *b"SCTO";
/// Bit of a hand frame's flags.
const LEADS: u32 = 1;

/// Where a device's hand is: 48 bytes, to the session.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HandFrame {
    /// Number that comes back, once the frame has been taken in.
    pub number: u32,
    /// Where the hand is, if it holds the plate; none: it let go.
    pub target: Option<HandTarget>,
}

/// What a device's hand touches, after a tick: 80 bytes, from the session.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TouchFrame {
    /// The tick.
    pub tick: u64,
    /// How things are.
    pub flags: HandFlags,
    /// Number of the last hand frame that was taken in.
    pub number: u32,
    /// Middle of the plate's lower edge in m, base frame; zero before homing.
    pub place_m: [f64; 3],
    /// Its tool angle in rad.
    pub tool_angle_rad: f64,
    /// Force of the soil on the plate in N, base frame.
    pub force_n: [f64; 3],
}

/// The flags of a [`TouchFrame`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(clippy::struct_excessive_bools, reason = "bits of a frame")]
pub struct HandFlags {
    /// Bit 0: the arm is driven and homed.
    pub ready: bool,
    /// Bit 1: this hand leads the plate.
    pub leads: bool,
    /// Bit 2: the arm does not reach, or may not go, where the hand is.
    pub reach: bool,
    /// Bit 3: the soil pushes back as hard as is allowed.
    pub force: bool,
    /// Bit 4: a motor or joint turns as hard as is allowed.
    pub torque: bool,
    /// Bit 5: the last hand frame was refused: the arm is not ready, another hand leads, something else is to be done, or it held what is no
    /// number.
    pub refused: bool,
}

impl HandFlags {
    const fn list(self) -> [bool; 6] {
        [self.ready, self.leads, self.reach, self.force, self.torque, self.refused]
    }

    fn bits(self) -> u32 {
        self.list().into_iter().enumerate().fold(0, |bits, (place, on)| bits | (u32::from(on) << place))
    }

    fn of(bits: u32) -> Self {
        let on = |place: u32| bits & (1 << place) != 0;
        Self { ready: on(0), leads: on(1), reach: on(2), force: on(3), torque: on(4), refused: on(5) }
    }
}

impl HandFrame {
    /// The bytes of the frame.
    #[must_use]
    pub fn encode(&self) -> [u8; HAND_BYTES] {
        let mut bytes = [0; HAND_BYTES];
        let mut writer = Writer::new(&mut bytes);
        writer.put(&HAND_MAGIC);
        writer.put(&FRAME_VERSION.to_le_bytes());
        writer.put(&[0; 2]);
        writer.put(&if self.target.is_some() { LEADS } else { 0 }.to_le_bytes());
        writer.put(&self.number.to_le_bytes());
        let target = self.target.unwrap_or_default();
        writer.floats(&[target.x_m, target.y_m, target.z_m, target.tool_angle_rad]);
        bytes
    }

    /// The frame in these bytes. Numbers that are not finite are kept: the controller refuses them.
    ///
    /// # Errors
    /// [`FrameError`] for another beginning or version.
    pub fn decode(bytes: &[u8; HAND_BYTES]) -> Result<Self, FrameError> {
        let mut reader = Reader::new(bytes);
        reader.head(HAND_MAGIC)?;
        let flags = u32::from_le_bytes(reader.take());
        let number = u32::from_le_bytes(reader.take());
        let [x_m, y_m, z_m, tool_angle_rad] = reader.floats();
        let target = (flags & LEADS != 0).then_some(HandTarget { x_m, y_m, z_m, tool_angle_rad });
        Ok(Self { number, target })
    }
}

impl TouchFrame {
    /// The bytes of the frame.
    #[must_use]
    pub fn encode(&self) -> [u8; TOUCH_BYTES] {
        let mut bytes = [0; TOUCH_BYTES];
        let mut writer = Writer::new(&mut bytes);
        writer.put(&TOUCH_MAGIC);
        writer.put(&FRAME_VERSION.to_le_bytes());
        writer.put(&[0; 2]);
        writer.put(&self.tick.to_le_bytes());
        writer.put(&self.flags.bits().to_le_bytes());
        writer.put(&self.number.to_le_bytes());
        writer.floats(&self.place_m);
        writer.floats(&[self.tool_angle_rad]);
        writer.floats(&self.force_n);
        bytes
    }

    /// The frame in these bytes.
    ///
    /// # Errors
    /// [`FrameError`] for another beginning or version.
    pub fn decode(bytes: &[u8; TOUCH_BYTES]) -> Result<Self, FrameError> {
        let mut reader = Reader::new(bytes);
        reader.head(TOUCH_MAGIC)?;
        let tick = u64::from_le_bytes(reader.take());
        let flags = HandFlags::of(u32::from_le_bytes(reader.take()));
        let number = u32::from_le_bytes(reader.take());
        let place_m = reader.floats();
        let [tool_angle_rad] = reader.floats();
        Ok(Self { tick, flags, number, place_m, tool_angle_rad, force_n: reader.floats() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The layout that the reference promises.
    #[test]
    fn numbers_are_where_the_reference_says() {
        let target = HandTarget { x_m: 1.0, y_m: 2.0, z_m: 3.0, tool_angle_rad: 4.0 };
        let bytes = HandFrame { number: 9, target: Some(target) }.encode();
        assert_eq!(&bytes[..16], b"SCHD\x01\0\0\0\x01\0\0\0\x09\0\0\0");
        assert_eq!(bytes[40..], 4.0_f64.to_le_bytes());
        let flags = HandFlags { leads: true, refused: true, ..HandFlags::default() };
        let touch =
            TouchFrame { tick: 7, flags, number: 9, force_n: [0.0, 0.0, 5.0], ..TouchFrame::default() };
        let bytes = touch.encode();
        assert_eq!(&bytes[..24], b"SCTO\x01\0\0\0\x07\0\0\0\0\0\0\0\x22\0\0\0\x09\0\0\0");
        assert_eq!(bytes[72..], 5.0_f64.to_le_bytes());
        assert_eq!(TouchFrame::decode(&bytes), Ok(touch));
    }

    #[test]
    fn frames_come_back_and_others_are_refused() {
        for target in
            [None, Some(HandTarget { x_m: -0.0, y_m: 1e300, z_m: f64::INFINITY, tool_angle_rad: 1.5 })]
        {
            let frame = HandFrame { number: 5, target };
            assert_eq!(HandFrame::decode(&frame.encode()), Ok(frame));
        }
        let mut bytes = HandFrame::default().encode();
        bytes[4] = 2;
        assert_eq!(HandFrame::decode(&bytes), Err(FrameError::Version(2)));
        bytes[0] = b'X';
        assert_eq!(HandFrame::decode(&bytes), Err(FrameError::Magic(*b"XCHD")));
    }
}
