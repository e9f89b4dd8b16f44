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
//! | the band without dynamics while a mechanism is edited; a curve over the cycle; zones of paths | `live_band.rs`; `live_curve.rs`; `live_path.rs` |
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

mod bands;
mod cases_page;
mod charts;
mod compare;
mod identification;
mod mechanism;
mod medium;
mod motion;
mod numbers;
mod simulation;
mod spatial;
mod study;
mod sweep;
mod words;

pub use bands::draft_band::{DraftBand, draft_bands};
pub use bands::draft_text::draft_text;
pub use bands::live_band::{BandPart, LiveBand, LiveLimit, PartKind, live_bands};
pub use bands::live_path::{LivePath, live_paths};
pub use cases_page::{cases_page, cases_text};
pub use charts::figure::{Figure, figures};
pub use compare::{
    ChangedInput, ComparedBand, ComparedEnd, ComparedRequirement, ComparedSide, ComparedStatistic, Comparison,
    InputPlace, Weight, compare_studies,
};
pub use identification::{identification_gain, identification_page, identification_text, motion_plan_text};
pub use mechanism::figure::{Motion, MovingDrawing, mechanism_picture, moving_drawing};
pub use medium::article_text::article_text;
pub use medium::page::{Frame, widget_script};
pub use medium::styles::figure_styles;
pub use medium::terminal_table::TERMINAL_COLUMNS;
pub use motion::{
    CurveChoice, CurveKey, CurveLine, CurveQuantity, LiveCurve, live_curve, live_curves, motion_drawing, motion_page,
    motion_picture, motion_text, short_motion_text,
};
pub use numbers::tag::{ResultTag, Tag, TaggedNumber, TaggedText, degree_group, percentile_group, tagged};
pub use simulation::{
    short_simulation_text, simulation_excerpt, simulation_frame, simulation_page, simulation_text, wear_text,
};
pub use spatial::figure::SpaceDrawing;
pub use study::page::{KnownValue, known_values, study_excerpt, study_frame, study_page};
pub use study::short_answer::{motion_sentences, study_sentences};
pub use study::text::{short_study_text, study_text};
pub use sweep::{sweep_page, sweep_text};
pub use words::witness::{WitnessWords, witness_words};
pub use words::wording::verdict_words;
