//! The normal distribution cut to an interval.

use super::{Family, MIN_SHARE_KEPT, Tails, finite, ordered, positive};
use crate::functions::normal::{normal_cdf, normal_quantile};
use crate::variables::distribution::DistributionError;

/// Cuts narrower than this, in standard deviations before the cut, have their moments from a power series.
const NARROW: f64 = 1.0;
/// Terms of that series: enough for the last digit wherever a cut keeps more than `MIN_SHARE_KEPT`.
const SERIES_TERMS: usize = 64;

/// Mean and standard deviation before the cut to `lower` .. `upper`.
#[derive(Debug)]
pub struct TruncatedNormal {
    mean: f64,
    standard_deviation: f64,
    lower: f64,
    upper: f64,
    /// Φ at the lower end, 1 - Φ at the upper end, and what lies between.
    below: f64,
    above: f64,
    share: f64,
}

impl TruncatedNormal {
    pub fn try_new(mean: f64, standard_deviation: f64, lower: f64, upper: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        positive("standard deviation", standard_deviation)?;
        ordered(lower, upper)?;
        let (a, b) = ((lower - mean) / standard_deviation, (upper - mean) / standard_deviation);
        let (below, above) = (normal_cdf(a), normal_cdf(-b));
        // The difference is taken where both numbers are small.
        let share = if a > 0.0 { normal_cdf(-a) - above } else { normal_cdf(b) - below };
        if share < MIN_SHARE_KEPT {
            return Err(DistributionError::NothingKept { mean, standard_deviation, lower, upper, share });
        }
        Ok(Self { mean, standard_deviation, lower, upper, below, above, share })
    }

    /// Mean and variance of the truncated standard normal variable.
    fn moments(&self) -> (f64, f64) {
        if self.upper - self.lower < NARROW * self.standard_deviation {
            let middle = 0.5 * ((self.lower - self.mean) + (self.upper - self.mean)) / self.standard_deviation;
            narrow_moments(middle, 0.5 * (self.upper - self.lower) / self.standard_deviation)
        } else {
            let [a, b] = [self.lower, self.upper].map(|end| (end - self.mean) / self.standard_deviation);
            wide_moments(a, b, self.share)
        }
    }
}

/// With φ the density, a and b the ends and Z the share: m = (φ(a) - φ(b))/Z, v = 1 + (a φ(a) - b φ(b))/Z - m².
fn wide_moments(a: f64, b: f64, share: f64) -> (f64, f64) {
    let density = |x: f64| libm::exp(-0.5 * x * x) / (2.0 * core::f64::consts::PI).sqrt();
    let first = (density(a) - density(b)) / share;
    (first, 1.0 + (a * density(a) - b * density(b)) / share - first * first)
}

/// The same where the ends c - h and c + h are so near that the differences lose digits, by the power series of the density:
///
/// ```text
/// φ(c + t)/φ(c) = Σ a_n tⁿ,   a_0 = 1,   (n + 1) a_(n+1) = -c a_n - a_(n-1);   I_k = Σ a_n h^(n+k)/(n + k + 1) over even n + k
/// m = c + I_1/I_0,   v = I_2/I_0 - (I_1/I_0)²
/// ```
fn narrow_moments(middle: f64, half: f64) -> (f64, f64) {
    let mut integrals = [0.0; 3];
    // a_n hⁿ and the one before.
    let (mut term, mut before) = (1.0, 0.0);
    for n in 0..SERIES_TERMS {
        let order = n as f64;
        if n % 2 == 0 {
            integrals[0] += term / (order + 1.0);
            integrals[2] += term / (order + 3.0);
        } else {
            integrals[1] += term / (order + 2.0);
        }
        (term, before) = (-half * (middle * term + half * before) / (order + 1.0), term);
    }
    let [share, first, second] = integrals;
    let moved = half * first / share;
    (middle + moved, half * half * second / share - moved * moved)
}

impl Family for TruncatedNormal {
    fn mean(&self) -> f64 {
        self.mean + self.standard_deviation * self.moments().0
    }

    fn standard_deviation(&self) -> f64 {
        self.standard_deviation * self.moments().1.max(0.0).sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= self.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        if x >= self.upper {
            return Tails { below: 1.0, above: 0.0 };
        }
        let standard = (x - self.mean) / self.standard_deviation;
        if standard < 0.0 {
            Tails::at(((normal_cdf(standard) - self.below) / self.share).clamp(0.0, 1.0))
        } else {
            let above = ((normal_cdf(-standard) - self.above) / self.share).clamp(0.0, 1.0);
            Tails { below: 1.0 - above, above }
        }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let from_below = self.below + at.below * self.share;
        let standard = if from_below < 0.5 {
            normal_quantile(from_below)
        } else {
            -normal_quantile(self.above + at.above * self.share)
        };
        (self.mean + self.standard_deviation * standard).clamp(self.lower, self.upper)
    }
}

#[cfg(test)]
mod tests {
    use super::{Family, NARROW, TruncatedNormal, narrow_moments, wide_moments};

    /// Half widths of narrow cuts, in standard deviations, and their middles.
    const HALF_WIDTHS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-7];
    const MIDDLES: [f64; 4] = [0.0, 1.5, -3.0, 6.0];

    #[test]
    fn analytic_narrow_cuts_scatter_like_a_uniform_distribution_and_its_next_term() {
        // With φ(c + t) ~ exp(-c t - t²/2) on |t| <= h: mean c - c h²/3, variance h²/3 (1 - h² (2 + 3 c²)/15), up to terms (h c)⁴.
        const ROUND_OFF: f64 = 1e-13;
        for (h, c) in HALF_WIDTHS.into_iter().flat_map(|h| MIDDLES.map(|c| (h, c))) {
            let cut = TruncatedNormal::try_new(0.0, 1.0, c - h, c + h).unwrap();
            // The ends are rounded: what the family was told.
            let (h, c) = (0.5 * (cut.upper - cut.lower), 0.5 * (cut.upper + cut.lower));
            let left_out = (h * (1.0 + c.abs())).powi(4) + ROUND_OFF;
            let variance = h * h / 3.0 * (1.0 - h * h * (2.0 + 3.0 * c * c) / 15.0);
            let deviation = cut.standard_deviation();
            assert!((deviation / variance.sqrt() - 1.0).abs() < left_out, "{c} ± {h}: {deviation} {}", variance.sqrt());
            let moved = cut.mean() - c;
            let error = (moved + c * h * h / 3.0).abs();
            assert!(error < h * (h * (1.0 + c.abs())).powi(3) + c.abs() * f64::EPSILON, "{c} ± {h}: {moved}");
        }
    }

    #[test]
    fn identity_the_series_is_the_closed_form_where_neither_loses_digits() {
        const TOLERANCE: f64 = 1e-12;
        for middle in [0.0, -0.3, 1.5, 3.0] {
            let (a, b) = (middle - 0.5 * NARROW, middle + 0.5 * NARROW);
            let cut = TruncatedNormal::try_new(0.0, 1.0, a, b).unwrap();
            let (series, closed) = (narrow_moments(middle, 0.5 * NARROW), wide_moments(a, b, cut.share));
            assert!((series.0 - closed.0).abs() < TOLERANCE, "{middle}: {series:?} {closed:?}");
            assert!((series.1 / closed.1 - 1.0).abs() < TOLERANCE, "{middle}: {series:?} {closed:?}");
        }
    }
}
