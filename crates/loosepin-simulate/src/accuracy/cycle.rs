//! One cycle of the ideal motion: positions, how far the mechanism turns, and where it is singular.

use super::error::AccuracyError;
use super::transmission::{Transmission, is_positive};
use crate::maximum_within;
use loosepin_math::sort_by_number;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample, SampleError};
use loosepin_mechanics::model::{CycleInput, describe_path};
use loosepin_result::motion::SingularPosition;
use loosepin_text::units::{Dimension, format_value};
use std::sync::atomic::{AtomicBool, Ordering};

/// Below this sine of the smallest angle a position is reported as nearly singular: 5°, where errors are magnified more
/// than ten times. Designers keep transmission angles above 30° to 45°.
const NEARLY_SINGULAR_SINE: f64 = 0.087_155_742_747_658_17;
/// Steps of a drive in one cycle, at most: six thousand turns.
const MAX_STEPS: usize = 200_000;
/// Singular positions are located to this share of a turn.
const LOCATED_TURNS: f64 = 1e-12;
/// How far beyond a sample at which branches cross the motion is taken up again, in steps.
const PAST_CROSSING: f64 = 0.37;
/// Some body turns this much faster than the drive at a located dead point, where its speed grows beyond all bounds; where
/// two branches cross, speeds stay finite.
const DEAD_POINT_RATIO: f64 = 1e3;

/// The positions of one turn of a drive.
pub struct Cycle<'a> {
    /// States at the sampled positions, in the order of the drive's angle, which is not that of time where the drive runs backwards.
    pub states: Vec<IdealMotion<'a>>,
    /// Singular positions by time.
    singular: Vec<SingularTime>,
}

/// A singular position, or one nearly so.
struct SingularTime {
    time_s: f64,
    kind: SingularKind,
    words: String,
}

/// What a singular position is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SingularKind {
    /// Branches cross: the drives do not determine which one is followed.
    ChangePoint,
    /// The drives cannot go on.
    DeadPoint,
    /// Errors are magnified, and no more.
    Nearly,
}

impl<'a> Cycle<'a> {
    /// The position from which a cycle is walked.
    ///
    /// # Errors
    /// The sample has none; a drive moves so far in a cycle that the walk would be too long.
    pub fn start(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        input: &CycleInput,
    ) -> Result<IdealMotion<'a>, AccuracyError> {
        let start = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
        let (drive, steps) = start.longest_way(start.time_s() + input.turn_s());
        if steps > MAX_STEPS as f64 {
            let drive = mechanism.model.drives[drive.0].name.clone();
            return Err(AccuracyError::TooLong { drive, steps, most: MAX_STEPS });
        }
        Ok(start)
    }

    /// Walks `positions` steps of one turn from `start`. A mechanism that cannot go through the turn is followed as far as
    /// it goes forwards, and from the start backwards. Where `stop` is set it ends wherever it is.
    pub fn walk(
        mechanism: &Mechanism,
        start: IdealMotion<'a>,
        input: &CycleInput,
        positions: usize,
        stop: &AtomicBool,
    ) -> Self {
        let turn_s = input.turn_s();
        let at = |step: i64| turn_s * step as f64 / positions as f64;
        let steps = positions as i64;
        let mut walk = Walk { mechanism, input, stop, singular: Vec::new() };
        let (mut states, forward_stop_s) = walk.follow(start.clone(), (1..=steps).map(at));
        states.insert(0, start.clone());
        if forward_stop_s.is_some() {
            let left = steps - (states.len() as i64 - 1);
            let (backward, _) = walk.follow(start, (1..=left).map(|step| at(-step)));
            states.splice(0..0, backward.into_iter().rev());
        }
        walk.note_nearly_singular(&states, turn_s / positions as f64);
        if input.speed_rad_s < 0.0 {
            states.reverse();
        }
        let mut singular = walk.singular;
        sort_by_number(&mut singular, |a| a.time_s);
        Self { states, singular }
    }

    /// The singular positions in the order of the drive's angle.
    pub fn singular_positions(&self, input: &CycleInput) -> Vec<SingularPosition> {
        let mut found: Vec<SingularPosition> = self
            .singular
            .iter()
            .map(|at| SingularPosition { drive_angle_rad: input.angle_rad(at.time_s), words: at.words.clone() })
            .collect();
        sort_by_number(&mut found, |a| a.drive_angle_rad);
        found
    }

    /// Angles of the drive at change points and dead points.
    pub fn change_points(&self, input: &CycleInput) -> Vec<(f64, SingularKind)> {
        let located = self.singular.iter().filter(|at| at.kind != SingularKind::Nearly);
        located.map(|at| (input.angle_rad(at.time_s), at.kind)).collect()
    }
}

/// Notes of a walk through a cycle.
struct Walk<'m> {
    mechanism: &'m Mechanism,
    input: &'m CycleInput,
    stop: &'m AtomicBool,
    singular: Vec<SingularTime>,
}

impl Walk<'_> {
    /// Moves through `times_s` until one cannot be reached; gives the states, and where the way ends.
    fn follow<'a>(
        &mut self,
        start: IdealMotion<'a>,
        times_s: impl Iterator<Item = f64>,
    ) -> (Vec<IdealMotion<'a>>, Option<f64>) {
        let mut states = Vec::new();
        let mut last = start;
        for time_s in times_s.take_while(|_| !self.stop.load(Ordering::Relaxed)) {
            let mut next = last.clone();
            if next.move_to(time_s).is_err() {
                let (end, error) = self.last_reachable(last.clone(), time_s);
                let is_crossing = self.is_crossing(&end);
                let (kind, words) = if is_crossing {
                    (SingularKind::ChangePoint, self.crossing_words(&end))
                } else {
                    (SingularKind::DeadPoint, dead_point_words(&error))
                };
                self.singular.push(SingularTime { time_s: end.time_s(), kind, words });
                // Branches that cross at a sample: the motion goes on smoothly, past this sample.
                let past_s = time_s + PAST_CROSSING * (time_s - last.time_s());
                if !is_crossing || last.move_to(past_s).is_err() {
                    return (states, Some(end.time_s()));
                }
                continue;
            }
            let [before, after] = [&last, &next].map(|motion| is_positive(self.mechanism, motion));
            if before != after {
                let (time_s, state) = self.crossing(last, time_s, before);
                let words = self.crossing_words(&state);
                self.singular.push(SingularTime { time_s, kind: SingularKind::ChangePoint, words });
            }
            states.push(next.clone());
            last = next;
        }
        (states, None)
    }

    /// Bisects between a state and a time that cannot be reached from it.
    fn last_reachable<'a>(&self, mut reached: IdealMotion<'a>, beyond_s: f64) -> (IdealMotion<'a>, SampleError) {
        let mut beyond_s = beyond_s;
        let side = is_positive(self.mechanism, &reached);
        let mut error = SampleError::Singular { time_s: beyond_s, at: None };
        while (beyond_s - reached.time_s()).abs() > LOCATED_TURNS * self.input.turn_s() {
            let middle_s = 0.5 * (reached.time_s() + beyond_s);
            if middle_s == reached.time_s() || middle_s == beyond_s {
                break;
            }
            let mut next = reached.clone();
            match next.move_to(middle_s) {
                Ok(()) if is_positive(self.mechanism, &next) == side => reached = next,
                Ok(()) => beyond_s = middle_s,
                Err(found) => {
                    error = found;
                    beyond_s = middle_s;
                }
            }
        }
        (reached, error)
    }

    /// Bisects for the sign change of the determinant.
    fn crossing<'a>(&self, mut before: IdealMotion<'a>, after_s: f64, side: bool) -> (f64, IdealMotion<'a>) {
        let mut after_s = after_s;
        while (after_s - before.time_s()).abs() > LOCATED_TURNS * self.input.turn_s() {
            let middle_s = 0.5 * (before.time_s() + after_s);
            if middle_s == before.time_s() || middle_s == after_s {
                break;
            }
            let mut next = before.clone();
            if next.move_to(middle_s).is_ok() && is_positive(self.mechanism, &next) == side {
                before = next;
            } else {
                after_s = middle_s;
            }
        }
        (after_s, before)
    }

    /// Whether branches cross at the end of the way, where all speeds stay finite; else it is a dead point.
    fn is_crossing(&self, end: &IdealMotion<'_>) -> bool {
        let fastest = end.kinematics().twists.iter().fold(0.0_f64, |fastest, twist| {
            let linear = twist.linear.length() / self.mechanism.size_m;
            fastest.max(twist.angular.abs()).max(linear)
        });
        fastest < DEAD_POINT_RATIO * self.input.speed_rad_s.abs()
    }

    /// Error where branches cross, with the ways on.
    fn crossing_words(&self, state: &IdealMotion<'_>) -> String {
        let Some(ways) = state.motion_branches() else { return CROSSING_WORDS.to_owned() };
        let link = &self.mechanism.ideal.links[ways.slot - 1];
        let [faster, slower] =
            ways.angular_velocities_rad_s.map(|speed| format_value(speed, Dimension::ANGULAR_VELOCITY));
        format!(
            "{CROSSING_WORDS}: '{}' goes on at {faster} or at {slower}",
            self.mechanism.model.bodies[link.body.0].name
        )
    }

    /// Local minima of the sine of transmission that are low but not zero.
    fn note_nearly_singular(&mut self, states: &[IdealMotion<'_>], stride_s: f64) {
        let transmission = Transmission::over(self.mechanism, states);
        let sines: Vec<(f64, f64)> = states.iter().map(|state| (state.time_s(), transmission.sine(state))).collect();
        let turn_s = self.input.turn_s();
        let mut found: Vec<(f64, f64)> = Vec::new();
        for k in 0..sines.len() {
            let (low, high) = (k.saturating_sub(1), (k + 1).min(sines.len() - 1));
            let is_minimum = sines[k].1 <= sines[low].1 && sines[k].1 < sines[high].1
                || sines[k].1 < sines[low].1 && sines[k].1 <= sines[high].1;
            // Between samples the sine can fall further: by less than the change from the neighbours.
            let reach = (sines[low].1 - sines[k].1).max(sines[high].1 - sines[k].1);
            if !is_minimum || sines[k].1 - reach > NEARLY_SINGULAR_SINE {
                continue;
            }
            let points: Vec<(f64, f64)> = sines[low..=high].iter().map(|(time_s, sine)| (*time_s, -sine)).collect();
            let state = &states[k];
            let lowest = maximum_within(&points, |time_s| {
                let mut motion = state.clone();
                match motion.move_to(time_s) {
                    Ok(()) => -transmission.sine(&motion),
                    Err(_) => f64::NEG_INFINITY,
                }
            });
            let is_singular = self.singular.iter().any(|at| (at.time_s - lowest.time_s).abs() <= 1.5 * stride_s);
            let is_repeated =
                found.iter().any(|(time_s, _)| ((time_s - lowest.time_s).abs() - turn_s).abs() < 1e-6 * turn_s);
            if -lowest.value < NEARLY_SINGULAR_SINE && !is_singular && !is_repeated {
                found.push((lowest.time_s, -lowest.value));
            }
        }
        for (time_s, sine) in found {
            let degrees = sine.asin().to_degrees();
            let words = format!(
                "nearly a dead point: the transmission angle is {degrees:.2}° away from 0°, small errors and forces are magnified by a factor of about {:.0}",
                1.0 / sine
            );
            self.singular.push(SingularTime { time_s, kind: SingularKind::Nearly, words });
        }
    }
}

/// Error at a dead point, by why the loops do not close beyond it.
fn dead_point_words(error: &SampleError) -> String {
    match error {
        SampleError::CannotClose { open, .. } => format!(
            "dead point: the drive cannot turn further, the links no longer close at {}",
            describe_path(&open.path)
        ),
        _ => "dead point: the drive cannot turn any further".to_owned(),
    }
}

/// Said where the determinant of the loop equations changes its sign although the loops close on both sides.
const CROSSING_WORDS: &str =
    "the links can be assembled in two ways here, and the drives do not determine which one the mechanism follows";
