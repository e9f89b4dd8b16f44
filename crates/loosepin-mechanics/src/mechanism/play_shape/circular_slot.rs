//! A round pin in a slot along a circle.

use super::form::{PlayForm, PlayFreedom};
use loosepin_math::{Real, numbers};

/// A slot along a circle.
#[derive(Debug, Clone, Copy)]
pub struct CircularSlotShape<T> {
    /// Radius R of the middle of the slot, m.
    pub radius_m: T,
    /// Half its width b, m.
    pub half_width_m: T,
    /// Stiffness at the inner flank over that at the outer one, which is the law's; one where the stiffness is given.
    pub inner_share: T,
}

numbers!(struct CircularSlotShape { radius_m, half_width_m, inner_share });

impl<T: Real> PlayForm<T> for CircularSlotShape<T> {
    fn freedom(&self) -> PlayFreedom<T> {
        PlayFreedom::BetweenFaces
    }

    fn thickness_m(&self, clearance_m: T) -> T {
        (self.half_width_m - clearance_m).max(T::zero())
    }

    fn hole_radius_m(&self) -> Option<T> {
        Some(self.half_width_m)
    }

    fn wall_shares(&self) -> Option<[(&'static str, f64); 2]> {
        let inner_share = self.inner_share.to_f64();
        (inner_share < 1.0).then_some([("at the outer flank", 1.0), ("at the inner one", inner_share)])
    }
}

/// Radii of the spheres whose contact with a plane is as stiff as the pin at the outer and the inner flank, m: with the pin's radius
/// R_j = b - c, R_j (R + b)/(R + c) in the hollow flank and R_j (R - b)/(R - c) on the other.
pub fn flank_radii_m(radius_m: f64, half_width_m: f64, clearance_m: f64) -> [f64; 2] {
    let pin_radius_m = half_width_m - clearance_m;
    [1.0, -1.0].map(|side| pin_radius_m * (radius_m + side * half_width_m) / (radius_m + side * clearance_m))
}
