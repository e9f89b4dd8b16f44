//! The interface of a kind of output, and its terms.

use super::position::{Position, Relative};
use super::reader::OutputReader;
use super::state::OutputState;
use crate::model::ids::{BodyId, JointId, PointId};
use crate::model::parts::wear::WearMeasure;
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Key, Table};
use loosepin_text::units::Dimension;
use std::fmt::Debug;

/// A kind of output of a model.
///
/// The rest of the program asks these questions, and knows no kind by its name. Constants are what all outputs of a kind have in common,
/// methods what one of them states.
pub trait KindOfOutput: Sized {
    /// Keys of which exactly one stands in the table of an output.
    const MEASURES: &'static [Measure];
    /// Keys that stand beside a measure, and that no kind before it in the list has.
    const KEYS: &'static [Key] = &[];
    /// Words that stand behind the key `component`.
    const COMPONENTS: &'static [&'static str] = &[];
    /// The unit in which people read it, where that is not the one of its dimension.
    const USUAL_UNIT: Option<&'static str> = None;
    /// The number that is read at an instant; [`NoReading`] where there is none.
    type Reading: KindOfReading;

    /// Reads it from its table, whose key is `measure`; `None` after a diagnostic.
    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self>;

    /// Dimension of its columns.
    fn dimension(&self) -> Dimension;

    /// The number that it has at each instant, which is one column; `None` of what has none.
    fn reading(&self) -> Option<Self::Reading> {
        None
    }

    /// The point whose path it is: two columns, x and y, and errors from its ideal path.
    fn path(&self) -> Option<Relative<PointId>> {
        None
    }

    /// The joint, and the measure of its wear after all cycles: one number of a run, without a history.
    fn wear(&self) -> Option<(JointId, WearMeasure)> {
        None
    }

    /// The point that drawings mark for it.
    fn drawn_point(&self) -> Option<PointId> {
        None
    }

    /// The flexible body whose stress is computed for it.
    fn stressed_body(&self) -> Option<BodyId> {
        None
    }
}

/// A number that is read off the state of a mechanism.
pub trait KindOfReading: Copy + PartialEq + Debug {
    /// Whether it is a number of the lanes; else it is looked at in plain states alone.
    const IS_ON_LANES: bool = true;
    /// Whether it is an effort of a drive or control: `motion` shows it along the ideal motion too, where no positions of points are
    /// available.
    const IS_EFFORT: bool = false;

    /// The quantity in words, for example `x of slider.pin`.
    fn words(&self, names: &dyn PartNames) -> String;

    /// Whether accelerations or forces are needed, not only positions and velocities.
    fn needs_forces(&self) -> bool;

    /// The value, SI.
    fn value<T: Real>(&self, state: &impl OutputState<T>) -> T;

    /// The position or angle that it is, so that its first two time derivatives are velocities and accelerations.
    fn position(&self) -> Option<Position> {
        None
    }

    /// The position or angle that it is, or whose derivative it is.
    fn motion_of(&self) -> Option<Position> {
        None
    }

    /// The joint whose force it is, or whose component.
    fn force_in(&self) -> Option<JointId> {
        None
    }

    /// Whether it is a magnitude: no value is below zero.
    fn is_never_negative(&self) -> bool {
        false
    }
}

/// A key of which exactly one stands in the table of an output.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// The key.
    pub key: Key,
    /// The keys that mean something beside it.
    pub beside: &'static [&'static str],
}

/// The number of an output that has none at an instant: there is no such value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoReading {}

impl KindOfReading for NoReading {
    fn words(&self, _names: &dyn PartNames) -> String {
        match *self {}
    }

    fn needs_forces(&self) -> bool {
        match *self {}
    }

    fn value<T: Real>(&self, _state: &impl OutputState<T>) -> T {
        match *self {}
    }
}
