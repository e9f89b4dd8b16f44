//! The share of the response inside a band, for every tested u.

use crate::data::bound::Witness;
use crate::estimators::estimate::Confidence;
use crate::estimators::pool::Pool;
use crate::estimators::probability::share;

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

/// P(Y in band | u) over the outer points: a correct band holds its share at every u.
///
/// Where u differs from mechanism to mechanism, a share of them as large as the mass of each focal element has its u somewhere in that
/// element. Then the least share inside is the sum of the least of each element, by mass.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// Every outer point, in the order of the outer index.
    pub points: Vec<CoveragePoint>,
    /// The least `lower` of all points; NaN if there are none.
    pub minimum: f64,
    /// How far the share there may lie above `minimum`: failed runs and sampling.
    pub minimum_error: f64,
    /// The greatest `upper` of all points; NaN if there are none.
    pub maximum: f64,
    /// The point where the minimum is attained; of several elements, in that of the largest mass.
    pub minimum_witness: Option<Witness>,
}

impl Coverage {
    /// The coverage of the band from `lower` to `upper` (both included) of `column`; `shares` are those of
    /// `Setup::shares_of_mechanisms`.
    pub(crate) fn of_band(
        pool: &Pool,
        column: usize,
        [lower, upper]: [f64; 2],
        shares: &[(f64, Vec<usize>)],
        confidence: &Confidence,
    ) -> Self {
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
        let mut coverage = Self { points, minimum: 0.0, minimum_error: 0.0, maximum: 0.0, minimum_witness: None };
        let mut heaviest = 0.0;
        for (mass, members) in shares {
            let of_element = || members.iter().map(|&member| (member, &coverage.points[member]));
            let least = of_element().min_by(|(_, a), (_, b)| a.lower.total_cmp(&b.lower));
            let greatest = of_element().map(|(_, point)| point.upper).max_by(f64::total_cmp);
            let error = |point: &CoveragePoint| (point.upper + point.sampling_error[1]).min(1.0) - point.lower;
            let witness = least.map(|(member, _)| pool.points[member].witness());
            let (least, error) = least.map_or((f64::NAN, 0.0), |(_, point)| (point.lower, error(point)));
            coverage.minimum += mass * least;
            coverage.minimum_error += mass * error;
            coverage.maximum += mass * greatest.unwrap_or(f64::NAN);
            if *mass > heaviest {
                (heaviest, coverage.minimum_witness) = (*mass, witness);
            }
        }
        coverage
    }
}
