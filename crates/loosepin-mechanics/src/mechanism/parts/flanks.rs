//! The numbers of a coupling with play.

use crate::mechanism::loops::coupling_geometry::CouplingGeometry;
use crate::mechanism::play_shape::{PlayForm, PlayFreedom};
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::spanning_tree::CouplingPlace;
use loosepin_math::{Real, numbers};

/// Teeth between flanks, or a follower on its cam. The second joint's coordinate deviates by the length x = r (q_2 - f(q_1))
/// from where the first would have it.
#[derive(Debug, Clone)]
pub struct Flanks<T> {
    /// f, and the two joints.
    pub coupling: CouplingGeometry<T>,
    /// Indices of the two joints in the real tree.
    pub places: CouplingPlace,
    /// Whether only x < 0 is resisted: a follower may lift off its cam, a tooth has another flank behind it.
    pub is_one_sided: bool,
}

numbers!(struct Flanks { coupling; places, is_one_sided });

impl<T: Real> Flanks<T> {
    /// x, m, and ẋ, m/s. Out of line, as the functions of a slot: not every mechanism has flanks.
    #[inline(never)]
    pub fn deviation_m(&self, kinematics: &Kinematics<T>) -> [T; 2] {
        let (coupling, places) = (&self.coupling, &self.places);
        [coupling.lever * coupling.residual(places, kinematics), coupling.lever * coupling.rate(places, kinematics)]
    }
}

impl<T: Real> PlayForm<T> for Flanks<T> {
    fn freedom(&self) -> PlayFreedom<T> {
        PlayFreedom::AlongPitchLine
    }

    /// The thickness of a tooth or a cam is not modelled.
    fn thickness_m(&self, _clearance_m: T) -> T {
        T::from_f64(f64::INFINITY)
    }

    fn may_lift(&self) -> bool {
        self.is_one_sided
    }
}

/// Names of the two contacts of teeth, by where the second wheel is against the first.
pub(in crate::mechanism) const FLANKS: [&str; 2] = ["behind", "ahead"];
