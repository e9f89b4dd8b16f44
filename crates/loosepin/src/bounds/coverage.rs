//! How much of the response a band holds, for every u that was looked at.

use super::bound::Witness;
use super::pool::Pool;
use super::probability::share;
use super::sample::Confidence;

/// P(Y in band | u) at one outer point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoveragePoint {
    /// Outer index.
    pub point: u32,
    /// The share with every failed run taken as outside.
    pub lower: f64,
    /// The share with every failed run taken as inside.
    pub upper: f64,
    /// Sampling error downwards from `lower` and upwards from `upper`, at the stated confidence.
    pub sampling_error: [f64; 2],
}

/// P(Y in band | u) over the outer points: a band that holds what it says holds it at every u.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// Every outer point, in the order of the outer index.
    pub points: Vec<CoveragePoint>,
    /// The least `lower` of all points; not a number without points.
    pub minimum: f64,
    /// The greatest `upper` of all points; not a number without points.
    pub maximum: f64,
    /// Where the minimum is attained.
    pub minimum_witness: Option<Witness>,
    /// Where the maximum is attained.
    pub maximum_witness: Option<Witness>,
}

impl Coverage {
    /// The coverage of the band from `lower` to `upper` (both included) of `column`.
    pub(super) fn of_band(pool: &Pool, column: usize, lower: f64, upper: f64, confidence: &Confidence) -> Self {
        let points: Vec<CoveragePoint> = pool
            .samples(column)
            .into_iter()
            .zip(&pool.points)
            .map(|(sample, point)| {
                let inside = share(sample, confidence, |value| value >= lower && value <= upper);
                CoveragePoint {
                    point: point.point,
                    lower: inside.low.value,
                    upper: inside.high.value,
                    sampling_error: [inside.low.below, inside.high.above],
                }
            })
            .collect();
        let least = points.iter().enumerate().min_by(|(_, a), (_, b)| a.lower.total_cmp(&b.lower));
        let greatest = points.iter().enumerate().rev().max_by(|(_, a), (_, b)| a.upper.total_cmp(&b.upper));
        let witness = |found: Option<(usize, &CoveragePoint)>| found.map(|(index, _)| pool.points[index].witness());
        Self {
            minimum: least.map_or(f64::NAN, |(_, point)| point.lower),
            maximum: greatest.map_or(f64::NAN, |(_, point)| point.upper),
            minimum_witness: witness(least),
            maximum_witness: witness(greatest),
            points,
        }
    }
}
