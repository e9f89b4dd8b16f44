//! Sensitivity: how much narrower the band becomes by a tighter tolerance or a better measurement; one chart in two colours.

use maud::{Markup, html};

use crate::charts::still_figures::percent_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::numbers::tag::{Tag, same_wording};
use crate::words::wording::{counted, listed, response_words};
use loosepin_result::study::{Contributors, ResponsePoint, ShareRange, StudyResult};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};

/// `None` if no question asks for contributors.
pub(crate) fn contributors_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    if result.contributors.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("contributors", "Sensitivity");
    push_figure(&mut section, writer, || legend(writer));
    for one in &result.contributors {
        let tag = Tag::contributors(one, "band width", "");
        let heading = format!(
            "Sensitivity: how much narrower the {} band ({} wide) becomes without one input",
            band_probability(writer),
            writer.with_tag(&tag).value(one.band_width_si, &one.unit)
        );
        section.push_on(Medium::Terminal, Content::Heading(heading.into()));
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
            name(&input.path).into(),
            "measurement".into(),
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
    Table {
        title: response_words(result, (&one.output, one.of, one.at), writer).into(),
        caption: caption(one, writer).into(),
        ..Table::new(columns, random.chain(epistemic))
    }
}

/// Meaning and error of the numbers.
fn caption(one: &Contributors, writer: &NumberWriter) -> String {
    let error = one.epistemic.iter().map(|input| input.error).fold(0.0, f64::max);
    let mut caption = format!(
        "The band is {} wide{}. For an unknown value, the reduction depends on the measured value: the bar goes from the smallest to \
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
    Cell::Drawn { html: html.into_string(), text: text.unwrap_or_else(|| "-".to_owned()) }
}
