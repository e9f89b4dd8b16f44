//! Pereira, Ramalho and Ambrósio 2011.

use super::law::LineLaw;
use crate::contact::normal::PereiraContact;
use crate::contact::point::DEFAULT_LAW;

/// Clearance at which the fit of Y changes, mm.
const CHANGE_MM: f64 = 0.34954;

/// Pereira, Ramalho and Ambrósio 2011, for a pin inside of a hole: F = ((0.965 c + 0.0965) L E*/c) δⁿ with c, L, δ in mm, E* in
/// MPa, n = Y c^(-0.005), Y = 1.51 (ln 1000c)^(-0.151) for c up to 0.34954 mm and 0.0151 c + 1.151 beyond.
///
/// Fitted to clearances from 0.005 to 10 mm; for every δ.
pub(super) const PEREIRA: LineLaw = LineLaw {
    name: "pereira",
    source: "Pereira, Ramalho and Ambrósio 2011, internal contact: F = ((0.965 c + 0.0965) L E*/c) δⁿ, n = Y c^(-0.005), in mm, N \
        and MPa, fitted to c from 0.005 to 10 mm",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: Some([5e-6, 10e-3]),
    contact: |pair, damping_factor| {
        let clearance_mm = pair.clearance_m * 1e3;
        let y = if clearance_mm <= CHANGE_MM {
            1.51 * libm::pow(libm::log(1000.0 * clearance_mm), -0.151)
        } else {
            0.0151 * clearance_mm + 1.151
        };
        let stiffness = (0.965 * clearance_mm + 0.0965) * (pair.length_m * 1e3) * (pair.equivalent_modulus_pa() * 1e-6)
            / clearance_mm;
        let exponent = y * libm::pow(clearance_mm, -0.005);
        PereiraContact { force_at_1_mm_n: stiffness, exponent, damping_factor }.into()
    },
};

#[cfg(test)]
mod tests {
    use super::PEREIRA;
    use crate::contact::line::static_table::{assert_static_forces, bisected};

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&PEREIRA, [0.8569, 12.459, 80.928], |pair, force_n| {
            bisected(force_n, 1.0, |depth_m| {
                let c = pair.clearance_m / 1e-3;
                let y = if c > 0.34954 { 0.0151 * c + 1.151 } else { 1.51 * (1000.0 * c).ln().powf(-0.151) };
                let modulus_mpa = pair.equivalent_modulus_pa() / 1e6;
                let length_mm = pair.length_m / 1e-3;
                (0.965 * c + 0.0965) * length_mm * modulus_mpa / c * (depth_m / 1e-3).powf(y * c.powf(-0.005))
            })
        });
    }
}
