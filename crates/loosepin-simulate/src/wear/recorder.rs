//! The friction path of wearing joints by sectors, step by step of a run.

use super::joint::WearingJoint;
use super::jumps::Life;
use super::profile::{ContactSample, WearProfile};
use crate::ideal::column::columns;
use crate::observer::Step;
use crate::recording::work::NODES;
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Values;

/// Halvings that locate where an ideal joint turns back, within a step.
const HALVINGS: usize = 48;

/// Takes the steps of a recorded part into the profiles of all wearing joints: Gauss's rule over each step in contact, on its dense
/// output. Steps end where v_T of a joint with play reverses; those of ideal joints are cut there.
#[derive(Debug, Clone)]
pub struct WearRecorder {
    /// The joints.
    pub joints: Vec<WearingJoint>,
    /// Wear of each joint by its recorded part so far.
    pub profiles: Vec<WearProfile>,
    /// The wear of all cycles, where the worn shape acts back; then the profiles are those of the last cycle alone.
    pub life: Option<Life>,
    /// Column of the model and its largest deviation, SI, that end the life of the mechanism.
    pub limit: Option<(usize, f64)>,
    /// The contact of each joint; `None` for an ideal joint. A pin touches its hole at one place.
    contacts: Vec<Option<usize>>,
    /// Slots of bearing and journal in the real tree: of a flexible body, those of its sections.
    slots: Vec<[usize; 2]>,
}

impl WearRecorder {
    /// An unworn record.
    pub fn new(mechanism: &Mechanism, values: &Values) -> Self {
        let joints = WearingJoint::all(mechanism, values);
        let slots_of = |joint: &WearingJoint| {
            let points = mechanism.model.joints[joint.joint.0].kind.points();
            points.map(|point| mechanism.real.slot_of_point(point))
        };
        let limit = mechanism.model.wear.and_then(|life| life.limit).and_then(|limit| {
            let column = columns(&mechanism.model).iter().position(|column| column.output == limit.output)?;
            Some((column, values[limit.limit]))
        });
        Self {
            life: None,
            limit,
            profiles: joints.iter().map(WearProfile::new).collect(),
            contacts: joints.iter().map(|joint| Some(mechanism.contacts_of(joint.play?).start)).collect(),
            slots: joints.iter().map(slots_of).collect(),
            joints,
        }
    }

    /// Takes a step in.
    pub fn step(&mut self, step: &mut Step<'_, '_>) {
        for (index, joint) in self.joints.iter().enumerate() {
            let (profile, slots) = (&mut self.profiles[index], self.slots[index]);
            match joint.play.zip(self.contacts[index]) {
                Some((play, contact)) if step.is_in_contact(contact) => {
                    for point in gauss_points(step, [0.0, 1.0]) {
                        match step.foundation(contact, play, point.0) {
                            Some(at) => profile.add_foundation(&at, point.1),
                            None => profile.add(joint, &with_play(step, (contact, play), slots, point)),
                        }
                    }
                }
                // In flight nothing wears.
                Some(_) => {}
                None => {
                    for part in parts(step, slots) {
                        for point in gauss_points(step, part) {
                            profile.add(joint, &ideal(step, joint, slots, point));
                        }
                    }
                }
            }
        }
    }
}

/// Points of Gauss's rule between two shares of a step: their times, s, and the times that they stand for, s.
fn gauss_points(step: &Step<'_, '_>, [from, to]: [f64; 2]) -> [(f64, f64); NODES.len()] {
    let time = step.time_polynomial();
    NODES.map(|(node, weight)| {
        let share = from + node * (to - from);
        (time.value(share), weight * (to - from) * time.slope(share))
    })
}

/// A joint with play.
fn with_play(
    step: &mut Step<'_, '_>,
    (contact, play): (usize, usize),
    slots: [usize; 2],
    (time_s, weight_s): (f64, f64),
) -> ContactSample {
    let (force, dynamics) = step.contact_force(contact, time_s);
    ContactSample {
        normal_rad: angle(dynamics.plays()[play].eccentricity_m),
        bodies_rad: angles(dynamics, slots),
        force_n: force.normal_n.max(0.0),
        path_j: force.friction_path_w() * weight_s,
    }
}

/// An ideal joint: its pin is pressed against the side that its force comes from, and slides by R_i (ω_j - ω_i).
fn ideal(
    step: &mut Step<'_, '_>,
    joint: &WearingJoint,
    slots: [usize; 2],
    (time_s, weight_s): (f64, f64),
) -> ContactSample {
    let dynamics = step.evaluate(time_s);
    let force_n = dynamics.joint_force_n(joint.joint);
    let length_n = force_n.length();
    ContactSample {
        normal_rad: angle(-force_n),
        bodies_rad: angles(dynamics, slots),
        force_n: length_n,
        path_j: length_n * joint.radii_m[0] * turning_rad_s(dynamics, slots).abs() * weight_s,
    }
}

/// The shares of a step between which an ideal joint turns one way.
fn parts(step: &mut Step<'_, '_>, slots: [usize; 2]) -> Vec<[f64; 2]> {
    let time = step.time_polynomial();
    let mut turning = |share: f64| turning_rad_s(step.set_state(time.value(share)), slots);
    let (first, last) = (turning(0.0), turning(1.0));
    if !(first * last < 0.0) {
        return vec![[0.0, 1.0]];
    }
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if turning(middle) * first > 0.0 { low = middle } else { high = middle }
    }
    vec![[0.0, high], [high, 1.0]]
}

fn turning_rad_s(dynamics: &Dynamics<'_, f64>, [bearing, journal]: [usize; 2]) -> f64 {
    let twists = &dynamics.kinematics.twists;
    twists[journal].angular - twists[bearing].angular
}

fn angles(dynamics: &Dynamics<'_, f64>, slots: [usize; 2]) -> [f64; 2] {
    slots.map(|slot| dynamics.kinematics.poses[slot].angle_rad())
}

fn angle(vector: Vec2<f64>) -> f64 {
    vector.y.atan2(vector.x)
}

#[cfg(test)]
mod tests {
    use super::WearRecorder;
    use loosepin_mechanics::mechanism::Mechanism;
    use loosepin_mechanics::model::Model;

    #[test]
    fn identity_a_surface_on_a_flexible_link_turns_with_its_section() {
        let text = include_str!("../../../../cases/flexible_slider_crank/model.toml");
        let wearing = text.replace(
            "[joint.gudgeon]\n",
            "[joint.gudgeon]\nbearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\n",
        );
        assert_ne!(wearing, text);
        let model = Model::from_text("model.toml", &wearing).expect("a model");
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).expect("a mechanism");
        let recorder = WearRecorder::new(&mechanism, &values);
        let beam = &mechanism.real.beams[0];
        // The bearing is at the small end of the rod, the pin in the slider.
        assert_eq!(recorder.slots[0][0], beam.sections[1]);
        assert_ne!(recorder.slots[0][0], beam.slot);
        assert!(!beam.sections.contains(&recorder.slots[0][1]));
    }
}
