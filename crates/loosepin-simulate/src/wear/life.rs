//! Cycles of a mechanism whose worn joints act back.

use super::joint::WearingJoint;
use super::jumps::{Cycle, Depths, JumpLength, Life, life};
use super::recorder::WearRecorder;
use crate::engine::run_from;
use crate::failure::RunFailure;
use crate::ideal::column::{Column, columns};
use crate::ideal::reference::IdealReference;
use crate::lanes::batch::CompiledCodeCache;
use crate::observer::{Observer, Step};
use crate::resume::MotionState;
use crate::settings::{Settings, Window};
use crate::stepping::search::{maximum_within, may_exceed};
use crate::stoppable_observer::StoppableObserver;
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample, SampleError};
use loosepin_mechanics::model::{CycleJumps, Values, WearGeometry};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Points of each step at which deviations are looked at, before their largest is located.
const POINTS_PER_STEP: usize = 5;

/// The plan of a life: how each of its cycles is run.
#[derive(Debug, Clone, Copy)]
pub struct LifePlan<'a> {
    /// Numbers of the mechanism.
    pub values: &'a Values,
    /// The recorded part of each cycle.
    pub window: Window,
    /// Turns in it.
    pub turns: f64,
    /// Accuracy.
    pub settings: &'a Settings,
}

/// The wear of all cycles where the worn shape of `mechanism` acts back; `None` if its model holds the unworn shape. Afterwards
/// `sample` is worn.
///
/// Each cycle starts from the ideal positions and velocities, as every run does, on a shape that is held meanwhile.
///
/// # Errors
/// The reason why a cycle failed; a joint that wears has no play; too many jumps; `stop` was set.
pub fn worn_life(
    mechanism: &Mechanism,
    sample: &mut Sample<f64>,
    plan: &LifePlan<'_>,
    stop: &AtomicBool,
) -> Result<Option<Life>, RunFailure> {
    let Some(WearGeometry::Worn(jumps)) = mechanism.model.wear.map(|life| life.geometry) else { return Ok(None) };
    let length = match jumps {
        CycleJumps::Equal(count) => JumpLength::Equal(count),
        CycleJumps::Controlled(tolerance) => JumpLength::Controlled { tolerance_m: plan.values[tolerance] },
    };
    let joints = WearingJoint::all(mechanism, plan.values);
    if let Some(joint) = joints.iter().find(|joint| joint.play.is_none()) {
        return Err(RunFailure::WornWithoutPlay { joint: mechanism.model.joints[joint.joint.0].name.clone() });
    }
    let cycles = joints.first().map_or(1.0, |joint| joint.cycles);
    let start: Depths = joints.iter().map(|joint| [0, 1].map(|_| vec![0.0; joint.sectors])).collect();
    let ideal = mechanism.without_play();
    let ideal_sample = sample.clone().without_play();
    let mut cycle = |depths_m: &Depths| {
        wear(sample, &joints, depths_m);
        let reference = IdealReference::new(&ideal, &ideal_sample, plan.window.end_s, plan.settings)?;
        run_cycle(mechanism, sample, reference, plan, stop, None)
    };
    let life = life(cycles, length, start, &mut cycle)?;
    wear(sample, &joints, &life.last().depths_m);
    Ok(Some(life))
}

/// Puts worn shapes into a sample.
fn wear(sample: &mut Sample<f64>, joints: &[WearingJoint], depths_m: &Depths) {
    for (joint, [bearing_m, journal_m]) in joints.iter().zip(depths_m) {
        let play = joint.play.and_then(|play| sample.plays.get_mut(play));
        if let Some(foundation) = play.and_then(|play| play.foundation.as_mut()) {
            *foundation = Arc::new(foundation.worn([bearing_m, journal_m]));
        }
    }
}

/// A cycle on the shape of `sample`, from the ideal start or from where another run ended.
fn run_cycle(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    reference: IdealReference<'_>,
    plan: &LifePlan<'_>,
    stop: &AtomicBool,
    resume: Option<MotionState>,
) -> Result<Cycle, RunFailure> {
    let columns = columns(&mechanism.model);
    let mut observer = CycleObserver {
        arms: Arms::new(mechanism, plan.values),
        deviations_si: vec![0.0; columns.len()],
        with_forces: columns.iter().any(|column| column.reading.needs_forces()),
        columns,
        reference,
        wear: WearRecorder::new(mechanism, plan.values),
        turn_s: (plan.window.end_s - plan.window.start_s) / plan.turns,
        start_s: plan.window.start_s,
        path_of_turn_j: vec![0.0; plan.turns.floor() as usize],
        failure: None,
    };
    let mut watched = StoppableObserver { observer: &mut observer, stop };
    let report = run_from(
        mechanism,
        sample,
        (&plan.window, plan.settings),
        resume,
        &mut CompiledCodeCache::default(),
        &mut watched,
    )?;
    report.check_energy(&mechanism.model)?;
    if let Some(failure) = observer.failure {
        return Err(failure.into());
    }
    let WearRecorder { joints, profiles, .. } = &observer.wear;
    let foundation = |joint: &WearingJoint| sample.plays[joint.play?].foundation.as_deref();
    let mut stiffening = 0.0_f64;
    let mut cycle = Cycle {
        growth_m: Vec::with_capacity(joints.len()),
        paths_j: joints.iter().map(|joint| joint.friction_path_j(&report, None)).collect(),
        stable_cycles: f64::INFINITY,
        noise: standard_error(&observer.path_of_turn_j),
        deviations_si: observer.deviations_si,
        clearances_m: Vec::with_capacity(joints.len()),
        patch_sectors: Vec::with_capacity(joints.len()),
    };
    for (joint, profile) in joints.iter().zip(profiles) {
        cycle.growth_m.push([0, 1].map(|side| {
            let per_path = joint.coefficients_m2_n[side].unwrap_or(0.0) / joint.sector_area_m2(side);
            profile.path_j[side].iter().map(|path_j| per_path * path_j).collect()
        }));
        let foundation = foundation(joint)
            .ok_or_else(|| RunFailure::WornWithoutPlay { joint: mechanism.model.joints[joint.joint.0].name.clone() })?;
        stiffening = stiffening.max(profile.stiffening(joint.coefficients_m2_n, foundation.stiffness_pa_m));
        cycle.clearances_m.push(foundation.clearances_within_m(profile.turns_rad));
        cycle
            .patch_sectors
            .push(2.0 * profile.widest_m / (joint.radii_m[0] * std::f64::consts::TAU / joint.sectors as f64));
    }
    if stiffening > 0.0 {
        cycle.stable_cycles = 1.0 / stiffening;
    }
    if let Some(index) = joints
        .iter()
        .zip(&cycle.growth_m)
        .position(|(_, growth_m)| growth_m.iter().flatten().any(|growth_m| !growth_m.is_finite()))
    {
        return Err(RunFailure::WearNotFinite { joint: mechanism.model.joints[joints[index].joint.0].name.clone() });
    }
    Ok(cycle)
}

/// Standard error of a mean of turns over that mean; zero of fewer than two.
fn standard_error(of_turns: &[f64]) -> f64 {
    let count = of_turns.len() as f64;
    let mean = of_turns.iter().sum::<f64>() / count;
    if of_turns.len() < 2 || !(mean > 0.0) {
        return 0.0;
    }
    let squares = of_turns.iter().map(|own| (own - mean) * (own - mean)).sum::<f64>();
    (squares / (count * (count - 1.0))).sqrt() / mean
}

/// Takes in a cycle: wear by sectors, and deviations.
struct CycleObserver<'a> {
    arms: Arms,
    columns: Vec<Column>,
    with_forces: bool,
    reference: IdealReference<'a>,
    deviations_si: Vec<f64>,
    wear: WearRecorder,
    start_s: f64,
    turn_s: f64,
    /// Friction path of all joints in each whole turn, J.
    path_of_turn_j: Vec<f64>,
    failure: Option<SampleError>,
}

impl Observer for CycleObserver<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let total_j = |wear: &WearRecorder| wear.profiles.iter().map(|profile| profile.total_j).sum::<f64>();
        let before_j = total_j(&self.wear);
        self.wear.step(step);
        let turn = (0.5 * (step.start_s + step.end_s) - self.start_s) / self.turn_s;
        if let Some(own_j) = self.path_of_turn_j.get_mut(turn as usize) {
            *own_j += total_j(&self.wear) - before_j;
        }
        self.note_deviations(step);
    }
}

impl CycleObserver<'_> {
    /// The deviations of all columns from the ideal motion, SI.
    fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64) -> Vec<f64> {
        let dynamics = if self.with_forces { step.evaluate(time_s) } else { step.set_state(time_s) };
        match self.reference.at(time_s, self.with_forces) {
            Ok(ideal) => {
                let values = |column: &Column| {
                    column.reading.value(&self.arms, dynamics) - column.reading.value(&self.arms, ideal)
                };
                self.columns.iter().map(values).collect()
            }
            Err(error) => {
                self.failure.get_or_insert(error);
                vec![f64::NAN; self.columns.len()]
            }
        }
    }

    /// Takes in the largest deviations of a step, located as a history locates its own.
    fn note_deviations(&mut self, step: &mut Step<'_, '_>) {
        if self.columns.is_empty() || self.failure.is_some() {
            return;
        }
        let (start_s, end_s) = (step.start_s, step.end_s);
        self.reference.hold_pieces(0.5 * (start_s + end_s));
        let time_s = |k: usize| start_s + (end_s - start_s) * k as f64 / (POINTS_PER_STEP - 1) as f64;
        let looks: Vec<Vec<f64>> = (0..POINTS_PER_STEP).map(|k| self.look(step, time_s(k))).collect();
        for column in 0..self.deviations_si.len() {
            for sign in [-1.0, 1.0] {
                let points: Vec<(f64, f64)> =
                    looks.iter().enumerate().map(|(k, look)| (time_s(k), sign * look[column])).collect();
                if !may_exceed(&points, self.deviations_si[column]) {
                    continue;
                }
                let peak = maximum_within(&points, |time_s| sign * self.look(step, time_s)[column]);
                self.deviations_si[column] = self.deviations_si[column].max(peak.value);
            }
        }
    }
}

#[cfg(test)]
mod tests;
