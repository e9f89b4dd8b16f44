//! Sensitivities, for a terminal.

use super::number::{NumberWriter, plain_name};
use super::study_page::{band_probability, band_share, known_share, share_range};
use super::tag::Tag;
use super::terminal_table::{push_table, table};
use super::wording::{listed, response_words};
use loosepin_result::study::StudyResult;

/// One table for each question that asks for contributors.
pub(super) fn contributors_text(result: &StudyResult, writer: &NumberWriter) -> String {
    let mut text = String::new();
    for one in &result.contributors {
        text.push_str(&format!(
            "\nSensitivity: how much narrower the {} band ({} wide) becomes without one input\n\n{}\n",
            band_probability(writer),
            writer.about(&Tag::contributors(one, "band width", "")).value(one.band_width_si, &one.unit),
            response_words(result, (&one.output, one.of, one.at), writer)
        ));
        let head = ["input", "by", "band narrower by", "Sobol' first", "Sobol' total", "quasi-static"];
        let mut rows = table(&head, &[2, 3, 4, 5]);
        let name = |path: &String| plain_name(path, &result.inputs);
        let tag = |part: &str, paths: &[String]| Tag::contributors(one, part, &paths.join(" "));
        let of_path = |part: &str, path: &String| Tag::contributors(one, part, path);
        for input in &one.random {
            rows.add_row([
                listed(&input.paths.iter().map(name).collect::<Vec<String>>()),
                "tolerance".to_owned(),
                band_share([input.band_share; 2], &writer.about(&tag("band", &input.paths))),
                share_range(&input.first, &writer.about(&tag("first", &input.paths))),
                share_range(&input.total, &writer.about(&tag("total", &input.paths))),
                known_share(input.quasi_static_share, &writer.about(&tag("quasi-static", &input.paths))),
            ]);
        }
        for input in &one.epistemic {
            rows.add_row([
                name(&input.path),
                "measurement".to_owned(),
                band_share(input.band_share, &writer.about(&of_path("band", &input.path))),
                "-".to_owned(),
                "-".to_owned(),
                known_share(input.quasi_static_share, &writer.about(&of_path("quasi-static", &input.path))),
            ]);
        }
        push_table(&mut text, &rows);
    }
    text.replace('–', "-")
}
