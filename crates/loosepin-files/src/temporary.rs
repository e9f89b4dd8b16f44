//! Names of files that are not whole yet.

use std::ffi::OsStr;
use std::io;

const BEGINNING: &str = ".loosepin-";
const END: &str = ".partial";
/// What SQLite adds to the name of a database that it writes.
const JOURNAL: &str = "-journal";
/// Hexadecimal digits between them: 64 random bits.
const DIGITS: usize = 16;

/// Under which lock a temporary file was made. Taking a lock removes those of its own kind: a writer under the other lock of the folder
/// may be at work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TemporaryKind {
    /// The lock of a folder of results.
    Result,
    /// The lock for the moment in which texts are written.
    Text,
    /// None: a file that loses its name at once.
    Unnamed,
}

impl TemporaryKind {
    const ALL: [Self; 3] = [Self::Result, Self::Text, Self::Unnamed];

    fn infix(self) -> &'static str {
        match self {
            Self::Result => "",
            Self::Text => "text-",
            Self::Unnamed => "unnamed-",
        }
    }

    /// A new name. It is random: no other process has or can predict it.
    pub(crate) fn new_name(self) -> io::Result<String> {
        Ok(format!("{BEGINNING}{}{:0DIGITS$x}{END}", self.infix(), random()?))
    }

    /// The kind of a temporary name; `None` for any other name.
    pub fn of(name: &OsStr) -> Option<Self> {
        let name = name.to_str()?;
        let middle = name.strip_suffix(JOURNAL).unwrap_or(name).strip_prefix(BEGINNING)?.strip_suffix(END)?;
        let is_random = |digits: &str| digits.len() == DIGITS && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        Self::ALL.into_iter().find(|kind| middle.strip_prefix(kind.infix()).is_some_and(is_random))
    }
}

/// A random number from the operating system.
pub(crate) fn random() -> io::Result<u64> {
    getrandom::u64().map_err(|error| io::Error::other(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temporary_names_are_known_again_and_differ() {
        for kind in TemporaryKind::ALL {
            let [one, other] = [kind.new_name().unwrap(), kind.new_name().unwrap()];
            assert_ne!(one, other);
            for name in [&one, &format!("{one}-journal")] {
                assert_eq!(TemporaryKind::of(OsStr::new(name)), Some(kind), "{name}");
            }
        }
        for name in ["model.toml.partial", ".loosepin-12.partial", ".loosepin-000000000000000g.partial", "my.partial"] {
            assert_eq!(TemporaryKind::of(OsStr::new(name)), None, "{name}");
        }
    }
}
