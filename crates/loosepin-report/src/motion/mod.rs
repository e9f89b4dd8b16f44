//! The ideal motion and the quasi-static answer: page and text for a terminal.
//!
//! | Said | File |
//! |---|---|
//! | the answer in sentences | `answer.rs`; how far play goes, and what of that is proven `play_effect.rs`; requirements `verdicts.rs` |
//! | between what the outputs move, and how far play moves them | `ranges.rs` |
//! | what each joint contributes | `contributors.rs` |
//! | the effect of part scatter | `scatter.rs` |
//! | loops, swings, dead centres, transmission angles | `kinematic_sentences.rs` |
//! | paths of points with their zones | `paths.rs` |
//! | what the drives must do | `efforts.rs` |
//! | what was found at single positions | `searched.rs` |
//! | whether play and scatter move an output | `moved.rs` |
//! | the mechanism as it is drawn, in a plane or in space | `drawing.rs` |
//! | on the page alone: charts over the cycle | `charts.rs` |
//! | one of these charts while a mechanism is edited | `live_curve.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod angles;
mod answer;
mod charts;
mod contributors;
mod drawing;
mod efforts;
mod kinematic_sentences;
mod lean;
mod live_curve;
mod moved;
mod page;
mod paths;
mod play_effect;
mod ranges;
mod scatter;
mod searched;
mod text;
mod verdicts;

pub(crate) use angles::{angle_chart, asked_place, turn_angle};
pub(crate) use answer::headline_sentences;
pub(crate) use contributors::{joints_section, joints_text};
pub(crate) use drawing::motion_figure;
pub use drawing::{motion_drawing, motion_picture};
pub use live_curve::{CurveChoice, CurveKey, CurveLine, CurveQuantity, LiveCurve, live_curve, live_curves};
pub(crate) use moved::moved_words;
pub use page::motion_page;
pub use text::{motion_text, short_motion_text};
