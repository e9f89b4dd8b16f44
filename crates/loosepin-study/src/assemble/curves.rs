//! Deviation curves over the cycle with their bands.

use super::drawing::Pictures;
use super::material::Material;
use super::summary::centre_point;
use crate::columns::{BAND, PlannedAsk};
use crate::file::{Deviation, Where};
use crate::simultaneous::CurveBand;
use loosepin_bounds::{Purpose, Statistic};
use loosepin_result::study::{CurveRange, DeviationCurve, SimultaneousCurve};

/// One curve for each ask for the whole cycle.
pub fn curves(material: &Material<'_>, pictures: &Pictures, bands: &[CurveBand]) -> Vec<DeviationCurve> {
    let asks = material.plan().asks.iter();
    asks.filter(|planned| planned.ask.location == Where::Cycle)
        .map(|planned| curve(material, pictures, bands, planned))
        .collect()
}

fn curve(material: &Material<'_>, pictures: &Pictures, bands: &[CurveBand], planned: &PlannedAsk) -> DeviationCurve {
    let output = &material.plan().outputs[planned.output];
    let centre = centre_point(material);
    let centre_inputs: Vec<f64> = material.study.epistemic.iter().map(|input| input.variable.middle()).collect();
    let mut curve = DeviationCurve {
        output: output.name.clone(),
        of: planned.ask.deviation,
        unit: output.unit.clone(),
        probabilities: BAND,
        centre: material.witness(&centre_inputs),
        numerical_error_si: 0.0,
        pose_rad: Vec::new(),
        ideal_si: Vec::new(),
        nominal_si: Vec::new(),
        random: CurveRange::default(),
        mixed: CurveRange::default(),
        simultaneous: simultaneous(material, bands, planned),
    };
    for &column in &planned.columns {
        curve.pose_rad.push(material.point_of(column, true).pose_rad().unwrap_or(f64::NAN));
        curve.ideal_si.push(material.response.shared.nominal_at_pose[column]);
        curve.nominal_si.push(match planned.ask.deviation {
            Deviation::Dimensional => 0.0,
            _ => pictures.nominal_row[column],
        });
        let [lower, upper] = centre.map_or([f64::NAN; 2], |point| random_band(material, column, point));
        curve.random.lower_si.push(lower);
        curve.random.upper_si.push(upper);
        let mixed = [0, 1].map(|end| material.ends(column, Statistic::Quantile(BAND[end])));
        if let [Some([low, _]), Some([_, high])] = mixed {
            curve.mixed.lower_si.push(low.widened_si);
            curve.mixed.upper_si.push(high.widened_si);
            curve.numerical_error_si = curve.numerical_error_si.max(low.error.total_si()).max(high.error.total_si());
        }
    }
    curve
}

/// The bands for the whole curve that were asked for.
fn simultaneous(material: &Material<'_>, bands: &[CurveBand], planned: &PlannedAsk) -> Vec<SimultaneousCurve> {
    let of_share = |&share: &f64| {
        let own = bands.iter().find(|band| band.columns == planned.columns && band.share == share);
        let found = own.and_then(|own| own.found.as_ref());
        let ends = found.map_or_else(Vec::new, |found| (0..planned.columns.len()).map(|k| found.ends(k)).collect());
        SimultaneousCurve {
            share,
            factor: found.map_or(f64::NAN, |found| found.factor.widened.max(1.0)),
            witness: found
                .and_then(|found| found.factor.witness.as_ref())
                .map(|witness| material.witness(&witness.epistemic))
                .unwrap_or_default(),
            band: CurveRange {
                lower_si: ends.iter().map(|[lower, _]| lower.widened).collect(),
                upper_si: ends.iter().map(|[_, upper]| upper.widened).collect(),
            },
        }
    };
    planned.ask.simultaneous_bands.iter().map(of_share).collect()
}

/// Quantiles of the scatter at one value of the epistemic inputs.
fn random_band(material: &Material<'_>, column: usize, point: u32) -> [f64; 2] {
    let table = material.table;
    let mut values: Vec<f64> = table
        .inputs()
        .iter()
        .enumerate()
        .filter(|(_, inputs)| inputs.purpose == Purpose::DoubleLoop && inputs.point == point)
        .map(|(run, _)| table.values(run)[column])
        .filter(|value| value.is_finite())
        .collect();
    values.sort_by(f64::total_cmp);
    if values.is_empty() {
        return [f64::NAN; 2];
    }
    BAND.map(|probability| {
        let rank = (probability * values.len() as f64).ceil() as usize;
        values[rank.clamp(1, values.len()) - 1]
    })
}
