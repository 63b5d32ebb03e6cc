//! What all requests have in common. A request is declared once, as a struct whose fields carry their help, range and default;
//! from it follow the options of the command line (clap), the JSON schema (schemars) and the signature in Python.

use std::collections::BTreeMap;
use std::str::FromStr;

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};
use soilctl_earth_pressure::{EarthPressureError, ForceModel, Loads as SoilLoads, MODEL_IDS};
use soilctl_estimator::MAX_SLOPE_DEG;
use soilctl_soil::STANDARD_GRAVITY_M_S2;

use crate::AppError;

/// A request of a use case. Its `Default` holds the defaults of all faces; required values have a stand-in there.
pub trait Request: Serialize + DeserializeOwned + JsonSchema + clap::Args + Default {}

impl<R: Serialize + DeserializeOwned + JsonSchema + clap::Args + Default> Request for R {}

/// The JSON schema of a request, with defaults, ranges, what is required, which texts are paths, and in `propertyOrder` the order in
/// which its fields are declared.
///
/// # Errors
/// [`AppError::Json`] if the schema cannot be put into JSON.
pub fn schema<R: Request>() -> Result<Value, AppError> {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut schema = serde_json::to_value(generator.into_root_schema_for::<R>())?;
    let required: Vec<String> = required::<R>();
    let mut order = Vec::new();
    for argument in R::augment_args(clap::Command::new("request")).get_arguments() {
        let key = argument.get_id().as_str();
        order.push(key.to_owned());
        let property = schema.get_mut("properties").and_then(|properties| properties.get_mut(key));
        let Some(property) = property.and_then(Value::as_object_mut) else { continue };
        if argument.is_required_set() {
            property.remove("default");
        }
        if argument.get_value_hint() == clap::ValueHint::AnyPath {
            property.insert("format".into(), "path".into());
        }
    }
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("required".into(), required.into());
        keys.insert("propertyOrder".into(), order.into());
        keys.insert("additionalProperties".into(), false.into());
    }
    Ok(schema)
}

/// Fields without which the command line refuses.
fn required<R: Request>() -> Vec<String> {
    let command = R::augment_args(clap::Command::new("request"));
    let required = command.get_arguments().filter(|argument| argument.is_required_set());
    required.map(|argument| argument.get_id().to_string()).collect()
}

/// A request from a JSON object of its fields; those that are left out have their defaults.
///
/// # Errors
/// [`AppError::Request`] for an unknown or missing key, or two that exclude each other, [`AppError::Json`] for a value of
/// another type, [`AppError::OutOfRange`] for one outside its range.
pub fn from_json<R: Request>(text: &str) -> Result<R, AppError> {
    let given: Map<String, Value> = serde_json::from_str(text)?;
    let schema = schema::<R>()?;
    let known = properties(&schema);
    if let Some(key) = given.keys().find(|key| !known.contains_key(key.as_str())) {
        let names: Vec<&str> = known.keys().copied().collect();
        return Err(AppError::Request(format!("{key} is unknown; known are {}", names.join(", "))));
    }
    if let Some(key) = required::<R>().iter().find(|key| !given.contains_key(*key)) {
        return Err(AppError::Request(format!("{key} is missing")));
    }
    excluded::<R>(&given)?;
    // Before they are read, since a number outside the range of its type would be refused without a word about the range.
    in_range(&known, |key| given.get(key))?;
    let request: R = serde_json::from_value(Value::Object(given))?;
    check(&request)?;
    Ok(request)
}

/// Refuses values that exclude each other, as on the command line.
fn excluded<R: Request>(given: &Map<String, Value>) -> Result<(), AppError> {
    let command = R::augment_args(clap::Command::new("request"));
    let is_given = |id: &clap::Id| given.get(id.as_str()).is_some_and(|value| !value.is_null());
    for argument in command.get_arguments().filter(|argument| is_given(argument.get_id())) {
        let others = command.get_arg_conflicts_with(argument);
        if let Some(other) = others.iter().find(|other| is_given(other.get_id())) {
            let (one, other) = (argument.get_id(), other.get_id());
            return Err(AppError::Request(format!("{one} and {other} exclude each other; leave one out")));
        }
    }
    Ok(())
}

/// Checks every number of a request against the range that its field declares.
///
/// # Errors
/// [`AppError::OutOfRange`] for the first that is outside.
pub fn check<R: Request>(request: &R) -> Result<(), AppError> {
    let values = serde_json::to_value(request)?;
    in_range(&properties(&schema::<R>()?), |key| values.get(key))
}

fn in_range<'v>(
    properties: &BTreeMap<&str, &Value>,
    value_of: impl Fn(&str) -> Option<&'v Value>,
) -> Result<(), AppError> {
    for (&key, property) in properties {
        let Some(value) = value_of(key) else { continue };
        let limits = Limits::of(property);
        let numbers = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
        for number in numbers.iter().filter_map(Value::as_f64) {
            if !limits.allow(number) {
                let unit = unit(key);
                let (value, allowed) = (format!("{number}{unit}"), limits.in_words(unit));
                return Err(AppError::OutOfRange { key: key.to_owned(), value, allowed });
            }
        }
    }
    Ok(())
}

fn properties(schema: &Value) -> BTreeMap<&str, &Value> {
    let keys = schema["properties"].as_object().into_iter().flatten();
    keys.map(|(key, property)| (key.as_str(), property)).collect()
}

/// Unit at the end of a field's name.
fn unit(key: &str) -> &'static str {
    const UNITS: [(&str, &str); 9] = [
        ("_deg", " deg"),
        ("_kg_m3", " kg/m3"),
        ("_m_s2", " m/s2"),
        ("_pa", " Pa"),
        ("_n", " N"),
        ("_hz", " Hz"),
        ("_s", " s"),
        ("_m2", " m2"),
        ("_m", " m"),
    ];
    UNITS.iter().find(|(ending, _)| key.ends_with(ending)).map_or("", |(_, unit)| unit)
}

/// Ends of a range in a schema.
struct Limits {
    least: Option<f64>,
    above: Option<f64>,
    most: Option<f64>,
    below: Option<f64>,
}

impl Limits {
    /// Of a number, or of the items of an array.
    fn of(property: &Value) -> Self {
        let numbers = if property["items"].is_object() { &property["items"] } else { property };
        let of = |key: &str| numbers[key].as_f64();
        // The greatest number of the type is a limit as well.
        let most = of("maximum").or_else(|| (numbers["format"] == "uint32").then_some(f64::from(u32::MAX)));
        Self { least: of("minimum"), above: of("exclusiveMinimum"), most, below: of("exclusiveMaximum") }
    }

    fn allow(&self, number: f64) -> bool {
        self.least.is_none_or(|least| number >= least)
            && self.above.is_none_or(|above| number > above)
            && self.most.is_none_or(|most| number <= most)
            && self.below.is_none_or(|below| number < below)
    }

    fn in_words(&self, unit: &str) -> String {
        let ends = [
            self.least.map(|end| format!("at least {end}{unit}")),
            self.above.map(|end| format!("above {end}{unit}")),
            self.most.map(|end| format!("at most {end}{unit}")),
            self.below.map(|end| format!("below {end}{unit}")),
        ];
        ends.into_iter().flatten().collect::<Vec<_>>().join(" and ")
    }
}

/// The help of an option that names a force model.
#[must_use]
pub fn model_help() -> String {
    format!("Force model: {}", MODEL_IDS.join(", "))
}

/// What a plate has at its two sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Ends {
    /// Ends as far apart as the plate is wide: soil fails there too
    Finite,
    /// No ends: plane strain
    None,
}

impl Ends {
    /// What a model is asked about. Where nothing is wished, a plate has ends if the model knows them, and its width if the model
    /// is one of plane strain too.
    ///
    /// # Errors
    /// [`EarthPressureError::NoEnds`] for a model of plane strain.
    pub fn of(wish: Option<Self>, model: &dyn ForceModel, sized: bool) -> Result<Self, EarthPressureError> {
        match wish {
            Some(Self::None) => Ok(Self::None),
            Some(Self::Finite) if !model.has_ends() => Err(EarthPressureError::NoEnds { model: model.id() }),
            Some(Self::Finite) => Ok(Self::Finite),
            None if model.has_ends() && (sized || !model.is_for_plane_strain()) => Ok(Self::Finite),
            None => Ok(Self::None),
        }
    }
}

/// How friction falls with stress, in degrees a decade: LOW:HIGH.
pub(crate) fn slopes(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once(':').ok_or("it must be LOW:HIGH in degrees a decade, such as 3:6")?;
    check_slopes((finite(low)?, finite(high)?))
}

/// The same slopes, if soil may have them.
pub(crate) fn check_slopes((low, high): (f64, f64)) -> Result<(f64, f64), String> {
    if 0.0 <= low && low <= high && high <= MAX_SLOPE_DEG {
        Ok((low, high))
    } else {
        Err(format!("LOW must be at most HIGH, both 0 to {MAX_SLOPE_DEG} degrees a decade"))
    }
}

/// A number that is neither NaN nor infinite, from the command line.
///
/// # Errors
/// What a number looks like.
pub fn finite(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err("it must be a finite number with a decimal point, such as 0.025".into()),
    }
}

/// Loads on and properties of the soil, beside its friction and density.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Loads {
    /// Cohesion of the soil (Pa), at least 0
    #[arg(long = "cohesion", value_name = "PA", default_value_t = Loads::default().cohesion_pa, value_parser = finite,
          allow_negative_numbers = true)]
    pub cohesion_pa: f64,

    /// Adhesion between soil and plate (Pa), at least 0
    #[arg(long = "adhesion", value_name = "PA", default_value_t = Loads::default().adhesion_pa, value_parser = finite,
          allow_negative_numbers = true)]
    pub adhesion_pa: f64,

    /// Vertical pressure on the surface, on both sides of the plate (Pa), at least 0
    #[arg(long = "surcharge", value_name = "PA", default_value_t = Loads::default().surcharge_pa, value_parser = finite,
          allow_negative_numbers = true)]
    pub surcharge_pa: f64,

    /// Gravity (m/s2), above 0
    #[arg(long = "gravity", value_name = "M/S2", default_value_t = Loads::default().gravity_m_s2, value_parser = finite,
          allow_negative_numbers = true)]
    pub gravity_m_s2: f64,

    /// Slope of the surface (deg), positive when it rises ahead of the plate
    #[arg(long = "beta", value_name = "DEG", default_value_t = Loads::default().beta_deg, value_parser = finite,
          allow_negative_numbers = true)]
    pub beta_deg: f64,
}

impl Default for Loads {
    fn default() -> Self {
        Self {
            cohesion_pa: 0.0,
            adhesion_pa: 0.0,
            surcharge_pa: 0.0,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
            beta_deg: 0.0,
        }
    }
}

impl From<Loads> for SoilLoads {
    fn from(loads: Loads) -> Self {
        let Loads { cohesion_pa, adhesion_pa, surcharge_pa, gravity_m_s2: _, beta_deg: _ } = loads;
        Self { cohesion_pa, adhesion_pa, surcharge_pa }
    }
}

/// A number, or the word `column` for the column of that name in the stroke table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NumberOrColumn {
    /// The number.
    Number(f64),
    /// The column.
    Column,
}

impl NumberOrColumn {
    /// The number, if it is one.
    #[must_use]
    pub const fn number(self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(value),
            Self::Column => None,
        }
    }
}

impl std::fmt::Display for NumberOrColumn {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(value) => write!(f, "{value}"),
            Self::Column => f.write_str("column"),
        }
    }
}

impl FromStr for NumberOrColumn {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "column" {
            return Ok(Self::Column);
        }
        finite(text).map(Self::Number).map_err(|problem| format!("{problem}, or the word column"))
    }
}

impl Serialize for NumberOrColumn {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Column => serializer.serialize_str("column"),
        }
    }
}

impl<'de> Deserialize<'de> for NumberOrColumn {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::String(text) => text.parse().map_err(serde::de::Error::custom),
            value => value.as_f64().map(Self::Number).ok_or_else(|| {
                serde::de::Error::custom(format!("{value} is neither a number nor the word column"))
            }),
        }
    }
}

impl JsonSchema for NumberOrColumn {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "NumberOrColumn".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({"anyOf": [{"type": "number"}, {"const": "column"}]})
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A request like those of the use cases.
    #[derive(Debug, PartialEq, Serialize, Deserialize, JsonSchema, clap::Args)]
    #[serde(default)]
    struct Sample {
        /// Required.
        #[arg(long)]
        delta: NumberOrColumn,
        /// With a range and a default.
        #[arg(long, default_value_t = Sample::default().width_m)]
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 10.0))]
        width_m: f64,
        /// A list.
        #[arg(long)]
        #[schemars(inner(range(min = 0.0)))]
        depths_m: Vec<f64>,
        /// Whole.
        #[arg(long)]
        count: Option<u32>,
        /// Not beside the list.
        #[arg(long, conflicts_with = "depths_m")]
        depth_m: Option<f64>,
        #[command(flatten)]
        #[serde(flatten)]
        loads: Loads,
    }

    impl Default for Sample {
        fn default() -> Self {
            Self {
                delta: NumberOrColumn::Column,
                width_m: 0.1,
                depths_m: Vec::new(),
                count: None,
                depth_m: None,
                loads: Loads::default(),
            }
        }
    }

    #[test]
    fn what_is_left_out_has_its_default_and_the_schema_says_it() {
        let read: Sample = from_json(r#"{"delta": 20, "cohesion_pa": 5}"#).unwrap();
        let loads = Loads { cohesion_pa: 5.0, ..Loads::default() };
        assert_eq!(read, Sample { delta: NumberOrColumn::Number(20.0), loads, ..Sample::default() });
        let schema = schema::<Sample>().unwrap();
        assert_eq!(schema["required"], serde_json::json!(["delta"]));
        assert_eq!(schema["properties"]["width_m"]["default"], 0.1);
        assert_eq!(schema["properties"]["gravity_m_s2"]["default"], STANDARD_GRAVITY_M_S2);
    }

    #[test]
    fn what_makes_no_sense_is_refused_by_name() {
        for (text, message) in [
            (r#"{"delta": 20, "widht_m": 1}"#, "widht_m is unknown"),
            (r#"{"width_m": 1}"#, "delta is missing"),
            (r#"{"delta": "row"}"#, "the word column"),
            (r#"{"delta": 20, "width_m": 0}"#, "width_m is 0 m; it must be above 0 m and at most 10 m"),
            (r#"{"delta": 20, "depths_m": [1, -1]}"#, "depths_m is -1 m; it must be at least 0 m"),
            (r#"{"delta": 20, "depths_m": [1], "depth_m": 2}"#, "exclude each other"),
            (r#"{"delta": 20, "count": -1}"#, "count is -1; it must be at least 0 and at most 4294967295"),
            ("[]", "expected"),
        ] {
            let problem = from_json::<Sample>(text).unwrap_err().to_string();
            assert!(problem.contains(message), "{text}: {problem}");
        }
    }
}
