//! Kinds of joints: the rows that each is made of, with a file for each kind. Nothing else names a kind.

pub(crate) mod frames;
pub(crate) mod kind_of_joint;
pub(crate) mod row;
pub(crate) mod sign;

mod cylindrical;
mod planar;
mod prismatic;
mod revolute;
mod rigid;
mod screw;
mod spherical;
mod universal;

use kind_of_joint::KindOfJoint;
use row::Row;
use sign::JointSign;

pub use cylindrical::Cylindrical;
pub use planar::Planar;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use rigid::Rigid;
pub use screw::Screw;
pub use spherical::Spherical;
pub use universal::Universal;

/// Lists the kinds once: variant, doc.
macro_rules! spatial_kinds {
    ($($kind:ident),* $(,)?) => {
        /// A kind of joint in space; each stands in a file of its own.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SpatialKind {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $kind($kind),)*
        }
        impl KindOfJoint for SpatialKind {
            fn word(&self) -> &'static str {
                match self { $(Self::$kind(kind) => kind.word(),)* }
            }
            fn rows(&self) -> Vec<Row> {
                match self { $(Self::$kind(kind) => kind.rows(),)* }
            }
            fn turns(&self) -> bool {
                match self { $(Self::$kind(kind) => kind.turns(),)* }
            }
            fn slides(&self) -> bool {
                match self { $(Self::$kind(kind) => kind.slides(),)* }
            }
            fn play_keys(&self) -> &'static [&'static str] {
                match self { $(Self::$kind(kind) => kind.play_keys(),)* }
            }
            fn sign(&self) -> JointSign {
                match self { $(Self::$kind(kind) => kind.sign(),)* }
            }
        }
        $(impl From<$kind> for SpatialKind {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*
    };
}

spatial_kinds!(Revolute, Prismatic, Cylindrical, Spherical, Universal, Planar, Screw, Rigid);

impl SpatialKind {
    /// The kinds that have no number of their own.
    const PLAIN: [Self; 7] = [
        Self::Revolute(Revolute),
        Self::Prismatic(Prismatic),
        Self::Cylindrical(Cylindrical),
        Self::Spherical(Spherical),
        Self::Universal(Universal),
        Self::Planar(Planar),
        Self::Rigid(Rigid),
    ];

    /// The kind of this name, for those that have no number of their own: all but [`Screw`].
    pub fn from_word(word: &str) -> Option<Self> {
        Self::PLAIN.into_iter().find(|kind| kind.word() == word)
    }

    /// A screw with its pitch, m.
    pub fn screw(pitch_m: f64) -> Self {
        Self::Screw(Screw { pitch_m })
    }

    /// Degrees of freedom that it leaves: 6 minus its rows.
    pub fn freedoms(&self) -> usize {
        6 - self.rows().into_iter().map(|row| row.scalars().len()).sum::<usize>()
    }

    /// The pitch of a screw, m; `None` of other kinds.
    pub(crate) fn pitch_m(&self) -> Option<f64> {
        if let Self::Screw(screw) = self { Some(screw.pitch_m) } else { None }
    }

    /// Whether it has a pitch that is not a number, or zero.
    pub(crate) fn is_without_pitch(&self) -> bool {
        self.pitch_m().is_some_and(|pitch_m| !(pitch_m.is_finite() && pitch_m != 0.0))
    }
}
