//! Journals that rest in their bearings at the start.
//!
//! A journal rests where the force that an ideal joint would carry presses it: with F(e) the force on the journal, of the motion at time
//! zero with all joints closed at their offsets e, accelerations included,
//!
//! ```text
//! e = -c F(e)/|F(e)|
//! ```
//!
//! by iteration from e = 0: F turns by some e/L at each step, L a length of the mechanism, so that five steps reach round-off. The journal
//! begins just before it touches, a millionth of the clearance away: what the contact gives way under F it does in the first instants, at a
//! speed below an impact's. Friction in its contact does not hold it anywhere else.

use crate::failure::RunFailure;
use crate::stepping::motion::Motion;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample, StartOffset};
use loosepin_mechanics::model::PlayId;

/// Steps of the iteration.
const STEPS: usize = 50;
/// Change of an offset over the clearance that is round-off.
const SETTLED: f64 = 1e-12;
/// Share of the clearance at which a journal counts as touching: contacts begin as they close.
const TOUCHING: f64 = 1.0 - 1e-6;

/// Coordinates and rates of the real tree at time zero: as [`Mechanism::start`], with journals that rest where forces press them.
///
/// # Errors
/// As [`Mechanism::start`]; [`RunFailure::NothingPresses`] and [`RunFailure::NotResting`].
pub fn start(mechanism: &Mechanism, sample: &Sample<f64>) -> Result<(Vec<f64>, Vec<f64>), RunFailure> {
    if !sample.offsets.iter().any(|own| own.is_resting) {
        return Ok(mechanism.start(sample)?);
    }
    Ok(mechanism.start_at(sample, &resting_offsets(mechanism, sample)?)?)
}

/// The offsets of a sample with those of resting journals found.
fn resting_offsets(mechanism: &Mechanism, sample: &Sample<f64>) -> Result<Vec<StartOffset>, RunFailure> {
    let ideal = mechanism.without_play();
    let name = |own: &StartOffset| mechanism.model.play_name(mechanism.plays[own.play]).to_owned();
    let mut offsets = sample.offsets.clone();
    for _ in 0..STEPS {
        let geometry = mechanism.displaced(&sample.ideal, &offsets);
        let mut closed = sample.clone().without_play();
        (closed.ideal, closed.real) = (geometry.clone(), geometry);
        let solved = IdealMotion::new(&ideal, &closed.ideal, &closed.drives)?;
        let (coordinates, rates) = solved.real_state();
        let mut motion = Motion::new(&ideal, &closed);
        let n = motion.freedoms();
        motion.dynamics.sample_mut().take_pieces_at(0.0);
        motion.dynamics.evaluate(0.0, &coordinates[..n], &rates[..n], &motion.states);
        let mut change = 0.0_f64;
        for own in offsets.iter_mut().filter(|own| own.is_resting) {
            let PlayId::Joint(joint) = mechanism.plays[own.play] else { continue };
            let force_n = motion.dynamics.joint_force_n(joint);
            let size_n = force_n.length();
            if !(size_n > 0.0) {
                return Err(RunFailure::NothingPresses { joint: name(own) });
            }
            let clearance_m = sample.plays[own.play].clearance_m;
            let found_m: Vec2<f64> = force_n * (-TOUCHING * clearance_m / size_n);
            change = change.max((found_m - own.offset_m).length() / clearance_m);
            own.offset_m = found_m;
        }
        if change <= SETTLED {
            return Ok(offsets);
        }
    }
    let joint = offsets.iter().find(|own| own.is_resting).map_or_else(String::new, name);
    Err(RunFailure::NotResting { joint })
}
