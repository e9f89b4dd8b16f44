//! Folders of shards: what each says of itself, and whether they belong together.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::error::ResultsError;
use crate::shard::Shard;
use loosepin_text::diagnostics::{Code, problems};

/// Name of the file that says what a folder of a shard belongs to.
pub const SHARD_FILE: &str = "shard.json";

/// Start of a shard: its study, version and number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShardRecord {
    /// Its number, from 1.
    pub shard: u32,
    /// How many there are.
    pub of: u32,
    /// Name of the study.
    pub name: String,
    /// The study file, as it was given.
    pub study: PathBuf,
    /// Accuracies that were given beside those of the file.
    pub accuracy: Vec<String>,
    /// The budget that was given in place of that of the file.
    pub budget: Option<String>,
    /// BLAKE3 of all inputs, 64 hexadecimal digits.
    pub inputs_blake3: String,
    /// Version of the program.
    pub version: String,
}

/// The folders of all shards of a study, in the order of their numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShardFolders {
    /// The record of their start; the number is that of the first.
    pub record: ShardRecord,
    /// The folder of each shard.
    pub folders: Vec<PathBuf>,
}

problems! {
    /// Why folders are not the shards of one study.
    #[derive(Debug)]
    pub enum ShardsError {
        /// A folder that no shard has written, or that cannot be read.
        NotAShard { folder: PathBuf, source: Box<ResultsError> } => Code::ShardsDoNotFit,
            says("{} is not the folder of a shard: {source}", folder.display()),
            hint("give the folders written by loosepin study --shard i/n, RESULTS.shard-i-of-n");
        /// A shard of something else: of another `study`, `version` or `number of shards` than the first folder.
        OfOther { folder: PathBuf, what: &'static str, found: String, first: PathBuf, expected: String } =>
            Code::ShardsDoNotFit,
            says("{} belongs to another {what} ({found}) than {} ({expected})", folder.display(), first.display()),
            hint("give the shards of one study, with the same version and the same number of shards");
        /// A shard twice.
        Twice { shard: u32, of: u32, folders: [PathBuf; 2] } => Code::ShardsDoNotFit,
            says("shard {shard}/{of} is given twice: {} and {}", folders[0].display(), folders[1].display()),
            hint("give each shard once");
        /// Shards that are not given.
        Missing { missing: Vec<u32>, of: u32, study: PathBuf } => Code::ShardsDoNotFit,
            says(
                "{} of {of} shards {} missing: {}",
                missing.len(),
                if missing.len() == 1 { "is" } else { "are" },
                listed(missing, *of)
            ),
            hint(
                "also give their folders; loosepin study {} --shard {first}/{of} makes the runs of shard {first}",
                study.display(),
                first = missing.first().copied().unwrap_or(1)
            );
        /// The study is not what the shards were started with.
        Changed { study: PathBuf, found: String, expected: String } => Code::ShardsDoNotFit,
            says(
                "{} with its model (inputs {found}) differs from the study of the shards (inputs {expected})",
                study.display()
            ),
            hint("give the original study with --study, or run the shards of the changed study");
        /// A folder whose name does not identify the destination of the results.
        Renamed { folder: PathBuf, shard: u32, of: u32 } => Code::ShardsDoNotFit,
            says("{} does not have the name that its shard gave it, NAME.shard-{shard}-of-{of}", folder.display()),
            hint("give the folder of the results with --out");
    }
}

/// `3/7, 5/7`; of many the first ones.
fn listed(shards: &[u32], of: u32) -> String {
    const SHOWN: usize = 10;
    let mut list: Vec<String> = shards.iter().take(SHOWN).map(|shard| format!("{shard}/{of}")).collect();
    if shards.len() > SHOWN {
        list.push(format!("and {} more", shards.len() - SHOWN));
    }
    list.join(", ")
}

impl ShardFolders {
    /// Reads the folders of all shards of a study, given in any order.
    ///
    /// # Errors
    /// [`ShardsError`]: a folder is none of a shard, belongs to something else, is given twice, or is missing.
    pub fn read(folders: &[PathBuf]) -> Result<Self, ShardsError> {
        let records = folders.iter().map(|folder| match read_record(folder) {
            Ok(record) => Ok((folder, record)),
            Err(source) => Err(ShardsError::NotAShard { folder: folder.clone(), source: Box::new(source) }),
        });
        let records = records.collect::<Result<Vec<(&PathBuf, ShardRecord)>, _>>()?;
        let Some((first_folder, first)) = records.first() else {
            return Err(ShardsError::Missing { missing: vec![1], of: 1, study: PathBuf::new() });
        };
        let mut by_number: BTreeMap<u32, &PathBuf> = BTreeMap::new();
        for (folder, record) in &records {
            for (what, found, expected) in [
                ("version", &record.version, &first.version),
                ("study", &record.inputs_blake3, &first.inputs_blake3),
                ("number of shards", &record.of.to_string(), &first.of.to_string()),
            ] {
                if found != expected {
                    let [found, expected] = [found, expected].map(|text| text.chars().take(8).collect());
                    let (folder, first) = ((*folder).clone(), (*first_folder).clone());
                    return Err(ShardsError::OfOther { folder, what, found, first, expected });
                }
            }
            if let Some(known) = by_number.insert(record.shard, folder) {
                let folders = [known.clone(), (*folder).clone()];
                return Err(ShardsError::Twice { shard: record.shard, of: record.of, folders });
            }
        }
        let missing: Vec<u32> = (1..=first.of).filter(|shard| !by_number.contains_key(shard)).collect();
        if !missing.is_empty() {
            return Err(ShardsError::Missing { missing, of: first.of, study: first.study.clone() });
        }
        let folders = by_number.into_values().cloned().collect();
        Ok(Self { record: first.clone(), folders })
    }
}

/// The record of the start of the shard in `folder`.
fn read_record(folder: &Path) -> Result<ShardRecord, ResultsError> {
    let path = folder.join(SHARD_FILE);
    const MAX_BYTES: u64 = 1 << 20;
    let text = match loosepin_files::read_named(&path, MAX_BYTES) {
        Ok(text) => text,
        Err(source) => return Err(ResultsError::Read { path, source }),
    };
    let foreign = |reason: String| ResultsError::ForeignFile { path: path.clone(), reason };
    let record: ShardRecord = serde_json::from_slice(&text).map_err(|error| foreign(error.to_string()))?;
    match Shard::new(record.shard, record.of) {
        Some(_) => Ok(record),
        None => Err(foreign(format!("there is no shard {}/{}", record.shard, record.of))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(shard: u32) -> ShardRecord {
        ShardRecord {
            shard,
            of: 3,
            name: "worn pin".to_owned(),
            study: PathBuf::from("study.toml"),
            accuracy: vec!["3um".to_owned()],
            budget: None,
            inputs_blake3: "9f1c22d0a7".to_owned(),
            version: "0.3.7".to_owned(),
        }
    }

    fn written(desk: &tempfile::TempDir, name: &str, record: &ShardRecord) -> PathBuf {
        let folder = desk.path().join(name);
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(SHARD_FILE), serde_json::to_string(record).unwrap()).unwrap();
        folder
    }

    fn refused(folders: &[PathBuf], desk: &tempfile::TempDir) -> String {
        let message = ShardFolders::read(folders).unwrap_err().to_string();
        message.replace(&format!("{}/", desk.path().display()), "")
    }

    #[test]
    fn shards_that_do_not_belong_together_are_named() {
        let desk = tempfile::tempdir().unwrap();
        let [one, two, three] = [1, 2, 3].map(|shard| written(&desk, &format!("part{shard}"), &record(shard)));
        let all = ShardFolders::read(&[three.clone(), one.clone(), two.clone()]).unwrap();
        assert_eq!(all.folders, [one.clone(), two.clone(), three.clone()]);
        assert_eq!(refused(&[one.clone(), three.clone()], &desk), "1 of 3 shards is missing: 2/3");
        assert_eq!(refused(std::slice::from_ref(&two), &desk), "2 of 3 shards are missing: 1/3, 3/3");
        let again = written(&desk, "again", &record(2));
        assert_eq!(
            refused(&[one.clone(), two.clone(), again, three.clone()], &desk),
            "shard 2/3 is given twice: part2 and again"
        );
        for (other, words) in [
            (ShardRecord { inputs_blake3: "77aa".to_owned(), ..record(3) }, "study (77aa) than part1 (9f1c22d0)"),
            (ShardRecord { version: "0.3.8".to_owned(), ..record(3) }, "version (0.3.8) than part1 (0.3.7)"),
            (ShardRecord { of: 4, ..record(3) }, "number of shards (4) than part1 (3)"),
        ] {
            let other = written(&desk, "other", &other);
            let message = refused(&[one.clone(), two.clone(), other], &desk);
            assert_eq!(message, format!("other belongs to another {words}"));
        }
        for odd in [ShardRecord { shard: 0, ..record(3) }, ShardRecord { shard: 4, ..record(3) }] {
            let message = refused(&[one.clone(), two.clone(), three.clone(), written(&desk, "odd", &odd)], &desk);
            assert!(message.ends_with(&format!("there is no shard {}/3", odd.shard)), "{message}");
        }
        let empty = desk.path().join("empty");
        std::fs::create_dir_all(&empty).unwrap();
        let message = refused(&[one, empty], &desk);
        assert_eq!(
            message,
            "empty is not the folder of a shard: cannot read empty/shard.json: there is no such file or folder"
        );
    }
}
