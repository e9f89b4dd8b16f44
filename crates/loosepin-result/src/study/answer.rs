//! The answer of a question that has no layout of its own: sentences with numbers in them.

use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// Answer to a question.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct QuestionAnswer {
    /// The key of its table in a study file.
    pub question: String,
    /// The question, as a heading.
    pub heading: String,
    /// The answer, sentence by sentence.
    pub sentences: Vec<Vec<AnswerPart>>,
}

/// A part of a sentence.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum AnswerPart {
    /// Words, with the spaces around them.
    Words(String),
    /// A number of things.
    Count {
        /// What is counted; no two numbers of an answer are of the same.
        of: String,
        /// How many.
        count: u64,
    },
    /// A quantity.
    Quantity {
        /// What it is of; no two numbers of an answer are of the same.
        of: String,
        /// Its value, SI.
        #[serde(with = "extended")]
        value_si: f64,
        /// Its unit.
        unit: SiUnit,
    },
}

impl QuestionAnswer {
    /// The answer to the question whose table has the key `question`, without a sentence.
    pub fn new(question: &str, heading: &str) -> Self {
        Self { question: question.to_owned(), heading: heading.to_owned(), sentences: Vec::new() }
    }

    /// Adds a sentence.
    pub fn add_sentence(&mut self, parts: impl IntoIterator<Item = AnswerPart>) {
        self.sentences.push(parts.into_iter().collect());
    }
}

impl AnswerPart {
    /// A number of things.
    pub fn count(of: &str, count: usize) -> Self {
        Self::Count { of: of.to_owned(), count: count as u64 }
    }

    /// A quantity.
    pub fn quantity(of: &str, value_si: f64, unit: SiUnit) -> Self {
        Self::Quantity { of: of.to_owned(), value_si, unit }
    }
}

impl From<&str> for AnswerPart {
    fn from(words: &str) -> Self {
        Self::Words(words.to_owned())
    }
}

impl From<String> for AnswerPart {
    fn from(words: String) -> Self {
        Self::Words(words)
    }
}

#[cfg(test)]
mod tests {
    use super::{AnswerPart, QuestionAnswer};
    use loosepin_text::units::SiUnit;

    #[test]
    fn an_answer_is_written_and_read_back() {
        let mut answer = QuestionAnswer::new("check_steps", "How near the steps come");
        let largest = AnswerPart::quantity("largest change", f64::INFINITY, SiUnit::LENGTH);
        answer.add_sentence([
            "Of ".into(),
            AnswerPart::count("runs", 3),
            " runs the largest change is ".into(),
            largest,
            ".".into(),
        ]);
        let written = serde_json::to_string(&answer).unwrap();
        assert!(written.contains(r#"["Of ",{"of":"runs","count":3}," runs"#), "{written}");
        assert_eq!(serde_json::from_str::<QuestionAnswer>(&written).unwrap(), answer);
    }
}
