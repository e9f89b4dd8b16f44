//! Ranges in which the block of a slider with play may reach over an end of its guide, which lets it tilt further than the quasi-static
//! answer has it.

use super::play_reach::PlayReach;
use loosepin_mechanics::dynamics::PlayMotion;
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, Sample};
use loosepin_mechanics::model::PlayId;
use loosepin_result::motion::GuideOverhang;

/// The joints with play, by their place among them, whose block may reach over an end of its guide at an ideal position: its corners at
/// any tilt, and its centre as far off as the play.
pub(super) fn overhanging<'a>(
    mechanism: &'a Mechanism,
    sample: &'a Sample<f64>,
    reaches: &'a [PlayReach],
    kinematics: &'a Kinematics<f64>,
) -> impl Iterator<Item = usize> + 'a {
    let is_over = move |play: usize| {
        let numbers = &sample.plays[play];
        let Some([first_m, last_m]) = numbers.shape.face_ends_m() else { return false };
        let (PlayId::Joint(joint), Some(reach_m)) = (mechanism.plays[play], reaches[play].along_guide_m()) else {
            return false;
        };
        let slots = mechanism.model.joints[joint.0].kind.bodies().map(|body| mechanism.ideal.slot_of_body[body.0]);
        let motion = PlayMotion::between(kinematics, slots, numbers);
        let along_m = motion.directions[0].dot(motion.eccentricity_m);
        along_m - reach_m < first_m || last_m < along_m + reach_m
    };
    (0..mechanism.plays.len()).filter(move |play| is_over(*play))
}

/// Gathers the angles of the drive at which blocks overhang, in the order of the angle.
#[derive(Default)]
pub(super) struct Overhangs {
    found: Vec<GuideOverhang>,
    /// The angle before.
    last_rad: Option<f64>,
}

impl Overhangs {
    /// Takes in the joints named `joints`, which overhang at `angle_rad`.
    pub fn record(&mut self, angle_rad: f64, joints: impl Iterator<Item = String>) {
        for joint in joints {
            let place = self.found.iter().position(|overhang| overhang.joint == joint).unwrap_or_else(|| {
                self.found.push(GuideOverhang { joint, spans_rad: Vec::new() });
                self.found.len() - 1
            });
            let spans_rad = &mut self.found[place].spans_rad;
            match spans_rad.last_mut() {
                Some(span_rad) if Some(span_rad[1]) == self.last_rad => span_rad[1] = angle_rad,
                _ => spans_rad.push([angle_rad; 2]),
            }
        }
        self.last_rad = Some(angle_rad);
    }

    pub fn into_found(self) -> Vec<GuideOverhang> {
        self.found
    }
}

#[cfg(test)]
mod tests {
    use super::Overhangs;

    #[test]
    fn analytic_angles_in_a_row_are_one_span() {
        let mut overhangs = Overhangs::default();
        for (angle_rad, joints) in
            [(0.1, vec!["rail"]), (0.2, vec!["rail"]), (0.3, vec![]), (0.4, vec!["bed", "rail"]), (0.5, vec!["bed"])]
        {
            overhangs.record(angle_rad, joints.into_iter().map(str::to_owned));
        }
        let found = overhangs.into_found();
        let spans = |name: &str| &found.iter().find(|overhang| overhang.joint == name).unwrap().spans_rad;
        assert_eq!((spans("rail"), spans("bed")), (&vec![[0.1, 0.2], [0.4, 0.4]], &vec![[0.4, 0.5]]));
    }
}
