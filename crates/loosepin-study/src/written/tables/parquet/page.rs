//! Pages: a header (`PageHeader` of parquet.thrift), then values (README.md, "Data Pages"). A chunk is a dictionary page, where it has
//! one, and data pages of the first version.

use super::cursor::Cursor;
use super::error::ParquetError;
use super::thrift::{Fields, Value};

/// `Encoding`
pub const PLAIN: i32 = 0;
pub const PLAIN_DICTIONARY: i32 = 2;
pub const RLE: i32 = 3;
pub const DELTA_BINARY_PACKED: i32 = 5;
pub const RLE_DICTIONARY: i32 = 8;

/// What a page holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PageKind {
    /// Values, or their places in the dictionary.
    Data,
    /// The values of the dictionary.
    Dictionary,
}

/// A page without its header.
#[derive(Debug)]
pub struct Page<'a> {
    /// What it holds.
    pub kind: PageKind,
    /// How many values, the missing ones among them.
    pub count: usize,
    /// How they stand there.
    pub encoding: i32,
    /// Its bytes.
    pub body: &'a [u8],
}

/// Appends a page; returns the bytes that it takes.
///
/// # Errors
/// A page of two gigabytes, of which no header can speak.
pub fn write(bytes: &mut Vec<u8>, page: &Page<'_>) -> Result<usize, ParquetError> {
    let number = |number: usize| Some(Value::I32(number as i32));
    if i32::try_from(page.body.len()).is_err() {
        let rule = format!("at most {} bytes", i32::MAX);
        return Err(ParquetError::wrong("the size of a page", page.body.len(), rule));
    }
    let encoding = Some(Value::I32(page.encoding));
    let levels = Some(Value::I32(RLE));
    let (kind, place, header) = match page.kind {
        PageKind::Data => {
            (0, 5, Fields::new([(1, number(page.count)), (2, encoding), (3, levels.clone()), (4, levels)]))
        }
        PageKind::Dictionary => (2, 7, Fields::new([(1, number(page.count)), (2, encoding)])),
    };
    let header = Some(Value::Struct(header));
    let first = bytes.len();
    let length = number(page.body.len());
    Fields::new([(1, number(kind)), (2, length.clone()), (3, length), (place, header)]).write(bytes);
    bytes.extend(page.body);
    Ok(bytes.len() - first)
}

/// The next page.
///
/// # Errors
/// Pages of other kinds, and bytes that end too early.
pub fn read<'a>(cursor: &mut Cursor<'a>) -> Result<Page<'a>, ParquetError> {
    let fields = Fields::read(cursor)?;
    let (kind, place) = match fields.size(1, "the kind of a page")? {
        0 => (PageKind::Data, 5),
        2 => (PageKind::Dictionary, 7),
        other => return Err(ParquetError::wrong("the kind of a page", other, "0 (data) or 2 (dictionary)")),
    };
    let body = cursor.take("a page", fields.size(3, "the size of a page")? as u64)?;
    let header = fields.fields(place).ok_or(ParquetError::Missing { what: "the header of a page" })?;
    let count = header.size(1, "the number of values of a page")?;
    let encoding = header.size(2, "the encoding of a page")? as i32;
    if kind == PageKind::Data && header.integer(3) != Some(i64::from(RLE)) {
        let found = header.integer(3).unwrap_or_default();
        return Err(ParquetError::wrong("the encoding of definition levels", found, RLE.to_string()));
    }
    Ok(Page { kind, count, encoding, body })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fields of `PageHeader` and `DataPageHeader` by their numbers, in the compact protocol.
    #[test]
    fn published_header_of_a_data_page() {
        let mut bytes = Vec::new();
        let page = Page { kind: PageKind::Data, count: 3, encoding: DELTA_BINARY_PACKED, body: &[7, 8] };
        assert_eq!(write(&mut bytes, &page), Ok(19));
        assert_eq!(bytes, [0x15, 0, 0x15, 4, 0x15, 4, 0x2c, 0x15, 6, 0x15, 10, 0x15, 6, 0x15, 6, 0, 0, 7, 8][..]);
        let read = read(&mut Cursor::new(&bytes)).expect("a page");
        assert_eq!((read.kind, read.count, read.encoding, read.body), (PageKind::Data, 3, 5, &[7, 8][..]));
    }

    #[test]
    fn other_pages_are_refused() {
        let told = |bytes: &[u8]| read(&mut Cursor::new(bytes)).expect_err("no page").to_string();
        assert_eq!(told(&[0x15, 6, 0]), "the kind of a page is 3; must be 0 (data) or 2 (dictionary)");
        assert_eq!(told(&[0x15, 0, 0x25, 4, 0, 7]), "a page: 2 bytes are needed where 1 are left");
        assert_eq!(told(&[0x15, 0, 0x25, 1, 0, 7]), "the size of a page is -1; must be at least 0");
        assert_eq!(told(&[0x15, 0, 0x25, 2, 0, 7]), "the header of a page is missing");
    }
}
