//! Programs translated lately: a mechanism that is run again, or with another method, does not wait for the same programs again.

use super::Level;
use super::assemble::Code;
use super::error::NativeError;
use super::program::Program;
use super::translate::{KernelSize, translate};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Operations of the programs that are held, at most: a few megabytes with their code. The programs of a slider-crank have 20,000.
const MAX_OPERATIONS: usize = 400_000;

/// What a program was translated to.
pub(super) type Translated = Arc<(Code, KernelSize)>;

/// A program, for what it was translated, and the result.
struct Entry {
    program: Program,
    level: Level,
    lanes: usize,
    translated: Translated,
}

impl Entry {
    fn is_of(&self, program: &Program, level: Level, lanes: usize) -> bool {
        (self.level, self.lanes) == (level, lanes) && self.program == *program
    }
}

/// The programs of this process, the oldest first.
static RECENT: Mutex<VecDeque<Entry>> = Mutex::new(VecDeque::new());

fn recent() -> MutexGuard<'static, VecDeque<Entry>> {
    // An entry is put in whole.
    RECENT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The machine code of `program`, as [`translate`] gives it, if it was translated lately.
fn known(program: &Program, level: Level, lanes: usize) -> Option<Translated> {
    recent().iter().rev().find(|entry| entry.is_of(program, level, lanes)).map(|entry| Arc::clone(&entry.translated))
}

/// [`translate`], or what it gave for the same program lately.
///
/// # Errors
/// Those of [`translate`].
pub(super) fn translate_once(program: &Program, level: Level, lanes: usize) -> Result<Translated, NativeError> {
    if let Some(known) = known(program, level, lanes) {
        return Ok(known);
    }
    // Others may translate meanwhile, even the same.
    let translated = Arc::new(translate(program, level, lanes)?);
    let mut recent = recent();
    recent.push_back(Entry { program: program.clone(), level, lanes, translated: Arc::clone(&translated) });
    let mut operations: usize = recent.iter().map(|entry| entry.program.nodes().len()).sum();
    while operations > MAX_OPERATIONS {
        let Some(oldest) = recent.pop_front() else { break };
        operations -= oldest.program.nodes().len();
    }
    Ok(translated)
}

#[cfg(test)]
mod tests {
    use super::translate_once;
    use crate::native::{Graph, Level, Program, Slot};
    use std::sync::Arc;

    /// x times `factor`.
    fn multiple(factor: f64) -> Program {
        let mut graph = Graph::new();
        let x = graph.input(Slot { block: 0, index: 0 });
        let factor = graph.constant(factor);
        let product = graph.multiply(x, factor);
        Program::new(&graph, &[(Slot { block: 0, index: 1 }, product)]).unwrap()
    }

    #[test]
    fn identity_an_equal_program_for_the_same_lanes_is_translated_once() {
        let Some(level) = Level::best() else { return };
        let [first, again, other] = [37.25, 37.25, 37.5].map(multiple);
        let code = translate_once(&first, level, 8).unwrap();
        let is_same = |program, lanes| Arc::ptr_eq(&code, &translate_once(program, level, lanes).unwrap());
        assert!(is_same(&again, 8) && !is_same(&again, 16) && !is_same(&other, 8));
    }
}
