//! The mechanism with its drives locked, and where it settles under a push.

use super::rig::Rig;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{Axis, Position, Relative, Values};
use loosepin_simulate::accuracy::{AccuracyError, DisplacedLoops, PlayReach, play_gradients};
use loosepin_study::Push;

/// Iterations until the mechanism has settled; each gains about the ratio of clearance to link length.
const ITERATIONS: usize = 80;
/// Relative change of displacements below which the iteration has converged, as a share of the largest.
const SETTLED: f64 = 1e-12;
/// A joint whose load is below this share of the largest is not loaded.
pub(crate) const UNLOADED: f64 = 1e-9;

/// A reading: its push, its output, and its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Test {
    pub push: Push,
    pub travel: Position,
    pub pose_rad: f64,
    /// Largest error of that angle, of either sign, rad.
    pub pose_error_rad: f64,
    /// Largest coefficient of friction, where it is not that of the model.
    pub friction: Option<f64>,
}

/// The coordinates of the ideal mechanism where the drive that the cycle counts stands at `angle_rad`.
pub(crate) fn locked_at(mechanism: &Mechanism, values: &Values, angle_rad: f64) -> Result<Vec<f64>, AccuracyError> {
    let input = mechanism.model.cycle_input(values);
    if input.speed_rad_s == 0.0 {
        return Err(AccuracyError::StandsStill { drive: input.name });
    }
    let sample = Sample::new(mechanism, values)?;
    let turn_s = input.turn_s();
    let forward_s = ((angle_rad - input.start_rad) / input.speed_rad_s).rem_euclid(turn_s);
    let reached = |time_s: f64| {
        let mut motion = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
        motion.move_to(time_s)?;
        Ok(motion.coordinates().to_vec())
    };
    // A mechanism that cannot turn fully reaches some angles the other way round only.
    reached(forward_s).or_else(|error| reached(forward_s - turn_s).map_err(|_| error))
}

/// Positions whose weighted sum moves along a push: its work is the force, or the moment, times that sum.
pub(crate) fn pushed(push: &Push) -> Vec<(Position, f64)> {
    match *push {
        Push::Force { point, direction_rad, .. } => {
            let point = Relative::to_ground(point);
            vec![
                (Position::Point(point, Axis::X), direction_rad.cos()),
                (Position::Point(point, Axis::Y), direction_rad.sin()),
            ]
        }
        Push::Moment { body, .. } => vec![(Position::Angle(Relative::to_ground(body)), 1.0)],
    }
}

/// Gradients of a weighted sum of positions over the displacements of the joints with play.
pub(crate) fn gradient(
    loops: &mut DisplacedLoops<'_>,
    parts: &[(Position, f64)],
) -> Result<Vec<Vec2<f64>>, AccuracyError> {
    let readings: Vec<Position> = parts.iter().map(|(position, _)| *position).collect();
    let gradients = play_gradients(loops, &readings)?;
    let mut sum = vec![Vec2::zero(); loops.displacements().len()];
    for ((_, weight), gradients) in parts.iter().zip(&gradients) {
        for (sum, gradient) in sum.iter_mut().zip(gradients) {
            *sum += *gradient * *weight;
        }
    }
    Ok(sum)
}

/// Largest load of a joint under a unit push.
pub(crate) fn largest_load(loads: &[Vec2<f64>]) -> f64 {
    loads.iter().map(|load| load.length()).fold(0.0, f64::max)
}

/// The reaches of the joints with play where their clearances are `radii_m`.
pub(crate) fn reaches(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    radii_m: &[f64],
) -> Result<Vec<PlayReach>, AccuracyError> {
    let further = sample.plays.iter().zip(radii_m).map(|(play, radius_m)| radius_m - play.clearance_m);
    PlayReach::of_sample(mechanism, sample, further)
}

/// The dead travel on the exact loops, without friction: where the push goes one way the mechanism settles where its work is
/// largest, e_k = furthest along ±h_k(e), and where it goes the other way likewise.
///
/// The way e -> furthest(h(e)) contracts by about clearance over link length, so that it ends at the one settled position.
/// A joint that the push does not load stays in the middle.
pub(crate) fn exact_travel(
    rig: &Rig<'_>,
    coordinates: &[f64],
    push: &[(Position, f64)],
    travel: Position,
    radii_m: &[f64],
) -> Result<f64, AccuracyError> {
    let sample = Sample::new(&rig.mechanism, &rig.values)?;
    let reaches = reaches(&rig.mechanism, &sample, radii_m)?;
    let mut loops = DisplacedLoops::new(&rig.mechanism, &rig.values);
    loops.set_position(coordinates);
    let mut settled = |sign: f64| -> Result<f64, AccuracyError> {
        loops.centre();
        for _ in 0..ITERATIONS {
            let loads = gradient(&mut loops, push)?;
            let least = UNLOADED * largest_load(&loads);
            let target: Vec<Vec2<f64>> = loads
                .iter()
                .zip(&reaches)
                .map(|(load, reach)| {
                    let end = (load.length() > least).then(|| reach.furthest(*load * sign)).flatten();
                    end.unwrap_or(Vec2::zero())
                })
                .collect();
            let largest = target.iter().map(|end| end.length()).fold(0.0, f64::max);
            let change = target.iter().zip(loops.displacements()).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
            loops.displace(&target)?;
            if change <= SETTLED * largest {
                break;
            }
        }
        Ok(loops.value(travel))
    };
    Ok(settled(1.0)? - settled(-1.0)?)
}
