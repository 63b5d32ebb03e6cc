use soilctl_columns::Cell;

use crate::fields::cells;
use crate::messages::{ControllerStep, JointState, SoilTruth, WrenchStamped};
use crate::{cdr, topics};

/// One message as cells with their names.
///
/// # Errors
/// In words, if it is not a message of the topic's type.
pub(super) fn row(
    topic: &str,
    log_time_ns: u64,
    data: &[u8],
) -> Result<Vec<(String, Cell<'static>)>, String> {
    #[allow(clippy::cast_precision_loss, reason = "a hundredth of a tick after 285 years")]
    let time = Cell::Float(log_time_ns as f64 / 1e9);
    let mut row = vec![("time_s".to_owned(), time)];
    match topic {
        topics::STEP => row.extend(cells(&cdr::decode::<ControllerStep>(data)?)),
        topics::TRUE_SOIL => row.extend(cells(&cdr::decode::<SoilTruth>(data)?)),
        topics::WRENCH => row.extend(cells(&cdr::decode::<WrenchStamped>(data)?.wrench)),
        _ => joint_state(&cdr::decode(data)?, &mut row),
    }
    Ok(row)
}

/// Position, velocity and effort of each joint under its name; what a message leaves out is not a number.
fn joint_state(message: &JointState, row: &mut Vec<(String, Cell<'static>)>) {
    let parts =
        [("position", &message.position), ("velocity", &message.velocity), ("effort", &message.effort)];
    for (i, name) in message.name.iter().enumerate() {
        for (part, values) in parts {
            let value = values.get(i).copied().unwrap_or(f64::NAN);
            row.push((format!("{name}_{part}"), Cell::Float(value)));
        }
    }
}
