//! Exact bounds of statistics from the ends of m, s and k.

use super::brute::{Curve, extremes};
use super::draw::Draw;
use super::law::Law;
use loosepin_bounds::Statistic;
use loosepin_uncertainty::normal_cdf;
use std::f64::consts::FRAC_2_PI;

/// A statistic with its exact bounds.
#[derive(Debug, Clone, Copy)]
pub struct Exact {
    pub statistic: Statistic,
    /// Its least and its greatest value.
    pub ends: [f64; 2],
    /// Of the response: round-off is a share of it.
    pub magnitude: f64,
}

/// Ends of what a response is made of; each of them is attained with each of the others.
#[derive(Debug, Clone)]
pub struct Corners<'a> {
    pub law: &'a Law,
    /// Of m.
    pub location: [f64; 2],
    /// Of |s|.
    pub spread: [f64; 2],
    /// Of the shape of Z.
    pub shape: [f64; 2],
    /// Whether m and s take every value between their ends.
    pub is_continuous: bool,
}

impl Exact {
    /// By how much a widened bound lies inside of the exact one, at the lower and at the upper end; none where it does not, but for round-off.
    pub fn missed_by(&self, widened: [f64; 2]) -> [Option<f64>; 2] {
        /// Shares of the exact width and of the response.
        const ROUND_OFF: [f64; 2] = [1e-9, 1e-12];
        let allowed = (ROUND_OFF[0] * (self.ends[1] - self.ends[0])).max(ROUND_OFF[1] * self.magnitude);
        [widened[0] - self.ends[0], self.ends[1] - widened[1]].map(|inside| (inside > allowed).then_some(inside))
    }

    /// The statistic without its numbers.
    pub fn name(&self) -> String {
        match self.statistic {
            Statistic::ProbabilityAbove(_) => "P(Y > L)".to_owned(),
            Statistic::ProbabilityBeyond(_) => "P(|Y| > L)".to_owned(),
            Statistic::Quantile(p) => format!("quantile {p}"),
            Statistic::Mean => "mean".to_owned(),
            Statistic::StandardDeviation => "deviation".to_owned(),
            other => format!("{other:?}"),
        }
    }
}

/// P(m + s Z > limit); of s = 0 too, for laws whose Z is symmetric.
fn above(law: &Law, limit: f64, m: f64, s: f64, k: f64) -> f64 {
    match s > 0.0 {
        true => law.above(k, (limit - m) / s),
        false => f64::from(u8::from(m > limit)),
    }
}

impl Corners<'_> {
    /// A statistic that rises or falls all the way with each of m, s and k.
    fn at_corners(&self, value: &dyn Fn(f64, f64, f64) -> f64) -> [f64; 2] {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for m in self.location {
            for s in self.spread {
                for k in self.shape {
                    let value = value(m, s, k);
                    ends = [ends[0].min(value), ends[1].max(value)];
                }
            }
        }
        ends
    }

    /// Round-off of responses is a share of this.
    fn magnitude(&self) -> f64 {
        let deviations = self.shape.map(|k| self.law.standard_deviation(k));
        self.furthest() + self.spread[1] * deviations[0].max(deviations[1])
    }

    fn furthest(&self) -> f64 {
        self.location[0].abs().max(self.location[1].abs())
    }

    /// The least |m| where m takes every value between its ends.
    fn nearest(&self) -> f64 {
        let [low, high] = self.location;
        if low < 0.0 && high > 0.0 { 0.0 } else { low.abs().min(high.abs()) }
    }

    /// Probability that m + s Z is on the other side of 0 than m, where m is nearest to 0 and s greatest.
    pub fn folded_share(&self) -> f64 {
        let z = -self.nearest() / self.spread[1];
        // On the side of m that is nearer to 0.
        if self.location[0] >= 0.0 { 1.0 - self.law.above(self.shape[0], z) } else { self.law.above(self.shape[0], -z) }
    }

    /// Bounds of statistics of m + s Z where every corner is attained.
    pub fn of_sum(&self, draw: &mut Draw) -> Vec<Exact> {
        let mut all = self.of_place(draw, |value| self.at_corners(value));
        if self.law.is_symmetric() && self.is_continuous {
            let (statistic, ends) = self.beyond(draw);
            all.push(Exact { statistic, ends, magnitude: self.magnitude() });
        }
        all
    }

    /// Bounds of statistics of m + s Z; `ends` has the extremes of a function of m, s and k.
    pub fn of_place(
        &self,
        draw: &mut Draw,
        mut ends: impl FnMut(&dyn Fn(f64, f64, f64) -> f64) -> [f64; 2],
    ) -> Vec<Exact> {
        let law = self.law;
        let between = |draw: &mut Draw, [low, high]: [f64; 2]| draw.between(low, high);
        // A limit that is exceeded with this probability where m, s and k are somewhere between their ends.
        let p = draw.one_of(&[0.5, 0.1, 0.02, 0.003]);
        let (m, s, k) = (between(draw, self.location), between(draw, self.spread), between(draw, self.shape));
        let limit = m + s * law.quantile(k, 1.0 - p);
        let mut all = vec![
            (Statistic::Mean, ends(&|m, s, k| m + s * law.mean(k))),
            (Statistic::StandardDeviation, ends(&|_, s, k| s * law.standard_deviation(k))),
            (Statistic::ProbabilityAbove(limit), ends(&|m, s, k| above(law, limit, m, s, k))),
        ];
        for p in [0.025, 0.5, 0.975] {
            // Of a shape that does not change it is needed once.
            let constant = law.quantile(self.shape[0], p);
            let quantile = |k: f64| if k == self.shape[0] { constant } else { law.quantile(k, p) };
            all.push((Statistic::Quantile(p), ends(&|m, s, k| m + s * quantile(k))));
        }
        all.into_iter().map(|(statistic, ends)| Exact { statistic, ends, magnitude: self.magnitude() }).collect()
    }

    /// P(|m + s Z| > limit) of a symmetric Z with one peak, with a limit above the greatest |m|: it rises with |m| and with s.
    fn beyond(&self, draw: &mut Draw) -> (Statistic, [f64; 2]) {
        let (law, k) = (self.law, self.shape[0]);
        let limit = self.furthest() + self.spread[1] * draw.between(0.0, 2.0) * law.quantile(k, 0.9);
        let beyond = |m: f64, s: f64| above(law, limit, m, s, k) + above(law, limit, -m, s, k);
        let ends = [beyond(self.nearest(), self.spread[0]), beyond(self.furthest(), self.spread[1])];
        (Statistic::ProbabilityBeyond(limit), ends)
    }

    /// Bounds of statistics of |m + s Z|, m and s continuous, for laws that have [`Law::folded`].
    pub fn of_absolute(&self, draw: &mut Draw) -> Vec<Exact> {
        let law = self.law;
        let at = |[low, high]: [f64; 2], t: f64| low + (high - low) * t;
        let moments = |t: &[f64]| law.folded(at(self.location, t[0]), at(self.spread, t[1]));
        // Where m + s z = 0 for a value z of a discrete Z there is a crease.
        let crease = |z: f64| -> Curve {
            let (location, spread) = (self.location, self.spread);
            Box::new(move |t| {
                let m = -z * at(spread, t);
                vec![((m - location[0]) / (location[1] - location[0])).clamp(0.0, 1.0), t]
            })
        };
        let creases: Vec<Curve> = match law {
            Law::Discrete { values, .. } => values.iter().map(|z| crease(*z)).collect(),
            _ => vec![crease(0.0)],
        };
        let ends = |of: &dyn Fn(&[f64]) -> f64| extremes(of, 2, &[], &creases).map(|end| end.value);
        let mut all =
            vec![(Statistic::Mean, ends(&|t| moments(t)[0])), (Statistic::StandardDeviation, ends(&|t| moments(t)[1]))];
        if law.is_symmetric() {
            let (statistic, ends) = self.beyond(draw);
            let Statistic::ProbabilityBeyond(limit) = statistic else { unreachable!("a probability beyond a limit") };
            all.push((Statistic::ProbabilityAbove(limit), ends));
        }
        all.into_iter().map(|(statistic, ends)| Exact { statistic, ends, magnitude: self.magnitude() }).collect()
    }
}

impl Law {
    /// Whether [`Law::folded`] knows the moments.
    pub fn has_folded(&self) -> bool {
        matches!(self, Self::Sum(_) | Self::Chaotic { .. } | Self::Discrete { .. })
    }

    /// Mean and standard deviation of |m + s Z|.
    fn folded(&self, m: f64, s: f64) -> [f64; 2] {
        match self {
            Self::Discrete { values, probabilities } => {
                let each = || values.iter().zip(probabilities).map(|(z, p)| (p, (m + s * z).abs()));
                let mean: f64 = each().map(|(p, y)| p * y).sum();
                [mean, each().map(|(p, y)| p * (y - mean) * (y - mean)).sum::<f64>().sqrt()]
            }
            // The folded normal distribution (F. C. Leone, L. S. Nelson, R. B. Nottingham 1961).
            _ if s > 0.0 => {
                let z = m / s;
                let mean = s * FRAC_2_PI.sqrt() * libm::exp(-0.5 * z * z) + m * (1.0 - 2.0 * normal_cdf(-z));
                [mean, (m * m + s * s - mean * mean).max(0.0).sqrt()]
            }
            _ => [m.abs(), 0.0],
        }
    }
}
