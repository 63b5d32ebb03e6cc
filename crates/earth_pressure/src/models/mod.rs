//! The models, one a file, and the list of them.

mod blocks;
mod caquot;
mod chen_liu;
mod coulomb;
mod godwin_spoor;
mod in_plane_strain;
mod log_spiral;
mod mckyes;
mod ovesen;
mod perumpral;
mod plate_bounds;
pub mod thesis;
mod wedge_with_ends;

pub use blocks::{Blocks, EndLaw};
pub use caquot::Caquot;
pub use chen_liu::ChenLiu;
pub(crate) use chen_liu::{active as chen_active, passive as chen_passive};
pub use coulomb::Coulomb;
pub use godwin_spoor::GodwinSpoor;
pub use in_plane_strain::InPlaneStrain;
pub use log_spiral::LogSpiral;
pub use mckyes::McKyesAli;
pub use ovesen::Ovesen;
pub use perumpral::Perumpral;
pub use plate_bounds::plate_bounds;

use crate::{EarthPressureError, ForceModel};

/// Makes a model.
type Make = fn() -> Result<Box<dyn ForceModel>, EarthPressureError>;

/// Id and maker of each model, in the order in which they are listed.
const MODELS: &[(&str, Make)] = &[
    ("coulomb", || Ok(Box::new(Coulomb))),
    ("log-spiral", || Ok(Box::new(LogSpiral::CORRECT))),
    ("log-spiral-thesis", || Ok(Box::new(LogSpiral::THESIS))),
    ("caquot", || Ok(Box::new(Caquot::new()?))),
    ("chen", || Ok(Box::new(ChenLiu))),
    ("thesis-ub", || Ok(Box::new(thesis::upper_bound()?))),
    ("thesis-lb", || Ok(Box::new(thesis::lower_bound()?))),
    ("mckyes", || Ok(Box::new(McKyesAli))),
    ("perumpral", || Ok(Box::new(Perumpral))),
    ("godwin-spoor", || Ok(Box::new(GodwinSpoor))),
    ("ovesen", || Ok(Box::new(Ovesen))),
    ("blocks-3d", || Ok(Box::new(Blocks))),
    ("table", || Ok(Box::new(plate_bounds::bracket()?))),
];

/// Ids of all models.
pub const MODEL_IDS: [&str; MODELS.len()] = {
    let mut ids = [""; MODELS.len()];
    let mut k = 0;
    while k < ids.len() {
        ids[k] = MODELS[k].0;
        k += 1;
    }
    ids
};

/// The model with this id.
///
/// # Errors
/// [`EarthPressureError::UnknownModel`] if there is none.
pub fn model(id: &str) -> Result<Box<dyn ForceModel>, EarthPressureError> {
    match MODELS.iter().find(|(name, _)| *name == id) {
        Some((_, make)) => make(),
        None => Err(EarthPressureError::UnknownModel { name: id.to_owned(), known: MODEL_IDS.join(", ") }),
    }
}

/// The model with this id, for a use in which plates have no ends.
///
/// # Errors
/// [`EarthPressureError::UnknownModel`] if there is none, [`EarthPressureError::HasEnds`] if the model is one of plates
/// with ends.
pub fn plane_model(id: &str) -> Result<Box<dyn ForceModel>, EarthPressureError> {
    let model = model(id)?;
    if model.is_for_plane_strain() {
        Ok(InPlaneStrain::of(model))
    } else {
        Err(EarthPressureError::HasEnds { model: model.id() })
    }
}
