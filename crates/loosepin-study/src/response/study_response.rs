//! A study as a function from uncertain inputs to numbers: what the uncertainty wing sees, for models in the plane and in space.

use crate::file::Study;
use crate::model::StudyModel;
use crate::response::columns::ColumnPlan;
use crate::response::extras::RunExtras;
use crate::response::planar_response::PlanarResponse;
use crate::response::problem::PrepareError;
use crate::response::spatial_response::SpatialResponse;
use loosepin_bounds::{Failure, Response};
use loosepin_simulate::{Execution, RunFailure};
use loosepin_text::numbers::{QuantityError, QuantityId, Values};
use std::sync::atomic::AtomicBool;

/// A prepared study.
#[derive(Debug)]
pub enum StudyResponse {
    /// Its runs are integrated.
    Planar(Box<PlanarResponse>),
    /// Its positions are closed, without dynamics.
    Spatial(Box<SpatialResponse>),
}

impl StudyResponse {
    /// Prepares `study`.
    ///
    /// # Errors
    /// The nominal mechanism has no ideal motion over the recorded part.
    pub fn new(study: &Study) -> Result<Self, PrepareError> {
        Self::with_plays(study, &[])
    }

    /// As [`Self::new`], with the joints with play that the values `at` of inputs give. All else is that of the nominal mechanism: what
    /// deviations are measured against, and the columns.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub(crate) fn with_plays(study: &Study, at: &[(QuantityId, f64)]) -> Result<Self, PrepareError> {
        match &study.model {
            StudyModel::Planar(model) => {
                PlanarResponse::with_plays(study, model, at).map(|own| Self::Planar(Box::new(own)))
            }
            StudyModel::Spatial(model) => SpatialResponse::new(study, model).map(|own| Self::Spatial(Box::new(own))),
        }
    }

    /// The runs that are integrated, if they are.
    pub fn planar(&self) -> Option<&PlanarResponse> {
        match self {
            Self::Planar(own) => Some(own),
            Self::Spatial(_) => None,
        }
    }

    /// The runs that are integrated, to be limited.
    pub fn planar_mut(&mut self) -> Option<&mut PlanarResponse> {
        match self {
            Self::Planar(own) => Some(own),
            Self::Spatial(_) => None,
        }
    }

    /// The columns of a run.
    pub fn plan(&self) -> &ColumnPlan {
        match self {
            Self::Planar(own) => &own.shared.plan,
            Self::Spatial(own) => &own.plan,
        }
    }

    /// Nominal values with the epistemic inputs in the middle.
    pub fn nominal(&self) -> &Values {
        match self {
            Self::Planar(own) => &own.nominal,
            Self::Spatial(own) => &own.nominal,
        }
    }

    /// Nominal ideal value of each column's output at its pose; NaN for reduced columns.
    pub fn nominal_at_pose(&self) -> &[f64] {
        match self {
            Self::Planar(own) => &own.shared.nominal_at_pose,
            Self::Spatial(own) => &own.nominal_at_pose,
        }
    }

    /// Names of the joints with play that have extras in a row.
    pub fn joints(&self) -> &[String] {
        self.planar().map_or(&[], |own| &own.joints)
    }

    /// Turns that a run records.
    pub fn recorded_turns(&self) -> f64 {
        match self {
            Self::Planar(own) => own.recorded_turns,
            Self::Spatial(own) => own.recorded_turns,
        }
    }

    /// Extras of a run, read from its row.
    pub fn extras(&self, row: &[f64]) -> RunExtras {
        RunExtras::read(row, self.joints().len())
    }

    /// Numbers of a row: columns, then extras.
    pub fn row_length(&self) -> usize {
        self.plan().columns.len() + RunExtras::count(self.joints().len())
    }

    /// How many kinds of runs there are: combinations of laws.
    pub fn variants(&self) -> usize {
        self.planar().map_or(1, |own| own.mechanisms.len())
    }

    /// Which of them runs with these epistemic inputs.
    pub fn variant(&self, epistemic: &[f64]) -> usize {
        self.planar().map_or(0, |own| own.variant(epistemic))
    }

    /// The values of the model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    pub fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        match self {
            Self::Planar(own) => own.values(random, epistemic),
            Self::Spatial(own) => own.values(random, epistemic),
        }
    }

    /// One run, alone.
    ///
    /// # Errors
    /// The one reason why the run failed.
    pub fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure> {
        match self {
            Self::Planar(own) => own.run(random, epistemic, row),
            Self::Spatial(own) => own.row(random, epistemic).map(|own| row.copy_from_slice(&own)),
        }
    }

    /// Runs on this thread until `next` gives no more inputs, all of them of the kind `variant`; `finished` gets the rows, or the one reason
    /// why a run failed, under the index that came with the inputs. A row has the same bits whatever the thread. Once `stop` is set, a life of
    /// wear ends as [`RunFailure::Stopped`].
    pub fn run_all_until<'i>(
        &self,
        variant: usize,
        execution: Execution,
        stop: &AtomicBool,
        mut next: impl FnMut() -> Option<(usize, &'i [f64], &'i [f64])>,
        mut finished: impl FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) {
        match self {
            Self::Planar(own) => {
                own.run_all_until(variant, execution, stop, next, finished);
            }
            Self::Spatial(own) => {
                while let Some((index, random, epistemic)) = next() {
                    finished(index, own.row(random, epistemic));
                }
            }
        }
    }
}

impl Response for StudyResponse {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        self.run(random, epistemic, columns).map_err(|failure| Failure(failure.number()))
    }
}
