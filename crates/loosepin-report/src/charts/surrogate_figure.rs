//! Training runs against one input, with the surrogate and its error.

use maud::{Markup, html};

use crate::charts::axes::{Axes, Axis, with_unit};
use crate::charts::figure::{Picture, csv_number, csv_text, name_of};
use crate::numbers::number::{NumberWriter, plain_name};
use crate::words::wording::{deviation_words, output_words, place_words};
use loosepin_result::study::{ResponsePoint, StudyResult, SurrogateOutput, SurrogatePicture};

/// Width and height of the picture in its own units; a unit is about a pixel.
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 340.0;

/// A dot for each run, a line for the surrogate, and two for the ends of its band.
pub(crate) fn surrogate_figure(
    result: &StudyResult,
    output: &SurrogateOutput,
    picture: &SurrogatePicture,
    index: usize,
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
    let y_axis = Axis::over(shown.map(|value| up.from_si(*value))).with_margin();
    let axes = Axes { width: WIDTH, height: HEIGHT, x: x_axis, y: y_axis };
    let x = |value_si: f64| axes.x_position(across.from_si(value_si));
    let y = |value_si: f64| axes.y_position(up.from_si(value_si));
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
    let name = output_words(&output.output, &result.outputs);
    // Of a curve the picture is at one of its poses.
    let at = picture.pose_rad.map_or(output.at, |pose_rad| ResponsePoint::Pose { pose_rad });
    let at = place_words(at, writer);
    let input = plain_name(&picture.path, &result.inputs);
    let subject = format!("{} of {}", deviation_words(output.of), output.output);
    let alternative = format!(
        "{} training runs of {name} against the {input}, and the surrogate with its band.",
        picture.run_input_si.len()
    );
    let csv = csv(
        picture,
        [&low, &high],
        [with_unit(&input, &across.symbol), with_unit(&subject, &up.symbol)],
        writer,
        output,
    );
    let drawn = html! {
                (axes.grid())
                path.irregular.dots d=(dots) {}
                path.regular d=(line(&picture.output_si)) {}
                path.regular stroke-dasharray="5 5" d=(line(&low)) {}
                path.regular stroke-dasharray="5 5" d=(line(&high)) {}
                (axes.labels([&input, &across.symbol], [&subject, &up.symbol]))
    };
    let caption = html! {
                strong { (name) ", " (deviation_words(output.of)) ", " (at) ", against the " (input) "." }
                " " span.irregular { "Dots" } ": training runs, projected along the surrogate to the middle of all other inputs. "
                span.regular { "Lines" } ": the surrogate there, with its error."
    };
    let name = name_of("surrogate", &format!("{} {} {}", output.output, output.of.word(), index + 1));
    Picture { name, class: "section", view: [0.0, 0.0, WIDTH, HEIGHT], below: 0.0, alternative, drawn }
        .figure(caption, Some(&csv))
}

/// The runs, then the surrogate: a row for each, where it has no value empty.
fn csv(
    picture: &SurrogatePicture,
    [low, high]: [&[f64]; 2],
    [input, subject]: [String; 2],
    writer: &NumberWriter,
    output: &SurrogateOutput,
) -> String {
    let x = |value_si: f64| csv_number(writer.scaled(value_si, &picture.input_unit));
    let y = |value_si: f64| csv_number(writer.scaled(value_si, &output.unit));
    let of = |what: &str| csv_text(&format!("{what}, {subject}"));
    let heads = [csv_text(&input), of("run"), of("surrogate"), of("surrogate lower"), of("surrogate upper")];
    let mut table = format!("{}\n", heads.join(","));
    for (at, value) in picture.run_input_si.iter().zip(&picture.run_output_si) {
        table.push_str(&format!("{},{},,,\n", x(*at), y(*value)));
    }
    let ends = low.iter().zip(high);
    for ((at, value), (low, high)) in picture.input_si.iter().zip(&picture.output_si).zip(ends) {
        table.push_str(&format!("{},,{},{},{}\n", x(*at), y(*value), y(*low), y(*high)));
    }
    table
}
