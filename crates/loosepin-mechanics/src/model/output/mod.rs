//! Outputs: what a run measures. One file for each kind, and the list of them here. Nothing outside this folder names a kind.
//!
//! A kind says of itself what the rest of the program asks ([`KindOfOutput`]), reads its own table, and reads its number off a state
//! ([`KindOfReading`]).

mod asked_paths;
mod effort;
mod joint_force;
mod kind;
mod motion;
mod path;
mod position;
mod reader;
mod state;
mod stress;
mod table;
mod wear;

pub use effort::{Effort, EffortMeasure};
pub use joint_force::{Component, JointForce};
pub use kind::{KindOfOutput, KindOfReading, Measure, NoReading};
pub use motion::Motion;
pub use path::PointPath;
pub use position::{Derivative, Position, Relative, relative_words};
pub use reader::{ActuatorFacts, BeamFacts, OutputReader};
pub use state::OutputState;
pub use stress::Stress;
pub use wear::Wear;

use super::ids::{BodyId, JointId, PointId};
use crate::model::parts::wear::WearMeasure;
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Key, Keys, Table, count_of, joined};
use loosepin_text::units::{Dimension, ReadableUnit};

/// Makes the enum of all kinds and that of their readings at an instant, and forwards every call to the kind.
macro_rules! output_kinds {
    ($($(#[$doc:meta])* $kind:ident),* $(,)?) => {
        /// The quantity that an output measures, of any kind.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum OutputKind {
            $($(#[$doc])* $kind($kind),)*
        }

        /// The measures of each kind, the keys that stand beside them, and the words of its component.
        const MEASURES_OF_KINDS: &[&[Measure]] = &[$(<$kind as KindOfOutput>::MEASURES),*];
        const KEYS_OF_KINDS: &[&[Key]] = &[$(<$kind as KindOfOutput>::KEYS),*];
        const COMPONENTS_OF_KINDS: &[&[&str]] = &[$(<$kind as KindOfOutput>::COMPONENTS),*];

        impl OutputKind {
            /// Reads an output of the kind with the key `measure`; `None` after a diagnostic.
            pub(super) fn read(
                measure: &'static str,
                table: &Table<'_>,
                reader: &mut dyn OutputReader,
            ) -> Option<Self> {
                let has = |measures: &[Measure]| measures.iter().any(|own| own.key.name == measure);
                $(if has(<$kind as KindOfOutput>::MEASURES) {
                    return $kind::read(measure, table, reader).map(Self::$kind);
                })*
                None
            }

            /// See [`KindOfOutput::USUAL_UNIT`].
            pub fn usual_unit(&self) -> Option<&'static str> {
                match self { $(Self::$kind(_) => <$kind as KindOfOutput>::USUAL_UNIT,)* }
            }

            /// See [`KindOfOutput::dimension`].
            pub fn dimension(&self) -> Dimension {
                match self { $(Self::$kind(kind) => kind.dimension(),)* }
            }

            /// See [`KindOfOutput::reading`].
            pub fn reading(&self) -> Option<Reading> {
                match self {
                    $(Self::$kind(kind) => kind.reading().map(|reading| Reading(ReadingKind::$kind(reading))),)*
                }
            }

            /// See [`KindOfOutput::path`].
            pub fn path(&self) -> Option<Relative<PointId>> {
                match self { $(Self::$kind(kind) => kind.path(),)* }
            }

            /// See [`KindOfOutput::wear`].
            pub fn wear(&self) -> Option<(JointId, WearMeasure)> {
                match self { $(Self::$kind(kind) => kind.wear(),)* }
            }

            /// See [`KindOfOutput::drawn_point`].
            pub fn drawn_point(&self) -> Option<PointId> {
                match self { $(Self::$kind(kind) => kind.drawn_point(),)* }
            }

            /// See [`KindOfOutput::stressed_body`].
            pub fn stressed_body(&self) -> Option<BodyId> {
                match self { $(Self::$kind(kind) => kind.stressed_body(),)* }
            }
        }

        /// The number that an output of each kind is at an instant; kinds that have none have no value here.
        #[derive(Debug, Clone, Copy, PartialEq)]
        enum ReadingKind {
            $($kind(<$kind as KindOfOutput>::Reading),)*
        }

        impl Reading {
            /// See [`KindOfReading::IS_ON_LANES`].
            pub fn is_on_lanes(&self) -> bool {
                match &self.0 { $(ReadingKind::$kind(_) => <$kind as KindOfOutput>::Reading::IS_ON_LANES,)* }
            }

            /// See [`KindOfReading::IS_EFFORT`].
            pub fn is_effort(&self) -> bool {
                match &self.0 { $(ReadingKind::$kind(_) => <$kind as KindOfOutput>::Reading::IS_EFFORT,)* }
            }

            /// See [`KindOfReading::words`].
            pub fn words(&self, names: &dyn PartNames) -> String {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.words(names),)* }
            }

            /// See [`KindOfReading::needs_forces`].
            pub fn needs_forces(&self) -> bool {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.needs_forces(),)* }
            }

            /// See [`KindOfReading::value`].
            #[inline(always)]
            pub(crate) fn value_at<T: Real>(&self, state: &impl OutputState<T>) -> T {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.value(state),)* }
            }

            /// See [`KindOfReading::position`].
            #[inline(always)]
            pub fn position(&self) -> Option<Position> {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.position(),)* }
            }

            /// See [`KindOfReading::motion_of`].
            pub fn motion_of(&self) -> Option<Position> {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.motion_of(),)* }
            }

            /// See [`KindOfReading::force_in`].
            pub fn force_in(&self) -> Option<JointId> {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.force_in(),)* }
            }

            /// See [`KindOfReading::is_never_negative`].
            pub fn is_never_negative(&self) -> bool {
                match &self.0 { $(ReadingKind::$kind(reading) => reading.is_never_negative(),)* }
            }
        }
    };
}

output_kinds! {
    /// A position or angle, or one of its time derivatives.
    Motion,
    /// Force of a joint.
    JointForce,
    /// Torque, force or power of a drive or control.
    Effort,
    /// Path of a point.
    PointPath,
    /// Wear of a joint after all cycles.
    Wear,
    /// Largest stress along a flexible body.
    Stress,
}

/// An output column of a run.
#[derive(Debug, Clone)]
pub struct Output {
    /// Name in the file.
    pub name: String,
    /// The measured quantity.
    pub kind: OutputKind,
    /// The unit in which people read it.
    pub unit: ReadableUnit,
}

/// A quantity that is read at an instant. Which kinds there are is known in this folder alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading(ReadingKind);

impl Reading {
    /// Whether it is a position or an angle, so that its first two time derivatives are velocities and accelerations.
    pub fn is_position(&self) -> bool {
        self.position().is_some()
    }
}

impl From<Motion> for Reading {
    fn from(motion: Motion) -> Self {
        Self(ReadingKind::Motion(motion))
    }
}

impl OutputKind {
    /// The measure that stands in the table of an output, and with it the other keys that mean something there.
    pub(super) fn measure_in(table: &Table<'_>) -> Option<&'static Measure> {
        MEASURES.iter().find(|measure| table.has(measure.key.name))
    }

    /// The keys that mean something beside some measures only.
    pub(super) fn keys_beside() -> impl Iterator<Item = &'static str> {
        let of_kinds = KEYS_OF_KINDS.iter().copied().flatten().map(|key| key.name);
        of_kinds.chain(std::iter::once("component"))
    }
}

const MEASURES: &[Measure; count_of(MEASURES_OF_KINDS)] = &joined(MEASURES_OF_KINDS);
const MEASURE_KEYS: &[Key; MEASURES.len()] = &table::keys(MEASURES);
static MEASURE_NAMES: [&str; MEASURES.len()] = table::names(MEASURE_KEYS);

const OWN_KEYS: &[Key; count_of(KEYS_OF_KINDS)] = &joined(KEYS_OF_KINDS);
const ALL_KEYS: [Key; MEASURES.len() + OWN_KEYS.len() + 2] =
    joined(&[MEASURE_KEYS, OWN_KEYS, &[table::component(component_words), table::UNIT]]);

/// The words behind `component`, each once.
fn component_words() -> Vec<&'static str> {
    let mut words: Vec<&'static str> = Vec::new();
    for word in COMPONENTS_OF_KINDS.iter().copied().flatten() {
        if !words.contains(word) {
            words.push(word);
        }
    }
    words
}

/// The keys of the table of an output.
pub(super) static OUTPUT_KEYS: Keys =
    Keys::new("a column of the results", &ALL_KEYS).with_exactly_one(&[&MEASURE_NAMES]);
