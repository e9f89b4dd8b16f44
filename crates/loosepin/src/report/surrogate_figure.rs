//! Training runs against one input, with the surrogate and by how much it is taken to err.

use maud::{Markup, html};

use super::number::{NumberWriter, plain_name};
use super::section_figure::{Axis, tick_text};
use super::wording::{deviation_words, output_words};
use crate::study::result::{StudyResult, SurrogateOutput, SurrogatePicture};
use crate::units::SiUnit;

/// Width and height of the picture in its own units; a unit is about a pixel.
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 340.0;
/// Room for numbers on the left and below.
const LEFT: f64 = 74.0;
const BELOW: f64 = 46.0;
const MARGIN: f64 = 18.0;

/// A dot for each run, a line for the surrogate, and two for the ends of its band.
pub(super) fn surrogate_figure(
    result: &StudyResult,
    output: &SurrogateOutput,
    picture: &SurrogatePicture,
    writer: &NumberWriter,
) -> Markup {
    let (across, up) = (writer.units.of(&picture.input_unit), writer.units.of(&output.unit));
    let ends = |sign: f64| {
        let pairs = picture.output_si.iter().zip(&picture.half_width_si);
        pairs.map(move |(value, half)| value + sign * half).collect::<Vec<f64>>()
    };
    let (low, high) = (ends(-1.0), ends(1.0));
    let x_axis = Axis::over(picture.input_si.iter().map(|value| across.from_si(*value)));
    let shown = picture.run_output_si.iter().chain(&low).chain(&high);
    let y_axis = Axis::over(shown.map(|value| up.from_si(*value))).wider();
    let x = |value_si: f64| LEFT + x_axis.share(across.from_si(value_si)) * (WIDTH - LEFT - MARGIN);
    let y = |value_si: f64| HEIGHT - BELOW - y_axis.share(up.from_si(value_si)) * (HEIGHT - BELOW - MARGIN);
    let line = |values: &[f64]| {
        let mut path = String::new();
        for (input, value) in picture.input_si.iter().zip(values) {
            let command = if path.is_empty() { 'M' } else { 'L' };
            path.push_str(&format!("{command}{:.1} {:.1}", x(*input), y(*value)));
        }
        path
    };
    let mut dots = String::new();
    for (input, value) in picture.run_input_si.iter().zip(&picture.run_output_si) {
        dots.push_str(&format!("M{:.1} {:.1}h0", x(*input), y(*value)));
    }
    let symbol = |symbol: &str| if symbol.is_empty() { String::new() } else { format!(" [{symbol}]") };
    let name = output_words(&output.output, &result.outputs);
    let at =
        picture.pose_rad.map_or(String::new(), |pose| format!(", at {}", writer.value_trimmed(pose, &SiUnit::ANGLE)));
    let input = plain_name(&picture.path, &result.inputs);
    let alternative = format!(
        "{} training runs of {name} against the {input}, and the surrogate with its band.",
        picture.run_input_si.len()
    );
    html! {
        figure.section {
            svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(alternative) {
                @for tick in x_axis.ticks() {
                    @let place = LEFT + x_axis.share(tick) * (WIDTH - LEFT - MARGIN);
                    line.grid x1=(format!("{place:.1}")) x2=(format!("{place:.1}")) y1=(MARGIN) y2=(HEIGHT - BELOW) {}
                    text x=(format!("{place:.1}")) y=(HEIGHT - BELOW + 17.0) text-anchor="middle" { (tick_text(tick)) }
                }
                @for tick in y_axis.ticks() {
                    @let place = HEIGHT - BELOW - y_axis.share(tick) * (HEIGHT - BELOW - MARGIN);
                    line.grid x1=(LEFT) x2=(WIDTH - MARGIN) y1=(format!("{place:.1}")) y2=(format!("{place:.1}")) {}
                    text x=(LEFT - 8.0) y=(format!("{:.1}", place + 4.0)) text-anchor="end" { (tick_text(tick)) }
                }
                path.irregular stroke-width="5" d=(dots) {}
                path.regular d=(line(&picture.output_si)) {}
                path.regular stroke-dasharray="5 5" d=(line(&low)) {}
                path.regular stroke-dasharray="5 5" d=(line(&high)) {}
                text x=(0.5 * (LEFT + WIDTH - MARGIN)) y=(HEIGHT - 8.0) text-anchor="middle" {
                    (input) (symbol(&across.symbol))
                }
                text transform=(format!("translate(14 {}) rotate(-90)", 0.5 * (HEIGHT - BELOW))) text-anchor="middle" {
                    (output.output) (symbol(&up.symbol))
                }
            }
            figcaption {
                strong { (name) ", " (deviation_words(output.of)) (at) ", against the " (input) "." }
                " " span.irregular { "Dots" } ": training runs, moved along the surrogate to the middle of all other inputs. "
                span.regular { "Lines" } ": the surrogate there, and by how much it is taken to err."
            }
        }
    }
}
