//! A round pin in a straight slot with round ends.

use super::form::{PlayForm, PlayFreedom};
use loosepin_math::{Real, Vec2, numbers};

/// A straight slot with round ends.
#[derive(Debug, Clone, Copy)]
pub struct SlotShape<T> {
    /// Half-length h from the middle of the slot to the centre of each round end, m.
    pub half_length_m: T,
    /// Radius R_i of the ends, half the width of the slot, m.
    pub end_radius_m: T,
    /// Direction of the slot's line in its body's frame.
    pub line: Vec2<T>,
    /// κ: by what share the round ends are stiffer than the faces; zero where the stiffness is given.
    pub end_stiffening: T,
}

numbers!(struct SlotShape { half_length_m, end_radius_m, line, end_stiffening });

impl<T: Real> PlayForm<T> for SlotShape<T> {
    fn freedom(&self) -> PlayFreedom<T> {
        PlayFreedom::BetweenFaces
    }

    fn thickness_m(&self, clearance_m: T) -> T {
        (self.end_radius_m - clearance_m).max(T::zero())
    }

    fn hole_radius_m(&self) -> Option<T> {
        Some(self.end_radius_m)
    }

    #[inline(always)]
    fn is_round(&self) -> bool {
        true
    }

    #[inline(always)]
    fn directions(&self) -> [Option<Vec2<T>>; 2] {
        [Some(self.line), None]
    }

    fn wall_shares(&self) -> Option<[(&'static str, f64); 2]> {
        let end_stiffening = self.end_stiffening.to_f64();
        (end_stiffening > 0.0).then_some([("at the faces", 1.0), ("in the ends", 1.0 + end_stiffening)])
    }

    fn has_walls(&self) -> bool {
        true
    }
}
