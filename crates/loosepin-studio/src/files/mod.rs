//! The served folder: models, studies, results and templates in it, read, listed and written.
//! Nothing outside of it is opened.

pub(crate) mod adopt;
pub(crate) mod blank;
pub(crate) mod drafts;
pub(crate) mod duplicate;
pub(crate) mod folder;
pub(crate) mod gallery;
pub(crate) mod listed;
pub(crate) mod listing;
pub(crate) mod record_head;
pub(crate) mod stored;
pub(crate) mod trash;
pub(crate) mod verdicts;
