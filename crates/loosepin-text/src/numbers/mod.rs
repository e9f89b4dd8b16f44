//! The numbers of a file as quantities: each with path, unit and rule, given by a number or an expression over parameters; and the reader of
//! them, which every kind of model has. What the numbers measure is known above.

mod parameter;
mod parameters;
mod point_argument;
mod problem;
mod quantity;
mod reader;
mod reads_numbers;
mod unitless;

pub use parameters::Parameters;
pub use point_argument::{NamedPoints, place_in_path_argument, points_of_paths};
pub use problem::EntryProblem;
pub use quantity::{DIAMETRAL, Origin, Quantity, QuantityError, QuantityId, QuantityTable, RADIAL, UNREAD, Values};
pub use reader::{HintOfNeeds, NameTable, NumberReader};
pub use reads_numbers::ReadsNumbers;
