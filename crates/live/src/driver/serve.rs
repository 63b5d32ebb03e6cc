use std::io::{ErrorKind, Read, Write};
use std::path::Path;

use soilctl_kinematics::MotorTorques;
use soilctl_plant::{Drive, Hardware};
use thiserror::Error;

use super::frames::{DRIVE_BYTES, DriveFrame, ReadingsFrame};
use crate::LiveError;
use crate::frame::FrameError;
use crate::local::{Listener, bind};

/// The driver's side: puts any [`Hardware`] behind a socket.
#[derive(Debug)]
pub struct DriverServer {
    listener: Listener,
}

/// Why a driver stopped.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ServeError<E: std::error::Error + 'static> {
    /// The socket.
    #[error("the session cannot be reached: {0}; start it again")]
    Socket(#[from] std::io::Error),
    /// A frame.
    #[error("the session {0}; use programs of one version")]
    Frame(#[from] FrameError),
    /// The hardware.
    #[error(transparent)]
    Hardware(E),
}

impl DriverServer {
    /// Listens at `path`; a socket that nobody listens at any more is replaced.
    ///
    /// # Errors
    /// [`LiveError::Taken`] or [`LiveError::Socket`].
    pub fn bind(path: &Path) -> Result<Self, LiveError> {
        Ok(Self { listener: bind(path)? })
    }

    /// Serves one session to its end; returns how many ticks it had. Whatever ends it, the last thing that the hardware is
    /// told is that the amplifiers are off.
    ///
    /// # Errors
    /// [`ServeError`].
    pub fn serve<H>(&mut self, hardware: &mut H) -> Result<u64, ServeError<H::Error>>
    where
        H: Hardware<Error: std::error::Error + 'static>,
    {
        let mut stream = self.listener.accept()?;
        let mut ticks = 0;
        let mut bytes = [0; DRIVE_BYTES];
        let done = loop {
            match stream.read_exact(&mut bytes) {
                Ok(()) => {}
                Err(error) if error.kind() == ErrorKind::UnexpectedEof => break Ok(()),
                Err(error) => break Err(error.into()),
            }
            let frame = match DriveFrame::decode(&bytes) {
                Ok(frame) => frame,
                Err(error) => break Err(error.into()),
            };
            let mut sensed = match hardware.exchange(&frame.drive) {
                Ok(sensed) => sensed,
                Err(error) => break Err(ServeError::Hardware(error)),
            };
            sensed.tick = frame.tick;
            if let Err(error) = stream.write_all(&ReadingsFrame { sensed }.encode()) {
                break Err(error.into());
            }
            ticks += 1;
        };
        let off = Drive { motor_torques: MotorTorques::default(), amplifiers_enabled: false };
        let last = hardware.exchange(&off).map(|_| ()).map_err(ServeError::Hardware);
        done.and(last)?;
        Ok(ticks)
    }
}
