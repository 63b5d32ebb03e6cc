/// Declares a row by its columns.
///
/// After the fields that are no columns, each line has name and type of a column, its unit, its [`Range`](crate::Range), its
/// meaning, the commands that read it and who knows it, a variant of [`Source`](crate::Source). Attributes before a line go to the field.
/// The types are those with a [`Field`](crate::Field): `f64` and `String` in every row, in an `Option` if they may be
/// missing, and `Option<u32>`.
#[macro_export]
macro_rules! columns {
    (
        $(#[$attribute:meta])*
        pub struct $row:ident { $($other:tt)* } columns {
            $(
                $(#[$field_attribute:meta])*
                $name:ident: $kind:ty, $unit:literal, $range:expr, $meaning:literal, [$($reader:ident)*], $source:ident;
            )+
        }
    ) => {
        $(#[$attribute])*
        pub struct $row {
            $($other)*
            $(
                #[doc = concat!($meaning, " (", $unit, ").")]
                $(#[$field_attribute])*
                pub $name: $kind,
            )+
        }

        impl $crate::Columns for $row {
            const COLUMNS: &'static [$crate::Column<Self>] = &[$(
                $crate::Column {
                    about: $crate::About {
                        name: stringify!($name),
                        unit: $unit,
                        range: $range,
                        meaning: $meaning,
                        readers: &[$(stringify!($reader)),*],
                        source: $crate::Source::$source,
                        kind: <$kind as $crate::Field>::KIND,
                        required: <$kind as $crate::Field>::REQUIRED,
                    },
                    get: |row| $crate::Field::cell(&row.$name),
                    set: |row, cell| $crate::Field::put(&mut row.$name, cell),
                },
            )+];
        }
    };
}
