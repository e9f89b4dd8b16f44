//! How the size of a load, or what a control feeds forward, changes.

use crate::model::parts::load_table::LoadTable;
use crate::model::values::function::Function;
use loosepin_text::numbers::QuantityId;

/// How something changes with time.
#[derive(Debug, Clone)]
pub enum TimeCourse {
    /// Not at all.
    Constant(QuantityId),
    /// mean + amplitude sin(2π frequency t + phase).
    Harmonic {
        /// Its middle.
        mean: QuantityId,
        /// Largest departure from the middle.
        amplitude: QuantityId,
        /// Oscillations in a second, 1/s, > 0.
        frequency: QuantityId,
        /// At time zero, rad.
        phase_rad: QuantityId,
    },
    /// By a function of the time, then of the coordinate and the rate of a joint where the load names one.
    Function(Function),
    /// By points.
    Table(LoadTable),
}
