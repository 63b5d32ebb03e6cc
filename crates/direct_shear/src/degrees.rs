//! Serialises an [`Angle`] in degrees, for fields that are called `..._deg` outside.

use serde::Serializer;
use soilctl_soil::Angle;

// serde fixes the signature of a `serialize_with` function.
#[allow(clippy::trivially_copy_pass_by_ref)]
pub(crate) fn one<S: Serializer>(angle: &Angle, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(angle.degrees())
}

#[allow(clippy::trivially_copy_pass_by_ref, clippy::ref_option)]
pub(crate) fn option<S: Serializer>(angle: &Option<Angle>, serializer: S) -> Result<S::Ok, S::Error> {
    match angle {
        Some(angle) => serializer.serialize_some(&angle.degrees()),
        None => serializer.serialize_none(),
    }
}
