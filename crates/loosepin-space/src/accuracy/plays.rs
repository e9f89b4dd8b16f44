//! The plays of a mechanism, prepared for many places.

use crate::accuracy::play_set::PlaySet;
use crate::closure::loops::Loops;
use crate::kind::frames::{JointFrames, MarkerShift};
use core::ops::Range;
use loosepin_math::Vec3;

/// A joint with play: its rows and its variables.
#[derive(Debug, Clone)]
struct PlayJoint {
    joint: usize,
    rows: Range<usize>,
    variables: Range<usize>,
}

/// All plays of a mechanism.
#[derive(Debug, Clone)]
pub(crate) struct Plays {
    pub set: PlaySet,
    pub radii_m: Vec<f64>,
    joints: Vec<PlayJoint>,
    /// What each variable does to its joint with the journals in the middle.
    middle: Vec<MarkerShift>,
}

impl Plays {
    pub(crate) fn new(loops: &Loops) -> Self {
        let set = PlaySet::new(loops.mechanism);
        let radii_m = set.radii_m();
        let of_joint = |joint: usize| {
            let mut own = set.blocks().iter().filter(|block| block.joint == joint);
            let first = own.next()?;
            let last = own.next_back().unwrap_or(first);
            let is_own = |row: &crate::closure::loops::PlacedRow| row.joint == joint && row.drive.is_none();
            let start = loops.rows.iter().position(is_own)?;
            let count = loops.rows.iter().filter(|row| is_own(row)).count();
            Some(PlayJoint { joint, rows: start..start + count, variables: first.first..last.range().end })
        };
        let joints = (0..loops.mechanism.joints().len()).filter_map(of_joint).collect();
        let zeros = vec![0.0; set.variables()];
        let middle = set.derivatives(loops.mechanism, &zeros).into_iter().map(|(_, shift)| shift).collect();
        Self { set, radii_m, joints, middle }
    }

    /// What variables, in units of their radii, do to all joints.
    pub(crate) fn shifts(&self, loops: &Loops, scaled: &[f64], metres: &mut Vec<f64>, shifts: &mut Vec<MarkerShift>) {
        metres.clear();
        metres.extend(scaled.iter().zip(&self.radii_m).map(|(value, radius)| value * radius));
        self.put_shifts(loops, metres, shifts);
    }

    /// The same of the variables themselves.
    pub(crate) fn shifts_in_metres(&self, loops: &Loops, metres: &[f64]) -> Vec<MarkerShift> {
        let mut shifts = Vec::new();
        self.put_shifts(loops, metres, &mut shifts);
        shifts
    }

    fn put_shifts(&self, loops: &Loops, metres: &[f64], shifts: &mut Vec<MarkerShift>) {
        shifts.clear();
        shifts.resize(loops.mechanism.joints().len(), MarkerShift::default());
        for own in &self.joints {
            if let Some(play) = &loops.mechanism.joints()[own.joint].play {
                shifts[own.joint] = play.marker_shift(&metres[own.variables.clone()]);
            }
        }
    }

    /// Gains by the variables in units of their radii: -yᵀK, for changes y of an output by changes of the rows. `metres` are the places of the
    /// journals; `None` in the middle.
    pub(crate) fn gains(
        &self,
        loops: &Loops,
        frames: &[JointFrames],
        by_rows: &[f64],
        metres: Option<&[f64]>,
        gains: &mut Vec<f64>,
    ) {
        self.gains_in_metres(loops, frames, by_rows, metres, gains);
        gains.iter_mut().zip(&self.radii_m).for_each(|(gain, radius)| *gain *= radius);
    }

    /// The same by the variables themselves.
    pub(crate) fn gains_in_metres(
        &self,
        loops: &Loops,
        frames: &[JointFrames],
        by_rows: &[f64],
        metres: Option<&[f64]>,
        gains: &mut Vec<f64>,
    ) {
        gains.clear();
        for own in &self.joints {
            let at = &frames[own.joint];
            let (mut by_shift, mut by_slope) = (Vec3::ZERO, [0.0; 2]);
            for (row, y) in loops.rows[own.rows.clone()].iter().zip(&by_rows[own.rows.clone()]) {
                let (shift, slope) = row.row.by_play(at);
                let share = y / loops.scale(row);
                by_shift += shift * share;
                (by_slope[0], by_slope[1]) = (by_slope[0] + slope[0] * share, by_slope[1] + slope[1] * share);
            }
            self.each_shift(loops, own, metres, |_, shift| {
                let change = by_shift.dot(shift.shift_m) + by_slope[0] * shift.slope[0] + by_slope[1] * shift.slope[1];
                gains.push(-change);
            });
        }
    }

    /// The largest derivative of a row by a variable in units of its radius.
    pub(crate) fn largest_derivative(&self, loops: &Loops, frames: &[JointFrames], metres: Option<&[f64]>) -> f64 {
        let mut largest: f64 = 0.0;
        let mut rows = Vec::new();
        for own in &self.joints {
            rows.clear();
            let placed = loops.rows[own.rows.clone()].iter();
            rows.extend(placed.map(|row| (row.row.by_play(&frames[own.joint]), loops.scale(row))));
            self.each_shift(loops, own, metres, |variable, shift| {
                for ((by_shift, by_slope), scale) in &rows {
                    let change =
                        by_shift.dot(shift.shift_m) + by_slope[0] * shift.slope[0] + by_slope[1] * shift.slope[1];
                    largest = largest.max((change / scale * self.radii_m[variable]).abs());
                }
            });
        }
        largest
    }

    /// What each variable of a joint does to it.
    fn each_shift(
        &self,
        loops: &Loops,
        own: &PlayJoint,
        metres: Option<&[f64]>,
        mut take: impl FnMut(usize, &MarkerShift),
    ) {
        let variables = own.variables.clone();
        match metres.and_then(|metres| Some((loops.mechanism.joints()[own.joint].play.as_ref()?, metres))) {
            Some((play, metres)) => {
                let shifts = play.derivatives(&metres[variables.clone()]);
                variables.zip(&shifts).for_each(|(variable, shift)| take(variable, shift));
            }
            None => variables.clone().zip(&self.middle[variables]).for_each(|(variable, shift)| take(variable, shift)),
        }
    }
}
