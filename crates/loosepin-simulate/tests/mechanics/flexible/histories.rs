//! Whole runs with one clearance joint against histories of another program: joint coordinates, the same shapes, DOP853 at 1e-11; a
//! second coding of it, in absolute coordinates with multipliers, is 6e-11 m apart.

use crate::elements::{Built, build, file};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Plan, Settings, simulate};

/// The run of a model of `tests/files`, as tight as is of use.
fn record(built: &Built) -> SimulationRecord {
    let plan = Plan {
        settings: Settings { tolerance_m: 1e-12, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

/// Columns of a history by their names, up to `until_s`.
struct History {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl History {
    fn new(name: &str, until_s: f64) -> Self {
        let text = file(name);
        let mut lines = text.lines();
        let names: Vec<String> = lines.next().expect("a header").split(',').map(str::to_owned).collect();
        let row = |line: &str| -> Vec<f64> { line.split(',').map(|n| n.parse().expect("a number")).collect() };
        let rows: Vec<Vec<f64>> = lines.map(row).collect();
        assert_eq!(rows.len(), 401);
        assert!(rows.iter().all(|row| row.len() == names.len()));
        Self { names, rows: rows.into_iter().filter(|row| row[0] <= until_s).collect() }
    }

    /// Largest difference of a column from an output of the run.
    fn apart(&self, record: &SimulationRecord, column: &str, output: &str) -> f64 {
        let place = self.names.iter().position(|name| name == column).expect("a column");
        let found = record.outputs.iter().find(|history| history.name == output).expect("an output");
        assert!(self.rows.len() > 100 && record.time_s.len() >= self.rows.len());
        let rows = self.rows.iter().zip(&record.time_s).zip(&found.value_si);
        rows.fold(0.0, |apart, ((row, time_s), value)| {
            assert!((row[0] - time_s).abs() < 1e-15, "{} and {time_s}", row[0]);
            apart.max((row[place] - value).abs())
        })
    }
}

/// Onsets, speeds and peaks of the first contacts. The peaks of the histories are the largest forces at the ends of steps: up to 5e-6 lower
/// than the greatest within one.
fn assert_contacts(record: &SimulationRecord, known: &[[f64; 3]]) {
    assert!(record.impacts.len() >= known.len());
    for (impact, [time_s, speed_m_s, peak_n]) in record.impacts.iter().zip(known) {
        assert!((impact.time_s - time_s).abs() < 1e-12, "onset {:e} for {time_s:e}", impact.time_s);
        assert!((impact.speed_m_s - speed_m_s).abs() < 1e-7, "{} m/s for {speed_m_s}", impact.speed_m_s);
        assert!((impact.peak_force_n / peak_n - 1.0).abs() < 1e-5, "{} N for {peak_n}", impact.peak_force_n);
    }
}

/// Positions as the history is trusted, 1e-8 m, and rates: 1e-4 of the speeds at hand.
fn assert_history(record: &SimulationRecord, history: &History, columns: &[(&str, &str, f64)]) {
    for (column, output, largest) in columns {
        let apart = history.apart(record, column, output);
        assert!(apart < *largest, "{column}: {apart:e}");
    }
    assert!(record.energy.relative_residual < 1e-10, "{:e}", record.energy.relative_residual);
}

#[test]
fn peer_slider_crank_with_a_flexible_rod() {
    let built = build(&file("flexible_slider_crank.toml"));
    let record = record(&built);
    let known = [
        [2.85080111979e-4, 1.2517675, 3880.635],
        [3.55403147e-4, 0.1807218, 2884.442],
        [9.53447685e-4, 1.7282571, 5935.294],
        [1.092628494e-3, 2.1672000, 5110.366],
    ];
    assert_contacts(&record, &known);
    let history = History::new("flexible_slider_crank.csv", 7.325e-3);
    let columns = [
        ("rod_angle", "rod", 1e-8 / 0.3),
        ("slider_x", "slider", 1e-8),
        ("bearing_x_m", "small_end_x", 1e-8),
        ("bearing_y_m", "small_end_y", 1e-8),
        ("slider_x_rate", "slider_velocity", 1e-4),
    ];
    assert_history(&record, &history, &columns);
    // 52 contacts and 6063.37 N; the rigid rod has 17 contacts, of 9502.7 and 7800.8 N at first.
    assert_eq!(record.impacts.len(), 52);
    let greatest_n = record.impacts.iter().fold(0.0_f64, |greatest, impact| greatest.max(impact.peak_force_n));
    assert!((greatest_n / 6063.37 - 1.0).abs() < 1e-5, "{greatest_n}");
}

#[test]
fn peer_four_bar_with_a_flexible_coupler() {
    let built = build(&file("flexible_four_bar.toml"));
    let record = record(&built);
    let known = [
        [9.94134537630e-4, 0.4082844, 1355.225],
        [1.810120962e-3, 0.4549017, 668.296],
        [2.475701649e-3, 0.3791165, 649.932],
    ];
    assert_contacts(&record, &known);
    let history = History::new("flexible_four_bar.csv", 6.7e-3);
    let columns = [
        ("rod_angle", "coupler", 1e-8 / 0.3),
        ("rocker_angle", "rocker", 1e-8 / 0.3),
        ("bearing_x_m", "head_x", 1e-8),
        ("bearing_y_m", "head_y", 1e-8),
        ("rocker_angle_rate", "rocker_speed", 1e-4),
    ];
    assert_history(&record, &history, &columns);
}
