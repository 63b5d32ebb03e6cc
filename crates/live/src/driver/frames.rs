use soilctl_controller::Sensed;
use soilctl_kinematics::MotorTorques;
use soilctl_plant::Drive;

use crate::frame::{FRAME_VERSION, FrameError, Reader, Writer};

/// Version of the frames.
pub const DRIVER_VERSION: u16 = FRAME_VERSION;
/// Length of a drive frame in bytes.
pub const DRIVE_BYTES: usize = 64;
/// Length of a frame of readings in bytes.
pub const READINGS_BYTES: usize = 208;

const DRIVE_MAGIC: [u8; 4] = *b"SCDR";
const READINGS_MAGIC: [u8; 4] = *b"SCRE";

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
        let mut writer = Writer::new(&mut bytes);
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
        let mut reader = Reader::new(bytes);
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
        let mut writer = Writer::new(&mut bytes);
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
        let mut reader = Reader::new(bytes);
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
