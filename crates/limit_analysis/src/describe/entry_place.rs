//! Where in a description a message belongs, for programs that show it there.

use serde::Serialize;

use super::error::DescriptionError;

/// A table of a problem file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Section {
    /// `[[soil]]`
    Soil,
    /// `[[region]]`
    Region,
    /// `[[boundary]]`
    Boundary,
    /// `[[plate]]`
    Plate,
    /// `[[structure]]`
    Structure,
    /// `[[member]]`
    Member,
    /// `[[case]]`
    Case,
    /// `[[sweep]]`
    Sweep,
    /// `[[head]]`
    Head,
    /// `[water]`
    Water,
    /// `[seepage]`
    Seepage,
    /// `[seismic]`
    Seismic,
    /// `[objective]`
    Objective,
    /// The keys of the file itself.
    Problem,
}

impl Section {
    const ALL: [(Self, &'static str); 14] = [
        (Self::Soil, "soil"),
        (Self::Region, "region"),
        (Self::Boundary, "boundary"),
        (Self::Plate, "plate"),
        (Self::Structure, "structure"),
        (Self::Member, "member"),
        (Self::Case, "case"),
        (Self::Sweep, "sweep"),
        (Self::Head, "head"),
        (Self::Water, "water"),
        (Self::Seepage, "seepage"),
        (Self::Seismic, "seismic"),
        (Self::Objective, "objective"),
        (Self::Problem, "the problem"),
    ];
}

/// An entry of a description.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Entry {
    /// Its table.
    pub section: Section,
    /// Which of them, from 0; none where there is one only.
    pub index: Option<usize>,
}

impl Entry {
    /// The entry that a title names as messages do: `soil 2 ("clay")`, `water`; words may follow.
    #[must_use]
    pub fn of_title(title: &str) -> Option<Self> {
        Section::ALL.iter().find_map(|(section, word)| {
            let rest = title.strip_prefix(word)?;
            if rest.starts_with(char::is_alphabetic) {
                return None;
            }
            let number = rest.trim_start().split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
            let index = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
            Some(Self { section: *section, index })
        })
    }
}

/// Where in a description a message belongs.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Place {
    /// The entries that it is about.
    pub entries: Vec<Entry>,
    /// The key of the entry, where one is at fault.
    pub key: Option<String>,
    /// Where in the ground, in m: a point, or both ends of a line.
    pub points: Vec<[f64; 2]>,
}

impl Place {
    /// The place of a message that begins with the title of its entry: `soil 1 ("sand"): phi_deg is 0.5; ...`.
    #[must_use]
    pub fn of_words(words: &str) -> Self {
        let Some(entry) = Entry::of_title(words) else { return Self::default() };
        // A name may hold anything, also a colon.
        let after =
            words.rsplit_once("\"): ").or_else(|| words.split_once(": ")).map_or("", |(_, rest)| rest);
        let key = after.split_once(" is ").map(|(key, _)| key).filter(|key| !key.contains(' '));
        Self { entries: vec![entry], key: key.map(str::to_owned), points: Vec::new() }
    }
}

impl DescriptionError {
    /// Where it belongs.
    #[must_use]
    pub fn place(&self) -> Place {
        let of = |titles: &[&String]| titles.iter().filter_map(|title| Entry::of_title(title)).collect();
        let keyed = |entry: &String, key: &str| Place {
            entries: of(&[entry]),
            key: Some(key.to_owned()),
            points: Vec::new(),
        };
        match self {
            Self::File { .. }
            | Self::TooLarge { .. }
            | Self::Ending { .. }
            | Self::Format { .. }
            | Self::TooMuch { .. } => Place::default(),
            // The key that would say what holds there.
            Self::NoCondition { parts } => Place {
                entries: vec![Entry { section: Section::Problem, index: None }],
                key: Some("default_boundary".to_owned()),
                points: points_in(parts).take(2).collect(),
            },
            Self::Number { entry, key, .. } | Self::Unknown { entry, key, .. } => keyed(entry, key),
            Self::Entry { entry, problem } => {
                Place { entries: of(&[entry]), key: None, points: points_in(problem).take(1).collect() }
            }
            Self::Overlap { first, second, at } | Self::NearlyTouch { first, second, at, .. } => {
                Place { entries: of(&[first, second]), key: None, points: vec![*at] }
            }
            Self::Conflict { first, second, line } => {
                Place { entries: of(&[first, second]), key: None, points: line.to_vec() }
            }
        }
    }
}

/// The points that words name: `(4.8, 0)`.
fn points_in(words: &str) -> impl Iterator<Item = [f64; 2]> {
    words.split('(').skip(1).filter_map(|rest| {
        let (x, y) = rest.split_once(')')?.0.split_once(", ")?;
        Some([x.parse().ok()?, y.parse().ok()?])
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::describe::{Description, SoilEntry};

    #[test]
    fn titles_name_their_entries() {
        let entry = |section, index| Some(Entry { section, index });
        for (title, wanted) in [
            ("soil 2 (\"clay\")", entry(Section::Soil, Some(1))),
            ("region 1", entry(Section::Region, Some(0))),
            ("case 12 (\"soil 3\"): it is", entry(Section::Case, Some(11))),
            ("water: its table", entry(Section::Water, None)),
            ("the problem", entry(Section::Problem, None)),
            ("soils everywhere", None),
            ("", None),
        ] {
            assert_eq!(Entry::of_title(title), wanted, "{title}");
        }
    }

    #[test]
    fn points_are_found_in_words() {
        let of = |words: &str| points_in(words).collect::<Vec<_>>();
        assert_eq!(of("from (0, -6) to (4.5, 0), (a, b), (3) and ("), [[0.0, -6.0], [4.5, 0.0]]);
        assert!(of("").is_empty());
    }

    #[test]
    fn errors_know_their_place() {
        let soil = |phi_deg| SoilEntry {
            name: "a: b".into(),
            phi_deg: Some(phi_deg),
            unit_weight_kn_m3: 18.0,
            ..SoilEntry::default()
        };
        let error = Description::strip_load(soil(95.0), 2.0).described().unwrap_err().to_string();
        assert!(error.contains("phi_deg"), "{error}");
        let mut it = Description::strip_load(soil(30.0), 2.0);
        it.regions.push(it.regions[0].clone());
        let Err(crate::LimitError::Description(error)) = it.described() else { panic!("it is refused") };
        let place = error.place();
        assert_eq!(place.entries.len(), 2);
        assert!(place.entries.iter().all(|entry| entry.section == Section::Region));
        let mut it = Description::strip_load(soil(30.0), 2.0);
        it.regions[0].polygon = vec![[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
        let Err(crate::LimitError::Description(error)) = it.described() else { panic!("it crosses itself") };
        assert_eq!(error.place().points, [[2.0, 2.0]], "{error}");
        let mut it = Description::strip_load(soil(30.0), 2.0);
        it.default_boundary = None;
        let Err(crate::LimitError::Description(error)) = it.described() else {
            panic!("it has no condition")
        };
        assert_eq!(error.place().points.len(), 2, "{error}");
        let place = Place::of_words("soil 1 (\"a: b\"): phi_deg is 0.5; soils with friction have");
        assert_eq!((place.entries[0].index, place.key.as_deref()), (Some(0), Some("phi_deg")));
        assert_eq!(Place::of_words("water: its table is at y = 3 m").key, None);
    }
}
