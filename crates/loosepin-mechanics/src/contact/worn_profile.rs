//! Depth of a worn surface as a smooth periodic function of the angle.

use std::f64::consts::TAU;

/// Depth H of a worn surface: a uniform periodic cubic B-spline whose control values are the depths of the sectors.
///
/// It has two continuous derivatives, is never negative where the depths are not, and its mean is theirs exactly.
#[derive(Debug, Clone)]
pub struct WornProfile {
    depths_m: Vec<f64>,
    is_unworn: bool,
}

/// Weights of four sectors in a row in the value of a spline and in its first two derivatives over the angle.
#[derive(Debug, Clone, Copy)]
pub struct Weights {
    /// Offset of the first of the four sectors from the current sector, from 0 up to their number.
    shift: usize,
    /// Values.
    pub value: [f64; 4],
    slope_1_rad: [f64; 4],
    bend_1_rad2: [f64; 4],
}

/// `place` less `count` where it is past the last sector, below 2 `count`: a division would take longer than the rest of a sector.
#[inline]
pub(super) fn wrapped(place: usize, count: usize) -> usize {
    if place < count { place } else { place - count }
}

impl Weights {
    /// At the middles of the sectors of another surface whose frame is turned by `turn_rad` from that of the profile.
    pub fn at(turn_rad: f64, sectors: usize) -> Self {
        let per_rad = sectors as f64 / TAU;
        let turn = turn_rad * per_rad;
        let whole = turn.floor();
        let u = turn - whole;
        let v = 1.0 - u;
        // Sectors -1, 0, 1 and 2 from the one below.
        let value = [v * v * v, 3.0 * u * u * (u - 2.0) + 4.0, 3.0 * v * v * (v - 2.0) + 4.0, u * u * u];
        let slope = [-v * v, u * (3.0 * u - 4.0), -v * (3.0 * v - 4.0), u * u];
        let bend = [v, 3.0 * u - 2.0, 3.0 * v - 2.0, u];
        // Whole turns may be many: the sector counts within one.
        let shift = (whole - 1.0).rem_euclid(sectors as f64) as usize % sectors;
        Self {
            shift,
            value: value.map(|weight| weight / 6.0),
            slope_1_rad: slope.map(|weight| 0.5 * weight * per_rad),
            bend_1_rad2: bend.map(|weight| weight * per_rad * per_rad),
        }
    }

    /// The four sectors beside a sector of the other surface, of `count` on each.
    pub fn sectors(&self, sector: usize, count: usize) -> [usize; 4] {
        let first = wrapped(sector + self.shift, count);
        [0, 1, 2, 3].map(|k| wrapped(first + k, count))
    }
}

impl WornProfile {
    /// Without wear.
    pub fn unworn(sectors: usize) -> Self {
        Self { depths_m: vec![0.0; sectors], is_unworn: true }
    }

    /// With these depths, m.
    pub fn new(depths_m: Vec<f64>) -> Self {
        let is_unworn = depths_m.iter().all(|depth_m| *depth_m == 0.0);
        Self { depths_m, is_unworn }
    }

    /// Whether all depths are zero.
    pub fn is_unworn(&self) -> bool {
        self.is_unworn
    }

    /// H at the middle of a sector, m.
    pub fn at_middle_m(&self, sector: usize) -> f64 {
        let count = self.depths_m.len();
        let depth_m = |offset: usize| self.depths_m[(sector + offset) % count];
        (depth_m(count - 1) + 4.0 * depth_m(0) + depth_m(1)) / 6.0
    }

    /// H, H' and H'' at the middle of a sector of the other surface: m, m/rad, m/rad².
    pub fn jet(&self, sector: usize, weights: &Weights) -> [f64; 3] {
        let depths_m = weights.sectors(sector, self.depths_m.len()).map(|own| self.depths_m[own]);
        let sum = |weights: &[f64; 4]| weights.iter().zip(depths_m).map(|(weight, depth_m)| weight * depth_m).sum();
        [sum(&weights.value), sum(&weights.slope_1_rad), sum(&weights.bend_1_rad2)]
    }
}
