//! Questions and requirements of outputs, and the accuracy of the answers. How they are answered stands in `question` of the crate.

pub(crate) mod accuracy;
pub(crate) mod allow;
pub(crate) mod ask;
pub(crate) mod asked_before;
pub(crate) mod location;
pub(crate) mod output;
pub(crate) mod promise;
pub(crate) mod question_settings;
pub(crate) mod requirement;
pub(crate) mod requirement_runs;
pub(crate) mod target;
