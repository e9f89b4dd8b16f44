//! Picture of the posterior distribution of one unknown: its density over the interval of the study.

use maud::{Markup, html};

use crate::charts::axes::{Axes, Axis, with_unit};
use crate::charts::figure::{Picture, csv_number, csv_text};
use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::identification::PlayBounds;
use loosepin_result::motion_identification::{Marginal, MarginalSummary};

/// Size of the picture in its own units; a unit is about a pixel.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 320.0;

/// Densities of the cells of a distribution over `unknown`, in units that are shown, each with both ends of its cell.
fn densities(unknown: &PlayBounds, marginal: &Marginal, writer: &NumberWriter<'_>) -> Vec<([f64; 2], f64)> {
    let [low, high] = unknown.before_si.map(|end_si| writer.scaled(end_si, &unknown.unit));
    let width = (high - low) / marginal.shares.len().max(1) as f64;
    let cell = |(cell, share): (usize, &f64)| {
        ([cell, cell + 1].map(|end| low + width * end as f64), if width > 0.0 { share / width } else { 0.0 })
    };
    marginal.shares.iter().enumerate().map(cell).collect()
}

/// Density of an unknown that is no list, its credible interval shaded.
pub(super) fn density(
    unknown: &PlayBounds,
    (marginal, summary): (&Marginal, &MarginalSummary),
    probability: f64,
    name: String,
    writer: &NumberWriter<'_>,
) -> Markup {
    let cells = densities(unknown, marginal, writer);
    let symbol = writer.symbol(&unknown.unit);
    let axes = Axes {
        width: WIDTH,
        height: HEIGHT,
        x: Axis::over(cells.iter().flat_map(|(ends, _)| *ends)),
        y: Axis::over(cells.iter().map(|(_, density)| *density).chain([0.0])),
    };
    let steps: String = cells
        .iter()
        .map(|([left, right], density)| {
            let [left, right, up] = [axes.x_position(*left), axes.x_position(*right), axes.y_position(*density)];
            format!("V{up:.1}H{right:.1}").replacen('V', &format!("L{left:.1} {up:.1}V"), 1)
        })
        .collect();
    let start = cells.first().map_or(0.0, |([left, _], _)| axes.x_position(*left));
    let zero = axes.y_position(0.0);
    let [left, right] = summary.credible_si.map(|end_si| axes.x_position(writer.scaled(end_si, &unknown.unit)));
    let top = axes.y_position(cells.iter().map(|(_, density)| *density).fold(0.0, f64::max));
    let credible = writer.percent(probability, Rounding::Nearest);
    let unit = if symbol.is_empty() { String::new() } else { format!("1/{symbol}") };
    let drawn = html! {
        (axes.grid())
        rect.cell x=(format!("{left:.1}")) y=(format!("{top:.1}")) width=(format!("{:.1}", (right - left).max(1.0)))
            height=(format!("{:.1}", zero - top)) {}
        path.density d=(format!("M{start:.1} {zero:.1}{steps}V{zero:.1}")) {}
        (axes.labels([&unknown.name, &symbol], ["density", &unit]))
    };
    let alternative = format!("Posterior density of {} over the interval of the study.", unknown.name);
    let caption = html! {
        strong { "Posterior density of " (unknown.name) "." }
        " Shaded: the " (credible) " credible interval, with equal tails. The prior is uniform over the whole axis."
    };
    let heads =
        [with_unit(&format!("{} from", unknown.name), &symbol), with_unit("to", &symbol), with_unit("density", &unit)];
    let mut csv = format!("{}\n", heads.map(|head| csv_text(&head)).join(","));
    for ([from, to], density) in &cells {
        csv.push_str(&format!("{}\n", [*from, *to, *density].map(csv_number).join(",")));
    }
    Picture { name, class: "map", view: [0.0, 0.0, WIDTH, HEIGHT], below: 0.0, alternative, drawn }
        .figure(caption, Some(&csv))
}
