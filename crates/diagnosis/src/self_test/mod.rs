//! A test of the diagnosis on campaigns whose effects it has not seen.

mod campaign;
mod cause;
mod design;
mod hidden;
mod random;
mod run;
mod tally;
mod traces;

pub use campaign::HiddenCampaign;
pub use cause::{Cause, Outside};
pub use design::Design;
pub use hidden::{Hidden, hidden_size};
pub use random::Random;
pub use run::{Case, Kind, Outcome, SelfTest, cases, run_case};
pub use tally::{Rate, Tally, tally};
