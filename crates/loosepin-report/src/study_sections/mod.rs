//! The sections that a page and a terminal show of a study, each made once.

mod accuracy;
mod allowed;
mod answers;
mod bounds;
mod columns;
mod contributors;
mod promise;
mod runs;
mod surrogate;
mod surrogate_words;
mod treatments;

pub(super) use accuracy::accuracy_section;
pub(super) use allowed::{allowed_section, rare_section};
pub(super) use answers::answers_section;
pub(super) use bounds::bounds_section;
pub(super) use columns::{degrees_section, percentiles_section};
pub(super) use contributors::contributors_section;
pub(super) use promise::promise_section;
pub(super) use runs::{double_loop_words, runs_section};
pub(super) use surrogate::surrogate_section;
pub(super) use treatments::treatments_section;
