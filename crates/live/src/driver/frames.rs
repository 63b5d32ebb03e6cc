use soilctl_controller::Sensed;
use soilctl_kinematics::MotorTorques;
use soilctl_plant::Drive;
use thiserror::Error;

/// Version of the frames.
pub const DRIVER_VERSION: u16 = 1;
/// Length of a drive frame in bytes.
pub const DRIVE_BYTES: usize = 64;
/// Length of a frame of readings in bytes.
pub const READINGS_BYTES: usize = 208;

const DRIVE_MAGIC: [u8; 4] = *b"SCDR";
const READINGS_MAGIC: [u8; 4] = *b"SCRE";

/// What is wrong with a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FrameError {
    /// It does not begin as a frame should.
    #[error(
        "sent a frame that begins with {0:02x?}, not with its four letters; frames are little endian and without gaps"
    )]
    Magic([u8; 4]),
    /// It is of another version.
    #[error("speaks version {0} of the frames, not {DRIVER_VERSION}")]
    Version(u16),
}

/// What the motors shall do in a tick: 64 bytes, to the driver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveFrame {
    /// Number of the tick, rising by one.
    pub tick: u64,
    /// The torques, and whether the amplifiers shall be on.
    pub drive: Drive,
}

/// What the sensors say in a tick: 208 bytes, from the driver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadingsFrame {
    /// The readings; their tick is that of the drive frame that they answer.
    pub sensed: Sensed,
}

impl DriveFrame {
    /// The bytes of the frame.
    #[must_use]
    pub fn encode(&self) -> [u8; DRIVE_BYTES] {
        let mut bytes = [0; DRIVE_BYTES];
        let mut writer = Writer { bytes: &mut bytes, at: 0 };
        writer.put(&DRIVE_MAGIC);
        writer.put(&DRIVER_VERSION.to_le_bytes());
        writer.put(&[0; 2]);
        writer.put(&self.tick.to_le_bytes());
        writer.put(&u32::from(self.drive.amplifiers_enabled).to_le_bytes());
        writer.put(&[0; 4]);
        writer.floats(&self.drive.motor_torques.0);
        bytes
    }

    /// The frame in these bytes.
    ///
    /// # Errors
    /// [`FrameError`] for another beginning or version.
    pub fn decode(bytes: &[u8; DRIVE_BYTES]) -> Result<Self, FrameError> {
        let mut reader = Reader { bytes, at: 0 };
        reader.head(DRIVE_MAGIC)?;
        let tick = u64::from_le_bytes(reader.take());
        let flags = u32::from_le_bytes(reader.take());
        let _: [u8; 4] = reader.take();
        let motor_torques = MotorTorques(reader.floats());
        Ok(Self { tick, drive: Drive { motor_torques, amplifiers_enabled: flags & 1 != 0 } })
    }
}

impl ReadingsFrame {
    /// The bytes of the frame.
    #[must_use]
    pub fn encode(&self) -> [u8; READINGS_BYTES] {
        let sensed = &self.sensed;
        let mut bytes = [0; READINGS_BYTES];
        let mut writer = Writer { bytes: &mut bytes, at: 0 };
        writer.put(&READINGS_MAGIC);
        writer.put(&DRIVER_VERSION.to_le_bytes());
        writer.put(&[0; 2]);
        writer.put(&sensed.tick.to_le_bytes());
        writer.put(&u32::from(sensed.wrench_overload).to_le_bytes());
        let sequences = [
            sensed.motor_sequence,
            sensed.external_sequence,
            sensed.wrench_sequence,
            sensed.amplifier_sequence,
        ];
        sequences.iter().for_each(|sequence| writer.put(&sequence.to_le_bytes()));
        sensed.motor_counts.iter().for_each(|count| writer.put(&count.to_le_bytes()));
        sensed.external_counts.iter().for_each(|count| writer.put(&count.to_le_bytes()));
        writer.put(&[0; 4]);
        writer.floats(&sensed.wrench);
        writer.floats(&sensed.amplifier_current_a);
        writer.floats(&sensed.amplifier_voltage_v);
        bytes
    }

    /// The frame in these bytes. Numbers that are not finite are kept: the controller judges them.
    ///
    /// # Errors
    /// [`FrameError`] for another beginning or version.
    pub fn decode(bytes: &[u8; READINGS_BYTES]) -> Result<Self, FrameError> {
        let mut reader = Reader { bytes, at: 0 };
        reader.head(READINGS_MAGIC)?;
        let tick = u64::from_le_bytes(reader.take());
        let flags = u32::from_le_bytes(reader.take());
        let [motor_sequence, external_sequence, wrench_sequence, amplifier_sequence] =
            std::array::from_fn(|_| u32::from_le_bytes(reader.take()));
        let motor_counts = std::array::from_fn(|_| i32::from_le_bytes(reader.take()));
        let external_counts = std::array::from_fn(|_| i32::from_le_bytes(reader.take()));
        let _: [u8; 4] = reader.take();
        Ok(Self {
            sensed: Sensed {
                tick,
                motor_counts,
                motor_sequence,
                external_counts,
                external_sequence,
                wrench: reader.floats(),
                wrench_sequence,
                wrench_overload: flags & 1 != 0,
                amplifier_current_a: reader.floats(),
                amplifier_voltage_v: reader.floats(),
                amplifier_sequence,
            },
        })
    }
}

struct Writer<'a> {
    bytes: &'a mut [u8],
    at: usize,
}

impl Writer<'_> {
    fn put(&mut self, part: &[u8]) {
        if let Some(place) = self.bytes.get_mut(self.at..self.at + part.len()) {
            place.copy_from_slice(part);
        }
        self.at += part.len();
    }

    fn floats(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.put(&number.to_le_bytes()));
    }
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let part = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        self.at += N;
        part.copied().unwrap_or([0; N])
    }

    fn floats<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| f64::from_le_bytes(self.take()))
    }

    fn head(&mut self, magic: [u8; 4]) -> Result<(), FrameError> {
        let found = self.take();
        if found != magic {
            return Err(FrameError::Magic(found));
        }
        let version = u16::from_le_bytes(self.take());
        if version != DRIVER_VERSION {
            return Err(FrameError::Version(version));
        }
        let _: [u8; 2] = self.take();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Whatever the bits behind the head, a frame is what its bytes are.
        #[test]
        fn frames_keep_every_bit(
            tail in prop::collection::vec(any::<u8>(), READINGS_BYTES - 8),
            on in any::<bool>(), tick in any::<u64>(), bits in prop::array::uniform5(any::<u64>()),
        ) {
            let mut bytes = [0; READINGS_BYTES];
            bytes[..4].copy_from_slice(b"SCRE");
            bytes[4] = 1;
            bytes[8..].copy_from_slice(&tail);
            // One flag, and a gap.
            bytes[16..20].copy_from_slice(&u32::from(on).to_le_bytes());
            bytes[76..80].copy_from_slice(&[0; 4]);
            prop_assert_eq!(ReadingsFrame::decode(&bytes).unwrap().encode(), bytes);

            let drive = Drive { motor_torques: MotorTorques(bits.map(f64::from_bits)), amplifiers_enabled: on };
            let bytes = DriveFrame { tick, drive }.encode();
            let back = DriveFrame::decode(&bytes).unwrap();
            prop_assert_eq!((back.tick, back.drive.amplifiers_enabled), (tick, on));
            prop_assert_eq!(back.encode(), bytes);
        }
    }

    /// The layout that the reference promises.
    #[test]
    fn numbers_are_where_the_reference_says() {
        let drive =
            Drive { motor_torques: MotorTorques([1.0, 2.0, 3.0, 4.0, 5.0]), amplifiers_enabled: true };
        let bytes = DriveFrame { tick: 7, drive }.encode();
        assert_eq!(&bytes[..24], b"SCDR\x01\0\0\0\x07\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0");
        assert_eq!(bytes[56..], 5.0_f64.to_le_bytes());
        let sensed = Sensed { tick: 7, external_counts: [0, 0, 0, 0, -2], ..Sensed::default() };
        let sensed = Sensed { amplifier_voltage_v: [0.0, 0.0, 0.0, 0.0, 48.0], motor_sequence: 9, ..sensed };
        let bytes = ReadingsFrame { sensed }.encode();
        assert_eq!(bytes[20..24], 9_u32.to_le_bytes());
        assert_eq!(bytes[72..76], (-2_i32).to_le_bytes());
        assert_eq!(bytes[200..], 48.0_f64.to_le_bytes());
    }

    #[test]
    fn other_frames_are_refused() {
        let mut bytes = ReadingsFrame { sensed: Sensed::default() }.encode();
        bytes[4] = 2;
        assert_eq!(ReadingsFrame::decode(&bytes), Err(FrameError::Version(2)));
        bytes[0] = b'X';
        assert_eq!(ReadingsFrame::decode(&bytes), Err(FrameError::Magic(*b"XCRE")));
    }
}
