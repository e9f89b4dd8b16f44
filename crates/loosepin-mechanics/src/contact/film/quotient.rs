//! Forces of films of any length as a quotient of Ocvirk's force and a sum: the form that solutions of the Reynolds equation take.

use super::motion::{FilmForce, FilmMotion};
use super::ocvirk::OcvirkFilm;
use super::pressure::FilmPressure;
use loosepin_math::{Real, factor_ldl, numbers, solve_ldl};

/// κ, from which on a bearing counts as long: κ Λ² against 1 + X.
pub(super) const CROSSOVER: f64 = 0.5;
/// The largest i + j of the sums.
const DEGREE: usize = 8;
/// Pairs (i, j).
pub(super) const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;
/// The sums are made for films down to this share of the clearance, so for eccentricity ratios up to [`MAX_RATIO`].
pub(super) const THINNEST_SHARE: f64 = 0.002;
pub(super) const MAX_RATIO: f64 = 1.0 - THINNEST_SHARE;
/// The relative error of a force counts with the root of its share of the largest at the same ε, and never less than this.
const MIN_WEIGHT: f64 = 0.1;

/// The force of a film in a bearing with the length ratio Λ = L/D: as a complex number F = F_r + i F_t it is Ocvirk's F₀
/// ([`OcvirkFilm`]) over what the length takes away. With X + i Y = ε F₀/|F₀|, κ = ½,
///
/// F = F₀ (1 + X)/(1 + X + κΛ²)/Σ (a_ij + i Y b_ij) T_i(2 (u - u_1)/(u_2 - u_1) - 1) T_j(η - 1), i + j <= 8,
///
/// Chebyshev's polynomials T, η = (1 - ε²)/(1 + X), u = l/(l + √(1 + X)), l about Λ√κ, and u_1, u_2 the range of u.
///
/// X + i Y is where the pressure is, √(1 + X) how far it spreads around the bearing, and u how long the bearing is against that: so
/// the sums are smooth where a small change of direction moves the pressure from the thin to the thick film, and at ε = 0.
#[derive(Debug, Clone, Copy)]
pub struct FilmQuotient<T> {
    /// Ocvirk's film of the same bearing.
    pub short: OcvirkFilm<T>,
    /// κ Λ².
    pub crossover: T,
    /// l.
    pub reach: T,
    /// a_ij and b_ij, i outermost.
    pub sums: [[T; 2]; TERMS],
}

numbers!(struct FilmQuotient { short, crossover, reach, sums });

/// A motion, and the force that belongs to it.
pub(super) type MotionForce = (FilmMotion<f64>, FilmForce<f64>);

impl FilmQuotient<f64> {
    /// For Λ and l with forces in units of μ L R³/c², all sums zero.
    pub(super) fn without_sums(length_ratio: f64, reach: f64) -> Self {
        Self {
            short: OcvirkFilm { factor_n_s: 4.0 * length_ratio * length_ratio },
            crossover: CROSSOVER * length_ratio * length_ratio,
            reach,
            sums: [[0.0; 2]; TERMS],
        }
    }

    /// Sums by least squares of the relative error of forces in many directions, at one eccentricity after the other.
    pub(super) fn fit(&mut self, eccentricities: impl Iterator<Item = Vec<MotionForce>>) {
        let mut matrices = [vec![0.0; TERMS * TERMS], vec![0.0; TERMS * TERMS]];
        let mut rights = [vec![0.0; TERMS], vec![0.0; TERMS]];
        for forces in eccentricities {
            let largest = forces.iter().map(|(_, force)| force.size_n()).fold(0.0, f64::max);
            for (motion, force) in &forces {
                let place = self.place(motion);
                let [radial, tangential] = [place.short.radial_n, place.short.tangential_n].map(|f| f * place.share);
                let square = force.size_n() * force.size_n();
                // F₀ (1 + X)/(1 + X + κΛ²)/F.
                let target = [
                    (radial * force.radial_n + tangential * force.tangential_n) / square,
                    (tangential * force.radial_n - radial * force.tangential_n) / square,
                ];
                let weight = (force.size_n() / largest).sqrt().max(MIN_WEIGHT)
                    / (target[0] * target[0] + target[1] * target[1]).sqrt();
                for part in 0..2 {
                    let factor = if part == 0 { weight } else { weight * place.across };
                    let row = place.terms().map(|term| term * factor);
                    for i in 0..TERMS {
                        rights[part][i] += row[i] * target[part] * weight;
                        for j in 0..=i {
                            matrices[part][i * TERMS + j] += row[i] * row[j];
                        }
                    }
                }
            }
        }
        for part in 0..2 {
            let matrix = &mut matrices[part];
            for i in 0..TERMS {
                for j in 0..i {
                    matrix[j * TERMS + i] = matrix[i * TERMS + j];
                }
            }
            factor_ldl(matrix, TERMS);
            solve_ldl(matrix, TERMS, &mut rights[part]);
            for (pair, value) in self.sums.iter_mut().zip(&rights[part]) {
                pair[part] = *value;
            }
        }
    }
}

/// The terms of the sums at a motion.
struct SumTerms<T> {
    short: FilmForce<T>,
    /// (1 + X)/(1 + X + κΛ²).
    share: T,
    /// Y.
    across: T,
    along_u: [T; DEGREE + 1],
    along_eta: [T; DEGREE + 1],
}

impl<T: Real> SumTerms<T> {
    /// T_i T_j, i outermost.
    #[inline(always)]
    fn terms(&self) -> [T; TERMS] {
        let mut terms = [T::zero(); TERMS];
        let mut at = 0;
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                terms[at] = self.along_u[i] * self.along_eta[j];
                at += 1;
            }
        }
        terms
    }
}

impl<T: Real> FilmQuotient<T> {
    #[inline(always)]
    fn place(&self, motion: &FilmMotion<T>) -> SumTerms<T> {
        let (one, two) = (T::one(), T::from_f64(2.0));
        let short = self.short.force(motion);
        let to_direction = motion.ratio / short.size_n().max(T::from_f64(f64::MIN_POSITIVE));
        let (x, across) = (short.radial_n * to_direction, short.tangential_n * to_direction);
        let room = one + x;
        let eta = (one - motion.ratio * motion.ratio) / room;
        let share = |spread: f64| self.reach / (self.reach + T::from_f64(spread));
        let (last, first) = (share((1.0 - MAX_RATIO).sqrt()), share((1.0 + MAX_RATIO).sqrt()));
        let u = self.reach / (self.reach + room.sqrt());
        SumTerms {
            short,
            share: room / (room + self.crossover),
            across,
            along_u: chebyshev((two * u - first - last) / (last - first)),
            along_eta: chebyshev(eta - one),
        }
    }
}

impl<T: Real> FilmPressure<T> for FilmQuotient<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let place = self.place(motion);
        let mut sums = [T::zero(); 2];
        let mut at = 0;
        for i in 0..=DEGREE {
            let mut inner = [T::zero(); 2];
            for j in 0..=DEGREE - i {
                for part in 0..2 {
                    inner[part] = self.sums[at][part].mul_add(place.along_eta[j], inner[part]);
                }
                at += 1;
            }
            for part in 0..2 {
                sums[part] = inner[part].mul_add(place.along_u[i], sums[part]);
            }
        }
        let (real, imaginary) = (sums[0], place.across * sums[1]);
        // F₀ over the complex number.
        let share = place.share / (real * real + imaginary * imaginary);
        let short = place.short;
        FilmForce {
            radial_n: share * (short.radial_n * real + short.tangential_n * imaginary),
            tangential_n: share * (short.tangential_n * real - short.radial_n * imaginary),
        }
    }
}

/// T_0(x), T_1(x), and so on.
#[inline(always)]
fn chebyshev<T: Real>(x: T) -> [T; DEGREE + 1] {
    let mut values = [T::one(); DEGREE + 1];
    values[1] = x;
    for k in 2..=DEGREE {
        values[k] = (x + x).mul_add(values[k - 1], -values[k - 2]);
    }
    values
}
