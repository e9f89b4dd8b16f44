//! Where bodies are at the start, as the file guesses it.

use super::direction::{Direction, LENGTHS};
use super::parts::ModelGuess;
use super::problem::SpatialModelProblem;
use super::reader::SpaceReader;
use loosepin_text::document::{Entry, Kind};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

record! {
    /// the choice for loops that can close in several ways, and a start where none is found
    pub(super) struct SpatialAssemblyTable for ReadsNumbers;
    /// approximate poses of bodies at time zero; bodies without one are placed by their joints
    required guess: Entry<'t> =
        Kind::Values(&Kind::Table(&GuessTable::KEYS)), "{ rod = { at = [\"0 mm\", \"90 mm\", \"0 mm\"], turned = [\"z 20 deg\"] } }";
}

record! {
    /// approximate pose of a body
    pub(super) struct GuessTable for ReadsNumbers;
    /// origin of its frame in that of the ground
    required at: Entry<'t> = LENGTHS, "[\"200 mm\", \"0 mm\", \"0 mm\"]";
    /// turns in their order, each about x, y, z or a named axis of the body as the turns before left it; none if omitted
    optional turned: Entry<'t> = Kind::List(&Kind::Text), "[\"x 30 deg\", \"z 20 deg\"]";
}

impl SpaceReader {
    /// Reads the guesses.
    pub fn read_guesses(&mut self, entry: &Entry<'_>) -> Vec<ModelGuess> {
        let Some(SpatialAssemblyTable { guess, .. }) = SpatialAssemblyTable::read(self, entry) else {
            return Vec::new();
        };
        let mut guesses = Vec::new();
        for entry in self.numbers.reader.any_keys(&guess) {
            self.numbers.remember(&entry);
            match self.body(&entry.at_key(), entry.name) {
                Some(0) => self.numbers.reader.report(&SpatialModelProblem::GuessOfGround, entry.key_span),
                Some(body) => guesses.extend(self.read_guess(&entry, body)),
                None => {}
            }
        }
        guesses
    }

    fn read_guess(&mut self, entry: &Entry<'_>, body: usize) -> Option<ModelGuess> {
        let own = GuessTable::read(self, entry)?;
        let at_m = self.numbers.three(&own.at, Dimension::LENGTH);
        let turned = own.turned.map_or(Some(Vec::new()), |list| self.turns(&list, body))?;
        Some(ModelGuess { body, at_m: at_m?, turned })
    }

    fn turns(&mut self, list: &Entry<'_>, body: usize) -> Option<Vec<(Direction, QuantityId)>> {
        let elements = self.numbers.reader.list(list)?;
        elements.iter().map(|element| self.turn(element, body)).collect()
    }

    /// A turn of a body, written `x 30 deg`, or with the name of an axis of the body in place of x.
    fn turn(&mut self, entry: &Entry<'_>, body: usize) -> Option<(Direction, QuantityId)> {
        let text = self.numbers.reader.text(entry)?;
        let is_name = |word: &&str| word.starts_with(|c: char| c.is_alphabetic() || c == '_');
        let Some(word) = text.split_once(' ').map(|(word, _)| word).filter(is_name) else {
            let problem = SpatialModelProblem::NotATurn { entry: entry.path.describe(), found: text.to_owned() };
            return self.numbers.reader.refuse(&problem, entry.span);
        };
        let axis = self.axis_called(word, entry, body)?;
        Some((axis, self.numbers.quantity_behind(entry, word.len() + 1, Dimension::ANGLE, Rule::Finite)?))
    }
}
