//! Bands in which a share of mechanisms stays for the whole cycle.

use crate::assemble::Material;
use crate::response::columns::pointwise_ends;
use loosepin_bounds::{DoubleLoop, PlanError, SimultaneousBand};

/// A band for the columns of a curve.
#[derive(Debug)]
pub struct CurveBand {
    /// The columns, pose by pose.
    pub columns: Vec<usize>,
    /// The share that was asked for.
    pub share: f64,
    /// Whether it is promised for a share of the box too.
    pub is_promised: bool,
    /// The band; `None` if the ends at some pose are not finite, or nothing differs from run to run.
    pub found: Option<SimultaneousBand>,
}

/// Every band that was asked for. Its form is that of the band of the same share at each pose by itself, numerical error included.
///
/// # Errors
///
/// [`PlanError`] where the table lacks runs.
pub fn curve_bands(material: &Material<'_>, plan: &DoubleLoop) -> Result<Vec<CurveBand>, PlanError> {
    let asks = material.response.plan().asks.iter();
    let asked = asks.flat_map(|ask| ask.bands().map(move |share| (ask, share)));
    asked
        .map(|(ask, share)| {
            let shape = ask.columns.iter().map(|&column| {
                let [lower, upper] = pointwise_ends(share).map(|statistic| material.ends(column, statistic));
                Some([lower?[0].widened_si, upper?[1].widened_si])
            });
            let shape: Option<Vec<[f64; 2]>> = shape.collect();
            let found = match shape {
                Some(shape) => plan.simultaneous_band(material.table, &ask.columns, &shape, share)?,
                None => None,
            };
            let is_promised = !ask.promised.is_empty();
            Ok(CurveBand { columns: ask.columns.clone(), share, is_promised, found })
        })
        .collect()
}
