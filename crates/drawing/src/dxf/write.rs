//! DXF R2000: the least that programs ask of it.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::{Outline, Shape, Unit};

/// Letters that names of layers may not have.
const FORBIDDEN: &str = "<>/\\\":;?*|=`";
/// Colours of layers, by their numbers in DXF: such as are told apart on light and dark ground.
const COLOURS: [u8; 8] = [30, 90, 150, 200, 50, 130, 10, 170];

/// A text that is built by codes.
struct Text {
    text: String,
    handle: u32,
}

impl Text {
    fn add(&mut self, code: i32, value: impl std::fmt::Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{code}\n{value}");
    }

    /// The start of an object with a handle of its own.
    fn object(&mut self, kind: &str) {
        self.add(0, kind);
        self.handle += 1;
        let handle = format!("{:X}", self.handle);
        self.add(5, handle);
    }

    fn table(&mut self, name: &str, count: usize, mut entries: impl FnMut(&mut Self)) {
        self.add(0, "TABLE");
        self.add(2, name);
        self.handle += 1;
        let handle = format!("{:X}", self.handle);
        self.add(5, handle);
        self.add(100, "AcDbSymbolTable");
        self.add(70, count);
        entries(self);
        self.add(0, "ENDTAB");
    }

    fn entry(&mut self, kind: &str, class: &str, name: &str) {
        self.object(kind);
        self.add(100, "AcDbSymbolTableRecord");
        self.add(100, class);
        self.add(2, name);
    }
}

/// A drawing in metres, each layer with a colour of its own.
pub(crate) fn write(shapes: &[Shape]) -> String {
    let mut layers: BTreeMap<&str, String> = BTreeMap::new();
    for shape in shapes {
        let name = named(&shape.layer, &layers);
        layers.entry(&shape.layer).or_insert(name);
    }
    let mut text = Text { text: String::new(), handle: 0x20 };
    header(&mut text);
    tables(&mut text, &layers.values().map(String::as_str).collect::<Vec<_>>());
    blocks(&mut text);
    text.add(0, "SECTION");
    text.add(2, "ENTITIES");
    for shape in shapes {
        text.object("LWPOLYLINE");
        text.add(100, "AcDbEntity");
        text.add(8, &layers[shape.layer.as_str()]);
        text.add(100, "AcDbPolyline");
        text.add(90, shape.corners.len());
        text.add(70, i32::from(shape.outline == Outline::Closed));
        for [x, y] in &shape.corners {
            text.add(10, format!("{x:?}"));
            text.add(20, format!("{y:?}"));
        }
    }
    text.add(0, "ENDSEC");
    text.add(0, "SECTION");
    text.add(2, "OBJECTS");
    text.object("DICTIONARY");
    text.add(100, "AcDbDictionary");
    text.add(281, 1);
    text.add(0, "ENDSEC");
    text.add(0, "EOF");
    text.text
}

fn header(text: &mut Text) {
    text.add(0, "SECTION");
    text.add(2, "HEADER");
    text.add(9, "$ACADVER");
    text.add(1, "AC1015");
    text.add(9, "$HANDSEED");
    text.add(5, "FFFFFF");
    text.add(9, "$INSUNITS");
    text.add(70, Unit::Metre.of_dxf());
    text.add(0, "ENDSEC");
}

fn tables(text: &mut Text, layers: &[&str]) {
    text.add(0, "SECTION");
    text.add(2, "TABLES");
    text.table("LTYPE", 3, |text| {
        for name in ["ByBlock", "ByLayer", "Continuous"] {
            text.entry("LTYPE", "AcDbLinetypeTableRecord", name);
            for (code, value) in [(70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0.0")] {
                text.add(code, value);
            }
        }
    });
    text.table("LAYER", layers.len() + 1, |text| {
        for (i, name) in std::iter::once("0").chain(layers.iter().copied().filter(|n| *n != "0")).enumerate()
        {
            text.entry("LAYER", "AcDbLayerTableRecord", name);
            text.add(70, 0);
            text.add(62, if i == 0 { 7 } else { COLOURS[(i - 1) % COLOURS.len()] });
            text.add(6, "Continuous");
        }
    });
    text.table("STYLE", 1, |text| {
        text.entry("STYLE", "AcDbTextStyleTableRecord", "Standard");
        for (code, value) in [(70, "0"), (40, "0.0"), (41, "1.0"), (3, "txt"), (4, "")] {
            text.add(code, value);
        }
    });
    text.table("APPID", 1, |text| {
        text.entry("APPID", "AcDbRegAppTableRecord", "ACAD");
        text.add(70, 0);
    });
    text.table("BLOCK_RECORD", 2, |text| {
        for name in ["*Model_Space", "*Paper_Space"] {
            text.entry("BLOCK_RECORD", "AcDbBlockTableRecord", name);
        }
    });
    text.add(0, "ENDSEC");
}

fn blocks(text: &mut Text) {
    text.add(0, "SECTION");
    text.add(2, "BLOCKS");
    for name in ["*Model_Space", "*Paper_Space"] {
        text.object("BLOCK");
        text.add(100, "AcDbEntity");
        text.add(8, "0");
        text.add(100, "AcDbBlockBegin");
        text.add(2, name);
        text.add(70, 0);
        for code in [10, 20, 30] {
            text.add(code, "0.0");
        }
        text.add(3, name);
        text.object("ENDBLK");
        text.add(100, "AcDbEntity");
        text.add(8, "0");
        text.add(100, "AcDbBlockEnd");
    }
    text.add(0, "ENDSEC");
}

/// A name that DXF allows, and that no other layer has; letters beyond ASCII are written as R2000 does.
fn named(layer: &str, others: &BTreeMap<&str, String>) -> String {
    if let Some(name) = others.get(layer) {
        return name.clone();
    }
    let letter = |c: char| match c {
        c if FORBIDDEN.contains(c) || c.is_control() => "_".to_owned(),
        c if c.is_ascii() => c.to_string(),
        c if u32::from(c) < 0x1_0000 => format!("\\U+{:04X}", u32::from(c)),
        _ => "_".to_owned(),
    };
    let plain: String = layer.trim().chars().take(200).map(letter).collect();
    let plain = if plain.is_empty() { "layer".to_owned() } else { plain };
    let is_taken = |name: &str| others.values().any(|other| other.eq_ignore_ascii_case(name));
    let mut name = plain.clone();
    let mut count = 1;
    while is_taken(&name) {
        count += 1;
        name = format!("{plain}_{count}");
    }
    name
}
