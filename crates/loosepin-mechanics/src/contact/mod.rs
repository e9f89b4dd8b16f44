//! Contact and friction laws of a revolute joint with clearance.
//!
//! One law a file. A new law of the family `F_N = K δⁿ (1 + χ δ̇/v0)` is one file with one struct that implements
//! [`PointLaw`], and one line in [`POINT_LAWS`]. The kernel that all of them share is [`PointContact`].
//!
//! Laws of other families are described by a struct that implements [`LinearLaw`] or [`LineLaw`] and a line in
//! [`LINEAR_LAWS`] or [`LINE_LAWS`].
//!
//! What the equations of motion evaluate are the numbers of a law: [`NormalLaw`] and [`FrictionLaw`], enums with one struct
//! for each form of the force. A new form is one file with one struct that implements [`NormalContact`] or [`Friction`],
//! and one line in the list at the end of `normal.rs` or `friction.rs`. Films of oil are in `film/`, with a list of their own.

mod ambrosio;
mod anagnostopoulos;
mod bai_zhao;
mod bengisu_akay;
mod brown_mcphee;
mod carvalho_martins;
mod dubowsky_freudenstein;
mod esdu;
mod exact_linear_restitution;
mod exact_restitution;
mod film;
mod flores;
mod friction;
mod gonthier;
mod herbert_mcwhannell;
mod hertz;
mod hu_guo;
mod hunt_crossley;
mod johnson;
mod kelvin_voigt;
mod lankarani_nikravesh;
mod lee_wang;
mod line;
mod linear;
mod liu;
mod logarithmic;
mod lugre;
mod normal;
mod pereira;
mod point;
mod radzimovsky;
mod restitution;
mod state;
#[cfg(test)]
mod static_table;
mod stiffness;
mod stribeck;
mod threlfall;
mod zhiying_qishao;

pub use film::{
    FILM_LAWS, Film, FilmBearing, FilmDescription, FilmForce, FilmLaw, FilmLoad, FilmMotion, FilmPressure,
    FiniteLengthFilm, OcvirkFilm, OcvirkPrintedFilm, PinkusSternlichtFilm,
};
pub use friction::{
    BristledForce, FRICTION_LAWS, Friction, FrictionDescription, FrictionLaw, FrictionNumber, KinkSpeeds, friction_law,
};
pub use line::{LINE_LAWS, LineLaw, LinePair};
pub use linear::{LINEAR_LAWS, LinearContact, LinearLaw, damping_ratio_that_delivers, restitution_of_damping_ratio};
pub use logarithmic::{LogarithmicContact, inverse_logarithmic};
pub use normal::{NormalContact, NormalForce, NormalLaw};
pub use point::PointContact;
pub use restitution::{damping_factor_that_delivers, delivered_restitution, free_impact_penetration_m};
pub use state::PlayState;
pub use stiffness::{
    compliance_1_pa, cylinder_stiffness_n_m1_5, largest_valid_impact_speed_m_s, sphere_stiffness_n_m1_5,
};

use std::fmt::Debug;

/// A point-contact law `F_N = K δⁿ (1 + χ δ̇/v0)` (method, section 2.1): it gives the factor χ of its energy loss.
pub trait PointLaw: Debug + Sync {
    /// The name used in model files, in kebab case.
    fn name(&self) -> &'static str;
    /// Author, year and the equation of χ, as shown in help and reports.
    fn source(&self) -> &'static str;
    /// χ for a nominal coefficient of restitution `restitution` in (0, 1].
    fn damping_factor(&self, restitution: f64) -> f64;
    /// Whether χ grows without limit as the coefficient of restitution goes to zero.
    fn diverges_at_zero_restitution(&self) -> bool {
        false
    }
}

/// Every point-contact law, in the order of the method's table.
pub static POINT_LAWS: &[&dyn PointLaw] = &[
    &hertz::Hertz,
    &hunt_crossley::HuntCrossley,
    &herbert_mcwhannell::HerbertMcWhannell,
    &lee_wang::LeeWang,
    &lankarani_nikravesh::LankaraniNikravesh,
    &gonthier::Gonthier,
    &zhiying_qishao::ZhiyingQishao,
    &flores::Flores,
    &hu_guo::HuGuo,
    &carvalho_martins::CarvalhoMartins,
    &exact_restitution::ExactRestitution,
];

/// The law called `name` in model files.
pub fn point_law(name: &str) -> Option<&'static dyn PointLaw> {
    POINT_LAWS.iter().copied().find(|law| law.name() == name)
}

/// A normal force law as model files, help and reports know it, by where its numbers come from.
#[derive(Debug, Clone, Copy)]
pub enum NormalDescription {
    /// K from the materials or given with its exponent, χ from the restitution.
    Point(&'static dyn PointLaw),
    /// K given, D given or from the restitution and the masses that meet.
    Linear(&'static dyn LinearLaw),
    /// From the materials, the radii and the length of the bearing; χ from the restitution by a point-contact law.
    Line(&'static dyn LineLaw),
}

impl NormalDescription {
    /// Every law: point contact, linear, line contact.
    pub fn all() -> impl Iterator<Item = Self> {
        let points = POINT_LAWS.iter().map(|law| Self::Point(*law));
        let linear = LINEAR_LAWS.iter().map(|law| Self::Linear(*law));
        points.chain(linear).chain(LINE_LAWS.iter().map(|law| Self::Line(*law)))
    }

    /// The name used in model files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Point(law) => law.name(),
            Self::Linear(law) => law.name(),
            Self::Line(law) => law.name(),
        }
    }

    /// Author, year and equation.
    pub fn source(&self) -> &'static str {
        match self {
            Self::Point(law) => law.source(),
            Self::Linear(law) => law.source(),
            Self::Line(law) => law.source(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_laws_differ_and_defaults_exist() {
        let mut names: Vec<&str> = NormalDescription::all().map(|law| law.name()).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
        assert!(LINE_LAWS.iter().all(|law| point_law(law.default_damping()).is_some()));
        assert!(NormalDescription::all().all(|law| law.source().contains(|c: char| c.is_ascii_digit() || c == ':')));
    }
}
