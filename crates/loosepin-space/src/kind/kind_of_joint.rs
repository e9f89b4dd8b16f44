//! What every kind of joint says of itself.

use crate::kind::joint_reader::JointReader;
use crate::kind::places::Markers;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::play::kind_of_play::PlayOfFile;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;

/// A kind of ideal joint between a marker on body i and one on body j. The rest of the program asks these questions, and knows no kind by its
/// name.
pub(crate) trait KindOfJoint: Copy {
    /// Word in files.
    const WORD: &'static str;
    /// Keys of its table.
    const KEYS: &'static Keys;
    /// Whether the angle φ = atan2(y_i·x_j, x_i·x_j) about z is a coordinate of it.
    const TURNS: bool;
    /// Whether the place z_i·d along z is a coordinate of it.
    const SLIDES: bool;
    /// What is drawn of it.
    const SIGN: JointSign;
    /// Its play; [`crate::play::kind_of_play::NoPlay`] of a kind that has none.
    type Play: PlayOfFile;

    /// Reads it from its table; `None` after a diagnostic.
    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>>;

    /// The rows that hold the journal's marker to the bearing's.
    fn rows(&self) -> Vec<Row>;

    /// Itself with these values of [`ReadJoint::numbers`].
    fn with_numbers(self, numbers: &[f64]) -> Self {
        let _ = numbers;
        self
    }

    /// The rule that its numbers break, if they do.
    fn mistake(&self) -> Option<&'static str> {
        None
    }

    /// Advance along z in one turn, m, where the place along z follows the angle.
    fn pitch_m(&self) -> Option<f64> {
        None
    }
}

/// A joint as its table gives it.
pub(crate) struct ReadJoint<K, P> {
    /// Its kind.
    pub kind: K,
    /// The numbers of its kind, as quantities of the model.
    pub numbers: Vec<QuantityId>,
    /// Where it is on both bodies.
    pub markers: Markers,
    /// Its play; `None` of an ideal joint.
    pub play: Option<P>,
}

impl<K, P> ReadJoint<K, P> {
    /// An ideal joint whose kind has no number of its own.
    pub(crate) fn ideal(kind: K, markers: Markers) -> Self {
        Self { kind, numbers: Vec::new(), markers, play: None }
    }

    /// The joint as one of any kind.
    pub(crate) fn into_any<A: From<K>, B: From<P>>(self) -> ReadJoint<A, B> {
        let Self { kind, numbers, markers, play } = self;
        ReadJoint { kind: kind.into(), numbers, markers, play: play.map(B::from) }
    }
}
