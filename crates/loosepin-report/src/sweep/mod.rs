//! A sweep: its page and its text for a terminal.
//!
//! | Said | File |
//! |---|---|
//! | the answer in sentences | `answer.rs` |
//! | which kind of motion there is where | `stretches.rs`; its dots on the page `section_figure.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod answer;
mod page;
mod section_figure;
mod stretches;
mod text;

pub use page::sweep_page;
pub use text::sweep_text;
