//! Where a table comes from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a table comes from.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Source {
    /// A table file (.csv or .parquet, with its .json beside it) or a built-in table: appendix-c-coulomb,
    /// appendix-c-log-spiral, appendix-c-chen, appendix-c-caquot, appendix-c-num-ub, appendix-c-num-lb,
    /// plate-bounds
    #[arg(value_name = "FILE|NAME")]
    pub table: String,
}
