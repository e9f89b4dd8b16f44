//! Numbers that the equations run on: plain, dual (exact derivatives), and small geometry and linear algebra over them.

pub mod integrate;

mod angle;
mod arctangent;
mod complex_lu;
pub mod dense;
pub mod descent;
mod dual;
mod exponential;
mod exponentials;
mod four_rows;
mod fused;
mod gauss;
mod gram;
mod hermite;
mod interval;
mod ldl;
mod linear;
mod numbers;
mod pieces;
mod real;
mod real_lu;
mod scalar;
mod spline;
mod vector;
mod whole_range;

pub use angle::{KnownAngle, NEAR_RAD, sin_cos, sin_cos_near};
pub use arctangent::arctangent;
pub use dual::Dual;
pub use exponential::{exponential, hyperbolic_tangent, logarithm_above_one, natural_logarithm, power};
pub use exponentials::exponentials;
pub use four_rows::{FourRows, beside_one_another, dots_of_each};
pub use fused::on_vectors;
pub use gauss::{legendre_coefficient, legendre_rule, orthonormal_values, symmetric_gauss_rule};
pub use gram::GramSystem;
pub use hermite::Quintic;
pub use interval::{Certainty, Interval};
pub use ldl::{Envelope, factor_ldl, solve_ldl, solve_sparse_symmetric};
pub use linear::{Elimination, determinant, determinant_sign, solve_square};
pub use numbers::Numbers;
pub use pieces::Pieces;
pub use real::Real;
pub use spline::{
    clamped_spline, cubic_piece, cubic_with_slopes, monotone_slopes, natural_spline, periodic_spline, resting_spline,
};
pub use vector::Vec2;
pub use whole_range::{any_exponential, any_logarithm, any_power};
