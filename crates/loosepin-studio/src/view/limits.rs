//! Limits of a study that are lines in the chart of a band: on the magnitude of a deviation, over the whole cycle.

use std::sync::Arc;

use loosepin::diagnostics::Source;
use loosepin::document::parse_toml;
use loosepin::report::LiveLimit;
use loosepin::study::{Deviation, InputFile, Limit, Study};

use crate::messages::LimitView;
use crate::view::places::unquoted;
use crate::view::texts::Texts;

/// The lines in the charts of bands, and where the text of the study says them.
pub fn banded_limits(file: &InputFile, texts: &Texts) -> (Vec<LiveLimit>, Vec<LimitView>) {
    let (InputFile::Study(study), Some(source)) = (file, &texts.study) else { return (Vec::new(), Vec::new()) };
    let (lines, views): (Vec<LiveLimit>, Vec<Option<LimitView>>) = limits(study, source).into_iter().unzip();
    (lines, views.into_iter().flatten().collect())
}

/// Each with the stretch of the text of the study that says it.
fn limits(study: &Study, source: &Arc<Source>) -> Vec<(LiveLimit, Option<LimitView>)> {
    let toml = parse_toml(source).ok();
    let written = |index: usize| {
        let required = toml.as_ref()?.get_ref().get("require")?.get_ref().as_array()?.get(index)?;
        let range = unquoted(source, required.get_ref().as_table()?.get("within")?.span().into());
        Some((source.text()[range.clone()].to_owned(), [range.start, range.end].map(|byte| source.utf16_units(byte))))
    };
    let line = |(index, required): (usize, &loosepin::study::Requirement)| {
        let Limit::Within(within_si) = required.limit else { return None };
        if required.deviation != Deviation::of_all_causes() || !required.location.is_cycle() {
            return None;
        }
        let output = study.outputs[required.output].name.clone();
        let seen = written(index).map(|(written, [from, to])| LimitView {
            output: output.clone(),
            within_si,
            written,
            from,
            to,
        });
        Some((LiveLimit { output, within_si }, seen))
    };
    study.requirements.iter().enumerate().filter_map(line).collect()
}
