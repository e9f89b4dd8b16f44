//! Linear laws, `F_N = K δ + D δ̇`: the list, and one law a file.
//! The form of the force stands in `normal`.

mod anagnostopoulos;
#[cfg(test)]
mod delivered;
mod exact_linear_restitution;
mod kelvin_voigt;
mod law;

pub use law::LinearLaw;

/// Every linear law.
pub static LINEAR_LAWS: &[LinearLaw] =
    &[kelvin_voigt::KELVIN_VOIGT, anagnostopoulos::ANAGNOSTOPOULOS, exact_linear_restitution::EXACT_LINEAR_RESTITUTION];
