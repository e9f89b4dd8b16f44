//! A sweep over the clearance of the gudgeon: motion that repeats itself, then windows of motion that does not.

use loosepin::result::repeat::Repeat;
use loosepin::sweep::record::{SweepPoint, SweepRecord, SweptJoint, SweptOutput};
use loosepin::units::{DisplayUnits, SiUnit};

/// Values of the clearance.
const VALUES: usize = 61;
/// Turns that are looked at.
const TURNS: u32 = 32;

/// More kinds of motion than the first screen of a page has rows for, and two outputs.
pub fn windows() -> SweepRecord {
    let output =
        |name: &str, words: &str, unit: SiUnit| SweptOutput { name: name.to_owned(), words: words.to_owned(), unit };
    SweepRecord {
        repeat: Repeat::default(),
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        overrides: Vec::new(),
        path: "joint.gudgeon.radial_clearance".to_owned(),
        unit: SiUnit::LENGTH,
        drive: "crank".to_owned(),
        section_angle_rad: 0.0,
        transient_turns: 200,
        recorded_turns: TURNS,
        tolerance_m: 1e-8,
        outputs: vec![
            output("slider", "x of slider.pin", SiUnit::LENGTH),
            output("rod", "angle of rod", SiUnit::ANGLE),
        ],
        joints: vec!["crank_pin".to_owned(), "gudgeon".to_owned()],
        points: (0..VALUES).map(point).collect(),
        display_units: DisplayUnits::default(),
    }
}

fn point(place: usize) -> SweepPoint {
    let clearance_m = 1e-5 + 8e-6 * place as f64;
    let period_turns = match place / 5 {
        0 | 1 => Some(1),
        window if window % 2 == 0 => Some(window as u32 / 2 + 1),
        _ => None,
    };
    // The logistic map stands for what does not repeat itself.
    let mut state = 0.3 + 1e-3 * place as f64;
    let section = (0..TURNS).map(|turn| {
        state = 3.9 * state * (1.0 - state);
        let share = period_turns.map_or(state, |period| f64::from(turn % period) / f64::from(period));
        clearance_m * (0.2 + 0.8 * share)
    });
    let lengths_m: Vec<f64> = section.collect();
    let angles_rad = lengths_m.iter().map(|length_m| length_m / 0.12).collect();
    let joint = |share: f64| SweptJoint {
        impacts_per_turn: share * 0.2 * place as f64,
        flight_share: share * 3e-3 * place as f64,
        losses_per_turn: share * 0.2 * place as f64,
        peak_force_n: share * (2500.0 + 600.0 * place as f64),
        largest_penetration_m: share * 1e-6 * place as f64,
    };
    SweepPoint {
        value_si: clearance_m,
        failure: None,
        period_turns,
        sections_si: vec![lengths_m, angles_rad],
        joints: vec![joint(0.6), joint(1.0)],
    }
}
