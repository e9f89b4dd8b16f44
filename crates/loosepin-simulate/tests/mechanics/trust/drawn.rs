//! Runs of drawn mechanisms: other clearances, restitutions, speeds and start angles than their files have.

use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{JointKind, Model, QuantityId, Steady, Values};
use std::path::Path;

/// The mechanisms on which the share of a length was chosen, by which two runs may differ: names in `cases/`.
pub(super) const CHOSEN_ON: [&str; 8] = [
    "cases/slider_crank_5000",
    "cases/slider_crank_two_clearances",
    "cases/slider_crank_friction",
    "cases/four_bar_600",
    "cases/four_bar_linear_contact",
    "cases/six_bar",
    "cases/six_bar_stephenson",
    "cases/four_bar_settling",
];

/// Those on which it is shown: all others with a drive and play.
pub(super) const SHOWN_ON: [&str; 31] = [
    "cases/backlash_test",
    "cases/eight_bar",
    "cases/engine_indicator_diagram",
    "cases/five_bar_driven_slider",
    "cases/five_bar_elbow_drive",
    "cases/five_bar_two_drives",
    "cases/four_bar_bronze_bushing",
    "cases/four_bar_coupler_path",
    "cases/four_bar_floating_coupler",
    "cases/four_bar_friction",
    "cases/four_bar_ground_journal",
    "cases/four_bar_three_clearances",
    "cases/geared_four_bar_backlash",
    "cases/inverted_slider_crank_literal",
    "cases/inverted_slider_crank_material",
    "cases/scotch_yoke",
    "cases/slider_crank_force_cut",
    "cases/slider_crank_given_stiffness",
    "cases/slider_crank_worn_pin",
    "crates/loosepin-import/templates/double-slider",
    "crates/loosepin-import/templates/four-bar",
    "crates/loosepin-import/templates/inverted-slider-crank",
    "crates/loosepin-import/templates/offset-slider-crank",
    "crates/loosepin-import/templates/pantograph",
    "crates/loosepin-import/templates/scotch-yoke",
    "crates/loosepin-import/templates/slider-crank",
    "crates/loosepin-import/templates/stephenson-six-bar",
    "crates/loosepin-import/templates/toggle-press",
    "crates/loosepin-import/templates/watt-six-bar",
    "crates/loosepin-import/templates/whitworth-quick-return",
    "crates/loosepin-import/templates/worn-press",
];

/// A clearance is at most this many times larger or smaller than in its file.
const CLEARANCE_FACTOR: f64 = 3.0;
/// A speed likewise.
const SPEED_FACTOR: f64 = 2.0;
/// A coefficient of restitution changes by this share of its distance from one at most.
const RESTITUTION_SHARE: f64 = 0.5;
/// A start angle is this much larger or smaller at most, rad.
const START_RAD: f64 = 0.5;
/// Draws until a mechanism can be put together.
const MAX_DRAWS: u64 = 50;

/// A mechanism with drawn numbers.
pub(super) struct DrawnRun {
    pub name: &'static str,
    pub mechanism: Mechanism,
    pub values: Values,
    pub sample: Sample<f64>,
    pub turn_s: f64,
}

/// Run `index` of those that `seed` draws from `names`, which take turns.
pub(super) fn drawn_run(names: &[&'static str], seed: u64, index: usize) -> DrawnRun {
    let name = names[index % names.len()];
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name).join("model.toml");
    let model = Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let nominal = model.quantities.nominal();
    let drawn = (0..MAX_DRAWS).find_map(|draw| {
        let values =
            drawn_values(&model, &nominal, mixed(seed.wrapping_mul(1_000_003) ^ ((index as u64) << 8) ^ draw))?;
        let mechanism = Mechanism::new(&model, &values).ok()?;
        let sample = Sample::new(&mechanism, &values).ok()?;
        mechanism.start(&sample).ok()?;
        let turn_s = mechanism.model.cycle_input(&values).turn_s();
        Some(DrawnRun { name, mechanism, values, sample, turn_s })
    });
    drawn.unwrap_or_else(|| panic!("{name}: no draw of {MAX_DRAWS} is a mechanism"))
}

fn drawn_values(model: &Model, nominal: &Values, mut state: u64) -> Option<Values> {
    let mut even = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        2.0 * ((mixed(state) >> 11) as f64 / (1_u64 << 53) as f64) - 1.0
    };
    let mut set: Vec<(QuantityId, f64)> = Vec::new();
    for (_, clearance) in model.play_clearances() {
        set.push((clearance, nominal[clearance] * CLEARANCE_FACTOR.powf(even())));
    }
    for restitution in model.contacts.iter().filter_map(|contact| contact.law.restitution()) {
        let room = 1.0 - nominal[restitution];
        set.push((restitution, nominal[restitution] + RESTITUTION_SHARE * room * even()));
    }
    for drive in &model.drives {
        if let Some(Steady { speed, start }) = drive.law.steady() {
            set.push((speed, nominal[speed] * SPEED_FACTOR.powf(even())));
            if let JointKind::Revolute { .. } = model.joints[drive.joint.0].kind {
                set.push((start, nominal[start] + START_RAD * even()));
            }
        }
    }
    set.retain(|(id, _)| model.quantities[*id].is_settable());
    model.quantities.evaluate(&set).ok()
}

/// SplitMix64's finaliser.
fn mixed(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
