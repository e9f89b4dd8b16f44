//! Mechanisms whose single runs went on as machine code lately: the next run of one changes over sooner, since its programs need not be
//! translated again.

use crate::lanes::programs::fixed;
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample};
use std::collections::VecDeque;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// How many are remembered.
const MAX_REMEMBERED: usize = 32;

/// Of this process, the oldest first.
static LATELY: Mutex<VecDeque<Fingerprint>> = Mutex::new(VecDeque::new());

fn lately() -> MutexGuard<'static, VecDeque<Fingerprint>> {
    LATELY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Tells mechanisms with different programs apart, in all likelihood: two that have the same one cost time, not a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fingerprint(u64);

impl Fingerprint {
    /// Of single runs of `mechanism` with the zeros and ones of `sample`. Runs by another method have the equations in common, which are most
    /// of their programs.
    pub fn new(mechanism: &Mechanism, sample: &Sample<f64>) -> Self {
        let mut hasher = DefaultHasher::new();
        for value in fixed(sample, &Arms::none()) {
            value.map(f64::to_bits).hash(&mut hasher);
        }
        mechanism.multiplications().to_bits().hash(&mut hasher);
        Self(hasher.finish())
    }

    /// Whether such a run went on as machine code lately.
    pub fn is_known(self) -> bool {
        lately().contains(&self)
    }

    /// Remembers that one did.
    pub fn remember(self) {
        let mut lately = lately();
        if lately.contains(&self) {
            return;
        }
        if lately.len() == MAX_REMEMBERED {
            lately.pop_front();
        }
        lately.push_back(self);
    }
}
