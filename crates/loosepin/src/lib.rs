//! How accurately a planar mechanism moves when its parts scatter (random: a distribution) and its joints have play
//! that is known only roughly (epistemic: an interval).
//!
//! Two wings and one bridge. Physics: [`contact`], [`model`], [`mechanism`], [`dynamics`], [`simulate`], [`accuracy`];
//! it knows nothing of probability. Uncertainty: [`uncertainty`], [`surrogate`], [`bounds`]; it knows nothing of mechanisms.
//! [`study`] joins them, [`sweep`] varies one number without either, [`cases`] holds the program against answers that are
//! known, [`report`] only reads results. [`import`] makes models of drawings, [`measured`] lays measured curves over a run.
//! `docs/architecture.md` says who may import whom.

pub mod accuracy;
pub mod bounds;
pub mod cases;
pub mod contact;
pub mod contributors;
pub mod diagnostics;
pub mod document;
pub mod dynamics;
pub mod import;
pub mod integrate;
pub mod math;
pub mod measured;
pub mod mechanism;
pub mod model;
pub mod native;
pub mod reliability;
pub mod report;
pub mod results;
pub mod simulate;
pub mod store;
pub mod study;
pub mod surrogate;
pub mod sweep;
pub mod templates;
pub mod trace;
pub mod uncertainty;
pub mod units;

/// The version of this library, as `major.minor.patch`.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
