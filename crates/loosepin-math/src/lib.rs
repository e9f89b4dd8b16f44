//! Numbers that the equations run on: plain, dual (exact derivatives), and small geometry and linear algebra over them.

mod geometry;
pub mod integrate;
mod solve;

mod bracket;
mod dual;
mod functions;
mod fused;
mod numbers;
mod order;
mod outlined;
mod real;
mod scalar;

pub use bracket::Bracket;
pub use dual::Dual;
pub use functions::angle::{KnownAngle, NEAR_RAD, sin_cos, sin_cos_by, sin_cos_near};
pub use functions::arctangent::arctangent;
pub use functions::exponential::{exponential, hyperbolic_tangent, logarithm_above_one, natural_logarithm, power};
pub use functions::exponentials::exponentials;
pub use functions::hermite::Quintic;
pub use functions::interval::{Certainty, Interval};
pub use functions::pieces::Pieces;
pub use functions::quadratic::QuadraticOverBalls;
pub use functions::spline::{
    clamped_spline, cubic_piece, cubic_with_slopes, monotone_slopes, natural_spline, periodic_spline, resting_spline,
};
pub use functions::whole_range::{full_range_exponential, full_range_logarithm, full_range_power};
pub use fused::with_vector_instructions;
pub use geometry::{
    Frame, Geometry, Plane, PlaneMount, PlaneRotation, PlaneSwing, Pose, Quaternion, Rotation, Space, SpaceInertia,
    SpaceMount, SpaceSwing, Vec2, Vec3, Vector,
};
pub use numbers::Numbers;
pub use order::{in_order, number_of_key, order_key, places_in_order, sort_ascending, sort_by_number};
pub use outlined::Outlined;
pub use real::{Real, joined_all};
pub use solve::dense::{
    Elimination, RealLu, determinant, determinant_sign, inverse, reduced_echelon, solve_in_order, solve_square,
};
pub use solve::four_rows::{FourRows, interleaved, pairwise_dots};
pub use solve::gauss::{legendre_coefficient, legendre_rule, orthonormal_values, symmetric_gauss_rule};
pub use solve::gram::GramSystem;
pub use solve::ldl::{Envelope, factor_ldl, solve_ldl, solve_sparse_symmetric};
pub use solve::svd::SingularValues;
pub use solve::{dense, descent};
