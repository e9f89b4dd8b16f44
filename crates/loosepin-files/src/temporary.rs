//! Names of files that are not whole yet.

use std::ffi::OsStr;
use std::io;

const BEGINNING: &str = ".loosepin-";
const END: &str = ".partial";
/// Hexadecimal digits between them: 64 random bits.
const DIGITS: usize = 16;

/// A random number from the operating system.
pub(crate) fn random() -> io::Result<u64> {
    getrandom::u64().map_err(|error| io::Error::other(error.to_string()))
}

/// A new name. Nobody else has it, and nobody can foresee it.
pub(crate) fn temporary_name() -> io::Result<String> {
    Ok(format!("{BEGINNING}{:0DIGITS$x}{END}", random()?))
}

/// Whether a name is one of those that files and folders have until they are whole. These names are reserved: what has one goes when
/// the folder is written into the next time.
pub fn is_temporary(name: &OsStr) -> bool {
    let digits = name.to_str().and_then(|name| name.strip_prefix(BEGINNING)?.strip_suffix(END));
    digits.is_some_and(|digits| digits.len() == DIGITS && digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temporary_names_are_known_again_and_differ() {
        let [one, other] = [temporary_name().unwrap(), temporary_name().unwrap()];
        assert_ne!(one, other);
        assert!(is_temporary(OsStr::new(&one)) && is_temporary(OsStr::new(&other)));
        for name in ["model.toml.partial", ".loosepin-12.partial", ".loosepin-000000000000000g.partial", "my.partial"] {
            assert!(!is_temporary(OsStr::new(name)), "{name}");
        }
    }
}
