//! Joints and couplings that may have play.

use crate::model::ids::{ContactId, JointId, PlayId};
use crate::model::parts::topology::Model;
use loosepin_text::document::describe_path;
use loosepin_text::numbers::{QuantityId, Values};

impl Model {
    /// The joints and then the couplings that may have play, in file order.
    pub fn plays(&self) -> impl Iterator<Item = PlayId> {
        let joints = (0..self.joints.len()).filter(|&index| self.joints[index].kind.play().is_some());
        let couplings = (0..self.couplings.len()).filter(|&index| self.couplings[index].play.is_some());
        joints.map(|index| PlayId::Joint(JointId(index))).chain(couplings.map(PlayId::Coupling))
    }

    /// The clearance (of a coupling its backlash), m, of what may have play. `None` if there is none: a cam from which its
    /// follower may lift off.
    pub fn play_clearance(&self, play: PlayId) -> Option<QuantityId> {
        match play {
            PlayId::Joint(joint) => self.joints[joint.0].kind.play().map(|play| play.clearance_m),
            PlayId::Coupling(index) => self.couplings[index].play.and_then(|play| play.backlash_m),
        }
    }

    /// The clearances of all that may have play, each with what has it.
    pub fn play_clearances(&self) -> impl Iterator<Item = (PlayId, QuantityId)> {
        self.plays().filter_map(|play| Some((play, self.play_clearance(play)?)))
    }

    /// The contact of what may have play.
    pub fn play_contact(&self, play: PlayId) -> Option<ContactId> {
        match play {
            PlayId::Joint(joint) => self.joints[joint.0].kind.play().map(|play| play.contact),
            PlayId::Coupling(index) => self.couplings[index].play.map(|play| play.contact),
        }
    }

    /// Whether it has play with `values`: its clearance is above zero, or it has none because its follower may lift off.
    pub fn has_play(&self, play: PlayId, values: &Values) -> bool {
        self.play_contact(play).is_some() && self.play_clearance(play).is_none_or(|clearance| values[clearance] > 0.0)
    }

    /// A joint or coupling in words: `joint 'gudgeon'`.
    pub fn play_words(&self, play: PlayId) -> String {
        match play {
            PlayId::Joint(joint) => format!("joint '{}'", self.joints[joint.0].name),
            PlayId::Coupling(index) => describe_path(&self.couplings[index].path),
        }
    }

    /// Name of a joint or coupling. A coupling that shares its name with a joint goes by its table, `coupling.NAME`.
    pub fn play_name(&self, play: PlayId) -> &str {
        match play {
            PlayId::Joint(joint) => &self.joints[joint.0].name,
            PlayId::Coupling(index) => {
                let path = &self.couplings[index].path;
                let name = path.split_once('.').map_or(path.as_str(), |(_, name)| name);
                if self.joints.iter().any(|joint| joint.name == name) { path } else { name }
            }
        }
    }
}
