//! The footer of a file: its columns, its row groups, and what else is said of it (`FileMetaData` of parquet.thrift). The file begins
//! and ends with the letters PAR1; before the last ones stands the length of the footer in four bytes (README.md, "File format").

use std::collections::BTreeSet;
use std::ops::Range;

use super::cursor::Cursor;
use super::error::ParquetError;
use super::thrift::{Fields, Value};
use crate::runs::table::{RunColumn, RunData};

/// The letters at both ends.
pub const MAGIC: &[u8; 4] = b"PAR1";
/// `CompressionCodec.UNCOMPRESSED`
const UNCOMPRESSED: i32 = 0;
/// `Type`, by its numbers.
const TYPES: [&str; 8] =
    ["BOOLEAN", "INT32", "INT64", "INT96", "FLOAT", "DOUBLE", "BYTE_ARRAY", "FIXED_LEN_BYTE_ARRAY"];
const INT64: i32 = 2;
const DOUBLE: i32 = 5;
const BYTE_ARRAY: i32 = 6;
/// `CompressionCodec`, by its numbers.
const CODECS: [&str; 8] = ["UNCOMPRESSED", "SNAPPY", "GZIP", "LZO", "BROTLI", "LZ4", "ZSTD", "LZ4_RAW"];
/// `FieldRepetitionType`
const REQUIRED: i32 = 0;
const OPTIONAL: i32 = 1;

/// What the values of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `DOUBLE` without a logical type.
    Double,
    /// `INT64` with the logical type `INTEGER(64, false)`.
    Count,
    /// `BYTE_ARRAY` with the logical type `STRING`.
    Text,
}

/// A column of the schema.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// The name of its physical type.
    pub stored: String,
    /// What its values are, where that is one of those of runs.
    pub kind: Option<Kind>,
    /// Whether rows may be without a value.
    pub is_optional: bool,
}

/// Where the rows of a column within a row group stand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChunkPlace {
    /// Its bytes in the file.
    pub bytes: Range<usize>,
    /// The name of its compression, if it has any.
    pub codec: Option<String>,
}

/// Some rows of all columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// How many.
    pub rows: usize,
    /// A chunk for each column.
    pub chunks: Vec<ChunkPlace>,
}

/// What the footer says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Metadata {
    /// The columns.
    pub columns: Vec<Column>,
    /// Texts by their names.
    pub entries: Vec<(String, String)>,
    /// The rows.
    pub groups: Vec<Group>,
}

impl Metadata {
    /// Reads the footer of a file.
    ///
    /// # Errors
    /// Bytes that are no Parquet file, columns within columns or with several values a row, and chunks beyond the file.
    pub fn read(file: &[u8]) -> Result<Self, ParquetError> {
        let inner = file.strip_prefix(MAGIC).and_then(|rest| rest.strip_suffix(MAGIC));
        let (rest, length) = inner.and_then(<[u8]>::split_last_chunk).ok_or(ParquetError::NotParquet)?;
        let length = u32::from_le_bytes(*length);
        let cut = || ParquetError::CutShort { what: "the footer", needed: u64::from(length), left: rest.len() };
        let footer_at = rest.len().checked_sub(length as usize).ok_or_else(cut)?;
        let fields = Fields::read(&mut Cursor::new(&rest[footer_at..]))?;
        let columns = columns(&fields)?;
        let chunks_end = MAGIC.len() + footer_at;
        let groups =
            fields.list(4, "the row groups")?.into_iter().map(|fields| group(fields, columns.len(), chunks_end));
        let groups: Vec<Group> = groups.collect::<Result<_, _>>()?;
        let what = "the number of rows";
        let (rows, of_groups) =
            (fields.size(3, what)?, groups.iter().map(|group| group.rows).fold(0, usize::saturating_add));
        if rows != of_groups {
            return Err(ParquetError::wrong(what, rows, format!("{of_groups}, those of all row groups")));
        }
        // Chunks that share bytes could be many more than the file has bytes for.
        let taken: usize =
            groups.iter().flat_map(|group| &group.chunks).map(|chunk| chunk.bytes.len()).fold(0, usize::saturating_add);
        if taken > file.len() {
            return Err(ParquetError::wrong("the size of all column chunks", taken, format!("at most {}", file.len())));
        }
        let entry = |fields: &Fields| {
            let (key, value) = (fields.text(1)?, fields.text(2)?);
            Ok(key.zip(value).map(|(key, value)| (key.to_owned(), value.to_owned())))
        };
        let entries = fields.list(5, "the texts of the file")?;
        let entries = entries.into_iter().filter_map(|fields| entry(fields).transpose()).collect::<Result<_, _>>()?;
        Ok(Self { columns, entries, groups })
    }
}

/// The leaves of the schema, whose first element is the table itself.
fn columns(footer: &Fields) -> Result<Vec<Column>, ParquetError> {
    let mut elements = footer.list(2, "the schema")?.into_iter();
    let what = "the number of columns";
    let count = elements.next().ok_or(ParquetError::Missing { what: "the schema" })?.size(5, what)?;
    let columns: Vec<Column> = elements.map(column).collect::<Result<_, _>>()?;
    if columns.len() != count {
        return Err(ParquetError::wrong(what, count, columns.len().to_string()));
    }
    let mut names = BTreeSet::new();
    if let Some(column) = columns.iter().find(|column| !names.insert(column.name.as_str())) {
        return Err(ParquetError::RepeatedColumn.in_column(&column.name));
    }
    Ok(columns)
}

fn column(element: &Fields) -> Result<Column, ParquetError> {
    let name = element.text(4)?.ok_or(ParquetError::Missing { what: "the name of a column" })?.to_owned();
    let read = || {
        if let Some(within) = element.integer(5).filter(|&within| within > 0) {
            return Err(ParquetError::wrong("the number of columns within it", within, "0"));
        }
        let number = element.size(1, "the type of the column")?;
        let stored = TYPES.get(number).ok_or_else(|| ParquetError::wrong("the type", number, "at most 7"))?;
        let repetition = element.size(3, "the repetition of the column")?;
        if repetition > OPTIONAL as usize {
            return Err(ParquetError::wrong("the repetition", repetition, "0 (required) or 1 (optional)"));
        }
        let logical = element.fields(10);
        let is_count = |integer: &Fields| integer.integer(1) == Some(64) && integer.truth(2) == Some(false);
        let kind = match (i32::try_from(number), logical) {
            (Ok(DOUBLE), None) => Some(Kind::Double),
            (Ok(INT64), Some(logical)) if logical.fields(10).is_some_and(is_count) => Some(Kind::Count),
            (Ok(BYTE_ARRAY), Some(logical)) if logical.fields(1).is_some() => Some(Kind::Text),
            _ => None,
        };
        Ok(Column { name: name.clone(), stored: (*stored).to_owned(), kind, is_optional: repetition == 1 })
    };
    read().map_err(|error: ParquetError| error.in_column(&name))
}

fn group(fields: &Fields, columns: usize, chunks_end: usize) -> Result<Group, ParquetError> {
    let rows = fields.size(3, "the rows of a group")?;
    let chunks = fields.list(1, "the chunks of a group")?;
    let chunks = chunks.into_iter().map(|fields| chunk(fields, chunks_end)).collect::<Result<Vec<_>, _>>()?;
    if chunks.len() != columns {
        return Err(ParquetError::wrong("the number of chunks of a group", chunks.len(), columns.to_string()));
    }
    Ok(Group { rows, chunks })
}

fn chunk(fields: &Fields, chunks_end: usize) -> Result<ChunkPlace, ParquetError> {
    let fields = fields.fields(3).ok_or(ParquetError::Missing { what: "what is said of a chunk" })?;
    let data = fields.size(9, "the place of a data page")?;
    let dictionary = fields.integer(11).is_some().then(|| fields.size(11, "the place of a dictionary")).transpose()?;
    let first = dictionary.map_or(data, |dictionary| dictionary.min(data));
    let end = first.saturating_add(fields.size(7, "the size of a chunk")?);
    if first < MAGIC.len() || end > chunks_end {
        let rule = format!("from {} to {chunks_end}, as is its first byte ({first})", MAGIC.len());
        return Err(ParquetError::wrong("the end of a chunk", end, rule));
    }
    let number = fields.size(4, "the compression of a chunk")?;
    let name = || CODECS.get(number).map_or_else(|| format!("codec {number}"), |name| (*name).to_owned());
    let codec = (i32::try_from(number) != Ok(UNCOMPRESSED)).then(name);
    Ok(ChunkPlace { bytes: first..end, codec })
}

/// A column chunk that has been written.
#[derive(Debug)]
pub struct WrittenChunk {
    /// Where it begins in the file.
    pub at: usize,
    /// Its bytes.
    pub length: usize,
    /// The bytes of the dictionary before its data page, if it has one.
    pub dictionary_length: Option<usize>,
    /// The encodings of its pages (`Encoding`).
    pub encodings: &'static [i32],
    /// What is said of its values.
    pub statistics: Fields,
}

/// A row group that has been written.
#[derive(Debug)]
pub struct WrittenGroup {
    /// Its rows.
    pub rows: usize,
    /// A chunk for each column.
    pub chunks: Vec<WrittenChunk>,
}

/// What stands behind the row groups: the footer, its length, and the letters.
pub fn footer(
    columns: &[RunColumn],
    groups: &[WrittenGroup],
    entries: &[(&str, String)],
    created_by: &str,
) -> Result<Vec<u8>, ParquetError> {
    let list = |fields: &mut dyn Iterator<Item = Fields>| Some(Value::List(fields.map(Value::Struct).collect()));
    let table = Fields::new([(4, Some(Value::text("runs"))), (5, Some(Value::I32(columns.len() as i32)))]);
    let schema = list(&mut std::iter::once(table).chain(columns.iter().map(schema_element)));
    let groups_written = list(&mut groups.iter().map(|group| row_group(group, columns)));
    let entry =
        |(key, value): &(&str, String)| Fields::new([(1, Some(Value::text(key))), (2, Some(Value::text(value)))]);
    let rows: usize = groups.iter().map(|group| group.rows).sum();
    // `ColumnOrder`: that of the type. Several readers refuse a file with the newer total order of doubles.
    let order = |_: &RunColumn| Fields::new([(1, Some(Value::Struct(Fields::default())))]);
    let fields = Fields::new([
        (1, Some(Value::I32(1))),
        (2, schema),
        (3, Some(Value::I64(rows as i64))),
        (4, groups_written),
        (5, list(&mut entries.iter().map(entry))),
        (6, Some(Value::text(created_by))),
        (7, list(&mut columns.iter().map(order))),
    ]);
    let mut bytes = Vec::new();
    fields.write(&mut bytes);
    let length = i32::try_from(bytes.len())
        .map_err(|_| ParquetError::wrong("the size of the footer", bytes.len(), format!("at most {}", i32::MAX)))?;
    bytes.extend(length.to_le_bytes());
    bytes.extend(MAGIC);
    Ok(bytes)
}

/// `Type`
fn physical_type(data: &RunData) -> i32 {
    match data {
        RunData::F64(_) => DOUBLE,
        RunData::U64(_) => INT64,
        RunData::Text(_) => BYTE_ARRAY,
    }
}

/// `SchemaElement`: type, repetition, name, the older form of the logical type (`ConvertedType`), the logical type.
fn schema_element(column: &RunColumn) -> Fields {
    let empty = || Value::Struct(Fields::default());
    let (converted, logical) = match column.data {
        RunData::F64(_) => (None, None),
        RunData::U64(_) => {
            let integer = Fields::new([(1, Some(Value::Byte(64))), (2, Some(Value::Truth(false)))]);
            (Some(Value::I32(14)), Some((10, Value::Struct(integer))))
        }
        RunData::Text(_) => (Some(Value::I32(0)), Some((1, empty()))),
    };
    let logical = logical.map(|(number, value)| Value::Struct(Fields::new([(number, Some(value))])));
    let repetition = if column.data.is_nullable() { OPTIONAL } else { REQUIRED };
    Fields::new([
        (1, Some(Value::I32(physical_type(&column.data)))),
        (3, Some(Value::I32(repetition))),
        (4, Some(Value::text(&column.name))),
        (6, converted),
        (10, logical),
    ])
}

fn row_group(group: &WrittenGroup, columns: &[RunColumn]) -> Fields {
    let length: usize = group.chunks.iter().map(|chunk| chunk.length).sum();
    let chunks = group.chunks.iter().zip(columns).map(|(chunk, column)| {
        let chunk = Value::Struct(column_metadata(chunk, column, group.rows));
        Value::Struct(Fields::new([(2, Some(Value::I64(0))), (3, Some(chunk))]))
    });
    Fields::new([
        (1, Some(Value::List(chunks.collect()))),
        (2, Some(Value::I64(length as i64))),
        (3, Some(Value::I64(group.rows as i64))),
        (5, group.chunks.first().map(|chunk| Value::I64(chunk.at as i64))),
        (6, Some(Value::I64(length as i64))),
    ])
}

/// `ColumnMetaData`
fn column_metadata(chunk: &WrittenChunk, column: &RunColumn, rows: usize) -> Fields {
    let number = |number: usize| Some(Value::I64(number as i64));
    Fields::new([
        (1, Some(Value::I32(physical_type(&column.data)))),
        (2, Some(Value::numbers(chunk.encodings))),
        (3, Some(Value::List(vec![Value::text(&column.name)]))),
        (4, Some(Value::I32(UNCOMPRESSED))),
        (5, number(rows)),
        (6, number(chunk.length)),
        (7, number(chunk.length)),
        (9, number(chunk.at + chunk.dictionary_length.unwrap_or_default())),
        (11, chunk.dictionary_length.and_then(|_| number(chunk.at))),
        (12, Some(Value::Struct(chunk.statistics.clone()))),
    ])
}
