//! The answer of an identification from motion for a terminal: what is consistent, or the misfit; and what features would tell.

use super::lengths_text::{LENGTH_HEADS, length_rows, length_words};
use super::number::{NumberWriter, Rounding};
use super::posterior_text::{motion_range, posterior_heads, posterior_rows, posterior_words};
use super::terminal_table::{keep_words, push_table, table, wrapped};
use loosepin_result::identification::PlayBounds;
use loosepin_result::motion_identification::{
    ConsistentMembers, MotionFeature, MotionMisfit, MotionPlan, MotionPosterior, MotionSpecimen, PlannedFeature,
    SpecimenLengths,
};
use loosepin_text::units::{DisplayUnits, SiUnit, counted, listed};

/// Digits of a bound.
const DIGITS: usize = 4;
/// Digits of a share and of a distance.
const SHARE_DIGITS: usize = 2;
/// A feature that leaves more than this share of each unknown tells nothing.
const TELLS_NOTHING: f64 = 0.95;

/// Appends what the motion of a specimen says.
pub(super) fn push_motion(text: &mut String, specimen: &MotionSpecimen, writer: &NumberWriter<'_>) {
    let features = counted(specimen.features.len(), "feature");
    let runs = format!(
        "{} values of the unknowns were tested with {} each",
        specimen.points.len(),
        counted(specimen.runs_per_point, "run")
    );
    let mut sentences = vec![runs];
    match &specimen.misfit {
        None => {
            let share = |share: f64| writer.percent(share, Rounding::Up);
            let head = format!(
                "{features} of the motion: {} of the box is consistent, {} with the cells beside it.",
                share(specimen.share_of_box[0]),
                share(specimen.share_of_box[1])
            );
            text.push_str(&format!("\n{}\n", wrapped(&head, "")));
            push_table(text, &unknowns_table(&specimen.unknowns, &specimen.lists, writer));
        }
        Some(misfit) => {
            let which = if specimen.features.len() == 1 { "the feature".to_owned() } else { format!("all {features}") };
            text.push_str(&format!("\nMISFIT: no values of the unknowns explain {which} of the motion\n\n"));
            for sentence in misfit_words(misfit, &specimen.features, writer) {
                text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
            }
        }
    }
    text.push_str("\nFeatures, measured and predicted\n");
    push_table(text, &features_table(&specimen.features, writer));
    if specimen.failed > 0 {
        let failed = counted(specimen.failed, "run");
        sentences.push(format!("{failed} failed: each counts as if it lay further off than the measurement"));
    }
    if specimen.is_coarse {
        sentences.push("the search ended at its number of points: more of them (--points) narrow further".to_owned());
    }
    text.push('\n');
    for sentence in sentences {
        text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
    }
    if let Some(posterior) = &specimen.posterior {
        push_posterior(text, specimen, posterior, writer);
    }
    if let Some(lengths) = &specimen.lengths {
        push_lengths(text, specimen, lengths, writer);
    }
}

/// Appends the lengths of the specimen, or why they are not told.
fn push_lengths(text: &mut String, specimen: &MotionSpecimen, lengths: &SpecimenLengths, writer: &NumberWriter<'_>) {
    text.push_str("\nLengths of this specimen\n");
    if let SpecimenLengths::Given(rows) = lengths {
        let mut table = table(&LENGTH_HEADS, &[1, 2, 3, 4]);
        for row in length_rows(rows, writer) {
            table.add_row(row.to_vec());
        }
        push_table(text, &table);
    }
    text.push('\n');
    for sentence in length_words(specimen, lengths, writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
    }
}

/// Appends how probable the values are, or why that is not told.
fn push_posterior(
    text: &mut String,
    specimen: &MotionSpecimen,
    posterior: &MotionPosterior,
    writer: &NumberWriter<'_>,
) {
    text.push_str("\nPosterior distribution\n");
    match posterior {
        MotionPosterior::Given(given) => {
            let heads = posterior_heads(given, writer);
            let mut table = table(&heads.each_ref().map(String::as_str), &[1, 2]);
            for row in posterior_rows(specimen, given, writer) {
                table.add_row(row.to_vec());
            }
            push_table(text, &table);
            text.push('\n');
        }
        MotionPosterior::Refused(_) => text.push('\n'),
    }
    for sentence in posterior_words(specimen, posterior, writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
    }
}

fn unknowns_table(
    unknowns: &[PlayBounds],
    lists: &[ConsistentMembers],
    writer: &NumberWriter<'_>,
) -> comfy_table::Table {
    let mut table = table(&["unknown", "before", "after", "narrowed"], &[]);
    for (place, unknown) in unknowns.iter().enumerate() {
        if let Some(list) = lists.iter().find(|list| list.unknown == place) {
            let narrowed = match list.before.len() - list.after.len() {
                0 => "no".to_owned(),
                excluded => format!("{excluded} of {} excluded", list.before.len()),
            };
            table.add_row(vec![unknown.name.clone(), list.before.join(", "), list.after.join(", "), narrowed]);
            continue;
        }
        let narrowed = match unknown.is_narrowed() {
            [true, true] => "both ends",
            [true, false] => "lower end",
            [false, true] => "upper end",
            [false, false] => "no",
        };
        table.add_row(vec![
            unknown.name.clone(),
            motion_range(unknown.before_si, &unknown.unit, writer),
            motion_range(unknown.after_si, &unknown.unit, writer),
            narrowed.to_owned(),
        ]);
    }
    table
}

fn features_table(features: &[MotionFeature], writer: &NumberWriter<'_>) -> comfy_table::Table {
    let head = ["feature", "measured", "repeats", "with its common error", "predicted before", "predicted after"];
    let mut table = table(&head, &[1, 2]);
    for feature in features {
        let unit = &feature.unit;
        table.add_row(vec![
            feature.name.clone(),
            writer.rounded(feature.measured_si, unit, DIGITS, Rounding::Nearest),
            feature.repeats.to_string(),
            motion_range(feature.found_si, unit, writer),
            motion_range(feature.predicted_before_si, unit, writer),
            feature.predicted_after_si.map_or_else(|| "none".to_owned(), |ends_si| motion_range(ends_si, unit, writer)),
        ]);
    }
    keep_words(&mut table, 0);
    table
}

pub(super) fn misfit_words(
    misfit: &MotionMisfit,
    features: &[MotionFeature],
    writer: &NumberWriter<'_>,
) -> Vec<String> {
    let mut words: Vec<String> = misfit
        .culprits
        .iter()
        .map(|culprit| {
            let feature = &features[culprit.feature];
            let side = if culprit.apart_si > 0.0 { "above" } else { "below" };
            format!(
                "'{}' is {}, and no run of any value reaches it: {} {side} {}, its common error included",
                feature.name,
                writer.rounded(feature.measured_si, &feature.unit, DIGITS, Rounding::Nearest),
                writer.rounded(culprit.apart_si.abs(), &feature.unit, SHARE_DIGITS, Rounding::Nearest),
                motion_range(feature.predicted_before_si, &feature.unit, writer)
            )
        })
        .collect();
    if misfit.culprits.is_empty() {
        words.push(
            "each feature by itself is within what some runs predict, but no values explain them together".to_owned(),
        );
    }
    words.push(format!(
        "at the tested values the measurement is at least {} times as far from the runs as the test allows",
        writer.rounded(misfit.least_distance, &SiUnit::NONE, 3, Rounding::Down)
    ));
    words.push(
        "the nearest values are not given: they would explain nothing. A joint that is ideal in the model may have play, friction or \
         another input may lie outside its interval, or a value may be wrong"
            .to_owned(),
    );
    words
}

/// What features would tell, as text.
pub fn motion_plan_text(plan: &MotionPlan, units: &DisplayUnits) -> String {
    let writer = NumberWriter::for_terminal(units);
    let mut text = format!("{}\n\n", plan.study);
    let head = format!(
        "What each feature would leave: mean over measurements that are imagined at {} values of the unknowns, {} runs each.",
        plan.points, plan.runs_per_point
    );
    text.push_str(&format!("{}\n", wrapped(&head, "")));
    let names: Vec<String> = plan.unknowns.iter().map(|unknown| format!("{} left", unknown.name)).collect();
    let head: Vec<&str> = ["feature", "box left"].into_iter().chain(names.iter().map(String::as_str)).collect();
    let numbers: Vec<usize> = (1..head.len()).collect();
    let mut rows = table(&head, &numbers);
    for feature in plan.features.iter().chain([&plan.together]) {
        let shares = std::iter::once(&feature.share_of_box).chain(&feature.shares_of_width);
        let shares = shares.map(|share| writer.percent(*share, Rounding::Up));
        rows.add_row(std::iter::once(feature.name.clone()).chain(shares).collect::<Vec<String>>());
    }
    push_table(&mut text, &rows);
    text.push('\n');
    for sentence in plan_words(plan, &writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
    }
    text
}

pub(super) fn plan_words(plan: &MotionPlan, writer: &NumberWriter<'_>) -> Vec<String> {
    let tells = |feature: &PlannedFeature| feature.share_of_box < TELLS_NOTHING;
    let (telling, silent): (Vec<&PlannedFeature>, Vec<&PlannedFeature>) =
        plan.features.iter().partition(|feature| tells(feature));
    let mut words = Vec::new();
    match telling.first() {
        Some(first) => words.push(format!("most telling alone: {}", first.name)),
        None => words.push("no feature tells anything of the unknowns by itself".to_owned()),
    }
    if !silent.is_empty() && !telling.is_empty() {
        let names: Vec<String> = silent.iter().map(|feature| feature.name.clone()).collect();
        words.push(format!("tells nothing by itself: {}", listed(&names, "and")));
    }
    for (place, unknown) in plan.unknowns.iter().enumerate() {
        let is_open = plan.together.shares_of_width[place] >= TELLS_NOTHING;
        if is_open && !unknown.is_list {
            words.push(format!("not distinguishable: values of {}, with all of these features", unknown.name));
        }
    }
    if plan.failed > 0 {
        words.push(format!(
            "{} of {} imagined measurements have no values, since their run failed, and count in none of the means",
            plan.failed, plan.imagined
        ));
    }
    for alike in &plan.not_distinguishable {
        words.push(format!(
            "not distinguishable: where {} is {}, {} is told to be wrong in {} of the measurements",
            plan.unknowns[alike.unknown].name,
            alike.members[0],
            alike.members[1],
            writer.percent(alike.told, Rounding::Up)
        ));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::{features_table, motion_plan_text, unknowns_table};
    use crate::number::NumberWriter;
    use loosepin_result::identification::PlayBounds;
    use loosepin_result::motion_identification::{
        AlikeMembers, ConsistentMembers, MotionFeature, MotionPlan, PlannedFeature, PlannedUnknown,
    };
    use loosepin_text::units::{DisplayUnits, SiUnit};

    fn law() -> PlayBounds {
        PlayBounds {
            path: "contact.pin.normal".to_owned(),
            name: "pin normal".to_owned(),
            unit: SiUnit::NONE,
            before_si: [0.0, 2.0],
            after_si: [0.0, 2.0],
            is_identifiable: false,
            is_interval: false,
        }
    }

    #[test]
    fn no_name_of_a_feature_is_cut() {
        let feature = |name: &str| MotionFeature {
            name: name.to_owned(),
            unit: SiUnit::LENGTH,
            measured_si: 189.805,
            repeats: 1,
            found_si: [180.766, 199.795],
            predicted_before_si: [36.1234, 456.789],
            predicted_after_si: Some([123.456, 234.567]),
        };
        let units = DisplayUnits::default();
        let writer = NumberWriter::for_terminal(&units);
        let table = features_table(&[feature("slider_acceleration, maximum absolute")], &writer).to_string();
        for word in ["slider_acceleration,", "maximum", "absolute"] {
            assert!(table.contains(word), "{word}\n{table}");
        }
        assert!(table.lines().all(|line| line.trim_end().chars().count() <= 100), "{table}");
    }

    #[test]
    fn laws_are_named() {
        let units = DisplayUnits::default();
        let names = ["flores", "hunt-crossley", "lankarani-nikravesh"].map(str::to_owned);
        let list =
            ConsistentMembers { unknown: 0, before: names.to_vec(), after: vec![names[0].clone(), names[2].clone()] };
        let text = unknowns_table(&[law()], &[list], &NumberWriter::for_terminal(&units)).to_string();
        assert!(text.contains("flores, lankarani-nikravesh") && text.contains("1 of 3 excluded"), "{text}");
        assert!(!text.contains("0 to 2"), "{text}");
    }

    #[test]
    fn a_plan_names_laws_and_says_how_many_measurements_are_missing() {
        let feature = PlannedFeature { name: "peak".to_owned(), share_of_box: 0.5, shares_of_width: vec![0.5] };
        let plan = MotionPlan {
            study: "laws".to_owned(),
            unknowns: vec![PlannedUnknown {
                path: "contact.pin.normal".to_owned(),
                name: "pin normal".to_owned(),
                is_list: true,
            }],
            features: vec![feature.clone()],
            together: feature,
            not_distinguishable: vec![AlikeMembers {
                unknown: 0,
                members: ["flores".to_owned(), "hunt-crossley".to_owned()],
                told: 0.25,
            }],
            points: 2,
            imagined: 8,
            failed: 3,
            runs_per_point: 199,
        };
        let text = motion_plan_text(&plan, &DisplayUnits::default());
        let flat = text.split_whitespace().collect::<Vec<&str>>().join(" ");
        assert!(flat.contains("where pin normal is flores, hunt-crossley is told to be wrong in 25"), "{text}");
        assert!(flat.contains("3 of 8 imagined measurements have no values"), "{text}");
    }
}
