//! The largest linear function on a product of unit balls, cut by planes.
//!
//! For blocks v_k, |v_k| <= 1: maximise g·v - τ|v - v0|²/2 with H v = b. By a primal-dual interior point method (S. Boyd, L. Vandenberghe,
//! Convex Optimization, 2004, 11.7) with s_k = (1 - |v_k|²)/2 and multipliers z_k:
//!
//! ```text
//! -g + τ(v - v0) + z_k v_k + Hᵀλ = 0,   H v = b,   z_k s_k = μ → 0
//! ```
//!
//! A step costs as much as the blocks and one system of the order of H. A single plane has one multiplier, which is found directly
//! ([`on_plane`]).

use crate::accuracy::linear::near::Near;
use crate::accuracy::linear::one_plane::on_plane;
use crate::accuracy::linear::planes::Planes;
use crate::accuracy::linear::vectors::{add, dot};
use crate::accuracy::play_set::PlaySet;
use loosepin_math::RealLu;

/// Most steps; 20 are usual.
const MAX_STEPS: usize = 100;
/// μ of a step as a share of the present one.
const CENTRING: f64 = 0.1;
/// Share of the way to the border that a step goes.
const STAY_INSIDE: f64 = 0.995;
/// μ at the end, relative to the gains.
const SMALLEST_GAP: f64 = 1e-15;
/// Residuals at the end, relative to the gains and to one.
const SMALL_RESIDUAL: f64 = 1e-12;

/// Distance of bound and value, or from the planes, with which a search ends without an answer, relative to the gains and to one.
const WORST_MISS: f64 = 1e-6;

/// The largest value.
#[derive(Debug, Clone)]
pub(crate) struct Largest {
    /// Where it is.
    pub place: Vec<f64>,
    /// λ of the rows of H.
    pub multipliers: Vec<f64>,
    /// g - Hᵀλ.
    pub rest: Vec<f64>,
}

/// Solves the problem of the head of this file; `rows` is the number of rows of H. `None` if no inner place of the planes was found.
pub(crate) fn largest(set: &PlaySet, gains: &[f64], near: Option<Near>, planes: &Planes, b: &[f64]) -> Option<Largest> {
    let scale = set.support(gains).iter().sum::<f64>();
    let scale = if scale > 0.0 { scale } else { 1.0 };
    let gains: Vec<f64> = gains.iter().map(|gain| gain / scale).collect();
    let near = near.map(|near| Near { weight: near.weight / scale, ..near });
    let right = planes.right_hand_side(b);
    let found = match (planes.rows.as_slice(), right.as_slice()) {
        ([], _) => Some((on_balls(set, &gains, near), Vec::new())),
        ([row], [b]) => on_plane(set, &gains, near, row, *b).map(|(place, multiplier)| (place, vec![multiplier])),
        _ => None,
    };
    let found = found.or_else(|| inner_point(set, &gains, near, planes, &right));
    let (place, own) = found?;
    let rest = planes.less(&gains, &own).iter().map(|gain| gain * scale).collect();
    let own: Vec<f64> = own.iter().map(|value| value * scale).collect();
    Some(Largest { place, multipliers: planes.multipliers(&own, b.len()), rest })
}

/// Without planes: each block along its gains, or at the point of its ball nearest to v0 + g/τ.
fn on_balls(set: &PlaySet, gains: &[f64], near: Option<Near>) -> Vec<f64> {
    let mut place = match near {
        Some(near) if near.weight > 0.0 => {
            near.place.iter().zip(gains).map(|(at, gain)| at + gain / near.weight).collect()
        }
        _ => gains.to_vec(),
    };
    for block in set.blocks() {
        let length = PlaySet::length(block, &place);
        let is_free = near.is_none_or(|near| near.weight <= 0.0);
        let divisor = if is_free { length } else { length.max(1.0) };
        if divisor > 0.0 {
            place[block.range()].iter_mut().for_each(|value| *value /= divisor);
        }
    }
    place
}

/// The state of the method.
struct Iterate {
    v: Vec<f64>,
    z: Vec<f64>,
    multipliers: Vec<f64>,
}

fn inner_point(
    set: &PlaySet,
    gains: &[f64],
    near: Option<Near>,
    planes: &Planes,
    b: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let blocks = set.blocks();
    let v = inner_start(set, planes, b)?;
    // The same μ of all blocks, one half, however near to the border they are.
    let z = blocks.iter().map(|block| 1.0 / (1.0 - PlaySet::square(block, &v))).collect();
    let mut at = Iterate { v, z, multipliers: vec![0.0; planes.count()] };
    let weight = near.map_or(0.0, |near| near.weight);
    let count = blocks.len() as f64;
    // Where multipliers are not unique, as of two discs that a plane holds together, the system becomes singular towards the end and round-off
    // spoils the last steps. The best one counts: any multipliers give an upper bound, the place reaches a value on the planes.
    let mut best = (f64::INFINITY, at.v.clone(), at.multipliers.clone());
    for _ in 0..MAX_STEPS {
        let slacks: Vec<f64> = blocks.iter().map(|block| 0.5 * (1.0 - PlaySet::square(block, &at.v))).collect();
        let gap: f64 = at.z.iter().zip(&slacks).map(|(z, s)| z * s).sum();
        let mut dual = planes.less(gains, &at.multipliers);
        for (block, z) in blocks.iter().zip(&at.z) {
            for k in block.range() {
                let pull = near.map_or(0.0, |near| near.weight * (at.v[k] - near.place[k]));
                dual[k] -= pull + z * at.v[k];
            }
        }
        let primal: Vec<f64> = planes.rows.iter().zip(b).map(|(row, b)| dot(row, &at.v) - b).collect();
        let residual = dual.iter().chain(&primal).fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let miss = match near {
            // Any multipliers bound the largest value from above: Σ|g - Hᵀλ| + λ·b.
            None => {
                let bound = set.support(&planes.less(gains, &at.multipliers)).iter().sum::<f64>();
                bound + dot(&at.multipliers, b) - dot(gains, &at.v)
            }
            Some(_) => gap,
        };
        let miss = primal.iter().fold(miss.abs(), |largest: f64, value| largest.max(value.abs()));
        if miss < best.0 {
            best = (miss, at.v.clone(), at.multipliers.clone());
        }
        if gap <= SMALLEST_GAP * count && residual <= SMALL_RESIDUAL {
            break;
        }
        if !(gap.is_finite() && residual.is_finite()) {
            break;
        }
        let target = CENTRING * gap / count;
        let Some(step) = newton_step(set, &at, weight, &slacks, &dual, &primal, planes, target) else { break };
        let share = STAY_INSIDE * step_inside(set, &at, &step);
        let share = share.min(1.0);
        if !(share > 1e-12) {
            break;
        }
        add(&mut at.v, &step.v, share);
        add(&mut at.z, &step.z, share);
        add(&mut at.multipliers, &step.multipliers, share);
    }
    (best.0 <= WORST_MISS).then_some((best.1, best.2))
}

/// A place on the planes inside all balls: the nearest to the middle, then by projections on planes and smaller balls in turn. Where planes hardly
/// reach into the balls, the place is near the border.
fn inner_start(set: &PlaySet, planes: &Planes, b: &[f64]) -> Option<Vec<f64>> {
    const INSIDE: f64 = 0.98;
    const MAX_PROJECTIONS: usize = 2000;
    const HARDLY_INSIDE: f64 = 1.0 - 1e-6;
    let mut v = vec![0.0; set.variables()];
    let mut best = (HARDLY_INSIDE, None);
    for _ in 0..MAX_PROJECTIONS {
        for (row, b) in planes.rows.iter().zip(b) {
            let miss = b - dot(row, &v);
            add(&mut v, row, miss);
        }
        let outside = set.blocks().iter().map(|block| PlaySet::length(block, &v)).fold(0.0, f64::max);
        if outside < 0.999 {
            return Some(v);
        }
        if outside < best.0 {
            best = (outside, Some(v.clone()));
        }
        for block in set.blocks() {
            let length = PlaySet::length(block, &v);
            if length > INSIDE {
                v[block.range()].iter_mut().for_each(|value| *value *= INSIDE / length);
            }
        }
    }
    best.1
}

#[allow(clippy::too_many_arguments, reason = "the parts of one system of equations")]
fn newton_step(
    set: &PlaySet,
    at: &Iterate,
    weight: f64,
    slacks: &[f64],
    dual: &[f64],
    primal: &[f64],
    planes: &Planes,
    target: f64,
) -> Option<Iterate> {
    let blocks = set.blocks();
    // D⁻¹ u of a block: (u - κ v (v·u))/(τ + z), κ = (z/s)/(τ + z + |v|² z/s).
    let apply = |vector: &[f64]| {
        let mut result = vector.to_vec();
        for (k, block) in blocks.iter().enumerate() {
            let (own, ratio, sum) = (&at.v[block.range()], at.z[k] / slacks[k], weight + at.z[k]);
            let share = ratio / (sum + ratio * dot(own, own)) * dot(own, &vector[block.range()]);
            for (entry, v) in result[block.range()].iter_mut().zip(own) {
                *entry = (*entry - share * v) / sum;
            }
        }
        result
    };
    let mut right = dual.to_vec();
    for (k, block) in blocks.iter().enumerate() {
        let push = (target - at.z[k] * slacks[k]) / slacks[k];
        right[block.range()].iter_mut().zip(&at.v[block.range()]).for_each(|(entry, v)| *entry -= v * push);
    }
    let images: Vec<Vec<f64>> = planes.rows.iter().map(|row| apply(row)).collect();
    let count = planes.count();
    let mut schur = RealLu::new(count);
    for (i, row) in planes.rows.iter().enumerate() {
        images.iter().enumerate().for_each(|(j, image)| schur.matrix[i * count + j] = dot(row, image));
    }
    schur.factor();
    let first = apply(&right);
    let mut multipliers: Vec<f64> = planes.rows.iter().zip(primal).map(|(row, miss)| dot(row, &first) + miss).collect();
    schur.solve(&mut multipliers);
    if !multipliers.iter().all(|value| value.is_finite()) {
        return None;
    }
    let v = apply(&planes.less(&right, &multipliers));
    let z = blocks.iter().enumerate().map(|(k, block)| {
        let along = dot(&at.v[block.range()], &v[block.range()]);
        (target - at.z[k] * slacks[k] + at.z[k] * along) / slacks[k]
    });
    Some(Iterate { z: z.collect(), v, multipliers })
}

/// How far a step may go until a ball or a multiplier ends.
fn step_inside(set: &PlaySet, at: &Iterate, step: &Iterate) -> f64 {
    let mut share = f64::INFINITY;
    for (k, block) in set.blocks().iter().enumerate() {
        if step.z[k] < 0.0 {
            share = share.min(-at.z[k] / step.z[k]);
        }
        let (v, d) = (&at.v[block.range()], &step.v[block.range()]);
        let (a, half, c) = (dot(d, d), dot(v, d), dot(v, v) - 1.0);
        let root = (half * half - a * c).max(0.0).sqrt();
        if a > 0.0 {
            // The positive root, without a difference of like numbers.
            share = share.min(if half > 0.0 { -c / (half + root) } else { (root - half) / a });
        }
    }
    share
}

#[cfg(test)]
mod tests {
    use super::{Near, dot, inner_point, largest, on_plane};
    use crate::accuracy::linear::planes::Planes;
    use crate::accuracy::play_set::PlaySet;
    use crate::play::block::{Block, PlayPart};
    use crate::random::random;

    /// What an interior point method leaves.
    const TOLERANCE: f64 = 1e-10;

    fn set(parts: &[PlayPart]) -> PlaySet {
        parts.iter().fold(PlaySet::empty(), |set, part| set.with_block(Block { part: *part, radius: 1.0 }))
    }

    #[test]
    fn analytic_a_cylinder_cut_by_a_tilted_plane() {
        // Disc (x, y) and interval z with z = 2x: x is at most 1/2. Largest x + y: x = 1/2, y = √3/2; largest 2x + y/10: x = 1/2 as well.
        let set = set(&[PlayPart::Across, PlayPart::Axial]);
        let planes = Planes::new(&[vec![-2.0, 0.0, 1.0]], 3, 1e-12);
        for (gains, expected) in [
            ([1.0, 1.0, 0.0], 0.5 + 0.75_f64.sqrt()),
            ([2.0, 0.1, 0.0], 1.0 + 0.1 * 0.75_f64.sqrt()),
            ([0.0, 1.0, 0.0], 1.0),
        ] {
            let found = largest(&set, &gains, None, &planes, &[0.0]).unwrap();
            let reached: f64 = gains.iter().zip(&found.place).map(|(gain, value)| gain * value).sum();
            let bound: f64 = set.support(&found.rest).iter().sum();
            assert!((reached - expected).abs() < TOLERANCE, "{reached} {expected}");
            assert!((bound - expected).abs() < TOLERANCE, "{bound} {expected}");
            assert!((found.place[2] - 2.0 * found.place[0]).abs() < TOLERANCE);
        }
        // Moved off the middle, z = 2x + b: x is at most (1 - b)/2. The multiplier of the plane times b is a part of the bound.
        for b in [0.3_f64, -0.7] {
            let x = 0.5 * (1.0 - b);
            let expected = x + (1.0 - x * x).max(0.0).sqrt();
            let expected = if x > 0.5_f64.sqrt() { 2.0_f64.sqrt() } else { expected };
            let found = largest(&set, &[1.0, 1.0, 0.0], None, &planes, &[b]).unwrap();
            assert!(
                (found.place[0] + found.place[1] - expected).abs() < TOLERANCE,
                "{b}: {:?} {expected}",
                found.place
            );
        }
        // Planes that repeat each other are one; a plane outside has no place.
        let twice = Planes::new(&[vec![-2.0, 0.0, 1.0], vec![-4.0, 0.0, 2.0]], 3, 1e-12);
        assert_eq!(twice.count(), 1);
        assert!(
            largest(&set, &[1.0, 0.0, 0.0], None, &Planes::new(&[vec![1.0, 0.0, 0.0]], 3, 1e-12), &[2.0]).is_none()
        );
    }

    #[test]
    fn analytic_a_ball_cut_beside_its_middle() {
        // x = b in the unit ball: largest x + y is b + √(1 - b²), smallest b - √(1 - b²), however near to the border.
        let set = set(&[PlayPart::Ball]);
        let planes = Planes::new(&[vec![2.0, 0.0, 0.0]], 3, 1e-12);
        for b in [0.0_f64, 0.3, -0.7, 0.99, 0.9999] {
            for sign in [1.0, -1.0] {
                let gains = [sign, sign, 0.0];
                let found = largest(&set, &gains, None, &planes, &[2.0 * b]).unwrap();
                let reached: f64 = gains.iter().zip(&found.place).map(|(gain, value)| gain * value).sum();
                let expected = sign * b + (1.0 - b * b).sqrt();
                assert!((reached - expected).abs() < TOLERANCE, "{reached} {expected}");
                let bound = set.support(&found.rest).iter().sum::<f64>() + found.multipliers[0] * 2.0 * b;
                assert!((bound - expected).abs() < TOLERANCE, "{bound} {expected}");
            }
        }
    }

    #[test]
    fn identity_one_plane_by_its_multiplier_and_by_inner_points() {
        const PARTS: [PlayPart; 7] = [
            PlayPart::Across,
            PlayPart::Axial,
            PlayPart::Ball,
            PlayPart::FirstEnd,
            PlayPart::SecondEnd,
            PlayPart::Axial,
            PlayPart::Axial,
        ];
        let set = set(&PARTS);
        let mut state = 5;
        let (mut jumps, mut compared) = (0, 0);
        for case in 0..400 {
            let mut numbers = || (0..set.variables()).map(|_| random(&mut state)).collect::<Vec<f64>>();
            let (mut gains, mut row, place) = (numbers(), numbers(), numbers());
            // Intervals that decide, blocks that are not in the plane, gains along it.
            if case % 3 == 1 {
                gains[2] *= 10.0;
                row[2] *= 10.0;
            }
            if case % 5 == 2 {
                row[0..2].fill(0.0);
                (gains[6], gains[7]) = (0.3 * row[6], 0.3 * row[7]);
            }
            let planes = Planes::new(&[row], set.variables(), 1e-12);
            let scale: f64 = set.support(&gains).iter().sum();
            gains.iter_mut().for_each(|gain| *gain /= scale);
            let reach: f64 = set.support(&planes.rows[0]).iter().sum();
            let b = [0.8 * reach * random(&mut state)];
            for near in [None, Some(Near { weight: 0.1, place: &place }), Some(Near { weight: 3.0, place: &place })] {
                let (one, multiplier) = on_plane(&set, &gains, near, &planes.rows[0], b[0]).unwrap();
                assert!((dot(&planes.rows[0], &one) - b[0]).abs() < 1e-13, "{case}");
                assert!(set.support(&one).iter().all(|length| *length < 1.0 + 1e-14), "{case}");
                if near.is_none() {
                    // What the multiplier bounds from above is reached.
                    let rest = planes.less(&gains, &[multiplier]);
                    let bound = set.support(&rest).iter().sum::<f64>() + multiplier * b[0];
                    assert!((bound - dot(&gains, &one)).abs() < 1e-14, "{case}: {bound} {}", dot(&gains, &one));
                    jumps += usize::from(set.support(&one).iter().any(|length| *length < 1.0 - 1e-9));
                }
                // Inner points do not come to an end everywhere.
                let Some((other, _)) = inner_point(&set, &gains, near, &planes, &b) else { continue };
                compared += 1;
                // A disc whose gains are all along the plane's may lie anywhere across them.
                let is_unique = case % 5 != 2 || near.is_some();
                for (a, b) in one.iter().zip(&other).filter(|_| is_unique) {
                    assert!((a - b).abs() < 1e-6, "{case} {near:?}: {one:?} {other:?}");
                }
                if near.is_none() {
                    assert!((dot(&gains, &one) - dot(&gains, &other)).abs() < 1e-9, "{case}: {one:?} {other:?}");
                }
            }
        }
        assert!(compared > 1000, "{compared}");
        assert!(jumps > 50 && jumps < 350, "{jumps}");
    }

    #[test]
    fn analytic_near_a_place() {
        // Maximise x - τ|v - v0|²/2 in a ball: at v0 + g/τ where that is inside, else on the border in its direction.
        let set = set(&[PlayPart::Ball]);
        let none = Planes::new(&[], 3, 0.0);
        let near = |weight| Near { weight, place: &[0.1, 0.2, 0.0] };
        let inside = largest(&set, &[1.0, 0.0, 0.0], Some(near(2.0)), &none, &[]).unwrap().place;
        assert!((inside[0] - 0.6).abs() < TOLERANCE && (inside[1] - 0.2).abs() < TOLERANCE);
        let outside = largest(&set, &[1.0, 0.0, 0.0], Some(near(0.5)), &none, &[]).unwrap().place;
        let length = 2.1_f64.hypot(0.2);
        assert!((outside[0] - 2.1 / length).abs() < TOLERANCE && (outside[1] - 0.2 / length).abs() < TOLERANCE);
        // The same with a plane z = 0.3 across it: v0 + g/τ projected on it.
        let plane = Planes::new(&[vec![0.0, 0.0, 1.0]], 3, 1e-12);
        let cut = largest(&set, &[1.0, 0.0, 0.0], Some(near(2.0)), &plane, &[0.3]).unwrap().place;
        assert!((cut[0] - 0.6).abs() < 1e-6 && (cut[1] - 0.2).abs() < 1e-6 && (cut[2] - 0.3).abs() < TOLERANCE);
    }
}
