//! After how many turns a motion repeats itself.

use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Mechanism, PlayGeometry, Sample};
use loosepin_result::simulation::REPEAT_SHARE;
use std::f64::consts::TAU;

/// Numbers that return where a motion repeats itself, read once a turn: the eccentricity of every joint with play, the tilt of
/// every slider in its guide, and for a
/// mechanism that its drives do not move alone position, angle and both rates (a turn as the unit of time) of every body.
pub fn section(dynamics: &Dynamics<'_, f64>, turn_s: f64) -> Vec<Vec2<f64>> {
    let mut section: Vec<Vec2<f64>> = dynamics.plays().iter().map(|motion| motion.eccentricity_m).collect();
    for (motion, numbers) in dynamics.plays().iter().zip(&dynamics.sample().plays) {
        if numbers.shape.block().is_some() {
            let [line, axis] = motion.directions;
            section.push(Vec2::new(line.cross(axis), 0.0));
        }
    }
    let mechanism = dynamics.mechanism();
    if !mechanism.is_driven() {
        for slot in 1..=mechanism.real.links.len() {
            let (pose, twist) = (&dynamics.kinematics.poses[slot], &dynamics.kinematics.twists[slot]);
            let turn = turn_s / TAU;
            section.extend([
                pose.position_m,
                Vec2::new(pose.rotation.cosine, pose.rotation.sine),
                twist.linear * turn,
                Vec2::new(twist.angular * turn, 0.0),
            ]);
        }
    }
    section
}

/// The sizes that go with [`section`]: the clearances, and over half the length of a slider for its tilt; a tenth of the mechanism's size for positions, a tenth of a radian
/// for angles.
pub fn section_sizes(mechanism: &Mechanism, sample: &Sample<f64>) -> Vec<f64> {
    // A follower that may lift off its cam has no clearance: as much as a body.
    let size_m =
        |play: &PlayGeometry<f64>| if play.shape.may_lift() { 0.1 * mechanism.size_m } else { play.clearance_m };
    let mut sizes: Vec<f64> = sample.plays.iter().map(size_m).collect();
    let tilt_rad = |play: &PlayGeometry<f64>| Some(play.clearance_m / play.shape.block()?.half_length_m);
    sizes.extend(sample.plays.iter().filter_map(tilt_rad));
    if !mechanism.is_driven() {
        let length_m = 0.1 * mechanism.size_m;
        for _ in &mechanism.real.links {
            sizes.extend([length_m, 0.1, length_m, 0.1]);
        }
    }
    sizes
}

/// The smallest number of turns p, at most half of those looked at, after which everything is back: |e(k + p) - e(k)| within
/// [`REPEAT_SHARE`] of its size for all turns k. `None` if there is none: the motion has not settled, has a longer period,
/// or never repeats itself.
///
/// `sections`: what [`section`] reads, once a turn; `sizes`: what [`section_sizes`] says.
pub fn period_turns(sections: &[Vec<Vec2<f64>>], sizes: &[f64]) -> Option<usize> {
    let turns = sections.len();
    let is_back = |before: &[Vec2<f64>], after: &[Vec2<f64>]| {
        let mut parts = before.iter().zip(after).zip(sizes);
        parts.all(|((before, after), size)| (*after - *before).length() <= REPEAT_SHARE * size)
    };
    (1..=turns / 2).find(|&period| (period..turns).all(|k| is_back(&sections[k - period], &sections[k])))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLEARANCE_M: f64 = 3e-4;

    fn sections(turns: usize, x_m: impl Fn(usize) -> f64) -> Vec<Vec<Vec2<f64>>> {
        (0..turns).map(|k| vec![Vec2::new(x_m(k), -1e-4), Vec2::new(2e-4, 0.7e-4)]).collect()
    }

    #[test]
    fn analytic_periods_of_one_two_and_three_turns() {
        let period = |x_m: &dyn Fn(usize) -> f64| period_turns(&sections(20, x_m), &[CLEARANCE_M, CLEARANCE_M]);
        assert_eq!(period(&|_| 1.3e-4), Some(1));
        assert_eq!(period(&|k| if k % 2 == 0 { 1.3e-4 } else { -0.4e-4 }), Some(2));
        assert_eq!(period(&|k| [1.3e-4, -0.4e-4, 0.9e-4][k % 3]), Some(3));
    }

    #[test]
    fn analytic_just_within_and_just_beyond_the_share() {
        let drift = |share: f64| {
            let jump_m = share * REPEAT_SHARE * CLEARANCE_M;
            period_turns(&sections(12, |k| if k < 11 { 1e-4 } else { 1e-4 + jump_m }), &[CLEARANCE_M, CLEARANCE_M])
        };
        assert_eq!(drift(0.99), Some(1));
        assert_eq!(drift(1.01), None);
    }

    #[test]
    fn analytic_a_period_longer_than_half_of_the_turns_is_not_claimed() {
        let seven = |turns| period_turns(&sections(turns, |k| 1e-4 * (k % 7) as f64), &[CLEARANCE_M, CLEARANCE_M]);
        assert_eq!(seven(14), Some(7));
        assert_eq!(seven(13), None);
        assert_eq!(period_turns(&[], &[]), None);
    }
}
