//! One of several processes that share the runs of a study.

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use thiserror::Error;

/// More shards than this are a slip of the pen.
const MAX_SHARDS: u32 = 100_000;

/// Shard i of n: of every round it makes the runs whose place p in their list has p mod n = i - 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u32,
    of: u32,
}

/// A text that names no shard.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "'{text}' is no shard: write i/n, shard i of n, with i from 1 to n and n at most {MAX_SHARDS}, for example 2/7"
)]
pub struct ShardError {
    /// The text.
    pub text: String,
}

impl Shard {
    /// Shard `index` of `of`, counted from 1; `None` if there is no such shard.
    pub fn new(index: u32, of: u32) -> Option<Self> {
        (index >= 1 && index <= of && of <= MAX_SHARDS).then_some(Self { index, of })
    }

    /// Its number, from 1.
    pub fn index(self) -> u32 {
        self.index
    }

    /// How many there are.
    pub fn of(self) -> u32 {
        self.of
    }

    /// Whether it makes the run at `place` of a list.
    pub fn makes(self, place: u64) -> bool {
        place % u64::from(self.of) == u64::from(self.index - 1)
    }

    /// The number of the shard, of `of`, that makes the run at `place`.
    pub fn index_for_run(place: u64, of: u32) -> u32 {
        // Below `of`, which is 32 bits wide.
        (place % u64::from(of)) as u32 + 1
    }

    /// Folder of the shard when the study goes to `results`: `results.shard-2-of-7`.
    pub fn folder(self, results: &Path) -> PathBuf {
        let mut name = results.as_os_str().to_owned();
        name.push(self.suffix());
        PathBuf::from(name)
    }

    /// Destination of the study when this shard writes to `folder`; `None` if that has another name than its own.
    pub fn results(self, folder: &Path) -> Option<PathBuf> {
        let name = folder.file_name()?.to_str()?.strip_suffix(&self.suffix())?;
        (!name.is_empty()).then(|| folder.with_file_name(name))
    }

    fn suffix(self) -> String {
        format!(".shard-{}-of-{}", self.index, self.of)
    }
}

/// `2/7`.
impl fmt::Display for Shard {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let number = |text: &str| text.trim().parse::<u32>().ok();
        let numbers = text.split_once('/').and_then(|(index, of)| Some((number(index)?, number(of)?)));
        numbers.and_then(|(index, of)| Self::new(index, of)).ok_or_else(|| ShardError { text: text.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_every_run_has_one_shard() {
        for of in [1, 2, 7, 11] {
            for place in 0..40 {
                let shards: Vec<u32> = (1..=of).filter(|&index| Shard::new(index, of).unwrap().makes(place)).collect();
                assert_eq!(shards, [Shard::index_for_run(place, of)]);
            }
        }
    }

    #[test]
    fn a_shard_is_read_and_written() {
        let shard: Shard = "3/7".parse().unwrap();
        assert_eq!((shard.index(), shard.of(), shard.to_string()), (3, 7, "3/7".to_owned()));
        for text in ["", "3", "0/7", "8/7", "-1/7", "3/", "a/b", "3/7/9", "1/200000"] {
            assert_eq!(text.parse::<Shard>().unwrap_err().text, text);
        }
        let folder = shard.folder(Path::new("results/worn-pin/1a2b3c4d"));
        assert_eq!(folder, Path::new("results/worn-pin/1a2b3c4d.shard-3-of-7"));
        assert_eq!(shard.results(&folder), Some(PathBuf::from("results/worn-pin/1a2b3c4d")));
        assert_eq!(shard.results(Path::new("results/worn-pin/1a2b3c4d.shard-4-of-7")), None);
        assert_eq!(shard.results(Path::new("x/.shard-3-of-7")), None);
    }
}
