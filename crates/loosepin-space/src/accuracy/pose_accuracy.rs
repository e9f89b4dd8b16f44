//! The loop equations of a position with play.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::linear::planes::Planes;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::plays::Plays;
use crate::closure::bordered::Bordered;
use crate::closure::loops::Loops;
use crate::closure::newton::{Closed, close, largest};
use crate::closure::position::Position;
use crate::closure::singular::RANK_THRESHOLD;
use crate::closure::step::CLOSED;
use crate::kind::frames::JointFrames;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};

/// Part of a gradient along free motions, relative to all of it, that is round-off.
const FREE_SHARE: f64 = 1e-7;
/// Singular values and pivots above this, relative to the largest, are far from zero.
const FAR_FROM_SINGULAR: f64 = 1e-4;
/// Part of a redundant row that plays do not reach, relative to the largest derivative by play.
const NEGLIGIBLE: f64 = 1e-9;

/// A position, its loop equations, and what play does to them.
///
/// To first order J dx + K dp + N dν = 0, with K the derivatives of the rows by the variables p of play and N a basis of the redundant
/// combinations. An output with gradient c has the gains g = -yᵀK, Jᵀy = c; the loops close where ν = 0, which is h·p = 0, h = -aᵀK, aᵀJ = 0.
#[derive(Debug, Clone)]
pub struct PoseAccuracy<'a> {
    pub(crate) loops: Loops<'a>,
    pub(crate) position: Position,
    pub(crate) frames: Vec<JointFrames>,
    pub(crate) system: Bordered,
    /// ν of the ideal position: how far redundant rows of parts with few digits are from closing.
    pub(crate) apart: Vec<f64>,
    pub(crate) set: PlaySet,
    pub(crate) plays: Plays,
    /// h of each redundant row, of variables in units of their radii.
    pub(crate) redundant: Vec<Vec<f64>>,
    pub(crate) planes: Planes,
}

impl<'a> PoseAccuracy<'a> {
    /// The accuracy of `mechanism` in a position of it.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NotAPosition`] and [`AccuracyError::Singular`].
    pub fn new(mechanism: &'a SpatialMechanism, position: &Position) -> Result<Self, AccuracyError> {
        if position.poses.len() != mechanism.bodies().len() || position.drives.len() != mechanism.drives().len() {
            return Err(AccuracyError::NotAPosition);
        }
        let loops = Loops::new(mechanism);
        // To round-off: deviations are differences.
        let closed = close(&loops, &position.poses, &[], &position.drive_values(), &position.borders, None)
            .map_err(|_| AccuracyError::NotAPosition)?;
        Self::of_closed(loops, position, closed)
    }

    /// The accuracy in a position of which the borders are known, closed to round-off.
    pub(crate) fn of_closed(loops: Loops<'a>, position: &Position, closed: Closed) -> Result<Self, AccuracyError> {
        let position = Position { poses: closed.poses, ..position.clone() };
        let (frames, system, apart) = (closed.frames, closed.system, closed.apart);
        // Pivots that are far from zero, and a position that was, need no closer look.
        let is_regular = position.singular_ratio > FAR_FROM_SINGULAR && system.pivot_ratio() > FAR_FROM_SINGULAR;
        if !is_regular && !(system.singular_ratio(&loops, &frames, &position.borders) > RANK_THRESHOLD) {
            return Err(AccuracyError::Singular);
        }
        let plays = Plays::new(&loops);
        let redundant = redundant(&loops, &frames, &system, &plays, None);
        let size = if redundant.is_empty() { 0.0 } else { plays.largest_derivative(&loops, &frames, None) };
        let planes = Planes::new(&redundant, plays.set.variables(), NEGLIGIBLE * size);
        Ok(Self { set: plays.set.clone(), loops, position, frames, system, apart, plays, redundant, planes })
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &'a SpatialMechanism {
        self.loops.mechanism
    }

    /// The ideal position.
    pub fn position(&self) -> &Position {
        &self.position
    }

    /// The variables of play.
    pub fn play_set(&self) -> &PlaySet {
        &self.set
    }

    /// Whether the parts do not fit without play: redundant rows are open by more than the digits of a file.
    pub(crate) fn is_open(&self) -> bool {
        !(largest(&self.apart) <= CLOSED)
    }

    /// ν at which the loops count as closed: that of numbers with few digits, and zero where the parts do not fit without play.
    pub(crate) fn closed_rows(&self) -> Vec<f64> {
        if self.is_open() { vec![0.0; self.apart.len()] } else { self.apart.clone() }
    }

    /// Planes of redundant rows at another place: what plays do not reach is none.
    pub(crate) fn planes_of(&self, rows: &[Vec<f64>]) -> Planes {
        let reach = rows.iter().flatten().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        Planes::new(rows, self.set.variables(), NEGLIGIBLE * reach)
    }

    /// Conditions that the plays must meet together so that the loops close: redundant rows that plays reach.
    pub fn conditions(&self) -> usize {
        self.planes.count()
    }

    /// Gains of an output.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::OutputDoesNotFit`] and [`AccuracyError::OutputIsFree`].
    pub fn gains(&self, output: &SpatialOutput) -> Result<Gains, AccuracyError> {
        if !output.fits(self.mechanism()) {
            return Err(AccuracyError::OutputDoesNotFit);
        }
        let ideal = self.ideal_state();
        let gradient = self.gradient(output, &ideal);
        let (by_rows, free) = self.system.solve_transposed(&gradient);
        if largest(&free) > FREE_SHARE * largest(&gradient) {
            return Err(AccuracyError::OutputIsFree);
        }
        let mut by_play = Vec::with_capacity(self.set.variables());
        self.plays.gains_in_metres(&self.loops, &self.frames, &by_rows, None, &mut by_play);
        Ok(Gains { output: *output, blocks: self.set.blocks().to_vec(), by_play, by_rows })
    }

    /// h of each redundant row by the variables of play: to first order the loops close where h·p = 0. In the order of
    /// [`crate::FirstOrder::multipliers`], in units of the characteristic length; rows that no play reaches are zero.
    pub fn conditions_by_play(&self) -> Vec<Vec<f64>> {
        let gains = |row: Vec<f64>| {
            let mut gains = Vec::new();
            self.plays.gains_in_metres(&self.loops, &self.frames, &row, None, &mut gains);
            gains
        };
        self.system.redundant_rows().into_iter().map(gains).collect()
    }

    pub(crate) fn ideal_state(&self) -> OutputState<'_> {
        OutputState { mechanism: self.loops.mechanism, poses: &self.position.poses }
    }

    /// Gradient of an output over the scaled unknowns.
    pub(crate) fn gradient(&self, output: &SpatialOutput, actual: &OutputState) -> Vec<f64> {
        let mut gradient = vec![0.0; self.loops.unknowns()];
        for part in output.gradient(&self.ideal_state(), actual) {
            self.loops.add_gradient(&mut gradient, part.body, part.by_displacement, part.by_turning);
        }
        gradient
    }
}

/// h of each redundant row at some frames: derivatives of ν by the variables of play in units of their radii. `metres` are the places of the
/// journals; `None` in the middle.
pub(crate) fn redundant(
    loops: &Loops,
    frames: &[JointFrames],
    system: &Bordered,
    plays: &Plays,
    metres: Option<&[f64]>,
) -> Vec<Vec<f64>> {
    let gains = |row: Vec<f64>| {
        let mut gains = Vec::with_capacity(plays.set.variables());
        plays.gains(loops, frames, &row, metres, &mut gains);
        gains
    };
    system.redundant_rows().into_iter().map(gains).collect()
}
