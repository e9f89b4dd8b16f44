//! Bands over the cycle before a study is finished, and while a mechanism is edited.
//! The bands of a finished study stand in `study`.

pub(crate) mod draft_band;
pub(crate) mod draft_text;
pub(crate) mod live_band;
pub(crate) mod live_path;
