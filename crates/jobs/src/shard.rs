use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::JobsError;

/// A share of work that several processes do (Slurm arrays, GNU parallel): every N-th piece, starting with the I-th.
///
/// In text, and in JSON, it is `I/N`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Shard {
    /// 1 to `of`.
    number: usize,
    of: usize,
}

impl Shard {
    /// Whether the piece at a place, from 0, is one of these.
    #[must_use]
    pub const fn has(self, place: usize) -> bool {
        place % self.of == self.number - 1
    }

    /// As a part of a file's name, such as `2_of_4`.
    #[must_use]
    pub fn named(self) -> String {
        format!("{}_of_{}", self.number, self.of)
    }
}

impl FromStr for Shard {
    type Err = JobsError;

    fn from_str(text: &str) -> Result<Self, JobsError> {
        let parsed = text.split_once('/').and_then(|(number, of)| {
            let (number, of) = (number.trim().parse().ok()?, of.trim().parse().ok()?);
            (1 <= number && number <= of).then_some(Self { number, of })
        });
        parsed.ok_or(JobsError::Shard)
    }
}

impl TryFrom<String> for Shard {
    type Error = JobsError;

    fn try_from(text: String) -> Result<Self, JobsError> {
        text.parse()
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> Self {
        shard.to_string()
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::Shard;

    #[test]
    fn each_piece_is_in_one_shard() {
        for place in 0..20 {
            let shards = ["1/3", "2/3", "3/3"].map(|text| text.parse::<Shard>().unwrap());
            assert_eq!(shards.iter().filter(|shard| shard.has(place)).count(), 1);
        }
    }

    #[test]
    fn what_is_no_shard_is_refused() {
        for text in ["", "1", "0/2", "3/2", "1/0", "a/b", "-1/2"] {
            assert!(text.parse::<Shard>().unwrap_err().to_string().contains("I/N"), "{text}");
        }
    }
}
