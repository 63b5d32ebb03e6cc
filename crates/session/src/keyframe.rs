use soilctl_controller::{STATE_VERSION, State};

use crate::SessionError;
use crate::messages::Keyframe;

/// Version of key frames: the message and the encoding of the state.
pub const KEYFRAME_VERSION: u32 = 1;

impl Keyframe {
    /// The key frame `number` before the step `step`.
    ///
    /// # Errors
    /// [`SessionError::Keyframe`] if the state cannot be encoded.
    pub fn new(number: u32, step: u64, state: &State) -> Result<Self, SessionError> {
        let state = postcard::to_stdvec(state).map_err(SessionError::Keyframe)?;
        Ok(Self { version: KEYFRAME_VERSION, number, step, state })
    }

    /// The state, bit for bit.
    ///
    /// # Errors
    /// [`SessionError::Version`] if this program cannot read it, [`SessionError::Keyframe`] if it is damaged.
    pub fn state(&self) -> Result<State, SessionError> {
        let wrong = |what, found: u32, known| SessionError::Version { what, found: found.to_string(), known };
        if self.version != KEYFRAME_VERSION {
            return Err(wrong("a key frame", self.version, KEYFRAME_VERSION));
        }
        let (state, rest): (State, &[u8]) =
            postcard::take_from_bytes(&self.state).map_err(SessionError::Keyframe)?;
        if state.version != STATE_VERSION {
            return Err(wrong("the state of a key frame", state.version, STATE_VERSION));
        }
        if !rest.is_empty() {
            return Err(SessionError::Keyframe(postcard::Error::DeserializeBadEncoding));
        }
        Ok(state)
    }
}
