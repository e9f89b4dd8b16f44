//! Which way numbers are rounded.

/// Which way a number is rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rounding {
    Nearest,
    /// Towards minus infinity: a lower bound.
    Down,
    /// Towards infinity: an upper bound.
    Up,
}
