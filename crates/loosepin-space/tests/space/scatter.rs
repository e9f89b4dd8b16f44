//! What random dimensions do to outputs over a turn, against the derivatives of closed forms.

use loosepin_space::{SpatialModel, SpatialScatterPlan};
use loosepin_text::numbers::QuantityId;

const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

/// Paths of crank, coupler and rocker lengths in the file, their values and standard deviations, m.
const LENGTHS: [(&str, f64, f64); 3] = [
    ("body.crank.points.pin.x", 0.05, 20e-6),
    ("body.coupler.points.rocker.x", 0.25, 40e-6),
    ("body.rocker.points.ball.z", 0.12, 30e-6),
];

/// Angle of the rocker of the RSSR four-bar, rad: ψ = atan2(Q, P) + acos(S/√(P² + Q²)) with D = O2 - B, P = 2k D·e2, Q = 2k D·(a2×e2),
/// S = L² - k² - D·D (space.md 4 (b)).
fn rocker_rad([crank, coupler, rocker]: [f64; 3], crank_rad: f64) -> f64 {
    let (a2, e2) = ([0.6, 0.8, 0.0], [0.0, 0.0, 1.0]);
    let b = [crank * crank_rad.cos(), crank * crank_rad.sin(), 0.0];
    let d = [0.22 - b[0], 0.04 - b[1], 0.06 - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = [a2[1] * e2[2] - a2[2] * e2[1], a2[2] * e2[0] - a2[0] * e2[2], a2[0] * e2[1] - a2[1] * e2[0]];
    let (p, q) = (2.0 * rocker * dot(d, e2), 2.0 * rocker * dot(d, cross));
    let s = coupler * coupler - rocker * rocker - dot(d, d);
    q.atan2(p) + (s / p.hypot(q)).acos()
}

/// The derivative of the closed form by a length, by Richardson's extrapolation.
fn derivative(number: usize, crank_rad: f64) -> f64 {
    let slope = |step: f64| {
        let at = |side: f64| {
            let mut lengths = LENGTHS.map(|(_, value, _)| value);
            lengths[number] += side * step;
            rocker_rad(lengths, crank_rad)
        };
        (at(1.0) - at(-1.0)) / (2.0 * step)
    };
    (4.0 * slope(1e-4) - slope(2e-4)) / 3.0
}

fn model() -> (SpatialModel, Vec<(QuantityId, f64)>) {
    let model = SpatialModel::from_text("model.toml", FOUR_BAR).unwrap_or_else(|found| panic!("{found}"));
    let quantities = LENGTHS.map(|(path, _, deviation)| (model.quantities.id(path).unwrap(), deviation));
    (model, quantities.to_vec())
}

#[test]
fn analytic_scatter_of_a_four_bar_with_two_balls_is_that_of_its_closed_form() {
    let (model, quantities) = model();
    let plan = SpatialScatterPlan { quantities, ..SpatialScatterPlan::default() };
    let found = model.scatter_until(&plan, &|| false).unwrap_or_else(|found| panic!("{found}"));
    let scatter = &found[0];
    assert_eq!(scatter.standard_deviation_si.len(), 37);
    for (position, found) in scatter.standard_deviation_si.iter().enumerate() {
        let crank_rad = (10.0 * position as f64).to_radians();
        let effects = [0, 1, 2].map(|number| derivative(number, crank_rad) * LENGTHS[number].2);
        let expected = effects.iter().map(|own| own * own).sum::<f64>().sqrt();
        assert!((found - expected).abs() < 1e-7 * expected, "{position}: {found} {expected}");
        for (own, effect) in scatter.contributors.iter().zip(effects) {
            let found = own.standard_deviation_si[position];
            assert!((found - effect.abs()).abs() < 1e-7 * expected, "{position}: {found} {effect}");
        }
    }
}

#[test]
fn analytic_correlations_join_the_effects_with_their_signs() {
    let (model, quantities) = model();
    let plan = SpatialScatterPlan { quantities, correlations: vec![(1, 2, -0.8)], set: Vec::new() };
    let scatter = &model.scatter_until(&plan, &|| false).unwrap_or_else(|found| panic!("{found}"))[0];
    for position in [0, 7, 20] {
        let crank_rad = (10.0 * f64::from(position)).to_radians();
        let [crank, coupler, rocker] = [0, 1, 2].map(|number| derivative(number, crank_rad) * LENGTHS[number].2);
        let variance = crank * crank + coupler * coupler + rocker * rocker - 2.0 * 0.8 * coupler * rocker;
        let found = scatter.standard_deviation_si[position as usize];
        assert!((found - variance.sqrt()).abs() < 1e-7 * variance.sqrt(), "{position}: {found}");
    }
}

#[test]
fn values_that_are_set_are_those_about_which_it_scatters() {
    let (model, quantities) = model();
    let longer = 0.27;
    let set = vec![(quantities[1].0, longer)];
    let plan = SpatialScatterPlan { quantities: quantities[..1].to_vec(), set, correlations: Vec::new() };
    let scatter = &model.scatter_until(&plan, &|| false).unwrap_or_else(|found| panic!("{found}"))[0];
    let at = |side: f64| rocker_rad([0.05 + side * 1e-6, longer, 0.12], 0.5_f64.to_radians() * 20.0);
    let expected = ((at(1.0) - at(-1.0)) / 2e-6 * LENGTHS[0].2).abs();
    let found = scatter.standard_deviation_si[1];
    assert!((found - expected).abs() < 1e-6 * expected, "{found} {expected}");
}

#[test]
fn a_drive_whose_start_scatters_has_no_answer() {
    let (model, _) = model();
    let start = model.quantities.id("drive.crank.start_angle").unwrap();
    let plan = SpatialScatterPlan { quantities: vec![(start, 1e-3)], ..SpatialScatterPlan::default() };
    let found = model.scatter_until(&plan, &|| false).unwrap_err().to_string();
    assert!(found.contains("drive 'crank'") && found.contains("model.toml:"), "{found}");
}
