//! Springs with their dampers.

use crate::model::ids::{BodyId, PointId};
use crate::model::parts::table_curve::TableCurve;
use loosepin_text::numbers::QuantityId;

/// A spring with its damper between two bodies.
#[derive(Debug, Clone)]
pub struct Spring {
    /// Name in the file.
    pub name: String,
    /// Its kind, with the points or bodies that it connects.
    pub kind: SpringKind,
    /// How it pulls without its damper.
    pub elasticity: Elasticity,
    /// Damping d, N s/m or N m s/rad, >= 0; absent for a spring without damper.
    pub damping: Option<QuantityId>,
}

/// The pull of a spring, N, over its length, m; or its torque, N m, over its angle, rad.
#[derive(Debug, Clone)]
pub enum Elasticity {
    /// P + k (x - x0).
    Linear {
        /// Stiffness k, N/m or N m/rad, >= 0.
        stiffness: QuantityId,
        /// Free length L0, m, >= 0, or free angle θ0, rad.
        free: QuantityId,
        /// Pull P, N, or torque, N m, at the free length or angle.
        preload: QuantityId,
    },
    /// A smooth curve through points, straight beyond both ends.
    Table {
        /// Lengths or angles, increasing, and pulls or torques.
        points: Vec<[QuantityId; 2]>,
        /// How it goes between the points.
        curve: TableCurve,
    },
}

/// The kinds of spring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringKind {
    /// Along the line between two points.
    Linear {
        /// Point of the first body.
        first: PointId,
        /// Point of the second body.
        second: PointId,
    },
    /// Against the angle of the second body from the first.
    Torsional {
        /// The first body.
        first: BodyId,
        /// The second body.
        second: BodyId,
    },
}

impl SpringKind {
    /// The points between which it pulls; `None` of one that turns bodies.
    pub fn points(&self) -> Option<[PointId; 2]> {
        if let Self::Linear { first, second } = *self { Some([first, second]) } else { None }
    }

    /// The two bodies that it connects.
    pub fn bodies(&self) -> [BodyId; 2] {
        match *self {
            Self::Linear { first, second } => [first.body, second.body],
            Self::Torsional { first, second } => [first, second],
        }
    }
}
