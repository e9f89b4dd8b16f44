//! A four-bar with a ball at each end of its coupler, in closed form: what play and scatter make of the angle of its rocker.

use loosepin::uncertainty::{hash, normal};

pub(crate) const MM: f64 = 1e-3;

pub(crate) type Vector = [f64; 3];

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// A crank about z through the origin, a rocker about `axis` through `pivot_m`, and a coupler with a ball at each end, which at the start
/// closes the loop with the crank along x and the arm of the rocker along `arm`.
#[derive(Debug, Clone)]
pub(crate) struct FourBar {
    /// Lengths of crank, rocker and coupler, m, and their standard deviations.
    pub lengths_m: Vector,
    pub deviations_m: Vector,
    pub pivot_m: Vector,
    pub axis: Vector,
    pub arm: Vector,
    /// Of the two angles that close the loop the one with this sign.
    pub side: f64,
    /// Angles of the crank that are looked at, rad.
    pub angles_rad: Vec<f64>,
}

impl FourBar {
    /// The angle ψ of the rocker from its start, rad: with A the pin of the crank, D = A - pivot and f = axis × arm,
    ///
    /// ```text
    /// |D - k (arm cos ψ + f sin ψ)| = L:   ψ = atan2(D·f, D·arm) ± acos((D·D + k² - L²)/(2 k √((D·arm)² + (D·f)²)))
    /// ```
    ///
    /// and the argument of acos, which says how far the loop is from a dead centre.
    pub fn rocker(&self, [crank_m, rocker_m, coupler_m]: Vector, crank_rad: f64) -> (f64, f64) {
        let d = minus([crank_m * crank_rad.cos(), crank_m * crank_rad.sin(), 0.0], self.pivot_m);
        let (along, across) = (dot(d, self.arm), dot(d, cross(self.axis, self.arm)));
        let cosine = (dot(d, d) + rocker_m * rocker_m - coupler_m * coupler_m) / (2.0 * rocker_m * along.hypot(across));
        let angle = across.atan2(along) + self.side * cosine.acos();
        (angle.sin().atan2(angle.cos()), cosine)
    }

    /// Largest deviation over the cycle, rad, of a mechanism with these lengths whose coupler is longer by any of `longer_m` at each angle.
    pub fn largest(&self, [crank_m, rocker_m, coupler_m]: Vector, longer_m: &[f64]) -> f64 {
        let of = |angle: f64| {
            let nominal = self.rocker(self.lengths_m, angle).0;
            let at = |longer_m: &f64| (self.rocker([crank_m, rocker_m, coupler_m + longer_m], angle).0 - nominal).abs();
            longer_m.iter().map(at).fold(0.0, f64::max)
        };
        self.angles_rad.iter().map(|angle| of(*angle)).fold(0.0, f64::max)
    }

    /// Largest deviations of `count` drawn mechanisms, in increasing order.
    pub fn drawn(&self, count: u64, seed: u64, longer_m: &[f64]) -> Vec<f64> {
        self.drawn_with(count, seed, longer_m, |lengths_m| lengths_m)
    }

    /// [`Self::drawn`] where lengths follow from each other.
    pub fn drawn_with(
        &self,
        count: u64,
        seed: u64,
        longer_m: &[f64],
        following: impl Fn(Vector) -> Vector,
    ) -> Vec<f64> {
        let drawn = |mechanism: u64| {
            let length = |k: usize| self.lengths_m[k] + self.deviations_m[k] * normal(hash(seed, mechanism), k as u64);
            self.largest(following([0, 1, 2].map(length)), longer_m)
        };
        let mut all: Vec<f64> = (0..count).map(drawn).collect();
        all.sort_by(f64::total_cmp);
        all
    }
}

/// The value that `share` of these do not exceed.
pub(crate) fn quantile(increasing: &[f64], share: f64) -> f64 {
    increasing[((share * increasing.len() as f64) as usize).min(increasing.len() - 1)]
}
