//! Dense algebra of small matrices: each job is done here once, in a fixed order of operations.
//!
//! | Job | Where |
//! |---|---|
//! | products of vectors and matrices | [`dot`], [`multiply`], [`gram`] |
//! | A x = b, A symmetric positive definite: all at once, appended to, row by row, with raised pivots | [`Cholesky`] |
//! | whether A is positive definite, on intervals too, and A x = b then | [`factor_definite`], [`solve_definite`] |
//! | A x = b once, for one or several b; A⁻¹; the determinant | [`solve_square`], [`inverse`], [`determinant`] |
//! | A x = b and Aᵀ x = b later on, for many b | [`RealLu`] |
//! | A x = b on numbers that allow no choice by value: intervals, lanes, what is written down | [`solve_in_order`] |
//! | rank, dependent rows, solutions of rectangular systems | [`Elimination`], [`reduced_echelon`] |
//! | A v = λ v and K v = λ M v, symmetric | [`SymmetricEigen`] |
//!
//! Other algorithms for other matrices stand beside: L D Lᵀ within an envelope on any scalar inside the equations of motion, and of loops with most
//! entries zero (`ldl.rs`); Gram matrices whose rows may repeat each other (`gram.rs`); complex factors with both parts apart, for vectors
//! (`complex_lu.rs`); singular values (`svd.rs`); triangles four rows at a time (`four_rows.rs`); sparse factors with blocks (`loosepin-space`,
//! `closure/sparse_lu.rs`); a triangle within an envelope that is filled cell by cell (`loosepin-mechanics`, `contact/film/ruptured.rs`);
//! matrices with three diagonals (`functions/spline.rs`).

mod cholesky;
mod definite;
mod eigen;
mod elimination;
mod lu;
mod products;
mod rank;
mod triangle;

pub use cholesky::Cholesky;
pub use definite::{factor_definite, solve_definite};
pub use eigen::{Precision, SymmetricEigen};
pub use elimination::{determinant, determinant_sign, inverse, solve_in_order, solve_square};
pub use lu::RealLu;
pub use products::{dot, gram, multiply};
pub use rank::{Elimination, reduced_echelon};
pub use triangle::LowerTriangle;
