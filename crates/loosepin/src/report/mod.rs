//! Self-contained HTML pages and terminal tables from results. This module only reads; it computes nothing that is not
//! in the result, except how to show it.

mod answer;
mod chart;
mod glossary;
mod mechanism_figure;
mod number;
mod page;
mod script_data;
mod still_figures;
mod study_page;
mod wording;

pub use study_page::study_page;
