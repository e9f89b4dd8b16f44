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

/// Every point-contact law, by year; the exact one last.
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
