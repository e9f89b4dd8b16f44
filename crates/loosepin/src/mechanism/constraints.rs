//! The constraints of ideal joints that close loops: residual, Jacobian and acceleration bias.

use super::geometry::Geometry;
use super::kinematics::{Kinematics, acceleration_at, moved};
use super::tree::Tree;
use crate::math::{Real, Vec2};

/// Residuals Φ of all cut joints, in their order: m for points that should coincide or lie on a line, sine of the
/// angle for bodies that should not turn against each other.
#[inline(always)]
pub fn residuals<T: Real>(tree: &Tree, geometry: &Geometry<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let mut row = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&geometry.cuts) {
        let poses = cut.slots.map(|slot| kinematics.poses[slot]);
        let gap = poses[1].point_m(numbers.arms_m[1]) - poses[0].point_m(numbers.arms_m[0]);
        if cut.kind.is_on_line() {
            let (sine, cosine) = (poses[0].angle_rad + numbers.angles_rad[0]).sin_cos();
            out[row] = Vec2::new(-sine, cosine).dot(gap);
        } else {
            let gap = gap - numbers.eccentricity_m;
            out[row] = gap.x;
            out[row + 1] = gap.y;
        }
        if cut.kind.holds_angle() {
            let turn = poses[1].angle_rad + numbers.angles_rad[1] - poses[0].angle_rad - numbers.angles_rad[0];
            out[row + cut.kind.rows() - 1] = turn.sin_cos().0;
        }
        row += cut.kind.rows();
    }
}

/// The Jacobian dΦ/dz, row-major, `tree.constraint_rows()` × `tree.coordinates()` (driven coordinates last).
#[inline(always)]
pub fn jacobian<T: Real>(tree: &Tree, geometry: &Geometry<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let columns = tree.coordinates();
    out.fill(T::zero());
    let mut row = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&geometry.cuts) {
        let poses = cut.slots.map(|slot| kinematics.poses[slot]);
        let arms = [0, 1].map(|side| poses[side].turn(numbers.arms_m[side]));
        let gap = poses[1].position_m + arms[1] - poses[0].position_m - arms[0];
        let (sine, cosine) = (poses[0].angle_rad + numbers.angles_rad[0]).sin_cos();
        let (line, normal) = (Vec2::new(cosine, sine), Vec2::new(-sine, cosine));
        let turn = poses[1].angle_rad + numbers.angles_rad[1] - poses[0].angle_rad - numbers.angles_rad[0];
        let turn_cosine = turn.sin_cos().1;
        for (side, sign) in [(0, -T::one()), (1, T::one())] {
            let slot = cut.slots[side];
            if slot == 0 {
                continue;
            }
            let dependences = &tree.links[slot - 1].dependences;
            for (dependence, partial) in dependences.iter().zip(kinematics.partials(slot)) {
                let column = dependence.coordinate;
                let turning = T::from_f64(dependence.turning);
                let velocity = moved(*partial, arms[side].turned(), dependence.turning) * sign;
                if cut.kind.is_on_line() {
                    out[row * columns + column] += normal.dot(velocity);
                    if side == 0 {
                        // The normal turns with the guide: dn/dt = -ω d.
                        out[row * columns + column] -= turning * line.dot(gap);
                    }
                } else {
                    out[row * columns + column] += velocity.x;
                    out[(row + 1) * columns + column] += velocity.y;
                }
                if cut.kind.holds_angle() {
                    out[(row + cut.kind.rows() - 1) * columns + column] += turning * sign * turn_cosine;
                }
            }
        }
        row += cut.kind.rows();
    }
}

/// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`.
#[inline(always)]
pub fn biases<T: Real>(tree: &Tree, geometry: &Geometry<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let mut row = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&geometry.cuts) {
        let arms = [0, 1].map(|side| kinematics.poses[cut.slots[side]].turn(numbers.arms_m[side]));
        let poses = cut.slots.map(|slot| kinematics.poses[slot]);
        let twists = cut.slots.map(|slot| kinematics.twists[slot]);
        let changes = cut.slots.map(|slot| kinematics.biases[slot]);
        let acceleration =
            acceleration_at(&changes[1], &twists[1], arms[1]) - acceleration_at(&changes[0], &twists[0], arms[0]);
        if cut.kind.is_on_line() {
            let gap = poses[1].position_m + arms[1] - poses[0].position_m - arms[0];
            let velocity = twists[1].at(arms[1]) - twists[0].at(arms[0]);
            let (sine, cosine) = (poses[0].angle_rad + numbers.angles_rad[0]).sin_cos();
            let (line, normal) = (Vec2::new(cosine, sine), Vec2::new(-sine, cosine));
            let spin = twists[0].angular;
            // Second derivative of n·gap with dn/dt = -ω d and dd/dt = ω n.
            out[row] = normal.dot(acceleration)
                - T::from_f64(2.0) * spin * line.dot(velocity)
                - changes[0].angular * line.dot(gap)
                - spin.squared() * normal.dot(gap);
        } else {
            out[row] = acceleration.x;
            out[row + 1] = acceleration.y;
        }
        if cut.kind.holds_angle() {
            let turn = poses[1].angle_rad + numbers.angles_rad[1] - poses[0].angle_rad - numbers.angles_rad[0];
            let (sine, cosine) = turn.sin_cos();
            let spin = twists[1].angular - twists[0].angular;
            out[row + cut.kind.rows() - 1] = cosine * (changes[1].angular - changes[0].angular) - sine * spin.squared();
        }
        row += cut.kind.rows();
    }
}

/// Names the joint that constraint row `row` belongs to, as an index into `tree.cuts`.
pub fn cut_of_row(tree: &Tree, row: usize) -> usize {
    let mut first = 0;
    for (index, cut) in tree.cuts.iter().enumerate() {
        first += cut.kind.rows();
        if row < first {
            return index;
        }
    }
    tree.cuts.len() - 1
}
