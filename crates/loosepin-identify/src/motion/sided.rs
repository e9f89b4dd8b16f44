//! Distance of a draw from others that may scatter further on one side than on the other.
//!
//! ```text
//! s_k±² = 2/N Σ max(0, ±δ_k)² + l_k²    s_k² = (s_k+² + s_k-²)/2    R = 1/N Σ z zᵀ    z_k = δ_k/s_k±, the sign that of δ_k
//! d² = max( zᵀ R⁻¹ z,  (x - mean)ᵀ C⁻¹ (x - mean) (1 + Σ z_k²)/(1 + Σ (δ_k/s_k)²) )
//! ```
//!
//! | Symbol | Means |
//! |---|---|
//! | δ_k | value of feature k less the median of the N draws |
//! | s_k+, s_k- | scatter above and below the median; N/2 draws lie on either side |
//! | l_k | least standard deviation that counts |
//! | R | second moments of z, 1 on the diagonal |
//! | C | covariance of the draws |
//!
//! Where draws scatter alike on both sides, both are the Mahalanobis distance. Two draws of 200 that lie far below the others make their
//! standard deviation large on both sides, so that the distance of what lies above them is small; here they count below alone. The first of
//! the two breaks lines at the median, and no longer sees a sum of features that hardly scatters; the second one does. The 1 keeps
//! the factor near 1 beside the median.

use super::scatter::{Form, least_deviation, symmetric};
use loosepin_math::dense::Cholesky;
use loosepin_math::sort_ascending;
use loosepin_study::MotionError;

/// Middle, scatter on each side, and covariance of draws. It does not depend on their order.
pub(crate) struct SidedForm {
    form: Form,
    median: Vec<f64>,
    /// s- and s+ of each feature.
    sides: Vec<[f64; 2]>,
    /// L of R.
    factor: Cholesky,
}

impl SidedForm {
    /// Of at least one draw.
    pub fn new(rows: &[Vec<f64>], is_log: &[bool], errors: &[MotionError]) -> Self {
        let form = Form::new(rows, is_log, errors);
        let (count, features) = (rows.len() as f64, is_log.len());
        let median: Vec<f64> = (0..features).map(|k| median(rows.iter().map(|row| row[k]).collect())).collect();
        let least: Vec<f64> = (0..features).map(|k| least_deviation(form.mean[k], is_log[k], errors[k])).collect();
        let side = |k: usize, sign: f64| {
            let sum: f64 = rows.iter().map(|row| (sign * (row[k] - median[k])).max(0.0).powi(2)).sum();
            (2.0 * sum / count + least[k] * least[k]).sqrt()
        };
        let sides: Vec<[f64; 2]> = (0..features).map(|k| [side(k, -1.0), side(k, 1.0)]).collect();
        let all: Vec<Vec<f64>> = rows.iter().map(|row| over_sides(row, &median, &sides)).collect();
        let moment = |i: usize, j: usize| {
            let sum: f64 = all.iter().map(|z| z[i] * z[j]).sum();
            if i == j { 1.0 } else { sum / count }
        };
        // The share of l² in what is 1 on the diagonal.
        let floor = |i: usize| sides[i].iter().map(|side| 0.5 * (least[i] / side).powi(2)).sum();
        let floors: Vec<f64> = (0..features).map(floor).collect();
        let factor = Cholesky::with_raised_pivots(&symmetric(features, moment), &floors);
        Self { form, median, sides, factor }
    }

    /// Distance of values from the middle.
    pub fn distance(&self, values: &[f64]) -> f64 {
        let z = over_sides(values, &self.median, &self.sides);
        let mut white = z.clone();
        self.factor.solve_lower(&mut white);
        let own = length(&white);
        let both: Vec<f64> = (0..z.len())
            .map(|k| {
                let [below, above] = self.sides[k];
                (values[k] - self.median[k]) / (0.5 * (below * below + above * above)).sqrt()
            })
            .collect();
        let turned = (1.0 + length(&z).powi(2)) / (1.0 + length(&both).powi(2));
        own.max(turned.sqrt() * self.form.distance(values))
    }
}

/// Differences from the median, each over the scatter on its side.
fn over_sides(values: &[f64], median: &[f64], sides: &[[f64; 2]]) -> Vec<f64> {
    let of = |k: usize| {
        let off = values[k] - median[k];
        off / sides[k][usize::from(off > 0.0)]
    };
    (0..values.len()).map(of).collect()
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// The middle one of values, or the mean of the two.
fn median(mut values: Vec<f64>) -> f64 {
    sort_ascending(&mut values);
    let half = values.len() / 2;
    if values.len().is_multiple_of(2) { 0.5 * (values[half - 1] + values[half]) } else { values[half] }
}

#[cfg(test)]
mod tests {
    use super::SidedForm;
    use crate::motion::scatter::Form;
    use loosepin_study::MotionError;
    use loosepin_uncertainty::{hash, normal, uniform};

    const NONE: MotionError = MotionError { size: 0.0, is_share: false };

    fn sided(rows: &[Vec<f64>]) -> SidedForm {
        let features = rows[0].len();
        SidedForm::new(rows, &vec![false; features], &vec![NONE; features])
    }

    #[test]
    fn analytic_draws_alike_on_both_sides_have_the_distance_of_mahalanobis() {
        // (±1, ±1) times a matrix, and their middle: the same numbers on both sides of the median.
        let rows: Vec<Vec<f64>> = (0..400)
            .map(|run| {
                let [a, b] = [1, 2].map(|step| if run / step % 2 == 0 { 1.3 } else { -1.3 });
                vec![5.0 + a, -2.0 + 0.6 * a + 0.8 * b]
            })
            .collect();
        let form = sided(&rows);
        let plain = Form::new(&rows, &[false; 2], &[NONE; 2]);
        // N - 1 against N in the covariance.
        let most = (400.0_f64 / 399.0).sqrt();
        for values in [[6.1, -2.5], [3.0, 1.0], [5.5, -0.4]] {
            let ratio = form.distance(&values) / plain.distance(&values);
            assert!(ratio > 1.0 - 1e-9 && ratio < most + 1e-9, "{values:?}: {ratio}");
        }
    }

    #[test]
    fn analytic_each_side_has_its_own_scatter() {
        // 2, 1 below the median and 30, 40 above it: s-² = (4 + 1)/2, s+² = (900 + 1600)/2.
        let rows: Vec<Vec<f64>> = [-2.0, -1.0, 30.0, 40.0].iter().map(|off| vec![7.0 + off]).collect();
        // The median is 7 + 14.5.
        let form = sided(&rows);
        let [below, above] = [(16.5_f64.powi(2) + 15.5_f64.powi(2)) / 2.0, (15.5_f64.powi(2) + 25.5_f64.powi(2)) / 2.0];
        let (mean, both) = (7.0 + 67.0 / 4.0, 0.5 * (below + above));
        let deviation = (rows.iter().map(|row| (row[0] - mean).powi(2)).sum::<f64>() / 3.0).sqrt();
        for (off, side) in [(-40.0_f64, below), (-3.0, below), (9.0, above), (60.0, above)] {
            let turned = (1.0 + off * off / side) / (1.0 + off * off / both);
            let value = 21.5 + off;
            let expected = (off * off / side).sqrt().max(turned.sqrt() * (value - mean).abs() / deviation);
            assert!((form.distance(&[value]) / expected - 1.0).abs() < 1e-9, "{off}");
        }
    }

    #[test]
    fn analytic_what_lies_above_is_further_off_than_two_that_lie_below() {
        // Two of 200 hardly hit: 8 and 9 below, where the others scatter by 1. The measurement is 7.5 above. Mahalanobis has it third.
        // Over the scatter of each side: 7.5/√(1 + 0.56) = 6.0, and 9/√(1 + 1.45) = 5.7.
        let (mut told, mut told_plain) = (0, 0);
        for trial in 0..100 {
            let mut rows: Vec<Vec<f64>> = (0..200).map(|run| vec![normal(hash(trial, run), 0)]).collect();
            (rows[0][0], rows[1][0], rows[199][0]) = (-8.0, -9.0, 7.5);
            let rank = |distance: &dyn Fn(&[f64]) -> f64| {
                rows.iter().filter(|row| distance(row) >= distance(&rows[199])).count()
            };
            told += usize::from(rank(&|row| sided(&rows).distance(row)) <= 2);
            told_plain += usize::from(rank(&|row| Form::new(&rows, &[false], &[NONE]).distance(row)) <= 2);
        }
        assert_eq!((told, told_plain), (100, 0));
    }

    #[test]
    fn analytic_a_sum_that_hardly_scatters_is_seen() {
        // The second is the first, which is skewed up, and the third, which is skewed down; the sum is off by 20 of its standard deviations.
        let told = (0..100).filter(|trial| {
            let draw = |run: u64| {
                let key = hash(*trial, run);
                let [a, b] = [normal(key, 0).exp(), -(0.5 * normal(key, 1)).exp()];
                vec![a, a + b + 0.05 * normal(key, 2), b]
            };
            let mut rows: Vec<Vec<f64>> = (0..200).map(draw).collect();
            rows[199][1] += 1.0;
            let form = sided(&rows);
            rows.iter().filter(|row| form.distance(row) >= form.distance(&rows[199])).count() <= 2
        });
        assert!(told.count() >= 95);
    }

    #[test]
    fn identity_neither_order_of_draws_nor_of_features_matters() {
        // Round-off of sums in another order.
        const TOLERANCE: f64 = 1e-9;
        let rows: Vec<Vec<f64>> = (0..41_u64)
            .map(|run| vec![normal(run, 0), uniform(run, 1).powi(3), normal(run, 0) + uniform(run, 2)])
            .collect();
        let turned: Vec<Vec<f64>> = rows.iter().rev().map(|row| row.iter().rev().copied().collect()).collect();
        for (row, other) in rows.iter().zip(turned.iter().rev()) {
            let [own, other] = [sided(&rows).distance(row), sided(&turned).distance(other)];
            assert!((own / other - 1.0).abs() < TOLERANCE, "{own} {other}");
        }
    }
}
