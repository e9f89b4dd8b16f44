//! The three treatments side by side.

use super::material::Material;
use crate::without_runs::proven_ends::proven_ends_si;
use loosepin_bounds::{Band, SurrogateBounds, SurrogatePlan};
use loosepin_result::study::{CoveragePoint, TreatmentBand, TreatmentComparison, TreatmentEnd};

/// The treatments of the direct runs.
pub fn treatments(material: &Material<'_>) -> Vec<TreatmentComparison> {
    let points = [material.bounds.outer_points.as_slice(); 3];
    let comparisons = &material.bounds.comparisons;
    let records = comparisons.iter().map(|comparison| treatment_record(material, comparison, points)).collect();
    let columns: Vec<usize> = comparisons.iter().map(|comparison| comparison.column).collect();
    with_proven_ends(material, records, &columns)
}

/// The records of `columns` with what is proven of each without dynamics.
fn with_proven_ends(
    material: &Material<'_>,
    mut records: Vec<TreatmentComparison>,
    columns: &[usize],
) -> Vec<TreatmentComparison> {
    let proven = proven_ends_si(material.study, material.plan(), columns);
    for (record, ends_si) in records.iter_mut().zip(proven) {
        record.proven_without_dynamics_si = ends_si;
    }
    records
}

/// The three treatments by surrogates that stand alone, with what is proven without dynamics.
pub fn treatments_by_surrogates_alone(
    material: &Material<'_>,
    plan: &SurrogatePlan,
    found: &SurrogateBounds,
) -> Vec<TreatmentComparison> {
    let (records, columns): (Vec<_>, Vec<usize>) = learned(material, plan, found).unzip();
    with_proven_ends(material, records, &columns)
}

/// The three treatments by surrogates beside those of direct runs.
pub fn learned_treatments(
    material: &Material<'_>,
    plan: &SurrogatePlan,
    found: &SurrogateBounds,
) -> Vec<TreatmentComparison> {
    learned(material, plan, found).map(|(record, _)| record).collect()
}

/// Each treatment with its column, in the order of the compared columns.
fn learned(
    material: &Material<'_>,
    plan: &SurrogatePlan,
    found: &SurrogateBounds,
) -> impl Iterator<Item = (TreatmentComparison, usize)> {
    let of_column = move |column: &usize| {
        let mut groups = found.groups.iter().filter_map(|group| group.treatments.as_ref());
        let (points, learned) = groups.find_map(|of| {
            let own = of.comparisons.iter().find(|learned| learned.comparison.column == *column)?;
            Some((of.outer_points.each_ref().map(Vec::as_slice), own))
        })?;
        let comparison = &learned.comparison;
        let mut record = treatment_record(material, comparison, points);
        for (record, unknown) in record.bands.iter_mut().zip(learned.coverage_surrogate) {
            record.coverage_error += unknown;
            record.is_by_surrogate = true;
        }
        Some((record, *column))
    };
    plan.problem().compared_columns.iter().filter_map(of_column)
}

fn treatment_record(
    material: &Material<'_>,
    comparison: &loosepin_bounds::TreatmentComparison,
    outer_points: [&[Vec<f64>]; 3],
) -> TreatmentComparison {
    let column = comparison.column;
    let bands = [&comparison.probability_only, &comparison.interval_only, &comparison.mixed];
    TreatmentComparison {
        output: material.name_of(column),
        of: material.plan().columns[column].deviation,
        at: material.point_of(column, false),
        unit: material.unit_of(column),
        promised_coverage: comparison.probability,
        bands: bands
            .into_iter()
            .zip(outer_points)
            .map(|(band, points)| treatment_band(material, column, band, points))
            .collect(),
        proven_without_dynamics_si: None,
    }
}

fn treatment_band(material: &Material<'_>, column: usize, band: &Band, outer_points: &[Vec<f64>]) -> TreatmentBand {
    let [lower, upper] = [&band.lower, &band.upper].map(|end| material.end_of_values(column, end));
    TreatmentBand {
        treatment: band.treatment,
        lower_si: lower.value_si,
        upper_si: upper.value_si,
        coverage_minimum: band.coverage.minimum,
        coverage_maximum: band.coverage.maximum,
        coverage_error: band.coverage.minimum_error,
        coverage_at: band
            .coverage
            .points
            .iter()
            .map(|point| CoveragePoint {
                at: material.witness(&outer_points[point.point as usize]),
                coverage: point.lower,
            })
            .collect(),
        ends: Some([lower, upper].map(|end| TreatmentEnd { widened_si: end.widened_si, error: end.error })),
        is_by_surrogate: false,
    }
}
