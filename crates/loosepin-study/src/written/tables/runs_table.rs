//! `runs.parquet`: one run a row.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Stored};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterVersion};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type};

use super::FilesError;
use super::arrow_schema::{ARROW_SCHEMA_KEY, arrow_schema};
use crate::runs::table::{RunColumn, RunData, RunsTable};
use loosepin_text::units::SiUnit;

/// Key of the file metadata that holds the unit of each column, as a JSON object.
const UNITS_KEY: &str = "units";
/// Rows per row group: fixed, because it shapes the bytes.
const ROWS_PER_GROUP: usize = 1 << 16;

/// The runs as a Parquet file whose bytes depend on the table alone: no time stamp, fixed writer settings, no compression.
/// Units stand under the key `units` and in the field metadata of the Arrow schema; not-a-number is written as null.
///
/// # Errors
/// Columns of unequal length or of equal name, and what the library refuses.
pub fn runs_parquet(table: &RunsTable) -> Result<Vec<u8>, FilesError> {
    check_columns(table)?;
    written(table).map_err(|source| FilesError::Parquet { source })
}

/// Reads what [`runs_parquet`] wrote; a null in a column of numbers becomes not-a-number.
///
/// # Errors
/// A compressed file, as older versions wrote it, other column types, and what the library refuses.
pub fn read_runs_parquet(bytes: Vec<u8>) -> Result<RunsTable, FilesError> {
    let refused = |source| FilesError::Parquet { source };
    let file = SerializedFileReader::new(bytes::Bytes::from(bytes)).map_err(refused)?;
    let mut columns = empty_columns(&file)?;
    for group in 0..file.num_row_groups() {
        let group = file.get_row_group(group).map_err(refused)?;
        for (index, column) in columns.iter_mut().enumerate() {
            let compression = group.metadata().column(index).compression();
            if compression != Compression::UNCOMPRESSED {
                // "ZSTD(ZstdLevel(1))": the level is of no interest.
                let codec = compression.to_string().chars().take_while(|letter| *letter != '(').collect();
                return Err(FilesError::CompressedRuns { codec });
            }
            read_column(&*group, index, &mut column.data).map_err(refused)?;
        }
    }
    let table = RunsTable { columns };
    check_columns(&table)?;
    Ok(table)
}

fn check_columns(table: &RunsTable) -> Result<(), FilesError> {
    let mut names = BTreeSet::new();
    let Some(first) = table.columns.first() else { return Ok(()) };
    for column in &table.columns {
        if column.data.len() != first.data.len() {
            return Err(FilesError::UnequalColumns {
                name: column.name.clone(),
                rows: column.data.len(),
                expected: first.data.len(),
                first: first.name.clone(),
            });
        }
        if !names.insert(column.name.as_str()) {
            return Err(FilesError::RepeatedColumn { name: column.name.clone() });
        }
    }
    Ok(())
}

fn written(table: &RunsTable) -> Result<Vec<u8>, ParquetError> {
    let fields = table.columns.iter().map(|column| parquet_type(column).map(Arc::new));
    let schema = Type::group_type_builder("runs").with_fields(fields.collect::<Result<_, _>>()?).build()?;
    let mut bytes = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut bytes, Arc::new(schema), Arc::new(properties(table)))?;
    let rows = table.columns.first().map_or(0, |column| column.data.len());
    for first in (0..rows).step_by(ROWS_PER_GROUP) {
        let rows = first..rows.min(first + ROWS_PER_GROUP);
        let mut group = writer.next_row_group()?;
        for column in &table.columns {
            // The schema has a column for each of the table.
            let Some(mut chunk) = group.next_column()? else { break };
            write_chunk(&mut chunk, &column.data, rows.clone())?;
            chunk.close()?;
        }
        group.close()?;
    }
    writer.close()?;
    Ok(bytes)
}

fn parquet_type(column: &RunColumn) -> Result<Type, ParquetError> {
    let (stored, meaning) = match column.data {
        RunData::F64(_) => (Stored::DOUBLE, None),
        RunData::U64(_) => (Stored::INT64, Some(LogicalType::integer(64, false))),
        RunData::Text(_) => (Stored::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let repetition = if column.data.is_nullable() { Repetition::OPTIONAL } else { Repetition::REQUIRED };
    Type::primitive_type_builder(&column.name, stored).with_logical_type(meaning).with_repetition(repetition).build()
}

fn properties(table: &RunsTable) -> WriterProperties {
    let units: serde_json::Map<_, _> =
        table.columns.iter().map(|column| (column.name.clone(), column.unit.symbol().into())).collect();
    let metadata = vec![
        KeyValue::new(UNITS_KEY.to_owned(), serde_json::Value::from(units).to_string()),
        KeyValue::new(ARROW_SCHEMA_KEY.to_owned(), arrow_schema(&table.columns)),
    ];
    let mut properties = WriterProperties::builder()
        .set_created_by(format!("loosepin {}", loosepin_text::VERSION))
        .set_writer_version(WriterVersion::PARQUET_1_0)
        .set_compression(Compression::UNCOMPRESSED)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_key_value_metadata(Some(metadata));
    for column in &table.columns {
        // Counts go up by little from run to run: differences are shorter than a dictionary of them.
        if matches!(column.data, RunData::U64(_)) {
            let path = ColumnPath::from(column.name.as_str());
            properties = properties
                .set_column_dictionary_enabled(path.clone(), false)
                .set_column_encoding(path, Encoding::DELTA_BINARY_PACKED);
        }
    }
    properties.build()
}

fn write_chunk(
    chunk: &mut SerializedColumnWriter<'_>,
    data: &RunData,
    rows: std::ops::Range<usize>,
) -> Result<(), ParquetError> {
    match data {
        RunData::F64(values) => {
            let values = &values[rows];
            let is_there: Vec<i16> = values.iter().map(|value| i16::from(!value.is_nan())).collect();
            let present: Vec<f64> = values.iter().copied().filter(|value| !value.is_nan()).collect();
            chunk.typed::<DoubleType>().write_batch(&present, Some(&is_there), None)?;
        }
        RunData::U64(values) => {
            // Parquet keeps the bits and says beside them that they have no sign.
            let values: Vec<i64> = values[rows].iter().map(|value| value.cast_signed()).collect();
            chunk.typed::<Int64Type>().write_batch(&values, None, None)?;
        }
        RunData::Text(values) => {
            let values: Vec<ByteArray> = values[rows].iter().map(|value| value.as_bytes().into()).collect();
            chunk.typed::<ByteArrayType>().write_batch(&values, None, None)?;
        }
    }
    Ok(())
}

/// The columns that `file` announces, without rows.
fn empty_columns(file: &impl FileReader) -> Result<Vec<RunColumn>, FilesError> {
    let metadata = file.metadata().file_metadata();
    let entries = metadata.key_value_metadata().into_iter().flatten();
    let units = entries.filter(|entry| entry.key == UNITS_KEY).find_map(|entry| entry.value.as_deref());
    let mut units: BTreeMap<String, String> = match units {
        Some(text) => serde_json::from_str(text)
            .map_err(|source| FilesError::Layout { what: format!("'{UNITS_KEY}' of the runs"), source })?,
        None => BTreeMap::new(),
    };
    let columns = metadata.schema_descr().columns().iter().map(|column| {
        let name = column.path().string();
        let data = match (column.physical_type(), column.logical_type_ref()) {
            (Stored::DOUBLE, None) => RunData::F64(Vec::new()),
            (Stored::INT64, Some(meaning)) if *meaning == LogicalType::integer(64, false) => RunData::U64(Vec::new()),
            (Stored::BYTE_ARRAY, Some(LogicalType::String)) => RunData::Text(Vec::new()),
            (stored, _) => return Err(FilesError::ForeignColumn { name, stored: stored.to_string() }),
        };
        let unit = units.remove(&name).map_or(SiUnit::NONE, SiUnit::from_symbol);
        Ok(RunColumn { name, unit, data })
    });
    columns.collect()
}

/// Appends the rows of one column of a row group.
fn read_column(group: &dyn RowGroupReader, index: usize, data: &mut RunData) -> Result<(), ParquetError> {
    match (group.get_column_reader(index)?, data) {
        (ColumnReader::DoubleColumnReader(reader), RunData::F64(rows)) => {
            let (values, levels) = read_values(reader)?;
            let mut values = values.into_iter();
            rows.extend(
                levels.iter().map(|&level| if level == 1 { values.next().unwrap_or(f64::NAN) } else { f64::NAN }),
            );
        }
        (ColumnReader::Int64ColumnReader(reader), RunData::U64(rows)) => {
            rows.extend(read_values(reader)?.0.into_iter().map(i64::cast_unsigned));
        }
        (ColumnReader::ByteArrayColumnReader(reader), RunData::Text(rows)) => {
            for value in read_values(reader)?.0 {
                rows.push(value.as_utf8()?.to_owned().into());
            }
        }
        _ => return Err(ParquetError::General(format!("column {index} has another type than the schema says"))),
    }
    Ok(())
}

/// All values of a column chunk, and for each of its rows 1 where it has a value.
fn read_values<T: DataType>(mut reader: ColumnReaderImpl<T>) -> Result<(Vec<T::T>, Vec<i16>), ParquetError> {
    let (mut values, mut is_there) = (Vec::new(), Vec::new());
    reader.read_records(usize::MAX, Some(&mut is_there), None, &mut values)?;
    Ok((values, is_there))
}
