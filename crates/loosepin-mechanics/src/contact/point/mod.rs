//! Point-contact laws, `F_N = K δⁿ (1 + χ δ̇/v0)`: the list, and one law a file. The law of the source paper is in
//! `lankarani_nikravesh.rs`.

mod carvalho_martins;
#[cfg(test)]
mod delivered;
mod exact_restitution;
mod flores;
mod gonthier;
mod herbert_mcwhannell;
mod hertz;
mod hu_guo;
mod hunt_crossley;
mod lankarani_nikravesh;
mod law;
mod lee_wang;
mod zhiying_qishao;

pub use law::PointLaw;
pub(super) use zhiying_qishao::ZHIYING_QISHAO;

/// The law where the model file names none: that of the source paper. Long pins have another one, `LONG_PIN_LAW`.
pub const DEFAULT_LAW: &PointLaw = &lankarani_nikravesh::LANKARANI_NIKRAVESH;

/// Every point-contact law, by year; the exact one last.
pub static POINT_LAWS: &[PointLaw] = &[
    hertz::HERTZ,
    hunt_crossley::HUNT_CROSSLEY,
    herbert_mcwhannell::HERBERT_MCWHANNELL,
    lee_wang::LEE_WANG,
    lankarani_nikravesh::LANKARANI_NIKRAVESH,
    gonthier::GONTHIER,
    zhiying_qishao::ZHIYING_QISHAO,
    flores::FLORES,
    hu_guo::HU_GUO,
    carvalho_martins::CARVALHO_MARTINS,
    exact_restitution::EXACT_RESTITUTION,
];
