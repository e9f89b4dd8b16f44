//! The check of a dynamic run: its positions must respect the quasi-static worst case of the exact loops.

use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use super::overhang::overhanging;
use super::play_reach::PlayReach;
use super::position::{PositionOutput, position_outputs};
use super::worst_case::{WorstCaseExtremes, starts_on_borders, worst_case_extremes};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::Values;
use loosepin_result::simulation::{QuasiStaticShare, SimulationRecord};
use loosepin_text::units::SiUnit;

/// Relative round-off and iteration error of the worst case.
const RELATIVE_TOLERANCE: f64 = 1e-9;

/// Compares every recorded position of a run with the worst case of the exact loops over the play of all joints, each
/// clearance widened by δmax,k, the largest penetration of the run: |e_k| <= c_k + δmax,k for a journal.
///
/// `values` are those that the run was made with. A position counts as exceeded where it lies beyond by more than the
/// tolerance of the run and round-off. Where the loops cannot be closed everywhere within the clearances (a dead point lies
/// among them), or a slider overhangs an end of its guide, which lets it tilt further, there is no worst case: such samples are
/// counted. With a slider that can turn over in its
/// guide, or a follower that may lift off its cam, there is none at all, and no output is compared.
///
/// # Errors
/// The ideal mechanism of the run cannot be built or moved.
pub fn quasi_static_check(
    mechanism: &Mechanism,
    values: &Values,
    record: &SimulationRecord,
) -> Result<Vec<QuasiStaticShare>, AccuracyError> {
    let sample = Sample::new(mechanism, values)?;
    // Where forces move the mechanism, its ideal motion is no worst case of the real one: the two drift apart in time.
    // Flexible bodies give way beyond it.
    if sample.plays.is_empty() || !mechanism.is_driven() || mechanism.real.flexible_bodies().next().is_some() {
        return Ok(Vec::new());
    }
    // A follower that lifts off its cam goes as far as it flies.
    if sample.plays.iter().any(|play| play.shape.may_lift()) {
        return Ok(Vec::new());
    }
    let penetrations_m = record.joints.iter().map(|joint| joint.largest_penetration_m);
    let Ok(reaches) = PlayReach::of_sample(mechanism, &sample, penetrations_m) else { return Ok(Vec::new()) };
    let mut ideal = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    let mut loops = DisplacedLoops::new(mechanism, values);
    let mut compared: Vec<Compared<'_>> = position_outputs(mechanism)
        .into_iter()
        .filter_map(|output| {
            // Positions that only stand for a velocity or an acceleration were not recorded.
            let history = record.outputs.iter().find(|h| h.name == output.name && h.words == output.words)?;
            Some(Compared::new(output, &history.deviation_si))
        })
        .collect();
    for (row, time_s) in record.time_s.iter().enumerate() {
        ideal.move_to(*time_s)?;
        loops.set_position(ideal.coordinates());
        if overhanging(mechanism, &sample, &reaches, ideal.kinematics()).next().is_some() {
            compared.iter_mut().for_each(Compared::leave_out);
            continue;
        }
        for output in &mut compared {
            // An angle errs by what its length errs over the size of the mechanism.
            let scale_m = if output.output.unit == SiUnit::ANGLE { mechanism.size_m } else { 1.0 };
            output.compare(&mut loops, &reaches, row, *time_s, record.settings.tolerance_m / scale_m);
        }
    }
    Ok(compared.into_iter().map(|output| output.share).collect())
}

/// Puts the result of [`quasi_static_check`] into the record of the run.
///
/// # Errors
/// As [`quasi_static_check`].
pub fn check_quasi_static(
    mechanism: &Mechanism,
    values: &Values,
    record: &mut SimulationRecord,
) -> Result<(), AccuracyError> {
    record.quasi_static_check = quasi_static_check(mechanism, values, record)?;
    Ok(())
}

/// One output on its way through the samples.
struct Compared<'r> {
    output: PositionOutput,
    deviation_si: &'r [f64],
    /// Extremes at the sample before: the best starts for the next.
    starts: Vec<Vec<Vec2<f64>>>,
    share: QuasiStaticShare,
}

impl<'r> Compared<'r> {
    fn new(output: PositionOutput, deviation_si: &'r [f64]) -> Self {
        let share = QuasiStaticShare {
            output: output.name.clone(),
            unit: output.unit.clone(),
            largest_share: 0.0,
            time_s: None,
            deviation_si: 0.0,
            worst_case_si: 0.0,
            is_exceeded: false,
            samples_without_worst_case: 0,
        };
        Self { output, deviation_si, starts: Vec::new(), share }
    }

    /// Passes over a sample without a worst case.
    fn leave_out(&mut self) {
        self.share.samples_without_worst_case += 1;
        self.starts.clear();
    }

    fn compare(
        &mut self,
        loops: &mut DisplacedLoops<'_>,
        reaches: &[PlayReach],
        row: usize,
        time_s: f64,
        tolerance_si: f64,
    ) {
        let deviation_si = self.deviation_si[row];
        let mut found = worst_case_extremes(loops, self.output.reading, reaches, &self.starts);
        let is_beyond = |found: &WorstCaseExtremes| {
            deviation_si < found.lowest.deviation_si - tolerance_si
                || found.highest.deviation_si + tolerance_si < deviation_si
        };
        if is_beyond(&found) {
            // Another extreme may lie further out: the search is done again from more places.
            self.starts.extend(starts_on_borders(reaches));
            found = worst_case_extremes(loops, self.output.reading, reaches, &self.starts);
        }
        let WorstCaseExtremes { lowest, highest, is_blocked } = found;
        if is_blocked {
            self.leave_out();
            return;
        }
        let worst_case_si = if deviation_si < 0.0 { lowest.deviation_si } else { highest.deviation_si };
        let share = if deviation_si == 0.0 { 0.0 } else { deviation_si / worst_case_si };
        let slack_si = tolerance_si + RELATIVE_TOLERANCE * worst_case_si.abs();
        self.share.is_exceeded |= deviation_si.abs() > worst_case_si.abs() + slack_si;
        if share > self.share.largest_share {
            let found = &mut self.share;
            (found.largest_share, found.time_s) = (share, Some(time_s));
            (found.deviation_si, found.worst_case_si) = (deviation_si, worst_case_si);
        }
        self.starts = vec![lowest.displacements, highest.displacements];
    }
}
