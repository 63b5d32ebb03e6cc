//! What all answers have in common.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;
use serde_json::{Value, json};

use crate::{AppError, finite};

/// How a use case that gave an answer ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Done.
    Done,
    /// Done, and the answer is negative.
    Negative,
    /// Done in part: the budget or the user ended it before the goal, or data were left out.
    Partial,
}

impl Outcome {
    /// The exit code of the command line, also the key `exit_code` in Python: 0 done, 1 negative, 3 in part.
    #[must_use]
    pub const fn exit_code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Negative => 1,
            Self::Partial => 3,
        }
    }
}

/// The answer of a use case: plain data without NaN or infinities.
pub trait Answer: Serialize + JsonSchema {
    /// Id of its schema, `soilctl.<verb>/1`.
    const SCHEMA: &'static str;

    /// How the use case ended.
    fn outcome(&self) -> Outcome {
        Outcome::Done
    }
}

/// An answer with what every JSON document starts with.
#[derive(Serialize, JsonSchema)]
struct Document<'a, A> {
    /// Id of this schema.
    schema: &'a str,
    /// Version of the program.
    version: &'a str,
    #[serde(flatten)]
    answer: &'a A,
}

/// An answer as its JSON document, ended by a line feed.
///
/// # Errors
/// [`AppError::NotFinite`] if a number in it is NaN or infinite.
pub fn document<A: Answer>(answer: &A) -> Result<String, AppError> {
    finite::check(answer)?;
    let document = Document { schema: A::SCHEMA, version: env!("CARGO_PKG_VERSION"), answer };
    Ok(serde_json::to_string_pretty(&document)? + "\n")
}

/// The JSON schema of the document of an answer.
///
/// # Errors
/// [`AppError::Json`] if the schema cannot be put into JSON.
pub fn schema<A: Answer + 'static>() -> Result<Value, AppError> {
    let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let mut schema = serde_json::to_value(generator.into_root_schema_for::<Document<'static, A>>())?;
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("title".into(), Value::from(A::SCHEMA));
    }
    if let Some(id) = schema.pointer_mut("/properties/schema") {
        *id = json!({"description": "Id of this schema.", "const": A::SCHEMA});
    }
    Ok(schema)
}
