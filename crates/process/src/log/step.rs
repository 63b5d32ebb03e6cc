use super::cdr::Cursor;

/// What is needed of a `soilctl_msgs/msg/ControllerStep`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step<'a> {
    pub(super) tick: u64,
    /// Force and moment in `ft_sensor`, bias included.
    pub(super) wrench: [f64; 6],
    pub(super) motor_joints: [f64; 5],
    pub(super) external_joints: [f64; 5],
    /// Joint torques before the transmission in N m.
    pub(super) joint_torques: [f64; 5],
    /// Kind of the active trajectory, for example `stroke`.
    pub(super) trajectory: &'a str,
    /// The innermost sequence, empty if none runs.
    pub(super) sequence: &'a str,
    pub(super) sequence_step: u8,
    /// Walls that this step found, by number and place in m.
    pub(super) wall: Option<(u16, f64)>,
}

impl<'a> Step<'a> {
    /// In the order of `crates/session/msg/ControllerStep.msg`; `None` if the message is another.
    pub(super) fn read(message: &'a [u8]) -> Option<Self> {
        let mut c = Cursor::new(message)?;
        c.u64()?;
        let tick = c.u64()?;
        c.u64()?;
        c.skip_u32s(12)?; // counts and sequence numbers of motor and external encoders
        let wrench = c.f64s()?;
        c.u32()?;
        c.u8()?;
        c.skip_f64s(10)?; // currents and voltages
        c.skip_u32s(2)?;
        c.u8()?;
        c.text()?; // request
        let _ = c.list()?;
        c.text()?; // mode
        c.u8()?;
        c.skip_f64s(10)?; // torques and currents of the motors
        c.u8()?;
        c.u32()?;
        let mut wall = None;
        for _ in 0..c.u32()? {
            let kind = c.text()?;
            let (index, value) = (c.u16()?, c.f64()?);
            c.f64()?;
            if kind == "wall_found" {
                wall = Some((index, value));
            }
        }
        c.u32()?;
        let motor_joints = c.f64s()?;
        let external_joints = c.f64s()?;
        c.skip_f64s(21)?; // rates, pose, force, desired joints and position
        let joint_torques = c.f64s()?;
        c.skip_f64s(5)?;
        let trajectory = c.text()?;
        let sequence = c.text()?;
        let sequence_step = c.u8()?;
        c.is_done().then_some(Self {
            tick,
            wrench,
            motor_joints,
            external_joints,
            joint_torques,
            trajectory,
            sequence,
            sequence_step,
            wall,
        })
    }
}
