//! Pictures that do not move and need no script: the path of a journal, bars, histograms.

use maud::{Markup, html};

use super::figure::{Picture, name_of};
use super::number::{NumberWriter, Rounding};
use loosepin_result::simulation::JournalOrbit;
use loosepin_result::study::HistogramBin;
use loosepin_text::units::SiUnit;

/// Half the side of an orbit picture in its own units; the clearance circle has radius 1000.
const ORBIT_HALF_SIDE: f64 = 1180.0;
/// Radius of the clearance circle.
const ORBIT_RADIUS: f64 = 1000.0;
/// Points of an orbit in a page.
const ORBIT_POINTS: usize = 3000;

/// Path of a journal inside the circle of its clearance.
pub(super) fn orbit_figure(orbit: &JournalOrbit, writer: &NumberWriter) -> Markup {
    let clearance = writer.value_trimmed(orbit.radial_clearance_m, &SiUnit::LENGTH);
    let radii = || orbit.x_m.iter().zip(&orbit.y_m).map(|(x_m, y_m)| x_m.hypot(*y_m));
    let farthest_m = radii().fold(0.0, f64::max);
    let on_rim = radii().filter(|radius_m| *radius_m >= 0.999 * orbit.radial_clearance_m).count();
    let rim_share = on_rim as f64 / orbit.x_m.len().max(1) as f64;
    let farthest = writer.value_trimmed(farthest_m, &SiUnit::LENGTH);
    let rim = writer.percent(rim_share, Rounding::Nearest);
    let mut path = String::new();
    for place in places(orbit) {
        path.push_str(&format!("{}{place}", if path.is_empty() { 'M' } else { 'L' }));
    }
    let title = if orbit.label.is_empty() { orbit.joint.clone() } else { format!("{}, {}", orbit.joint, orbit.label) };
    in_circle(
        &format!("Path of the journal of {title}: within {farthest} of the bearing's centre, clearance {clearance}."),
        &name_of("orbit", &title),
        html! { path.track d=(path) {} },
        html! {
            strong { (title) } ". Circle: radial clearance " (clearance) ". On the rim in " (rim)
            " of the samples; farthest " (farthest) " from the centre."
        },
    )
}

/// A journal once a turn, inside the circle of its clearance: a dot for each turn.
pub(super) fn journal_sections(journal: &JournalOrbit, writer: &NumberWriter) -> Markup {
    let clearance = writer.value_trimmed(journal.radial_clearance_m, &SiUnit::LENGTH);
    let (joint, turns) = (&journal.joint, journal.x_m.len());
    let dots: String = places(journal).map(|place| format!("M{place}h0")).collect();
    in_circle(
        &format!("The journal of {joint} once a turn, {turns} turns: dots in the circle of the clearance {clearance}."),
        &name_of("once-a-turn", joint),
        html! { path.dots d=(dots) {} },
        html! { strong { (joint) ", once a turn" } ". Circle: radial clearance " (clearance) ". " (turns) " turns." },
    )
}

/// Where a journal was, in units of the picture.
fn places(journal: &JournalOrbit) -> impl Iterator<Item = String> {
    let scale = if journal.radial_clearance_m > 0.0 { ORBIT_RADIUS / journal.radial_clearance_m } else { 0.0 };
    let step = journal.x_m.len().div_ceil(ORBIT_POINTS).max(1);
    let finite = journal.x_m.iter().zip(&journal.y_m).step_by(step).filter(|(x, y)| (**x + **y).is_finite());
    finite.map(move |(x_m, y_m)| format!("{:.0} {:.0}", x_m * scale, y_m * scale))
}

/// The circle of a clearance with what is drawn in it.
fn in_circle(alternative: &str, name: &str, drawn: Markup, caption: Markup) -> Markup {
    let view = [-ORBIT_HALF_SIDE, -ORBIT_HALF_SIDE, 2.0 * ORBIT_HALF_SIDE, 2.0 * ORBIT_HALF_SIDE];
    let drawn = html! {
        g transform="scale(1 -1)" {
            line.axis x1="-1120" x2="1120" y1="0" y2="0" {}
            line.axis y1="-1120" y2="1120" x1="0" x2="0" {}
            circle.clearance r=(ORBIT_RADIUS) {}
            (drawn)
        }
    };
    Picture { name: name.to_owned(), class: "orbit", view, below: 0.0, alternative: alternative.to_owned(), drawn }
        .figure(caption, None)
}

/// Where `value` lies between `from` and `to`, in percent of the width.
pub(super) fn percent_of(value: f64, from: f64, to: f64) -> String {
    let share = if to > from { (value - from) / (to - from) } else { 0.5 };
    // The ends may be infinite where a bound does not exist.
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    format!("{:.3}%", 100.0 * share)
}

/// Bars over a logarithmic axis.
pub(super) fn histogram_figure(bins: &[HistogramBin], id: &str, caption: Markup, alternative: &str) -> Markup {
    // A logarithmic axis has no place for anything else, and its decades are counted below.
    let bins: Vec<&HistogramBin> = bins
        .iter()
        .filter(|bin| bin.from.is_normal() && bin.from > 0.0 && bin.to > bin.from && bin.to.is_finite())
        .collect();
    let most = bins.iter().map(|bin| bin.count).max().unwrap_or(0).max(1) as f64;
    let (Some(first), Some(last)) = (bins.first(), bins.last()) else { return html! {} };
    let (from, to) = (first.from.log10(), last.to.log10());
    let decades: Vec<i32> = (from.ceil() as i32..=to.floor() as i32).collect();
    let every = decades.len().div_ceil(8).max(1);
    html! {
        figure.histogram id=(id) {
            svg width="100%" height="170" role="img" aria-label=(alternative) {
                @for bin in &bins {
                    @let share = bin.count as f64 / most;
                    @let left = (bin.from.log10() - from) / (to - from) * 94.0 + 3.0;
                    @let width = (bin.to.log10() - bin.from.log10()) / (to - from) * 94.0;
                    rect.bar x=(format!("{left:.3}%")) width=(format!("{:.3}%", (width - 0.25).max(0.1)))
                        y=(format!("{:.2}", 130.0 - 115.0 * share)) height=(format!("{:.2}", 115.0 * share)) {
                        title { (bin.count) @if bin.count == 1 { " run" } @else { " runs" } }
                    }
                }
                line.axis x1="3%" x2="97%" y1="130" y2="130" {}
                @for decade in decades.iter().step_by(every) {
                    @let place = (f64::from(*decade) - from) / (to - from) * 94.0 + 3.0;
                    text x=(format!("{place:.3}%")) y="150" text-anchor="middle" {
                        "10" tspan dy="-5" font-size="10" { (decade.to_string().replace('-', "−")) }
                    }
                }
            }
            figcaption { (caption) }
        }
    }
}
