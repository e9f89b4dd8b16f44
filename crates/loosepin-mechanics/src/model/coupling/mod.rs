//! Couplings: the coordinate of one joint follows that of another. The kinds of coupling are one file each, and the list of them is
//! here. Nothing outside this folder names a kind.
//!
//! A kind says of itself what the rest of the program asks ([`KindOfCoupling`]), reads its own table, and has the numbers of its
//! function ([`Curve`]).

mod belt;
mod cam;
mod cam_profile;
mod gears;
mod kind;
mod play;
mod proportion;
mod rack;
mod ratio;
mod reading;
mod teeth;
mod wheels;

pub use belt::Belt;
pub use cam::Cam;
pub use cam_profile::CamProfile;
pub use gears::Gears;
pub use kind::{Coupled, Curve, KindOfCoupling, PitchCircles};
pub use play::CouplingPlay;
pub use proportion::Proportion;
pub use rack::Rack;
pub use ratio::Ratio;
pub use reading::CouplingReader;
pub use teeth::{Mesh, Teeth};
pub use wheels::Wheels;

use super::ids::JointId;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::numbers::QuantityId;
use std::fmt::Write;

/// A coupling of two joints: the coordinate of the second (angle of the journal's body from the bearing's, rad, or position of
/// the slider along the guide, m) is a function of that of the first. Without play it does no net work.
#[derive(Debug, Clone)]
pub struct Coupling {
    /// Its table in the file, for example `coupling.mesh`.
    pub path: String,
    /// The joint that is followed.
    pub first: JointId,
    /// The joint that follows.
    pub second: JointId,
    /// How.
    pub kind: CouplingKind,
    /// Absent for a coupling that is always ideal.
    pub play: Option<CouplingPlay>,
    /// There where the joints feel the force of the teeth; else they act with torques alone.
    pub teeth: Option<Teeth>,
}

impl Coupling {
    /// Reads the coupling of the kind `word` from its table at `entry`; `None` after a diagnostic.
    pub(super) fn read(
        word: &str,
        entry: &Entry<'_>,
        table: &Table<'_>,
        reader: &mut dyn CouplingReader,
    ) -> Option<Self> {
        let Coupled { joints: [first, second], kind, play, teeth } = CouplingKind::read(word, entry, table, reader)?;
        Some(Self { path: entry.path.dotted(), first, second, kind, play, teeth })
    }

    /// `'output' follows 'input' times -20 mm / 45 mm`.
    pub fn words(&self, names: &dyn Names) -> String {
        let [first, second] = [self.first, self.second].map(|joint| names.joint(joint));
        let mut words = format!("'{second}' follows '{first}' {}", self.kind.words(names));
        if let Some(teeth) = &self.teeth {
            let angle = names.quantity(teeth.pressure_angle_rad);
            let _ = write!(words, "; their joints carry the force of the teeth, with a pressure angle of {angle}");
        }
        words
    }
}

/// Makes the enum of all kinds and that of their numbers, and hands every question on to the kind. Each kind stands with the numbers of its
/// function; kinds of `[coupling.NAME]` first, then those with tables of their own.
macro_rules! coupling_kinds {
    (
        of_coupling_tables { $($(#[$doc:meta])* $kind:ident($curve:ident),)* }
        of_own_tables { $($(#[$own_doc:meta])* $own_kind:ident($own_curve:ident),)* }
    ) => {
        /// Words of the kinds of `[coupling.NAME]`, with their keys.
        pub(super) static COUPLING_KINDS: &[(&str, &Keys)] = &[$(($kind::WORD, $kind::KEYS)),*];

        coupling_kinds! { all $($(#[$doc])* $kind($curve),)* $($(#[$own_doc])* $own_kind($own_curve),)* }
    };
    (all $($(#[$doc:meta])* $kind:ident($curve:ident),)*) => {
        /// A coupling of any kind: how the second joint follows the first.
        #[derive(Debug, Clone)]
        pub enum CouplingKind {
            $($(#[$doc])* $kind($kind),)*
        }

        /// Numbers of the coordinate of the second joint over that of the first.
        #[derive(Debug, Clone)]
        pub enum CouplingNumbers<T> {
            $($(#[$doc])* $kind($curve<T>),)*
        }

        numbers!(enum CouplingNumbers { $($kind(curve)),* });

        impl CouplingKind {
            fn read(
                word: &str,
                entry: &Entry<'_>,
                table: &Table<'_>,
                reader: &mut dyn CouplingReader,
            ) -> Option<Coupled<Self>> {
                match word {
                    $(<$kind as KindOfCoupling>::WORD => {
                        let Coupled { joints, kind, play, teeth } = $kind::read(entry, table, reader)?;
                        Some(Coupled { joints, kind: Self::$kind(kind), play, teeth })
                    })*
                    _ => None,
                }
            }

            /// See [`KindOfCoupling::quantities`].
            pub fn quantities(&self) -> Vec<QuantityId> {
                match self { $(Self::$kind(kind) => kind.quantities(),)* }
            }

            /// See [`KindOfCoupling::pitch_circles`].
            pub fn pitch_circles(&self) -> Option<PitchCircles> {
                match self { $(Self::$kind(kind) => kind.pitch_circles(),)* }
            }

            /// See [`KindOfCoupling::words`].
            pub fn words(&self, names: &dyn Names) -> String {
                match self { $(Self::$kind(kind) => kind.words(names),)* }
            }

            /// See [`KindOfCoupling::curve`].
            pub fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> CouplingNumbers<T> {
                match self { $(Self::$kind(kind) => CouplingNumbers::$kind(kind.curve(number)),)* }
            }
        }

        impl<T: Real> CouplingNumbers<T> {
            /// See [`Curve::at`].
            #[inline(always)]
            pub fn at(&self, coordinate: T) -> [T; 3] {
                match self { $(Self::$kind(curve) => curve.at(coordinate),)* }
            }

            /// See [`Curve::offset`].
            pub fn offset(&self) -> Option<T> {
                match self { $(Self::$kind(curve) => curve.offset(),)* }
            }

            /// See [`Curve::offset_mut`].
            pub fn offset_mut(&mut self) -> Option<&mut T> {
                match self { $(Self::$kind(curve) => curve.offset_mut(),)* }
            }

            /// See [`Curve::gain`].
            pub fn gain(&self, scale: T) -> T {
                match self { $(Self::$kind(curve) => curve.gain(scale),)* }
            }
        }
    };
}

coupling_kinds! {
    of_coupling_tables {
        /// Two gears in mesh.
        Gears(Proportion),
        /// A belt or a chain around two wheels.
        Belt(Proportion),
        /// A rack and its pinion.
        Rack(Proportion),
        /// A ratio as given.
        Ratio(Proportion),
    }
    of_own_tables {
        /// A cam and its follower.
        Cam(CamProfile),
    }
}

/// Name of the tables of cams, and their keys.
pub(super) const CAM: (&str, &Keys) = (Cam::WORD, Cam::KEYS);
