//! Verdicts of `motion` on the requirements of a study without dynamics, in sentences for pages and terminals.

use crate::medium::short_answer::Said;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::limits::limits_words;
use crate::words::wording::{capitalised, deviation_words};
use loosepin_result::motion::{MotionAllowance, MotionRecord, MotionRequirement, MotionVerdict};
use loosepin_text::units::SiUnit;

use super::lean::pins_lean_in_the_plane;
use super::searched::is_together;

/// The headline over all requirements; `None` if there are none.
pub(super) fn verdict_headline(record: &MotionRecord) -> Option<&'static str> {
    let verdicts = || record.requirements.iter().map(|requirement| requirement.verdict);
    if record.requirements.is_empty() {
        return None;
    }
    let has = |verdict: MotionVerdict| verdicts().any(|own| own == verdict);
    Some(if has(MotionVerdict::NotMetInTheWorstCase) {
        "Not all requirements are met in the worst case without dynamics"
    } else if has(MotionVerdict::Undecided) || has(MotionVerdict::NeedsDynamics) {
        "Not all requirements can be decided without dynamics"
    } else {
        "All requirements met without dynamics"
    })
}

/// A sentence or a few for each requirement, and for each input that may be loosened.
pub(super) fn verdicts_said(record: &MotionRecord, writer: &NumberWriter<'_>) -> Vec<Said> {
    let requirements = record.requirements.iter().map(|requirement| requirement_sentence(record, requirement, writer));
    let allowances = record.allowances.iter().map(|allowance| allowance_sentence(allowance, writer));
    let rests_on = record.requirements.iter().any(|requirement| requirement.verdict == MotionVerdict::Met).then(|| {
        let by_study = if record.picture.is_empty() {
            ": `loosepin study` shows how much"
        } else {
            "; in space nothing computes them yet"
        };
        format!("Elastic contacts and bending bodies add to these deviations{by_study}.")
    });
    let is_open =
        |own: &MotionRequirement| matches!(own.verdict, MotionVerdict::Undecided | MotionVerdict::NeedsDynamics);
    let how_decided = record.requirements.iter().any(is_open).then(|| match pins_lean_in_the_plane(record) {
        true => "Runs do not lean: `loosepin study` decides nothing of it.".to_owned(),
        false => "Run `loosepin study` for what is undecided here.".to_owned(),
    });
    let answers = requirements.chain(how_decided).chain(allowances).map(Said::answer);
    answers.chain(rests_on.map(Said::caveat)).collect()
}

fn requirement_sentence(record: &MotionRecord, requirement: &MotionRequirement, writer: &NumberWriter<'_>) -> String {
    let MotionRequirement { output, unit, of, pose_rad, proven_si, found_si, verdict, .. } = requirement;
    let tag = |part: &str| Tag::motion_requirement(requirement, part);
    let place = match pose_rad {
        Some(pose_rad) => {
            format!("at {}", writer.with_tag(&Tag::Given("pose")).value_trimmed(*pose_rad, &SiUnit::ANGLE))
        }
        None => "over the whole cycle".to_owned(),
    };
    let what = format!(
        "{} of {output} {} {place}, in at least {} of the mechanisms",
        deviation_words(*of),
        limits_words(requirement.lower_si, requirement.upper_si, unit, writer),
        writer.with_tag(&Tag::Given("required share")).percent(requirement.probability_at_least, Rounding::Nearest)
    );
    let between = |what: &str, ends: [f64; 2]| {
        let low = writer.with_tag(&tag(&format!("lowest {what}"))).rounded(ends[0], unit, 4, Rounding::Down);
        let high = writer.with_tag(&tag(&format!("highest {what}"))).rounded(ends[1], unit, 4, Rounding::Up);
        format!("{low} to {high}")
    };
    let share = match requirement.share_within_limits {
        1.0 => "This holds for all parts within their stated limits.".to_owned(),
        share => format!(
            "This holds while all parts lie within their stated limits, or ±{1} standard deviations: at least {0} of the mechanisms.",
            writer.with_tag(&tag("share within limits")).percent(share, Rounding::Down),
            writer.with_tag(&Tag::Given("standard deviations")).count(3)
        ),
    };
    let is_proven = proven_si.iter().all(|end| end.is_finite());
    let end = match verdict {
        MotionVerdict::Met => {
            format!(
                "Proven: it stays within {}, at any position within the play. {share}",
                between("proven", *proven_si)
            )
        }
        MotionVerdict::NotMetInTheWorstCase => {
            let beyond = [requirement.lower_si - found_si[0], found_si[1] - requirement.upper_si];
            let side = usize::from(beyond[1] >= beyond[0]);
            // To the nearest digit: it was reached, and is no end.
            let tag = tag(["lowest found", "highest found"][side]);
            // In space searches are made with the parts as they are drawn.
            let of = if is_together(record) { "of play" } else { "of play and parts" };
            let how_often = if pins_lean_in_the_plane(record) { "" } else { " `loosepin study` computes how often." };
            format!(
                "It reaches {} at {} of {}, in the worst case {of}.{how_often}",
                writer.with_tag(&tag).rounded(found_si[side], unit, 4, Rounding::Nearest),
                writer.with_tag(&tag.part("at")).angle_in_turn(requirement.found_at_rad[side], 4),
                record.drive
            )
        }
        MotionVerdict::Undecided => {
            let found = if found_si.iter().all(|end| end.is_finite()) {
                format!("Found: {}; ", between("found", *found_si))
            } else {
                String::new()
            };
            let proven = match &requirement.reason {
                Some(reason) => format!("nothing is proven: {reason}."),
                None if is_proven && requirement.share_within_limits < requirement.probability_at_least => format!(
                    "proven: it stays within {}, but for fewer mechanisms than required. {share}",
                    between("proven", *proven_si)
                ),
                None if is_proven => format!("proven: it stays within {}. {share}", between("proven", *proven_si)),
                None => "nothing is proven.".to_owned(),
            };
            capitalised(&format!("{found}{proven}"))
        }
        MotionVerdict::NeedsDynamics => {
            format!(
                "{}: loosepin study decides.",
                capitalised(requirement.reason.as_deref().unwrap_or("it needs runs"))
            )
        }
    };
    let verdict = match verdict {
        MotionVerdict::Met => "Met without dynamics",
        MotionVerdict::NotMetInTheWorstCase => "Not met in the worst case",
        MotionVerdict::Undecided => "Undecided without dynamics",
        MotionVerdict::NeedsDynamics => "Not judged without dynamics",
    };
    format!("{verdict}: {what}. {end}")
}

fn allowance_sentence(allowance: &MotionAllowance, writer: &NumberWriter<'_>) -> String {
    let MotionAllowance { path, unit, up_to_si, loosest_si, fit, reason } = allowance;
    let up_to = writer.with_tag(&Tag::Given("largest value to try")).value_trimmed(*up_to_si, unit);
    match (reason, loosest_si, fit) {
        (Some(reason), ..) => format!("{path} is not loosened here: {reason}."),
        (None, Some(_), Some(fit)) => {
            format!(
                "{path}: {fit} is the loosest fit with which the requirements are proven to be met without dynamics."
            )
        }
        (None, Some(loosest_si), None) if loosest_si == up_to_si => {
            format!(
                "{path} may increase to {up_to}, the largest value to try; the requirements are proven to be met without dynamics."
            )
        }
        (None, Some(loosest_si), None) => format!(
            "{path} may increase to {} (of at most {up_to}): up to this value, the requirements are proven to be met without dynamics.",
            writer.with_tag(&Tag::joint(path, "loosest", "")).rounded(*loosest_si, unit, 4, Rounding::Down)
        ),
        (None, None, _) => {
            format!("{path}: no value up to {up_to} is proven to meet the requirements without dynamics.")
        }
    }
}
