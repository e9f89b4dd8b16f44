//! What a column chunk says of its values: least, largest, how many are missing (`Statistics` of parquet.thrift).

use super::thrift::{Fields, Value};

/// Longer texts stand in statistics by their beginning.
const LONGEST: usize = 64;

/// Of doubles; not-a-number is missing. Readers need not tell zeros apart: a least zero is written as -0, a largest one as 0 (`ColumnOrder`
/// of parquet.thrift).
pub fn of_doubles(values: &[f64]) -> Fields {
    let there = || values.iter().copied().filter(|value| !value.is_nan());
    let bytes = |value: f64| (value.to_le_bytes().to_vec(), true);
    let least = there().reduce(f64::min).map(|least| if least == 0.0 { -0.0 } else { least });
    let largest = there().reduce(f64::max).map(|largest| if largest == 0.0 { 0.0 } else { largest });
    statistics(values.len() - there().count(), least.map(bytes), largest.map(bytes))
}

/// Of counts.
pub fn of_counts(values: &[u64]) -> Fields {
    let bytes = |value: &u64| (value.to_le_bytes().to_vec(), true);
    statistics(0, values.iter().min().map(bytes), values.iter().max().map(bytes))
}

/// Of texts, in the order of their bytes.
pub fn of_texts(values: &[&str]) -> Fields {
    let least = values.iter().min().map(|text| (beginning(text).as_bytes().to_vec(), text.len() <= LONGEST));
    let largest = values.iter().max().and_then(|text| {
        let is_whole = text.len() <= LONGEST;
        let bytes = if is_whole { Some(text.as_bytes().to_vec()) } else { beyond(beginning(text)) };
        bytes.map(|bytes| (bytes, is_whole))
    });
    statistics(0, least, largest)
}

fn statistics(missing: usize, least: Option<(Vec<u8>, bool)>, largest: Option<(Vec<u8>, bool)>) -> Fields {
    let (least, is_least) = least.unzip();
    let (largest, is_largest) = largest.unzip();
    Fields::new([
        (3, Some(Value::I64(missing as i64))),
        (5, largest.map(Value::Bytes)),
        (6, least.map(Value::Bytes)),
        (7, is_largest.map(Value::Truth)),
        (8, is_least.map(Value::Truth)),
    ])
}

fn beginning(text: &str) -> &str {
    &text[..text.floor_char_boundary(LONGEST)]
}

/// A text that comes after all that begin with `text`: its last letter is the next one of as many bytes.
fn beyond(text: &str) -> Option<Vec<u8>> {
    text.char_indices().rev().find_map(|(at, letter)| {
        let next = char::from_u32(letter as u32 + 1).filter(|next| next.len_utf8() == letter.len_utf8())?;
        Some(format!("{}{next}", &text[..at]).into_bytes())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_least_and_largest() {
        let bytes = |value: f64| Some(Value::Bytes(value.to_le_bytes().to_vec()));
        let truth = |number| (number, Some(Value::Truth(true)));
        let of_ends = |missing: i64, least: f64, largest: f64| {
            let ends = [(3, Some(Value::I64(missing))), (5, bytes(largest)), (6, bytes(least))];
            Fields::new(ends.into_iter().chain([truth(7), truth(8)]))
        };
        let of = of_doubles(&[0.0, f64::NAN, -0.0, -3.5, f64::INFINITY, -f64::NAN]);
        assert_eq!(of, of_ends(2, -3.5, f64::INFINITY));
        assert_eq!(of_doubles(&[0.0, 2.0]), of_ends(0, -0.0, 2.0));
        assert_eq!(of_doubles(&[-0.0, -2.0]), of_ends(0, -2.0, 0.0));
        assert_eq!(of_doubles(&[f64::NAN]), Fields::new([(3, Some(Value::I64(1)))]));
        let of = of_counts(&[3, u64::MAX, 0]);
        let ends = [(5, vec![0xff; 8]), (6, vec![0; 8])].map(|(number, bytes)| (number, Some(Value::Bytes(bytes))));
        assert_eq!(of, Fields::new([(3, Some(Value::I64(0)))].into_iter().chain(ends).chain([truth(7), truth(8)])));
    }

    /// 63 letters and one of two bytes: the beginning has 63; the letter after z is {.
    #[test]
    fn analytic_long_texts_stand_by_their_beginning() {
        let text = format!("{}z{}", "a".repeat(62), "ä");
        let of = of_texts(&[text.as_str(), "b"]);
        assert_eq!((of.text(5), of.text(6)), (Ok(Some("b")), Ok(Some(&text[..63]))));
        assert_eq!((of.truth(7), of.truth(8)), (Some(true), Some(false)));
        let of = of_texts(&[text.as_str()]);
        assert_eq!(of.text(5), Ok(Some(format!("{}{{", "a".repeat(62)).as_str())));
        assert_eq!(beyond("a\u{7f}"), Some(b"b".to_vec()));
        assert_eq!(beyond("\u{7f}"), None);
    }
}
