//! The result of a study: its answer in sentences, its sections, its page and its text.
//! It computes nothing that is not in the result.

pub(crate) mod answer;
pub(crate) mod inverse;
pub(crate) mod output_summary;
pub(crate) mod page;
pub(crate) mod place_sentence;
pub(crate) mod repeat_section;
pub(crate) mod sections;
pub(crate) mod short_answer;
mod subject;
pub(crate) mod text;
pub(crate) mod together;
mod way_to_decide;
