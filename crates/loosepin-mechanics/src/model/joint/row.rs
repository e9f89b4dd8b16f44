//! The conditions that ideal joints put on their two bodies. How each is computed stands in `mechanism/row`, a file for each.

use core::fmt::Debug;

/// A condition: one scalar constraint or more.
pub trait Row: Copy + Debug + PartialEq + 'static {
    /// Number of scalar constraints.
    fn count(self) -> usize;
    /// Whether its residual is an angle, or a sine or cosine of one; others are lengths.
    fn is_angle(self) -> bool;
}

/// A condition in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneRow {
    /// The points coincide: x and y.
    Coincident,
    /// The second point stays on a line of the first body.
    OnLine,
    /// The second point stays on a circle about the first.
    OnCircle,
    /// The bodies do not turn against each other.
    Angle,
}

impl Row for PlaneRow {
    #[inline(always)]
    fn count(self) -> usize {
        if self == Self::Coincident { 2 } else { 1 }
    }
    #[inline(always)]
    fn is_angle(self) -> bool {
        self == Self::Angle
    }
}

/// An axis of the marker of a joint in space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkerAxis {
    /// Its x axis.
    X,
    /// Its y axis.
    Y,
    /// Its z axis: the axis of the joint.
    Z,
}

/// A condition in space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpaceRow {
    /// The points coincide: x, y and z.
    Coincident,
    /// An axis of the first marker is at a right angle to one of the second.
    Perpendicular(MarkerAxis, MarkerAxis),
    /// The way from point to point has no part along an axis of the first marker.
    Across(MarkerAxis),
}

impl Row for SpaceRow {
    #[inline(always)]
    fn count(self) -> usize {
        if self == Self::Coincident { 3 } else { 1 }
    }
    #[inline(always)]
    fn is_angle(self) -> bool {
        matches!(self, Self::Perpendicular(..))
    }
}
