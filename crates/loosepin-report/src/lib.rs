//! Self-contained HTML pages and terminal tables from results. This module only reads; it computes nothing that is not
//! in the result, except how to show it.
//!
//! What a page and a terminal both say is made once, as sections of an article (`loosepin_text::article`); `article_page.rs` and
//! `article_text.rs` show it. Here sentences on results are made:
//!
//! | Sentences on | File |
//! |---|---|
//! | the answer: headline, requirements, numerical error, number of runs; the three treatments | `answer.rs` |
//! | each output: one sentence | `output_summary.rs` |
//! | a study: its bounds, treatments, sensitivity, surrogates, promises, required accuracy; tables and sentences at once | `study_sections`, shown by `study_page` and `study_text.rs` |
//! | the loosest values that meet the requirements; small probabilities | `inverse.rs`; several inputs together: `together.rs` |
//! | two studies beside each other | `compare` |
//! | the band without dynamics while a mechanism is edited | `live_band.rs` |
//! | a run; an ideal motion; a sweep | `simulation`; `motion`; `sweep` |
//! | what readings of a rig, or a motion, say of the plays; what that gains | `identification` |
//! | how a result is made again | `repeat_section.rs` |
//! | histories that no surrogate can learn | `history_words.rs` |
//! | the law behind contact forces, and deep penetrations | `force_words.rs` |
//! | the terms of a page | `glossary.rs` |
//! | one picture or table of a page: what it shows | the file of the picture or table; for a study in `study_page` |
//! | which bounds a witness attains | `witness_words.rs` |
//!
//! Parts of sentences: `wording.rs` (statistic, deviation, place, verdict), `bound_words.rs` (a bound and its error), `number.rs`
//! (digits, units, rounding outwards), `tag.rs` (what a number is, so that no two texts contradict each other).

mod answer;
mod article_page;
mod article_text;
mod axes;
mod bound_words;
mod cases_page;
mod chart;
mod chart_drawing;
mod chart_figure;
mod compare;
mod draft_band;
mod draft_text;
mod error_words;
mod figure;
mod force_words;
mod glossary;
mod history_words;
mod identification;
mod inverse;
mod live_band;
mod mechanism_bends;
mod mechanism_figure;
mod mechanism_labels;
mod mechanism_shapes;
mod mechanism_signs;
mod motion;
mod number;
mod output_summary;
mod page;
mod repeat_section;
mod rounding;
mod script_data;
mod short_answer;
mod simulation;
mod still_figures;
mod study_page;
mod study_sections;
mod study_text;
mod styles;
mod surrogate_figure;
mod sweep;
mod tag;
mod terminal_table;
mod ticks;
mod together;
mod trust_words;
mod turn_words;
mod witness_words;
mod wording;
mod zone_figure;

pub use article_text::article_text;
pub use cases_page::{cases_page, cases_text};
pub use compare::{
    ChangedInput, ComparedBand, ComparedEnd, ComparedRequirement, ComparedSide, ComparedStatistic, Comparison, Weight,
    compare_studies,
};
pub use draft_band::{DraftBand, draft_bands};
pub use draft_text::draft_text;
pub use figure::{Figure, figures};
pub use identification::{identification_gain, identification_page, identification_text, motion_plan_text};
pub use live_band::{BandPart, LiveBand, LiveLimit, live_bands};
pub use mechanism_figure::{Motion, MovingDrawing, mechanism_picture, moving_drawing};
pub use motion::{motion_page, motion_text};
pub use short_answer::{motion_sentences, study_sentences};
pub use simulation::{simulation_page, simulation_text, wear_text};
pub use study_page::{KnownValue, known_values, study_excerpt, study_page};
pub use study_text::study_text;
pub use styles::figure_styles;
pub use sweep::{sweep_page, sweep_text};
pub use tag::{ResultTag, Tag, TaggedNumber, TaggedText, among_cut, among_percentile, tagged};
pub use terminal_table::TERMINAL_COLUMNS;
pub use witness_words::{WitnessWords, witness_words};
pub use wording::verdict_words;
