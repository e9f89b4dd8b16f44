//! Whole turns of steel links in absolute nodal coordinates by implicit steps: `just campaign nodal-turns`.

use super::{apart, case_text, values};
use crate::elements::build;
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Integrator, Plan, Settings, simulate};
use std::f64::consts::TAU;

/// A mechanism with play, and what another program has for it.
struct Machine {
    case: &'static str,
    shapes: &'static str,
    duration: &'static str,
    turn_s: f64,
    /// The output compared, and until when histories with play are, s.
    output: &'static str,
    until_s: f64,
    /// The output of a force, which is left out: looks at it inside of implicit steps take evaluations.
    force: &'static str,
    /// With 16 elements: first onset, s, and its peak, N.
    first: (f64, f64),
    /// Distance of 2 + 2 shapes from 16 elements until then, m or rad.
    off: f64,
}

const SLIDER_CRANK: Machine = Machine {
    case: "flexible_slider_crank",
    shapes: "lateral_shapes = 2\naxial_shapes = 2",
    duration: "10 ms",
    turn_s: TAU / 150.0,
    output: "slider",
    until_s: 1.5e-3,
    force: "gudgeon_force",
    first: (2.84637e-4, 4085.4),
    off: 7.9e-5,
};

const FOUR_BAR: Machine = Machine {
    case: "flexible_four_bar",
    shapes: "lateral_shapes = 3\naxial_shapes = 2",
    duration: "20 ms",
    turn_s: 0.1,
    output: "rocker",
    until_s: 2.5e-3,
    force: "coupler_pin_force",
    first: (9.942158e-4, 1399.6),
    off: 9.8e-5,
};

/// Rows of a turn.
const ROWS: usize = 4000;

impl Machine {
    fn text(&self, keys: &str, has_play: bool) -> String {
        let mut text = case_text(self.case);
        let (duration, turn) = (format!("\"{}\"", self.duration), format!("\"{:e} s\"", self.turn_s));
        let rows = format!("samples_per_turn = {ROWS}");
        let ideal = ["radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\""];
        let changes = [[self.shapes, keys], [&duration, &turn], ["samples_per_turn = 400", &rows], ideal];
        for [part, other] in &changes[..if has_play { 3 } else { 4 }] {
            assert!(text.contains(part), "{part}");
            text = text.replace(part, other);
        }
        let force = text.find(&format!("[output.{}]", self.force)).expect("the last output");
        text.truncate(force);
        text
    }

    /// A turn, with a line of what it took.
    fn turn(&self, keys: &str, has_play: bool, tolerance_m: f64, integrator: Integrator) -> SimulationRecord {
        let built = build(&self.text(keys, has_play));
        let plan = Plan {
            settings: Settings { tolerance_m, integrator, ..Settings::for_simulation() },
            ..Plan::of_model(&built.mechanism.model)
        };
        let record =
            simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record;
        let counters = &record.counters;
        println!(
            "{} {} {integrator:?} {tolerance_m:e} m: {} steps, {} rejected, {} evaluations, {} factorizations, {} impacts, \
             energy residual {:.1e}, largest peak {:.1} N",
            self.case,
            keys.replace('\n', " "),
            counters.steps,
            counters.rejections,
            counters.evaluations,
            counters.factorizations,
            record.impacts.len(),
            record.energy.relative_residual,
            record.impacts.iter().map(|impact| impact.peak_force_n).fold(0.0, f64::max),
        );
        for impact in record.impacts.iter().take(2) {
            println!("    onset {:.6e} s, peak {:.2} N", impact.time_s, impact.peak_force_n);
        }
        record
    }

    /// Largest difference until the histories part, of the output.
    fn early(&self, one: &SimulationRecord, other: &SimulationRecord) -> f64 {
        let [values_of_one, values_of_other] = [one, other].map(|record| values(record, self.output));
        assert_eq!(one.time_s.len(), other.time_s.len());
        let pairs = one.time_s.iter().zip(values_of_one.iter().zip(values_of_other));
        let early = pairs.take_while(|(time_s, _)| **time_s <= self.until_s);
        early.fold(0.0, |apart, (_, (one, other))| apart.max((one - other).abs()))
    }
}

fn elements(count: usize, start: &str) -> String {
    format!("formulation = \"absolute-nodal\"\nelements = {count}\nstart = \"{start}\"")
}

fn shapes(lateral: usize, axial: usize, start: &str) -> String {
    format!("lateral_shapes = {lateral}\naxial_shapes = {axial}\nstart = \"{start}\"")
}

/// A closed loop from a settled start: elements against each other and against the floating frame.
fn closed(machine: &Machine) {
    let nodal =
        |count, tolerance_m| machine.turn(&elements(count, "settled"), false, tolerance_m, Integrator::Implicit);
    let [coarse, sixteen, eight] =
        [(16, 1e-4), (16, 1e-5), (8, 1e-5)].map(|(count, tolerance_m)| nodal(count, tolerance_m));
    println!("    16 elements, 1e-4 m against 1e-5 m: {:.1e}", apart(&coarse, &sixteen, machine.output));
    println!("    8 against 16 elements: {:.1e}", apart(&eight, &sixteen, machine.output));
    let history = sixteen.outputs.iter().find(|history| history.name == machine.output).expect("an output");
    let largest = history.deviation_si.iter().fold(0.0_f64, |largest, deviation| largest.max(deviation.abs()));
    println!("    what elasticity adds at most: {largest:.3e}");
    for count in [2, 4, 8] {
        let floating = machine.turn(&shapes(count, count, "settled"), false, 1e-9, Integrator::Explicit);
        let off = apart(&floating, &sixteen, machine.output);
        println!("    {count} + {count} shapes against 16 elements: {off:.1e}");
        // The second order of the floating frame leaves half a percent.
        assert!(off < 0.01 * largest, "{off:e} of {largest:e}");
    }
    assert!(apart(&eight, &sixteen, machine.output) < 1e-3 * largest);
    for record in [&sixteen, &eight] {
        assert!(record.energy.relative_residual < 1e-5, "{:e}", record.energy.relative_residual);
    }
}

/// With play.
fn loose(machine: &Machine) {
    let nodal = |count| machine.turn(&elements(count, "undeformed"), true, 1e-5, Integrator::Implicit);
    let [sixteen, eight] = [16, 8].map(nodal);
    println!("    8 against 16 elements until {:e} s: {:.1e}", machine.until_s, machine.early(&eight, &sixteen));
    let [two, five] = [2, 5].map(|count| {
        let floating = machine.turn(&shapes(count, count, "undeformed"), true, 1e-9, Integrator::Explicit);
        let off = machine.early(&floating, &sixteen);
        println!("    {count} + {count} shapes against 16 elements until {:e} s: {off:.1e}", machine.until_s);
        off
    });
    // The known distance has two digits. That of 5 + 5 shapes depends on the waves at the second contact.
    assert!((two / machine.off - 1.0).abs() < 0.02, "{two:e} for {:e}", machine.off);
    assert!(five < 0.1 * two, "{five:e} beside {two:e}");
    let explicit = machine.turn(&elements(16, "undeformed"), true, 1e-5, Integrator::Explicit);
    println!(
        "    explicit against implicit steps until {:e} s: {:.1e}",
        machine.until_s,
        machine.early(&explicit, &sixteen)
    );
    let first = &sixteen.impacts[0];
    let (onset_s, peak_n) = machine.first;
    assert!((first.time_s - onset_s).abs() < 1e-9, "{:e} s for {onset_s:e}", first.time_s);
    assert!((first.peak_force_n / peak_n - 1.0).abs() < 1e-3, "{} N for {peak_n}", first.peak_force_n);
    assert!(sixteen.energy.relative_residual < 1e-6, "{:e}", sixteen.energy.relative_residual);
}

#[test]
#[ignore = "minutes: just campaign nodal-turns"]
fn peer_turn_of_the_closed_slider_crank() {
    closed(&SLIDER_CRANK);
}

#[test]
#[ignore = "minutes: just campaign nodal-turns"]
fn peer_turn_of_the_closed_four_bar() {
    closed(&FOUR_BAR);
}

#[test]
#[ignore = "minutes: just campaign nodal-turns"]
fn peer_turn_of_the_loose_slider_crank() {
    loose(&SLIDER_CRANK);
}

#[test]
#[ignore = "minutes: just campaign nodal-turns"]
fn peer_turn_of_the_loose_four_bar() {
    loose(&FOUR_BAR);
}
