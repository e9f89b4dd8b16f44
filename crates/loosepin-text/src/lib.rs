//! From files to numbers: text with units to SI and back ([`units`]), TOML files walked by hand
//! ([`document`]), their numbers as quantities ([`numbers`]), values with their tolerances ([`tolerance`]), numbers that are hardly possible
//! ([`plausible`]), diagnostics with their place, code and hint ([`diagnostics`]). The other way: what people read ([`article`]), dates
//! ([`date`]). [`work`] counts what reading costs.

pub mod article;
pub mod date;
pub mod diagnostics;
pub mod document;
pub mod numbers;
pub mod plausible;
pub mod tolerance;
pub mod units;
pub mod work;

/// The version of loosepin, of all its crates, as `major.minor.patch`.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
