//! The first points of a box: corners, centre, interior; and candidates for later points.

use loosepin_uncertainty::{ScrambledSobol, SobolError, hash};

/// Up to this many dimensions all corners are used.
const ALL_CORNERS_DIMENSIONS: usize = 4;

/// Candidates inside the box; as many more lie on its faces.
const INTERIOR_CANDIDATES: u32 = 192;

/// Streams of random numbers.
const FIRST_POINTS: u64 = 0x006f_7574_6572;
const CANDIDATES: u64 = 0x6361_6e64;

/// Number of corners and the centre of a box; one where it is a point.
pub(crate) fn structural_point_count(dimensions: usize) -> usize {
    if dimensions == 0 { 1 } else { corners(dimensions).len() + 1 }
}

/// Corners of the unit box: all of them up to four dimensions, beyond that a two-level orthogonal array of strength 2 and
/// its mirror image (together of strength 3: every combination of any three inputs occurs equally often).
///
/// Rows of a Sylvester-Hadamard matrix, corner_ij = parity(i & (j + 1)); R. L. Plackett and J. P. Burman, "The design of
/// optimum multifactorial experiments", Biometrika 33 (1946) 305-325.
pub(crate) fn corners(dimensions: usize) -> Vec<Vec<f64>> {
    let level = |bit: bool| if bit { 1.0 } else { 0.0 };
    if dimensions <= ALL_CORNERS_DIMENSIONS {
        return (0..1_usize << dimensions)
            .map(|corner| (0..dimensions).map(|j| level(corner >> j & 1 == 1)).collect())
            .collect();
    }
    let rows = (dimensions + 1).next_power_of_two();
    (0..2 * rows)
        .map(|row| {
            let mirrored = row >= rows;
            (0..dimensions).map(|j| level(((row % rows) & (j + 1)).count_ones() % 2 == 1) != level(mirrored)).collect()
        })
        .map(|signs: Vec<bool>| signs.into_iter().map(level).collect())
        .collect()
}

/// The first `count` points of a search: corners, centre, then low-discrepancy points of the interior.
pub(crate) fn first_points(seed: u64, dimensions: usize, count: usize) -> Result<Vec<Vec<f64>>, SobolError> {
    let mut points = corners(dimensions);
    points.push(vec![0.5; dimensions]);
    let interior = ScrambledSobol::try_new(hash(seed, FIRST_POINTS), dimensions)?;
    for index in 0..count.saturating_sub(points.len()) as u32 {
        let mut point = vec![0.0; dimensions];
        interior.write_point(0, index, &mut point);
        points.push(point);
    }
    points.truncate(count);
    Ok(points)
}

/// Places at which a model of the response is asked where to look next: corners, points of all faces, interior points.
pub(crate) fn candidates(dimensions: usize) -> Result<Vec<Vec<f64>>, SobolError> {
    let sobol = ScrambledSobol::try_new(CANDIDATES, 2 * dimensions)?;
    let mut points = corners(dimensions);
    let mut coordinates = vec![0.0; 2 * dimensions];
    for index in 0..2 * INTERIOR_CANDIDATES {
        sobol.write_point(0, index, &mut coordinates);
        let (inside, side) = coordinates.split_at(dimensions);
        // The first half are interior points, the second half lie on faces of every dimension down to the edges.
        let share_on_faces = if index < INTERIOR_CANDIDATES { 0.0 } else { f64::from(1 + index % 3) / 4.0 };
        let point = inside.iter().zip(side).map(|(&value, &side)| {
            if side < 0.5 * share_on_faces {
                0.0
            } else if side > 1.0 - 0.5 * share_on_faces {
                1.0
            } else {
                value
            }
        });
        points.push(point.collect());
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::{candidates, corners, first_points};

    #[test]
    fn identity_every_combination_of_three_inputs_occurs_equally_often() {
        for dimensions in 5..=12 {
            let corners = corners(dimensions);
            for triple in [[0, 1, 2], [0, 2, 4], [1, 3, 4], [2, 3, dimensions - 1]] {
                let mut counts = [0; 8];
                for corner in &corners {
                    let pattern = triple.iter().fold(0, |sum, &j| 2 * sum + corner[j] as usize);
                    counts[pattern] += 1;
                }
                assert!(counts.iter().all(|&count| count == counts[0]), "{dimensions} {triple:?} {counts:?}");
            }
        }
    }

    #[test]
    fn identity_corners_and_centre_come_first() {
        let points = first_points(3, 2, 9).unwrap();
        assert_eq!(points[..5], [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.5]]);
        assert_eq!(points.len(), 9);
        assert!(points[5..].iter().flatten().all(|&x| x > 0.0 && x < 1.0));
    }

    #[test]
    fn identity_candidates_lie_on_every_face() {
        let candidates = candidates(3).unwrap();
        for dimension in 0..3 {
            for side in [0.0, 1.0] {
                assert!(candidates.iter().filter(|point| point[dimension] == side).count() > 20);
            }
        }
    }
}
