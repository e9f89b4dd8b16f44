//! Largest quasi-static effect of play on an output, and the proof of that number, in words.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::listed;
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_text::units::SiUnit;

use super::angles::{largest, shown_angle_rad, turn_angle};

/// The largest effect of play on one output over the cycle.
pub(super) struct PlayEffect {
    /// Angle of the drive.
    pub angle_rad: f64,
    /// The largest magnitude of the deviation.
    pub largest_si: f64,
    pub shown: Shown,
}

/// Proof of [`PlayEffect::largest_si`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shown {
    /// The sum of first-order effects.
    FirstOrder,
    /// Found by a search, with a proven upper limit.
    UpTo(f64),
    /// Found by a search; larger values are not excluded.
    Found,
}

/// The largest effect of play on an output; NaN if there are no positions.
pub(super) fn play_effect(record: &MotionRecord, output: &OutputMotion) -> PlayEffect {
    let answer = &output.clearance;
    if answer.worst_case_si.is_empty() {
        let (angle_rad, largest_si) = largest(record, &answer.first_order_si);
        return PlayEffect { angle_rad, largest_si, shown: Shown::FirstOrder };
    }
    let (angle_rad, largest_si) = largest(record, &answer.worst_case_si);
    let ends = answer.proven_lowest_si.iter().map(|low| -low).chain(answer.proven_highest_si.iter().copied());
    let proven_si = ends.fold(0.0, f64::max);
    let shown = if proven_si.is_finite() { Shown::UpTo(proven_si) } else { Shown::Found };
    PlayEffect { angle_rad, largest_si, shown }
}

impl PlayEffect {
    /// `±0.5503 mm`, rounded up.
    pub fn written(&self, output: &OutputMotion, writer: &NumberWriter<'_>) -> String {
        let tag = Tag::joint(&output.name, "play", "largest");
        format!("±{}", writer.with_tag(&tag).rounded(self.largest_si, &output.unit, PLAIN_DIGITS, Rounding::Up))
    }

    /// The angle of the drive where it is largest.
    pub fn place(
        &self,
        record: &MotionRecord,
        output: &OutputMotion,
        digits: usize,
        writer: &NumberWriter<'_>,
    ) -> String {
        let tag = Tag::joint(&output.name, "play", "at");
        turn_angle(record, self.angle_rad, digits, &writer.with_tag(&tag))
    }

    /// `±0.5504 mm`, the proven end; `None` if nothing is proven.
    pub fn proven(&self, output: &OutputMotion, writer: &NumberWriter<'_>) -> Option<String> {
        let Shown::UpTo(proven_si) = self.shown else { return None };
        let tag = Tag::joint(&output.name, "play", "proven");
        Some(format!("±{}", writer.with_tag(&tag).rounded(proven_si, &output.unit, PLAIN_DIGITS, Rounding::Up)))
    }

    /// `worst case, at 270°; proven: never more than ±0.5504 mm`.
    pub fn words(&self, record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter<'_>) -> String {
        let at = self.place(record, output, 3, writer);
        match (self.shown, self.proven(output, writer)) {
            (Shown::FirstOrder, _) => format!("first order, at {at}"),
            (_, Some(end)) => {
                let between = if record.is_proven_between_angles { "" } else { " at the angles shown" };
                format!("worst case, at {at}; proven: never more than {end}{between}")
            }
            (_, None) => format!("largest found, at {at}; not proven to be the largest"),
        }
    }
}

/// The largest standard deviation of an output if every direction of the contacts is equally likely.
pub(super) fn spread_on_rims(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter<'_>) -> String {
    let (_, spread_si) = largest(record, &output.clearance.rim_standard_deviation_si);
    let tag = Tag::joint(&output.name, "play", "standard deviation on the rims");
    writer.with_tag(&tag).rounded(spread_si, &output.unit, PLAIN_DIGITS, Rounding::Up)
}

/// Spans in which no end of the worst cases is proven, a sentence for each reason.
pub(super) fn unproven_sentences(record: &MotionRecord, writer: &NumberWriter<'_>) -> Vec<String> {
    let mut reasons: Vec<&str> = record.unproven_spans.iter().map(|span| span.words.as_str()).collect();
    reasons.sort_unstable();
    reasons.dedup();
    let sentence = |words: &str| {
        let spans = record.unproven_spans.iter().filter(|span| span.words == words).map(|span| {
            let [from, to] = span.span_rad.map(|angle_rad| {
                let tag = Tag::whole("unproven", &angle_rad.to_string());
                writer.with_tag(&tag).rounded(shown_angle_rad(record, angle_rad), &SiUnit::ANGLE, 3, Rounding::Nearest)
            });
            if from == to { format!("at {from}") } else { format!("from {from} to {to}") }
        });
        let places = listed(&spans.collect::<Vec<_>>());
        format!("Worst cases are the largest found, without a proven end, {places} of {}: {words}.", record.drive)
    };
    reasons.into_iter().map(sentence).collect()
}
