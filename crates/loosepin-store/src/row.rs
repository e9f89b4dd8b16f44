//! A finished run as bytes, with its checksum.

/// The first 128 bits of a BLAKE3 hash of all inputs of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InputsKey(pub [u8; 16]);

/// A finished run.
#[derive(Debug, Clone)]
pub struct StoredRun {
    /// Its inputs.
    pub inputs: InputsKey,
    /// Its results, or the number of the reason why it failed.
    pub outcome: Result<Vec<f64>, u16>,
}

impl InputsKey {
    /// The key of these bytes.
    pub fn of(bytes: &[u8]) -> Self {
        Self(first_half(blake3::hash(bytes).as_bytes()))
    }
}

impl StoredRun {
    /// Whether it is the same, bit for bit.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.inputs == other.inputs
            && self.outcome.as_ref().err() == other.outcome.as_ref().err()
            && self.bytes() == other.bytes()
    }

    /// The numbers as bytes, little-endian; empty for a failed run.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.outcome.iter().flatten().flat_map(|value| value.to_le_bytes()).collect()
    }

    /// The numbers that these bytes are; `None` if they are none.
    pub(super) fn numbers(bytes: &[u8]) -> Option<Vec<f64>> {
        let (numbers, rest) = bytes.as_chunks::<8>();
        rest.is_empty().then(|| numbers.iter().map(|number| f64::from_le_bytes(*number)).collect())
    }
}

/// Checksum of a row: its list and place, the key of its inputs, the reason of failure, its numbers.
pub(super) fn checksum(list: u32, place: u64, inputs: &[u8], failure: Option<u16>, numbers: &[u8]) -> [u8; 16] {
    let mut hasher = blake3::Hasher::new();
    hasher.update(&list.to_le_bytes()).update(&place.to_le_bytes()).update(inputs);
    // One byte more than the number, so that no reason is not the reason 0.
    hasher.update(&failure.map_or([0; 3], |reason| [1, reason.to_le_bytes()[0], reason.to_le_bytes()[1]]));
    hasher.update(numbers);
    first_half(hasher.finalize().as_bytes())
}

fn first_half(hash: &[u8; 32]) -> [u8; 16] {
    std::array::from_fn(|k| hash[k])
}
