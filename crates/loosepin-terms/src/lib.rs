//! Terms of an answer. Each is one type from the computation to the file, the page and Python, with the word that names it there.

mod deviation;
#[cfg(test)]
mod drawn;
mod guarantee;
mod purpose;
mod reading;
mod reduction;
mod side;
mod statistic;
mod surrogate_verdict;
mod treatment;

pub use deviation::{Deviation, Reference};
pub use guarantee::Guarantee;
pub use purpose::Purpose;
pub use reading::Reading;
pub use reduction::{Course, CourseEnds, Reduction, ReductionDescription};
pub use side::Side;
pub use statistic::{
    Description, ErrorEffect, Estimation, Event, Form, Mirrored, Number, NumberKind, Statistic, StatisticKind,
    between_order_statistics,
};
pub use surrogate_verdict::SurrogateVerdict;
pub use treatment::Treatment;
