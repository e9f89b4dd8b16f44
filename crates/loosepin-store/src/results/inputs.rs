//! The inputs of a result as one hash.

use std::fmt;

use super::kind::ResultKind;

/// BLAKE3 of all inputs of a result: the contents of the files, settings, set values, kind and version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InputsHash(blake3::Hash);

impl InputsHash {
    /// The first eight hexadecimal digits, which name a folder.
    pub fn short(&self) -> String {
        self.to_string().chars().take(8).collect()
    }
}

/// All 64 hexadecimal digits.
impl fmt::Display for InputsHash {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0.to_hex())
    }
}

/// Adds up inputs. The same parts in the same order give the same hash on every machine.
#[derive(Debug, Clone)]
pub struct InputsHasher(blake3::Hasher);

impl InputsHasher {
    /// Begins with the kind of the result and the version of the program.
    pub fn new(kind: ResultKind) -> Self {
        let mut hasher = Self(blake3::Hasher::new());
        hasher.add("kind", kind.words()).add("version", loosepin_text::VERSION);
        hasher
    }

    /// Adds a part under its name. Lengths go in as well, so that parts cannot run into each other.
    pub fn add(&mut self, name: &str, contents: impl AsRef<[u8]>) -> &mut Self {
        for bytes in [name.as_bytes(), contents.as_ref()] {
            self.0.update(&(bytes.len() as u64).to_le_bytes());
            self.0.update(bytes);
        }
        self
    }

    /// Adds a number by its bits.
    pub fn add_number(&mut self, name: &str, value: f64) -> &mut Self {
        self.add(name, value.to_bits().to_le_bytes())
    }

    /// The hash of all parts.
    pub fn finish(&self) -> InputsHash {
        InputsHash(self.0.finalize())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_parts_do_not_run_into_each_other() {
        let of = |parts: &[(&str, &str)]| {
            let mut hasher = InputsHasher::new(ResultKind::Simulation);
            parts.iter().for_each(|(name, contents)| {
                hasher.add(name, contents);
            });
            hasher.finish()
        };
        assert_eq!(of(&[("set", "a=1")]), of(&[("set", "a=1")]));
        assert_ne!(of(&[("set", "a=1"), ("set", "b=2")]), of(&[("set", "a=1b=2")]));
        assert_ne!(of(&[("ab", "c")]), of(&[("a", "bc")]));
        assert_ne!(InputsHasher::new(ResultKind::Motion).finish(), InputsHasher::new(ResultKind::Study).finish());
        assert_eq!(of(&[]).short().len(), 8);
    }
}
