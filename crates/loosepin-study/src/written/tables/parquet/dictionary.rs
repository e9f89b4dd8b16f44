//! Values by their place in a list of those that differ (Encodings.md, "Dictionary Encoding (RLE_DICTIONARY = 8)").

use std::collections::HashMap;

use super::bits::width_of;
use super::cursor::Cursor;
use super::error::ParquetError;
use super::hybrid;
use super::plain::Stored;

/// The values that differ, in the order in which they come first, and the data page: the width of a place, then the places.
pub fn encode<'a, T: Stored<'a>>(values: &[T]) -> (Vec<T>, Vec<u8>) {
    let mut entries = Vec::new();
    let mut places = HashMap::new();
    let place = |value: &T| {
        *places.entry(*value).or_insert_with(|| {
            entries.push(*value);
            entries.len() as u32 - 1
        })
    };
    let places: Vec<u32> = values.iter().map(place).collect();
    let width = width_of(entries.len().saturating_sub(1) as u64);
    let mut page = vec![width as u8];
    page.extend(hybrid::encode(&places, width));
    (entries, page)
}

/// The `count` values of a data page; for each of them there is memory.
///
/// # Errors
/// A place that the list does not have, and bytes that end too early.
pub fn decode<T: Copy>(cursor: &mut Cursor<'_>, entries: &[T], count: usize) -> Result<Vec<T>, ParquetError> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let [width] = cursor.array("the width of indices")?;
    let places = hybrid::decode(cursor.take_rest(), u32::from(width), count)?;
    let value = |place: u32| {
        let rule = || format!("below the {} values of its dictionary", entries.len());
        entries.get(place as usize).copied().ok_or_else(|| ParquetError::wrong("an index", place, rule()))
    };
    places.into_iter().map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_places_in_a_dictionary() {
        let (entries, page) = encode(&["b", "a", "b", "c"]);
        assert_eq!(entries, ["b", "a", "c"]);
        // Two bits each: 0, 1, 0, 2, and four zeros that fill the group.
        assert_eq!(page, [2, 0b11, 0b1000_0100, 0]);
        assert_eq!(decode(&mut Cursor::new(&page), &entries, 4), Ok(vec!["b", "a", "b", "c"]));
        // One value takes no bits.
        assert_eq!(encode(&[7_u64; 20]), (vec![7], vec![0, 40]));
        assert_eq!(encode::<u64>(&[]), (vec![], vec![0]));
        assert_eq!(decode(&mut Cursor::new(&[0, 40]), &[7], 20), Ok(vec![7; 20]));
    }

    #[test]
    fn places_beyond_the_dictionary_are_refused() {
        let told = decode(&mut Cursor::new(&[2, 0b11, 0b1000_0100, 0]), &["b", "a"], 4).expect_err("no values");
        assert_eq!(told.to_string(), "an index is 2; must be below the 2 values of its dictionary");
    }
}
