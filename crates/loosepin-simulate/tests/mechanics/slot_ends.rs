//! A disc that flies along a slot into its round ends, against closed forms: when it meets an end, how fast, and how it leaves.

use crate::case::case;
use loosepin_simulate::{Observer, Onset, Separation, Settings, Step, Window, run};

const HALF_LENGTH_M: f64 = 0.05;
const MASS_KG: f64 = 0.1;
const GRAVITY_M_S2: f64 = 9.81;

/// A bar that turns at 1 rad/s and sets the longest step, 65 ms; and a disc in a slot of the ground.
fn disc_in_a_slot(gravity_m_s2: f64, clearance_m: f64, place_m: [f64; 2], velocity_m_s: [f64; 2]) -> String {
    let [x_m, y_m] = place_m;
    let [x_m_s, y_m_s] = velocity_m_s;
    format!(
        "name = \"disc\"\ngravity = \"{gravity_m_s2} m/s^2\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"], s = [\"200 mm\", \"0 mm\"] }}\n\
         [body.bar]\nmass = \"0.3 kg\"\ninertia = \"1e-3 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
         points = {{ root = [\"0 mm\", \"0 mm\"] }}\n\
         [body.disc]\nmass = \"{MASS_KG} kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
         points = {{ centre = [\"0 mm\", \"0 mm\"] }}\n\
         [contact.steel]\nlaw = \"exact-restitution\"\nrestitution = 0.8\nyoungs_modulus = \"207 GPa\"\n\
         poisson_ratio = 0.3\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
         [joint.slot]\nkind = \"slot\"\nslot = {{ point = \"ground.s\", angle = \"90 deg\" }}\npin = \"disc.centre\"\n\
         half_length = \"{HALF_LENGTH_M} m\"\nend_radius = \"10 mm\"\nclearance = \"{clearance_m} m\"\n\
         contact = \"steel\"\n\
         [drive.bar]\njoint = \"main\"\nspeed = \"1 rad/s\"\nstart_angle = \"0.7 rad\"\n\
         [initial.body.disc]\nposition = [\"{} m\", \"{y_m} m\"]\nvelocity = [\"{x_m_s} m/s\", \"{y_m_s} m/s\"]\n\
         angle = \"0 deg\"\nangular_velocity = \"0 rad/s\"\n\
         [cycle]\nduration = \"1 s\"\n",
        0.2 + x_m
    )
}

/// Contacts of a run: when each begins and ends, s, and the speeds there, m/s.
#[derive(Debug, Default)]
struct Contacts {
    begins: Vec<[f64; 2]>,
    ends: Vec<[f64; 2]>,
    steps: u64,
}

impl Observer for Contacts {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
    fn contact_begins(&mut self, onset: &Onset) {
        self.begins.push([onset.time_s, onset.speed_m_s]);
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.ends.push([separation.time_s, separation.speed_m_s]);
    }
}

fn contacts(text: &str, tolerance_m: f64, end_s: f64) -> Contacts {
    let case = case(text);
    let settings = Settings { tolerance_m, ..Settings::for_simulation() };
    let mut contacts = Contacts::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(&case.mechanism, &case.sample, &window, &settings, &mut contacts).expect("the run is sound");
    assert_eq!(report.plays[0].contacts, contacts.begins.len() as u64, "all of them are counted");
    contacts.steps = report.counters.steps;
    contacts
}

/// The disc is thrown up and turns back just beyond the end, within one step: it is as far from the walls at both ends of that step.
#[test]
fn analytic_a_disc_that_turns_back_in_the_end_of_a_slot_meets_it() {
    /// Of times, s, and of speeds.
    const ERROR: f64 = 1e-9;
    let mut flights = 0;
    for clearance_m in [1e-5, 1e-4] {
        for tolerance_m in [1e-6, 1e-9] {
            for over_m in [2e-7, 2e-6] {
                for start_m in (0..24).map(|k| 0.0497 - 0.0021 * f64::from(k)) {
                    let speed_m_s = (2.0 * GRAVITY_M_S2 * (HALF_LENGTH_M + clearance_m + over_m - start_m)).sqrt();
                    let due_m_s = (2.0 * GRAVITY_M_S2 * over_m).sqrt();
                    let due_s = (speed_m_s - due_m_s) / GRAVITY_M_S2;
                    let text = disc_in_a_slot(GRAVITY_M_S2, clearance_m, [0.0, start_m], [0.0, speed_m_s]);
                    let found = contacts(&text, tolerance_m, 1.9 * speed_m_s / GRAVITY_M_S2);
                    let label = format!("{over_m:e} m over from {start_m} m at {tolerance_m:e} m");
                    assert_eq!((found.begins.len(), found.ends.len()), (1, 1), "{label}");
                    let [time_s, found_m_s] = found.begins[0];
                    assert!((time_s - due_s).abs() < ERROR, "{label}: {time_s} s for {due_s}");
                    assert!((found_m_s / due_m_s - 1.0).abs() < ERROR, "{label}: {found_m_s} m/s for {due_m_s}");
                    flights += 1;
                }
            }
        }
    }
    assert_eq!(flights, 192);
}

/// Without gravity it flies evenly from end to end, and leaves each with 0.8 of its speed.
#[test]
fn analytic_even_flights_from_end_to_end() {
    /// Of the speed after a contact over that before.
    const RESTITUTION_ERROR: f64 = 1e-9;
    /// Of a time over that of a flight.
    const TIME_ERROR: f64 = 1e-11;
    /// 26 of both contacts beside those of the flights, the shortest steps first.
    const MAX_STEPS: u64 = 200;
    let clearance_m = 1e-5;
    let end_m = HALF_LENGTH_M + clearance_m;
    for speed_m_s in [0.1, 1.0, 10.0] {
        for start_m in (0..12).map(|k| 0.0497 - 0.0073 * f64::from(k)) {
            let due_s = (end_m - start_m) / speed_m_s;
            let back_s = 2.0 * end_m / (0.8 * speed_m_s);
            let text = disc_in_a_slot(0.0, clearance_m, [0.0, start_m], [0.0, speed_m_s]);
            let found = contacts(&text, 1e-9, due_s + 1.3 * back_s);
            let label = format!("{speed_m_s} m/s from {start_m} m");
            assert_eq!((found.begins.len(), found.ends.len()), (2, 2), "{label}");
            let ([first, second], left) = ([found.begins[0], found.begins[1]], found.ends[0]);
            assert!((first[0] - due_s).abs() < TIME_ERROR * due_s, "{label}: {} s for {due_s}", first[0]);
            assert!((second[0] - left[0] - back_s).abs() < RESTITUTION_ERROR * back_s, "{label}");
            assert!((first[1] / speed_m_s - 1.0).abs() < TIME_ERROR, "{label}");
            for ([_, before_m_s], [_, after_m_s]) in [(first, left), (second, found.ends[1])] {
                assert!((after_m_s / before_m_s - 0.8).abs() < RESTITUTION_ERROR, "{label}: {after_m_s}");
            }
            assert!(found.steps < MAX_STEPS, "{label}: {} steps", found.steps);
        }
    }
}

/// A slot that turns about its middle at 5 rad/s, and a disc that flies straight on: seen from the slot it drifts across.
fn disc_in_a_turning_slot(start_m: f64, speed_m_s: f64) -> String {
    disc_in_a_slot(0.0, WIDE_M, [0.0; 2], [0.0; 2])
        .replace("point = \"ground.s\", angle = \"90 deg\"", "point = \"bar.root\", angle = \"0 deg\"")
        .replace("speed = \"1 rad/s\"", &format!("speed = \"{TURN_RAD_S} rad/s\""))
        .replace("position = [\"0.2 m\", \"0 m\"]\nvelocity = [\"0 m/s\", \"0 m/s\"]\n", "")
        + &format!("[initial.joint.slot]\nposition = \"{start_m} m\"\nvelocity = \"{speed_m_s} m/s\"\n")
}

const TURN_RAD_S: f64 = 5.0;
const WIDE_M: f64 = 1e-3;

/// δ and δ̇ of that flight at a time, and whether the disc is in an end.
fn drifting(start_m: f64, speed_m_s: f64, time_s: f64) -> ([f64; 2], bool) {
    // Of the flight in the axes of the slot at time zero, then turned into those of the slot.
    let (x, y) = (start_m + speed_m_s * time_s, TURN_RAD_S * start_m * time_s);
    let (x_rate, y_rate) = (speed_m_s, TURN_RAD_S * start_m);
    let (sine, cosine) = (TURN_RAD_S * time_s).sin_cos();
    let (along, across) = (x * cosine + y * sine, y * cosine - x * sine);
    let along_rate = x_rate * cosine + y_rate * sine + TURN_RAD_S * across;
    let across_rate = y_rate * cosine - x_rate * sine - TURN_RAD_S * along;
    let past = along - along.clamp(-HALF_LENGTH_M, HALF_LENGTH_M);
    let off = past.hypot(across);
    ([off - WIDE_M, (past * along_rate + across * across_rate) / off], past != 0.0)
}

/// Time, s, and speed, m/s, of the first contact of that flight, and whether it is in an end.
fn first_wall(start_m: f64, speed_m_s: f64) -> ([f64; 2], bool) {
    const INSTANT_S: f64 = 1e-5;
    let depth_m = |time_s: f64| drifting(start_m, speed_m_s, time_s).0[0];
    let mut high_s = INSTANT_S;
    while depth_m(high_s) < 0.0 {
        high_s += INSTANT_S;
    }
    let mut low_s = high_s - INSTANT_S;
    for _ in 0..60 {
        let middle_s = 0.5 * (low_s + high_s);
        if depth_m(middle_s) < 0.0 { low_s = middle_s } else { high_s = middle_s }
    }
    let ([_, rate_m_s], is_in_end) = drifting(start_m, speed_m_s, high_s);
    ([high_s, rate_m_s], is_in_end)
}

/// Oblique flights into both ends, out of them and onto the faces meet the wall that is first in their way.
#[test]
fn analytic_oblique_flights_meet_the_first_wall() {
    /// Of times, s, and of speeds.
    const ERROR: f64 = 1e-8;
    let (mut at_faces, mut in_ends) = (0, 0);
    for flight in 0..96 {
        // From 8 mm before an end to 0.6 mm beyond it, to and fro.
        let share = (f64::from(flight) * 0.618_034).fract();
        let side = if flight % 2 == 0 { 1.0 } else { -1.0 };
        let start_m = side * (HALF_LENGTH_M - 8e-3 + 8.6e-3 * share);
        let speed_m_s = [0.3, 0.1, -0.2, 0.03][flight as usize / 2 % 4];
        let ([due_s, due_m_s], is_in_end) = first_wall(start_m, speed_m_s);
        let found = contacts(&disc_in_a_turning_slot(start_m, speed_m_s), 1e-9, due_s + 1e-4);
        let [time_s, found_m_s] = *found.begins.first().unwrap_or(&[f64::NAN; 2]);
        let label = format!("from {start_m} m at {speed_m_s} m/s");
        assert!((time_s - due_s).abs() < ERROR, "{label}: {time_s} s for {due_s}");
        assert!((found_m_s / due_m_s - 1.0).abs() < ERROR, "{label}: {found_m_s} m/s for {due_m_s}");
        in_ends += usize::from(is_in_end);
        at_faces += usize::from(!is_in_end);
    }
    println!("{in_ends} in ends, {at_faces} at faces");
    assert!(in_ends > 30 && at_faces > 30, "{in_ends} in ends, {at_faces} at faces");
}
