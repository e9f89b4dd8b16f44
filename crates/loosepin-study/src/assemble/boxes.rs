//! Probability boxes.

use super::material::Material;
use crate::file::Where;
use loosepin_bounds::Bound;
use loosepin_result::study::{ProbabilityBox, Statistic};

/// The distribution functions of single numbers.
pub fn boxes(material: &Material<'_>) -> Vec<ProbabilityBox> {
    let asked = |column: usize| {
        material.plan().asks.iter().any(|planned| {
            planned.columns.contains(&column) && planned.ask.statistics.contains(&Statistic::Cdf)
                || planned.ask.location != Where::Cycle && planned.columns.contains(&column)
        })
    };
    material
        .bounds
        .boxes
        .iter()
        .filter(|found| asked(found.column))
        .map(|found| {
            let column = found.column;
            let limits = material.plan().asks.iter().filter(|planned| planned.columns.contains(&column));
            let limit_si = limits.flat_map(|planned| &planned.ask.statistics).find_map(|statistic| match statistic {
                Statistic::ProbabilityAbove(limit)
                | Statistic::ProbabilityBelow(limit)
                | Statistic::ProbabilityBeyond(limit) => Some(*limit),
                _ => None,
            });
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
