//! The order in which columns enter a sparse regression.

use loosepin_math::dense::{Cholesky, dot};

/// Correlation, relative to the first, at which nothing is left to be explained.
const MIN_CORRELATION: f64 = 1e-10;
/// What is left of the square of a column after those before it are taken out, below which it is a combination of them.
const MIN_INDEPENDENCE: f64 = 1e-12;

/// Columns centred and of length one; `None` in place of those that are constant.
fn normalised(columns: &[Vec<f64>]) -> Vec<Option<Vec<f64>>> {
    columns
        .iter()
        .map(|column| {
            let mean = column.iter().sum::<f64>() / column.len() as f64;
            let centred: Vec<f64> = column.iter().map(|x| x - mean).collect();
            let length = dot(&centred, &centred).sqrt();
            (length > 1e-10 * dot(column, column).sqrt()).then(|| centred.iter().map(|x| x / length).collect())
        })
        .collect()
}

/// Least-angle regression: the columns in the order in which they become as correlated with the rest as those before.
///
/// Source: B. Efron, T. Hastie, I. Johnstone and R. Tibshirani, "Least angle regression", Annals of Statistics 32 (2004)
/// 407-499, eqs. (2.8) to (2.13).
pub(crate) fn angle_order(columns: &[Vec<f64>], values: &[f64], most: usize) -> Vec<usize> {
    let columns = normalised(columns);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let centred: Vec<f64> = values.iter().map(|y| y - mean).collect();
    let mut correlations: Vec<f64> =
        columns.iter().map(|column| column.as_ref().map_or(0.0, |column| dot(column, &centred))).collect();
    let mut is_out: Vec<bool> = columns.iter().map(Option::is_none).collect();
    let mut active: Vec<usize> = Vec::new();
    let mut factor = Cholesky::default();
    let mut first = 0.0;
    while active.len() < most {
        let next = (0..columns.len())
            .filter(|&j| !is_out[j])
            .max_by(|&a, &b| correlations[a].abs().total_cmp(&correlations[b].abs()).then(b.cmp(&a)));
        let Some(next) = next else { break };
        let largest = correlations[next].abs();
        if active.is_empty() {
            first = largest;
        }
        if !(largest > MIN_CORRELATION * first) {
            break;
        }
        is_out[next] = true;
        let Some(entering) = &columns[next] else { continue };
        let products: Vec<f64> =
            active.iter().map(|&j| columns[j].as_ref().map_or(0.0, |column| dot(column, entering))).collect();
        if !factor.push(&products, 1.0, MIN_INDEPENDENCE) {
            continue;
        }
        active.push(next);
        let signs: Vec<f64> = active.iter().map(|&j| correlations[j].signum()).collect();
        let mut solved = signs.clone();
        factor.solve(&mut solved);
        let norm = 1.0 / dot(&signs, &solved).sqrt();
        let mut direction = vec![0.0; values.len()];
        for (&j, weight) in active.iter().zip(&solved) {
            if let Some(column) = &columns[j] {
                for (sum, entry) in direction.iter_mut().zip(column) {
                    *sum += norm * weight * entry;
                }
            }
        }
        let slopes: Vec<f64> =
            columns.iter().map(|column| column.as_ref().map_or(0.0, |column| dot(column, &direction))).collect();
        // How far until another column is as correlated as these; all the way to least squares where none is.
        let mut step = largest / norm;
        for j in (0..columns.len()).filter(|&j| !is_out[j]) {
            for (above, below) in
                [(largest - correlations[j], norm - slopes[j]), (largest + correlations[j], norm + slopes[j])]
            {
                let length = above / below;
                if below > 1e-14 && length > 1e-14 && length < step {
                    step = length;
                }
            }
        }
        for (correlation, slope) in correlations.iter_mut().zip(&slopes) {
            *correlation -= step * slope;
        }
    }
    active
}
