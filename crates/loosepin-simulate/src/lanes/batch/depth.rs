//! Checks of a step: the depth of contacts, friction in ideal joints, and expressions without a value.

use super::Batch;
use crate::failure::RunFailure;
use crate::lanes::lane::LaneRun;
use crate::lanes::memory::LaneLayout;
use crate::lanes::pass::{MAX_RESIDUAL, step_in_time};
use crate::lanes::reads::ReadLayout;
use crate::stepping::gap::ContactStep;
use loosepin_mechanics::dynamics::WithoutValue;
use loosepin_mechanics::mechanism::{GapMeasure, SliderBlock, is_front_corner};

impl Batch<'_> {
    /// The drive, spring, load or control that has no value where the current step of a lane begins, or where it would end if all
    /// bodies went straight on.
    pub(super) fn element_without_value(&mut self, lane: usize) -> Option<WithoutValue> {
        let run = self.runs[lane].as_ref()?;
        self.viewed = run.number;
        self.view.dynamics.sample_mut().clone_from(&run.sample);
        for contact in 0..self.view.states.len() {
            self.view.states[contact] = self.core.contact(lane, contact).0;
        }
        let n = self.mechanism.real.free;
        let [time_s, pace, change] = self.times(lane)[0].jet;
        let step_s = step_in_time([pace, change], self.core.step(lane));
        for ahead_s in [0.0, 0.5 * step_s, step_s] {
            self.core.interpolate(lane, 0.0, &mut self.view_state);
            for k in 0..n {
                self.view_state[k] += ahead_s * self.view_state[n + k];
            }
            self.view.evaluate(time_s + ahead_s, &self.view_state);
            if let Some(lost) = self.view.dynamics.element_without_value() {
                return Some(lost);
            }
        }
        None
    }

    /// Path of the beam that swings fastest, where no step that is allowed follows it: k/m of stretching or bending in the time of the smallest step.
    pub(super) fn beam_beyond_steps(&self, lane: usize, smallest_s: f64) -> Option<String> {
        let sample = &self.runs[lane].as_ref()?.sample.real;
        let floating = sample.beams.iter().map(|numbers| {
            let beam = &numbers.beam;
            [beam.mass_kg, beam.length_m, beam.axial_stiffness_n_m, beam.bending_stiffness_n_m]
        });
        let nodal = sample.nodal_beams.iter().map(|numbers| {
            let beam = &numbers.beam;
            [beam.mass_kg, beam.length_m, beam.axial_stiffness_n_m, beam.bending_stiffness_n_m]
        });
        let square_1_s2 = |[mass_kg, length_m, axial_n_m, bending_n_m]: [f64; 4]| {
            axial_n_m.max(bending_n_m / (length_m * length_m)) / mass_kg
        };
        let bodies = self.mechanism.real.flexible_bodies();
        let rates_1_s2 = bodies.zip(floating.chain(nodal).map(square_1_s2));
        let (body, fastest_1_s2) = rates_1_s2.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let is_beyond = !(fastest_1_s2.sqrt() * smallest_s < 1.0);
        is_beyond.then(|| format!("body.{}.beam", self.mechanism.model.bodies[body.0].name))
    }

    /// No contact may be pressed deeper than its limit allows, at the end of a step or, where it may be deepest, within.
    pub(super) fn check_bearings(&self, lane: usize) -> Result<(), RunFailure> {
        let Some(run) = &self.runs[lane] else { return Ok(()) };
        let time_s = self.core.start_read(lane, ReadLayout::TIME);
        let is_deep = self.core.is_set(lane, LaneLayout::DEEP);
        for (contact, limit) in run.depth_limits.iter().enumerate() {
            let gap = self.core.end_read(lane, self.core.pass.reads.gap(contact));
            if gap.is_nan() {
                return Err(RunFailure::NotFinite { time_s, element: None });
            }
            if let Some(place) = self.core.pass.reads.along(contact)
                && let Some(ends_m) = run.sample.play_of(contact).shape.face_ends_m()
            {
                let along_m = self.core.end_read(lane, place);
                let is_front = is_front_corner(run.sample.contacts[contact].place);
                let holds = if is_front { ends_m[0] <= along_m } else { along_m <= ends_m[1] };
                if !holds {
                    return Err(RunFailure::BeyondGuide {
                        contact: self.mechanism.contact_name(contact),
                        joint: self.joint_name(contact).to_owned(),
                        along_m,
                        ends_m,
                        time_s,
                    });
                }
            }
            let is_root = run.root == Some(contact);
            let is_beyond = gap > if is_root { limit.root } else { limit.gap };
            if !(is_beyond || is_deep && limit.is_of_law) {
                continue;
            }
            let measure = GapMeasure::of(run.sample.play_of(contact));
            let mut depth_m = match (is_beyond, is_root) {
                (false, _) => 0.0,
                (true, true) => gap * gap,
                (true, false) => measure.penetration_m(gap),
            };
            if !is_beyond && self.core.contact(lane, contact).0.contact > 0.0 {
                let (gap, time) = (self.gap(lane, contact), self.times(lane));
                let step = ContactStep { gap, time, step: self.core.step(lane), is_root };
                depth_m = step.largest_penetration_m(measure);
                if depth_m <= limit.penetration_m {
                    depth_m = 0.0;
                }
            }
            if depth_m > 0.0 {
                return Err(self.too_deep(run, contact, depth_m, time_s));
            }
        }
        Ok(())
    }

    /// Friction in ideal joints must have a solution at the end of a step.
    pub(super) fn check_joint_friction(&self, lane: usize) -> Result<(), RunFailure> {
        for index in 0..self.core.pass.reads.frictions() {
            let residual = self.core.end_read(lane, self.core.pass.reads.friction(index));
            if !(residual <= MAX_RESIDUAL)
                && let Some(run) = &self.runs[lane]
            {
                let joint = run.sample.frictions[index].joint;
                let time_s = self.core.start_read(lane, ReadLayout::TIME);
                return Err(RunFailure::Jams { joint: self.mechanism.model.joints[joint.0].name.clone(), time_s });
            }
        }
        Ok(())
    }

    fn joint_name(&self, contact: usize) -> &str {
        self.mechanism.model.play_name(self.mechanism.plays[self.mechanism.contacts[contact].play])
    }

    fn too_deep(&self, run: &LaneRun, contact: usize, penetration_m: f64, time_s: f64) -> RunFailure {
        let model = &self.mechanism.model;
        let play = self.mechanism.plays[self.mechanism.contacts[contact].play];
        let joint = model.play_name(play).to_owned();
        let limit = run.depth_limits[contact];
        let limit_m = limit.penetration_m;
        let shape = &run.sample.play_of(contact).shape;
        if let (Some(of_law), Some(_), true) = (model.play_contact(play), shape.hole(), limit.is_of_law) {
            let law = model.contacts[of_law.0].law.name();
            return RunFailure::BeyondLaw { joint, law, penetration_m, limit_m, time_s };
        }
        match (shape.hole_radius_m(), shape.block()) {
            (Some(bearing_radius_m), _) => RunFailure::LeavesBearing { joint, penetration_m, bearing_radius_m, time_s },
            (None, Some(&SliderBlock { half_height_m, .. })) => {
                RunFailure::LeavesGuide { joint, penetration_m, half_height_m, time_s }
            }
            // Without a limit nothing is too deep; a law with one is not for flanks.
            (None, None) => RunFailure::NotFinite { time_s, element: None },
        }
    }
}
