//! Pages, tables and files of results.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod coherence;
mod compare;
mod failed_answers;
mod figures;
mod frontier;
mod measured;
mod place_answers;
mod report_answer;
mod report_fixture;
mod report_pages;
mod simulations;
mod space_pages;
mod study_files;
mod sweep;
mod template_pictures;
mod treatments;
