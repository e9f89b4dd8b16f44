//! The output that a table is of, and which deviation of it.

use crate::file::problem::StudyProblem;
use crate::file::reader::StudyReader;
use crate::file::words::{DEVIATIONS, words};
use crate::model::outputs::{ALL_COMPONENTS, HEIGHT, OutputSource, StudyOutput};
use loosepin_mechanics::model::WearMeasure;
use loosepin_result::study::Deviation;
use loosepin_text::diagnostics::nearest_name;
use loosepin_text::document::{Entry, Key, Kind, Table, optional, required};
use loosepin_text::units::Dimension;

/// The output of a question or a requirement.
pub(crate) const OUTPUT: Key = required("output", Kind::Reference("output"), "\"slider\"", "an output of the model");
/// The component of it, where it is a path.
pub(crate) const COMPONENT: Key = optional(
    "component",
    Kind::Choice(&ALL_COMPONENTS),
    "\"normal\"",
    "of a path or an orientation, and only there. Of a path: a coordinate of the point; its error along the path, normal to it (to \
     the left), or whole; contour: its distance from the path whatever the timing; in space x, y, z, along, across (its distance from \
     the line along the path) and magnitude. Of an orientation: magnitude, which may be left out",
);
/// Which deviation of it.
pub(crate) const DEVIATION: Key = required(
    "of",
    Kind::Choice(&words(&DEVIATIONS)),
    "\"total\"",
    "value: the output itself; its deviation: dimensional, by lengths alone; clearance, by play alone; total, by both",
);

impl StudyReader {
    /// The output that is named in a table, with its component, by its place in [`Self::outputs`].
    pub(crate) fn output(
        &mut self,
        table: &Table<'_>,
        entry: &Option<Entry<'_>>,
        component: &Option<Entry<'_>>,
    ) -> Option<usize> {
        let entry = entry.as_ref()?;
        let name = self.reader.text(entry)?.to_owned();
        let names = self.model.output_names();
        let Some(index) = names.iter().position(|output| *output == name) else {
            let known = names.iter().map(|output| format!("'{output}'")).collect();
            let nearest = nearest_name(&name, names.iter().copied()).map(str::to_owned);
            let problem = StudyProblem::UnknownOutput { entry: table.path.describe(), name, nearest, known };
            return self.refused(&problem, entry.span);
        };
        let own = self.outputs.iter().filter(|output| output.output == index);
        let components: Vec<&'static str> = own.filter_map(|output| output.component).collect();
        if components.is_empty() {
            if let Some(component) = component {
                let problem = StudyProblem::ComponentOfNoPath { entry: table.path.describe(), name };
                return self.refused(&problem, component.key_span);
            }
            return self.outputs.iter().position(|output| output.output == index);
        }
        let Some(component) = component else {
            if components.len() == 1 {
                return self.outputs.iter().position(|output| output.output == index);
            }
            let has_height = components.contains(&HEIGHT);
            let problem = StudyProblem::PathOutput { entry: table.path.describe(), name, has_height };
            return self.refused(&problem, entry.span);
        };
        let choices: Vec<(&str, &'static str)> = components.iter().map(|&name| (name, name)).collect();
        let component = self.reader.choice(component, &choices)?;
        self.outputs.iter().position(|output| output.output == index && output.component == Some(component))
    }

    /// Which deviation of an output, where that is known.
    pub(crate) fn deviation(&mut self, entry: Option<&Entry<'_>>, output: Option<usize>) -> Option<Deviation> {
        let entry = entry?;
        let deviation = self.reader.choice(entry, &DEVIATIONS)?;
        if deviation.is_value()
            && let Some(StudyOutput { seen, component: Some(component), dimension, .. }) =
                output.map(|output| &self.outputs[output])
            && seen.is_error_of_path()
        {
            let of = if *dimension == Dimension::ANGLE { "orientation" } else { "path" };
            let problem = StudyProblem::ValueOfPathError { entry: entry.path.describe(), component, of };
            return self.refused(&problem, entry.span);
        }
        if !deviation.is_value_of_run() && self.is_wear(output) {
            let problem = StudyProblem::WearOfDeviation { entry: entry.path.describe() };
            return self.refused(&problem, entry.span);
        }
        let has_play = self.model.has_play();
        if deviation.is_by_play_alone() && !has_play {
            return self.refused(&StudyProblem::NoPlay { entry: entry.path.describe() }, entry.span);
        }
        Some(deviation)
    }

    /// Whether an output is the life of a joint.
    pub(crate) fn is_life(&self, output: usize) -> bool {
        matches!(self.outputs[output].seen, OutputSource::Wear(_, WearMeasure::Life))
    }

    /// Whether an output is the wear of a joint.
    pub(crate) fn is_wear(&self, output: Option<usize>) -> bool {
        output.is_some_and(|output| matches!(self.outputs[output].seen, OutputSource::Wear(..)))
    }
}
