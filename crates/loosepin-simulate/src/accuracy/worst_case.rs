//! Worst case of an output over clearances: to first order, and on the exact loops.

use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use super::play_reach::PlayReach;
use super::sensitivity::play_gradients;
use loosepin_math::Vec2;
use loosepin_mechanics::model::Position;

/// Iterations of the fixed point from one start; each gains about the ratio of clearance to link length.
const ITERATIONS: usize = 60;
/// The iteration ends where the linear gain left is below this share of the first-order worst case.
const SETTLED: f64 = 1e-13;
/// A step that does not improve is halved so often before the iteration ends.
const HALVINGS: usize = 10;

/// First-order worst case, the sum of [`PlayReach::worst_case_si`]: Σ c_k |g_k| for journals.
pub fn worst_case_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    joints.iter().map(|(reach, gradient)| reach.worst_case_si(*gradient)).sum()
}

/// Standard deviation with all joints uniform over their play: variance Σ c_k² |g_k|²/4 for journals in their discs,
/// (c² g_y² + θ_max² g_θ²)/6 for a slider, c² g_y²/3 for a pin in a slot.
pub fn disc_standard_deviation_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    0.5 * root_sum_of_squares(joints, 0)
}

/// Standard deviation with all joints uniform on the borders of their play: variance Σ c_k² |g_k|²/2 for journals on their
/// rims, (c² g_y² + θ_max² g_θ²)/3 for a slider, c² g_y² for a pin in a slot.
pub fn rim_standard_deviation_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    std::f64::consts::FRAC_1_SQRT_2 * root_sum_of_squares(joints, 1)
}

fn root_sum_of_squares(joints: &[(PlayReach, Vec2<f64>)], which: usize) -> f64 {
    joints.iter().map(|(reach, gradient)| reach.spreads_si2(*gradient)[which]).sum::<f64>().sqrt()
}

/// Where an output is extreme.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstPosition {
    /// Output there minus output with all journals centred, m or rad.
    pub deviation_si: f64,
    /// Displacements there ([`PlayReach`]), in the order of [`loosepin_mechanics::mechanism::Mechanism::plays`].
    pub displacements: Vec<Vec2<f64>>,
}

/// The extremes of one output over all displacements that the clearances allow, the loops closed exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactWorstCase {
    /// The lowest value; its deviation is <= 0.
    pub lowest: WorstPosition,
    /// The highest value; its deviation is >= 0.
    pub highest: WorstPosition,
}

/// Maximises and minimises an output over `reaches`, the loops closed exactly, from the position that `loops` was set to.
///
/// Fixed point e_k <- the displacement furthest along ±g_k(e) (±r_k g_k/|g_k| on discs) on the closed loops, with steps
/// halved where they do not improve (the conditional-gradient method of Frank and Wolfe, 1956). It starts at
/// the centres and at each of `starts`; the best end is kept. The extremes are local where the output is not concave over
/// the play: more starts make a missed one less likely.
///
/// # Errors
/// The loops cannot be closed with displaced journals: a singular position lies within the clearances.
pub fn exact_worst_case(
    loops: &mut DisplacedLoops<'_>,
    reading: Position,
    reaches: &[PlayReach],
    starts: &[Vec<Vec2<f64>>],
) -> Result<ExactWorstCase, AccuracyError> {
    let lowest = extreme(loops, reading, reaches, starts, -1.0)?;
    let highest = extreme(loops, reading, reaches, starts, 1.0)?;
    loops.centre();
    Ok(ExactWorstCase { lowest, highest })
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

fn extreme(
    loops: &mut DisplacedLoops<'_>,
    reading: Position,
    reaches: &[PlayReach],
    starts: &[Vec<Vec2<f64>>],
    sign: f64,
) -> Result<WorstPosition, AccuracyError> {
    loops.centre();
    let centred = loops.value(reading);
    let mut best = climb(loops, reading, reaches, sign)?;
    for start in starts {
        loops.centre();
        loops.displace(start)?;
        let other = climb(loops, reading, reaches, sign)?;
        if sign * (other.deviation_si - best.deviation_si) > 0.0 {
            best = other;
        }
    }
    best.deviation_si -= centred;
    Ok(best)
}

/// Climbs from the present displacements. The deviation of the result is the output's value still.
fn climb(
    loops: &mut DisplacedLoops<'_>,
    reading: Position,
    reaches: &[PlayReach],
    sign: f64,
) -> Result<WorstPosition, AccuracyError> {
    for _ in 0..ITERATIONS {
        let value = loops.value(reading);
        let present = loops.displacements().to_vec();
        let gradients = play_gradients(loops, &[reading])?.swap_remove(0);
        let mut target = present.clone();
        let (mut gain, mut worst_case) = (0.0, 0.0);
        for ((target, gradient), reach) in target.iter_mut().zip(&gradients).zip(reaches) {
            if let Some(end) = reach.furthest(*gradient * sign) {
                gain += sign * gradient.dot(end - *target);
                worst_case += reach.worst_case_si(*gradient);
                *target = end;
            }
        }
        let is_worth_it = gain > SETTLED * worst_case;
        if !is_worth_it {
            break;
        }
        let mut share = 1.0;
        let mut improved = false;
        for _ in 0..HALVINGS {
            let ways = present.iter().zip(&target).zip(reaches);
            let between: Vec<Vec2<f64>> = ways
                .map(|((a, b), reach)| if share == 1.0 { *b } else { reach.within(*a + (*b - *a) * share) })
                .collect();
            loops.displace(&between)?;
            if sign * (loops.value(reading) - value) > 0.0 {
                improved = true;
                break;
            }
            share *= 0.5;
        }
        if !improved {
            // What is left to gain is lost in round-off.
            loops.displace(&present)?;
            break;
        }
    }
    Ok(WorstPosition { deviation_si: loops.value(reading), displacements: loops.displacements().to_vec() })
}
