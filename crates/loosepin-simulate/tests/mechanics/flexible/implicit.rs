//! Implicit steps: against another program, and against explicit steps.

use super::{apart, case_text, values};
use crate::elements::{build, file};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Integrator, Observer, Plan, RunFailure, Settings, Step, Window, run, simulate};

fn outcome(text: &str, tolerance_m: f64, integrator: Integrator) -> Result<SimulationRecord, RunFailure> {
    let built = build(text);
    let plan = Plan {
        settings: Settings { tolerance_m, integrator, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).map(|simulation| simulation.record)
}

fn record(text: &str, tolerance_m: f64, integrator: Integrator) -> SimulationRecord {
    outcome(text, tolerance_m, integrator).unwrap_or_else(|failure| panic!("{failure}"))
}

/// A case with its rod or coupler in absolute nodal coordinates, of a settled start, over a short time.
fn nodal(name: &str, [shapes, keys]: [&str; 2], [duration, short]: [&str; 2]) -> String {
    let text = case_text(name);
    let with = text.replace(shapes, &format!("formulation = \"absolute-nodal\"\n{keys}"));
    assert_ne!(text, with);
    with.replace(&format!("duration = \"{duration}\""), &format!("duration = \"{short}\""))
}

fn slider_crank(keys: &str, short: &str) -> String {
    nodal("flexible_slider_crank", ["lateral_shapes = 2\naxial_shapes = 2", keys], ["10 ms", short])
}

fn four_bar(keys: &str, short: &str) -> String {
    nodal("flexible_four_bar", ["lateral_shapes = 3\naxial_shapes = 2", keys], ["20 ms", short])
}

/// The soft pendulum of another program, which folds: the error falls with the tolerance as order five says.
#[test]
fn peer_the_soft_pendulum_by_implicit_steps() {
    let rows: Vec<Vec<f64>> = include_str!("../../../../loosepin-flexible/src/tests/soft_pendulum.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    let error_m = |tolerance_m: f64| {
        let record = record(&file("nodal_pendulum.toml"), tolerance_m, Integrator::Implicit);
        let tips = values(&record, "tip_x").iter().zip(values(&record, "tip_y"));
        assert_eq!(rows.len(), record.time_s.len());
        let errors = rows.iter().zip(tips).map(|(row, (x, y))| (x - row[1]).hypot(y - row[2]));
        (errors.fold(0.0, f64::max), record.counters.steps as f64)
    };
    let [(coarse_m, few), (fine_m, many)] = [1e-3, 1e-5].map(error_m);
    assert!(coarse_m < 1e-6 && fine_m < 5e-9, "{coarse_m:e} m, {fine_m:e} m");
    let order = (coarse_m / fine_m).ln() / (many / few).ln();
    assert!(order > 4.0, "{order}");
}

/// First contacts of two mechanisms with 16 elements, by another program; the peak of one of them.
#[test]
fn peer_first_contacts_by_implicit_steps() {
    let keys = "elements = 16";
    let known = [(slider_crank(keys, "0.7 ms"), 2.84637e-4, Some(4085.4)), (four_bar(keys, "1 ms"), 9.942158e-4, None)];
    for (text, onset_s, peak_n) in known {
        let record = record(&text, 1e-5, Integrator::Implicit);
        let first = &record.impacts[0];
        assert!((first.time_s - onset_s).abs() < 1e-9, "{:e} s for {onset_s:e}", first.time_s);
        if let Some(peak_n) = peak_n {
            assert!((first.peak_force_n / peak_n - 1.0).abs() < 1e-3, "{} N for {peak_n}", first.peak_force_n);
        }
        assert!(record.energy.relative_residual < 1e-6, "{:e}", record.energy.relative_residual);
    }
}

/// A closed loop without play: places, forces and stresses come to those of explicit steps, whose evaluations are ten and three times those of implicit ones.
#[test]
fn identity_a_closed_loop_by_both_kinds_of_steps() {
    let text = slider_crank("elements = 4\nstart = \"settled\"", "1 ms")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
        + "\n[output.stress]\nstress_in = \"rod\"\n[output.torque]\ntorque_of = \"drive.crank\"\n";
    let explicit = record(&text, 1e-8, Integrator::Explicit);
    let work = |tolerance_m: f64, integrator: Integrator| {
        let (built, window) = (build(&text), Window { start_s: 0.0, end_s: 1e-3 });
        let settings = Settings { tolerance_m, integrator, ..Settings::for_simulation() };
        let mut looks = Looks { shares: &[], at_forces: false, steps: 0 };
        run(&built.mechanism, &built.sample(), &window, &settings, &mut looks)
            .unwrap_or_else(|failure| panic!("{failure}"))
            .counters
            .evaluations
    };
    let most = work(1e-8, Integrator::Explicit);
    for (tolerance_m, slider_m, share, evaluations) in [(1e-4, 2e-8, 1e-2, 10), (1e-6, 2e-11, 5e-5, 3)] {
        let implicit = record(&text, tolerance_m, Integrator::Implicit);
        assert!(evaluations * work(tolerance_m, Integrator::Implicit) < most);
        let off_m = apart(&explicit, &implicit, "slider");
        assert!(off_m < slider_m, "{off_m:e} m");
        for output in ["gudgeon_force", "stress", "torque"] {
            let size = values(&explicit, output).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let off = apart(&explicit, &implicit, output) / size;
            assert!(off < share, "{output}: {off:e}");
        }
    }
}

/// Damping of the material, friction and impacts: the energy account closes, and histories are those of explicit steps.
#[test]
fn identity_two_floating_links_by_both_kinds_of_steps() {
    let text = file("nodal_two_floating_links.toml").replace("duration = \"6 ms\"", "duration = \"2 ms\"");
    let [explicit, implicit] = [(1e-9, Integrator::Explicit), (1e-6, Integrator::Implicit)]
        .map(|(tolerance_m, integrator)| record(&text, tolerance_m, integrator));
    assert!(!explicit.impacts.is_empty() && explicit.impacts.len() == implicit.impacts.len());
    let off_m = apart(&explicit, &implicit, "head_x");
    assert!(off_m < 1e-8, "{off_m:e} m");
    assert!(implicit.energy.relative_residual < 1e-7, "{:e}", implicit.energy.relative_residual);
}

/// Without nodes there is nothing that implicit steps are for.
#[test]
fn messages_of_implicit_steps_without_nodes() {
    let refusal = outcome(&case_text("flexible_slider_crank"), 1e-6, Integrator::Implicit).expect_err("it is refused");
    assert_eq!(refusal, RunFailure::ImplicitWithoutNodes);
    assert_eq!(refusal.code(), "implicit_without_nodes");
    assert_eq!(
        refusal.to_string(),
        "implicit steps need a flexible body in absolute nodal coordinates, and this mechanism has none"
    );
}

/// A bar of 0.4 m with damping of its material that turns about its end at 15 rad/s.
fn slow_bar() -> String {
    "name = \"bar\"\ngravity = \"0 m/s^2\"\n\
     [body.ground]\npoints = { o = [\"0 mm\", \"0 mm\"] }\n\
     [body.bar]\npoints = { root = [\"0 mm\", \"0 mm\"], tip = [\"400 mm\", \"0 mm\"] }\n\
     [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = { width = \"12 mm\", height = \"7 mm\" }\n\
     youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\nformulation = \"absolute-nodal\"\nelements = 8\n\
     start = \"settled\"\nretardation_time = \"20 us\"\n\
     [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
     [drive.bar]\njoint = \"main\"\nspeed = \"15 rad/s\"\nstart_angle = \"0.7 rad\"\n\
     [cycle]\nduration = \"50 ms\"\ntransient_turns = 1\nrecorded_turns = 1\nsamples_per_turn = 100\n\
     [output.stress]\nstress_in = \"bar\"\n\
     [output.pull]\nforce_in = \"joint.main\"\ncomponent = \"magnitude\"\n\
     [output.fall]\nacceleration_of = \"bar.tip\"\nalong = \"x\"\n"
        .to_owned()
}

/// Factorizations are those of the whole run, also where steps begin anew at a point of a drive's table just before its end: the same even motion with the
/// point just behind the end takes about as many.
#[test]
fn identity_factorizations_go_on_beyond_the_points_of_a_table() {
    let factorizations = |[time, angle]: [&str; 2]| {
        let motion = format!(
            "motion = {{ kind = \"table\", ends = \"periodic\", points = [[\"0 s\", \"0.7 rad\"], [\"{time}\", \"{angle}\"], \
             [\"150 ms\", \"2.95 rad\"]] }}"
        );
        let text = slow_bar()
            .replace("speed = \"15 rad/s\"\nstart_angle = \"0.7 rad\"", &motion)
            .replace("duration = \"50 ms\"\ntransient_turns = 1", "duration = \"50 ms\"\ntransient_turns = 0");
        record(&text, 1e-6, Integrator::Implicit).counters.factorizations
    };
    let [inside, behind] = [["49 ms", "1.435 rad"], ["51 ms", "1.465 rad"]].map(factorizations);
    assert!(behind > 20 && 2 * inside > behind, "{inside}, {behind}");
}

/// Forces, stresses, accelerations and extremes inside of steps: E (1/cos κL - 1), times A, and ω² tan(κL)/κ, κ = ω√(ρ/E). Without corrections of stiff directions they are
/// 7.7e-3, 5.6e-3 and 1.0e-1 off.
#[test]
fn analytic_forces_inside_long_steps_of_a_turning_bar() {
    let record = record(&slow_bar(), 1e-4, Integrator::Implicit);
    // Explicit steps would be 13,000.
    assert!(record.counters.steps < 300, "{}", record.counters.steps);
    let (modulus_pa, density_kg_m3, spin_rad_s, length_m, area_m2) = (207e9_f64, 7800.0, 15.0, 0.4, 0.012 * 0.007);
    let factor_1_m = spin_rad_s * (density_kg_m3 / modulus_pa).sqrt();
    let stress_pa = modulus_pa * (1.0 / (factor_1_m * length_m).cos() - 1.0);
    let tip_m_s2 = spin_rad_s * spin_rad_s * (factor_1_m * length_m).tan() / factor_1_m;
    for (output, due, relative) in [("stress", stress_pa, 1e-3), ("pull", stress_pa * area_m2, 1e-4)] {
        for found in values(&record, output) {
            assert!((found / due - 1.0).abs() < relative, "{output}: {found:e} for {due:e}");
        }
        let extreme = record.extremes.iter().find(|extreme| extreme.name == output).expect("an output");
        for found in [extreme.minimum.value_si, extreme.maximum.value_si] {
            assert!((found / due - 1.0).abs() < relative, "extreme of {output}: {found:e} for {due:e}");
        }
    }
    for (time_s, found) in record.time_s.iter().zip(values(&record, "fall")) {
        let due = -tip_m_s2 * (0.7 + spin_rad_s * time_s).cos();
        assert!((found - due).abs() < 1e-2 * tip_m_s2, "{found} m/s² for {due}");
    }
}

/// Looks at each step at the shares it is given.
struct Looks<'l> {
    shares: &'l [f64],
    at_forces: bool,
    steps: u64,
}

impl Observer for Looks<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.steps += 1;
        for share in self.shares {
            let time_s = step.start_s + share * (step.end_s - step.start_s);
            if self.at_forces {
                step.evaluate(time_s);
            } else {
                step.set_state(time_s);
            }
        }
    }
}

/// Evaluations that looks at forces cost: none at the ends of a step, two at each instant inside an implicit one, however often it is looked at in turn; three of all
/// looks inside an explicit one. Looks at places and velocities cost none inside an implicit step.
#[test]
fn identity_evaluations_of_looks_inside_steps() {
    let text = slider_crank("elements = 4\nstart = \"settled\"", "0.2 ms")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"");
    let built = build(&text);
    let window = Window { start_s: 0.0, end_s: 2e-4 };
    let count = |integrator: Integrator, shares: &[f64], at_forces: bool| {
        let settings = Settings { tolerance_m: 1e-5, integrator, ..Settings::for_simulation() };
        let mut looks = Looks { shares, at_forces, steps: 0 };
        let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut looks)
            .unwrap_or_else(|failure| panic!("{failure}"));
        assert_eq!(looks.steps, report.counters.steps);
        (report.counters.evaluations, looks.steps)
    };
    for (integrator, by_looks) in [(Integrator::Implicit, [0, 2, 2, 6]), (Integrator::Explicit, [0, 3, 3, 3])] {
        let (least, steps) = count(integrator, &[], true);
        assert!(steps > 5);
        for (shares, each) in [&[0.0, 1.0][..], &[0.5], &[0.5, 0.5, 0.5], &[0.25, 0.5, 0.75]].into_iter().zip(by_looks)
        {
            assert_eq!(count(integrator, shares, true), (least + each * steps, steps), "{integrator:?} {shares:?}");
        }
        let each = if integrator == Integrator::Implicit { 0 } else { 3 };
        assert_eq!(count(integrator, &[0.25, 0.5], false), (least + each * steps, steps), "{integrator:?}");
    }
}

/// A disc that flies up in a slot and meets its round end in a step that has both ends at the faces, whose gap never changes: the impact is seen wherever steps begin and end.
#[test]
fn identity_an_impact_inside_a_long_step_is_seen() {
    /// How far the disc would fly beyond the end, m: it is in contact for 13 % of the time that it is beyond the faces.
    const OVER_M: f64 = 2e-7;
    /// A contact begins within 1e-9 m.
    const RELATIVE: f64 = 3e-3;
    const CLEARANCE_M: f64 = 1e-5;
    for start_m in [0.0495, 0.0494, 0.0493, 0.0492, 0.0491, 0.0487] {
        let end_m = 0.05 + CLEARANCE_M;
        let speed_m_s = (2.0 * 9.81 * (end_m + OVER_M - start_m)).sqrt();
        let text = format!(
            "name = \"disc\"\ngravity = \"9.81 m/s^2\"\n\
             [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"], s = [\"200 mm\", \"0 mm\"] }}\n\
             [body.bar]\npoints = {{ root = [\"0 mm\", \"0 mm\"], tip = [\"400 mm\", \"0 mm\"] }}\n\
             [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ width = \"12 mm\", height = \"7 mm\" }}\n\
             youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\nformulation = \"absolute-nodal\"\nelements = 2\n\
             start = \"settled\"\n\
             [body.disc]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = {{ centre = [\"0 mm\", \"0 mm\"] }}\n\
             [contact.steel]\nrestitution = 0.8\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\n\
             [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
             [joint.slot]\nkind = \"slot\"\nslot = {{ point = \"ground.s\", angle = \"90 deg\" }}\npin = \"disc.centre\"\n\
             half_length = \"50 mm\"\nend_radius = \"10 mm\"\nclearance = \"{CLEARANCE_M} m\"\ncontact = \"steel\"\n\
             [drive.bar]\njoint = \"main\"\nspeed = \"1 rad/s\"\nstart_angle = \"0.7 rad\"\n\
             [initial.body.disc]\nposition = [\"200 mm\", \"{start_m} m\"]\nvelocity = [\"0 m/s\", \"{speed_m_s} m/s\"]\n\
             angle = \"0 deg\"\nangular_velocity = \"0 rad/s\"\n\
             [cycle]\nduration = \"{} s\"\n",
            1.9 * speed_m_s / 9.81
        );
        let record = record(&text, 1e-5, Integrator::Implicit);
        assert_eq!(record.impacts.len(), 1, "from {start_m} m, {} steps", record.counters.steps);
        // At the speed that is left there.
        let due_m_s = (2.0 * 9.81 * OVER_M).sqrt();
        let found_m_s = record.impacts[0].speed_m_s;
        assert!((found_m_s / due_m_s - 1.0).abs() < RELATIVE, "{found_m_s:e} m/s for {due_m_s:e}");
    }
}
