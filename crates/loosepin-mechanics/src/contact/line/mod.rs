//! Line-contact laws of a cylinder in a cylinder: the list, and one law a file.
//! The form of a force stands in `normal`.

mod bai_zhao;
mod dubowsky_freudenstein;
mod esdu;
mod johnson;
mod law;
mod liu;
mod logarithmic;
mod pair;
mod pereira;
mod radzimovsky;
mod same_energy;
#[cfg(test)]
pub(super) mod static_table;

pub use law::LineLaw;
pub use pair::LinePair;
pub use same_energy::force_of_same_energy_n;

/// The law of a pin whose bearing has a length, where the model file names none (`docs/contact-laws.md` says why).
pub static LONG_PIN_LAW: &LineLaw = &johnson::JOHNSON;

/// Every line-contact law: the logarithmic ones, then those that hold for every penetration.
pub static LINE_LAWS: &[LineLaw] = &[
    johnson::JOHNSON,
    esdu::ESDU_78035,
    dubowsky_freudenstein::DUBOWSKY_FREUDENSTEIN,
    radzimovsky::RADZIMOVSKY,
    liu::LIU,
    bai_zhao::BAI_ZHAO,
    pereira::PEREIRA,
];
