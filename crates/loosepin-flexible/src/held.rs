//! A beam whose frame is held: mass matrix, stiffness, frequencies and damping of its shapes, with lumped masses.

use super::beam::Beam;
use super::shapes::{MassPoint, Shapes};
use super::spectrum::{modes, root_damping};
use super::station::Station;
use loosepin_math::Vec2;
use loosepin_math::dense::multiply;
use std::f64::consts::TAU;

/// A mass at a section of a beam, which carries it as a rigid arm.
#[derive(Debug, Clone, Copy)]
pub struct LumpedMass<'s> {
    /// The shapes at the section.
    pub station: &'s Station,
    /// Centre of mass from the point of the axis there, along the axis and across it, m.
    pub arm_m: Vec2<f64>,
    /// Mass, kg, >= 0.
    pub mass_kg: f64,
    /// Moment of inertia about its centre of mass, kg m², >= 0.
    pub inertia_kg_m2: f64,
}

/// Mass matrix M_f and stiffness K of the shapes, undeformed, over q = (a, b): axial coordinates, m, then lateral ones, rad.
///
/// ```text
/// M_f = ∫ ρA DᵀD dx + Σ m_p D_pᵀD_p + J_p φ_p' φ_p'ᵀ,   D = [ψᵀ, 0; 0, φᵀ],   D_p = [ψ_pᵀ, -y φ_p'ᵀ; 0, φ_pᵀ + x φ_p'ᵀ]
/// ```
///
/// with the arm (x, y) of each lump. Beside the axis a lump couples the stretch to the bending.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldBeam {
    axial: usize,
    count: usize,
    mass: Vec<f64>,
    stiffness: Vec<f64>,
}

impl HeldBeam {
    /// The matrices of a beam with lumps.
    pub fn new(beam: &Beam<f64>, shapes: &Shapes, lumps: &[LumpedMass<'_>]) -> Self {
        let (axial, lateral, count) = (shapes.axial(), shapes.lateral(), shapes.count());
        let mut found = Self { axial, count, mass: vec![0.0; count * count], stiffness: vec![0.0; count * count] };
        for MassPoint { station, weight } in &shapes.points {
            found.add_mass(&rows(beam, station, Vec2::zero()), [beam.mass_kg * weight, 0.0]);
        }
        for lump in lumps {
            found.add_mass(&rows(beam, lump.station, lump.arm_m), [lump.mass_kg, lump.inertia_kg_m2]);
        }
        for row in 0..axial {
            for column in 0..axial {
                found.stiffness[row * count + column] =
                    beam.axial_stiffness_n_m * shapes.axial_stiffness[row * axial + column];
            }
        }
        for row in 0..lateral {
            for column in 0..lateral {
                found.stiffness[(axial + row) * count + axial + column] =
                    beam.bending_stiffness_n_m * shapes.bending_stiffness[row * lateral + column];
            }
        }
        found
    }

    /// Adds a mass, kg, and an inertia, kg m², whose motion along, across and about are `rows`.
    fn add_mass(&mut self, [along, across, about]: &[Vec<f64>; 3], [mass_kg, inertia_kg_m2]: [f64; 2]) {
        let count = self.count;
        for row in 0..count {
            for column in 0..count {
                let moved = along[row] * along[column] + across[row] * across[column];
                self.mass[row * count + column] += mass_kg * moved + inertia_kg_m2 * about[row] * about[column];
            }
        }
    }

    /// M_f, row by row.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// K, row by row.
    pub fn stiffness(&self) -> &[f64] {
        &self.stiffness
    }

    /// Condenses the shapes above a frequency: they keep their static flexibility, and their own inertia is raised until they have this frequency.
    /// Gives what it adds to M_f, row by row, and the frequencies that the condensed shapes had, Hz, ascending:
    ///
    /// ```text
    /// ΔM = Σ_k (ω_k²/ω_c² - 1) M v_k v_kᵀM  over ω_k > ω_c = 2π f_c,    K v_k = ω_k² M v_k,  v_kᵀM v_k = 1
    /// ```
    ///
    /// ΔM acts on q̇ alone: mass, momentum and inertia of the rigid motion, and what it does to the shapes, are as before.
    pub fn condense(&mut self, above_hz: f64) -> (Vec<f64>, Vec<f64>) {
        let (count, limit) = (self.count, (TAU * above_hz).powi(2));
        let (mut added, mut condensed_hz) = (vec![0.0; count * count], Vec::new());
        let found = modes(&self.mass, &self.stiffness, count);
        for (square, vector) in found.values.into_iter().zip(found.vectors) {
            if square > limit {
                condensed_hz.push(square.sqrt() / TAU);
                let momentum = multiply(&self.mass, &vector);
                for row in 0..count {
                    for column in 0..count {
                        added[row * count + column] += (square / limit - 1.0) * momentum[row] * momentum[column];
                    }
                }
            }
        }
        self.mass.iter_mut().zip(&added).for_each(|(mass, added)| *mass += added);
        (added, condensed_hz)
    }

    /// Natural frequencies, Hz, ascending in each list: axial ones, then lateral ones. A frequency is axial where most of the strain energy of
    /// its motion is that of the stretch.
    pub fn frequencies_hz(&self) -> [Vec<f64>; 2] {
        let mut found = [Vec::new(), Vec::new()];
        let modes = modes(&self.mass, &self.stiffness, self.count);
        for (square, vector) in modes.values.into_iter().zip(modes.vectors) {
            // vᵀ K v = λ, of which the first rows are the stretch.
            let stretch: f64 = (0..self.axial * self.axial)
                .map(|place| (place / self.axial, place % self.axial))
                .map(|(row, column)| vector[row] * self.stiffness[row * self.count + column] * vector[column])
                .sum();
            found[usize::from(stretch <= 0.5 * square)].push(square.sqrt() / TAU);
        }
        found
    }

    /// C = 2ζ M V √Λ VᵀM with K V = M V Λ and VᵀM V = 1: the damping ratio ζ for every shape. N s/m, N s and N m s, row by row.
    pub fn damping(&self, ratio: f64) -> Vec<f64> {
        let half = root_damping(&self.mass, &self.stiffness, self.count);
        half.into_iter().map(|entry| 2.0 * ratio * entry).collect()
    }
}

/// Velocity along and across the axis, and angular velocity, at the end of an arm for unit rates of the coordinates.
fn rows(beam: &Beam<f64>, station: &Station, arm_m: Vec2<f64>) -> [Vec<f64>; 3] {
    let (axial, lateral) = (station.axial.len(), station.lateral.len());
    let joined = |of_axial: &dyn Fn(usize) -> f64, of_lateral: &dyn Fn(usize) -> f64| {
        (0..axial).map(of_axial).chain((0..lateral).map(of_lateral)).collect()
    };
    [
        joined(&|k| station.axial[k], &|i| -arm_m.y * station.slopes[i]),
        joined(&|_| 0.0, &|i| beam.length_m * station.lateral[i] + arm_m.x * station.slopes[i]),
        joined(&|_| 0.0, &|i| station.slopes[i]),
    ]
}
