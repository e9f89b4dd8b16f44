//! One run.

use std::f64::consts::TAU;

use loosepin::result::{ContactBasis, ContactShape, LongPinForce};
use loosepin::simulate::record::*;
use loosepin::study::result::Deviation;
use loosepin::units::{DisplayUnits, SiUnit};

use super::kinematics::{SPEED_RAD_S, Sample, angles_rad, drawing, orbit};

const CLEARANCE_M: f64 = 5e-4;
const TURNS: f64 = 2.0;

/// Two turns at 5000 rpm.
pub fn worn_pin() -> SimulationRecord {
    let sample = Sample::nominal(CLEARANCE_M);
    let angles = angles_rad(TURNS, 1001);
    let time_s: Vec<f64> = angles.iter().map(|angle| angle / SPEED_RAD_S).collect();
    let step_s = time_s[1];
    let actual: Vec<f64> = angles.iter().map(|angle| sample.slider(*angle).0).collect();
    let ideal: Vec<f64> = angles.iter().map(|angle| sample.ideal_slider(*angle).0).collect();
    let rate = |values: &[f64]| -> Vec<f64> {
        (0..values.len())
            .map(|row| {
                let (from, to) = (row.saturating_sub(1), (row + 1).min(values.len() - 1));
                (values[to] - values[from]) / (step_s * (to - from) as f64)
            })
            .collect()
    };
    let (velocity, ideal_velocity) = (rate(&actual), rate(&ideal));
    let (acceleration, ideal_acceleration) = (rate(&velocity), rate(&ideal_velocity));
    let impacts = impacts();
    let forces: Vec<f64> = time_s.iter().map(|time| force_n(*time, &impacts)).collect();
    let outputs = vec![
        output("slider", "x of slider.pin", SiUnit::LENGTH, &actual, &ideal),
        output("slider_velocity", "x velocity of slider.pin", SiUnit::VELOCITY, &velocity, &ideal_velocity),
        output(
            "slider_acceleration",
            "x acceleration of slider.pin",
            SiUnit::ACCELERATION,
            &acceleration,
            &ideal_acceleration,
        ),
    ];
    let extremes = outputs
        .iter()
        .map(|output| extreme(&output.name, Deviation::Value, &output.unit, &output.value_si, &time_s, &angles))
        .chain([extreme("slider", Deviation::Total, &SiUnit::LENGTH, &outputs[0].deviation_si, &time_s, &angles)])
        .collect();
    SimulationRecord {
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        repeat: Default::default(),
        overrides: vec![Override { path: "joint.gudgeon.radial_clearance".to_owned(), written: "0.5 mm".to_owned() }],
        settings: SimulationSettings {
            drive: "crank".to_owned(),
            drive_speed_rad_s: Some(SPEED_RAD_S),
            continued_at_s: None,
            transient_turns: 0.0,
            recorded_turns: TURNS,
            samples_per_turn: 500,
            tolerance_m: 1e-9,
            method: "DOP853 with regularised contact".to_owned(),
        },
        stop: StopReason::Finished,
        counters: RunCounters {
            steps: 2381,
            rejections: 164,
            evaluations: 30_214,
            factorizations: 0,
            contact_changes: 2 * (impacts.len() as u64 + 3),
        },
        extremes,
        joints: vec![JointSummary {
            joint: "gudgeon".to_owned(),
            radial_clearance_m: CLEARANCE_M,
            law: "lankarani-nikravesh".to_owned(),
            basis: Some(ContactBasis {
                shape: ContactShape::Point { unused_length_m: None },
                is_law_named: true,
                minimum_impact_speed_m_s: Some(1e-3),
                largest_valid_speed_m_s: Some(0.05152),
                largest_valid_penetration_m: None,
            }),
            long_pin: Some(LongPinForce {
                law: "johnson".to_owned(),
                length_m: 0.02,
                is_length_given: false,
                force_n: Some(91_870.0),
            }),
            contacts: impacts.len() as u64 + 3,
            impacts: impacts.len() as u64,
            impacts_per_turn: Some(impacts.len() as f64 / TURNS),
            largest_penetration_m: 7.83e-5,
            peak_force_n: 45_870.0,
            largest_speed_m_s: 4.385827,
            nominal_restitution: Some(0.9),
            delivered_restitution: Some(0.9132),
            share_outside_validity: Some(1.0),
            floored_contacts: 3,
            flight_share: 0.634,
            losses_per_turn: 22.5,
        }],
        kind: Some(MotionKind {
            turns: 2,
            period_turns: None,
            repeat_share: 0.01,
            section_angle_rad: 0.0,
            journals: vec![JournalOrbit {
                joint: "gudgeon".to_owned(),
                label: String::new(),
                radial_clearance_m: CLEARANCE_M,
                x_m: vec![0.31e-3, -0.42e-3],
                y_m: vec![0.39e-3, 0.11e-3],
                drive_angle_rad: Vec::new(),
                force_n: Vec::new(),
            }],
            outputs: vec![SectionedOutput {
                name: "slider".to_owned(),
                unit: SiUnit::LENGTH,
                deviation_si: vec![0.31e-3, -0.42e-3],
            }],
        }),
        trust: Trust::Measured(MeasuredTrust {
            tolerance_m: 1e-10,
            method: "Tsitouras 5(4)".to_owned(),
            evaluations: None,
            share: 0.2,
            horizons: [(1e-5, 0.0151), (1e-6, 0.0132), (1e-7, 0.0098)]
                .map(|(length_m, until_s)| TrustHorizon {
                    length_m,
                    until_s: Some(until_s),
                    turns: Some(until_s * SPEED_RAD_S / TAU),
                    is_end: false,
                })
                .into(),
            whole_m: None,
            failure: None,
            time_s: vec![0.0, 0.0051, 0.0098, 0.0132, 0.0151, 0.0153],
            difference_m: vec![0.0, 3e-10, 1.9e-8, 2e-7, 1.9e-6, 2.1e-6],
        }),
        lyapunov: Some(LyapunovRecord {
            exponent_1_s: 378.2,
            standard_error_1_s: 11.4,
            lower_1_s: 354.3,
            upper_1_s: 402.1,
            kind: NeighbourKind::Part,
            turn_s: TAU / SPEED_RAD_S,
            transient_turns: 2.0,
            aligning_turns: 5,
            separation: 1e-7,
            growth: (0..40).map(|turn| 378.2 * TAU / SPEED_RAD_S + if turn % 2 == 0 { 0.7 } else { -0.7 }).collect(),
        }),
        energy: energy(&time_s),
        display_units: DisplayUnits::for_duration_s(time_s[time_s.len() - 1]),
        drive_angle_rad: angles.clone(),
        outputs,
        paths: Vec::new(),
        contact_forces: vec![ContactForceHistory { joint: "gudgeon".to_owned(), force_n: forces }],
        controls: Vec::new(),
        impacts,
        orbits: vec![orbit(&sample, "", TURNS)],
        drawing: drawing(&sample, true),
        leans: false,
        quasi_static_check: Vec::new(),
        measured: Vec::new(),
        wear: Vec::new(),
        life: None,
        bending: Vec::new(),
        end_state: None,
        time_s,
    }
}

fn output(name: &str, words: &str, unit: SiUnit, actual: &[f64], ideal: &[f64]) -> OutputHistory {
    OutputHistory {
        name: name.to_owned(),
        words: words.to_owned(),
        unit,
        magnitude_of_force_in: None,
        value_si: actual.to_vec(),
        ideal_si: ideal.to_vec(),
        deviation_si: actual.iter().zip(ideal).map(|(actual, ideal)| actual - ideal).collect(),
    }
}

fn extreme(name: &str, of: Deviation, unit: &SiUnit, values: &[f64], time_s: &[f64], angles: &[f64]) -> Extreme {
    let point = |row: usize| ExtremePoint { value_si: values[row], time_s: time_s[row], drive_angle_rad: angles[row] };
    let rows = || 0..values.len();
    let lowest = rows().min_by(|a, b| values[*a].total_cmp(&values[*b])).expect("the history has samples");
    let highest = rows().max_by(|a, b| values[*a].total_cmp(&values[*b])).expect("the history has samples");
    Extreme { name: name.to_owned(), of, unit: unit.clone(), minimum: point(lowest), maximum: point(highest) }
}

fn impacts() -> Vec<ImpactRecord> {
    let mut list = Vec::new();
    let mut time_s = 2.272849e-4;
    let mut speed_m_s = 4.385827;
    while time_s < TURNS * TAU / SPEED_RAD_S {
        list.push(ImpactRecord {
            time_s,
            drive_angle_rad: time_s * SPEED_RAD_S,
            joint: "gudgeon".to_owned(),
            speed_m_s,
            duration_s: 5.2e-5,
            peak_force_n: 45_870.0 * (speed_m_s / 4.385827_f64).powf(1.2),
            separation_speed_m_s: Some(0.913 * speed_m_s),
        });
        time_s += 4.1e-4 + 1.3e-4 * speed_m_s;
        speed_m_s = if speed_m_s < 0.25 { 3.1 } else { 0.62 * speed_m_s };
    }
    list
}

fn force_n(time_s: f64, impacts: &[ImpactRecord]) -> f64 {
    impacts
        .iter()
        .filter(|impact| (impact.time_s..impact.time_s + impact.duration_s).contains(&time_s))
        .map(|impact| {
            impact.peak_force_n * (std::f64::consts::PI * (time_s - impact.time_s) / impact.duration_s).sin().powf(1.5)
        })
        .fold(0.0, f64::max)
}

fn energy(time_s: &[f64]) -> EnergyAccount {
    let angle = |time: &f64| time * SPEED_RAD_S;
    let history = |value: &dyn Fn(&f64) -> f64| -> Vec<f64> { time_s.iter().map(value).collect() };
    let last = time_s[time_s.len() - 1];
    let lost = |time: &f64| 3.4 * (1.0 - (-6.0 * time / last).exp());
    let kinetic = |time: &f64| 70.0 + 42.0 * (2.0 * angle(time)).cos() + 2.0 * (19.0 * angle(time)).sin();
    let potential = |time: &f64| 0.1 * angle(time).sin();
    EnergyAccount {
        relative_residual: 3.1e-11,
        kinetic_j: history(&kinetic),
        potential_j: history(&potential),
        stored_j: history(&|_| 0.0),
        contact_loss_j: history(&lost),
        friction_loss_j: history(&|_| 0.0),
        damping_loss_j: Vec::new(),
        supplied_j: history(&|time| kinetic(time) + potential(time) + lost(time) - 112.0),
        residual_j: history(&|time| 2.3e-9 * (40.0 * angle(time)).sin() * time / last),
    }
}
