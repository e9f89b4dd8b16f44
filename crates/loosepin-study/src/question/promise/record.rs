//! The promise for a share of the box, and the requirements that it decides.

use super::promised::Promised;
use crate::assemble::Material;
use crate::file::Ask;
use loosepin_bounds::{PromisedBound, Request, SimultaneousBand};
use loosepin_result::study::{CurveRange, PromiseRecord, PromisedBand, PromisedEnd, RequirementOutcome, Side};

/// The promise as it is stored.
pub fn promise_record(material: &Material<'_>, promised: &Promised<'_>) -> PromiseRecord {
    let Promised { plan, ends, bands } = promised;
    let settings = plan.settings();
    PromiseRecord {
        share: settings.share,
        confidence: settings.confidence,
        boxes: plan.boxes() as u64,
        values: plan.values() as u64,
        inner: plan.inner() as u64,
        miss: plan.miss(),
        runs: plan.runs() as u64,
        ends: ends.iter().map(|bound| promised_end(material, bound)).collect(),
        bands: bands.iter().map(|(band, factor)| promised_band(material, band, factor)).collect(),
    }
}

fn promised_band(material: &Material<'_>, band: &SimultaneousBand, factor: &PromisedBound) -> PromisedBand {
    let column = factor.asked.request.column;
    let end = |sign: f64| {
        let ends = band.centres.iter().zip(&band.half_widths);
        ends.map(|(centre, half_width)| centre + sign * factor.bound * half_width).collect()
    };
    PromisedBand {
        output: material.name_of(column),
        of: material.plan().columns[column].deviation,
        share: band.share,
        factor: factor.bound,
        band: CurveRange { lower_si: end(-1.0), upper_si: end(1.0) },
        witness: material.witness(&factor.witness.epistemic),
        failed_values: factor.failed_values as u64,
    }
}

fn promised_end(material: &Material<'_>, found: &PromisedBound) -> PromisedEnd {
    let Request { column, statistic } = found.asked.request;
    let is_in = |ask: &&Ask| ask.columns.contains(&column);
    let in_curve = material.plan().asks.iter().find(is_in).is_some_and(|ask| ask.location.is_cycle());
    PromisedEnd {
        output: material.name_of(column),
        of: material.plan().columns[column].deviation,
        at: material.point_of(column, in_curve),
        statistic,
        unit: material.unit_of_statistic(column, statistic),
        side: found.asked.side,
        bound_si: found.bound,
        witness: material.witness(&found.witness.epistemic),
        failed_values: found.failed_values as u64,
    }
}

/// Gives the requirements that a promise decides their verdicts, in the order of the plan.
pub fn decide(material: &Material<'_>, found: &[PromisedBound], outcomes: &mut [RequirementOutcome]) {
    debug_assert_eq!(material.plan().required().count(), outcomes.len());
    let places = material.plan().required().zip(outcomes);
    for ((required, column), outcome) in places.filter(|((required, _), _)| required.is_promised) {
        let request = Request { column, statistic: required.limit.broken() };
        let bound = found.iter().find(|bound| bound.asked.request == request && bound.asked.side == Side::Upper);
        let least = bound.map_or(0.0, |bound| 1.0 - bound.bound);
        outcome.promised = Some(least);
        outcome.failed_values = bound.map_or(0, |bound| bound.failed_values as u64);
        outcome.verdict = outcome.verdict.by_promise(least >= outcome.probability_at_least);
    }
}
