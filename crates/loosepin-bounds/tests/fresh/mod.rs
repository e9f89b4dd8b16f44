//! Problems with exact bounds that are drawn afresh from a seed.
//!
//! ```text
//! Y = m(u) + s(u) Z(X; k(u))      or its absolute value
//! ```
//!
//! Z has a known distribution (`law.rs`). m, s and the shape k of Z depend on separate coordinates of u, so (m, s, k) goes to every corner
//! of the box that their extremes make. Each of them is a number plus a sum over groups of coordinates of their own, so its extremes are
//! the sums of those of the groups, and these are exact for the reasons in `group.rs`. Every statistic rises or falls all the way with each
//! of m, s and k where the other two are held (`statistics.rs`), so its extremes are at corners. Where that is not so (P(|Y| > L), |m + s Z|) m
//! and s are continuous, take every pair of values in their rectangle, and the extremes over the rectangle are those of a formula.
//!
//! In some problems of one or two unknown numbers m and s depend on the same ones: the extremes of every statistic, a formula of m and s, are
//! found by brute force.
//!
//! Where brute force would overlook something, the exact bound would be too narrow, and a miss would go uncounted; no miss is counted
//! wrongly. `fresh_problems.rs` samples u against that.
//!
//! A problem is *visible* where every feature that sets an extreme can be seen by runs that are made anyway ([`Problem::is_visible`]).

mod brute;
mod draw;
mod feature;
mod group;
mod law;
mod problem;
mod shapes;
mod statistics;
mod term;

pub use feature::Feature;
pub use problem::Problem;
pub use statistics::Exact;
