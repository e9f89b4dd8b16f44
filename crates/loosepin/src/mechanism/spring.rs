//! The numbers of springs with their dampers.

use super::geometry::point_m;
use crate::math::{Real, Vec2};
use crate::model::{Model, Spring, SpringKind, Values};

/// Numbers of a spring: it pulls with P + k (x - x0) + d ẋ, x its length, m, or the angle of the second body from the first,
/// rad.
#[derive(Debug, Clone, Copy)]
pub struct SpringGeometry<T> {
    /// End points in the frames of the first and second body, m; zero for a torsional spring.
    pub arms_m: [Vec2<T>; 2],
    /// Stiffness k, N/m or N m/rad.
    pub stiffness: T,
    /// Free length or angle x0, m or rad.
    pub free: T,
    /// Damping d, N s/m or N m s/rad.
    pub damping: T,
    /// Pull or torque P at the free length or angle, N or N m.
    pub preload: T,
}

impl<T: Real> SpringGeometry<T> {
    /// Lays out `values` for a spring of `model`.
    pub fn new(model: &Model, spring: &Spring, values: &Values) -> Self {
        let number = |id| T::from_f64(values[id]);
        Self {
            arms_m: match spring.kind {
                SpringKind::Linear { first, second } => [first, second].map(|point| point_m(model, values, point)),
                SpringKind::Torsional { .. } => [Vec2::zero(); 2],
            },
            stiffness: number(spring.stiffness),
            free: number(spring.free),
            damping: spring.damping.map_or(T::zero(), number),
            preload: number(spring.preload),
        }
    }

    /// The same numbers in every lane.
    pub fn broadcast(from: &SpringGeometry<f64>) -> Self {
        let number = T::from_f64;
        Self {
            arms_m: from.arms_m.map(Vec2::from_f64),
            stiffness: number(from.stiffness),
            free: number(from.free),
            damping: number(from.damping),
            preload: number(from.preload),
        }
    }

    /// Shows every number.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.arms_m.iter_mut().for_each(|arm| arm.visit(visit));
        visit(&mut self.stiffness);
        visit(&mut self.free);
        visit(&mut self.damping);
        visit(&mut self.preload);
    }

    /// The pull P + k (x - x0) + d ẋ, N or N m, at `extent` x and its `rate` ẋ.
    #[inline(always)]
    pub fn pull(&self, extent: T, rate: T) -> T {
        let elastic = self.stiffness.mul_add(extent - self.free, self.preload);
        self.damping.mul_add(rate, elastic)
    }

    /// Stored energy at `extent`, J: k (x - x0)²/2 + P (x - x0).
    #[inline(always)]
    pub fn stored_energy_j(&self, extent: T) -> T {
        let stretch = extent - self.free;
        stretch * (T::from_f64(0.5) * self.stiffness).mul_add(stretch, self.preload)
    }

    /// Power that the damper turns into heat, W: d ẋ².
    #[inline(always)]
    pub fn damping_loss_w(&self, rate: T) -> T {
        self.damping * rate.squared()
    }
}
