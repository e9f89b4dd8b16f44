//! The rows of a file.

use std::borrow::Cow;

use super::cursor::Cursor;
use super::error::ParquetError;
use super::metadata::{Column, Metadata};
use super::page::{DELTA_BINARY_PACKED, PLAIN, PLAIN_DICTIONARY, Page, PageKind, RLE_DICTIONARY};
use super::plain::Stored;
use super::{ROWS_PER_GROUP, delta, dictionary, hybrid, page, plain};
use crate::runs::table::RunData;

/// A few bytes can stand for many equal rows. Rows may take this much memory, and so much for each byte of the file.
const MEMORY: usize = 1 << 28;
const MEMORY_PER_BYTE: usize = 32;

/// A file of which the footer has been read.
#[derive(Debug)]
pub struct ParquetFile<'a> {
    bytes: &'a [u8],
    metadata: Metadata,
    memory_left: usize,
}

impl<'a> ParquetFile<'a> {
    /// Reads the footer of a file.
    ///
    /// # Errors
    /// As [`Metadata::read`].
    pub fn open(bytes: &'a [u8]) -> Result<Self, ParquetError> {
        let memory_left = bytes.len().saturating_mul(MEMORY_PER_BYTE).saturating_add(MEMORY);
        Ok(Self { bytes, metadata: Metadata::read(bytes)?, memory_left })
    }

    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.metadata.columns
    }

    /// The text that the file keeps under `key`.
    pub fn entry(&self, key: &str) -> Option<&str> {
        self.metadata.entries.iter().find_map(|(own, value)| (own == key).then_some(value.as_str()))
    }

    /// The number of row groups.
    pub fn groups(&self) -> usize {
        self.metadata.groups.len()
    }

    /// The name of the compression of a column within a row group, if it has any.
    pub fn codec(&self, group: usize, column: usize) -> Option<&str> {
        self.metadata.groups[group].chunks[column].codec.as_deref()
    }

    /// Appends the rows of a column within a row group, which are not compressed, to `rows`, which are of the kind of the column.
    ///
    /// # Errors
    /// Encodings that [`super::write`] does not use, more rows than it puts into a group, values that are not there, and rows that take
    /// much more memory than the file.
    pub fn read(&mut self, group: usize, column: usize, rows: &mut RunData) -> Result<(), ParquetError> {
        let group = &self.metadata.groups[group];
        let bytes = &self.bytes[group.chunks[column].bytes.clone()];
        let column = &self.metadata.columns[column];
        let chunk = Chunk { bytes, rows: group.rows, is_optional: column.is_optional };
        let memory = read_chunk(&chunk, self.memory_left, rows).map_err(|error| error.in_column(&column.name))?;
        self.memory_left -= memory;
        Ok(())
    }
}

/// The bytes of a column chunk, and what the footer says of it.
struct Chunk<'a> {
    bytes: &'a [u8],
    rows: usize,
    is_optional: bool,
}

/// The values of a chunk, and for each row of an optional column 1 where it has one, else 0.
struct Values<T> {
    present: Vec<T>,
    is_there: Vec<u32>,
}

/// Appends the rows of `chunk`; returns the memory that they take, which is at most `memory_left`.
fn read_chunk(chunk: &Chunk<'_>, memory_left: usize, rows: &mut RunData) -> Result<usize, ParquetError> {
    if chunk.rows > ROWS_PER_GROUP {
        return Err(ParquetError::wrong("the rows of a group", chunk.rows, format!("at most {ROWS_PER_GROUP}")));
    }
    let affordable = |memory: usize| {
        let rule = || format!("at most {memory_left} bytes for a file of this size");
        if memory > memory_left {
            Err(ParquetError::wrong("the memory of its rows", memory, rule()))
        } else {
            Ok(memory)
        }
    };
    match rows {
        RunData::F64(rows) => {
            let memory = affordable(chunk.rows * size_of::<f64>())?;
            let values = chunk.values::<u64>(None)?;
            if chunk.is_optional {
                let mut present = values.present.into_iter();
                let value = |&is_there: &u32| if is_there == 1 { present.next() } else { None };
                rows.extend(values.is_there.iter().map(value).map(|bits| bits.map_or(f64::NAN, f64::from_bits)));
            } else {
                rows.extend(values.present.into_iter().map(f64::from_bits));
            }
            Ok(memory)
        }
        RunData::U64(rows) => {
            let memory = affordable(chunk.rows * size_of::<u64>())?;
            rows.extend(chunk.values_of_all(Some(delta::decode))?);
            Ok(memory)
        }
        RunData::Text(rows) => {
            let texts = chunk.values_of_all::<&str>(None)?;
            let length = |text: &&str| size_of::<Cow<'_, str>>() + text.len();
            let memory = affordable(texts.iter().map(length).fold(0, usize::saturating_add))?;
            rows.extend(texts.into_iter().map(|text| Cow::Owned(text.to_owned())));
            Ok(memory)
        }
    }
}

/// Reads counts by their differences.
type Deltas<T> = fn(&[u8], usize) -> Result<Vec<T>, ParquetError>;

impl<'a> Chunk<'a> {
    /// The values of a column in which none may be missing.
    fn values_of_all<T: Stored<'a>>(&self, deltas: Option<Deltas<T>>) -> Result<Vec<T>, ParquetError> {
        let values = self.values(deltas)?.present;
        if values.len() < self.rows { Err(ParquetError::Missing { what: "the value of a row" }) } else { Ok(values) }
    }

    fn values<T: Stored<'a>>(&self, deltas: Option<Deltas<T>>) -> Result<Values<T>, ParquetError> {
        let mut cursor = Cursor::new(self.bytes);
        let mut dictionary = None;
        let mut values = Values { present: Vec::new(), is_there: Vec::new() };
        let mut rows = 0;
        while cursor.left() > 0 {
            let page = page::read(&mut cursor)?;
            if page.kind == PageKind::Dictionary {
                dictionary = Some(dictionary_values(&page)?);
                continue;
            }
            if page.count > self.rows - rows {
                let rule = format!("at most {}, the rows that are left", self.rows - rows);
                return Err(ParquetError::wrong("the number of values of a page", page.count, rule));
            }
            rows += page.count;
            let mut body = Cursor::new(page.body);
            let mut present = page.count;
            if self.is_optional {
                // Levels stand behind their length, in four bytes.
                let length = u32::from_le_bytes(body.array("the length of definition levels")?);
                let levels = body.take("definition levels", u64::from(length))?;
                let levels = hybrid::decode(levels, 1, page.count)?;
                present = levels.iter().filter(|&&level| level == 1).count();
                values.is_there.extend(levels);
            }
            values.present.extend(match (page.encoding, deltas) {
                (PLAIN, _) => plain::decode(&mut body, present)?,
                (PLAIN_DICTIONARY | RLE_DICTIONARY, _) => {
                    let entries: &Vec<T> = dictionary.as_ref().ok_or(ParquetError::Missing { what: "a dictionary" })?;
                    dictionary::decode(&mut body, entries, present)?
                }
                (DELTA_BINARY_PACKED, Some(deltas)) => deltas(body.take_rest(), present)?,
                (other, deltas) => {
                    let rule = if deltas.is_some() { "0, 2, 5 or 8" } else { "0, 2 or 8" };
                    return Err(ParquetError::wrong("the encoding of a page", other, rule));
                }
            });
        }
        if rows < self.rows {
            return Err(ParquetError::wrong("the number of values of a chunk", rows, self.rows.to_string()));
        }
        Ok(values)
    }
}

fn dictionary_values<'a, T: Stored<'a>>(page: &Page<'a>) -> Result<Vec<T>, ParquetError> {
    if ![PLAIN, PLAIN_DICTIONARY].contains(&page.encoding) {
        return Err(ParquetError::wrong("the encoding of a dictionary", page.encoding, "0 or 2"));
    }
    plain::decode(&mut Cursor::new(page.body), page.count)
}

#[cfg(test)]
mod tests {
    use super::super::page::RLE;
    use super::*;

    /// Pages, one after another.
    fn pages(pages: &[(PageKind, usize, i32, &[u8])]) -> Vec<u8> {
        let mut bytes = Vec::new();
        for &(kind, count, encoding, body) in pages {
            page::write(&mut bytes, &Page { kind, count, encoding, body }).expect("a small page");
        }
        bytes
    }

    fn texts(bytes: &[u8], rows: usize, memory_left: usize) -> Result<Vec<Cow<'static, str>>, String> {
        let mut read = RunData::Text(Vec::new());
        let chunk = Chunk { bytes, rows, is_optional: false };
        read_chunk(&chunk, memory_left, &mut read).map_err(|error| error.to_string())?;
        let RunData::Text(texts) = read else { panic!("texts stay texts") };
        Ok(texts)
    }

    /// The crate `parquet` ends a dictionary at a megabyte: pages after that have their values themselves.
    #[test]
    fn analytic_pages_by_dictionary_and_without() {
        let (entries, places) = dictionary::encode(&["a", "b", "a"]);
        let (entries, plain) = (plain::encode(&entries), plain::encode(&["c", ""]));
        let bytes = pages(&[
            (PageKind::Dictionary, 2, PLAIN, &entries),
            (PageKind::Data, 3, RLE_DICTIONARY, &places),
            (PageKind::Data, 0, RLE_DICTIONARY, &[]),
            (PageKind::Data, 2, PLAIN, &plain),
        ]);
        assert_eq!(texts(&bytes, 5, 1000), Ok(["a", "b", "a", "c", ""].map(Cow::from).to_vec()));
        assert_eq!(
            texts(&bytes, 4, 1000),
            Err("the number of values of a page is 2; must be at most 1, the rows that are left".to_owned())
        );
        assert_eq!(texts(&bytes, 6, 1000), Err("the number of values of a chunk is 5; must be 6".to_owned()));
        let dictionary = pages(&[(PageKind::Dictionary, 2, PLAIN, &entries)]).len();
        assert_eq!(texts(&bytes[dictionary..], 5, 1000), Err("a dictionary is missing".to_owned()));
    }

    /// Sixty thousand rows of a text of a thousand letters, in a thousand bytes.
    #[test]
    fn rows_that_take_much_more_than_the_file_are_refused() {
        let text = "x".repeat(1000);
        let (entries, places) = dictionary::encode(&vec![text.as_str(); 60_000]);
        let entries = plain::encode(&entries);
        let bytes =
            pages(&[(PageKind::Dictionary, 1, PLAIN, &entries), (PageKind::Data, 60_000, RLE_DICTIONARY, &places)]);
        assert!(bytes.len() < 1100);
        let memory = 60_000 * (1000 + size_of::<Cow<'_, str>>());
        assert_eq!(texts(&bytes, 60_000, memory).map(|texts| texts.len()), Ok(60_000));
        let told =
            format!("the memory of its rows is {memory}; must be at most {} bytes for a file of this size", memory - 1);
        assert_eq!(texts(&bytes, 60_000, memory - 1), Err(told));
        let told = "the rows of a group is 65537; must be at most 65536".to_owned();
        assert_eq!(texts(&bytes, 65_537, memory), Err(told));
    }

    #[test]
    fn other_encodings_are_refused() {
        let told = |encoding, is_counts| {
            let bytes = pages(&[(PageKind::Data, 1, encoding, &[0; 8])]);
            let mut read = if is_counts { RunData::U64(Vec::new()) } else { RunData::F64(Vec::new()) };
            let chunk = Chunk { bytes: &bytes, rows: 1, is_optional: false };
            read_chunk(&chunk, 1000, &mut read).expect_err("no values").to_string()
        };
        assert_eq!(told(DELTA_BINARY_PACKED, false), "the encoding of a page is 5; must be 0, 2 or 8");
        assert_eq!(told(RLE, true), "the encoding of a page is 3; must be 0, 2, 5 or 8");
    }
}
