//! Sentences that several sections share, each made once.
//! Sections of one kind of result stand in the folder of that result.

pub(crate) mod bound;
pub(crate) mod error;
pub(crate) mod failed;
pub(crate) mod few_samples;
pub(crate) mod force;
pub(crate) mod glossary;
pub(crate) mod history;
pub(crate) mod limits;
pub(crate) mod round_off;
pub(crate) mod trust;
pub(crate) mod turn;
pub(crate) mod witness;
pub(crate) mod wording;
