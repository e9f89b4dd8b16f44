//! Films of oil in a revolute joint with clearance.
//!
//! One film a file: a struct over [`Real`] that implements [`FilmPressure`], its `NAME`, `SOURCE`, `THINNEST_SHARE` and
//! `LONGEST`, and one line in the list at the end of this file. [`Film`] adds what all of them share: the moments, the cap of the eccentricity, and the fading in dry contact.

mod axial;
#[cfg(test)]
mod butenschoen;
mod finite_length;
mod half_sommerfeld;
mod motion;
mod ocvirk;
mod ocvirk_printed;
mod pinkus_sternlicht;
mod pressure;
mod quotient;
mod reynolds;
#[rustfmt::skip]
mod reynolds_table;
#[cfg(test)]
mod ruptured;
#[cfg(test)]
mod tests;

pub use finite_length::FiniteLengthFilm;
pub use motion::{FilmForce, FilmMotion};
pub use ocvirk::OcvirkFilm;
pub use ocvirk_printed::OcvirkPrintedFilm;
pub use pinkus_sternlicht::PinkusSternlichtFilm;
pub use pressure::{FilmBearing, FilmPressure};
pub use reynolds::ReynoldsFilm;

use loosepin_math::{Real, numbers};

/// A film as model files, help and reports know it.
#[derive(Debug, Clone, Copy)]
pub struct FilmDescription {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year, and what it assumes.
    pub source: &'static str,
    /// The thinnest film that it holds for, as a share of the clearance.
    pub thinnest_share: f64,
    /// The largest L/D that it holds for.
    pub longest: f64,
    /// The film of a bearing.
    pub law: fn(&FilmBearing) -> FilmLaw<f64>,
}

impl FilmDescription {
    /// Smallest and largest roughness that goes with a radial clearance, m.
    pub fn roughness_m(&self, clearance_m: f64) -> [f64; 2] {
        [self.thinnest_share * clearance_m, 0.5 * clearance_m]
    }
}

/// The forces and the loss of a film in a joint.
#[derive(Debug, Clone, Copy)]
pub struct FilmLoad<T> {
    /// Force on the journal, N.
    pub force: FilmForce<T>,
    /// M_i and M_j, N m: moments about the centres of bearing and journal on their bodies.
    pub moments_n_m: [T; 2],
    /// Power that the film turns into heat, W, never negative.
    pub loss_w: T,
}

/// A film between the journal and the bearing of a joint (`docs/lubrication.md`).
///
/// The force of [`FilmPressure`] along n and t; forces at the two centres leave the couple |e| F_t, so
///
/// M_j = -½|e| F_t - T_s (ω_j - ω_i), M_i = -½|e| F_t + T_s (ω_j - ω_i), T_s = 2π μ R³ L/(c √(1 - ε²)),
///
/// and the film loses the power -(c (F_r ε̇ - ½ ε w F_t) - T_s (ω_j - ω_i)²) >= 0.
///
/// The film would be infinitely stiff at |e| = c: it is evaluated at ε no larger than ε_cap = 1 - h_min/c, to which ε is led smoothly
/// over h_min/c. Beyond |e| = c, where dry contact begins, all of it fades smoothly over h_min.
#[derive(Debug, Clone, Copy)]
pub struct Film<T> {
    /// The force.
    pub law: FilmLaw<T>,
    /// 2π μ R³ L/c, N m s.
    pub drag_n_m_s: T,
    /// h_min, m.
    pub roughness_m: T,
}

numbers!(struct Film { law, drag_n_m_s, roughness_m });

impl Film<f64> {
    /// The film of `bearing` as `description` has it.
    pub fn new(description: &FilmDescription, bearing: &FilmBearing) -> Self {
        let cube_m3 = bearing.radius_m.powi(3);
        let drag = std::f64::consts::TAU * bearing.viscosity_pa_s * cube_m3 * bearing.length_m / bearing.clearance_m;
        Self { law: (description.law)(bearing), drag_n_m_s: drag, roughness_m: bearing.roughness_m }
    }
}

impl<T: Real> Film<T> {
    /// The film at an eccentricity |e|, m, with the velocities q_n, q_t, m/s, of [`FilmMotion`], and the spins ω_i and ω_j.
    #[inline(always)]
    pub fn load(
        &self,
        clearance_m: T,
        eccentricity_m: T,
        [radial_m_s, tangential_m_s]: [T; 2],
        [spin_i, spin_j]: [T; 2],
    ) -> FilmLoad<T> {
        let ratio = self.capped_ratio(clearance_m, eccentricity_m);
        let squeeze_1_s = radial_m_s / clearance_m;
        let wedge_1_s = T::from_f64(-2.0) * tangential_m_s / clearance_m;
        let remains = self.remaining_share(clearance_m, eccentricity_m);
        let force = self.law.force(&FilmMotion { ratio, squeeze_1_s, wedge_1_s }).times(remains);
        let slip = spin_j - spin_i;
        let drag_n_m = remains * self.drag_n_m_s / (T::one() - ratio * ratio).sqrt() * slip;
        let half_couple_n_m = T::from_f64(0.5) * eccentricity_m * force.tangential_n;
        let supplied_w = force.radial_n * radial_m_s + force.tangential_n * tangential_m_s;
        FilmLoad {
            force,
            moments_n_m: [drag_n_m - half_couple_n_m, -half_couple_n_m - drag_n_m],
            loss_w: drag_n_m * slip - supplied_w,
        }
    }

    /// ε, led to ε_cap from ε_cap - h_min/(2c) on with two continuous derivatives, never above it.
    #[inline(always)]
    fn capped_ratio(&self, clearance_m: T, eccentricity_m: T) -> T {
        let thinnest = self.roughness_m / clearance_m;
        let ratio = eccentricity_m / clearance_m;
        let start = T::from_f64(-1.5).mul_add(thinnest, T::one()).max(T::zero());
        let width = T::from_f64(2.0) * (T::one() - thinnest - start);
        let share = ((ratio - start) / width).max(T::zero()).min(T::one());
        // The integral of 1 - 3u² + 2u³.
        let cube = share * share * share;
        let led = start + width * (share - cube + T::from_f64(0.5) * cube * share);
        T::select(ratio.less_than(start), ratio, led)
    }

    /// One up to |e| = c, zero from c + h_min on, with two continuous derivatives.
    #[inline(always)]
    fn remaining_share(&self, clearance_m: T, eccentricity_m: T) -> T {
        let share = ((eccentricity_m - clearance_m) / self.roughness_m).max(T::zero()).min(T::one());
        let bend = T::from_f64(6.0).mul_add(share, T::from_f64(-15.0)).mul_add(share, T::from_f64(10.0));
        T::one() - share * share * share * bend
    }
}

/// The enum of all films, what it hands on to them, and the table of their descriptions.
macro_rules! film_laws {
    ($($variant:ident($film:ident)),* $(,)?) => {
        /// The pressure of a film with its numbers. Which one it is belongs to the mechanism and is the same in all lanes.
        #[derive(Debug, Clone, Copy)]
        pub enum FilmLaw<T> {
            $(#[doc = concat!("The numbers of `", stringify!($film), "`.")] $variant($film<T>)),*
        }

        /// Every film.
        pub static FILM_LAWS: &[FilmDescription] = &[$(FilmDescription {
            name: $film::NAME,
            source: $film::SOURCE,
            thinnest_share: $film::THINNEST_SHARE,
            longest: $film::LONGEST,
            law: |bearing| FilmLaw::$variant($film::new(bearing)),
        }),*];

        numbers!(enum FilmLaw { $($variant(film)),* });

        impl<T: Real> FilmPressure<T> for FilmLaw<T> {
            #[inline(always)]
            fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
                match self {
                    $(Self::$variant(film) => film.force(motion)),*
                }
            }
        }
    };
}

film_laws! {
    Ocvirk(OcvirkFilm),
    OcvirkPrinted(OcvirkPrintedFilm),
    PinkusSternlicht(PinkusSternlichtFilm),
    FiniteLength(FiniteLengthFilm),
    Reynolds(ReynoldsFilm),
}
