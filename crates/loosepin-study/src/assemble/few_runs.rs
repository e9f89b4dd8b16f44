//! A small study of a curve with its runs: what tests of results begin with.

use super::Material;
use crate::file::Study;
use crate::planning::problem::problem;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{BoundPair, Bounds, DoubleLoop, SampleTable, execute};
use std::path::Path;

pub struct FewRuns {
    pub study: Study,
    pub response: StudyResponse,
    pub table: SampleTable,
    pub bounds: Bounds,
}

impl FewRuns {
    /// The mean deviation of the slider at six poses of a turn, after `transient_turns` turns.
    pub fn after(transient_turns: u32) -> Self {
        let ask = "output = \"slider\"\nof = \"dimensional\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n";
        Self::asking(transient_turns, ask)
    }

    /// The questions of these lines of `[[ask]]`.
    pub fn asking(transient_turns: u32, ask: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin/study.toml");
        let text = format!(
            "name = \"few runs\"\nmodel = \"model.toml\"\n\
             [cycle]\ntransient_turns = {transient_turns}\nrecorded_turns = 1\nsamples_per_turn = 6\n\
             [sampling]\nouter = 4\ninner = 32\n\
             [random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
             [[ask]]\n{ask}"
        );
        let study = Study::from_text_at(&path.display().to_string(), &text);
        let study = study.unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let response = StudyResponse::new(&study).unwrap();
        let plan = DoubleLoop::try_new(problem(&study, &response)).unwrap();
        let mut table = SampleTable::new(response.row_length());
        execute(plan.next_round(&table).unwrap(), &response, &mut table).unwrap();
        let bounds = plan.results(&table).unwrap();
        Self { study, response, table, bounds }
    }

    /// With only some of the bounds.
    pub fn material<'m>(&'m self, pairs: &'m [BoundPair]) -> Material<'m> {
        let Self { study, response, table, bounds } = self;
        Material::of_bounds(study, response, table, bounds).with_pairs(pairs)
    }
}
