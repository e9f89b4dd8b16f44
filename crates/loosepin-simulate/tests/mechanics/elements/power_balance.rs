//! The power of drives and controls against energies and losses, in mechanisms with two clearances.

use super::{Built, build, file};
use loosepin_math::{Dual, Quintic};
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Sample;
use loosepin_simulate::{Arms, GAUSS, Observer, Reading, Settings, Step, Window, columns, run};
use std::path::Path;

/// Share of the peak power by which the balance of powers may fail.
const BALANCE: f64 = 1e-9;
/// Share of the largest energy exchanged by which work that is integrated by looks inside of steps may fail: positions there are
/// known to the tolerance of the run, and contacts are stiff.
const WORK: f64 = 1e-7;
/// Tolerance of the runs, m: a hundredth of that of a simulation.
const TOLERANCE_M: f64 = 1e-11;

fn case(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join("model.toml");
    std::fs::read_to_string(path).expect("the case is there")
}

fn replaced(text: &str, own: &str, by: &str) -> String {
    assert!(text.contains(own), "{own}");
    text.replace(own, by)
}

/// Mechanisms with two clearances each, whose power outputs are the last ones: rigid cranks and rods with friction; springs, dampers
/// and loads; a rotary and a linear drive; two controls.
fn with_two_clearances() -> [(Built, f64); 4] {
    let power_of = |text: &str, actuators: &[&str]| {
        let outputs = actuators.iter().enumerate().map(|(k, of)| format!("[output.power{k}]\npower_of = \"{of}\"\n"));
        build(&format!("{text}\n{}", outputs.collect::<String>()))
    };
    let rubbing = replaced(
        &case("slider_crank_two_clearances"),
        "restitution = 0.65\n",
        "restitution = 0.65\nfriction = { law = \"ambrosio\", coefficient = 0.07 }\n",
    );
    let with_elements = replaced(
        &file("slider_crank_elements.toml"),
        "journal = \"rod.big_end\"\n",
        "journal = \"rod.big_end\"\nbearing_radius = \"13 mm\"\nradial_clearance = \"0.3 mm\"\ncontact = \"steel_pin\"\n",
    );
    let five_bar = replaced(
        &case("five_bar_driven_slider"),
        "journal = \"left_link.low\"\n",
        "journal = \"left_link.low\"\nbearing_radius = \"6 mm\"\nradial_clearance = \"0.1 mm\"\ncontact = \"steel\"\n",
    );
    [
        (power_of(&rubbing, &["drive.crank"]), 0.03),
        (power_of(&with_elements, &["drive.crank"]), 0.012),
        (power_of(&five_bar, &["drive.left", "drive.slide"]), 0.06),
        (power_of(&file("two_link_arm_with_play.toml"), &["control.shoulder", "control.elbow"]), 0.2),
    ]
}

/// The power outputs of a mechanism, which have names of their own.
fn powers(built: &Built) -> Vec<Reading> {
    let all = columns(&built.mechanism.model).into_iter();
    all.filter(|column| column.name.starts_with("power")).map(|column| column.reading).collect()
}

/// What a run looks at: what its power outputs and loads supply, integrated over time, and the balance of powers on the way.
struct Balance<'l> {
    arms: Arms,
    powers: Vec<Reading>,
    /// The equations of motion at a state of the run.
    own: Dynamics<'l, f64>,
    /// The same on numbers that move along with the motion.
    moving: Dynamics<'l, Dual<f64>>,
    supplied_j: f64,
    peak_w: f64,
    defect_w: f64,
    in_contact: [usize; 3],
}

impl Balance<'_> {
    /// P - dE/dt - losses at a state of the run. Derivatives of the energies come from the motion alone, q̇ and q̈, by dual numbers;
    /// the roots of penetrations, which a run carries as unknowns, are read off the positions.
    fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64) {
        let contacts = step.set_state(time_s).mechanism().contacts.len();
        let closed: Vec<f64> = (0..contacts).map(|contact| f64::from(u8::from(step.is_in_contact(contact)))).collect();
        let seen = step.set_state(time_s);
        let (coordinates, rates) = seen.free_state();
        // Any speed of impact does: its energy loss is another one, and belongs to the balance.
        let touch = |&contact: &f64| PlayState { contact, inverse_impact_speed_s_m: 3.0, effective_mass_kg: 0.2 };
        let states: Vec<PlayState<f64>> = closed.iter().map(touch).collect();
        self.own.error_integrals_mut().copy_from_slice(seen.error_integrals());
        self.own.evaluate(time_s, coordinates, rates, &states);
        let supplied_w: f64 = self.powers.iter().map(|power| power.value(&self.arms, &self.own)).sum();
        let along = |values: &[f64], derivatives: &[f64]| -> Vec<Dual<f64>> {
            values.iter().zip(derivatives).map(|(&value, &derivative)| Dual { value, derivative }).collect()
        };
        let moving_rates = along(rates, self.own.accelerations());
        self.moving.set_state(Dual::variable(time_s), &along(coordinates, rates), &moving_rates);
        let energy = self.moving.energy_in(|contact| Dual::constant(closed[contact]));
        let of = self.own.powers();
        let lost_w = of.contact_loss_w + of.friction_loss_w + of.damping_loss_w;
        let defect_w = supplied_w + of.loads_w - energy.total_j().derivative - lost_w;
        self.peak_w = self.peak_w.max(supplied_w.abs());
        self.defect_w = self.defect_w.max(defect_w.abs());
        self.in_contact[closed.iter().filter(|closed| **closed > 0.0).count()] += 1;
        assert!(defect_w.is_finite());
    }
}

impl Observer for Balance<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        /// Parts of a step, each with Gauss's points.
        const PARTS: usize = 4;
        let [start, end] = [0, 1].map(|side| step.time(side));
        let time = Quintic::new(start, end, step.length);
        for part in 0..PARTS {
            for (place, weight) in GAUSS {
                let share = (part as f64 + place) / PARTS as f64;
                let dynamics = step.evaluate(time.value(share));
                let powers = self.powers.iter().map(|power| power.value(&self.arms, dynamics));
                let supplied_w = powers.sum::<f64>() + dynamics.powers().loads_w;
                self.supplied_j += weight / PARTS as f64 * time.slope(share) * supplied_w;
            }
        }
        let span_s = step.end_s - step.start_s;
        for place in [0.0, 0.3, 0.7, 1.0] {
            self.look(step, step.start_s + place * span_s);
        }
    }
}

/// What drives, controls and loads supply is what kinetic, potential and stored energy gain and what contact, friction and dampers
/// lose: at any instant, and from one event to the next over the whole run.
#[test]
fn identity_power_is_what_energies_gain_and_losses_take() {
    for (built, end_s) in with_two_clearances() {
        let name = &built.mechanism.model.name;
        let moving = Sample::<Dual<f64>>::new(&built.mechanism, &built.values).expect("the values fit");
        let mut balance = Balance {
            arms: Arms::new(&built.mechanism, &built.values),
            powers: powers(&built),
            own: Dynamics::new(&built.mechanism, &built.sample()),
            moving: Dynamics::new(&built.mechanism, &moving),
            supplied_j: 0.0,
            peak_w: 0.0,
            defect_w: 0.0,
            in_contact: [0; 3],
        };
        let settings = Settings { tolerance_m: TOLERANCE_M, ..Settings::for_simulation() };
        let window = Window { start_s: 0.0, end_s };
        let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut balance)
            .unwrap_or_else(|failure| panic!("{name}: {failure}"));
        assert!(balance.in_contact.iter().all(|states| *states > 20), "{name}: {:?}", balance.in_contact);
        let share = balance.defect_w / balance.peak_w;
        let account = report.energy.expect("it is integrated");
        let lost_j = account.contact_loss_j + account.friction_loss_j + account.damping_loss_j;
        let gained_j = account.at_end_j - account.at_start_j + lost_j;
        let open_j = (balance.supplied_j - gained_j).abs() / account.largest_exchange_j;
        assert!(share < BALANCE, "{name}: {} W of {} W are missing", balance.defect_w, balance.peak_w);
        assert!(open_j < WORK, "{name}: {} J supplied, {gained_j} J gained and lost", balance.supplied_j);
    }
}
