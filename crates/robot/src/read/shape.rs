//! What is drawn. A shape that cannot be drawn is no reason to refuse an arm.

use crate::RobotError;
use crate::model::Geometry;
use crate::numbers::{are_sound, numbers};
use crate::words::cut;
use crate::xml::{Element, Elements};

/// The first shape in an element `geometry`.
pub(super) fn geometry(xml: &mut Elements<'_>, link: &str) -> Result<Option<Geometry>, RobotError> {
    let mut found = None;
    while let Some(part) = xml.child()? {
        if found.is_none() {
            found = shape(&part)?;
            if found.is_none() {
                let name = cut(part.name());
                xml.notes
                    .add(|| format!("a {name} of link {:?} is left out: its size is not one", cut(link)));
            }
        }
        xml.skip()?;
    }
    Ok(found)
}

fn shape(element: &Element<'_>) -> Result<Option<Geometry>, RobotError> {
    let [size, radius, length, filename, scale] =
        element.get(["size", "radius", "length", "filename", "scale"])?;
    let length_of = |text: Option<&str>| {
        numbers::<1>(text?).filter(|[value]| are_sound(&[*value]) && *value > 0.0).map(|[value]| value)
    };
    let (radius_m, length_m) = (length_of(radius.as_deref()), length_of(length.as_deref()));
    let three = |text: &str| numbers::<3>(text).filter(|values| are_sound(values));
    Ok(match element.name() {
        "box" => size
            .and_then(|text| three(&text))
            .filter(|size| size.iter().all(|edge| *edge > 0.0))
            .map(|size_m| Geometry::Box { size_m }),
        "cylinder" => {
            radius_m.zip(length_m).map(|(radius_m, length_m)| Geometry::Cylinder { radius_m, length_m })
        }
        "capsule" => {
            radius_m.zip(length_m).map(|(radius_m, length_m)| Geometry::Capsule { radius_m, length_m })
        }
        "sphere" => radius_m.map(|radius_m| Geometry::Sphere { radius_m }),
        "mesh" => {
            let scale = scale.map_or(Some([1.0; 3]), |text| three(&text));
            let scale = scale.filter(|scale| scale.iter().all(|factor| *factor != 0.0));
            let filename = filename.filter(|name| !name.trim().is_empty());
            filename.zip(scale).map(|(name, scale)| Geometry::Mesh { filename: name.into_owned(), scale })
        }
        _ => None,
    })
}

/// The colour in an element `material`, if it has one.
pub(super) fn colour(xml: &mut Elements<'_>, material: &str) -> Result<Option<[f64; 4]>, RobotError> {
    let mut found = None;
    while let Some(part) = xml.child()? {
        if part.name() == "color" && found.is_none() {
            let [rgba] = part.get(["rgba"])?;
            found = rgba
                .and_then(|text| numbers::<4>(&text))
                .filter(|rgba| rgba.iter().all(|share| (0.0..=1.0).contains(share)));
            if found.is_none() {
                let material = cut(material);
                xml.notes
                    .add(|| format!("the colour of material {material:?} is not four numbers from 0 to 1"));
            }
        }
        xml.skip()?;
    }
    Ok(found)
}
