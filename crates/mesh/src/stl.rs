//! STL, binary and as text. Both have a normal a triangle, which is not looked at: what corners say is what is drawn.

use crate::error::Fault;
use crate::shape::{Mesh, Part};

const HEAD: usize = 84;
const FACET: usize = 50;

/// Whether these bytes look like STL.
pub(crate) fn is_stl(bytes: &[u8]) -> bool {
    is_text(bytes) || is_binary(bytes)
}

/// A text begins with `solid` and a name, and has facets; a binary file may begin with that word, too.
fn is_text(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    let beginning = start.get(..start.len().min(2048)).unwrap_or_default();
    start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
        && !beginning.contains(&0)
        && beginning
            .windows(5)
            .any(|word| word.eq_ignore_ascii_case(b"facet") || word.eq_ignore_ascii_case(b"endso"))
}

fn is_binary(bytes: &[u8]) -> bool {
    count(bytes).is_some_and(|count| count.checked_mul(FACET).is_some_and(|size| size <= bytes.len() - HEAD))
}

/// The number of triangles that the head of a binary file states.
fn count(bytes: &[u8]) -> Option<usize> {
    let [a, b, c, d] = *bytes.get(HEAD - 4..HEAD)? else { return None };
    usize::try_from(u32::from_le_bytes([a, b, c, d])).ok()
}

/// At most so many triangles.
pub(crate) fn read(bytes: &[u8], most: u64) -> Result<Mesh, Fault> {
    let part = if is_text(bytes) { text(bytes, most)? } else { binary(bytes, most)? };
    if part.triangles.is_empty() {
        return Err(Fault::of("it has no triangle"));
    }
    Ok(Mesh { parts: vec![part] })
}

fn binary(bytes: &[u8], most: u64) -> Result<Part, Fault> {
    let count = count(bytes).ok_or_else(|| Fault::of("it is too short"))?;
    if count as u64 > most {
        return Err(Fault::TooMany);
    }
    let mut part = Part::default();
    for facet in bytes.get(HEAD..).unwrap_or_default().chunks_exact(FACET).take(count) {
        let value = |k: usize| {
            let at = 12 + 4 * k;
            facet
                .get(at..at + 4)
                .and_then(|four| <[u8; 4]>::try_from(four).ok())
                .map_or(0.0, f32::from_le_bytes)
        };
        part.flat([0, 1, 2].map(|corner| [0, 1, 2].map(|axis| value(3 * corner + axis))));
    }
    Ok(part)
}

fn text(bytes: &[u8], most: u64) -> Result<Part, Fault> {
    let text = std::str::from_utf8(bytes).map_err(|_| Fault::of("it is not UTF-8 text"))?;
    let (mut part, mut corners) = (Part::default(), Vec::with_capacity(3));
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some(word) if word.eq_ignore_ascii_case("vertex") => {
                let mut value = || words.next().and_then(|word| word.parse::<f32>().ok());
                let (Some(x), Some(y), Some(z)) = (value(), value(), value()) else {
                    return Err(Fault::of(format!("line {} has no three numbers", number + 1)));
                };
                corners.push([x, y, z]);
                if let [a, b, c] = corners[..] {
                    if part.triangles.len() as u64 >= most {
                        return Err(Fault::TooMany);
                    }
                    part.flat([a, b, c]);
                    corners.clear();
                }
            }
            Some(word) if word.eq_ignore_ascii_case("facet") => corners.clear(),
            _ => {}
        }
    }
    Ok(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 2e0 0\n  endloop\n endfacet\nendsolid a\n";

    fn packed(corners: &[[f32; 9]], title: &str) -> Vec<u8> {
        let mut bytes = title.as_bytes().to_vec();
        bytes.resize(80, b' ');
        bytes.extend(u32::try_from(corners.len()).unwrap().to_le_bytes());
        for nine in corners {
            bytes.extend([0; 12]);
            bytes.extend(nine.iter().flat_map(|value| value.to_le_bytes()));
            bytes.extend([7, 7]);
        }
        bytes
    }

    #[test]
    fn text_and_binary_say_the_same() {
        // A title such as some programs write.
        let bytes = packed(&[[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0]], "solid of an exporter");
        assert!(is_stl(&bytes) && is_stl(TEXT.as_bytes()) && !is_stl(b"solid") && !is_stl(b"glTF"));
        let mesh = read(&bytes, 10).unwrap();
        assert_eq!(mesh, read(TEXT.as_bytes(), 10).unwrap());
        assert_eq!(mesh.parts[0].normals, [[0.0, 0.0, 1.0]; 3]);
        assert_eq!(mesh.bounds_m(), Some([[0.0; 3], [1.0, 2.0, 0.0]]));
    }

    #[test]
    fn what_is_no_triangle_is_left_out() {
        let good = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0];
        let mut wrong = [good; 4];
        (wrong[0][3], wrong[1][4], wrong[2][3]) = (f32::NAN, f32::INFINITY, 0.0);
        assert_eq!(read(&packed(&wrong, ""), 10).unwrap().triangles(), 1);
        assert!(matches!(read(&packed(&wrong[..2], ""), 10), Err(Fault::Malformed(_))));
        assert_eq!(read(&packed(&[good; 3], ""), 2), Err(Fault::TooMany));
        assert_eq!(read(TEXT.as_bytes(), 0), Err(Fault::TooMany));
        assert!(read(TEXT.replace("2e0", "two").as_bytes(), 9).is_err());
    }
}
