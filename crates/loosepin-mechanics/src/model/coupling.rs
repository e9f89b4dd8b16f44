//! Couplings: the coordinate of one joint follows that of another.

use super::ids::{ContactId, JointId};
use super::quantity::QuantityId;

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
    pub law: CouplingLaw,
    /// Absent for a coupling that is always ideal.
    pub play: Option<CouplingPlay>,
    /// There where the joints feel the force of the teeth; else they act with torques alone.
    pub teeth: Option<Teeth>,
}

/// The teeth of gears, or of a rack and its pinion, whose force the two joints feel.
#[derive(Debug, Clone, Copy)]
pub struct Teeth {
    /// Pressure angle α at the pitch circles, rad, in [0, 45 deg).
    pub pressure_angle_rad: QuantityId,
    /// How they mesh.
    pub mesh: Mesh,
    /// Whether the body with the teeth is the second of its joint (journal, slider), not the first; of both joints.
    pub is_second: [bool; 2],
}

/// How teeth mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mesh {
    /// Two gears beside each other.
    External,
    /// A gear in a ring.
    Internal,
    /// A pinion on a rack.
    Rack {
        /// Whether the rack goes against the line of its guide when the pinion turns from x towards y.
        is_backward: bool,
    },
}

/// The play of a coupling: contact in place of the relation of both coordinates.
#[derive(Debug, Clone, Copy)]
pub struct CouplingPlay {
    /// Backlash j, m, >= 0; zero makes the coupling ideal. None of a follower that may lift off its cam.
    pub backlash_m: Option<QuantityId>,
    /// Radius on which the angle of the second joint counts as a length, m; none where its coordinate is a length.
    pub second_radius_m: Option<QuantityId>,
    /// The contact between the flanks, or between cam and follower.
    pub contact: ContactId,
}

/// The coordinate of the second joint over that of the first.
#[derive(Debug, Clone)]
pub enum CouplingLaw {
    /// ratio · first + offset.
    Ratio {
        /// Its slope, rad/rad, m/rad, rad/m or m/m.
        ratio: Ratio,
        /// Where the first joint is at zero, rad or m.
        offset: QuantityId,
    },
    /// A periodic cubic spline with dwells: the profile of a cam.
    Cam {
        /// Coordinates of the first joint, increasing, and of the second.
        points: Vec<[QuantityId; 2]>,
        /// Whether the follower rests from a point to the next: their values are equal in the model.
        dwells: Vec<bool>,
    },
}

/// Where a ratio comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ratio {
    /// As given.
    Given(QuantityId),
    /// Size of the first wheel over that of the second, with a sign.
    Wheels {
        /// Pitch radii, m, or numbers of teeth.
        sizes: [QuantityId; 2],
        /// Whether the coordinates of the joints go against each other.
        is_reversed: bool,
    },
    /// Pitch radius of a pinion, m, with a sign.
    Rack {
        /// The radius.
        radius_m: QuantityId,
        /// Whether the coordinates of the joints go against each other.
        is_reversed: bool,
    },
}

impl CouplingLaw {
    /// The quantities that shape it.
    pub fn quantities(&self) -> Vec<QuantityId> {
        let (ratio, offset) = match self {
            Self::Ratio { ratio, offset } => (ratio, offset),
            Self::Cam { points, .. } => return points.iter().flatten().copied().collect(),
        };
        let mut quantities = match *ratio {
            Ratio::Given(id) => vec![id],
            Ratio::Wheels { sizes, .. } => sizes.to_vec(),
            Ratio::Rack { radius_m, .. } => vec![radius_m],
        };
        quantities.push(*offset);
        quantities
    }
}
