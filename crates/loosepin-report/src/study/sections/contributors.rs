//! Contributors: how much narrower the band becomes by a tighter tolerance or a better measurement; one chart in two colours.

use maud::{Markup, html};

use crate::charts::still_figures::percent_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::output_summary::output_summaries;
use crate::study::sections::bounds::answer_bound;
use crate::words::wording::{capitalised, counted, listed, response_words};
use loosepin_result::study::{
    Contributors, EpistemicContributor, RandomContributor, ResponsePoint, ShareRange, StudyResult,
};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};

/// Inputs that [`contributors_overview`] and [`contributors_excerpt`] show.
const MAX_SHOWN: usize = 6;
/// Inputs that make the band less narrow than this are left out of the excerpt.
const LEAST_SHOWN: f64 = 0.015;

/// The inputs that make the band of the first answer wide, the widest first: one line each. `None` if none is known.
pub(crate) fn contributors_overview(result: &StudyResult, writer: &NumberWriter) -> Option<Markup> {
    let one = of_first_answer(result)?;
    let name = |path: &String| plain_name(path, &result.inputs);
    let random = one.random.iter().map(|input| {
        let name = listed(&input.paths.iter().map(name).collect::<Vec<String>>());
        let tag = Tag::contributors(one, "band", &input.paths.join(" "));
        (name, "probability", "tighter tolerance", [input.band_share; 2], tag)
    });
    let of_unknown = |input: &EpistemicContributor| {
        let tag = Tag::contributors(one, "band", &input.path);
        (unknown_name(input, result), "mixed", unknown_means(input), input.band_share, tag)
    };
    let measurable = one.epistemic.iter().filter(|input| input.can_be_measured).map(of_unknown);
    let mut all: Vec<_> = random.chain(measurable).collect();
    all.sort_by(|a, b| b.3[1].total_cmp(&a.3[1]));
    // What somebody can do something about comes first.
    all.extend(one.epistemic.iter().filter(|input| !input.can_be_measured).map(of_unknown));
    all.retain(|(_, _, _, share, _)| share[1].is_finite());
    let left = all.len().saturating_sub(MAX_SHOWN);
    let has_estimates = one.random.iter().any(RandomContributor::is_linear_estimate);
    (!all.is_empty()).then(|| {
        html! {
            section.contributors id="contributors-overview" aria-labelledby="contributors-overview-title" {
                h2 id="contributors-overview-title" { "What makes the band wide" }
                table.lines {
                    thead { tr { th scope="col" { "Input" } th scope="col" { "Reduced by" } th scope="col" { "Band narrower by" } } }
                    tbody {
                        @for (name, colour, means, share, tag) in all.into_iter().take(MAX_SHOWN) {
                            tr {
                                th scope="row" { (name) }
                                td.means { (means) }
                                td { (bar_markup(colour, share, &writer.with_tag(&tag)).0) }
                            }
                        }
                    }
                }
                p.quiet {
                    (capitalised(&response_words(result, (&one.output, one.of, one.at), writer))) ": the band of "
                    (band_probability(writer)) " of mechanisms. "
                    @if has_estimates { "Shares of tolerances are estimates by linear scatter without play. " }
                    @if left > 0 { "Inputs with smaller shares: " a href="#contributors" { "Sensitivity" } "." }
                    @else { "Details: " a href="#contributors" { "Sensitivity" } "." }
                }
            }
        }
    })
}

/// The contributors to the band of the first answer.
fn of_first_answer(result: &StudyResult) -> Option<&Contributors> {
    let first = output_summaries(result);
    let of_first = |one: &&Contributors| first.first().is_some_and(|summary| summary.output() == one.output);
    result.contributors.iter().find(of_first).or(result.contributors.first())
}

/// "To narrow the band: measure gudgeon radial clearance (by 81 % to 84 %); tighten rod length (11 %)." The measurement and the tolerance
/// that do most, for a terminal; `None` where neither does anything.
pub(crate) fn what_narrows(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    /// Less is nothing in whole percents.
    const LEAST_SHARE: f64 = 0.005;
    let one = of_first_answer(result)?;
    let name = |path: &String| plain_name(path, &result.inputs);
    let random = one.random.iter().map(|input| {
        let names = listed(&input.paths.iter().map(name).collect::<Vec<String>>());
        (format!("tighten {names}"), [input.band_share; 2], Tag::contributors(one, "band", &input.paths.join(" ")))
    });
    let measurable = one.epistemic.iter().filter(|input| input.can_be_measured).map(|input| {
        (format!("measure {}", name(&input.path)), input.band_share, Tag::contributors(one, "band", &input.path))
    });
    let largest = |means: &mut dyn Iterator<Item = (String, [f64; 2], Tag)>| {
        let known = means.filter(|(_, share, _)| share[0].is_finite() && share[1] >= LEAST_SHARE);
        known.max_by(|a, b| a.1[1].total_cmp(&b.1[1]))
    };
    let mut means: Vec<_> = [largest(&mut { measurable }), largest(&mut { random })].into_iter().flatten().collect();
    means.sort_by(|a, b| b.1[1].total_cmp(&a.1[1]));
    let told = means.into_iter().enumerate().filter_map(|(place, (what, share, tag))| {
        let share = band_share(share, &writer.with_tag(&tag))?;
        Some(format!("{what} ({}{share})", if place == 0 { "by " } else { "" }))
    });
    let told: Vec<String> = told.collect();
    (!told.is_empty())
        .then(|| Section::of_sentences("what-to-do", [format!("To narrow the band: {}.", told.join("; "))]))
}

/// The contributors to the band of the first answer, for a terminal; `None` if none is known.
pub(crate) fn contributors_excerpt(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let one = of_first_answer(result).filter(|one| one.band_width_si.is_finite())?;
    let mut section = Section::new("contributors", sensitivity_heading(one, writer));
    let mut table = table(result, one, writer);
    let random = one.random.iter().map(|input| input.band_share);
    let shares: Vec<f64> = random.chain(one.epistemic.iter().map(|input| input.band_share[1])).collect();
    let mut order: Vec<usize> = (0..shares.len()).filter(|place| shares[*place] >= LEAST_SHOWN).collect();
    order.sort_by(|a, b| shares[*b].total_cmp(&shares[*a]));
    order.truncate(MAX_SHOWN);
    for group in &mut table.groups {
        group.rows = order.iter().filter_map(|place| group.rows.get(*place).cloned()).collect();
    }
    let title = std::mem::take(&mut table.title);
    let is_of_answer =
        answer_bound(result).is_some_and(|first| (&first.output, first.of, first.at) == (&one.output, one.of, one.at));
    // The bounds above it have the same subject.
    if !is_of_answer {
        section.push_close(Content::Sentences(vec![title]));
    }
    section.push_close(Content::Table(table));
    (!order.is_empty()).then_some(section)
}

fn sensitivity_heading(one: &Contributors, writer: &NumberWriter) -> String {
    let band = band_probability(writer);
    match one.band_width_si.is_finite() {
        true => format!("Sensitivity: how much narrower the {band} band becomes without one input"),
        false => format!("Sensitivity: the {band} band has no known width, so no share of it is known"),
    }
}

/// `None` if no question has contributors.
pub(crate) fn contributors_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    if result.contributors.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("contributors", "Sensitivity");
    push_figure(&mut section, writer, || legend(writer));
    for one in &result.contributors {
        section.push_on(Medium::Terminal, Content::Heading(sensitivity_heading(one, writer).into()));
        section.push(Content::Table(table(result, one, writer)));
    }
    Some(section)
}

/// What the bars are, with their colours.
fn legend(writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Each bar shows how much narrower the band of " (band_probability(writer)) " of mechanisms becomes without the uncertainty of one input: "
            span class="swatch probability line" {} " " strong { "tighter tolerance" } " (a random input without scatter) or "
            span class="swatch mixed line" {} " " strong { "better measurement" } " (an unknown value that is measured)."
        }
    }
}

fn table(result: &StudyResult, one: &Contributors, writer: &NumberWriter) -> Table {
    let name = |path: &String| plain_name(path, &result.inputs);
    let tag = |part: &str, paths: &[String]| Tag::contributors(one, part, &paths.join(" "));
    let random = one.random.iter().map(|input| {
        vec![
            listed(&input.paths.iter().map(name).collect::<Vec<String>>()).into(),
            "tolerance".into(),
            bar("probability", [input.band_share; 2], &writer.with_tag(&tag("band", &input.paths))),
            share(&input.first, &writer.with_tag(&tag("first", &input.paths))).into(),
            share(&input.total, &writer.with_tag(&tag("total", &input.paths))).into(),
            known(input.quasi_static_share, &writer.with_tag(&tag("quasi-static", &input.paths))).into(),
        ]
    });
    let epistemic = one.epistemic.iter().map(|input| {
        let tag = |part: &str| Tag::contributors(one, part, &input.path);
        vec![
            unknown_name(input, result).into(),
            unknown_means(input).into(),
            bar("mixed", input.band_share, &writer.with_tag(&tag("band"))),
            Cell::Nothing,
            Cell::Nothing,
            known(input.quasi_static_share, &writer.with_tag(&tag("quasi-static"))).into(),
        ]
    });
    let columns = vec![
        Column::words(Text::by_medium("Input", "input")),
        Column { only: Some(Medium::Terminal), ..Column::words("by") },
        Column::numbers_on_terminal(Text::by_medium("Band narrower by", "band narrower by")),
        Column::numbers(Text::by_medium("Sobol' index, first order", "Sobol' first")),
        Column::numbers(Text::by_medium("Sobol' index, total", "Sobol' total")),
        Column::numbers(Text::by_medium("Quasi-static share", "quasi-static")),
    ];
    // Without runs of their own there are no indices.
    let has_indices = |place: usize| !one.points.is_empty() || !matches!(place, 3 | 4);
    let shown = |row: Vec<Cell>| -> Vec<Cell> {
        row.into_iter().enumerate().filter(|(place, _)| has_indices(*place)).map(|(_, cell)| cell).collect()
    };
    let columns: Vec<Column> =
        columns.into_iter().enumerate().filter(|(place, _)| has_indices(*place)).map(|(_, column)| column).collect();
    let rows: Vec<Vec<Cell>> = random.chain(epistemic).map(shown).collect();
    Table {
        title: response_words(result, (&one.output, one.of, one.at), writer).into(),
        caption: caption(result, one, writer).into(),
        ..Table::new(columns, rows)
    }
}

/// Name of an unknown input.
fn unknown_name(input: &EpistemicContributor, result: &StudyResult) -> String {
    if input.can_be_measured { plain_name(&input.path, &result.inputs) } else { "where the pins sit".to_owned() }
}

/// What makes the band narrower.
fn unknown_means(input: &EpistemicContributor) -> &'static str {
    if input.can_be_measured { "measurement" } else { "not measurable" }
}

/// Meaning and error of the numbers.
fn caption(result: &StudyResult, one: &Contributors, writer: &NumberWriter) -> String {
    let name = |path: &String| plain_name(path, &result.inputs);
    let error = one.epistemic.iter().map(|input| input.error).fold(0.0, f64::max);
    let mut caption = format!(
        "The band is {} wide{}, without its error. For an unknown value, the reduction depends on the measured value: the bar goes from the smallest to \
         the largest. It is computed from the existing runs, with an error of {}.",
        writer.with_tag(&Tag::contributors(one, "band width", "")).value(one.band_width_si, &one.unit),
        if one.at == ResponsePoint::Whole { " on average over the poses" } else { "" },
        writer.with_tag(&Tag::contributors(one, "error", "")).percent(error, Rounding::Up)
    );
    if !one.points.is_empty() {
        caption.push_str(&format!(
            " Sobol' indices are shares of the variance, at {} of the unknown inputs, errors included (confidence {}). For a random \
             input, the band is assumed to shrink with the square root of the variance.",
            counted(one.points.len() as u64, "value", &writer.with_tag(&Tag::Count("values with Sobol' indices"))),
            writer.with_tag(&Tag::Given("confidence")).percent(one.confidence, Rounding::Nearest)
        ));
    }
    let linear: Vec<_> = one.random.iter().filter(|input| input.is_linear_estimate()).collect();
    if !linear.is_empty() {
        let subject = if linear.len() == one.random.len() {
            "a random input".to_owned()
        } else {
            listed(&linear.iter().flat_map(|input| &input.paths).map(name).collect::<Vec<String>>())
        };
        caption.push_str(&format!(
            " For {subject} it is estimated without further runs: from its share of the variance by linear scatter without play. \
             Sobol' indices need further runs: \"contributors\" among the statistics."
        ));
    }
    caption.push_str(
        " Quasi-static share, without dynamics: share of the variance by linear scatter without play, or share of the worst case of \
         all clearances.",
    );
    caption
}

/// A share over the values that were tried, where it is known.
fn share(share: &ShareRange, writer: &NumberWriter) -> Option<String> {
    share.lower.is_finite().then(|| writer.percent_range(share.lower, share.upper))
}

/// A share that may not exist.
fn known(share: Option<f64>, writer: &NumberWriter) -> Option<String> {
    share.map(|share| writer.percent(share, Rounding::Nearest))
}

/// The share of mechanisms that the bands hold which sensitivities are about.
fn band_probability(writer: &NumberWriter) -> String {
    const BAND_PROBABILITY: f64 = 0.95;
    writer.with_tag(&Tag::Given("probability")).percent(BAND_PROBABILITY, Rounding::Nearest)
}

/// A share of the band, or its range, where it is known.
fn band_share(share: [f64; 2], writer: &NumberWriter) -> Option<String> {
    let text = |part: &str, share: f64| {
        let tag = writer.tag().map(|tag| tag.part(part));
        writer.with_optional_tag(tag.as_ref()).percent((100.0 * share).round() / 100.0, Rounding::Nearest)
    };
    let (least, most) = (text("least", share[0]), text("most", share[1]));
    match share {
        [least, _] if !least.is_finite() => None,
        _ if same_wording(&least, &most) => Some(most),
        _ => Some(format!("{least} to {most}")),
    }
}

fn bar(colour: &'static str, share: [f64; 2], writer: &NumberWriter) -> Cell {
    let (html, text) = bar_markup(colour, share, writer);
    Cell::Drawn { html: html.into_string(), text: text.unwrap_or_else(|| "-".to_owned()) }
}

/// The bar of a share of the band with the share in words, and these alone.
fn bar_markup(colour: &'static str, share: [f64; 2], writer: &NumberWriter) -> (Markup, Option<String>) {
    let text = band_share(share, writer);
    let [least, most] = share.map(|share| if share.is_finite() { share } else { 0.0 });
    let on_page = text.as_deref().unwrap_or("–");
    let html = html! {
        svg.bar width="100%" height="20" role="img" aria-label=(on_page) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            rect class=(colour) x="0%" y="4" width=(percent_of(least, 0.0, 1.0)) height="12" rx="2" {}
            // What depends on the value that it turns out to have.
            rect class=(colour) x=(percent_of(least, 0.0, 1.0)) y="8" width=(percent_of(most - least, 0.0, 1.0)) height="4" {}
        }
        span.range { (on_page) }
    };
    (html, text)
}
