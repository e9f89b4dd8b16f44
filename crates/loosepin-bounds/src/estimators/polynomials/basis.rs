//! Products of orthonormal polynomials up to a total degree.

use super::orthogonal::Axis;

/// More coefficients than this are not fitted.
const MAX_COEFFICIENTS: usize = 128;

/// p_k(t) = Π_j p_kj(t_j) with Σ_j k_j <= degree.
#[derive(Debug)]
pub(crate) struct Basis {
    pub axes: Vec<Axis>,
    pub degree: usize,
    /// Exponents k of each term, the constant first.
    pub terms: Vec<Vec<usize>>,
}

impl Basis {
    /// All terms up to `degree`; `None` if they are too many.
    pub fn try_new(axes: &[Axis], degree: usize) -> Option<Self> {
        Some(Self { axes: axes.to_vec(), degree, terms: exponents(axes.len(), degree)? })
    }

    /// Values of all terms at `point`.
    pub fn values(&self, point: &[f64]) -> impl Iterator<Item = f64> {
        let values: Vec<Vec<f64>> =
            point.iter().zip(&self.axes).map(|(&t, axis)| axis.values(t, self.degree)).collect();
        self.terms.iter().map(move |term| term.iter().zip(&values).map(|(&k, values)| values[k]).product::<f64>())
    }

    /// Axis whose linear term has the largest coefficient; the first one where none is larger.
    pub fn steepest_axis(&self, coefficients: &[f64]) -> usize {
        let slope_of = |axis: usize| -> f64 {
            let along = self.terms.iter().zip(coefficients).filter(|(term, _)| term[axis] == 1);
            along.filter(|(term, _)| term.iter().sum::<usize>() == 1).map(|(_, c)| c.abs()).sum()
        };
        let mut steepest = 0;
        for axis in 1..self.axes.len() {
            if slope_of(axis) > slope_of(steepest) {
                steepest = axis;
            }
        }
        steepest
    }
}

/// All exponents of `axes` variables with a sum up to `degree`, in the order of their sum; `None` if they are too many.
fn exponents(axes: usize, degree: usize) -> Option<Vec<Vec<usize>>> {
    let mut terms = vec![vec![0; axes]];
    let mut last = terms.clone();
    for _ in 0..degree {
        let mut next: Vec<Vec<usize>> = Vec::new();
        for term in &last {
            // Raising the last variable that is there, or one behind it, meets every combination once.
            let from = term.iter().rposition(|&k| k > 0).unwrap_or(0);
            for axis in from..axes {
                let mut raised = term.clone();
                raised[axis] += 1;
                next.push(raised);
            }
        }
        terms.extend(next.iter().cloned());
        if terms.len() > MAX_COEFFICIENTS {
            return None;
        }
        last = next;
    }
    Some(terms)
}
