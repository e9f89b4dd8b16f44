//! What clearances can do to an output: first order, and on the exact loops.

use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use super::position::PositionReading;
use super::sensitivity::eccentricity_gradients;
use crate::math::Vec2;

/// Iterations of the fixed point from one start; each gains about the ratio of clearance to link length.
const ITERATIONS: usize = 60;
/// The iteration ends where the linear gain left is below this share of the first-order worst case.
const SETTLED: f64 = 1e-13;
/// A step that does not improve is halved so often before the iteration ends.
const HALVINGS: usize = 10;

/// First-order worst case Σ c_k |g_k|, from (c_k, g_k).
pub fn worst_case_si(joints: &[(f64, Vec2<f64>)]) -> f64 {
    joints.iter().map(|(clearance_m, gradient)| clearance_m * gradient.length()).sum()
}

/// Standard deviation with journals uniform in their discs: variance Σ c_k² |g_k|²/4.
pub fn disc_standard_deviation_si(joints: &[(f64, Vec2<f64>)]) -> f64 {
    0.5 * root_sum_of_squares(joints)
}

/// Standard deviation with journals on their rims in uniform direction: variance Σ c_k² |g_k|²/2.
pub fn rim_standard_deviation_si(joints: &[(f64, Vec2<f64>)]) -> f64 {
    std::f64::consts::FRAC_1_SQRT_2 * root_sum_of_squares(joints)
}

fn root_sum_of_squares(joints: &[(f64, Vec2<f64>)]) -> f64 {
    joints
        .iter()
        .map(|(clearance_m, gradient)| clearance_m * clearance_m * gradient.length_squared())
        .sum::<f64>()
        .sqrt()
}

/// Where an output is extreme.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstPosition {
    /// Output there minus output with all journals centred, m or rad.
    pub deviation_si: f64,
    /// Eccentricities there, m, in the order of [`crate::mechanism::Mechanism::plays`].
    pub eccentricities_m: Vec<Vec2<f64>>,
}

/// The extremes of one output over all eccentricities |e_k| <= r_k of the exact loops.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactWorstCase {
    /// The lowest value; its deviation is <= 0.
    pub lowest: WorstPosition,
    /// The highest value; its deviation is >= 0.
    pub highest: WorstPosition,
}

/// Maximises and minimises an output over |e_k| <= `radii_m`, the loops closed exactly, from the position that `loops`
/// was set to.
///
/// Fixed point e_k <- ±r_k g_k(e)/|g_k(e)| on the closed loops, with steps halved where they do not improve (the
/// conditional-gradient method of Frank and Wolfe, 1956, whose linear subproblem has this solution on discs). It starts at
/// the centres and at each of `starts`; the best end is kept. The extremes are local where the output is not concave over
/// the discs: more starts make a missed one less likely.
///
/// # Errors
/// The loops cannot be closed with displaced journals: a singular position lies within the clearances.
pub fn exact_worst_case(
    loops: &mut DisplacedLoops<'_>,
    reading: PositionReading,
    radii_m: &[f64],
    starts: &[Vec<Vec2<f64>>],
) -> Result<ExactWorstCase, AccuracyError> {
    let lowest = extreme(loops, reading, radii_m, starts, -1.0)?;
    let highest = extreme(loops, reading, radii_m, starts, 1.0)?;
    loops.centre();
    Ok(ExactWorstCase { lowest, highest })
}

/// Four starts on the rims, the joints turned against each other by the golden angle, so that no two starts agree.
pub fn starts_on_rims(radii_m: &[f64]) -> Vec<Vec<Vec2<f64>>> {
    const GOLDEN_ANGLE_RAD: f64 = 2.399_963_229_728_653;
    (0..4)
        .map(|quarter| {
            let direction = |joint: usize| {
                let angle_rad = std::f64::consts::FRAC_PI_2 * f64::from(quarter) + GOLDEN_ANGLE_RAD * joint as f64;
                let (sine, cosine) = crate::math::sin_cos(angle_rad);
                Vec2::new(cosine, sine)
            };
            radii_m.iter().enumerate().map(|(joint, radius_m)| direction(joint) * *radius_m).collect()
        })
        .collect()
}

fn extreme(
    loops: &mut DisplacedLoops<'_>,
    reading: PositionReading,
    radii_m: &[f64],
    starts: &[Vec<Vec2<f64>>],
    sign: f64,
) -> Result<WorstPosition, AccuracyError> {
    loops.centre();
    let centred = loops.value(reading);
    let mut best = climb(loops, reading, radii_m, sign)?;
    for start in starts {
        loops.centre();
        loops.displace(start)?;
        let other = climb(loops, reading, radii_m, sign)?;
        if sign * (other.deviation_si - best.deviation_si) > 0.0 {
            best = other;
        }
    }
    best.deviation_si -= centred;
    Ok(best)
}

/// Climbs from the present eccentricities. The deviation of the result is the output's value still.
fn climb(
    loops: &mut DisplacedLoops<'_>,
    reading: PositionReading,
    radii_m: &[f64],
    sign: f64,
) -> Result<WorstPosition, AccuracyError> {
    for _ in 0..ITERATIONS {
        let value = loops.value(reading);
        let present = loops.eccentricities_m().to_vec();
        let gradients = eccentricity_gradients(loops, &[reading])?.swap_remove(0);
        let mut target = present.clone();
        let (mut gain, mut worst_case) = (0.0, 0.0);
        for ((target_m, gradient), radius_m) in target.iter_mut().zip(&gradients).zip(radii_m) {
            let length = gradient.length();
            if length > 0.0 {
                let rim_m = *gradient * (sign * radius_m / length);
                gain += sign * gradient.dot(rim_m - *target_m);
                worst_case += radius_m * length;
                *target_m = rim_m;
            }
        }
        let is_worth_it = gain > SETTLED * worst_case;
        if !is_worth_it {
            break;
        }
        let mut share = 1.0;
        let mut improved = false;
        for _ in 0..HALVINGS {
            let between: Vec<Vec2<f64>> = present
                .iter()
                .zip(&target)
                .map(|(a, b)| if share == 1.0 { *b } else { *a + (*b - *a) * share })
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
    Ok(WorstPosition { deviation_si: loops.value(reading), eccentricities_m: loops.eccentricities_m().to_vec() })
}
