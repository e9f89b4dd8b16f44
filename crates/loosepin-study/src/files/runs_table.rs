//! `runs.parquet`: one run a row.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use arrow::array::{Array, ArrayRef, Float64Array, RecordBatch, StringArray, UInt64Array};
use arrow::compute::concat_batches;
use arrow::datatypes::{DataType, Field, Schema};
use arrow::error::ArrowError;
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::{Compression, ZstdLevel};
use parquet::errors::ParquetError;
use parquet::file::properties::{WriterProperties, WriterVersion};

use super::FilesError;
use crate::runs::{RunColumn, RunData, RunsTable};
use loosepin_text::units::SiUnit;

/// Key of the field metadata that holds the unit of a column.
const UNIT_KEY: &str = "unit";
/// Rows per row group: fixed, because it shapes the bytes.
const ROWS_PER_GROUP: usize = 1 << 16;

/// The runs as a Parquet file whose bytes depend on the table alone: no time stamp, fixed writer settings, zstd.
/// The unit of a column stands in its field metadata under `unit`; not-a-number is written as null.
///
/// # Errors
/// Columns of unequal length or of equal name, and what the libraries refuse.
pub fn runs_parquet(table: &RunsTable) -> Result<Vec<u8>, FilesError> {
    check_columns(table)?;
    let fields: Vec<Field> = table.columns.iter().map(field).collect();
    let schema = Arc::new(Schema::new(fields));
    let arrays: Vec<ArrayRef> = table.columns.iter().map(array).collect();
    let properties = WriterProperties::builder()
        .set_created_by(format!("loosepin {}", loosepin_text::VERSION))
        .set_writer_version(WriterVersion::PARQUET_1_0)
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_max_row_group_row_count(Some(ROWS_PER_GROUP))
        .build();
    let mut bytes = Vec::new();
    let mut writer = ArrowWriter::try_new(&mut bytes, Arc::clone(&schema), Some(properties)).map_err(parquet_error)?;
    if !arrays.is_empty() {
        let batch = RecordBatch::try_new(schema, arrays).map_err(arrow_error)?;
        writer.write(&batch).map_err(parquet_error)?;
    }
    writer.close().map_err(parquet_error)?;
    Ok(bytes)
}

/// Reads what [`runs_parquet`] wrote; a null in a column of numbers becomes not-a-number.
///
/// # Errors
/// A file that another program wrote with other column types, and what the libraries refuse.
pub fn read_runs_parquet(bytes: Vec<u8>) -> Result<RunsTable, FilesError> {
    let contents = bytes::Bytes::from(bytes);
    let builder = ParquetRecordBatchReaderBuilder::try_new(contents).map_err(parquet_error)?;
    let schema = Arc::clone(builder.schema());
    let reader = builder.build().map_err(parquet_error)?;
    let batches = reader.collect::<Result<Vec<RecordBatch>, ArrowError>>().map_err(arrow_error)?;
    let whole = concat_batches(&schema, &batches).map_err(arrow_error)?;
    let columns = schema.fields().iter().zip(whole.columns()).map(|(field, stored)| column(field, stored));
    Ok(RunsTable { columns: columns.collect::<Result<Vec<RunColumn>, FilesError>>()? })
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

fn field(column: &RunColumn) -> Field {
    let data_type = match column.data {
        RunData::F64(_) => DataType::Float64,
        RunData::U64(_) => DataType::UInt64,
        RunData::Text(_) => DataType::Utf8,
    };
    // One key only: a map with more would be written in an order that changes from process to process.
    let metadata = HashMap::from([(UNIT_KEY.to_owned(), column.unit.symbol().to_owned())]);
    Field::new(&column.name, data_type, matches!(column.data, RunData::F64(_))).with_metadata(metadata)
}

fn array(column: &RunColumn) -> ArrayRef {
    match &column.data {
        RunData::F64(values) => {
            Arc::new(values.iter().map(|value| (!value.is_nan()).then_some(*value)).collect::<Float64Array>())
        }
        RunData::U64(values) => Arc::new(UInt64Array::from_iter_values(values.iter().copied())),
        RunData::Text(values) => Arc::new(StringArray::from_iter_values(values)),
    }
}

fn column(field: &Field, stored: &ArrayRef) -> Result<RunColumn, FilesError> {
    let any = stored.as_any();
    let data = if let Some(numbers) = any.downcast_ref::<Float64Array>() {
        RunData::F64(numbers.iter().map(|value| value.unwrap_or(f64::NAN)).collect())
    } else if let Some(counts) = any.downcast_ref::<UInt64Array>() {
        RunData::U64(counts.values().to_vec())
    } else if let Some(words) = any.downcast_ref::<StringArray>() {
        RunData::Text((0..words.len()).map(|row| words.value(row).to_owned()).collect())
    } else {
        return Err(FilesError::ForeignColumn { name: field.name().clone(), stored: field.data_type().to_string() });
    };
    let unit = match field.metadata().get(UNIT_KEY) {
        Some(symbol) => SiUnit::from_symbol(symbol.clone()),
        None => SiUnit::NONE,
    };
    Ok(RunColumn { name: field.name().clone(), unit, data })
}

fn parquet_error(source: ParquetError) -> FilesError {
    FilesError::Parquet { source }
}

fn arrow_error(source: ArrowError) -> FilesError {
    FilesError::Arrow { source }
}
