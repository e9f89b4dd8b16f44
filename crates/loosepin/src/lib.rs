//! How accurately a mechanism moves when its parts scatter (random: a distribution) and its joints have play
//! that is known only roughly (epistemic: an interval).
//!
//! This crate names what users of the library need, and holds nothing of its own. Each phase is a crate:
//!
//! * Mechanics: [`contact`], [`model`], [`mechanism`], [`dynamics`] (`loosepin-mechanics`), [`simulate`], [`accuracy`],
//!   [`sweep`], [`measured`] (`loosepin-simulate`). They know nothing of probability.
//! * Space: [`space`], mechanisms in space and what play does to them, without dynamics.
//! * Uncertainty: [`uncertainty`], [`contributors`], [`reliability`] (`loosepin-uncertainty`), [`surrogate`], [`bounds`].
//!   They know nothing of mechanisms.
//! * [`study`] joins the two wings, [`identify`] goes from readings of a rig to play, [`cases`] holds the program against answers that are known, [`check`] says what a file is before anything runs, [`report`] reads results.
//!
//! [`files`] is all that writes to disk.
//!
//! `docs/architecture.md` shows which crate stands on which.

pub use loosepin_bounds as bounds;
pub use loosepin_check as check;
pub use loosepin_files as files;
pub use loosepin_identify as identify;
pub use loosepin_import as import;
pub use loosepin_import::templates;
pub use loosepin_math as math;
pub use loosepin_math::integrate;
pub use loosepin_mechanics::{contact, dynamics, mechanism, model};
pub use loosepin_report as report;
pub use loosepin_result as result;
pub use loosepin_simulate as simulate;
pub use loosepin_simulate::{accuracy, measured, sweep};
pub use loosepin_space as space;
pub use loosepin_store as store;
pub use loosepin_store::results;
pub use loosepin_study as study;
pub use loosepin_study::cases;
pub use loosepin_surrogate as surrogate;
pub use loosepin_tape::{native, trace};
pub use loosepin_text::{VERSION, article, diagnostics, document, units, work};
pub use loosepin_uncertainty as uncertainty;
pub use loosepin_uncertainty::{contributors, reliability};
