//! Contact and friction laws of a joint with play: what acts where pin and hole touch.
//!
//! The law of the source paper (\[SC16\], see `docs/notation.md`), line by line:
//!
//! | Equation | File |
//! |---|---|
//! | (8), force `F_N = K δⁿ (1 + χ δ̇/v0)` | `normal/point.rs` for `K δⁿ`, `normal/contact.rs` for the factor |
//! | (8), factor χ of Lankarani and Nikravesh | `point/lankarani_nikravesh.rs` |
//! | (9), stiffness K | `stiffness.rs` |
//!
//! Equations (1) to (7), the motion of pin and hole, are in `dynamics/play.rs` and `dynamics/pin.rs`.
//!
//! | Folder | A file is | List |
//! |---|---|---|
//! | `point` | a law for χ, [`PointLaw`] | [`POINT_LAWS`] |
//! | `linear` | a law for D of `F_N = K δ + D δ̇`, [`LinearLaw`] | [`LINEAR_LAWS`] |
//! | `line` | a law for a cylinder in a cylinder, [`LineLaw`] | [`LINE_LAWS`] |
//! | `normal` | a form of the normal force, [`NormalContact`] | [`NormalLaw`] |
//! | `friction` | a friction law, [`Friction`] | [`FrictionLaw`] |
//! | `film` | a film of oil, [`FilmPressure`] | [`FilmLaw`] |
//!
//! `point`, `linear` and `line` are what model files choose from (`model/contact/law.rs`): a law gives the numbers of a form
//! in `normal`. Forms, friction and films are what the equations of motion evaluate. Each folder lists its files in its `mod.rs`.

mod film;
mod foundation;
#[cfg(test)]
mod free_impact;
mod friction;
mod hertz_line;
mod line;
mod linear;
mod normal;
mod point;
mod restitution;
mod stiffness;
mod worn_profile;

pub use film::{
    FILM_LAWS, Film, FilmBearing, FilmDescription, FilmForce, FilmLaw, FilmLoad, FilmMotion, FilmPressure,
    FiniteLengthFilm, OcvirkFilm, OcvirkPrintedFilm, PinkusSternlichtFilm, ReynoldsFilm,
};
pub use foundation::{
    DeepestSector, Foundation, FoundationLoad, FoundationMotion, PressedSector, liu_foundation_pa_m,
    point_law_foundation_pa_m,
};
pub use friction::{
    BristledForce, FRICTION_KEYS, FRICTION_LAWS, Friction, FrictionDescription, FrictionKey, FrictionLaw, FrictionPart,
    KinkSpeeds,
};
pub use hertz_line::{LinePatch, share_below};
pub use line::{LINE_LAWS, LONG_PIN_LAW, LineLaw, LinePair, force_of_same_energy_n};
pub use linear::{LINEAR_LAWS, LinearLaw};
pub use normal::{
    LinearContact, LogarithmicContact, NormalContact, NormalForce, NormalLaw, PlayState, PointContact,
    damping_ratio_that_delivers, inverse_logarithmic, restitution_of_damping_ratio,
};
pub use point::{DEFAULT_LAW, POINT_LAWS, PointLaw};
pub use restitution::{damping_factor_that_delivers, delivered_restitution};
pub use stiffness::{
    TouchingParts, compliance_1_pa, cylinder_stiffness_n_m1_5, largest_valid_impact_speed_m_s, sphere_stiffness_n_m1_5,
};
pub use worn_profile::{Weights, WornProfile};
