//! The output that a table is of, and which deviation of it.

use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::words::DEVIATIONS;
use crate::outputs::{COMPONENTS, Seen, StudyOutput};
use loosepin_mechanics::model::{Recorded, WearMeasure};
use loosepin_result::study::Deviation;
use loosepin_text::diagnostics::nearest_name;
use loosepin_text::document::Table;

impl StudyReader {
    /// The output that a table names, by its place in [`Self::outputs`].
    pub(super) fn output(&mut self, table: &Table<'_>) -> Option<usize> {
        let entry = table.get("output")?;
        let name = self.reader.text(&entry)?.to_owned();
        let outputs = &self.model.outputs;
        let Some(index) = outputs.iter().position(|output| output.name == name) else {
            let known = outputs.iter().map(|output| format!("'{}'", output.name)).collect();
            let nearest = nearest_name(&name, outputs.iter().map(|output| output.name.as_str())).map(str::to_owned);
            let problem = StudyProblem::UnknownOutput { entry: table.path.describe(), name, nearest, known };
            return self.refused(&problem, entry.span);
        };
        let component = table.get("component");
        if !matches!(outputs[index].kind.recorded(), Recorded::Path(_)) {
            if let Some(component) = component {
                let problem = StudyProblem::ComponentOfNoPath { entry: table.path.describe(), name };
                return self.refused(&problem, component.key_span);
            }
            return self.outputs.iter().position(|output| output.output == index);
        }
        let Some(component) = component else {
            return self.refused(&StudyProblem::PathOutput { entry: table.path.describe(), name }, entry.span);
        };
        let component = self.reader.choice(&component, &COMPONENTS.map(|name| (name, name)))?;
        self.outputs.iter().position(|output| output.output == index && output.component == Some(component))
    }

    /// Which deviation of an output, where that is known.
    pub(super) fn deviation(&mut self, table: &Table<'_>, output: Option<usize>) -> Option<Deviation> {
        let entry = table.get("of")?;
        let deviation = self.reader.choice(&entry, &DEVIATIONS)?;
        if deviation == Deviation::Value
            && let Some(StudyOutput { seen: Seen::Path(..), component: Some(component), .. }) =
                output.map(|output| &self.outputs[output])
        {
            let problem = StudyProblem::ValueOfPathError { entry: entry.path.describe(), component };
            return self.refused(&problem, entry.span);
        }
        if deviation != Deviation::Value && self.is_wear(output) {
            let problem = StudyProblem::WearOfDeviation { entry: entry.path.describe() };
            return self.refused(&problem, entry.span);
        }
        let has_play = self.model.plays().next().is_some();
        if deviation == Deviation::Clearance && !has_play {
            return self.refused(&StudyProblem::NoPlay { entry: entry.path.describe() }, entry.span);
        }
        Some(deviation)
    }

    /// Whether an output is the life of a joint.
    pub(super) fn is_life(&self, output: usize) -> bool {
        matches!(self.outputs[output].seen, Seen::Wear(_, WearMeasure::Life))
    }

    /// Whether an output is the wear of a joint.
    pub(super) fn is_wear(&self, output: Option<usize>) -> bool {
        output.is_some_and(|output| matches!(self.outputs[output].seen, Seen::Wear(..)))
    }
}
