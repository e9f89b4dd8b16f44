//! The steps of a plan with surrogates.

use super::confirm::Confirmation;
use super::learned::Learned;
use super::plan::{SurrogatePlan, SurrogatePlanError};
use super::reach::FIRST_REACH;
use super::results::SurrogateBounds;
use super::search::search_all;
use crate::data::table::SampleTable;

impl SurrogatePlan {
    /// Learns from the training runs in `table`.
    pub fn learn(&self, table: &SampleTable) -> Learned {
        Learned::new(self.problem(), &self.space, &self.settings, table)
    }

    /// The double loop on the surrogates, and the direct runs that its bounds are to be held against, as round `round`, without those
    /// that are in `table`.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn confirmation(
        &self,
        learned: &Learned,
        round: u32,
        table: &SampleTable,
    ) -> Result<Confirmation, SurrogatePlanError> {
        let searched = search_all(self, learned, |_| FIRST_REACH)?;
        Ok(Confirmation::new(self, searched, round, table))
    }

    /// Bounds from the surrogates without the treatments, with the runs of `confirmation` in `table`.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn results(
        &self,
        learned: Learned,
        confirmation: &Confirmation,
        table: &SampleTable,
    ) -> Result<SurrogateBounds, SurrogatePlanError> {
        SurrogateBounds::new(self, learned, confirmation, table)
    }
}
