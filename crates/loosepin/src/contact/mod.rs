//! Contact and friction laws of a revolute joint with clearance.
//!
//! One law a file. A new law of the family `F_N = K δⁿ (1 + χ δ̇/v0)` is one file with one struct that implements
//! [`PointLaw`], and one line in [`POINT_LAWS`]. The kernel that all of them share is [`PointContact`].
//!
//! What the equations of motion evaluate are the numbers of a law: [`NormalLaw`] and [`FrictionLaw`], enums with one struct
//! for each form of the force. A new form is one file with one struct that implements [`NormalContact`] or [`Friction`],
//! and one line in the list at the end of `normal.rs` or `friction.rs`.

mod ambrosio;
mod carvalho_martins;
mod exact_restitution;
mod flores;
mod friction;
mod gonthier;
mod herbert_mcwhannell;
mod hertz;
mod hu_guo;
mod hunt_crossley;
mod lankarani_nikravesh;
mod lee_wang;
mod normal;
mod point;
mod restitution;
mod state;
mod stiffness;
mod zhiying_qishao;

pub use ambrosio::AmbrosioFriction;
pub use friction::{
    FRICTION_LAWS, Friction, FrictionDescription, FrictionLaw, FrictionNumber, KinkSpeeds, friction_law,
};
pub use normal::{NormalContact, NormalForce, NormalLaw};
pub use point::PointContact;
pub use restitution::{damping_factor_that_delivers, delivered_restitution, free_impact_penetration_m};
pub use state::PlayState;
pub use stiffness::{compliance_1_pa, cylinder_stiffness_n_m1_5, largest_valid_impact_speed_m_s};

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
