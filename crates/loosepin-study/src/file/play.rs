//! The places of the journals of a mechanism in space.

use super::description::{EpistemicInput, EpistemicSubject};
use super::reader::StudyReader;
use loosepin_uncertainty::Interval;

/// Path of the input that stands for the places of all journals.
pub(crate) const PLAY: &str = "play";

impl StudyReader {
    /// Adds the places of the journals, where a model in space has play: anything between what they make smallest and largest, at each position.
    /// Runs in the plane have contact forces that decide where a journal is.
    pub fn add_play(&mut self) {
        if self.model.spatial().is_none() || !self.model.has_play() {
            return;
        }
        if let Ok(interval) = Interval::try_new(-1.0, 1.0) {
            let variable = interval.into();
            self.epistemic.push(EpistemicInput { path: PLAY.to_owned(), subject: EpistemicSubject::Play, variable });
        }
    }
}
