//! Likelihood of a measurement at one value of the unknowns, from its runs.
//!
//! ```text
//! p(y | u) = 2^-m ∫ t(x(y, s); ν, mean, Σ) |dx/dy| ds    over s in [-1, 1]^m
//! t = Γ((ν + p)/2)/(Γ(ν/2) (ν π)^(p/2) |Σ|^(1/2)) (1 + (x - mean)ᵀ Σ⁻¹ (x - mean)/ν)^(-(ν + p)/2)
//! ν = n - p    Σ = C (n - 1)(n + 1)/(n ν)
//! ```
//!
//! x are the p features without their common errors s, in logarithms where these are taken; mean and C are mean and covariance of the n
//! runs, which hold the scatter of random inputs and the independent errors. Common errors of the m instruments are uniform and
//! independent. Were mean and covariance known, x would be normal (synthetic likelihood: S. N. Wood, "Statistical inference for noisy
//! nonlinear ecological dynamic systems", Nature 466 (2010) 1102-1104). They are those of n draws: a further draw has Student's distribution
//! (S. Geisser, J. Cornfield, "Posterior distributions for multivariate normal parameters", Journal of the Royal Statistical Society B 25
//! (1963) 368-376, with their prior |covariance|^(-(p+1)/2)).

use super::scatter::{Observation, Scatter, symmetric};
use loosepin_math::dense::Cholesky;
use loosepin_math::legendre_rule;
use loosepin_uncertainty::{normal_cdf, normal_quantile};
use std::f64::consts::{LN_2, PI, TAU};

/// Runs for each feature, at least: with fewer the covariance is not known.
pub(crate) const RUNS_A_FEATURE: usize = 10;
/// Points of the integral over the common errors: Gauss's for one instrument, a lattice for several.
const POINTS_OF_ONE: usize = 96;
const POINTS_OF_SEVERAL: usize = 1024;
/// Standard deviations of a common error on either side of its nearest value that are integrated over, by the normal distribution that is as
/// curved there. Along one common error t is Student's distribution with n - 1 degrees of freedom, of which P(|T| > 12 sqrt((n - 1)/n)) lies
/// beyond: 3.4e-6 of 9 runs, the fewest that a posterior is given with, 1.2e-6 of 10, and less of more.
const REACH: f64 = 12.0;
/// Least second derivative of half the square of the distance along a common error. A share of a feature that was measured as 0 moves nothing:
/// it is drawn evenly, as of a normal distribution a million times as wide as the box.
const MIN_CURVATURE: f64 = 1e-12;

/// ln p(y | u); nothing where no more runs ended than there are features, -∞ where it is below the smallest number.
pub(crate) fn log_likelihood(runs: &[Vec<f64>], seen: &Observation) -> Option<f64> {
    let scatter = Scatter::new(runs, seen)?;
    let student = Student::new(scatter.rows.len(), seen.values_si.len())?;
    let movable = seen.movable();
    if movable.is_empty() {
        return Some(student.log_density(&scatter, seen, &vec![0.0; seen.instrument_count()]));
    }
    let near = NearestNormal::new(&scatter, &student, seen, movable);
    let instruments = seen.instrument_count();
    let logs: Vec<f64> = match near.movable[..] {
        [only] => {
            let [low, high] = near.reach();
            let of_node = |(node, weight): (f64, f64)| {
                let mut shares = vec![0.0; instruments];
                shares[only] = 0.5 * (low + high + node * (high - low));
                student.log_density(&scatter, seen, &shares) + (weight * (high - low)).ln()
            };
            // The weights of the rule add up to 1.
            legendre_rule(POINTS_OF_ONE).into_iter().map(of_node).collect()
        }
        _ => {
            let steps = lattice_steps(near.movable.len());
            let of_point = |point: usize| {
                let levels: Vec<f64> = steps.iter().map(|step| (0.5 + step * (point + 1) as f64).fract()).collect();
                let (shares, log_drawn) = near.drawn(&levels, instruments)?;
                Some(student.log_density(&scatter, seen, &shares) - log_drawn - (POINTS_OF_SEVERAL as f64).ln())
            };
            (0..POINTS_OF_SEVERAL).filter_map(of_point).collect()
        }
    };
    let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY {
        return Some(most);
    }
    let sum: f64 = logs.iter().map(|log| (log - most).exp()).sum();
    Some(most + sum.ln() - near.movable.len() as f64 * LN_2)
}

/// Student's distribution of a further draw.
struct Student {
    /// ν.
    freedom: f64,
    features: f64,
    /// Σ over C.
    scale: f64,
    /// Logarithm of the factor before |C|^(-1/2).
    log_factor: f64,
}

impl Student {
    /// Predictive distribution from `runs` runs of `features` features; `None` if their covariance has no inverse.
    fn new(runs: usize, features: usize) -> Option<Self> {
        let freedom = runs.checked_sub(features).filter(|freedom| *freedom > 0)? as f64;
        let (count, features) = (runs as f64, features as f64);
        let scale = (count - 1.0) * (count + 1.0) / (count * freedom);
        let log_factor = libm::lgamma(0.5 * (freedom + features))
            - libm::lgamma(0.5 * freedom)
            - 0.5 * features * (freedom * PI * scale).ln();
        Some(Self { freedom, features, scale, log_factor })
    }

    /// Density of the measurement where the common errors are `shares` of their largest.
    fn log_density(&self, scatter: &Scatter, seen: &Observation, shares: &[f64]) -> f64 {
        let found = seen.corrected_values(shares);
        let square = self.square(scatter, &found);
        let mut log = self.log_factor - 0.5 * (self.freedom + self.features) * (square / self.freedom).ln_1p();
        for (place, true_si) in found.iter().enumerate() {
            let error = seen.errors[place];
            // |dx/dy|: of a logarithm 1/x, of a share of an error 1/(1 + s e).
            let stretched = if error.is_share { 1.0 + shares[seen.instruments[place]] * error.size } else { 1.0 };
            let scale = if scatter.is_log[place] { *true_si } else { 1.0 };
            log -= scatter.form.factor.row(place)[place].ln() + (stretched * scale).ln();
        }
        log
    }

    /// (x - mean)ᵀ Σ⁻¹ (x - mean).
    fn square(&self, scatter: &Scatter, found: &[f64]) -> f64 {
        scatter.form.distance(&scatter.scaled(found)).powi(2) / self.scale
    }

    /// Second derivatives of -ln of the density over those of half the square of the distance by C, where the distance is least.
    fn curvature(&self, scatter: &Scatter, found: &[f64]) -> f64 {
        (self.freedom + self.features) / (self.freedom + self.square(scatter, found)) / self.scale
    }
}

/// The density as a function of the common errors, where features are linear in these: the normal one that is as curved where it is largest,
/// cut to the box.
struct NearestNormal {
    movable: Vec<usize>,
    /// Its maximum within the box.
    nearest: Vec<f64>,
    /// Its maximum without the box.
    centre: Vec<f64>,
    /// L of the second derivatives of -ln: L Lᵀ = H.
    factor: Cholesky,
}

impl NearestNormal {
    fn new(scatter: &Scatter, student: &Student, seen: &Observation, movable: Vec<usize>) -> Self {
        let shares = scatter.nearest_shares(seen, &|values| scatter.form.distance(values));
        let found = seen.corrected_values(&shares);
        let off: Vec<f64> =
            scatter.scaled(&found).iter().zip(&scatter.form.mean).map(|(value, mean)| value - mean).collect();
        let z = scatter.form.whiten(&off);
        // Columns of dz/ds.
        let column = |instrument: &usize| {
            let slope = |place: usize| {
                let error = seen.errors[place];
                if seen.instruments[place] != *instrument {
                    return 0.0;
                }
                let slope = if error.is_share {
                    -found[place] * error.size / (1.0 + shares[*instrument] * error.size)
                } else {
                    -error.size
                };
                if scatter.is_log[place] { slope / found[place] } else { slope }
            };
            scatter.form.whiten(&(0..found.len()).map(slope).collect::<Vec<f64>>())
        };
        let columns: Vec<Vec<f64>> = movable.iter().map(column).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let curvature = symmetric(movable.len(), |i, j| dot(&columns[i], &columns[j]));
        let mut factor = Cholesky::with_raised_pivots(&curvature, &vec![MIN_CURVATURE; movable.len()]);
        // H x = -Jᵀ z.
        let mut step: Vec<f64> = columns.iter().map(|column| -dot(column, &z)).collect();
        factor.solve(&mut step);
        let bent = student.curvature(scatter, &found).sqrt();
        factor.scale(bent);
        let nearest: Vec<f64> = movable.iter().map(|instrument| shares[*instrument]).collect();
        let centre = nearest.iter().zip(step).map(|(nearest, step)| nearest + step).collect();
        Self { movable, nearest, centre, factor }
    }

    /// The part of the interval of the first common error that is integrated over.
    fn reach(&self) -> [f64; 2] {
        let reach = REACH / self.factor.row(0)[0];
        [(self.nearest[0] - reach).max(-1.0), (self.nearest[0] + reach).min(1.0)]
    }

    /// Shares of the common errors at these levels in (0, 1), drawn one after the other, each cut to its interval, and the logarithm of their density
    /// (A. Genz, "Numerical computation of multivariate normal probabilities", Journal of Computational and Graphical Statistics 1 (1992)
    /// 141-149). `None` if no number is left of it.
    fn drawn(&self, levels: &[f64], instruments: usize) -> Option<(Vec<f64>, f64)> {
        let count = self.movable.len();
        let (mut off, mut log_drawn, mut shares) = (vec![0.0; count], 0.0, vec![0.0; instruments]);
        for j in (0..count).rev() {
            let known: f64 = (j + 1..count).map(|i| self.factor.row(i)[j] * off[i]).sum();
            let own = self.factor.row(j)[j];
            let [low, high] = [-1.0, 1.0].map(|end| own * (end - self.centre[j]) + known);
            // In the lower tail, where the distribution function keeps its digits.
            let sign = if low > 0.0 { -1.0 } else { 1.0 };
            let [low, high] = if sign < 0.0 { [-high, -low] } else { [low, high] };
            let [below, above] = [low, high].map(normal_cdf);
            let chance = above - below;
            if !(chance > 0.0) {
                return None;
            }
            let w = sign * normal_quantile(below + levels[j] * chance).clamp(low, high);
            off[j] = (w - known) / own;
            shares[self.movable[j]] = (self.centre[j] + off[j]).clamp(-1.0, 1.0);
            log_drawn += -0.5 * w * w - 0.5 * TAU.ln() + own.ln() - chance.ln();
        }
        Some((shares, log_drawn))
    }
}

/// Steps of a lattice that never repeats: powers of the root of x^(d+1) = x + 1.
fn lattice_steps(dimensions: usize) -> Vec<f64> {
    let mut root = 1.5_f64;
    for _ in 0..64 {
        root = (1.0 + root).powf(1.0 / (dimensions as f64 + 1.0));
    }
    (1..=dimensions).map(|power| root.powi(-(power as i32))).collect()
}

#[cfg(test)]
mod tests {
    use super::log_likelihood;
    use crate::motion::scatter::Observation;
    use loosepin_study::MotionError;
    use loosepin_uncertainty::{hash, normal};
    use std::f64::consts::TAU;

    /// So many draws, a multiple of four, with exactly this mean, these standard deviations and this correlation.
    fn draws(count: usize, mean: [f64; 2], deviations: [f64; 2], correlation: f64) -> Vec<Vec<f64>> {
        // (±1, ±1) has mean 0 and the identity as covariance, but for n/(n - 1).
        let scale = ((count - 1) as f64 / count as f64).sqrt();
        let across = (1.0 - correlation * correlation).sqrt();
        (0..count)
            .map(|run| {
                let a = scale * if run % 2 == 0 { 1.0 } else { -1.0 };
                let b = scale * if run / 2 % 2 == 0 { 1.0 } else { -1.0 };
                vec![mean[0] + deviations[0] * a, mean[1] + deviations[1] * (correlation * a + across * b)]
            })
            .collect()
    }

    fn runs(mean: [f64; 2], deviations: [f64; 2], correlation: f64) -> Vec<Vec<f64>> {
        draws(400, mean, deviations, correlation)
    }

    /// Student's density of a further pair beside 400: of two numbers the factor of gamma functions is 1/(2 π).
    fn density(at: [f64; 2], mean: [f64; 2], deviations: [f64; 2], correlation: f64) -> f64 {
        density_beside(400.0, at, mean, deviations, correlation)
    }

    fn density_beside(count: f64, [x, y]: [f64; 2], mean: [f64; 2], deviations: [f64; 2], correlation: f64) -> f64 {
        let [a, b] = [(x - mean[0]) / deviations[0], (y - mean[1]) / deviations[1]];
        let (rest, freedom) = (1.0 - correlation * correlation, count - 2.0);
        let scale = (count - 1.0) * (count + 1.0) / (count * freedom);
        let square = (a * a - 2.0 * correlation * a * b + b * b) / (rest * scale);
        (1.0 + square / freedom).powf(-0.5 * count) / (TAU * deviations[0] * deviations[1] * rest.sqrt() * scale)
    }

    /// ∫ over [-1, 1] by Simpson's rule.
    fn simpson(of: impl Fn(f64) -> f64) -> f64 {
        simpson_of(2000, of)
    }

    fn simpson_of(count: usize, of: impl Fn(f64) -> f64) -> f64 {
        let h = 2.0 / count as f64;
        let weight = |k: usize| {
            if k == 0 || k == count {
                1.0
            } else if k % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        (0..=count).map(|k| weight(k) * of(-1.0 + h * k as f64)).sum::<f64>() * h / 3.0
    }

    fn absolute(size: f64) -> MotionError {
        MotionError { size, is_share: false }
    }

    #[test]
    fn analytic_without_common_errors_it_is_the_density_of_the_features() {
        let (mean, deviations) = ([-3.0, 7.3], [0.4, 1.7]);
        let seen = Observation { values_si: vec![-2.6, 5.9], errors: vec![absolute(0.0); 2], instruments: vec![0, 0] };
        let found = log_likelihood(&runs(mean, deviations, 0.6), &seen).expect("all runs ended");
        // The second feature is positive in all runs: it is compared by its logarithm, whose mean and deviation are those of the runs.
        assert!((found.exp() / logarithmic([-2.6, 5.9], mean, deviations, 0.6) - 1.0).abs() < 1e-9, "{found}");
    }

    /// Density where the second feature is compared by its logarithm: moments by hand from the draws.
    fn logarithmic(at: [f64; 2], mean: [f64; 2], deviations: [f64; 2], correlation: f64) -> f64 {
        let all: Vec<[f64; 2]> = runs(mean, deviations, correlation).iter().map(|run| [run[0], run[1].ln()]).collect();
        let count = all.len() as f64;
        let middle = [0, 1].map(|k: usize| all.iter().map(|row| row[k]).sum::<f64>() / count);
        let product = |i: usize, j: usize| {
            all.iter().map(|row| (row[i] - middle[i]) * (row[j] - middle[j])).sum::<f64>() / (count - 1.0)
        };
        let spread = [product(0, 0).sqrt(), product(1, 1).sqrt()];
        density([at[0], at[1].ln()], middle, spread, product(0, 1) / (spread[0] * spread[1])) / at[1]
    }

    #[test]
    fn peer_common_errors_are_integrated_as_by_simpsons_rule() {
        // Negative features: no logarithms. One instrument whose error moves both, absolutely or by a share, small or large beside the scatter,
        // the measurement near the runs, or further off than the error reaches.
        let (mean, deviations, correlation) = ([-3.0, -7.3], [0.4, 0.9], 0.6);
        let all = runs(mean, deviations, correlation);
        for (size, is_share) in [(0.02, false), (0.8, false), (9.0, false), (0.05, true), (0.4, true)] {
            for values_si in [[-2.6, -6.9], [-3.9, -8.8], [-1.1, -4.0]] {
                let error = MotionError { size, is_share };
                let seen =
                    Observation { values_si: values_si.to_vec(), errors: vec![error; 2], instruments: vec![0, 0] };
                let found = log_likelihood(&all, &seen).expect("all runs ended").exp();
                let of = |share: f64| {
                    let (at, stretched) = if is_share {
                        (values_si.map(|value| value / (1.0 + share * size)), (1.0 + share * size).powi(2))
                    } else {
                        (values_si.map(|value| value - share * size), 1.0)
                    };
                    density(at, mean, deviations, correlation) / stretched
                };
                let expected = 0.5 * simpson(of);
                assert!((found / expected - 1.0).abs() < 1e-6, "{size} {is_share} {values_si:?}: {found} {expected}");
            }
        }
    }

    #[test]
    fn peer_two_instruments_are_integrated_as_by_simpsons_rule_twice() {
        let (mean, deviations, correlation) = ([-3.0, -7.3], [0.4, 0.9], 0.8);
        let all = runs(mean, deviations, correlation);
        for sizes in [[0.3, 0.5], [2.0, 0.1], [4.0, 6.0]] {
            let values_si = [-2.6, -6.1];
            let seen = Observation {
                values_si: values_si.to_vec(),
                errors: sizes.map(absolute).to_vec(),
                instruments: vec![0, 1],
            };
            let found = log_likelihood(&all, &seen).expect("all runs ended").exp();
            let at = |s: f64, t: f64| [values_si[0] - s * sizes[0], values_si[1] - t * sizes[1]];
            let expected = 0.25 * simpson(|s| simpson(|t| density(at(s, t), mean, deviations, correlation)));
            assert!((found / expected - 1.0).abs() < 5e-3, "{sizes:?}: {found} {expected}");
        }
    }

    #[test]
    fn peer_an_instrument_that_reads_0_with_an_error_as_a_share_moves_nothing() {
        // 0 stays 0 whatever its share; beside it an absolute error of another instrument.
        let (mean, deviations, correlation) = ([0.2, -7.3], [0.4, 0.9], 0.5);
        let errors = vec![MotionError { size: 0.4, is_share: true }, absolute(0.5)];
        let seen = Observation { values_si: vec![0.0, -6.1], errors, instruments: vec![0, 1] };
        let found = log_likelihood(&runs(mean, deviations, correlation), &seen).expect("all runs ended").exp();
        let of = |s: f64| simpson(|t| density([0.0, -6.1 - 0.5 * t], mean, deviations, correlation)) / (1.0 + 0.4 * s);
        let expected = 0.25 * simpson(of);
        assert!((found / expected - 1.0).abs() < 5e-3, "{found} {expected}");
    }

    #[test]
    fn analytic_nothing_is_lost_beyond_the_reach_of_few_runs() {
        // One feature of 8, 12 and 20 runs whose common error reaches a thousand times as far as they scatter: all of t lies within, and
        // p = 1/(2 e). What lies beyond the reach is that of Student's distributions with 7, 11 and 19 degrees of freedom, by a sum over x/t.
        for (runs, lost) in [(8, 9.94e-6), (12, 1.817e-7), (20, 4.0e-10)] {
            let all: Vec<Vec<f64>> =
                draws(runs, [-3.0, -7.3], [0.4, 0.9], 0.0).iter().map(|run| vec![run[0]]).collect();
            for y in [-3.0, -2.1] {
                let seen = Observation { values_si: vec![y], errors: vec![absolute(400.0)], instruments: vec![0] };
                let found = 2.0 * 400.0 * log_likelihood(&all, &seen).expect("all runs ended").exp();
                assert!((1.0 - found - lost).abs() < 1e-10 + 0.01 * lost, "{runs} {y}: {:e}", 1.0 - found);
            }
        }
    }

    #[test]
    fn peer_few_runs_and_two_instruments_as_by_simpsons_rule_twice() {
        // 20 runs of two features, the fewest that are allowed: tails are longer than those of the normal distribution that is drawn from.
        let (mean, deviations, correlation) = ([-3.0, -7.3], [0.4, 0.9], 0.8);
        let all = draws(20, mean, deviations, correlation);
        for sizes in [[0.3, 0.5], [2.0, 0.1], [4.0, 6.0]] {
            for values_si in [[-2.6, -6.1], [-0.9, -5.9]] {
                let errors = sizes.map(absolute).to_vec();
                let seen = Observation { values_si: values_si.to_vec(), errors, instruments: vec![0, 1] };
                let found = log_likelihood(&all, &seen).expect("all runs ended").exp();
                let at = |s: f64, t: f64| [values_si[0] - s * sizes[0], values_si[1] - t * sizes[1]];
                let of = |s: f64, t: f64| density_beside(20.0, at(s, t), mean, deviations, correlation);
                let expected = 0.25 * simpson(|s| simpson(|t| of(s, t)));
                assert!((found / expected - 1.0).abs() < 0.02, "{sizes:?} {values_si:?}: {found} {expected}");
            }
        }
    }

    #[test]
    fn analytic_a_further_draw_lies_in_the_middle_95_per_cent_as_often_as_that() {
        // Ten draws, the fewest of one feature. Those of the normal distribution with their mean and deviation would hold it in
        // P(|t_9| < 1.96 sqrt(10/11)) = 90.5 %. Of 4000, 95 % have a standard deviation of 0.34 %: four are allowed.
        const TRIALS: u64 = 4000;
        let mut held = 0;
        for trial in 0..TRIALS {
            let draw = |run: u64| normal(hash(trial, run), 0) - 50.0;
            let all: Vec<Vec<f64>> = (0..10).map(|run| vec![draw(run)]).collect();
            let truth = draw(10);
            let of = |x: f64| {
                let seen = Observation { values_si: vec![x], errors: vec![absolute(0.0)], instruments: vec![0] };
                log_likelihood(&all, &seen).expect("all runs ended").exp()
            };
            // The probability from the middle of the draws to the truth, twice.
            let mean = all.iter().map(|run| run[0]).sum::<f64>() / 10.0;
            let half = 0.5 * (truth - mean);
            let inside = 2.0 * half.abs() * simpson_of(100, |s| of(mean + half * (1.0 + s)));
            held += usize::from(inside < 0.95);
        }
        let share = held as f64 / TRIALS as f64;
        assert!((share - 0.95).abs() < 0.014, "{share}");
    }
}
