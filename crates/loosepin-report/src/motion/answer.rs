//! The answer of an ideal motion in sentences, the most important first; for pages and terminals alike.

use crate::medium::short_answer::{Said, Weight, words};
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{capitalised, listed};
use loosepin_result::motion::{GuideOverhang, MotionRecord, OutputMotion, PoseEffect, SingularPosition};
use loosepin_text::units::SiUnit;

use super::angles::{asked_place, largest, shown_angle_rad, turn_angle};
use super::kinematic_sentences::kinematic_sentences;
use super::lean::lean_words;
use super::moved::{has_clearance, has_scatter, moved_words};
use super::play_effect::{is_spread_anywhere, play_effect, spread, unproven_sentences};
use super::searched::searched_said;
use super::verdicts::{verdict_headline, verdicts_said};

/// Names of the joints with play.
fn playing_joints(record: &MotionRecord) -> Vec<String> {
    let contributors = record.outputs.first().map_or(&[][..], |output| &output.clearance.contributors);
    let playing = contributors.iter().filter(|contributor| contributor.radial_clearance_m > 0.0);
    playing.map(|contributor| format!("'{}'", contributor.joint)).collect()
}

/// All sentences of the answer.
pub(crate) fn headline_sentences(record: &MotionRecord, writer: &NumberWriter) -> Vec<String> {
    words(all_said(record, writer))
}

/// All paragraphs of the answer, with what each matters to a page: outputs but the first stand in a table.
pub(super) fn all_said(record: &MotionRecord, writer: &NumberWriter) -> Vec<Said> {
    let weight_of = |place: usize| if place == 0 { Weight::Answer } else { Weight::Detail };
    let judged = verdict_headline(record).map(|headline| Said::answer(format!("{headline}.")));
    let mut said: Vec<Said> = judged.into_iter().chain(verdicts_said(record, writer)).collect();
    let outputs = record.outputs.iter().filter(|output| has_clearance(output));
    let of_play: Vec<Said> = outputs
        .enumerate()
        .flat_map(|(place, output)| {
            let effect = play_effect(record, output);
            let likely = match is_spread_anywhere(output) {
                true => "With the journals anywhere in their play, all places alike",
                false => "If every contact direction is equally likely",
            };
            let spread = spread(record, output, writer);
            let spread = spread.map(|spread| format!(" {likely}, the standard deviation is at most {spread}."));
            let words = format!(
                "Play alone moves the {} by up to {} ({}).{}",
                moved_words(output),
                effect.written(output, writer),
                effect.words(record, output, writer),
                spread.unwrap_or_default(),
            );
            let weight = weight_of(place);
            let lean = lean_words(record, output, writer).map(|words| Said { weight, words });
            std::iter::once(Said { weight, words }).chain(searched_said(record, output, weight, writer)).chain(lean)
        })
        .collect();
    if of_play.is_empty() {
        let is_ideal = !record.outputs.iter().any(has_scatter);
        let playing = playing_joints(record);
        said.push(Said::answer(if record.outputs.is_empty() {
            "No output is a position or an angle: no effect of play is shown.".to_owned()
        } else if record.outputs.iter().any(|output| output.clearance.is_forgotten()) {
            format!("What the play of {} does is not known.", listed(&playing))
        } else if !playing.is_empty() {
            format!("The play of {} moves none of the outputs.", listed(&playing))
        } else if is_ideal {
            "No joint has play and no part scatters: the motion is ideal.".to_owned()
        } else {
            "No joint has play.".to_owned()
        }));
    }
    said.extend(of_play);
    for (place, output) in record.outputs.iter().filter(|output| has_scatter(output)).enumerate() {
        let [most, at] = scatter_words(record, output, writer);
        let asked: Vec<String> =
            record.asked_of(&output.name).map(|asked| asked_scatter(output, asked, writer)).collect();
        let asked = if asked.is_empty() { String::new() } else { format!("{}, and ", listed(&asked)) };
        let words = format!(
            "Part scatter moves the {} with a standard deviation of {asked}at most {most} (at {at}).",
            moved_words(output)
        );
        said.push(Said { weight: weight_of(place), words });
    }
    for position in &record.singular_positions {
        let place = singular_place(record, position, writer);
        said.push(Said::caveat(format!("Singular at {place} of {}: {}.", record.drive, position.words)));
    }
    said.extend(unproven_sentences(record, writer).into_iter().map(Said::caveat));
    let overhangs = record.guide_overhangs.iter().map(|overhang| overhang_sentence(record, overhang, writer));
    said.extend(overhangs.map(Said::caveat));
    said.extend(record.remarks.iter().map(|remark| Said::detail(format!("{}.", capitalised(remark)))));
    said.extend(kinematic_sentences(record, writer).into_iter().map(Said::detail));
    said
}

/// `0.0142 mm at 0°, where the requirement is`.
fn asked_scatter(output: &OutputMotion, asked: &PoseEffect, writer: &NumberWriter) -> String {
    let tag = Tag::joint(&output.name, &format!("scatter at {}", asked.pose_rad), "largest");
    let deviation_si = asked.standard_deviation_si;
    let deviation = writer.with_tag(&tag).rounded(deviation_si, &output.unit, PLAIN_DIGITS, Rounding::Up);
    format!("{deviation} {}", asked_place(asked, writer))
}

/// The largest standard deviation of an output by the scatter of the parts, and the angle of the drive there.
pub(super) fn scatter_words(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> [String; 2] {
    let (angle_rad, deviation_si) = largest(record, &output.dimensional_standard_deviation_si);
    let [most, at] = ["largest", "at"].map(|part| Tag::joint(&output.name, "scatter", part));
    [
        writer.with_tag(&most).rounded(deviation_si, &output.unit, PLAIN_DIGITS, Rounding::Up),
        turn_angle(record, angle_rad, 3, &writer.with_tag(&at)),
    ]
}

/// The angle of the drive at which the mechanism is singular.
pub(super) fn singular_place(record: &MotionRecord, position: &SingularPosition, writer: &NumberWriter) -> String {
    let tag = Tag::whole("singular", &position.drive_angle_rad.to_string());
    writer.with_tag(&tag).value_trimmed(shown_angle_rad(record, position.drive_angle_rad), &SiUnit::ANGLE)
}

/// `Joint guide: the block may overhang an end of its guide at 20° to 50° of crank. …`
fn overhang_sentence(record: &MotionRecord, overhang: &GuideOverhang, writer: &NumberWriter) -> String {
    let spans: Vec<String> = overhang
        .spans_rad
        .iter()
        .map(|[from_rad, to_rad]| {
            let [from, to] = [from_rad, to_rad].map(|angle_rad| {
                let tag = Tag::joint(&overhang.joint, "overhang", &angle_rad.to_string());
                writer.with_tag(&tag).value_trimmed(shown_angle_rad(record, *angle_rad), &SiUnit::ANGLE)
            });
            if from == to { from } else { format!("{from} to {to}") }
        })
        .collect();
    format!(
        "Joint {}: the block may overhang an end of its guide at {} of {}. It can tilt further there than the worst case assumes, so \
         that the effect of play may be larger than stated.",
        overhang.joint,
        listed(&spans),
        record.drive
    )
}
