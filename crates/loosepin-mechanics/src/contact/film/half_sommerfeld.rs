//! The Reynolds equation of a film that may pull, solved; where it pulls, its pressure is dropped.

use super::axial::{AxialModes, MODES, STATIONS};
use super::motion::FilmForce;
use loosepin_math::sin_cos;
use std::f64::consts::PI;

/// Places over half of the circle.
const PLACES: usize = 192;

/// The Reynolds equation of a bearing of any length,
///
/// (h³ p')' + h³ p_ζζ/Λ² = 2ε̇ cos θ - wε sin θ,
///
/// with h = 1 + ε cos θ, θ from the thickest film, ζ = 2z/L, Λ = L/D, p in units of 6 μ (R/c)², the pressure outside zero at ζ = ±1.
/// Negative pressure is dropped from the forces (half-Sommerfeld, after Gümbel), not from the equation.
///
/// Along the bearing: modes ([`AxialModes`]). Around it: finite volumes over Sommerfeld's variable ψ, h = (1 - ε²)/(1 - ε cos ψ), in
/// which the film is smooth however thin it is; the pressures of ε̇ and of wε are even and odd in ψ, which leaves half of the circle.
pub(super) struct HalfSommerfeld {
    modes: AxialModes,
    inverse_length_squared: f64,
}

/// The pressures at one eccentricity, by place and station.
pub(super) struct Pressures {
    /// Of ε̇ = 1.
    squeeze: Vec<[f64; STATIONS]>,
    /// Of wε = 1, for θ > 0; opposite for θ < 0.
    wedge: Vec<[f64; STATIONS]>,
    /// 6 dθ (cos θ, sin θ), by place.
    directions: Vec<[f64; 2]>,
    weights: [f64; STATIONS],
}

impl HalfSommerfeld {
    /// For the ratio Λ = L/D.
    pub fn new(length_ratio: f64) -> Self {
        Self { modes: AxialModes::new(), inverse_length_squared: 1.0 / (length_ratio * length_ratio) }
    }

    /// The pressures at the eccentricity ratio `ratio` < 1.
    pub fn pressures(&self, ratio: f64) -> Pressures {
        let gap = 1.0 - ratio * ratio; // S
        let root = gap.sqrt();
        let step = PI / PLACES as f64;
        let below = |place: f64| 1.0 - ratio * sin_cos(place * step).1; // 1 - ε cos ψ
        // S² ((1 - ε cos ψ)⁻² p_ψ)_ψ - κ² S³ (1 - ε cos ψ)⁻⁴/Λ² p = right-hand side/(1 - ε cos ψ), over one place.
        let faces: Vec<f64> = (0..=PLACES).map(|face| (gap / below(face as f64)).powi(2) / step).collect();
        let mut directions = vec![[0.0; 2]; PLACES];
        let (mut sinks, mut rights) = (vec![0.0; PLACES], vec![[0.0; 2]; PLACES]);
        for k in 0..PLACES {
            let place = k as f64 + 0.5;
            let (sine_psi, cosine_psi) = sin_cos(place * step);
            let film = below(place);
            let (cosine, sine) = ((cosine_psi - ratio) / film, root * sine_psi / film);
            directions[k] = [cosine, sine].map(|part| 6.0 * part * root / film * step);
            sinks[k] = step * gap.powi(3) / film.powi(4) * self.inverse_length_squared;
            rights[k] = [2.0 * cosine, -sine].map(|part| part / film * step);
        }
        let mut found = [vec![[0.0; STATIONS]; PLACES], vec![[0.0; STATIONS]; PLACES]];
        let (mut above, mut value) = ([0.0; PLACES], [0.0; PLACES]);
        for mode in 0..MODES {
            for (part, pressure) in found.iter_mut().enumerate() {
                // No flow through ψ = 0 and ψ = π for the even part; no pressure there, half a place away, for the odd one.
                let end = if part == 0 { 0.0 } else { 2.0 };
                let (mut before, mut last) = (0.0, 0.0);
                for k in 0..PLACES {
                    let [left, right] = [(k, k == 0), (k + 1, k + 1 == PLACES)]
                        .map(|(face, is_end)| faces[face] * if is_end { end } else { 1.0 });
                    let back = if k == 0 { 0.0 } else { faces[k] };
                    let pivot = -left - right - sinks[k] * self.modes.squares[mode] - back * before;
                    above[k] = faces[k + 1] / pivot;
                    value[k] = (rights[k][part] * self.modes.shares[mode] - back * last) / pivot;
                    (before, last) = (above[k], value[k]);
                }
                for k in (0..PLACES - 1).rev() {
                    value[k] -= above[k] * value[k + 1];
                }
                for (stations, value) in pressure.iter_mut().zip(&value) {
                    for (sum, profile) in stations.iter_mut().zip(&self.modes.profiles) {
                        *sum += value * profile[mode];
                    }
                }
            }
        }
        let [squeeze, wedge] = found;
        Pressures { squeeze, wedge, directions, weights: self.modes.weights }
    }
}

impl Pressures {
    /// The force for ε̇ and wε, in units of μ L R³/c².
    pub fn force(&self, squeeze_1_s: f64, wedge_1_s: f64) -> FilmForce<f64> {
        let mut force = FilmForce { radial_n: 0.0, tangential_n: 0.0 };
        for ((of_squeeze, of_wedge), [cosine, sine]) in self.squeeze.iter().zip(&self.wedge).zip(&self.directions) {
            let mut sums = [0.0; 2];
            for station in 0..STATIONS {
                let (even, odd) = (of_squeeze[station] * squeeze_1_s, of_wedge[station] * wedge_1_s);
                sums[0] += self.weights[station] * (even + odd).max(0.0);
                sums[1] += self.weights[station] * (even - odd).max(0.0);
            }
            force.radial_n += cosine * (sums[0] + sums[1]);
            force.tangential_n += sine * (sums[0] - sums[1]);
        }
        force
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peer_forces_of_films_of_finite_length() {
        /// Relative tolerance of the force. The peer's own error, from two grids, is a tenth of that.
        const RELATIVE: f64 = 1e-4;
        // ε, Λ, ε̇, wε, then F_r and F_t: tools/film/reynolds.py.
        for [ratio, length_ratio, squeeze_1_s, wedge_1_s, radial, tangential] in [
            [0.3, 0.5, 0.8, 0.9, -2.688_388_24, 0.975_027_55],
            [0.6, 1.0, 0.0, 1.1, -2.302_300_84, 3.549_978_11],
            [0.6, 1.3, -0.4, 0.7, 0.787_726_92, 1.093_643_01],
            [0.85, 0.4, 0.3, -1.2, -22.388_750_94, -4.612_737_11],
            [0.85, 2.5, 0.6, 0.5, -131.055_362_91, 9.393_179_30],
        ] {
            let found = HalfSommerfeld::new(length_ratio).pressures(ratio).force(squeeze_1_s, wedge_1_s);
            let error =
                (found.radial_n - radial).hypot(found.tangential_n - tangential) / f64::hypot(radial, tangential);
            assert!(error < RELATIVE, "ε = {ratio}, L/D = {length_ratio}: {found:?}, off by {error}");
        }
    }
}
