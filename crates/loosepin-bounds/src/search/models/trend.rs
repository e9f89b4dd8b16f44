//! The polynomial part of a model.

use loosepin_math::dense::{Cholesky, gram};

/// Degree of a polynomial.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Degree {
    Constant,
    Linear,
    Quadratic,
}

/// A polynomial on points whose last coordinates are cosine and sine of `circles` angles, two for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Trend {
    degree: Degree,
    circles: usize,
}

impl Trend {
    /// The highest degree with at least two points for each coefficient that the points determine, with its terms at the
    /// points (row by row) and the factor of its normal equations.
    pub fn for_points(points: &[Vec<f64>], circles: usize) -> Option<(Self, Vec<f64>, Cholesky)> {
        let dimensions = points.first()?.len();
        [Degree::Quadratic, Degree::Linear, Degree::Constant].into_iter().find_map(|degree| {
            let trend = Self { degree, circles };
            let size = trend.size(dimensions);
            if 2 * size > points.len() {
                return None;
            }
            let terms: Vec<f64> = points.iter().flat_map(|point| trend.terms(point)).collect();
            let normal_equations = Cholesky::new(gram(&terms, size), size)?;
            Some((trend, terms, normal_equations))
        })
    }

    /// Number of terms.
    fn size(self, dimensions: usize) -> usize {
        match self.degree {
            Degree::Constant => 1,
            Degree::Linear => 1 + dimensions,
            Degree::Quadratic => (dimensions + 1) * (dimensions + 2) / 2 - self.circles,
        }
    }

    /// 1, t_i, t_i t_j with t = 2u - 1; without the square of a sine, which those of the cosine and of 1 hold already.
    pub fn terms(self, point: &[f64]) -> Vec<f64> {
        let mut terms = Vec::with_capacity(self.size(point.len()));
        terms.push(1.0);
        if self.degree != Degree::Constant {
            terms.extend(point.iter().map(|x| 2.0 * x - 1.0));
        }
        if self.degree == Degree::Quadratic {
            for (i, x) in point.iter().enumerate() {
                terms.extend(
                    point[self.first_partner(i, point.len())..].iter().map(|y| (2.0 * x - 1.0) * (2.0 * y - 1.0)),
                );
            }
        }
        terms
    }

    /// How the polynomial with these `coefficients` of [`Self::terms`] changes along each coordinate of `point`.
    pub fn slopes(self, point: &[f64], coefficients: &[f64]) -> Vec<f64> {
        let mut slopes = vec![0.0; point.len()];
        let mut rest = coefficients.iter().skip(1);
        if self.degree != Degree::Constant {
            // dt/dx = 2
            for (slope, coefficient) in slopes.iter_mut().zip(rest.by_ref()) {
                *slope = 2.0 * coefficient;
            }
        }
        if self.degree == Degree::Quadratic {
            for i in 0..point.len() {
                for (j, coefficient) in (self.first_partner(i, point.len())..point.len()).zip(rest.by_ref()) {
                    slopes[i] += 2.0 * coefficient * (2.0 * point[j] - 1.0);
                    slopes[j] += 2.0 * coefficient * (2.0 * point[i] - 1.0);
                }
            }
        }
        slopes
    }

    /// The first coordinate with which coordinate `i` is multiplied.
    fn first_partner(self, i: usize, dimensions: usize) -> usize {
        let open = dimensions - 2 * self.circles;
        let is_sine = i >= open && (i - open) % 2 == 1;
        if is_sine { i + 1 } else { i }
    }
}
