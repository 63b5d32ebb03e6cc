//! Bags of ROS 2 in SQLite. Files may be damaged or made to do harm: they are opened to be read only, nothing in them is trusted, and
//! what may be read of them is bounded by their size.

mod open;
mod rows;
mod topics;

use std::path::Path;

use soilctl_session::read::{Ending, Item};

use crate::BagError;
use crate::scan::{Halt, Visit};

/// Shows what the database in `file` holds; `path` is named in messages.
pub(crate) fn show(file: &Path, path: &Path, visit: &mut Visit<'_>) -> Result<Ending, Halt> {
    let mut ending = Ending::default();
    let database = open::open(file, path, &mut ending.damage)?;
    ending.bytes = database.bytes;
    let tables = topics::tables(&database.connection)
        .map_err(|error| BagError::not_a_recording(path, format!("its tables cannot be read: {error}")))?;
    if let Some(missing) = ["topics", "messages"].into_iter().find(|name| !tables.contains(*name)) {
        let reason = format!("it is a database of SQLite without a table `{missing}`");
        return Err(BagError::not_a_recording(path, reason).into());
    }
    visit(Item::Header { profile: "ros2", library: "" })?;
    let channels = topics::channels(&database, tables.contains("message_definitions"), &mut ending.damage);
    rows::show(&database, &channels, &mut ending.damage, visit)?;
    Ok(ending)
}
