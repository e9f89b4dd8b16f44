//! Random choices that belong to a seed and an index, not to an order of problems.

use loosepin_uncertainty::{hash, normal, uniform};

/// A stream of choices: the next one belongs to the key and to how many were made before.
pub struct Draw {
    key: u64,
    made: u64,
}

impl Draw {
    /// The stream of problem `index` of `seed`.
    pub fn new(seed: u64, index: u64) -> Self {
        Self { key: hash(hash(0x6672_6573_6820_7072, seed), index), made: 0 }
    }

    /// 64 bits, as a key for further numbers.
    pub fn key(&mut self) -> u64 {
        self.made += 1;
        hash(self.key, self.made)
    }

    /// Uniform in (0, 1).
    pub fn fraction(&mut self) -> f64 {
        self.made += 1;
        uniform(self.key, self.made)
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.fraction()
    }

    /// Between two positive numbers, its logarithm uniform.
    pub fn of_size(&mut self, low: f64, high: f64) -> f64 {
        libm::exp(self.between(libm::log(low), libm::log(high)))
    }

    /// Standard normal.
    pub fn normal(&mut self) -> f64 {
        self.made += 1;
        normal(self.key, self.made)
    }

    /// 0, 1, … `count - 1`.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.fraction() * count as f64) as usize).min(count - 1)
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.fraction() < probability
    }

    /// -1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// One of these.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}
