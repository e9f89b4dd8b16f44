//! The largest deviation that is found over the play, the loops closed exactly.

use super::super::loops::{DisplacedLoops, LoopsPlace};
use super::super::play_reach::PlayReach;
use loosepin_math::Vec2;
use loosepin_mechanics::model::Position;

/// Steps from one start.
const STEPS: usize = 200;
/// The search from one start ends where a step gains less than this share of what has been gained.
const SETTLED: f64 = 1e-14;
/// A step that does not improve is shortened so often, each time to a quarter, before the search ends.
const SHORTENINGS: usize = 16;
/// Further starts where the loops cannot follow all displacements.
const STARTS_WHERE_BLOCKED: usize = 16;
/// The longest step, in units of the play: from any place to the border.
const LONGEST_STEP: f64 = 1e6;

/// Position of an extreme of an output.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstPosition {
    /// Output there minus output with all joints in the middle of their play, m or rad.
    pub deviation_si: f64,
    /// Displacements there ([`PlayReach`]), in the order of [`loosepin_mechanics::mechanism::Mechanism::plays`].
    pub displacements: Vec<Vec2<f64>>,
}

/// The extremes of one output that are found over all displacements that the clearances allow, the loops closed exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstCaseExtremes {
    /// The lowest value; its deviation is <= 0.
    pub lowest: WorstPosition,
    /// The highest value; its deviation is >= 0.
    pub highest: WorstPosition,
    /// Whether displacements were tried that the loops cannot follow, or only through a singular position.
    pub is_blocked: bool,
}

/// A sum of positions.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Objective<'o> {
    /// The positions.
    pub readings: &'o [Position],
    /// Which of them count, and how much.
    pub weights: &'o [(usize, f64)],
}

impl Objective<'_> {
    fn value(&self, loops: &DisplacedLoops<'_>) -> f64 {
        self.weights.iter().map(|(place, weight)| weight * loops.value(self.readings[*place])).sum()
    }
}

/// Lowest and highest value of an output over `reaches`, the loops closed exactly, from the position that `loops` was set to.
///
/// Each search climbs from a start: the middle of the play, [`starts_on_borders`] and each of `starts`. The extremes that it ends in are
/// local ones; more starts make a missed one less likely.
pub fn worst_case_extremes(
    loops: &mut DisplacedLoops<'_>,
    reading: Position,
    reaches: &[PlayReach],
    starts: &[Vec<Vec2<f64>>],
) -> WorstCaseExtremes {
    let objective = Objective { readings: &[reading], weights: &[(0, 1.0)] };
    let middle = vec![Vec2::zero(); reaches.len()];
    let all: Vec<&[Vec2<f64>]> = std::iter::once(&middle).chain(starts).map(Vec::as_slice).collect();
    let [lowest, highest] = [-1.0, 1.0].map(|sign| best_of(loops, objective, reaches, &all, sign));
    loops.centre();
    WorstCaseExtremes { is_blocked: lowest.1 || highest.1, lowest: lowest.0, highest: highest.0 }
}

/// Four starts on the borders of the play, the joints turned against each other by the golden angle, so that no two starts
/// agree.
pub fn starts_on_borders(reaches: &[PlayReach]) -> Vec<Vec<Vec2<f64>>> {
    const GOLDEN_ANGLE_RAD: f64 = 2.399_963_229_728_653;
    (0..4)
        .map(|quarter| {
            let angle_rad =
                |joint: usize| std::f64::consts::FRAC_PI_2 * f64::from(quarter) + GOLDEN_ANGLE_RAD * joint as f64;
            reaches.iter().enumerate().map(|(joint, reach)| reach.on_border(angle_rad(joint))).collect()
        })
        .collect()
}

/// The best end of searches from `starts`, the largest for the sign 1 and the smallest for -1, and whether the loops were in the way.
pub(in super::super) fn best_of(
    loops: &mut DisplacedLoops<'_>,
    objective: Objective<'_>,
    reaches: &[PlayReach],
    starts: &[&[Vec2<f64>]],
    sign: f64,
) -> (WorstPosition, bool) {
    best_from(loops, None, objective, reaches, starts, sign)
}

/// As [`best_of`], in the assembly of `other`: the deviation is counted from the position in the middle of the play as before.
pub(in super::super) fn best_across(
    loops: &mut DisplacedLoops<'_>,
    other: &LoopsPlace,
    objective: Objective<'_>,
    reaches: &[PlayReach],
    starts: &[&[Vec2<f64>]],
    sign: f64,
) -> WorstPosition {
    best_from(loops, Some(other), objective, reaches, starts, sign).0
}

fn best_from(
    loops: &mut DisplacedLoops<'_>,
    other: Option<&LoopsPlace>,
    objective: Objective<'_>,
    reaches: &[PlayReach],
    starts: &[&[Vec2<f64>]],
    sign: f64,
) -> (WorstPosition, bool) {
    loops.centre();
    let centred = objective.value(loops);
    let mut best = WorstPosition { deviation_si: 0.0, displacements: loops.displacements().to_vec() };
    let mut is_blocked = false;
    // Whether the loops were in the way.
    let mut from = |start: &[Vec2<f64>], best: &mut WorstPosition| {
        match other {
            Some(place) => loops.put(place),
            None => loops.centre(),
        }
        if loops.displace(start).is_err() {
            return true;
        }
        let is_blocked = climb(loops, objective, reaches, sign);
        let deviation_si = objective.value(loops) - centred;
        if sign * (deviation_si - best.deviation_si) > 0.0 {
            *best = WorstPosition { deviation_si, displacements: loops.displacements().to_vec() };
        }
        is_blocked
    };
    for start in starts {
        is_blocked |= from(start, &mut best);
    }
    if is_blocked {
        // Where the play is cut off by a singular position an extreme may lie on the edge of what is left: more starts.
        for index in 0..STARTS_WHERE_BLOCKED {
            from(&scattered(reaches, index), &mut best);
        }
    }
    (best, is_blocked)
}

/// Places all over the play, the joints independent of each other: multiples of irrational numbers.
fn scattered(reaches: &[PlayReach], index: usize) -> Vec<Vec2<f64>> {
    const IRRATIONAL: [f64; 2] = [0.618_033_988_749_895, 0.414_213_562_373_095];
    let part = |joint: usize, which: usize| {
        ((index + 1) as f64 * (IRRATIONAL[which] + 0.732_050_807_568_877 * joint as f64)).fract()
    };
    let at = |(joint, reach): (usize, &PlayReach)| {
        reach.on_border(std::f64::consts::TAU * part(joint, 0)) * part(joint, 1).sqrt()
    };
    reaches.iter().enumerate().map(at).collect()
}

/// Climbs from the present displacements by projected gradient steps: each joint goes along its own gradient, in units of its play, and is put
/// back to the border where it leaves the play. The first step is so long that only the direction counts; steps that do not improve are
/// shortened, and those that do make the next one longer. Whether the loops were in the way of a step.
fn climb(loops: &mut DisplacedLoops<'_>, objective: Objective<'_>, reaches: &[PlayReach], sign: f64) -> bool {
    let start = objective.value(loops);
    let mut value = start;
    let mut step = LONGEST_STEP;
    let mut is_blocked = false;
    for _ in 0..STEPS {
        let present = loops.displacements().to_vec();
        let Ok(gradients) = loops.play_gradient(objective.readings, objective.weights, reaches) else { return true };
        let mut improved = false;
        for _ in 0..SHORTENINGS {
            let joints = present.iter().zip(&gradients).zip(reaches);
            let next: Vec<Vec2<f64>> =
                joints.map(|((at, gradient), reach)| reach.stepped(*at, *gradient * sign, step)).collect();
            if next == present {
                break;
            }
            match loops.displace(&next) {
                Ok(()) => {
                    let found = objective.value(loops);
                    if sign * (found - value) > 0.0 {
                        improved = sign * (found - value) > SETTLED * (found - start).abs();
                        value = found;
                        break;
                    }
                }
                Err(_) => is_blocked = true,
            }
            // From the longest step, which only turns, to those that move by the size of the play.
            step = f64::min(0.25 * step, 8.0);
        }
        if !improved {
            if sign * (objective.value(loops) - value) < 0.0 && loops.displace(&present).is_err() {
                return true;
            }
            break;
        }
        step = f64::min(4.0 * step, LONGEST_STEP);
    }
    is_blocked
}
