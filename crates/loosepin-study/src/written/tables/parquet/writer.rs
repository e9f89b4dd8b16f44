//! Runs as the bytes of a file.

use std::ops::Range;

use super::error::ParquetError;
use super::metadata::{MAGIC, WrittenChunk, WrittenGroup, footer};
use super::page::{DELTA_BINARY_PACKED, PLAIN, Page, PageKind, RLE, RLE_DICTIONARY};
use super::plain::Stored;
use super::thrift::Fields;
use super::{ROWS_PER_GROUP, delta, dictionary, hybrid, page, plain, statistics};
use crate::runs::table::{RunColumn, RunData, RunsTable};

/// About the bytes that a dictionary costs beside its values and their places.
const DICTIONARY_HEADER: usize = 20;

/// The bytes of a file with the rows of `table`, whose columns have one length, the texts `entries` by their names, and the name of the
/// program that wrote it. They depend on nothing else.
///
/// # Errors
/// Texts of 65,536 rows that take two gigabytes.
pub fn write(table: &RunsTable, entries: &[(&str, String)], created_by: &str) -> Result<Vec<u8>, ParquetError> {
    let mut bytes = MAGIC.to_vec();
    let rows = table.columns.first().map_or(0, |column| column.data.len());
    let mut groups = Vec::new();
    for first in (0..rows).step_by(ROWS_PER_GROUP) {
        let rows = first..rows.min(first + ROWS_PER_GROUP);
        let chunk = |column: &RunColumn| {
            write_chunk(&mut bytes, &column.data, rows.clone()).map_err(|error| error.in_column(&column.name))
        };
        let chunks = table.columns.iter().map(chunk).collect::<Result<_, _>>()?;
        groups.push(WrittenGroup { rows: rows.len(), chunks });
    }
    bytes.extend(footer(&table.columns, &groups, entries, created_by)?);
    Ok(bytes)
}

fn write_chunk(bytes: &mut Vec<u8>, data: &RunData, rows: Range<usize>) -> Result<WrittenChunk, ParquetError> {
    match data {
        RunData::F64(values) => {
            let values = &values[rows];
            let is_there: Vec<u32> = values.iter().map(|value| u32::from(!value.is_nan())).collect();
            let present: Vec<u64> =
                values.iter().filter(|value| !value.is_nan()).map(|value| value.to_bits()).collect();
            // Levels stand behind their length, in four bytes.
            let levels = hybrid::encode(&is_there, 1);
            let mut prefix = (levels.len() as u32).to_le_bytes().to_vec();
            prefix.extend(levels);
            write_shorter(bytes, prefix, &present, values.len(), statistics::of_doubles(values))
        }
        RunData::U64(values) => {
            let values = &values[rows];
            let at = bytes.len();
            let (kind, encoding) = (PageKind::Data, DELTA_BINARY_PACKED);
            // Counts go up by little from run to run: differences are shorter than a dictionary of them.
            let body = &delta::encode(values);
            let length = page::write(bytes, &Page { kind, count: values.len(), encoding, body })?;
            let (encodings, statistics) = (&[RLE, DELTA_BINARY_PACKED], statistics::of_counts(values));
            Ok(WrittenChunk { at, length, dictionary_length: None, encodings, statistics })
        }
        RunData::Text(values) => {
            let texts: Vec<&str> = values[rows].iter().map(|text| &**text).collect();
            write_shorter(bytes, Vec::new(), &texts, texts.len(), statistics::of_texts(&texts))
        }
    }
}

/// The chunk of `values` behind their levels: by a dictionary where that is shorter, else one after another.
fn write_shorter<'a, T: Stored<'a>>(
    bytes: &mut Vec<u8>,
    levels: Vec<u8>,
    values: &[T],
    count: usize,
    statistics: Fields,
) -> Result<WrittenChunk, ParquetError> {
    let at = bytes.len();
    let mut body = levels;
    let (entries, places) = dictionary::encode(values);
    let with_dictionary = plain::length(&entries) + places.len() + DICTIONARY_HEADER;
    let (dictionary_length, encoding, encodings): (_, _, &[i32]) = if with_dictionary < plain::length(values) {
        let (kind, entries_body) = (PageKind::Dictionary, plain::encode(&entries));
        let entries = Page { kind, count: entries.len(), encoding: PLAIN, body: &entries_body };
        body.extend(places);
        (Some(page::write(bytes, &entries)?), RLE_DICTIONARY, &[PLAIN, RLE, RLE_DICTIONARY])
    } else {
        body.extend(plain::encode(values));
        (None, PLAIN, &[PLAIN, RLE])
    };
    page::write(bytes, &Page { kind: PageKind::Data, count, encoding, body: &body })?;
    Ok(WrittenChunk { at, length: bytes.len() - at, dictionary_length, encodings, statistics })
}
