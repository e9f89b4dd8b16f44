//! Runs on lanes against runs alone: the same bits, whatever the instructions, the lane, the neighbours and the order.

use loosepin_mechanics::contact::{FILM_LAWS, FRICTION_LAWS};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, Motion, NormalDescription, QuantityId};
use loosepin_result::study::Deviation;
use loosepin_simulate::{
    Arms, Execution, Findings, Follow, FollowedDeviation, FollowedRun, Observer, Onset, PassPrograms, Queue, Reading,
    Run, RunCounters, RunFailure, RunReport, Separation, Settings, Step, Window, columns, run_batch,
};
use loosepin_tape::native::OperationCounts;
use std::path::Path;

/// More runs than the widest group has lanes, so that lanes are filled again.
const RUNS: usize = 37;
/// Mechanisms among them. Of others about one in sixty steps over a kink of the friction law of Bengisu and Akay at the tolerance of
/// studies: its energy account closes to 1e-7 instead of 2e-9.
const MECHANISMS: usize = 19;
/// Equal parts of the recorded part at whose ends positions are read.
const INSTANTS: u32 = 40;

struct Case {
    mechanism: Mechanism,
    readings: Vec<Reading>,
    /// What is looked at inside the steps: velocity and acceleration of each position, then forces and all else.
    inside: Vec<Reading>,
    turn_s: f64,
    /// What the first so many runs have in place of the nominal value.
    other: Option<(usize, QuantityId, f64)>,
}

fn case_text(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = if name.ends_with(".toml") {
        folder.join("tests/files").join(name)
    } else {
        folder.join("../../cases").join(name).join("model.toml")
    };
    std::fs::read_to_string(file).expect("the case is there")
}

fn case(name: &str) -> Case {
    compiled(name, &case_text(name))
}

fn compiled(name: &str, text: &str) -> Case {
    let model = Model::from_text(name, text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let nominal = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &nominal).unwrap_or_else(|error| panic!("{name}: {error}"));
    let all = columns(&mechanism.model).into_iter().map(|column| column.reading);
    let (readings, others): (Vec<Reading>, Vec<Reading>) = all.partition(Reading::is_position);
    let rates = |reading: &Reading| match reading.position() {
        Some(of) => vec![Motion::velocity(of).into(), Motion::acceleration(of).into()],
        None => Vec::new(),
    };
    let inside = readings.iter().flat_map(rates).chain(others).collect();
    let turn_s = model.cycle_input(&nominal).turn_s();
    Case { mechanism, readings, inside, turn_s, other: None }
}

/// Everything that an observer can see of a run.
#[derive(Debug, Default, Clone, PartialEq)]
struct Seen {
    /// Ends of all steps with the bits of the outputs there: a zero has a sign.
    steps: Vec<(f64, Vec<u64>)>,
    /// dt/ds at the start and at the end of each.
    paces: Vec<[f64; 2]>,
    /// A look inside of some steps: positions of all bodies.
    looks: Vec<u64>,
    contacts: Vec<(f64, f64)>,
    report: Option<RunReport>,
}

struct Watcher {
    index: usize,
    seen: Seen,
    looks_inside: bool,
    /// Whether every step is shown.
    is_attentive: bool,
}

impl Observer for Watcher {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let bits = step.outputs.iter().flatten().flatten().map(|value| value.to_bits()).collect();
        self.seen.steps.push((step.end_s, bits));
        self.seen.paces.push([0, 1].map(|side| step.time(side)[1]));
        if self.looks_inside && self.seen.steps.len().is_multiple_of(17) {
            let poses = &step.evaluate(step.start_s + 0.37 * (step.end_s - step.start_s)).kinematics.poses;
            let numbers = poses.iter().flat_map(|pose| [pose.position_m.x, pose.position_m.y, pose.angle_rad()]);
            self.seen.looks.extend(numbers.map(f64::to_bits));
        }
    }
    fn awaits_s(&self) -> f64 {
        if self.is_attentive { f64::NEG_INFINITY } else { f64::INFINITY }
    }
    fn contact_begins(&mut self, onset: &Onset) {
        self.seen.contacts.push((onset.time_s, onset.speed_m_s));
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.seen.contacts.push((separation.time_s, separation.speed_m_s));
    }
}

struct Waiting<'c> {
    case: &'c Case,
    order: Vec<usize>,
    turns: f64,
    is_attentive: bool,
    instants: u32,
    seen: Vec<Seen>,
}

impl Queue for Waiting<'_> {
    type Observer = Watcher;

    fn next(&mut self) -> Option<Run<Watcher>> {
        let index = self.order.pop()?;
        let model = &self.case.mechanism.model;
        let factor = 0.9 + 0.2 * (index % MECHANISMS) as f64 / MECHANISMS as f64;
        let mut set = Vec::new();
        for play in &self.case.mechanism.plays {
            if let Some(id) = model.play_clearance(*play) {
                set.push((id, factor * model.quantities.nominal()[id]));
            }
        }
        set.extend(self.case.other.filter(|(first, ..)| index < *first).map(|(_, id, value)| (id, value)));
        let values = model.quantities.evaluate(&set).expect("the clearances are possible");
        // Every third run is longer, so that lanes become free at different times.
        let turns = self.turns * if index.is_multiple_of(3) { 1.3 } else { 1.0 };
        let window = Window { start_s: 0.2 * turns * self.case.turn_s, end_s: turns * self.case.turn_s };
        let looks_inside = self.is_attentive && index.is_multiple_of(2);
        let instant_s =
            |k: u32| window.start_s + (window.end_s - window.start_s) * f64::from(k) / f64::from(self.instants);
        Some(Run {
            sample: Sample::new(&self.case.mechanism, &values).expect("the sample fits"),
            arms: Arms::new(&self.case.mechanism, &values),
            observer: Watcher { index, seen: Seen::default(), looks_inside, is_attentive: self.is_attentive },
            followed: FollowedRun {
                instants_s: (0..=self.instants).map(instant_s).collect(),
                nominal: None,
                own: None,
            },
            window,
            resume: None,
        })
    }

    fn finished(&mut self, watcher: Watcher, outcome: Result<RunReport, RunFailure>) {
        let report = outcome.unwrap_or_else(|failure| panic!("run {}: {failure}", watcher.index));
        self.seen[watcher.index] = Seen { report: Some(report), ..watcher.seen };
    }
}

fn conducted(case: &Case, order: Vec<usize>, turns: f64, execution: Execution, settings: &Settings) -> Vec<Seen> {
    let instants = INSTANTS;
    let mut waiting = Waiting { case, order, turns, is_attentive: true, instants, seen: vec![Seen::default(); RUNS] };
    run_batch(&case.mechanism, &follow(case), settings, execution, &mut waiting);
    waiting.seen
}

/// All readings, their extremes and integrals.
fn follow(case: &Case) -> Follow {
    let deviation = |reading| FollowedDeviation { reading, deviation: Deviation::Value, is_integrated: true };
    let deviations = (0..case.readings.len()).map(deviation).collect();
    Follow { readings: case.readings.clone(), deviations, paths: Vec::new(), inside: case.inside.clone() }
}

#[test]
fn identity_what_is_followed_does_not_depend_on_whether_anybody_looks() {
    // Stops of drives within the recorded part, one turn and more, free flight, guides with play.
    const ARM: &str = "../../../loosepin-import/templates/two-link-arm/model.toml";
    for (name, turns) in
        [(ARM, 1.0), ("slider_crank_table_drive.toml", 0.3), ("slider_crank_5000", 1.5), ("four_bar_600", 0.5)]
    {
        let case = case(name);
        let of = |is_attentive| {
            let order = (0..8).collect();
            let seen = vec![Seen::default(); 8];
            let mut waiting = Waiting { case: &case, order, turns, is_attentive, instants: INSTANTS, seen };
            run_batch(&case.mechanism, &follow(&case), &Settings::for_study(), Execution::best(), &mut waiting);
            waiting.seen
        };
        for (run, (watched, quiet)) in of(true).iter().zip(of(false)).enumerate() {
            let findings = |seen: &Seen| seen.report.as_ref().unwrap().findings.clone();
            let (findings, own) = (findings(&quiet), findings(watched));
            assert_eq!(findings, own, "{name}: run {run}");
            assert_eq!(findings.at_instants.len(), (INSTANTS as usize + 1) * case.readings.len(), "{name}");
            for (reading, range) in findings.deviations.iter().enumerate() {
                let values = findings.at_instants.iter().skip(reading).step_by(case.readings.len());
                let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
                // Round-off of positions of a metre.
                let round_off = 1e-14;
                let is_within = range.smallest <= low + round_off && high <= range.largest + round_off;
                assert!(is_within, "{name}: {range:?} {low} {high}");
            }
            // The end of the last step is the last instant.
            let last = &watched.steps.last().unwrap().1;
            let end = last.iter().skip(3).step_by(6).map(|bits| f64::from_bits(*bits));
            let at_end = &findings.at_instants[findings.at_instants.len() - case.readings.len()..];
            assert!(at_end.iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-12), "{name}: {at_end:?}");
        }
    }
}

/// So many that most steps over a root hold some, in most lanes at once, and nothing else is asked.
#[test]
fn identity_many_instants_have_the_same_bits_in_every_lane() {
    const MANY: u32 = 4_000;
    let case = case("slider_crank_5000");
    let found = |execution| {
        let (order, seen) = ((0..RUNS).collect(), vec![Seen::default(); RUNS]);
        let mut waiting = Waiting { case: &case, order, turns: 1.0, is_attentive: false, instants: MANY, seen };
        run_batch(&case.mechanism, &Follow::readings(&case.readings), &Settings::for_study(), execution, &mut waiting);
        let of_run = |seen: &Seen| {
            let findings = &seen.report.as_ref().expect("a report").findings;
            findings.at_instants.iter().map(|value| value.to_bits()).collect::<Vec<u64>>()
        };
        waiting.seen.iter().map(of_run).collect::<Vec<_>>()
    };
    let alone = found(Execution::Scalar);
    assert_eq!(alone[0].len(), (MANY as usize + 1) * case.readings.len());
    assert!(alone.iter().flatten().all(|bits| f64::from_bits(*bits).is_finite()));
    for execution in Execution::available() {
        assert!(found(execution) == alone, "{}", execution.name());
    }
}

#[test]
fn identity_velocities_inside_the_steps_sum_up_to_positions_and_accelerations_to_velocities() {
    for (name, turns) in [("slider_crank_5000", 1.2), ("six_bar", 0.2), ("slider_crank_friction", 0.6)] {
        let case = case(name);
        let settings = Settings { tolerance_m: 1e-10, ..Settings::for_study() };
        for seen in conducted(&case, (0..4).collect(), turns, Execution::best(), &settings).iter().take(4) {
            let findings = &seen.report.as_ref().expect("a report").findings;
            let jet = |bits: &[u64]| [0, 1, 2].map(|k| f64::from_bits(bits[k]));
            // Outputs of the first and the last step that was shown: those of the recorded part.
            let last = seen.steps.len() - 1;
            let ends = [&seen.steps[0].1[..], &seen.steps[last].1[..]];
            let paces = [seen.paces[0][0], seen.paces[last][1]];
            for reading in 0..case.readings.len() {
                let (start, end) = (jet(&ends[0][6 * reading..]), jet(&ends[1][6 * reading + 3..]));
                for order in [0, 1] {
                    let range = &findings.inside[2 * reading + order];
                    // d/ds = w d/dt.
                    let over_time = |value: f64, pace: f64| if order == 0 { value } else { value / pace };
                    let change = over_time(end[order], paces[1]) - over_time(start[order], paces[0]);
                    let size = range.integral_of_square.sqrt().max(change.abs());
                    let missed = (range.integral - change).abs() / size;
                    assert!(missed < 1e-7, "{name}: reading {reading}, order {order}: {} {change}", range.integral);
                    assert!(range.smallest < range.largest, "{name}: {range:?}");
                }
            }
        }
    }
}

/// One clearance, two, friction, ideal loops, a drive that pushes, a law without machine code, bodies held by play alone,
/// springs with dampers and loads of every kind, drives with pieces and expressions, no drive at all, a controlled joint, gears, a cam,
/// friction in ideal joints, sliders with play in their guides, gears and racks with
/// backlash, a cam from which its follower lifts off, flexible links without and with damping and friction.
const CASES: [(&str, f64); 25] = [
    ("slider_crank_5000", 0.3),
    ("slider_crank_two_clearances", 0.06),
    ("slider_crank_friction", 0.3),
    ("six_bar", 0.05),
    ("five_bar_driven_slider", 0.1),
    ("four_bar_linear_contact", 0.05),
    ("slider_crank_given_stiffness", 0.1),
    ("four_bar_floating_coupler", 0.03),
    ("slider_crank_elements.toml", 0.1),
    ("slider_crank_table_drive.toml", 0.3),
    ("slider_crank_measured_loads.toml", 0.1),
    ("pendulum_on_a_spring.toml", 0.3),
    ("backlash.toml", 0.05),
    ("geared_pendulum.toml", 0.3),
    ("cam_lifter.toml", 0.4),
    ("slider_crank_joint_friction.toml", 0.1),
    ("slider_crank_guide", 0.05),
    ("slider_with_play_in_its_guide.toml", 0.1),
    ("block_over_the_end.toml", 0.6),
    ("geared_four_bar_backlash", 0.5),
    ("planetary_backlash.toml", 0.3),
    ("cam_lift_off.toml", 0.6),
    ("flexible_slider_crank", 0.06),
    ("flexible_two_floating_links.toml", 0.2),
    ("flexible_points_inside.toml", 0.02),
];

#[test]
fn identity_runs_have_the_same_bits_in_every_lane_and_on_every_instruction_set() {
    for (name, turns) in CASES {
        assert_same_bits(name, turns);
    }
}

/// Pins at the faces and in the ends of their slots, and at the flanks of circular ones.
#[test]
fn identity_pins_in_slots_have_the_same_bits_in_every_lane_and_on_every_instruction_set() {
    for (name, turns) in [
        ("scotch_yoke_with_play_in_its_slot.toml", 0.1),
        ("disc_in_a_turning_slot.toml", 0.12),
        ("disc_thrown_into_a_slot.toml", 0.02),
        ("linkage_with_a_circular_slot.toml", 0.1),
        ("disc_in_a_turning_circular_slot.toml", 0.12),
    ] {
        assert_same_bits(name, turns);
    }
}

#[test]
fn identity_links_in_absolute_nodal_coordinates_have_the_same_bits_in_every_lane() {
    assert_same_bits("nodal_two_floating_links.toml", 0.05);
}

#[test]
fn identity_links_with_lumps_and_condensed_shapes_have_the_same_bits_in_every_lane() {
    assert_same_bits("flexible_lumps.toml", 0.05);
}

/// A number that is zero in the first runs and not in the others, or the other way round: programs are written again while many lanes run.
#[test]
fn identity_a_number_that_stops_being_zero_leaves_the_bits_of_runs_at_hand() {
    let name = "slider_crank_5000";
    let plain = case(name);
    let path = "joint.guide.guide.angle";
    let id = plain.mechanism.model.quantities.id(path).unwrap_or_else(|| panic!("{path} is a quantity"));
    assert_same_bits_of(&Case { other: Some((20, id, 1e-4)), ..plain }, name, 0.1);
}

/// Runs of a case for some turns alone and together, in both orders, by every execution.
fn assert_same_bits(name: &str, turns: f64) {
    assert_same_bits_of(&case(name), name, turns);
}

fn assert_same_bits_of(case: &Case, name: &str, turns: f64) {
    let forward: Vec<usize> = (0..RUNS).collect();
    let backward: Vec<usize> = (0..RUNS).rev().collect();
    let settings = Settings::for_study();
    let alone = conducted(case, forward.clone(), turns, Execution::Scalar, &settings);
    assert!(alone.iter().all(|seen| seen.steps.len() > 3), "{name}: the runs are long enough to tell something");
    assert!(alone.iter().any(|seen| !seen.contacts.is_empty()), "{name}: there is contact");
    for execution in Execution::available() {
        for order in [&forward, &backward] {
            let together = conducted(case, order.clone(), turns, execution, &settings);
            for (index, (one, other)) in alone.iter().zip(&together).enumerate() {
                assert_eq!(one, other, "{name}, run {index}, {}", execution.name());
            }
        }
    }
}

/// A case whose joint with play wears.
fn worn(name: &str) -> Case {
    let wear = "bearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\nradial_clearance";
    compiled(name, &case_text(name).replacen("radial_clearance", wear, 1))
}

#[test]
fn identity_friction_paths_of_wearing_joints_have_the_same_bits_in_lanes() {
    // Without friction, where the root of the penetration is an unknown, and with friction.
    for (name, turns) in [("slider_crank_5000", 0.4), ("four_bar_friction", 0.2)] {
        let case = worn(name);
        let (order, settings) = ((0..RUNS).collect::<Vec<usize>>(), Settings::for_study());
        let alone = conducted(&case, order.clone(), turns, Execution::Scalar, &settings);
        for seen in &alone {
            let paths = &seen.report.as_ref().expect("a report").friction_paths;
            assert!(paths.len() == 1 && paths[0].path_j > 0.0, "{name}: {paths:?}");
        }
        for execution in Execution::available() {
            let together = conducted(&case, order.clone(), turns, execution, &settings);
            for (index, (one, other)) in alone.iter().zip(&together).enumerate() {
                assert_eq!(one, other, "{name}, run {index}, {}", execution.name());
            }
        }
    }
}

/// The slider-crank with another contact between pin and hole.
fn slider_crank_with(contact: &str) -> Case {
    let text = case_text("slider_crank_5000");
    let (before, rest) = text.split_once("[contact.steel_pin]").expect("there is a contact");
    let (_, after) = rest.split_once("[joint.main]").expect("joints follow");
    let after = after.replace("bearing_radius", "bearing_length = \"20 mm\"\nbearing_radius");
    compiled(contact, &format!("{before}[contact.steel_pin]\n{contact}\n[joint.main]{after}"))
}

/// Every law of normal force once, and every law of friction once.
fn contacts() -> Vec<String> {
    const STEEL: &str = "restitution = 0.83\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3";
    let normal = NormalDescription::all().map(|law| {
        let numbers = match law {
            NormalDescription::Linear(law) if law.has_given_damping() => {
                "stiffness = \"2.3e8 N/m\"\ndamping_coefficient = \"900 N s/m\""
            }
            NormalDescription::Linear(_) => "stiffness = \"2.3e8 N/m\"\nrestitution = 0.83",
            _ => STEEL,
        };
        format!("law = \"{}\"\n{numbers}", law.name())
    });
    let friction = FRICTION_LAWS.iter().map(|law| {
        let numbers = law.numbers.iter().filter(|number| number.usual.is_none()).map(|number| match number.name() {
            "coefficient" => "coefficient = 0.07",
            "static_coefficient" => "static_coefficient = 0.11",
            "stribeck_speed" => "stribeck_speed = \"30 mm/s\"",
            "decay" => "decay = \"21 s/m\"",
            "bristle_stiffness" => "bristle_stiffness = \"1e5 m^-1\"",
            key => panic!("no value for {key}"),
        });
        let numbers: Vec<&str> = numbers.collect();
        let friction = format!("friction = {{ law = \"{}\", {} }}", law.name, numbers.join(", "));
        format!("law = \"johnson\"\n{STEEL}\n{friction}")
    });
    normal.chain(friction).collect()
}

#[test]
fn identity_every_contact_law_keeps_the_energy_account_and_its_bits_in_lanes() {
    /// Largest residual over largest exchange: a few orders of magnitude above what tolerances of 1e-8 m leave.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    /// Long enough for some contacts.
    const TURNS: f64 = 0.15;
    let settings = Settings::for_study();
    for contact in contacts() {
        let case = slider_crank_with(&contact);
        let order: Vec<usize> = (0..RUNS).collect();
        let alone = conducted(&case, order.clone(), TURNS, Execution::Scalar, &settings);
        assert!(alone.iter().all(|seen| seen.contacts.len() > 1), "{contact}\nhas no contact");
        for seen in &alone {
            let residual = seen.report.as_ref().and_then(|report| report.energy).expect("a report").relative_residual();
            assert!(residual < ENERGY_RESIDUAL, "{contact}\nhas a residual of {residual:e}");
        }
        for execution in [Execution::best(), Execution::Interpreted] {
            let together = conducted(&case, order.clone(), TURNS, execution, &settings);
            for (index, (one, other)) in alone.iter().zip(&together).enumerate() {
                assert_eq!(one, other, "{contact}\nrun {index}, {}", execution.name());
            }
        }
    }
}

#[test]
fn identity_films_of_oil_keep_the_energy_account_and_their_bits_in_lanes() {
    const STEEL: &str = "restitution = 0.83\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3";
    /// As for dry contact.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    /// The gudgeon oscillates within that, so that w goes through zero.
    const TURNS: f64 = 0.03;
    let settings = Settings::for_study();
    // A thick oil, and one so thin that the pin breaks through it, with friction then.
    let thick = FILM_LAWS.iter().map(|law| format!("law = \"{}\", viscosity = \"0.4 Pa s\"", law.name));
    let films = thick.chain(["viscosity = \"0.003 Pa s\"".to_owned()]);
    for film in films {
        let friction = "friction = { coefficient = 0.06 }";
        let case = slider_crank_with(&format!("{STEEL}\n{friction}\nfilm = {{ {film}, roughness = \"9 um\" }}"));
        let order: Vec<usize> = (0..RUNS).collect();
        let alone = conducted(&case, order.clone(), TURNS, Execution::Scalar, &settings);
        for seen in &alone {
            let residual = seen.report.as_ref().and_then(|report| report.energy).expect("a report").relative_residual();
            assert!(seen.steps.len() > 3 && residual < ENERGY_RESIDUAL, "{film}\nhas a residual of {residual:e}");
        }
        for execution in [Execution::best(), Execution::Interpreted] {
            let together = conducted(&case, order.clone(), TURNS, execution, &settings);
            for (index, (one, other)) in alone.iter().zip(&together).enumerate() {
                assert_eq!(one, other, "{film}\nrun {index}, {}", execution.name());
            }
        }
    }
}

/// Longer than the evaluations after which a run alone goes on as machine code: over roots of penetrations, with friction, with loops that
/// are held, and with pieces of a drive's motion.
#[test]
fn identity_a_long_run_alone_has_the_same_bits_as_one_without_machine_code() {
    const LONG: u64 = 13_000;
    for (name, turns) in [
        ("slider_crank_5000", 1.0),
        ("slider_crank_friction", 1.0),
        ("six_bar", 0.4),
        ("slider_crank_table_drive.toml", 1.0),
    ] {
        let case = Case { readings: Vec::new(), inside: Vec::new(), ..case(name) };
        let settings = Settings::for_study();
        let expected = &conducted(&case, vec![0], turns, Execution::Scalar, &settings)[0];
        let seen = vec![Seen::default(); RUNS];
        let mut waiting = Waiting { case: &case, order: vec![0], turns, is_attentive: true, instants: INSTANTS, seen };
        let Run { sample, window, mut observer, .. } = waiting.next().expect("one run");
        let outcome = loosepin_simulate::run(&case.mechanism, &sample, &window, &settings, &mut observer);
        waiting.finished(observer, outcome);
        let found = &waiting.seen[0];
        let evaluations = found.report.as_ref().expect("a report").counters.evaluations;
        assert!(evaluations > LONG, "{name}: {evaluations} evaluations are not long");
        assert!(found == expected, "{name}");
    }
}

#[test]
fn identity_a_run_is_not_changed_by_who_looks_at_it() {
    let case = case("six_bar");
    let mut reports: Vec<Vec<Option<RunReport>>> = Vec::new();
    for readings in [case.readings.clone(), Vec::new()] {
        let case =
            Case { mechanism: case.mechanism.clone(), readings, inside: Vec::new(), turn_s: case.turn_s, other: None };
        let seen = conducted(&case, (0..RUNS).collect(), 0.03, Execution::best(), &Settings::for_study());
        let without_findings = |report: RunReport| RunReport { findings: Findings::default(), ..report };
        reports.push(seen.into_iter().map(|seen| seen.report.map(without_findings)).collect());
    }
    assert_eq!(reports[0], reports[1]);
}

/// Work of one turn of the nominal slider-crank at the accuracy of a study, and of mechanisms with other traits: what a change of
/// the integrator, of the events or of the tolerances shows first. From our own last run.
#[test]
fn pinned_counts_of_reference_cases() {
    struct Nobody;
    impl Observer for Nobody {
        fn step(&mut self, _step: &mut Step<'_, '_>) {}
    }
    let mut found = Vec::new();
    for (name, turns) in [
        ("slider_crank_5000", 1.0),
        ("slider_crank_two_clearances", 0.25),
        ("slider_crank_friction", 1.0),
        ("six_bar", 0.25),
    ] {
        let case = case(name);
        let sample = Sample::new(&case.mechanism, &case.mechanism.model.quantities.nominal()).expect("nominal");
        let window = Window { start_s: 0.0, end_s: turns * case.turn_s };
        let report = loosepin_simulate::run(&case.mechanism, &sample, &window, &Settings::for_study(), &mut Nobody);
        let RunCounters { steps, rejections, evaluations, contact_changes, .. } =
            report.expect("the cases run").counters;
        found.push((name, [evaluations, steps, rejections, contact_changes]));
    }
    let expected = [
        ("slider_crank_5000", [12386, 785, 191, 49]),
        ("slider_crank_two_clearances", [8047, 542, 95, 30]),
        ("slider_crank_friction", [15396, 786, 317, 35]),
        ("six_bar", [8282, 536, 77, 29]),
    ];
    assert_eq!(found, expected, "evaluations, steps, rejections, events");
}

/// Operations of an evaluation of the equations of the slider-crank, counted in the programs that its machine code is made of:
/// within a step, with and without penetrations that are read off the positions, and at its end, where the slider's position is read. `measured/performance.md` holds time against them.
#[test]
fn pinned_operations_of_the_slider_crank() {
    let Case { mechanism, readings, .. } = case("slider_crank_5000");
    let nominal = mechanism.model.quantities.nominal();
    let sample = Sample::new(&mechanism, &nominal).expect("nominal");
    let arms = Arms::new(&mechanism, &nominal);
    let programs =
        PassPrograms::new(&mechanism, &sample, &arms, &Follow::readings(&readings[..1]), &Settings::for_study());
    let PassPrograms { slope, slope_by_roots, end, hold_loops, .. } = programs;
    assert!(hold_loops.is_none(), "no loop of ideal joints is to be held");
    let expected = OperationCounts {
        multiply_adds: 33,
        additions: 17,
        multiplications: 61,
        divisions: 3,
        square_roots: 2,
        choices: 7,
        signs: 1,
        inputs: 30,
        constants: 11,
        outputs: 9,
    };
    assert_eq!(slope.counts(), expected, "within a step");
    let by_roots = OperationCounts {
        additions: 15,
        multiplications: 60,
        divisions: 2,
        square_roots: 1,
        choices: 5,
        inputs: 27,
        ..expected
    };
    assert_eq!(slope_by_roots.map(|program| program.counts()), Some(by_roots), "with no penetration off the positions");
    let expected = OperationCounts {
        multiply_adds: 62,
        additions: 33,
        multiplications: 90,
        divisions: 5,
        choices: 24,
        signs: 7,
        inputs: 26,
        constants: 25,
        outputs: 27,
        ..expected
    };
    assert_eq!(end.counts(), expected, "at the end of a step");
}
