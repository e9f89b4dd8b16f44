//! Embedded Runge-Kutta pairs with error control and dense output.
//! They know a right-hand side and tolerances, and nothing of what moves.

mod dop853;
mod dormand_prince;
mod radau;
mod radau_tables;
mod stepper;
mod tableau;
mod tsitouras;

pub use dop853::DOP853;
pub use dormand_prince::DORMAND_PRINCE_5;
pub use radau::{Radau, RadauAttempt};
pub use stepper::{StepRows, Stepper, System};
pub use tableau::{ErrorEstimate, Tableau, TableauRow};
pub use tsitouras::TSITOURAS_5;
