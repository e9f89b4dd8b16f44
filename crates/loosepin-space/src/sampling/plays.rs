//! The plays of a sample, prepared for many places.

use crate::accuracy::play_set::PlaySet;
use crate::closure::loops::Loops;
use crate::geometry::vector::Vec3;
use crate::kind::frames::{JointFrames, MarkerShift};
use crate::play::kind_of_play::KindOfPlay;
use core::ops::Range;

/// A joint with play: its rows and its variables.
#[derive(Debug, Clone)]
struct PlayJoint {
    joint: usize,
    rows: Range<usize>,
    variables: Range<usize>,
}

/// All plays of a sample.
#[derive(Debug, Clone)]
pub(super) struct Plays {
    pub set: PlaySet,
    pub radii_m: Vec<f64>,
    joints: Vec<PlayJoint>,
    /// What each variable does to its joint with the journals in the middle.
    middle: Vec<MarkerShift>,
}

impl Plays {
    pub(super) fn new(loops: &Loops) -> Self {
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
    pub(super) fn shifts(&self, loops: &Loops, scaled: &[f64], metres: &mut Vec<f64>, shifts: &mut Vec<MarkerShift>) {
        metres.clear();
        metres.extend(scaled.iter().zip(&self.radii_m).map(|(value, radius)| value * radius));
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
    pub(super) fn gains(
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
            let gain = |(variable, shift): (usize, &MarkerShift)| {
                let change = by_shift.dot(shift.shift_m) + by_slope[0] * shift.slope[0] + by_slope[1] * shift.slope[1];
                -change * self.radii_m[variable]
            };
            let play = metres.and_then(|metres| Some((loops.mechanism.joints()[own.joint].play.as_ref()?, metres)));
            match play {
                Some((play, metres)) => {
                    let shifts = play.derivatives(&metres[own.variables.clone()]);
                    gains.extend(own.variables.clone().zip(&shifts).map(gain));
                }
                None => gains.extend(own.variables.clone().zip(&self.middle[own.variables.clone()]).map(gain)),
            }
        }
    }
}
