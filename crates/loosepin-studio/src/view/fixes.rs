//! Changes that mend a diagnostic: a word that was probably meant, in place of the one that is written.

use loosepin::diagnostics::Diagnostic;
use strsim::osa_distance;

use crate::messages::{Change, Document, Fix};

/// Marks in which messages set what is written and what was probably meant.
const MARKS: [char; 2] = ['\'', '"'];

/// The change that the hint of a diagnostic proposes; `None` if it proposes more than one word in place of another, or where that word
/// does not stand exactly once at the place of the diagnostic.
pub fn fix(diagnostic: &Diagnostic, document: Option<Document>) -> Option<Fix> {
    let place = diagnostic.place.as_ref()?;
    let proposed = diagnostic.hint.as_ref()?.strip_prefix("did you mean ")?.strip_suffix('?')?;
    let (meant, mark) = MARKS.into_iter().find_map(|mark| Some((inside(proposed, mark)?, mark)))?;
    let range = place.source.clamp(place.span);
    let text = &place.source.text()[range.clone()];
    // Of the words that the message quotes, the one that was mistaken for the one that was meant.
    let quoted = diagnostic.message.split(mark).skip(1).step_by(2);
    let here = quoted.filter_map(|word| Some((word, only(text, word)?)));
    let (written, at) = here.min_by_key(|(word, _)| osa_distance(word, meant))?;
    let from = range.start + at;
    let units = |byte: usize| place.source.utf16_units(byte);
    let change =
        Change { document: document?, from: units(from), to: units(from + written.len()), insert: meant.to_owned() };
    Some(Fix { change, words: format!("Write {meant} in place of {written}") })
}

/// What a text is between two marks, where there is nothing else.
fn inside(text: &str, mark: char) -> Option<&str> {
    text.strip_prefix(mark)?.strip_suffix(mark).filter(|word| !word.is_empty() && !word.contains(mark))
}

/// Position of a word in a text that has it once.
fn only(text: &str, word: &str) -> Option<usize> {
    let mut found = text.match_indices(word).filter(|_| !word.is_empty());
    let (first, _) = found.next()?;
    found.next().is_none().then_some(first)
}
