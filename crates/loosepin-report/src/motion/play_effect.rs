//! Largest quasi-static effect of play on an output, and the proof of that number, in words.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::listed;
use loosepin_result::motion::{ClearanceAnswer, MotionRecord, OutputMotion};

use super::angles::{largest, turn_angle};

/// The largest effect of play on one output over the cycle.
pub(super) struct PlayEffect {
    /// Angle of the drive.
    pub angle_rad: f64,
    /// The largest magnitude of the deviation.
    pub largest_si: f64,
    pub shown: Shown,
}

/// Proof of [`PlayEffect::largest_si`].
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shown {
    /// The sum of first-order effects.
    FirstOrder,
    /// Found by a search, with a proven upper limit.
    UpTo(f64),
    /// Found by a search, with an upper limit that is proven but in these spans of the drive's angle.
    UpToBut(f64, Vec<[f64; 2]>),
    /// Found by a search; larger values are not excluded.
    Found,
}

/// Place and size of the largest first-order sum of an output: where a search was made, if it was at single positions.
pub(super) fn largest_first_order(record: &MotionRecord, output: &OutputMotion) -> (f64, f64) {
    let OutputMotion { clearance: answer, .. } = output;
    let at = |position: usize| Some((*record.drive_angle_rad.get(position)?, *answer.first_order_si.get(position)?));
    let searched = answer.searched.first().and_then(|searched| at(searched.position));
    searched.unwrap_or_else(|| largest(record, &answer.first_order_si))
}

/// The largest effect of play on an output; NaN if there are no positions.
pub(super) fn play_effect(record: &MotionRecord, output: &OutputMotion) -> PlayEffect {
    let answer = &output.clearance;
    if answer.worst_case_si.is_empty() {
        let (angle_rad, largest_si) = largest_first_order(record, output);
        return PlayEffect { angle_rad, largest_si, shown: Shown::FirstOrder };
    }
    let (angle_rad, largest_si) = largest(record, &answer.worst_case_si);
    let ends: Vec<f64> = answer
        .proven_lowest_si
        .iter()
        .zip(&answer.proven_highest_si)
        .map(|(low, high)| f64::max(-low, *high))
        .collect();
    let proven_si = ends.iter().copied().filter(|end| end.is_finite()).reduce(f64::max);
    let shown = match proven_si {
        _ if ends.is_empty() => Shown::UpTo(0.0),
        None => Shown::Found,
        Some(proven_si) => {
            let spans = unproven_spans(record, &ends);
            if spans.is_empty() { Shown::UpTo(proven_si) } else { Shown::UpToBut(proven_si, spans) }
        }
    };
    PlayEffect { angle_rad, largest_si, shown }
}

/// Angles in a row at which `ends` are infinite.
fn unproven_spans(record: &MotionRecord, ends: &[f64]) -> Vec<[f64; 2]> {
    let rows: Vec<(f64, bool)> =
        record.drive_angle_rad.iter().copied().zip(ends.iter().map(|end| end.is_finite())).collect();
    let stretches = rows.chunk_by(|a, b| a.1 == b.1).filter(|stretch| !stretch[0].1);
    stretches.map(|stretch| [stretch[0].0, stretch[stretch.len() - 1].0]).collect()
}

impl PlayEffect {
    /// `±0.5503 mm`, rounded up.
    pub fn written(&self, output: &OutputMotion, writer: &NumberWriter<'_>) -> String {
        let tag = Tag::joint(&output.name, "play", "largest");
        to_both_sides(output, writer.with_tag(&tag).rounded(self.largest_si, &output.unit, PLAIN_DIGITS, Rounding::Up))
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

    /// `±0.5504 mm` or `±0.5504 mm except at 90°`, the proven end; `None` if nothing is proven.
    pub fn proven(&self, record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter<'_>) -> Option<String> {
        let written = |proven_si: f64| {
            let tag = Tag::joint(&output.name, "play", "proven");
            format!("±{}", writer.with_tag(&tag).rounded(proven_si, &output.unit, PLAIN_DIGITS, Rounding::Up))
        };
        match &self.shown {
            Shown::UpTo(proven_si) => Some(written(*proven_si)),
            Shown::UpToBut(proven_si, spans) => {
                Some(format!("{} except {}", written(*proven_si), places_words(record, spans, writer)))
            }
            Shown::FirstOrder | Shown::Found => None,
        }
    }

    /// `worst case, at 270°; proven: never more than ±0.5504 mm`.
    pub fn words(&self, record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter<'_>) -> String {
        let at = self.place(record, output, 3, writer);
        let (through, reaching) = match self.is_through_dead_centre(record) {
            true => ("through a dead centre, ", "where play reaches a dead centre, "),
            false => ("", ""),
        };
        match (&self.shown, self.proven(record, output, writer)) {
            (Shown::FirstOrder, _) => format!("first order, {reaching}at {at}"),
            (shown, Some(end)) => {
                let found = if matches!(shown, Shown::UpTo(_)) { "worst case" } else { "largest found" };
                let between = if record.is_proven_between_angles { "" } else { " at the angles shown" };
                format!("{found}, {through}at {at}; proven: never more than {end}{between}")
            }
            (_, None) => format!("largest found, {through}at {at}; not proven to be the largest"),
        }
    }

    /// Whether it was found where play takes the mechanism to a dead centre, in one of the two assemblies.
    fn is_through_dead_centre(&self, record: &MotionRecord) -> bool {
        let holds = |[from_rad, to_rad]: [f64; 2]| from_rad <= self.angle_rad && self.angle_rad <= to_rad;
        record.unproven_spans.iter().any(|span| span.reaches_dead_centre && holds(span.span_rad))
    }
}

/// A deviation to both sides alike; that of a displacement or a rotation is a size.
pub(super) fn to_both_sides(output: &OutputMotion, number: String) -> String {
    if output.is_size() { number } else { format!("±{number}") }
}

/// The largest standard deviation of an output by play: if every direction of the contacts is equally likely, or where that has no closed form
/// with the journals anywhere in their play. `None` where neither has one.
pub(super) fn spread(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter<'_>) -> Option<String> {
    let ClearanceAnswer { rim_standard_deviation_si, disc_standard_deviation_si, .. } = &output.clearance;
    let ways = [
        (rim_standard_deviation_si, "standard deviation on the rims"),
        (disc_standard_deviation_si, "standard deviation anywhere in the play"),
    ];
    let (values_si, statistic) = ways.into_iter().find(|(values_si, _)| !values_si.is_empty())?;
    let (_, spread_si) = largest(record, values_si);
    let tag = Tag::joint(&output.name, "play", statistic);
    Some(writer.with_tag(&tag).rounded(spread_si, &output.unit, PLAIN_DIGITS, Rounding::Up))
}

/// Whether [`spread`] is that of journals anywhere in their play.
pub(super) fn is_spread_anywhere(output: &OutputMotion) -> bool {
    let answer = &output.clearance;
    answer.rim_standard_deviation_si.is_empty() && !answer.disc_standard_deviation_si.is_empty()
}

/// Spans in which no end of the worst cases is proven, a sentence for each reason.
pub(super) fn unproven_sentences(record: &MotionRecord, writer: &NumberWriter<'_>) -> Vec<String> {
    let mut reasons: Vec<&str> = record.unproven_spans.iter().map(|span| span.words.as_str()).collect();
    reasons.sort_unstable();
    reasons.dedup();
    let sentence = |words: &str| {
        let spans: Vec<[f64; 2]> =
            record.unproven_spans.iter().filter(|span| span.words == words).map(|span| span.span_rad).collect();
        let places = places_words(record, &spans, writer);
        format!("Worst cases are the largest found, without a proven end, {places} of {}: {words}.", record.drive)
    };
    reasons.into_iter().map(sentence).collect()
}

/// `at 0° and from 80.0° to 100°`: spans of the drive's angle, each once where the turn ends at its beginning.
fn places_words(record: &MotionRecord, spans: &[[f64; 2]], writer: &NumberWriter<'_>) -> String {
    let mut places: Vec<String> = Vec::new();
    for span in spans {
        let [from, to] = span.map(|angle_rad| {
            let tag = Tag::whole("unproven", &angle_rad.to_string());
            turn_angle(record, angle_rad, 3, &writer.with_tag(&tag))
        });
        let place = if from == to { format!("at {from}") } else { format!("from {from} to {to}") };
        if !places.contains(&place) {
            places.push(place);
        }
    }
    listed(&places)
}
