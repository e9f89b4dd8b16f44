//! Deviation curves over the cycle with their bands.

use super::drawing::Pictures;
use super::material::Material;
use super::value_bands::value_bands;
use crate::file::Ask;
use crate::model::outputs::OutputSource;
use crate::question::CurveBand;
use crate::response::columns::BAND;
use loosepin_bounds::Statistic;
use loosepin_result::study::{CurveRange, DeviationCurve, PathCurve, PathError, SimultaneousCurve};

/// One curve for each ask for the whole cycle.
pub fn curves(material: &Material<'_>, pictures: &Pictures, bands: &[CurveBand]) -> Vec<DeviationCurve> {
    let asks = material.plan().asks.iter();
    asks.filter(|ask| ask.location.is_cycle()).map(|ask| curve(material, pictures, bands, ask)).collect()
}

fn curve(material: &Material<'_>, pictures: &Pictures, bands: &[CurveBand], ask: &Ask) -> DeviationCurve {
    let output = &material.plan().outputs[ask.output];
    let centre_inputs: Vec<f64> = material.study.epistemic.iter().map(|input| input.variable.middle()).collect();
    let mut curve = DeviationCurve {
        output: output.name.clone(),
        of: ask.deviation,
        unit: output.unit.clone(),
        probabilities: BAND,
        centre: material.witness(&centre_inputs),
        numerical_error_si: 0.0,
        confidence: None,
        pose_rad: Vec::new(),
        ideal_si: Vec::new(),
        nominal_si: Vec::new(),
        random: CurveRange::default(),
        mixed: CurveRange::default(),
        simultaneous: simultaneous(material, bands, ask),
        at_values: Vec::new(),
        path: path(material, ask),
    };
    for &column in &ask.columns {
        curve.pose_rad.push(material.point_of(column, true).pose_rad().unwrap_or(f64::NAN));
        curve.ideal_si.push(material.response.nominal_at_pose()[column]);
        curve.nominal_si.push(if ask.deviation.has_play() || ask.deviation.is_value() {
            pictures.nominal_row[column]
        } else {
            0.0
        });
        let random = BAND.map(|probability| material.central(column, Statistic::quantile_at(probability)));
        let [lower, upper] = random.map(|ends| ends.unwrap_or([f64::NAN; 2]));
        curve.random.lower_si.push(lower[0]);
        curve.random.upper_si.push(upper[1]);
        // A pose without a bound may be anywhere; it keeps its place among the others.
        let ends = BAND.map(|probability| material.ends_or_unknown(column, Statistic::quantile_at(probability)));
        let [[low, _], [_, high]] = &ends;
        curve.mixed.lower_si.push(low.widened_si);
        curve.mixed.upper_si.push(high.widened_si);
        let confidence = BAND.map(|probability| material.confidence(column, Statistic::quantile_at(probability)));
        curve.confidence = confidence.into_iter().chain(curve.confidence).min_by(f64::total_cmp);
        curve.numerical_error_si = curve.numerical_error_si.max(low.error.total_si()).max(high.error.total_si());
    }
    curve.at_values = value_bands(material, ask, &curve.mixed);
    curve
}

/// The ideal path, where an ask is for a distance from it.
fn path(material: &Material<'_>, ask: &Ask) -> Option<PathCurve> {
    let OutputSource::Path(readings, PathError::Normal | PathError::Contour) = material.plan().outputs[ask.output].seen
    else {
        return None;
    };
    let mut path = PathCurve::default();
    for &column in &ask.columns {
        let share = material.plan().columns[column].spot.pose()?.turns / material.response.recorded_turns();
        let [x, y] = material.response.ideal_jets(readings, share)?;
        path.x_m.push(x[0]);
        path.y_m.push(y[0]);
        let speed = (x[1] * x[1] + y[1] * y[1]).sqrt();
        path.tangent_x.push(x[1] / speed);
        path.tangent_y.push(y[1] / speed);
    }
    Some(path)
}

/// The bands for the whole curve that were asked for.
fn simultaneous(material: &Material<'_>, bands: &[CurveBand], ask: &Ask) -> Vec<SimultaneousCurve> {
    let of_share = |share: f64| {
        let own = bands.iter().find(|band| band.columns == ask.columns && band.share == share);
        let found = own.and_then(|own| own.found.as_ref());
        let ends = found.map_or_else(Vec::new, |found| (0..ask.columns.len()).map(|k| found.ends(k)).collect());
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
    ask.bands().map(of_share).collect()
}

#[cfg(test)]
mod tests {
    use super::curves;
    use crate::assemble::drawing;
    use crate::assemble::few_runs::FewRuns;

    #[test]
    fn a_pose_without_a_bound_keeps_its_place() {
        let runs = FewRuns::after(0);
        let columns = &runs.response.plan().asks[0].columns;
        let known: Vec<_> = runs.bounds.pairs.iter().filter(|pair| pair.column != columns[2]).cloned().collect();
        let ends = |pairs| {
            let material = runs.material(pairs);
            let curve = curves(&material, &drawing::pictures(&material), &[]).remove(0);
            assert_eq!(curve.pose_rad.len(), 6);
            curve.mixed.lower_si.into_iter().zip(curve.mixed.upper_si).collect::<Vec<_>>()
        };
        let mut whole = ends(&runs.bounds.pairs);
        assert!(whole.iter().all(|(lower, upper)| lower <= upper && upper.is_finite()), "{whole:?}");
        whole[2] = (f64::NEG_INFINITY, f64::INFINITY);
        assert_eq!(ends(&known), whole);
    }
}
