//! Settings from the tables of single questions.

use std::any::Any;
use std::fmt;
use std::sync::Arc;

/// Settings from the tables of single questions: a value of each question's own type, which that question alone knows.
#[derive(Clone, Default)]
pub struct QuestionSettings(Vec<Arc<dyn Any + Send + Sync>>);

impl QuestionSettings {
    /// Adds what a question states.
    pub fn state<T: Any + Send + Sync>(&mut self, settings: T) {
        self.0.push(Arc::new(settings));
    }

    /// Settings of a question; `None` if it has no table.
    pub fn get<T: Any>(&self) -> Option<&T> {
        self.0.iter().find_map(|settings| settings.downcast_ref())
    }
}

impl fmt::Debug for QuestionSettings {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} tables of questions", self.0.len())
    }
}
