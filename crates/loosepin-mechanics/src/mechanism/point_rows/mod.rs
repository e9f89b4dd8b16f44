//! The rows by which a cut joint keeps its two points together: a file for each form of them, and the list of them here.
//!
//! Nothing else knows a form of [`PointConstraint`] by its name: residuals, Jacobian and biases of the constraints, the force that the joint
//! carries, and what a displacement by play changes go through this module.

mod coincident;
mod form;
mod on_circle;
mod on_line;

use crate::mechanism::tree::cut_geometry::CutGeometry;
use crate::model::PointConstraint;
use coincident::Coincident;
use form::PointRows;
use loosepin_math::{Real, Vec2};
use on_circle::OnCircle;
use on_line::OnLine;

/// Makes the enum of all forms, and hands every question on to the form.
macro_rules! point_rows {
    ($($keeps:ident => $form:ident),* $(,)?) => {
        /// The rows of a cut joint at a state.
        pub enum PointRowsAtState<T> {
            $(#[doc = concat!("Of [`PointConstraint::", stringify!($keeps), "`].")] $keeps($form<T>),)*
        }

        impl<T: Real> PointRowsAtState<T> {
            /// At a state: the angle of the first point's body, rad, and the way from the first point to the second, m, in the ground's frame.
            #[inline(always)]
            pub fn at(keeps: PointConstraint, numbers: &CutGeometry<T>, first_angle_rad: T, gap_m: Vec2<T>) -> Self {
                match keeps { $(PointConstraint::$keeps => Self::$keeps($form::at(numbers, first_angle_rad, gap_m)),)* }
            }

            /// Φ, m; the second entry is zero for a form with one row, here and below.
            #[inline(always)]
            pub fn residuals(&self) -> [T; 2] {
                match self { $(Self::$keeps(form) => form.residuals(),)* }
            }

            /// dΦ for a `velocity` of the second point from the first, where the first body turns by `spin`.
            #[inline(always)]
            pub fn rates(&self, velocity: Vec2<T>, spin: Option<T>) -> [T; 2] {
                match self { $(Self::$keeps(form) => form.rates(velocity, spin),)* }
            }

            /// d²Φ/dt² for velocity and acceleration of the second point from the first, and ω and α of the first body.
            #[inline(always)]
            pub fn biases(
                &self,
                velocity_m_s: Vec2<T>,
                acceleration_m_s2: Vec2<T>,
                spins: [T; 2],
            ) -> [T; 2] {
                match self { $(Self::$keeps(form) => form.biases(velocity_m_s, acceleration_m_s2, spins),)* }
            }

            /// Force on the second body, N: λ times the gradient with respect to the second point.
            #[inline(always)]
            pub fn force_n(&self, multipliers_n: [T; 2]) -> Vec2<T> {
                match self { $(Self::$keeps(form) => form.force_n(multipliers_n),)* }
            }
        }

        /// Displaces the second body of a cut joint from where it is in `centred`, the same numbers without a displacement.
        pub(super) fn displace<T: Real>(
            keeps: PointConstraint,
            numbers: &mut CutGeometry<T>,
            displacement: Vec2<T>,
            centred: &CutGeometry<T>,
        ) {
            match keeps { $(PointConstraint::$keeps => $form::displace(numbers, displacement, centred),)* }
        }
    };
}

point_rows! {
    Points => Coincident,
    Line => OnLine,
    Circle => OnCircle,
}
