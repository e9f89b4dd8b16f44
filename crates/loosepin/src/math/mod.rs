//! Numbers that the equations run on: plain, dual (exact derivatives), and small linear algebra over them.

pub mod real;

pub use real::Real;
