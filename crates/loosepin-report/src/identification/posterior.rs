//! The posterior distribution of an identification.

use super::posterior_figure::density;
use super::ranges::{BOUND_DIGITS, range};
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::remark;
use loosepin_result::identification::PlayBounds;
use loosepin_result::motion_identification::{Marginal, MotionPosterior, MotionSpecimen, Posterior, PosteriorRefusal};
use loosepin_text::article::{Column, Content, Medium, Section, Table};
use loosepin_text::units::SiUnit;
use maud::{Markup, html};

/// Digits of a standard deviation.
const DEVIATION_DIGITS: usize = 3;

/// Appends the probabilities of the values, or why they are not known; appends nothing if they were not asked for.
pub(super) fn push_posterior(
    section: &mut Section,
    specimen: &MotionSpecimen,
    index: usize,
    writer: &NumberWriter<'_>,
) {
    let Some(posterior) = &specimen.posterior else { return };
    section.push_on(Medium::Terminal, Content::Heading("Posterior distribution".into()));
    if let MotionPosterior::Given(given) = posterior {
        push_figure(
            section,
            writer,
            || html! { @for figure in densities(specimen, given, index, writer) { (figure) } },
        );
        section.push(Content::Table(values_table(specimen, given, writer)));
    }
    section.push(Content::points(posterior_words(specimen, posterior, writer).into_iter().map(remark)));
}

/// The density of each unknown that is no list.
fn densities(specimen: &MotionSpecimen, given: &Posterior, index: usize, writer: &NumberWriter<'_>) -> Vec<Markup> {
    let of_unknown = |(place, (unknown, marginal)): (usize, (&PlayBounds, &Marginal))| {
        let name = format!("posterior.{index}.{place}");
        Some(density(unknown, (marginal, marginal.summary.as_ref()?), given.probability, name, writer))
    };
    specimen.unknowns.iter().zip(&given.marginals).enumerate().filter_map(of_unknown).collect()
}

/// A row for each unknown; of a list the probability of each member.
fn values_table(specimen: &MotionSpecimen, posterior: &Posterior, writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column::words("unknown"),
        Column::numbers_on_terminal("mean"),
        Column::numbers_on_terminal("standard deviation"),
        Column::words(format!("{} credible", writer.percent(posterior.probability, Rounding::Nearest))),
    ];
    let row = |(place, unknown): (usize, &PlayBounds)| {
        let marginal = posterior.marginals.get(place);
        let list = specimen.lists.iter().find(|list| list.unknown == place);
        if let (Some(list), Some(marginal)) = (list, marginal) {
            let told =
                |(member, share): (&String, &f64)| format!("{member} {}", writer.percent(*share, Rounding::Nearest));
            let told: Vec<String> = list.before.iter().zip(&marginal.shares).map(told).collect();
            return vec![unknown.name.clone(), String::new(), String::new(), told.join(", ")];
        }
        match marginal.and_then(|marginal| marginal.summary) {
            Some(known) => vec![
                unknown.name.clone(),
                writer.rounded(known.mean_si, &unknown.unit, BOUND_DIGITS, Rounding::Nearest),
                writer.rounded(known.standard_deviation_si, &unknown.unit, DEVIATION_DIGITS, Rounding::Nearest),
                range(known.credible_si, &unknown.unit, writer),
            ],
            None => vec![unknown.name.clone(), String::new(), String::new(), String::new()],
        }
    };
    Table::new(columns, specimen.unknowns.iter().enumerate().map(row))
}

/// Prior, likelihood and number of runs behind a distribution, or why there is none.
fn posterior_words(specimen: &MotionSpecimen, posterior: &MotionPosterior, writer: &NumberWriter<'_>) -> Vec<String> {
    match posterior {
        MotionPosterior::Given(given) => vec![
            "prior: uniform over the intervals of the study, all members of a list equally probable".to_owned(),
            "likelihood: normal, with the mean and the covariance of the runs at each value; common errors uniform within their intervals"
                .to_owned(),
            format!(
                "the weights are equivalent to {} equally probable values, {} runs",
                writer.rounded(given.effective_values, &SiUnit::NONE, 2, Rounding::Down),
                writer.count(given.effective_runs as u64)
            ),
        ],
        MotionPosterior::Refused(refusal) => vec![format!("no posterior distribution: {}", refused(specimen, refusal, writer))],
    }
}

fn refused(specimen: &MotionSpecimen, refusal: &PosteriorRefusal, writer: &NumberWriter<'_>) -> String {
    match refusal {
        PosteriorRefusal::Misfit => "no tested value is consistent with the motion".to_owned(),
        PosteriorRefusal::NothingScatters => {
            "there is no scatter, so no value in the set is more probable than another; give the instrument its scatter"
                .to_owned()
        }
        PosteriorRefusal::FewRuns { runs, least } => {
            format!(
                "one of the values has {runs} finished runs, but this number of features needs {least}; a higher --confidence makes more"
            )
        }
        PosteriorRefusal::Failed { share, most } => format!(
            "{} of the runs with weight failed; at most {} are permitted",
            writer.percent(*share, Rounding::Up),
            writer.percent(*most, Rounding::Nearest)
        ),
        PosteriorRefusal::FewValues { unknown, effective, least, points_are_spent } => {
            let name = specimen.unknowns.get(*unknown).map_or("an unknown", |unknown| unknown.name.as_str());
            let way_out = if *points_are_spent {
                "more --points test additional values there"
            } else {
                "give it a narrower interval around the tested values with the smallest distance, and identify again"
            };
            format!(
                "along {name} the weights are equivalent to {} equally probable values, but {least} are needed; {way_out}",
                writer.rounded(*effective, &SiUnit::NONE, 2, Rounding::Nearest)
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{posterior_words, values_table};
    use crate::numbers::number::NumberWriter;
    use loosepin_result::identification::PlayBounds;
    use loosepin_result::motion_identification::{
        ConsistentMembers, Marginal, MarginalSummary, MotionPosterior, MotionSpecimen, Posterior, PosteriorRefusal,
    };
    use loosepin_text::article::{Cell, Medium, Table};
    use loosepin_text::units::{DisplayUnits, SiUnit};

    fn unknown(name: &str, unit: SiUnit) -> PlayBounds {
        PlayBounds {
            path: name.to_owned(),
            name: name.to_owned(),
            unit,
            before_si: [1e-4, 5e-4],
            after_si: [2e-4, 4e-4],
            is_identifiable: true,
            is_interval: true,
        }
    }

    fn specimen() -> MotionSpecimen {
        MotionSpecimen {
            name: None,
            features: Vec::new(),
            unknowns: vec![unknown("pin play", SiUnit::LENGTH), unknown("pin normal", SiUnit::NONE)],
            lists: vec![ConsistentMembers {
                unknown: 1,
                before: vec!["flores".to_owned(), "hertz".to_owned()],
                after: vec!["flores".to_owned()],
            }],
            share_of_box: [0.5, 0.5],
            grid: vec![2, 2],
            cells: vec![0],
            points: Vec::new(),
            runs_per_point: 199,
            failed: 0,
            is_coarse: false,
            misfit: None,
            posterior: None,
            lengths: None,
        }
    }

    /// The words of a row.
    fn row(table: &Table, place: usize) -> [String; 4] {
        let words = |cell: &Cell| match cell {
            Cell::Text(text) => text.words_on(Medium::Terminal),
            Cell::Drawn { .. } | Cell::Nothing => panic!("{cell:?}"),
        };
        let row: Vec<String> = table.groups[0].rows[place].iter().map(words).collect();
        row.try_into().expect("four columns")
    }

    #[test]
    fn a_distribution_is_told_with_its_prior_its_likelihood_and_its_runs() {
        let given = Posterior {
            probability: 0.99,
            effective_values: 8.67,
            effective_runs: 1725.4,
            marginals: vec![
                Marginal {
                    shares: vec![0.5, 0.5],
                    summary: Some(MarginalSummary {
                        mean_si: 3.0128e-4,
                        standard_deviation_si: 4.21e-5,
                        credible_si: [2.10001e-4, 4.0999e-4],
                    }),
                },
                Marginal { shares: vec![0.8, 0.2], summary: None },
            ],
        };
        let units = DisplayUnits::default();
        let writer = NumberWriter::for_terminal(&units);
        let plain = |text: &str| text.replace('\u{a0}', " ");
        let table = values_table(&specimen(), &given, &writer);
        assert_eq!(plain(&table.columns[3].head.words_on(Medium::Terminal)), "99 % credible");
        // Ends are rounded outwards.
        assert_eq!(
            row(&table, 0).each_ref().map(|cell| plain(cell)),
            ["pin play", "0.3013 mm", "0.0421 mm", "0.2100 mm to 0.4100 mm"]
        );
        assert_eq!(plain(&row(&table, 1)[3]), "flores 80 %, hertz 20 %");
        let words = plain(&posterior_words(&specimen(), &MotionPosterior::Given(given), &writer).join("\n"));
        for part in ["prior: uniform", "likelihood: normal", "equivalent to 8.6 equally probable values, 1725 runs"] {
            assert!(words.contains(part), "{words}");
        }
    }

    #[test]
    fn each_refusal_says_why_and_names_the_unknown() {
        let units = DisplayUnits::default();
        let writer = NumberWriter::for_terminal(&units);
        for (refusal, part) in [
            (PosteriorRefusal::Misfit, "no tested value is consistent"),
            (PosteriorRefusal::NothingScatters, "there is no scatter"),
            (
                PosteriorRefusal::FewRuns { runs: 19, least: 30 },
                "19 finished runs, but this number of features needs 30",
            ),
            (PosteriorRefusal::Failed { share: 0.25, most: 0.05 }, "25 % of the runs with weight failed"),
            (
                PosteriorRefusal::FewValues { unknown: 0, effective: 1.4, least: 4.0, points_are_spent: false },
                "along pin play the weights are equivalent to 1.4 equally probable values, but 4 are needed; give it a narrower interval",
            ),
            (
                PosteriorRefusal::FewValues { unknown: 0, effective: 1.4, least: 4.0, points_are_spent: true },
                "equally probable values, but 4 are needed; more --points test additional values there",
            ),
        ] {
            let words = posterior_words(&specimen(), &MotionPosterior::Refused(refusal), &writer).join("\n");
            assert!(words.replace('\u{a0}', " ").contains(part), "{words}");
        }
    }
}
