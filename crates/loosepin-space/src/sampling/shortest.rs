//! The smallest length of an offset and what plays add to it, to first order.

use super::longest::{Displacements, sum};
use crate::accuracy::AccuracyError;
use crate::accuracy::linear::vectors::dot;

/// Most steps; ten are usual.
const MAX_STEPS: usize = 100;
/// Distance of bound and length, relative to the largest length, that ends a search.
const GAP: f64 = 1e-9;
/// Determinant of edges below which points do not span a simplex, relative to the product of their squares.
const FLAT: f64 = 1e-12;

/// A lower bound of the length of d + G p over the plays, near to the smallest: 0 where they can take the offset back. `largest` is the largest
/// length.
///
/// By the method of E. G. Gilbert (SIAM Journal on Control 4 (1966) 61), with simplices as E. G. Gilbert, D. W. Johnson and S. S. Keerthi (IEEE
/// Journal of Robotics and Automation 4 (1988) 193) have them: x is the point of a simplex of places of the set that is nearest to the origin, and
/// the s of the set with the smallest x·s joins it. The set lies beyond the plane through s across x, so that x·s/|x| is a lower bound.
pub(super) fn shortest(
    displacements: &mut Displacements,
    offset: [f64; 3],
    largest: f64,
) -> Result<f64, AccuracyError> {
    let mut against = |x: [f64; 3]| Ok(sum(offset, displacements.farthest(x.map(|entry| -entry))?));
    let mut simplex: Vec<[f64; 3]> = vec![against(offset)?];
    let mut x = simplex[0];
    let mut bound: f64 = 0.0;
    for _ in 0..MAX_STEPS {
        let length = dot(&x, &x).sqrt();
        if length - bound <= GAP * largest {
            break;
        }
        let s = against(x)?;
        bound = bound.max(dot(&x, &s) / length);
        simplex.push(s);
        let (next, own) = nearest(&simplex);
        // Round-off: nothing is nearer.
        if !(dot(&next, &next) < length * length) {
            break;
        }
        (x, simplex) = (next, own);
    }
    Ok(bound)
}

/// The point of the hull of up to four points that is nearest to the origin, and those points that it is a mean of with positive weights.
fn nearest(points: &[[f64; 3]]) -> ([f64; 3], Vec<[f64; 3]>) {
    let mut best = (f64::INFINITY, [0.0; 3], Vec::new());
    for mask in 1_usize..1 << points.len() {
        let own: Vec<[f64; 3]> = (0..points.len()).filter(|k| mask >> k & 1 == 1).map(|k| points[k]).collect();
        let Some(x) = nearest_within(&own) else { continue };
        let square = dot(&x, &x);
        if square < best.0 {
            best = (square, x, own);
        }
    }
    (best.1, best.2)
}

/// The point of the plane through all points that is nearest to the origin, if it is between them: p_0 + Σ u_k e_k with edges e_k = p_k - p_0 and
/// Σ_k (e_j·e_k) u_k = -e_j·p_0.
fn nearest_within(points: &[[f64; 3]]) -> Option<[f64; 3]> {
    let (first, others) = points.split_first()?;
    let edges: Vec<[f64; 3]> = others.iter().map(|own| [0, 1, 2].map(|k| own[k] - first[k])).collect();
    let count = edges.len();
    if count > 3 {
        return None;
    }
    // What is left of the order three is one times one.
    let mut gram = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    for j in 0..3 {
        gram[j][j] = 1.0;
        for k in 0..3 {
            if j < count && k < count {
                gram[j][k] = dot(&edges[j], &edges[k]);
            }
        }
        right[j] = edges.get(j).map_or(0.0, |edge| -dot(edge, first));
    }
    let determinant = determinant(&gram);
    if !(determinant > FLAT * gram[0][0] * gram[1][1] * gram[2][2]) {
        return None;
    }
    let weights = [0, 1, 2].map(|column| {
        let mut replaced = gram;
        replaced.iter_mut().zip(right).for_each(|(row, value)| row[column] = value);
        self::determinant(&replaced) / determinant
    });
    let own = &weights[..count];
    let is_between = own.iter().all(|weight| *weight > 0.0) && own.iter().sum::<f64>() < 1.0;
    let mut x = *first;
    for (edge, weight) in edges.iter().zip(own) {
        x = [0, 1, 2].map(|k| x[k] + weight * edge[k]);
    }
    is_between.then_some(x)
}

fn determinant([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn analytic_nearest_points_of_a_simplex() {
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Corner, edge, face, and a tetrahedron about the origin.
        for (points, expected) in [
            (vec![unit[0], [2.0, 0.5, 0.0]], [1.0, 0.0, 0.0]),
            (vec![unit[0], unit[1]], [0.5, 0.5, 0.0]),
            (unit.to_vec(), [1.0 / 3.0; 3]),
            (vec![unit[0], unit[1], unit[2], [-1.0, -1.0, -1.0]], [0.0; 3]),
            (vec![unit[0], unit[1], unit[2], [2.0, 2.0, 2.0]], [1.0 / 3.0; 3]),
        ] {
            let (found, own) = nearest(&points);
            assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-15), "{found:?} {expected:?} {own:?}");
        }
    }
}
