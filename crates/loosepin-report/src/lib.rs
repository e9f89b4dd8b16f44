//! Self-contained HTML pages and terminal tables from results. This module only reads; it computes nothing that is not
//! in the result, except how to show it.

mod accuracy_text;
mod answer;
mod axes;
mod bound_words;
mod cases_page;
mod chart;
mod contributors_text;
mod glossary;
mod history_words;
mod inverse;
mod measured_figures;
mod mechanism_figure;
mod mechanism_shapes;
mod motion_kind_section;
mod motion_page;
mod number;
mod page;
mod percentile_words;
mod script_data;
mod section_figure;
mod simulation_page;
mod still_figures;
mod study_page;
mod surrogate_figure;
mod surrogate_text;
mod sweep_page;
mod terminal;
mod terminal_table;
mod wording;

pub use cases_page::{cases_page, cases_text};
pub use mechanism_figure::mechanism_picture;
pub use motion_page::motion_page;
pub use simulation_page::simulation_page;
pub use study_page::{study_excerpt, study_page};
pub use sweep_page::sweep_page;
pub use terminal::{motion_text, simulation_text, study_text, sweep_text};
pub use terminal_table::TERMINAL_COLUMNS;
