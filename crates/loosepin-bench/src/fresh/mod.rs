//! Problems with exact bounds that are drawn afresh from a seed.
//!
//! ```text
//! Y = m(u) + s(u) Z(X)
//! ```
//!
//! Z has a known distribution (`law.rs`), m and s depend on separate coordinates of u, and each is a sum over groups of coordinates
//! (`group.rs`). So (m, s) fills a rectangle's corners, whose ends are sums of the ends of the groups.

mod brute;
pub mod draw;
pub mod group;
pub mod law;
pub mod problem;
mod shapes;
pub mod term;

pub use problem::{Exact, Problem};
