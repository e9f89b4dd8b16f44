//! Terms of an answer. Each is one type from the computation to the file, the page and Python, with the word that names it there.

mod surrogate_verdict;

pub use surrogate_verdict::SurrogateVerdict;
