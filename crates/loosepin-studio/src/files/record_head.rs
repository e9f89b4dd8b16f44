//! One entry of the record of a study, which is read no further: records are large, and what stands at their head is wanted of many.

use std::fmt;
use std::io::{BufReader, Read};
use std::path::Path;

use loosepin::results::SUMMARY_FILE;
use serde::de::{DeserializeOwned, Deserializer, Error, IgnoredAny, MapAccess, Visitor};

use crate::files::folder::Folder;

/// The entry `key` of the record of the result at `path`, of which at most so many bytes are read; `None` if it has none there. Takes the
/// bytes that may have been read off those that are left.
pub fn entry_of<T: DeserializeOwned>(
    folder: &Folder,
    path: &str,
    key: &'static str,
    limit_bytes: u64,
    left_bytes: &mut u64,
) -> Option<T> {
    let (record, info) = folder.opened().open_file(&Path::new(path).join(SUMMARY_FILE)).ok()?;
    *left_bytes = left_bytes.saturating_sub(info.size_bytes.min(limit_bytes));
    let mut entry = None;
    let record = BufReader::new(record.take(limit_bytes));
    // It ends with an error in any case: the rest is not read.
    let _ = serde_json::Deserializer::from_reader(record).deserialize_map(UpTo { key, entry: &mut entry });
    entry
}

/// Takes an entry out of a record, and refuses what follows.
struct UpTo<'r, T> {
    key: &'static str,
    entry: &'r mut Option<T>,
}

impl<'de, T: DeserializeOwned> Visitor<'de> for UpTo<'_, T> {
    type Value = ();

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("the record of a study")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<(), A::Error> {
        while let Some(key) = entries.next_key::<String>()? {
            if key == self.key {
                *self.entry = Some(entries.next_value()?);
                return Err(A::Error::custom("the rest is not read"));
            }
            entries.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
}
