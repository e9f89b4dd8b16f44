//! Bounds before a study is finished: from a pilot, then after each round.

use crate::assemble::{Material, asked_bounds, requirements};
use crate::drafts::curves::draft_curves;
use crate::drafts::progress::{Drafts, PilotRun};
use crate::file::Study;
use crate::response::columns::BAND;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{DoubleLoop, PlanError, Purpose, Request, RunInputs, SampleTable, Statistic};
use loosepin_result::study::{Draft, ResponsePoint};
use loosepin_text::units::DisplayUnits;
use std::collections::HashSet;

/// Runs of a pilot, unless two in each replicate at every first point are more: two cores make them in a second or two.
const PILOT_RUNS: usize = 512;

/// Drafts of a study.
pub(crate) struct Drafting<'s> {
    study: &'s Study,
    response: &'s StudyResponse,
    /// `None` if a pilot would be no smaller than the first round.
    pilot: Option<Pilot>,
}

/// The runs that are made first.
struct Pilot {
    plan: DoubleLoop,
    /// Point, replicate and index of each.
    places: HashSet<(u32, u32, u32)>,
}

impl<'s> Drafting<'s> {
    /// Drafts of `study`, whose first round is that of `plan`.
    pub fn new(study: &'s Study, response: &'s StudyResponse, plan: &DoubleLoop) -> Self {
        let mut drafting = Self { study, response, pilot: None };
        drafting.pilot = drafting.pilot(plan);
        drafting
    }

    fn pilot(&self, plan: &DoubleLoop) -> Option<Pilot> {
        let plan = self.without_curves(plan)?.pilot(PILOT_RUNS)?;
        let runs = plan.next_round(&SampleTable::new(self.response.row_length())).ok()?;
        let places = runs.iter().map(|run| (run.point, run.replicate, run.index)).collect();
        Some(Pilot { plan, places })
    }

    /// The part of `plan` that a draft shows; `None` if there is none.
    fn without_curves(&self, plan: &DoubleLoop) -> Option<DoubleLoop> {
        let asks = || self.response.plan().asks.iter();
        let curve = asks().find(|ask| ask.location.is_cycle());
        // A curve alone needs the runs, but no bound of any of its points.
        let [middle, ..] = Statistic::of_curve_point(BAND);
        let pose = curve.and_then(|ask| ask.columns.first()).copied();
        plan.draft(|request| self.is_single_number(request))
            .or_else(|| plan.draft(|request| Some(request.column) == pose && request.statistic == middle))
    }

    /// Whether a request is of a single number of the whole recorded part.
    fn is_single_number(&self, request: &Request) -> bool {
        let column = self.response.plan().columns.get(request.column);
        column.is_some_and(|column| column.spot.reduction().is_some())
    }

    fn draft(&self, plan: &DoubleLoop, table: &SampleTable) -> Result<Draft, PlanError> {
        let &Self { study, response, .. } = self;
        let bounds = plan.results(table)?;
        let material = Material::of_bounds(study, response, table, &bounds);
        let is_reduced = |at: &ResponsePoint| matches!(at, ResponsePoint::Reduced { .. });
        Ok(Draft {
            runs: table.len(),
            bounds: asked_bounds(&material).into_iter().filter(|bound| is_reduced(&bound.at)).collect(),
            requirements: requirements(&material)
                .into_iter()
                .filter(|outcome| outcome.at == ResponsePoint::Whole)
                .collect(),
            curves: draft_curves(response, table),
            drive: study.model.input(study.cycle.span, response.nominal()).name,
            display_units: study.model.shown_in(DisplayUnits::default()),
        })
    }
}

impl Drafts for Drafting<'_> {
    fn is_in_pilot(&self, inputs: &RunInputs) -> bool {
        let place = (inputs.point, inputs.replicate, inputs.index);
        inputs.purpose == Purpose::DoubleLoop && self.pilot.as_ref().is_some_and(|pilot| pilot.places.contains(&place))
    }

    fn of_pilot(&self, runs: &[PilotRun<'_>]) -> Option<Draft> {
        let mut table = SampleTable::new(self.response.row_length());
        for &(inputs, outcome) in runs {
            table.push(inputs.clone(), outcome).ok()?;
        }
        self.draft(&self.pilot.as_ref()?.plan, &table).ok()
    }

    fn of(&self, plan: &DoubleLoop, table: &SampleTable) -> Option<Draft> {
        self.draft(&self.without_curves(plan)?, table).ok()
    }
}
