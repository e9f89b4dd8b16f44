//! Dual numbers.
