//! What connects the points of a body: lines, and faces of their convex hull.

use loosepin_math::Vec3;

/// Most points of which the hull is made; a body with more is drawn as lines from point to point.
const MAX_POINTS: usize = 40;

/// Lines and faces by the numbers of their points.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Shape {
    pub lines: Vec<Vec<usize>>,
    pub faces: Vec<Vec<usize>>,
}

/// A bar through points on a line, a polygon around points in a plane, the faces of the hull around others. Points inside are connected to the
/// nearest corner. What is closer than `same_m` is together.
pub(super) fn shape(points: &[Vec3], same_m: f64) -> Shape {
    if points.len() < 2 {
        return Shape::default();
    }
    let (first, far) = ends(points);
    let Some(along) = (points[far] - points[first]).normalised() else { return Shape::default() };
    let off_line = |point: Vec3| (point - points[first] - along * along.dot(point - points[first])).length();
    let side = farthest(points, off_line);
    if off_line(points[side]) <= same_m || points.len() > MAX_POINTS {
        let mut order: Vec<usize> = (0..points.len()).collect();
        if points.len() <= MAX_POINTS {
            order.sort_by(|a, b| along.dot(points[*a]).total_cmp(&along.dot(points[*b])));
        }
        return Shape { lines: vec![order], faces: Vec::new() };
    }
    let Some(normal) = along.cross(points[side] - points[first]).normalised() else { return Shape::default() };
    let off_plane = |point: Vec3| normal.dot(point - points[first]).abs();
    let is_flat = off_plane(points[farthest(points, off_plane)]) <= same_m;
    let faces = if is_flat { vec![polygon(points, along, normal)] } else { hull_faces(points, same_m) };
    let lines = (0..points.len()).filter(|k| faces.iter().all(|face| !face.contains(k))).filter_map(|inside| {
        let corners = faces.iter().flatten().copied();
        let distance = |corner: usize| (points[corner] - points[inside]).length();
        Some(vec![inside, corners.min_by(|a, b| distance(*a).total_cmp(&distance(*b)))?])
    });
    Shape { lines: lines.collect(), faces: faces.clone() }
}

/// Two points far apart: of two points the first and the second; else the one farthest from the first and, before it, the one farthest from that.
fn ends(points: &[Vec3]) -> (usize, usize) {
    let from = |origin: Vec3| farthest(points, move |point| (point - origin).length());
    let first = from(points[0]);
    (from(points[first]), first)
}

fn farthest(points: &[Vec3], distance: impl Fn(Vec3) -> f64) -> usize {
    let of = |k: &usize| distance(points[*k]);
    // The first of several alike.
    (0..points.len()).rev().max_by(|a, b| of(a).total_cmp(&of(b))).unwrap_or(0)
}

/// Corners of the convex hull of points in a plane, in their order round (gift wrapping).
fn polygon(points: &[Vec3], along: Vec3, normal: Vec3) -> Vec<usize> {
    let across = normal.cross(along);
    let flat: Vec<[f64; 2]> = points.iter().map(|point| [along.dot(*point), across.dot(*point)]).collect();
    let start =
        (0..flat.len()).min_by(|a, b| flat[*a][0].total_cmp(&flat[*b][0]).then(flat[*a][1].total_cmp(&flat[*b][1])));
    let Some(start) = start else { return Vec::new() };
    let turn = |o: usize, a: usize, b: usize| {
        let [ox, oy] = flat[o];
        (flat[a][0] - ox) * (flat[b][1] - oy) - (flat[a][1] - oy) * (flat[b][0] - ox)
    };
    let length = |a: usize, b: usize| (flat[b][0] - flat[a][0]).hypot(flat[b][1] - flat[a][1]);
    let mut corners = vec![start];
    let mut at = start;
    loop {
        let others = (0..flat.len()).filter(|k| *k != at);
        let next = others.reduce(|best, k| {
            let side = turn(at, best, k);
            if side < 0.0 || (side == 0.0 && length(at, k) > length(at, best)) { k } else { best }
        });
        match next {
            Some(next) if next != start && corners.len() < flat.len() => {
                corners.push(next);
                at = next;
            }
            _ => return corners,
        }
    }
}

/// Triangles of three points that have all others on one side; of faces with more corners one polygon.
fn hull_faces(points: &[Vec3], same_m: f64) -> Vec<Vec<usize>> {
    let mut faces: Vec<Vec<usize>> = Vec::new();
    for a in 0..points.len() {
        for b in a + 1..points.len() {
            for c in b + 1..points.len() {
                if faces.iter().any(|face| [a, b, c].iter().all(|corner| face.contains(corner))) {
                    continue;
                }
                let along = (points[b] - points[a]).normalised();
                let normal = (points[b] - points[a]).cross(points[c] - points[a]).normalised();
                let Some((along, normal)) = along.zip(normal) else { continue };
                let heights = points.iter().map(|point| normal.dot(*point - points[a]));
                let [low, high] = heights.fold([0.0_f64; 2], |[low, high], own| [low.min(own), high.max(own)]);
                if low < -same_m && high > same_m {
                    continue;
                }
                let in_plane = |k: &usize| normal.dot(points[*k] - points[a]).abs() <= same_m;
                let numbers: Vec<usize> = (0..points.len()).filter(in_plane).collect();
                let own: Vec<Vec3> = numbers.iter().map(|k| points[*k]).collect();
                let corners = polygon(&own, along, normal).into_iter().map(|k| numbers[k]).collect::<Vec<usize>>();
                if !faces.contains(&corners) {
                    faces.push(corners);
                }
            }
        }
    }
    faces
}

#[cfg(test)]
mod tests {
    use super::shape;
    use loosepin_math::Vec3;

    #[test]
    fn analytic_a_line_a_square_and_a_cube() {
        let line: Vec<Vec3> = [0.3, 0.1, 0.7].map(|x| Vec3::new(x, 2.0 * x, -x)).to_vec();
        let found = shape(&line, 1e-9);
        assert!(found.faces.is_empty());
        assert!(found.lines == [vec![1, 0, 2]] || found.lines == [vec![2, 0, 1]], "{found:?}");
        // Its middle is no corner.
        let square = [[0.0, 0.0], [0.4, 0.0], [0.2, 0.2], [0.4, 0.4], [0.0, 0.4]];
        let square: Vec<Vec3> = square.iter().map(|[x, y]| Vec3::new(*x, 0.5 * x, *y)).collect();
        let found = shape(&square, 1e-9);
        assert_eq!((found.faces.len(), found.faces[0].len(), found.lines.len()), (1, 4, 1));
        let cube: Vec<Vec3> =
            (0..8).map(|k| Vec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)) * 0.2).collect();
        let found = shape(&cube, 1e-9);
        assert_eq!((found.faces.len(), found.lines.len()), (6, 0));
        assert!(found.faces.iter().all(|face| face.len() == 4), "{found:?}");
        assert!(shape(&cube[..1], 1e-9).lines.is_empty());
    }
}
