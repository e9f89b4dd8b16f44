//! How a curve over the recorded turns becomes one number: one reduction a file, a struct with its `DESCRIPTION` and `ReductionKind`, and
//! one line in the list below. Nobody outside of this folder asks which reduction it is: they ask what it is like.

mod kind;
mod maximum;
mod maximum_absolute;
mod mean;
mod minimum;
mod range;
mod root_mean_square;
#[cfg(test)]
mod tests;

pub use kind::{Course, CourseEnds, ReductionDescription};

use crate::statistic::Event;
use kind::ReductionKind;
use serde::{Deserialize, Serialize};

macro_rules! reductions {
    ($($(#[$doc:meta])* $name:ident: $word:literal in $file:ident),* $(,)?) => {
        /// How a curve over the recorded turns becomes one number.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
        pub enum Reduction {
            $($(#[$doc])* #[serde(rename = $word)] $name,)*
        }

        impl Reduction {
            /// Every reduction, in the order in which study files name them.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$name),*];

            /// The word used in study files and in results.
            pub const fn word(self) -> &'static str {
                match self { $(Self::$name => $word,)* }
            }

            /// Its other names.
            pub const fn description(self) -> &'static ReductionDescription {
                match self { $(Self::$name => &$file::$name::DESCRIPTION,)* }
            }

            fn kind(self) -> &'static dyn ReductionKind {
                match self { $(Self::$name => &$file::$name,)* }
            }
        }
    };
}

reductions! {
    /// The largest value, located between the samples.
    Maximum: "maximum" in maximum,
    /// The smallest value, located between the samples.
    Minimum: "minimum" in minimum,
    /// The largest magnitude, located between the samples.
    MaximumAbsolute: "maximum_absolute" in maximum_absolute,
    /// The root of the mean square.
    RootMeanSquare: "rms" in root_mean_square,
    /// The mean over time.
    Mean: "mean" in mean,
    /// Maximum minus minimum.
    Range: "range" in range,
}

impl Reduction {
    /// How far a curve goes to either side: what answers for a whole cycle where nothing else is said.
    pub const fn largest_magnitude() -> Self {
        Self::MaximumAbsolute
    }

    /// The number of a curve for which an event happens where it happens for any of its values.
    pub const fn furthest_into(event: Event) -> Self {
        match event {
            Event::Above(_) => Self::Maximum,
            Event::Below(_) | Event::UpTo(_) => Self::Minimum,
            Event::Beyond(_) => Self::MaximumAbsolute,
        }
    }

    /// The number of a curve.
    pub fn of(self, course: &Course) -> f64 {
        self.kind().of(course)
    }

    /// The least and the largest number of the curves that lie between two others.
    pub fn ends(self, between: &CourseEnds) -> [f64; 2] {
        self.kind().ends(between)
    }

    /// Whether no curve gives a larger number than by `other`.
    pub fn never_exceeds(self, other: Self) -> bool {
        self.kind().never_exceeds(other.kind())
    }

    /// How far a point of a curve between these ends may take the number, in its direction: the point that can take it furthest decides it.
    /// `None` of numbers that all points make.
    pub fn reach(self, ends: [f64; 2]) -> Option<f64> {
        self.kind().reach(ends)
    }

    /// Whether no curve gives a negative number.
    pub fn is_never_negative(self) -> bool {
        self.kind().is_never_negative()
    }

    /// Whether the curve is integrated for it.
    pub fn is_of_means(self) -> bool {
        self.kind().is_of_means()
    }

    /// The direction, 1 or -1, in which a longer curve alone can take it; `None` where it can go either way.
    pub fn moved_by_more_turns(self) -> Option<f64> {
        self.kind().moved_by_more_turns()
    }
}
