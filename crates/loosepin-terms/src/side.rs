//! Ends of a bound.

use serde::{Deserialize, Serialize};

/// End of a bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The smallest value.
    Lower,
    /// The largest value.
    Upper,
}

impl Side {
    /// Both ends.
    pub const BOTH: [Self; 2] = [Self::Lower, Self::Upper];
}
