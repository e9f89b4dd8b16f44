//! Spectra over orders of the drive, against the series of a slider-crank and against waves of known amplitude.

use crate::elements::build;
use loosepin_simulate::{Plan, record::SimulationRecord, simulate, spectrum_csv};

/// A slider-crank without play: λ = r/l = 1/4, ω = 100 rad/s.
const SLIDER_CRANK: &str = r#"
name = "slider-crank"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.crank]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["40 mm", "0 mm"] }
[body.rod]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["80 mm", "0 mm"]
points = { big_end = ["0 mm", "0 mm"], small_end = ["160 mm", "0 mm"] }
[body.slider]
mass = "0.1 kg"
inertia = "1e-5 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = { pin = ["0 mm", "0 mm"] }
[joint]
main = { kind = "revolute", bearing = "ground.o", journal = "crank.main" }
crank_pin = { kind = "revolute", bearing = "crank.pin", journal = "rod.big_end" }
gudgeon = { kind = "revolute", bearing = "rod.small_end", journal = "slider.pin" }
guide = { kind = "prismatic", guide = { point = "ground.o", angle = "0 deg" }, slider = "slider.pin" }
[drive.crank]
joint = "main"
speed = "100 rad/s"
start_angle = "30 deg"
[assembly]
guess = { rod = "0 deg" }
[cycle]
drive = "crank"
recorded_turns = 2
samples_per_turn = 200
[output]
slider = { acceleration_of = "slider.pin", along = "x" }
crank = { angle_of = "crank" }
"#;

fn record() -> SimulationRecord {
    let built = build(SLIDER_CRANK);
    simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect("it turns").record
}

/// ẍ = -r ω² (cos θ + A₂ cos 2θ - A₄ cos 4θ + A₆ cos 6θ - ...), the series of the theory of engine balance.
#[test]
fn published_orders_of_a_slider_crank() {
    const LAMBDA: f64 = 0.25;
    const SIZE_M_S2: f64 = 0.04 * 100.0 * 100.0;
    /// What the series leave out is of the order λ⁷.
    const LEFT_OUT: f64 = 1e-5;
    let record = record();
    let spectrum = record.spectrum(&record.outputs[0].value_si).expect("two turns");
    assert_eq!(spectrum.orders[..4], [0.5, 1.0, 1.5, 2.0], "two turns tell half orders apart");
    let at = |order: f64| {
        let place = spectrum.orders.iter().position(|own| *own == order).expect("an order");
        spectrum.amplitudes_si[place] / SIZE_M_S2
    };
    let second = LAMBDA + LAMBDA.powi(3) / 4.0 + 15.0 * LAMBDA.powi(5) / 128.0;
    let fourth = LAMBDA.powi(3) / 4.0 + 3.0 * LAMBDA.powi(5) / 16.0;
    let sixth = 9.0 * LAMBDA.powi(5) / 128.0;
    for (order, due) in [(1.0, 1.0), (2.0, second), (4.0, fourth), (6.0, sixth)] {
        assert!((at(order) - due).abs() < LEFT_OUT, "order {order}: {} {due}", at(order));
    }
    for order in [0.5, 1.5, 3.0, 5.0, 20.0] {
        assert!(at(order) < 1e-9, "order {order}: {}", at(order));
    }
    let dominant: Vec<f64> = spectrum.dominant(3).into_iter().map(|(order, _)| order).collect();
    assert_eq!(dominant, [1.0, 2.0], "the fourth has less than a hundredth of the first");
    assert!(spectrum.mean_si.abs() < 1e-9 * SIZE_M_S2);
    // Parseval's theorem.
    let squares: f64 = spectrum.amplitudes_si.iter().map(|amplitude| amplitude * amplitude).sum();
    assert!((spectrum.rms_si - (0.5 * squares).sqrt()).abs() < 1e-9 * SIZE_M_S2);
    let csv = spectrum_csv(&record).expect("a drive turns");
    assert!(csv.starts_with("order,slider_m_s2\n0.5,"), "a shaft's angle runs away: {}", &csv[..60]);
    assert_eq!(csv.lines().count(), 1 + 120, "up to order 60 by halves");
}

#[test]
fn analytic_waves_have_their_amplitudes() {
    let record = record();
    let wave = |waves_a_turn: f64, phase: f64| {
        let at = move |k: usize| (std::f64::consts::TAU * waves_a_turn * k as f64 / 200.0 + phase).cos();
        (0..=400).map(at).collect::<Vec<f64>>()
    };
    let (slow, fast) = (wave(2.5, 0.3), wave(31.0, -1.0));
    let values: Vec<f64> = slow.iter().zip(&fast).map(|(slow, fast)| 3.0 + 0.7 * slow + 0.2 * fast).collect();
    let spectrum = record.spectrum(&values).expect("two turns");
    for (order, amplitude) in spectrum.orders.iter().zip(&spectrum.amplitudes_si) {
        let due = if *order == 2.5 {
            0.7
        } else if *order == 31.0 {
            0.2
        } else {
            0.0
        };
        assert!((amplitude - due).abs() < 1e-13, "order {order}: {amplitude}");
    }
    assert!((spectrum.mean_si - 3.0).abs() < 1e-14);
    assert!((spectrum.rms_si - (9.0_f64 + 0.5 * (0.49 + 0.04)).sqrt()).abs() < 1e-13);
    assert_eq!(record.spectrum(&[1.0; 100]), None, "no whole turn");
    let mut uneven = record.clone();
    uneven.settings.samples_per_turn = 198;
    assert_eq!(uneven.spectrum(&values), None, "the turn is no whole number of samples");
    let mut broken = values;
    broken[250] = f64::NAN;
    assert_eq!(record.spectrum(&broken), None);
}
