//! A motion in space: text for a terminal, page, picture as a file.
//!
//! | Said | File |
//! |---|---|
//! | the answer in sentences | `answer.rs` |
//! | outputs, what each joint contributes | `tables.rs` |
//! | where play reaches a dead centre | `dead_centre.rs` |
//! | what random dimensions do | `scatter.rs` |
//! | worst cases and ideal values over the turn | `charts.rs` |
//! | numbers in the unit of their size | `numbers.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod answer;
mod charts;
mod dead_centre;
mod numbers;
mod page;
mod scatter;
mod tables;
mod text;

pub(crate) use charts::{motion_chart, sorted};
pub(crate) use page::spatial_motion_figure;
pub use page::{spatial_motion_drawing, spatial_motion_page, spatial_motion_picture, spatial_motion_sentences};
pub(crate) use tables::{joints_section, joints_text};
pub use text::spatial_motion_text;

use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_text::article::Medium;

/// The input at a position in words, an angle within its turn.
pub(crate) fn within_turn(record: &SpatialMotionRecord, position: usize) -> String {
    numbers::shown_input(record, position, Medium::Page)
}
