//! Play without conditions: each block of variables goes where it likes, so that closed forms and short steps do.

use super::closing::Closing;
use super::conditioned;
use super::displaced::{Displaced, DisplacedSystem};
use super::goal::Goal;
use super::nominal::Base;
use super::part::PlaySide;
use super::reach::Reach;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::plays::Plays;
use crate::accuracy::{AccuracyError, PoseAccuracy};
use crate::closure::loops::{Loops, RowEntries};
use crate::closure::newton::largest;
use crate::kind::frames::MarkerShift;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use loosepin_math::Pose;

/// Part of a gradient along free motions, relative to all of it, that is round-off.
const FREE_SHARE: f64 = 1e-7;
/// Most steps of a climb; two are usual.
const MAX_STEPS: usize = 20;
/// An expected improvement below this, relative to the worst case of first order, is the end.
const LAST_IMPROVEMENT: f64 = 1e-11;
/// What a gradient of a displaced position may be off by, relative to it: the place that it points to is off as much, its value by the square.
const GRADIENT_ERROR: f64 = 1e-6;
/// Most refinements of a gradient.
const MAX_REFINEMENTS: usize = 12;

/// Memory for displaced positions.
#[derive(Debug, Clone, Default)]
pub(super) struct Room {
    system: DisplacedSystem,
    at: Displaced,
    best: Displaced,
    shifts: Vec<MarkerShift>,
    metres: Vec<f64>,
    gains: Vec<f64>,
    gradient: Vec<f64>,
    by_rows: Vec<f64>,
    rest: Vec<f64>,
    entries: Vec<RowEntries>,
    place: Vec<f64>,
    next: Vec<f64>,
}

/// A position of a sample without redundant rows, or in which no play is counted.
pub(super) struct Free<'a, 'b> {
    pub loops: &'a Loops<'b>,
    pub base: &'a Base,
    pub closing: &'a Closing,
    pub plays: &'a Plays,
    pub side: PlaySide,
    pub room: &'a mut Room,
}

impl Free<'_, '_> {
    /// Poses with the journals in given places, m; `None` if the loops do not close near the ideal position.
    pub(super) fn displaced(&mut self, variables_m: &[f64]) -> Result<Vec<Pose>, AccuracyError> {
        let radii = self.plays.radii_m.iter();
        let scaled =
            variables_m.iter().zip(radii).map(|(value, radius)| if *radius > 0.0 { value / radius } else { 0.0 });
        let scaled: Vec<f64> = scaled.collect();
        self.room.system.reset();
        self.room.at.poses.clone_from(&self.closing.poses);
        if self.close(&scaled) {
            return Ok(self.room.at.poses.clone());
        }
        let accuracy = self.accuracy()?;
        Ok(accuracy.close_at(&accuracy.position.poses, variables_m, None)?.poses)
    }

    /// Closes from the poses in `room.at`.
    fn close(&mut self, scaled: &[f64]) -> bool {
        let room = &mut *self.room;
        self.plays.shifts(self.loops, scaled, &mut room.metres, &mut room.shifts);
        room.system.close(self.loops, self.base, &self.closing.system, &room.shifts, &mut room.at)
    }

    /// The same position for searches of other kinds.
    fn accuracy(&self) -> Result<PoseAccuracy<'_>, AccuracyError> {
        PoseAccuracy::of_closed(self.loops.clone(), &self.base.position, self.closing.closed())
    }

    /// The gradient of an output over the scaled unknowns, into `room.gradient`.
    fn gradient(&mut self, output: &SpatialOutput, is_displaced: bool) {
        let mechanism = self.loops.mechanism;
        let room = &mut *self.room;
        room.gradient.clear();
        room.gradient.resize(self.closing.system.order(), 0.0);
        let ideal = OutputState { mechanism, poses: &self.closing.poses };
        let actual = if is_displaced { OutputState { mechanism, poses: &room.best.poses } } else { ideal };
        for part in output.gradient(&ideal, &actual) {
            self.loops.add_gradient(&mut room.gradient, part.body, part.by_displacement, part.by_turning);
        }
    }

    /// Gains at the displaced position of `room.best`, of variables `room.metres`, into `room.gains`: the transposed system of the ideal
    /// position, refined with the rows of the displaced one.
    fn displaced_gains(&mut self, output: &SpatialOutput) -> bool {
        self.gradient(output, true);
        let loops = self.loops;
        let room = &mut *self.room;
        let system = room.system.system(&self.closing.system);
        room.entries.clear();
        room.entries.extend(loops.rows.iter().map(|row| loops.row_entries(row, &room.best.frames)));
        room.by_rows.clone_from(&room.gradient);
        system.solve_transposed_in_place(&mut room.by_rows);
        let rows = loops.rows.len();
        let mut is_good = false;
        for _ in 0..MAX_REFINEMENTS {
            room.rest.clone_from(&room.gradient);
            for (entries, y) in room.entries.iter().zip(&room.by_rows) {
                for (first, values) in entries.iter().flatten() {
                    room.rest[*first..first + 6].iter_mut().zip(values).for_each(|(rest, value)| *rest -= value * y);
                }
            }
            for (null, along) in self.base.position.borders.right.iter().zip(&room.by_rows[rows..]) {
                room.rest.iter_mut().zip(null).for_each(|(rest, entry)| *rest -= entry * along);
            }
            system.solve_transposed_in_place(&mut room.rest);
            room.by_rows.iter_mut().zip(&room.rest).for_each(|(y, change)| *y += change);
            if largest(&room.rest[..rows]) <= GRADIENT_ERROR * largest(&room.by_rows[..rows]) {
                is_good = true;
                break;
            }
        }
        self.plays.gains(loops, &room.best.frames, &room.by_rows, Some(&room.metres), &mut room.gains);
        is_good
    }

    /// Steps from place to place, each where the gradient points to. `None` where the value does not grow by that.
    fn steps(&mut self, goal: &Goal, start: &[f64]) -> Option<f64> {
        let mechanism = self.loops.mechanism;
        self.room.place.clear();
        self.room.place.extend_from_slice(start);
        self.room.system.reset();
        self.room.at.poses.clone_from(&self.closing.poses);
        if !self.close(start) {
            return None;
        }
        let mut best = goal.value(mechanism, &self.closing.poses, &self.room.at.poses);
        for _ in 0..MAX_STEPS {
            core::mem::swap(&mut self.room.at, &mut self.room.best);
            let (output, sign) = goal.tangent(&self.closing.poses, &self.room.best.poses);
            if !self.displaced_gains(&output) {
                return None;
            }
            let room = &mut *self.room;
            room.gains.iter_mut().for_each(|gain| *gain *= sign);
            support(&self.plays.set, &room.gains, &mut room.next);
            let expected = dot(&room.gains, &room.next) - dot(&room.gains, &room.place);
            if expected <= LAST_IMPROVEMENT * dot(&room.gains, &room.next) {
                return Some(best);
            }
            room.at.poses.clone_from(&room.best.poses);
            let next = core::mem::take(&mut room.next);
            let is_closed = self.close(&next);
            self.room.next = next;
            let value = goal.value(mechanism, &self.closing.poses, &self.room.at.poses);
            if !(is_closed && value > best) {
                return None;
            }
            best = value;
            core::mem::swap(&mut self.room.place, &mut self.room.next);
        }
        None
    }
}

impl Reach for Free<'_, '_> {
    fn mechanism(&self) -> &SpatialMechanism {
        self.loops.mechanism
    }

    fn ideal(&self) -> &[Pose] {
        &self.closing.poses
    }

    fn side(&self) -> PlaySide {
        self.side
    }

    fn is_symmetric(&self) -> bool {
        true
    }

    fn gains(&mut self, output: &SpatialOutput) -> Result<Vec<f64>, AccuracyError> {
        self.gradient(output, false);
        let size = largest(&self.room.gradient);
        self.closing.system.solve_transposed_in_place(&mut self.room.gradient);
        let (by_rows, free) = self.room.gradient.split_at(self.loops.rows.len());
        if !(largest(free) <= FREE_SHARE * size) {
            return Err(AccuracyError::OutputIsFree);
        }
        let mut gains = Vec::with_capacity(self.plays.set.variables());
        self.plays.gains(self.loops, &self.closing.frames, by_rows, None, &mut gains);
        Ok(gains)
    }

    fn ends(&self, gains: &[f64]) -> Result<[f64; 2], AccuracyError> {
        let worst: f64 = self.plays.set.blocks().iter().map(|block| PlaySet::length(block, gains)).sum();
        Ok([-worst, worst])
    }

    fn farthest(&self, gains: &[f64], place: &mut Vec<f64>) -> Result<(), AccuracyError> {
        support(&self.plays.set, gains, place);
        off_the_middle(&self.plays.set, place);
        Ok(())
    }

    fn climb(&mut self, goal: &Goal, start: &[f64]) -> Result<f64, AccuracyError> {
        // Ideal joints are a place, too.
        let ideal = goal.value(self.loops.mechanism, &self.closing.poses, &self.closing.poses);
        let found = match self.steps(goal, start) {
            Some(value) => value,
            None => conditioned::climb(&self.accuracy()?, goal, start)?,
        };
        Ok(found.max(ideal))
    }
}

/// Each block on its border along its gains; in the middle where it has none.
fn support(set: &PlaySet, gains: &[f64], place: &mut Vec<f64>) {
    place.clear();
    place.extend_from_slice(gains);
    for block in set.blocks() {
        let length = PlaySet::length(block, place);
        if length > 0.0 {
            place[block.range()].iter_mut().for_each(|value| *value /= length);
        }
    }
}

/// Puts blocks that are in the middle onto their borders, each in a direction of its own: there the gradient may vanish, as that of a length by a
/// lean does.
fn off_the_middle(set: &PlaySet, place: &mut [f64]) {
    const DIRECTIONS: [[f64; 3]; 4] = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [-0.28, -0.96, 0.0], [0.96, -0.28, 0.0]];
    for (number, block) in set.blocks().iter().enumerate() {
        let own = &mut place[block.range()];
        if own.iter().all(|value| *value == 0.0) {
            match own {
                [axial] => *axial = 1.0,
                own => {
                    own.iter_mut().zip(DIRECTIONS[number % DIRECTIONS.len()]).for_each(|(value, part)| *value = part)
                }
            }
        }
    }
}
