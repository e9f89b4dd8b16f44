//! Random numbers of the tests.

use crate::build::v;
use loosepin_space::Vec3;

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, 2014).
pub struct Random(pub u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }
    /// Between -1 and 1.
    pub fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
    /// Between two numbers.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * 0.5 * (self.number() + 1.0)
    }
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }
    /// Components between -1 and 1.
    pub fn vector(&mut self) -> Vec3 {
        v(self.number(), self.number(), self.number())
    }
    pub fn direction(&mut self) -> Vec3 {
        self.vector().normalised().unwrap_or(Vec3::Z)
    }
}
