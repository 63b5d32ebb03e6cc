//! Chunks: rows of one entity as an Arrow table, with the marks by which the viewer knows its columns.

use std::sync::Arc;

use arrow_array::{
    ArrayRef, DurationNanosecondArray, FixedSizeBinaryArray, Int64Array, ListArray, RecordBatch,
};
use arrow_buffer::{Buffer, OffsetBuffer, ScalarBuffer};
use arrow_ipc::writer::StreamWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema, TimeUnit};

use super::Id;
use super::column::Column;

/// Version of the marks.
const MARKS: &str = "0.1.4";

/// When rows hold.
#[derive(Debug, Clone, Copy)]
pub(super) enum Times<'a> {
    /// Always.
    Static,
    /// At these times of the log, in ns.
    Log(&'a [i64]),
    /// In a layout.
    Blueprint,
}

/// The table as an Arrow stream. `rows` are the numbers of its rows, as many as each column has.
pub(super) fn ipc(
    entity: &str,
    chunk: Id,
    rows: &[Id],
    times: Times<'_>,
    columns: &[Column],
) -> Result<Vec<u8>, ArrowError> {
    let mut fields = vec![row_field()];
    let mut arrays: Vec<ArrayRef> = vec![Arc::new(FixedSizeBinaryArray::try_new(16, id_bytes(rows), None)?)];
    match times {
        Times::Static => {}
        Times::Log(ns) => {
            fields.push(time_field(
                super::TIMELINE,
                DataType::Duration(TimeUnit::Nanosecond),
                ns.is_sorted(),
            ));
            arrays.push(Arc::new(DurationNanosecondArray::from(ns.to_vec())));
        }
        Times::Blueprint => {
            fields.push(time_field("blueprint", DataType::Int64, true));
            arrays.push(Arc::new(Int64Array::from(vec![0; rows.len()])));
        }
    }
    for column in columns {
        let values = column.array()?;
        let item = Arc::new(Field::new("item", values.data_type().clone(), true));
        let ends = OffsetBuffer::new(ScalarBuffer::from(column.ends.clone()));
        let list = ListArray::try_new(item, ends, values, None)?;
        let component = column.component;
        let marks = [
            ("rerun:kind", "data".to_owned()),
            ("rerun:archetype", component.archetype()),
            ("rerun:component", component.name()),
            ("rerun:component_type", component.kind()),
        ];
        let field = Field::new(component.name(), arrow_array::Array::data_type(&list).clone(), true);
        fields.push(field.with_metadata(marks));
        arrays.push(Arc::new(list));
    }
    let marks = [
        ("rerun:entity_path", entity.to_owned()),
        ("rerun:id", format!("chunk_{:016X}{:016x}", chunk.high(), chunk.low())),
        ("sorbet:version", MARKS.to_owned()),
    ];
    let schema = Schema::new_with_metadata(fields, marks);
    let batch = RecordBatch::try_new(Arc::new(schema), arrays)?;
    let mut writer = StreamWriter::try_new(Vec::new(), batch.schema_ref())?;
    writer.write(&batch)?;
    writer.into_inner()
}

fn row_field() -> Field {
    let marks = [
        ("rerun:kind", "control".to_owned()),
        ("rerun:is_sorted", "true".to_owned()),
        ("ARROW:extension:name", "rerun.datatypes.TUID".to_owned()),
        ("ARROW:extension:metadata", "{\"namespace\":\"row\"}".to_owned()),
    ];
    Field::new("rerun.controls.RowId", DataType::FixedSizeBinary(16), false).with_metadata(marks)
}

fn time_field(name: &str, data: DataType, is_sorted: bool) -> Field {
    let marks = [
        ("rerun:kind", "index".to_owned()),
        ("rerun:index_name", name.to_owned()),
        ("rerun:is_sorted", is_sorted.to_string()),
    ];
    Field::new(name, data, true).with_metadata(marks)
}

fn id_bytes(rows: &[Id]) -> Buffer {
    let bytes: Vec<u8> =
        rows.iter().flat_map(|id| [id.high().to_be_bytes(), id.low().to_be_bytes()]).flatten().collect();
    Buffer::from_vec(bytes)
}
