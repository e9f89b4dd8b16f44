//! Lateral shapes of a beam with forces at points inside, by generalised Craig-Bampton.
//!
//! The beam is cut into spans between its points. On each span w/L is a cubic of the values and slopes at its ends, and polynomials that
//! have neither: twice integrated Legendre polynomials, whose curvatures are at right angles to each other and to those of the cubics. So the
//! static shapes, one for unit displacement of each point with the others held, are cubics and exact; the other shapes are the lowest modes with
//! all points held. An eigenproblem of them together makes shapes of their own frequencies.

use super::functions::Frame;
use super::legendre::legendre;
use super::spectrum::{eigenvectors, lowest};
use loosepin_math::dense::Cholesky;
use loosepin_math::legendre_rule;

/// Polynomials without values and slopes at the ends of a span, at least; one more for each half wave and two for safety.
const MIN_INNER: usize = 6;
/// Slopes this close to the largest count as equal to it: the first of them is scaled to one.
const EQUAL: f64 = 1e-9;

/// One lateral shape: coefficients of the functions of each span.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PointShape {
    spans: Vec<Vec<f64>>,
}

impl PointShape {
    /// φ/L, φ' and dφ'/ds at s, which lies in the span `span` of those between `nodes`.
    pub(crate) fn values(&self, nodes: &[f64], span: usize, s: f64) -> [f64; 3] {
        let coefficients = &self.spans[span];
        let functions = functions(nodes[span], nodes[span + 1], coefficients.len() - 4, s);
        let mut sums = [0.0; 3];
        for (coefficient, values) in coefficients.iter().zip(&functions) {
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += coefficient * value);
        }
        sums
    }
}

/// Functions of a span at s: value and slope at its first end, at its second end, then `inner` polynomials without either. Of each
/// the value, dφ/ds and its derivative.
fn functions(start: f64, end: f64, inner: usize, s: f64) -> Vec<[f64; 3]> {
    let length = end - start;
    let u = (s - start) / length;
    let (square, rest) = (u * u, 1.0 - u);
    let mut found = vec![
        [rest * rest * (1.0 + 2.0 * u), -6.0 * u * rest / length, (12.0 * u - 6.0) / (length * length)],
        [length * u * rest * rest, rest * (1.0 - 3.0 * u), (6.0 * u - 4.0) / length],
        [square * (3.0 - 2.0 * u), 6.0 * u * rest / length, (6.0 - 12.0 * u) / (length * length)],
        [-length * square * rest, u * (3.0 * u - 2.0), (6.0 * u - 2.0) / length],
    ];
    let p = legendre(2.0 * u - 1.0, inner + 4);
    let half = 0.5 * length;
    for k in 2..inner + 2 {
        let n = k as f64;
        let slope = (p[k + 1] - p[k - 1]) / (2.0 * n + 1.0);
        let value = ((p[k + 2] - p[k]) / (2.0 * n + 3.0) - (p[k] - p[k - 2]) / (2.0 * n - 1.0)) / (2.0 * n + 1.0);
        let scale = (2.0 * n + 1.0).sqrt();
        found.push([scale * half * half * value, scale * half * slope, scale * p[k]]);
    }
    found
}

/// Numbers of the unknowns of each span among those of the beam; `None` where the frame holds it.
struct Unknowns {
    spans: Vec<Vec<Option<usize>>>,
    /// Unknowns that are displacements of points inside.
    points: Vec<usize>,
    count: usize,
}

impl Unknowns {
    fn new(frame: Frame, nodes: &[f64], inner: &[usize]) -> Self {
        let mut count = 0;
        let mut next = |is_free: bool| {
            is_free.then(|| {
                count += 1;
                count - 1
            })
        };
        let last = nodes.len() - 1;
        let of_nodes: Vec<[Option<usize>; 2]> = (0..=last)
            .map(|node| match (frame, node == 0, node == last) {
                (Frame::Secant, true, _) | (Frame::Secant, _, true) => [None, next(true)],
                (Frame::Tangent, true, _) => [None, None],
                _ => [next(true), next(true)],
            })
            .collect();
        let spans = (0..last)
            .map(|span| {
                let ends = [of_nodes[span], of_nodes[span + 1]].concat();
                ends.into_iter().chain((0..inner[span]).map(|_| next(true))).collect()
            })
            .collect();
        let points = of_nodes[1..last].iter().filter_map(|node| node[0]).collect();
        Self { spans, points, count }
    }
}

/// The lateral shapes of a beam with static shapes at the points inside, `nodes` without its first and last, 0 and 1, and `modes` modes with
/// these points held: as many as points and modes together, by frequency, each scaled to the slope one at the node that turns most.
pub(crate) fn point_shapes(frame: Frame, nodes: &[f64], modes: usize) -> Vec<PointShape> {
    let spans = nodes.len() - 1;
    let inner: Vec<usize> = (0..spans)
        .map(|span| MIN_INNER + (2.0 * (modes + spans) as f64 * (nodes[span + 1] - nodes[span])).ceil() as usize)
        .collect();
    let unknowns = Unknowns::new(frame, nodes, &inner);
    let n = unknowns.count;
    let [mut mass, mut stiffness] = [vec![0.0; n * n], vec![0.0; n * n]];
    for (span, places) in unknowns.spans.iter().enumerate() {
        let (start, end) = (nodes[span], nodes[span + 1]);
        for [s, weight] in span_rule(start, end, inner[span] + 4) {
            let values = functions(start, end, inner[span], s);
            let free: Vec<(usize, [f64; 3])> =
                places.iter().zip(values).filter_map(|(place, values)| Some(((*place)?, values))).collect();
            for (row, of_row) in &free {
                for (column, of_column) in &free {
                    mass[row * n + column] += weight * of_row[0] * of_column[0];
                    stiffness[row * n + column] += weight * of_row[2] * of_column[2];
                }
            }
        }
    }

    let held = |of: &[f64], rows: &[usize], columns: &[usize]| -> Vec<f64> {
        rows.iter().flat_map(|row| columns.iter().map(move |column| of[row * n + column])).collect()
    };
    let points = &unknowns.points;
    let rest: Vec<usize> = (0..n).filter(|unknown| !points.contains(unknown)).collect();
    let spread = |values: &[f64], into: &mut Vec<f64>| {
        rest.iter().zip(values).for_each(|(place, value)| into[*place] = *value);
    };
    let mut vectors: Vec<Vec<f64>> = Vec::new();
    let stiffness_of_rest = held(&stiffness, &rest, &rest);
    if let Some(factor) = Cholesky::new(stiffness_of_rest.clone(), rest.len()) {
        for point in points {
            let mut right: Vec<f64> = rest.iter().map(|row| -stiffness[row * n + point]).collect();
            factor.solve(&mut right);
            let mut vector = vec![0.0; n];
            vector[*point] = 1.0;
            spread(&right, &mut vector);
            vectors.push(vector);
        }
    }
    // The elements between held points are positive definite: there is a shape for each.
    debug_assert_eq!(vectors.len(), points.len());
    for values in lowest(&held(&mass, &rest, &rest), &stiffness_of_rest, rest.len(), modes) {
        let mut vector = vec![0.0; n];
        spread(&values, &mut vector);
        vectors.push(vector);
    }

    let count = vectors.len();
    let form = |of: &[f64]| -> Vec<f64> {
        let products: Vec<Vec<f64>> = vectors.iter().map(|vector| loosepin_math::dense::multiply(of, vector)).collect();
        vectors
            .iter()
            .flat_map(|row| products.iter().map(|product| row.iter().zip(product).map(|(a, b)| a * b).sum()))
            .collect()
    };
    let own = eigenvectors(&form(&mass), &form(&stiffness), count);
    own.iter()
        .map(|weights| {
            let mut sum = vec![0.0; n];
            for (weight, vector) in weights.iter().zip(&vectors) {
                sum.iter_mut().zip(vector).for_each(|(sum, value)| *sum += weight * value);
            }
            shape(&unknowns, nodes, &sum)
        })
        .collect()
}

/// A shape of the unknowns, scaled.
fn shape(unknowns: &Unknowns, nodes: &[f64], values: &[f64]) -> PointShape {
    let coefficients = |places: &Vec<Option<usize>>| -> Vec<f64> {
        places.iter().map(|place| place.map_or(0.0, |place| values[place])).collect()
    };
    let mut found = PointShape { spans: unknowns.spans.iter().map(coefficients).collect() };
    let slopes: Vec<f64> =
        (0..nodes.len()).map(|node| found.spans[node.saturating_sub(1)][if node == 0 { 1 } else { 3 }]).collect();
    let largest = slopes.iter().fold(0.0_f64, |largest, slope| largest.max(slope.abs()));
    if let Some(slope) = slopes.into_iter().find(|slope| slope.abs() >= (1.0 - EQUAL) * largest && *slope != 0.0) {
        found.spans.iter_mut().flatten().for_each(|coefficient| *coefficient /= slope);
    }
    found
}

/// Places and weights of the Gauss rule with `points` points on a span.
pub(crate) fn span_rule(start: f64, end: f64, points: usize) -> impl Iterator<Item = [f64; 2]> {
    let length = end - start;
    // The weights of the rule add to one.
    legendre_rule(points).into_iter().map(move |(t, weight)| [start + 0.5 * length * (1.0 + t), length * weight])
}
