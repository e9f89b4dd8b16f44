//! Ends that no deviation passes, with the loops closed exactly, of mechanisms without redundant rows.
//!
//! The unknowns q are displacements over L and turns of all bodies, counted from the ideal position; v are the variables of play over their radii,
//! so that each of their blocks lies in a ball of radius one. Φ(q, v) = 0 are the loop equations, drives held. Idle freedoms, which take no part
//! in the output, are held by Vᵀq = 0, V the null space of the ideal position: Φ then has as many rows as unknowns.
//!
//! 1. *Positions.* With J = dΦ/dq and K = dΦ/dv over a box Q × balls, and Y near the inverse of J at q = 0, the operator of R. Krawczyk (Computing
//!    4 (1969) 187)
//!
//!    ```text
//!    N = -Y Φ(0, 0) - Y K v + (1 - Y J) Q
//!    ```
//!
//!    lies inside Q only if for every v there is exactly one q in Q that closes the loops. It is then the assembly of the ideal position, since the
//!    balls hang together and J is regular all over Q; that the ideal position is in Q is shown in the same way with v = 0. All q lie in N too.
//! 2. *Derivatives.* With T = dq/dv = -J⁻¹K, and weights w = J⁻ᵀ dy/dq of the rows, over (q, v),
//!
//!    ```text
//!    dy/dv = dy/dq T,   d²y/dv² = H = (T, 1)ᵀ (d²y - Σ w_r d²Φ_r) (T, 1)
//!    ```
//!
//!    as intervals: g at the ideal position, H over the positions with |v| <= s in each ball, for several shares s of the play.
//! 3. *Taylor's formula*, y(v) = y(0) + g·v + v·H̃ v/2 with H̃ = 2 ∫ (1 - s) H(s v) ds over 0 <= s <= 1. Where s is between a and b, H(s v) is in the
//!    intervals of the share b, with the weight (1 - a)² - (1 - b)². The largest value of this quadratic function over the balls is bounded
//!    by weak duality ([`loosepin_math::QuadraticOverBalls`]).
//!
//! To first order the end is the worst case of first order, to second order that of the quadratic function; what is added on top is of third order in
//! the play. Near singular positions step 1 fails, and nothing is proven. Everything from the numbers of the mechanism on is computed on intervals
//! whose ends are rounded outwards.

mod derivatives;
mod linear;
mod loop_box;

use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::enclosure::position_box::BoxCentre;
use crate::output::SpatialOutput;
use core::ops::Range;
use loop_box::LoopBox;
use loosepin_math::{Interval, QuadraticOverBalls, Real};

/// Parts into which the play is divided for the second derivatives.
const SHARES: usize = 3;

/// Ends that no deviation passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProvenEnds {
    /// No deviation is above it, m or rad.
    pub largest: f64,
    /// No deviation is below it.
    pub smallest: f64,
}

impl PoseAccuracy<'_> {
    /// Ends that no deviation of an output passes, over all places of the journals within their play, on the branch of the ideal position, loops closed
    /// exactly, drives held. They are proven, and lie a little outside the extremes of [`Self::worst_case`].
    ///
    /// `None` where nothing is proven: with redundant rows; where the play comes near a second assembly; and for an output that has no deviation
    /// ([`Self::gains`] says why).
    pub fn proven_end(&self, output: &SpatialOutput) -> Option<ProvenEnds> {
        if !self.redundant.is_empty() {
            return None;
        }
        self.gains(output).ok()?;
        let centre = BoxCentre::new(&self.loops, &self.position.poses, self.position.drive_values());
        let boxes = LoopBox::new(self, &centre)?;
        let ideal = boxes.positions(0.0)?;
        let first = boxes.derivatives::<0>(output, &ideal.found, 0.0)?;
        let mut hessian = vec![Interval::ZERO; self.set.variables() * self.set.variables()];
        for step in (1..=SHARES).rev() {
            let positions = boxes.positions(step as f64 / SHARES as f64)?;
            // Of all positions without play in the box, which are one, it must be the ideal one.
            if !ideal.found.iter().zip(&positions.tried).all(|(own, tried)| own.is_inside(*tried)) {
                return None;
            }
            let over = boxes.curvature(output, &positions.found, step as f64 / SHARES as f64)?;
            let weight =
                Interval::from_f64((2 * (SHARES - step) + 1) as f64) / Interval::from_f64((SHARES * SHARES) as f64);
            hessian.iter_mut().zip(over).for_each(|(sum, own)| *sum += weight * own);
        }
        let balls: Vec<Range<usize>> = self.set.blocks().iter().map(|block| block.range()).collect();
        let end = |sign: f64| {
            let sign = Interval::from_f64(sign);
            let [gradient, hessian] =
                [&first.by_play, &hessian].map(|own| own.iter().map(|own| sign * *own).collect::<Vec<_>>());
            let above = QuadraticOverBalls { balls: &balls, gradient: &gradient, hessian: &hessian }.upper_end();
            (sign * first.value + Interval::from_f64(above)).high()
        };
        let [largest, smallest] = [end(1.0), -end(-1.0)];
        (largest.is_finite() && smallest.is_finite()).then_some(ProvenEnds { largest, smallest })
    }
}
