//! Ends that no deviation passes, with the loops closed exactly, of mechanisms without redundant rows.
//!
//! The unknowns q are the steps of all bodies from the ideal position ([`crate::enclosure`]); v are the variables of play over their radii, so
//! that each of their blocks lies in a ball of radius one. F(q, v) = 0 are the loop equations, drives held, and as many rows Vᵀq = 0 as there are
//! idle freedoms, V the null space at the ideal position: idle parts, which do nothing to the output, are held. With Y near the inverse of
//! J = ∂F/∂q and T = -Y ∂F/∂v, both at the ideal position and then exact as they are, write
//!
//! ```text
//! q = T v + z,   u = (q, v),   W = (T, 1)
//! ```
//!
//! 1. *Positions.* Along v = s v₁, 0 <= s <= 1, from the ideal position, and with J̄ the mean of J from T v to q,
//!
//!    ```text
//!    z = -Y F(T v, v) + (1 - Y J̄) z
//!    ```
//!
//!    If |Y F(T v, v)| <= b for all v, |(1 - Y J) z| <= p for all u with |z| <= Z, and b + p < Z in all components, then z does not reach the end
//!    of this box, and Y J is regular all over it, since 1 - Y J makes every z shorter in the norm max |z_k|/Z_k: the position is followed from
//!    the ideal one to every place of the play, and |z| <= b + p. (It is the operator of R. Krawczyk, Computing 4 (1969) 187, in coordinates
//!    that move with v.)
//! 2. *Deviation.* With weights w = Yᵀ ∂y/∂q of the rows L = y - w·F has the value of the output y where the loops are closed, and ∂L/∂q = 0
//!    at the ideal position. By Taylor's formula, derivatives along W,
//!
//!    ```text
//!    L(T v, v) = L(0) + L'·v + v·L'' v/2 + L'''[v, v, v]/6
//!    ```
//!
//!    with L' and L'' at the ideal position and L''' anywhere between it and W v. The largest value of the quadratic function over the balls is
//!    bounded by weak duality ([`loosepin_math::QuadraticOverBalls`]). F(T v, v) is bounded likewise, from second derivatives over parts of the
//!    way: it is v·H̃ v/2 with H̃ = 2 ∫ (1 - s) F''(s W v) ds over 0 <= s <= 1, and where s is between a and b, F'' is in its intervals over
//!    b W v, with the weight (1 - a)² - (1 - b)².
//! 3. *The rest* is at most |∂L/∂q|·|z|, of third order in the play since both factors are small: |∂L/∂q| <= |L''W v| + |L''| Z.
//!
//! The derivatives of Y F and L are multiplied by Y, w and W before they are made absolute: what the play does to all bodies together cancels as
//! it does in truth. To second order in the play the end is exact but for the duality gap. Near singular positions step 1 fails, and nothing is
//! proven. From the numbers of the mechanism on everything is computed on intervals whose ends are rounded outwards.

mod correction;
mod cubic;
mod forms;
mod proof;

use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::enclosure::position_box::BoxCentre;
use crate::output::SpatialOutput;
use proof::Proof;

/// Ends that no deviation passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProvenEnds {
    /// No deviation is above it, m or rad.
    pub largest: f64,
    /// No deviation is below it.
    pub smallest: f64,
}

impl PoseAccuracy<'_> {
    /// Ends that no deviation of an output passes, over all places of the journals within their play, on the branch of the ideal position, loops
    /// closed exactly, drives held. They are proven, and lie a little outside the extremes of [`Self::worst_case`].
    ///
    /// `None` where nothing is proven: with redundant rows; where the play comes near a second assembly; and for an output that has no deviation
    /// ([`Self::gains`] says why).
    pub fn proven_end(&self, output: &SpatialOutput) -> Option<ProvenEnds> {
        if !self.redundant.is_empty() {
            return None;
        }
        self.gains(output).ok()?;
        let centre = BoxCentre::new(&self.loops, &self.position.poses, self.position.drive_values())?;
        let [largest, smallest] = Proof::new(&centre, &self.set, output)?.ends()?;
        (largest.is_finite() && smallest.is_finite()).then_some(ProvenEnds { largest, smallest })
    }
}
