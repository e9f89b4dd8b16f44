//! Bounds as they are stored: those asked for, at every degree of possibility, as percentiles, and bands for whole curves.

use super::coherent::{nest_cuts, nest_readings, order_percentiles};
use super::material::{Material, unknown_ends};
use crate::file::Where;
use crate::question::CurveBand;
use loosepin_bounds::{BoundPair, Bounds, Percentile};
use loosepin_result::study::{BoundRecord, CutBounds, Guarantee, PercentileBounds, Statistic, Treatment};
use loosepin_text::units::SiUnit;

/// The bounds at every degree of possibility.
pub fn cuts(material: &Material<'_>) -> Vec<CutBounds> {
    let of_level = |level: &loosepin_bounds::CutBounds| {
        // What was estimated for all that is possible says nothing of a degree: there the runs are counted.
        let bounds = asked_bounds(&Material { pairs: &level.pairs, rare: &[], ..*material });
        Some(CutBounds { alpha: level.alpha?, bounds })
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
        let bounds = asked_bounds(&Material { pairs: &pairs, rare: &[], ..*material });
        PercentileBounds { percentile, bounds }
    };
    let mut percentiles: Vec<PercentileBounds> = probabilities.iter().enumerate().map(of_percentile).collect();
    order_percentiles(&mut percentiles);
    percentiles
}

/// Every bound that was asked for, in the order of the asks; within a curve pose by pose.
pub fn asked_bounds(material: &Material<'_>) -> Vec<BoundRecord> {
    let mut records = Vec::new();
    for planned in &material.plan().asks {
        let in_curve = planned.ask.location == Where::Cycle;
        for &column in &planned.columns {
            for &asked in &planned.ask.statistics {
                // Distribution functions have their own place; what else has no bound may be anything.
                if !asked.is_single() {
                    continue;
                }
                let promised = match material.pair(column, asked).map_or(Guarantee::Inner, BoundPair::guarantee) {
                    Guarantee::Sampled { .. } => Guarantee::Sampled { confidence: material.confidence(column, asked) },
                    other => other,
                };
                let [mut lower, mut upper] = material.ends(column, asked).unwrap_or_else(|| unknown_ends(asked));
                let rare = material.rare.iter().find(|rare| rare.column == column && rare.statistic == asked);
                if let Some(rare) = rare {
                    [lower, upper] = rare.bounds.each_ref().map(|bound| material.end(bound));
                }
                let unit = if asked.is_probability() { SiUnit::NONE } else { material.unit_of(column) };
                records.push(BoundRecord {
                    output: material.name_of(column),
                    of: planned.ask.deviation,
                    at: material.point_of(column, in_curve),
                    statistic: asked,
                    treatment: Treatment::Mixed,
                    reading: material.bounds.reading,
                    unit,
                    lower,
                    upper,
                    guarantee: if rare.is_some_and(|rare| !rare.is_confirmed) { Guarantee::Inner } else { promised },
                });
            }
        }
    }
    records
}

/// Every bound: those asked for, bands for whole curves, then those asked for by each of the other readings.
pub fn all_bounds(material: &Material<'_>, curve_bands: &[CurveBand], beside: &[Bounds]) -> Vec<BoundRecord> {
    let by_other_reading = |bounds: &Bounds| {
        // What was estimated otherwise than by counting belongs to the first reading.
        asked_bounds(&Material { bounds, pairs: &bounds.pairs, rare: &[], ..*material })
    };
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
        let record = |(place, &column): (usize, &usize)| {
            let [lower, upper] = found.ends(place).map(|bound| material.end(&bound));
            BoundRecord {
                output: material.name_of(column),
                of: material.plan().columns[column].deviation,
                at: material.point_of(column, true),
                statistic: Statistic::band_of_curve(band.share),
                treatment: Treatment::Mixed,
                reading: material.bounds.reading,
                unit: material.unit_of(column),
                lower,
                upper,
                guarantee: found.guarantee(),
            }
        };
        band.columns.iter().enumerate().map(record).collect()
    };
    bands.iter().flat_map(of_band).collect()
}
