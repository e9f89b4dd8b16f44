//! Remaining range of the unknowns by the motion of a specimen, or why nothing explains it.

use super::figures::{RangeRow, map, ranges, strip};
use super::ranges::{BOUND_DIGITS, range, stated};
use super::readings::narrowed_words;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{capitalised, remark};
use loosepin_result::identification::PlayBounds;
use loosepin_result::motion_identification::{ConsistentMembers, MotionFeature, MotionMisfit, MotionSpecimen};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::{SiUnit, counted};
use maud::{Markup, html};

/// Digits of a distance.
const DISTANCE_DIGITS: usize = 2;

/// Appends the unknowns before and after, with the maps that the page does not begin with.
pub(super) fn push_unknowns(section: &mut Section, specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) {
    let features = counted(specimen.features.len(), "feature");
    match &specimen.misfit {
        None => {
            let [consistent, beside] = specimen.share_of_box.map(|share| writer.percent(share, Rounding::Up));
            let head = Text::default()
                .on(Medium::Terminal, format!("{features} of the motion: "))
                .plain(format!("{consistent} of the box is consistent, {beside} with the neighbouring cells."));
            section.push(Content::sentences([head]));
            section.push(Content::Table(unknowns_table(&specimen.unknowns, &specimen.lists, writer)));
        }
        Some(misfit) => {
            let which = if specimen.features.len() == 1 { "the feature".to_owned() } else { format!("all {features}") };
            let heading = format!("MISFIT: no values of the unknowns explain {which} of the motion");
            section.push_on(Medium::Terminal, Content::Heading(heading.into()));
            section.push(Content::points(misfit_words(misfit, &specimen.features, writer).into_iter().map(remark)));
        }
    }
    push_figure(section, writer, || html! { @for map in further_maps(specimen, index, writer) { (map) } });
}

/// Appends how many values were tested with how many runs.
pub(super) fn push_runs(section: &mut Section, specimen: &MotionSpecimen, medium: Medium) {
    let of_unknowns = match medium {
        Medium::Page => "",
        Medium::Terminal => " of the unknowns",
    };
    let mut words = vec![format!(
        "{} values{of_unknowns} were tested with {} each",
        specimen.points.len(),
        counted(specimen.runs_per_point, "run")
    )];
    if specimen.failed > 0 {
        let failed = counted(specimen.failed, "run");
        words.push(format!("{failed} failed: each counts as further away than the measurement"));
    }
    if specimen.is_coarse {
        words.push(
            "the search ended at the limit of points: more points (--points) can narrow the values further".to_owned(),
        );
    }
    let sentences: Vec<String> = words.iter().map(|words| format!("{}.", capitalised(words))).collect();
    section.push_on(Medium::Page, Content::Note(sentences.join(" ").into()));
    section.push_on(Medium::Terminal, Content::points(words));
}

/// Appends the measured features over what is predicted.
pub(super) fn push_features(section: &mut Section, specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) {
    section.push_on(Medium::Terminal, Content::Heading("Features, measured and predicted".into()));
    push_figure(section, writer, || features_figure(&specimen.features, index, writer));
    section.push(Content::Table(features_table(&specimen.features, writer)));
}

/// The map that the page begins with.
pub(super) fn first_map(specimen: &MotionSpecimen, writer: &NumberWriter<'_>) -> Markup {
    match continuous(specimen)[..] {
        [] => Markup::default(),
        [only] => strip(specimen, only, "map.first".to_owned(), writer),
        [across, up, ..] => map(specimen, [across, up], "map.first".to_owned(), writer),
    }
}

/// Places of the unknowns that are no lists.
fn continuous(specimen: &MotionSpecimen) -> Vec<usize> {
    let is_list = |unknown: usize| specimen.lists.iter().any(|list| list.unknown == unknown);
    (0..specimen.unknowns.len()).filter(|unknown| !is_list(*unknown)).collect()
}

/// The maps that the page does not begin with.
fn further_maps(specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) -> Vec<Markup> {
    let places = continuous(specimen);
    if let [only] = places[..] {
        let is_first = index == 0;
        return if is_first { Vec::new() } else { vec![strip(specimen, only, format!("map.{index}"), writer)] };
    }
    let pairs = places.iter().enumerate().flat_map(|(k, a)| places[k + 1..].iter().map(move |b| [*a, *b]));
    // The first one stands below the answer.
    let pairs = pairs.skip(usize::from(index == 0));
    pairs.map(|pair| map(specimen, pair, format!("map.{index}.{}-{}", pair[0], pair[1]), writer)).collect()
}

fn unknowns_table(unknowns: &[PlayBounds], lists: &[ConsistentMembers], writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column::words("unknown"),
        Column::words("before"),
        Column::words("after"),
        Column { only: Some(Medium::Terminal), ..Column::words("narrowed") },
    ];
    let row = |(place, unknown): (usize, &PlayBounds)| {
        if let Some(list) = lists.iter().find(|list| list.unknown == place) {
            let narrowed = match list.before.len() - list.after.len() {
                0 => "no".to_owned(),
                excluded => format!("{excluded} of {} excluded", list.before.len()),
            };
            return vec![unknown.name.clone(), list.before.join(", "), list.after.join(", "), narrowed];
        }
        let before = match writer.medium {
            Medium::Page => stated(unknown.before_si, &unknown.unit, writer),
            Medium::Terminal => range(unknown.before_si, &unknown.unit, writer),
        };
        let after = range(unknown.after_si, &unknown.unit, writer);
        vec![unknown.name.clone(), before, after, narrowed_words(unknown).to_owned()]
    };
    Table::new(columns, unknowns.iter().enumerate().map(row))
}

fn features_figure(features: &[MotionFeature], index: usize, writer: &NumberWriter<'_>) -> Markup {
    let row = |feature: &MotionFeature| RangeRow {
        label: feature.name.clone(),
        unit: feature.unit.clone(),
        before_si: feature.predicted_before_si,
        after_si: feature.predicted_after_si,
        measured_si: Some((feature.measured_si, feature.found_si)),
    };
    let rows: Vec<RangeRow> = features.iter().map(row).collect();
    let alternative = format!("Bars: predicted ranges of {}, and what was measured.", counted(rows.len(), "feature"));
    let caption = html! {
        strong { "Measured over predicted." }
        " Wide bar: smallest to largest of all runs at all tested values; narrow bar: at the consistent ones. Dot: measured value, with the true values that its common error permits. Each row has its own scale."
    };
    ranges(&rows, format!("features.{index}"), (alternative, caption), writer)
}

fn features_table(features: &[MotionFeature], writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column { keeps_words: true, ..Column::words("feature") },
        Column::numbers("measured"),
        Column { only: Some(Medium::Terminal), ..Column::numbers("repeats") },
        Column::words("with its common error"),
        Column::words("predicted before"),
        Column::words("predicted after"),
    ];
    let row = |feature: &MotionFeature| {
        let unit = &feature.unit;
        vec![
            feature.name.clone(),
            writer.rounded(feature.measured_si, unit, BOUND_DIGITS, Rounding::Nearest),
            feature.repeats.to_string(),
            range(feature.found_si, unit, writer),
            range(feature.predicted_before_si, unit, writer),
            feature.predicted_after_si.map_or_else(|| "none".to_owned(), |ends_si| range(ends_si, unit, writer)),
        ]
    };
    Table::new(columns, features.iter().map(row))
}

fn misfit_words(misfit: &MotionMisfit, features: &[MotionFeature], writer: &NumberWriter<'_>) -> Vec<String> {
    let mut words: Vec<String> = misfit
        .culprits
        .iter()
        .map(|culprit| {
            let feature = &features[culprit.feature];
            let side = if culprit.apart_si > 0.0 { "above" } else { "below" };
            format!(
                "'{}' is {}, and no run at any value reaches it: it is {} {side} {}, common error included",
                feature.name,
                writer.rounded(feature.measured_si, &feature.unit, BOUND_DIGITS, Rounding::Nearest),
                writer.rounded(culprit.apart_si.abs(), &feature.unit, DISTANCE_DIGITS, Rounding::Nearest),
                range(feature.predicted_before_si, &feature.unit, writer)
            )
        })
        .collect();
    if misfit.culprits.is_empty() {
        words.push("each feature alone agrees with some runs, but no values explain all features together".to_owned());
    }
    words.push(format!(
        "at the tested values the measurement is at least {} times as far from the runs as the test allows",
        writer.rounded(misfit.least_distance, &SiUnit::NONE, 3, Rounding::Down)
    ));
    words.push(
        "the nearest values are not shown, because they do not explain the motion. Possible reasons: a joint that is ideal in the model has play, friction or another input is outside its interval, or a value is wrong"
            .to_owned(),
    );
    words
}

#[cfg(test)]
mod tests {
    use super::{features_table, unknowns_table};
    use crate::medium::article_text::article_text;
    use crate::numbers::number::NumberWriter;
    use loosepin_result::identification::PlayBounds;
    use loosepin_result::motion_identification::{ConsistentMembers, MotionFeature};
    use loosepin_text::article::{Article, Content, Section, Table};
    use loosepin_text::units::{DisplayUnits, SiUnit};

    /// A table as a terminal shows it.
    fn shown(table: Table) -> String {
        let mut section = Section::default();
        section.push(Content::Table(table));
        article_text(&Article { title: String::new(), sections: vec![section] }, None)
    }

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
        let table = shown(features_table(&[feature("slider_acceleration, maximum absolute")], &writer));
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
        let text = shown(unknowns_table(&[law()], &[list], &NumberWriter::for_terminal(&units)));
        assert!(text.contains("flores, lankarani-nikravesh") && text.contains("1 of 3 excluded"), "{text}");
        assert!(!text.contains("0 to 2"), "{text}");
    }
}
