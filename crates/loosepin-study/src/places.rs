//! Places in the cycle: those that questions name, and those of the numbers that a run delivers for them.

use std::f64::consts::TAU;

use loosepin_mechanics::model::Cycle;
use loosepin_result::study::Reduction;

/// Place in the cycle of a question or a requirement.
#[derive(Debug, Clone, PartialEq)]
pub enum Where {
    /// Everywhere: the curve over the cycle.
    Cycle,
    /// At angles of the cycle's input.
    Poses {
        /// The angles, rad, in file order.
        angles_rad: Vec<f64>,
    },
    /// One number of the whole curve.
    Reduced(Reduction),
}

impl Where {
    /// The whole curve over the cycle.
    pub fn over_cycle() -> Self {
        Self::Cycle
    }

    /// Angles of the cycle's input, rad.
    pub fn at_angles(angles_rad: Vec<f64>) -> Self {
        Self::Poses { angles_rad }
    }

    /// One number of the whole curve.
    pub fn reduced(reduction: Reduction) -> Self {
        Self::Reduced(reduction)
    }

    /// Whether it is the whole curve.
    pub fn is_cycle(&self) -> bool {
        *self == Self::Cycle
    }

    /// The angles, rad, where it has some.
    pub fn angles_rad(&self) -> Option<&[f64]> {
        if let Self::Poses { angles_rad } = self { Some(angles_rad) } else { None }
    }

    /// Its angles one by one, rad; a single `None` where it has none.
    pub(crate) fn poses_rad(&self) -> Vec<Option<f64>> {
        self.angles_rad().map_or_else(|| vec![None], |angles_rad| angles_rad.iter().copied().map(Some).collect())
    }

    /// Which number of the curve it is, where it is one.
    pub fn reduction(&self) -> Option<Reduction> {
        if let Self::Reduced(reduction) = self { Some(*reduction) } else { None }
    }

    /// Each angle by itself; any other place as it is.
    pub fn angle_by_angle(&self) -> Vec<Self> {
        match self.angles_rad() {
            // Adding zero leaves one of the two zeros.
            Some(angles_rad) => angles_rad.iter().map(|angle_rad| Self::at_angles(vec![angle_rad + 0.0])).collect(),
            None => vec![self.clone()],
        }
    }

    /// How many numbers a run delivers for it, where the cycle has so many recorded positions.
    pub fn numbers(&self, positions: usize) -> usize {
        match self {
            Self::Cycle => positions,
            Self::Poses { angles_rad } => angles_rad.len(),
            Self::Reduced(_) => 1,
        }
    }

    /// The places of its numbers.
    pub(crate) fn locations(&self, recorded: &RecordedPart<'_>) -> Vec<Location> {
        match self {
            Self::Cycle => recorded.positions(),
            Self::Poses { angles_rad } => angles_rad.iter().map(|&angle_rad| recorded.position_at(angle_rad)).collect(),
            Self::Reduced(reduction) => vec![Location::reduced(*reduction)],
        }
    }
}

/// The recorded part of a cycle, and how its input turns.
pub(crate) struct RecordedPart<'c> {
    pub cycle: &'c Cycle,
    /// Angle of the input at time zero, rad.
    pub start_rad: f64,
    /// 1, or -1 where it turns backwards.
    pub sign: f64,
}

impl RecordedPart<'_> {
    /// Angle of the input after so many recorded turns, rad. People count the recorded turns, not those before them.
    fn angle_rad(&self, turns: f64) -> f64 {
        let before = self.cycle.transient_turns;
        self.start_rad + self.sign * TAU * (before + turns) - self.sign * TAU * before.floor()
    }

    /// Every recorded position.
    fn positions(&self) -> Vec<Location> {
        let turns = self.cycle.recorded_turns;
        let rows = (turns * self.cycle.samples_per_turn as f64).round().max(1.0);
        // A whole number of turns ends where it began: the last row would repeat the first.
        let is_closed = turns.fract() == 0.0;
        (0..rows as usize + usize::from(!is_closed))
            .map(|row| turns * row as f64 / rows)
            .map(|turns| Location::at_pose(turns, self.angle_rad(turns)))
            .collect()
    }

    /// The position at an angle, counted as those of a whole curve are. One that lies before the recorded part is where the drive comes by first.
    fn position_at(&self, angle_rad: f64) -> Location {
        let ahead = self.sign * (angle_rad - self.angle_rad(0.0)) / TAU;
        let turns = if ahead < 0.0 { ahead - ahead.floor() } else { ahead };
        // An angle at the very start comes out as a whole turn by round-off.
        let is_at_start = ahead < 0.0 && turns > 1.0 - 1e-12;
        Location::at_pose(if is_at_start { 0.0 } else { turns }, angle_rad)
    }
}

/// An angle of the drive in the recorded turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Turns since the start of the recorded part.
    pub turns: f64,
    /// Angle of the drive as it is shown, rad: the one asked for, or counted from the first recorded turn.
    pub angle_rad: f64,
}

/// Place of a number of a run in the recorded turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Location {
    /// At an angle of the drive.
    Pose(Pose),
    /// The recorded part reduced to one number.
    Reduced(Reduction),
}

/// Key of a location: the bits of a pose, or the reduction.
pub(crate) type LocationKey = Result<[u64; 2], Reduction>;

impl Location {
    /// At this many turns of the drive after the start of the recorded part, where its angle is shown as `angle_rad`.
    pub fn at_pose(turns: f64, angle_rad: f64) -> Self {
        Self::Pose(Pose { turns, angle_rad })
    }

    /// The recorded part reduced to one number.
    pub fn reduced(reduction: Reduction) -> Self {
        Self::Reduced(reduction)
    }

    /// The pose, unless it is a number of the whole.
    pub fn pose(&self) -> Option<Pose> {
        if let Self::Pose(pose) = self { Some(*pose) } else { None }
    }

    /// Which number of the whole it is, unless it is a pose.
    pub fn reduction(&self) -> Option<Reduction> {
        if let Self::Reduced(reduction) = self { Some(*reduction) } else { None }
    }

    /// What is made of it: of a pose, or of a reduction.
    pub(crate) fn turned_into<R>(
        self,
        of_pose: impl FnOnce(Pose) -> R,
        of_reduction: impl FnOnce(Reduction) -> R,
    ) -> R {
        match self {
            Self::Pose(pose) => of_pose(pose),
            Self::Reduced(reduction) => of_reduction(reduction),
        }
    }

    pub(crate) fn key(self) -> LocationKey {
        // Adding zero leaves one of the two zeros.
        self.turned_into(|pose| Ok([pose.turns, pose.angle_rad].map(|number| (number + 0.0).to_bits())), Err)
    }
}
