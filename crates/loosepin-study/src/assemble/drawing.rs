//! The mechanism with nominal dimensions, drawn and moving, and the paths of its journals.

use super::material::Material;
use crate::file::Study;
use crate::file::{EpistemicInput, EpistemicSubject};
use crate::response::study_response::StudyResponse;
use loosepin_result::simulation::{Drawing, JournalOrbit, Trust};

/// Poses of the moving picture.
const POSES: usize = 180;
/// Samples of an orbit over the recorded turns.
const ORBIT_SAMPLES: usize = 720;

/// Drawings from runs with nominal dimensions.
pub struct Pictures {
    /// The mechanism, epistemic inputs in the middle.
    pub drawing: Drawing,
    /// Journal paths at the ends and the middle of each clearance interval, and for each member of a list of clearances or laws.
    pub orbits: Vec<JournalOrbit>,
    /// The row of the run with nominal dimensions and the epistemic inputs in the middle.
    pub nominal_row: Vec<f64>,
    /// How long the positions of that run can be trusted.
    pub nominal_trust: Trust,
}

/// Runs the nominal mechanism for the pictures. A picture whose run fails is left out: no finished study is lost for it.
pub fn pictures(material: &Material<'_>) -> Pictures {
    let (study, response) = (material.study, material.response);
    let middle: Vec<f64> = study.epistemic.iter().map(|input| input.variable.middle()).collect();
    let nominal = nominal_quantities(study, response);
    let mut nominal_row = vec![f64::NAN; response.row_length()];
    if response.run(&nominal, &middle, &mut nominal_row).is_err() {
        nominal_row.fill(f64::NAN);
    }

    let mut cycle = study.cycle.clone();
    cycle.samples_per_turn = (ORBIT_SAMPLES as f64 / cycle.recorded_turns).ceil() as usize;
    let run_at =
        |epistemic: &[f64], has_second_run: bool| response.drawn_run(&nominal, epistemic, &cycle, has_second_run);
    let offset_rad = recorded_offset_rad(study, response);
    let mut orbits: Vec<JournalOrbit> = Vec::new();
    let mut add = |label: String, mut found: Vec<JournalOrbit>| {
        for orbit in &mut found {
            orbit.label.clone_from(&label);
            orbit.drive_angle_rad.iter_mut().for_each(|angle| *angle -= offset_rad);
        }
        orbits.append(&mut found);
    };
    let mut drawing = response.skeleton();
    let mut nominal_trust = Trust::NotMeasured;
    if let Some(central) = run_at(&middle, true) {
        nominal_trust = central.record.trust;
        drawing = central.record.drawing.clone();
        thin(&mut drawing, offset_rad);
        let has_lists = study.epistemic.iter().any(|input| input.interval().is_none());
        let label = if has_lists {
            "unknown values in the middle of their intervals, of lists the first"
        } else {
            "unknown values in the middle of their intervals"
        };
        add(label.to_owned(), central.record.orbits);
    }
    let is_shown = |input: &EpistemicInput| {
        let is_play = |id| study.model.has_play_from(id);
        input.quantity().is_some_and(is_play) || matches!(input.subject, EpistemicSubject::Law { .. })
    };
    for (index, input) in study.epistemic.iter().enumerate().filter(|(_, input)| is_shown(input)) {
        for value in input.variable.representative_values() {
            let mut epistemic = middle.clone();
            epistemic[index] = value;
            if let Some(run) = run_at(&epistemic, false) {
                add(format!("{} = {}", input.path, input.written(&study.model, value)), run.record.orbits);
            }
        }
    }
    Pictures { drawing, orbits, nominal_row, nominal_trust }
}

/// Angle that the drive turned through before the recorded part in whole turns, rad: poses are shown without it.
fn recorded_offset_rad(study: &Study, response: &StudyResponse) -> f64 {
    let sign = study.model.input(study.cycle.span, response.nominal()).speed_rad_s.signum();
    sign * std::f64::consts::TAU * study.cycle.transient_turns.floor()
}

/// Keeps about as many poses as a moving picture needs, at angles of the recorded turns.
fn thin(drawing: &mut Drawing, offset_rad: f64) {
    for poses in [&mut drawing.poses, &mut drawing.ideal_poses] {
        let count = poses.drive_angle_rad.len();
        let stride = count.div_ceil(POSES).max(1);
        let keep = |list: &mut Vec<f64>| *list = list.iter().copied().step_by(stride).collect();
        keep(&mut poses.drive_angle_rad);
        poses.drive_angle_rad.iter_mut().for_each(|angle| *angle -= offset_rad);
        for lists in [&mut poses.x_m, &mut poses.y_m, &mut poses.angle_rad] {
            lists.iter_mut().for_each(keep);
        }
    }
    for beam in &mut drawing.beams {
        for list in beam.turns_rad.iter_mut().chain(&mut beam.axis_x_m).chain(&mut beam.axis_y_m) {
            let stride = list.len().div_ceil(POSES).max(1);
            *list = list.iter().copied().step_by(stride).collect();
        }
    }
}

/// The random inputs as they are nominally, without the places of journals.
fn nominal_quantities(study: &Study, response: &StudyResponse) -> Vec<f64> {
    study.random.iter().filter_map(|input| Some(response.nominal()[input.quantity()?])).collect()
}

#[cfg(test)]
mod tests {
    use super::{ORBIT_SAMPLES, nominal_quantities, pictures};
    use crate::assemble::few_runs::FewRuns;
    use crate::response::planar_response::PlanarResponse;
    use loosepin_result::simulation::PoseTable;
    use loosepin_simulate::{Plan, simulate, simulate_poses};
    use std::f64::consts::TAU;

    #[test]
    fn identity_orbits_and_poses_count_the_recorded_turn_from_zero() {
        let runs = FewRuns::after(1);
        let found = pictures(&runs.material(&runs.bounds.pairs));
        assert_eq!(found.drawing.drives.len(), 1);
        assert!(!found.drawing.output_points.is_empty());
        let orbit = &found.orbits[0];
        assert_eq!(orbit.x_m.len(), ORBIT_SAMPLES + 1);
        assert_eq!(orbit.force_n.len(), ORBIT_SAMPLES + 1);
        let angles = &orbit.drive_angle_rad;
        assert!(angles[0].abs() < 1e-9 && (angles[ORBIT_SAMPLES] - TAU).abs() < 1e-9, "{angles:?}");
        assert_eq!(angles[0], found.drawing.poses.drive_angle_rad[0]);
    }

    #[test]
    fn identity_poses_and_orbits_are_those_of_a_run_with_extremes() {
        let runs = FewRuns::after(1);
        let material = runs.material(&runs.bounds.pairs);
        let (study, response) = (material.study, material.response);
        let middle: Vec<f64> = study.epistemic.iter().map(|input| input.variable.middle()).collect();
        let nominal = nominal_quantities(study, response);
        let values = response.values(&nominal, &middle).unwrap();
        let planar = PlanarResponse::new(study).unwrap();
        let (cycle, settings) = (study.cycle.clone(), *planar.settings());
        let plan = Plan {
            cycle,
            settings,
            with_states: false,
            lyapunov_turns: None,
            second_run: false,
            overrides: Vec::new(),
        };
        let mechanism = &planar.mechanisms[response.variant(&middle)];
        let whole = simulate(mechanism, &values, &plan).unwrap();
        let mut poses = simulate_poses(mechanism, &values, &plan).unwrap();
        // Loops are closed from the pose that was asked for before: that differs.
        const ROUND_OFF: f64 = 1e-12;
        let numbers = |table: &PoseTable| [table.x_m.concat(), table.y_m.concat(), table.angle_rad.concat()].concat();
        let [own, due] = [&poses, &whole].map(|run| numbers(&run.record.drawing.ideal_poses));
        assert_eq!(own.len(), due.len());
        assert!(own.iter().zip(&due).all(|(own, due)| (own - due).abs() < ROUND_OFF), "{own:?} {due:?}");
        poses.record.drawing.ideal_poses = whole.record.drawing.ideal_poses.clone();
        assert_eq!(format!("{:?}", poses.record.orbits), format!("{:?}", whole.record.orbits));
        assert_eq!(format!("{:?}", poses.record.drawing), format!("{:?}", whole.record.drawing));
        assert!(poses.record.extremes.is_empty() && !whole.record.extremes.is_empty());
    }
}
