//! A motion in space: text for a terminal, page, picture as a file.
//!
//! | Said | File |
//! |---|---|
//! | the answer in sentences | `answer.rs` |
//! | outputs, what each joint contributes | `tables.rs` |
//! | worst cases and ideal values over the turn | `charts.rs` |
//! | numbers in the unit of their size | `numbers.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod answer;
mod charts;
mod numbers;
mod page;
mod tables;
mod text;

pub(crate) use page::spatial_motion_figure;
pub use page::{spatial_motion_page, spatial_motion_picture};
pub(crate) use tables::{joints_section, joints_text};
pub use text::spatial_motion_text;
