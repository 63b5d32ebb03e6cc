use serde::{Deserialize, Serialize};

use super::Trajectory;

/// Places in the ring.
pub const RING_SIZE: usize = 16;

/// Trajectories that are still to come, first in first out, in fixed memory.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Ring {
    places: [Option<Trajectory>; RING_SIZE],
    next: u8,
    length: u8,
}

impl Ring {
    /// How many are to come.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.length as usize
    }

    /// Whether none is to come.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Appends one; says whether there was room.
    pub fn push(&mut self, trajectory: Trajectory) -> bool {
        if self.len() >= RING_SIZE {
            return false;
        }
        let place = (usize::from(self.next) + self.len()) % RING_SIZE;
        self.places[place] = Some(trajectory);
        self.length += 1;
        true
    }

    /// Takes the next one.
    pub fn pop(&mut self) -> Option<Trajectory> {
        if self.is_empty() {
            return None;
        }
        let place = usize::from(self.next) % RING_SIZE;
        self.next = ((place + 1) % RING_SIZE) as u8;
        self.length -= 1;
        self.places[place].take()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        *self = Self::default();
    }
}
