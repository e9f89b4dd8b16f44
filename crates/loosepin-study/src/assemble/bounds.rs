//! Bounds as they are stored: those asked for, at every degree of possibility, as percentiles, and bands for whole curves.

use super::coherent::{nest_cuts, nest_readings, order_percentiles};
use super::material::Material;
use crate::question::CurveBand;
use loosepin_bounds::{BoundPair, Bounds, Percentile};
use loosepin_result::study::{BoundEnd, BoundRecord, CutBounds, Guarantee, PercentileBounds, Statistic, Treatment};

/// The bounds at every degree of possibility.
pub fn cuts(material: &Material<'_>) -> Vec<CutBounds> {
    let of_level = |level: &loosepin_bounds::CutBounds| {
        Some(CutBounds { alpha: level.alpha?, bounds: asked_bounds(&material.with_pairs(&level.pairs)) })
    };
    let mut cuts: Vec<CutBounds> = material.bounds.levels.iter().filter_map(of_level).collect();
    nest_cuts(&mut cuts);
    cuts
}

/// The percentiles of every statistic that was asked for.
pub fn percentiles(material: &Material<'_>) -> Vec<PercentileBounds> {
    let found = &material.bounds.percentiles;
    let probabilities: Vec<f64> =
        found.first().map_or_else(Vec::new, |first| first.percentiles.iter().map(|each| each.probability).collect());
    let of_percentile = |(place, &percentile): (usize, &f64)| {
        let pair = |pair: &BoundPair| {
            let same = found.iter().find(|each| each.column == pair.column && each.statistic == pair.statistic)?;
            let Percentile { lower, upper, .. } = same.percentiles[place].clone();
            Some(BoundPair { lower, upper, ..pair.clone() })
        };
        let pairs: Vec<BoundPair> = material.pairs.iter().filter_map(pair).collect();
        PercentileBounds { percentile, bounds: asked_bounds(&material.with_pairs(&pairs)) }
    };
    let mut percentiles: Vec<PercentileBounds> = probabilities.iter().enumerate().map(of_percentile).collect();
    order_percentiles(&mut percentiles);
    percentiles
}

/// Every bound that was asked for, in the order of the asks; within a curve pose by pose.
pub fn asked_bounds(material: &Material<'_>) -> Vec<BoundRecord> {
    let mut records = Vec::new();
    for ask in &material.plan().asks {
        let in_curve = ask.location.is_cycle();
        for &column in &ask.columns {
            // Distribution functions have their own place; what else has no bound may be anything.
            let statistics = ask.statistics().filter(|statistic| statistic.is_single());
            records.extend(statistics.map(|statistic| asked_bound(material, column, in_curve, statistic)));
        }
    }
    records
}

/// The bound of a statistic of a column: by the method that was asked for, else as it was counted.
fn asked_bound(material: &Material<'_>, column: usize, in_curve: bool, statistic: Statistic) -> BoundRecord {
    let by_method = material.rare.iter().find(|rare| rare.column == column && rare.statistic == statistic);
    let ends = match by_method {
        Some(rare) => rare.bounds.each_ref().map(|bound| material.end(bound)),
        None => material.ends_or_unknown(column, statistic),
    };
    let of_pair = material.pair(column, statistic).filter(|_| by_method.is_none_or(|rare| rare.is_confirmed));
    let guarantee = of_pair.map_or(Guarantee::unconfirmed(), BoundPair::guarantee);
    let guarantee = guarantee.with_confidence(|| material.confidence(column, statistic));
    record(material, (column, in_curve), statistic, ends, guarantee)
}

/// A bound as it is stored: here, and nowhere else, the numbers of a column get their names.
fn record(
    material: &Material<'_>,
    (column, in_curve): (usize, bool),
    statistic: Statistic,
    [lower, upper]: [BoundEnd; 2],
    guarantee: Guarantee,
) -> BoundRecord {
    BoundRecord {
        output: material.name_of(column),
        of: material.plan().columns[column].deviation,
        at: material.point_of(column, in_curve),
        statistic,
        treatment: Treatment::of_bounds(),
        reading: material.bounds.reading,
        unit: material.unit_of_statistic(column, statistic),
        lower,
        upper,
        guarantee,
    }
}

/// Every bound: those asked for, bands for whole curves, then those asked for by each of the other readings.
pub fn all_bounds(material: &Material<'_>, curve_bands: &[CurveBand], beside: &[Bounds]) -> Vec<BoundRecord> {
    let by_other_reading = |bounds: &Bounds| asked_bounds(&Material { bounds, ..material.with_pairs(&bounds.pairs) });
    let mut by_reading: Vec<Vec<BoundRecord>> =
        [asked_bounds(material)].into_iter().chain(beside.iter().map(by_other_reading)).collect();
    nest_readings(&mut by_reading);
    let mut by_reading = by_reading.into_iter();
    let mut records = by_reading.next().unwrap_or_default();
    records.extend(simultaneous_bounds(material, curve_bands));
    records.extend(by_reading.flatten());
    records
}

/// The bands for whole curves, pose by pose.
fn simultaneous_bounds(material: &Material<'_>, bands: &[CurveBand]) -> Vec<BoundRecord> {
    let of_band = |band: &CurveBand| -> Vec<BoundRecord> {
        let Some(found) = &band.found else { return Vec::new() };
        let at_pose = |(place, &column): (usize, &usize)| {
            let ends = found.ends(place).map(|bound| material.end(&bound));
            record(material, (column, true), Statistic::band_of_curve(band.share), ends, found.guarantee())
        };
        band.columns.iter().enumerate().map(at_pose).collect()
    };
    bands.iter().flat_map(of_band).collect()
}
