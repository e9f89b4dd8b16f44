//! Probability boxes.

use super::material::Material;
use crate::file::Ask;
use loosepin_bounds::{Bound, Event, Statistic};
use loosepin_result::study::ProbabilityBox;

/// The distribution functions of single numbers.
pub fn boxes(material: &Material<'_>) -> Vec<ProbabilityBox> {
    let asked = |column: usize| {
        material.plan().asks.iter().any(|ask| {
            let is_shown = !ask.location.is_cycle();
            let is_stated = || ask.statistics().any(Statistic::is_distribution_function);
            ask.columns.contains(&column) && (is_shown || is_stated())
        })
    };
    material
        .bounds
        .boxes
        .iter()
        .filter(|found| asked(found.column))
        .map(|found| {
            let column = found.column;
            let limits = material.plan().asks.iter().filter(|ask| ask.columns.contains(&column));
            let events = limits.flat_map(Ask::statistics).filter_map(Statistic::event);
            let limit_si = events.map(Event::limit).next();
            // The search error of a single share is larger where the curve is steep: there it belongs to the size, not to the
            // share.
            let error = |bound: &Bound| bound.error.sampling;
            ProbabilityBox {
                output: material.name_of(column),
                of: material.plan().columns[column].deviation,
                at: material.point_of(column, false),
                unit: material.unit_of(column),
                probability_only: found.probability_only.clone().unwrap_or_default(),
                value_si: found.values.clone(),
                lower: found.lower.iter().map(|bound| bound.value).collect(),
                upper: found.upper.iter().map(|bound| bound.value).collect(),
                limit_si,
                numerical_error: found
                    .lower
                    .iter()
                    .chain(&found.upper)
                    .map(error)
                    .fold(found.probability_only_error, f64::max),
            }
        })
        .collect()
}
