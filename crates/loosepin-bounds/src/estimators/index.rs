//! The index of a probability: searched in place of the probability, since it has a slope where the probability is flat at 0 or 1.
//!
//! ```text
//! x = asinh z,   z = Φ⁻¹(P)
//! ```
//!
//! The inverse hyperbolic sine keeps the spikes down that z has where the response hardly scatters. Elsewhere z itself is the smoother
//! one of the two: a model takes the scale in which the values are likelier.

use super::polynomials::orthogonal::Axis;
use loosepin_uncertainty::{normal_cdf, normal_quantile};

/// Largest z at which probabilities are distinguished.
const MAX_INDEX: f64 = 40.0;
/// Steps of the index that are always worth a point: deep in a tail it only has to show the direction.
const COARSEST_INDEX: f64 = 0.1;

/// asinh z
pub(crate) fn compressed(z: f64) -> f64 {
    libm::asinh(z.clamp(-MAX_INDEX, MAX_INDEX))
}

/// The index of the probability of an event ([`super::polynomials::smooth::Smooth::index`]).
#[derive(Debug, Clone, Copy)]
pub(crate) enum Index {
    OfOne(f64),
    /// Of two events that exclude each other.
    OfEither([f64; 2]),
}

impl Index {
    /// The index of the event.
    pub fn value(self) -> f64 {
        match self {
            Self::OfOne(index) => index,
            Self::OfEither([a, b]) => index_of_either(a, b),
        }
    }

    /// The indices of the two events, if there are two.
    pub fn sides(self) -> Option<[f64; 2]> {
        match self {
            Self::OfOne(_) => None,
            Self::OfEither(sides) => Some(sides),
        }
    }
}

/// The index of the probability of either of two events that exclude each other, from theirs, z = sinh x of each:
///
/// ```text
/// Φ⁻¹(Φ(z_a) + Φ(z_b)),   the greater of the two where numbers are too small for the sum, the largest one where there is no rest
/// ```
pub(crate) fn index_of_either(a: f64, b: f64) -> f64 {
    let [most, least] = [a.max(b), a.min(b)].map(libm::sinh);
    let share = normal_cdf(most) + normal_cdf(least);
    // What neither has, without the round-off of 1 - Φ.
    let rest = normal_cdf(-most) - normal_cdf(least);
    let z = if share <= 0.0 {
        most
    } else if share < 0.5 {
        normal_quantile(share)
    } else if rest > 0.0 {
        -normal_quantile(rest)
    } else {
        MAX_INDEX
    };
    compressed(z)
}

/// The probability with this index ([`super::polynomials::smooth::Smooth::index`]), where it is neither below ε nor above 1 - ε.
pub(crate) fn probability_of_index(index: f64) -> f64 {
    normal_cdf(libm::sinh(index))
}

/// Change of the index for a `change` of the probability, at a given index.
pub(crate) fn index_resolution(index: f64, change: f64) -> f64 {
    let z = libm::sinh(index);
    let slope = Axis::Hermite.density(z) * libm::cosh(index);
    (change / slope.max(f64::MIN_POSITIVE)).min(COARSEST_INDEX)
}
