//! Whole runs against histories of another program: joint coordinates, the same shapes, DOP853 at 1e-11. `cases/flexible_slider_crank` and
//! `cases/flexible_four_bar` hold the histories of two machines with play.

use super::case_text;
use crate::elements::{Built, build, file};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Plan, Settings, simulate};

/// A run that is tighter than usual.
fn record(built: &Built) -> SimulationRecord {
    let plan = Plan {
        settings: Settings { tolerance_m: 2e-11, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

/// Onsets, speeds and peaks of the first contacts. The peaks of the histories are the largest forces at the ends of steps: up to 5e-6 lower
/// than the greatest within one.
#[test]
fn peer_contacts_of_two_mechanisms_with_flexible_links() {
    let slider_crank = [
        [2.85080111979e-4, 1.2517675, 3880.635],
        [3.55403147e-4, 0.1807218, 2884.442],
        [9.53447685e-4, 1.7282571, 5935.294],
        [1.092628494e-3, 2.1672000, 5110.366],
    ];
    let four_bar = [
        [9.94134537630e-4, 0.4082844, 1355.225],
        [1.810120962e-3, 0.4549017, 668.296],
        [2.475701649e-3, 0.3791165, 649.932],
    ];
    let known = [("flexible_slider_crank", "10 ms", &slider_crank[..]), ("flexible_four_bar", "20 ms", &four_bar[..])];
    for (name, duration, known) in known {
        let short = case_text(name).replace(&format!("duration = \"{duration}\""), "duration = \"2.6 ms\"");
        let record = record(&build(&short));
        assert!(record.impacts.len() >= known.len());
        for (impact, [time_s, speed_m_s, peak_n]) in record.impacts.iter().zip(known) {
            assert!((impact.time_s - time_s).abs() < 1e-12, "onset {:e} for {time_s:e}", impact.time_s);
            assert!((impact.speed_m_s - speed_m_s).abs() < 1e-7, "{} m/s for {speed_m_s}", impact.speed_m_s);
            assert!((impact.peak_force_n / peak_n - 1.0).abs() < 1e-5, "{} N for {peak_n}", impact.peak_force_n);
        }
        assert!(record.energy.relative_residual < 1e-10, "{:e}", record.energy.relative_residual);
    }
}

/// Through a hub, a rigid joint and a tangent frame; the crate of beams alone is held against the same history in its own tests.
#[test]
fn peer_a_blade_whose_hub_is_brought_to_speed() {
    let built = build(&file("flexible_spin_up.toml"));
    assert_eq!((built.mechanism.real.free, built.mechanism.real.cuts.len()), (3, 0));
    let record = record(&built);
    let text = include_str!("../../../../loosepin-flexible/src/tests/spin_up.csv");
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|n| n.parse().expect("a number")).collect()).collect();
    let of = |name: &str| &record.outputs.iter().find(|history| history.name == name).expect("an output").value_si;
    assert_eq!(record.time_s.len(), 121);
    // The slope of the tip is 0.13 where it bends most.
    assert_eq!(record.bending.len(), 1);
    assert!((record.bending[0].largest_angle_rad - 0.13).abs() < 0.005, "{:?}", record.bending);
    assert!(record.energy.relative_residual < 1e-9, "{:e}", record.energy.relative_residual);
    for ((row, time_s), (along, across)) in rows.iter().zip(&record.time_s).zip(of("along").iter().zip(of("across"))) {
        assert!((row[0] - time_s).abs() < 1e-12);
        assert!((along - 8.0 - row[1]).abs() < 2e-9, "at {time_s} s: {} for {}", along - 8.0, row[1]);
        assert!((across - row[2]).abs() < 2e-9, "at {time_s} s: {across} for {}", row[2]);
    }
}
