//! Inertia and weight of the bodies in generalised coordinates, in every geometry (Kane).
//!
//! With the partial velocities v_k of a centre of mass, the partial angular velocities w_k, the mass m, the inertia J and the accelerations a and α
//! that the rates cause when the free coordinates have none:
//!
//! ```text
//! M_kl = Σ m v_k·v_l + w_k·J w_l
//! h_k  = Σ m (g - a)·v_k - (J α + ω × J ω)·w_k
//! ```

use crate::mechanism::{Kinematics, Tree, TreeGeometry, TreeNumbers, acceleration_at};
use core::ops::Range;
use loosepin_math::{Envelope, Geometry, GramSystem, Plane, Real, Vector};

/// Partial velocity of a centre of mass, and the swing of a body, for a coordinate.
type CentreColumn<T, G> = (<G as Geometry>::Vector<T>, <G as Geometry>::Swing<T>);

/// M q̈ = h + Jᵀ λ with J q̈ = -γ, with room for an evaluation.
#[derive(Debug, Clone)]
pub struct BodyEquations<T: Real, G: TreeGeometry = Plane> {
    /// Free accelerations q̈.
    pub accelerations: Vec<T>,
    /// Constraint forces λ; where rows repeat each other, one of the many that do the same.
    pub multipliers: Vec<T>,
    /// M of the free speeds, row by row: the lower triangle; then its factors.
    pub mass: Vec<T>,
    /// Inertial coupling of the driven speeds (rows) with the free ones (columns).
    pub driven_mass: Vec<T>,
    /// h for all speeds: free ones, then driven ones.
    pub forces: Vec<T>,
    /// J over all speeds, row by row.
    pub jacobian: Vec<T>,
    /// γ.
    pub constraint_biases: Vec<T>,
    /// J M⁻¹ Jᵀ.
    pub gram: GramSystem<T>,
    /// The possibly non-zero entries of M.
    envelope: Envelope,
    /// Columns of the centre of mass of the current link.
    centres: Vec<CentreColumn<T, G>>,
}

impl<T: Real, G: TreeGeometry> BodyEquations<T, G> {
    /// Room for `tree`. For each constraint row, `scales` has the rows with the same scale.
    pub fn new(tree: &Tree<G>, scales: Vec<Range<usize>>) -> Self {
        let (free, speeds, rows) = (tree.free_speeds, tree.speeds(), scales.len());
        Self {
            accelerations: vec![T::zero(); free],
            multipliers: vec![T::zero(); rows],
            mass: vec![T::zero(); free * free],
            driven_mass: vec![T::zero(); (speeds - free) * free],
            forces: vec![T::zero(); speeds],
            jacobian: vec![T::zero(); rows * speeds],
            constraint_biases: vec![T::zero(); rows],
            gram: GramSystem::new(scales, free),
            envelope: tree.mass_envelope(),
            centres: Vec::with_capacity(speeds),
        }
    }

    /// Begins an evaluation with inertia and weight of all bodies that have a mass of their own. Needs the biases of `kinematics`.
    #[inline(always)]
    pub fn begin(&mut self, tree: &Tree<G>, numbers: &TreeNumbers<T, G>, kinematics: &Kinematics<T, G>) {
        let n = tree.free_speeds;
        self.mass.fill(T::zero());
        self.driven_mass.fill(T::zero());
        self.forces.fill(T::zero());
        for (index, (link, own)) in tree.links.iter().zip(&numbers.links).enumerate() {
            let slot = index + 1;
            if !link.has_own_mass {
                continue;
            }
            let (rotation, bias) = (&kinematics.poses[slot].rotation, &kinematics.biases[slot]);
            let twist = &kinematics.twists[slot];
            let arm_m = kinematics.poses[slot].turn(own.centre_of_mass_m);
            let force_n = (numbers.gravity_m_s2 - acceleration_at(bias, twist, arm_m)) * own.mass_kg;
            let moment_n_m = G::inertia_moment(rotation, &own.inertia_kg_m2, bias.angular, twist.angular);
            self.centres.clear();
            for column in kinematics.columns(tree, slot) {
                let velocity = column.at(arm_m);
                let swing = G::swing(rotation, &own.inertia_kg_m2, column.turning);
                self.centres.push((velocity, swing));
                let sum = G::inertia_push(moment_n_m, &swing, self.forces[column.coordinate]);
                self.forces[column.coordinate] = force_n.inner_plus(velocity, sum);
            }
            for (k, row) in link.dependences.iter().enumerate() {
                for (l, column) in link.dependences[..=k].iter().enumerate() {
                    // Only the lower triangle is used; what couples two driven coordinates is not.
                    let (high, low) = (*row.max(column), *row.min(column));
                    if low >= n {
                        continue;
                    }
                    let place = if high < n {
                        &mut self.mass[high * n + low]
                    } else {
                        &mut self.driven_mass[(high - n) * n + low]
                    };
                    let (first, second) = (&self.centres[k], &self.centres[l]);
                    let sum = first.0.inner(second.0).mul_add(own.mass_kg, *place);
                    *place = G::coupled(&first.1, &second.1, sum);
                }
            }
        }
    }

    /// Solves for accelerations and constraint forces. `set_rows` sets J and γ.
    #[inline(always)]
    pub fn solve(&mut self, set_rows: impl FnOnce(&mut [T], &mut [T])) {
        let (n, columns) = (self.accelerations.len(), self.forces.len());
        self.envelope.factor_ldl(&mut self.mass);
        self.accelerations.copy_from_slice(&self.forces[..n]);
        self.envelope.solve_ldl(&self.mass, &mut self.accelerations);
        if self.multipliers.is_empty() {
            return;
        }
        set_rows(&mut self.jacobian, &mut self.constraint_biases);
        for (row, multiplier) in self.multipliers.iter_mut().enumerate() {
            let gradient = &self.jacobian[row * columns..row * columns + n];
            let mut defect = -self.constraint_biases[row];
            for (slope, acceleration) in gradient.iter().zip(&self.accelerations) {
                defect = (-*slope).mul_add(*acceleration, defect);
            }
            *multiplier = defect;
        }
        self.gram.set(&self.jacobian, columns, &self.mass, n);
        self.gram.solve(&mut self.multipliers);
        self.gram.add_correction(&self.multipliers, &mut self.accelerations);
    }

    /// Force (N) or torque (N m) of the tree's drive `k` along its coordinate, at the last evaluation.
    #[inline(always)]
    pub fn drive_force(&self, k: usize) -> T {
        let (n, columns) = (self.accelerations.len(), self.forces.len());
        // `forces` holds applied minus inertial forces without q̈; the part of q̈ is added here.
        let mut needed = -self.forces[n + k];
        for (coupling, acceleration) in self.driven_mass[k * n..(k + 1) * n].iter().zip(&self.accelerations) {
            needed = coupling.mul_add(*acceleration, needed);
        }
        for (row, multiplier) in self.multipliers.iter().enumerate() {
            needed -= self.jacobian[row * columns + n + k] * *multiplier;
        }
        needed
    }
}

/// Adds the efforts that move all bodies with the accelerations that the rates cause, -h. Needs the biases of `kinematics`.
#[inline(always)]
pub(super) fn add_efforts<T: Real, G: TreeGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    efforts: &mut [T],
) {
    for (index, own) in numbers.links.iter().enumerate() {
        let slot = index + 1;
        let (rotation, bias) = (&kinematics.poses[slot].rotation, &kinematics.biases[slot]);
        let twist = &kinematics.twists[slot];
        let arm_m = kinematics.poses[slot].turn(own.centre_of_mass_m);
        let force_n = (acceleration_at(bias, twist, arm_m) - numbers.gravity_m_s2) * own.mass_kg;
        let moment_n_m = -G::inertia_moment(rotation, &own.inertia_kg_m2, bias.angular, twist.angular);
        for column in kinematics.columns(tree, slot) {
            let swing = G::swing(rotation, &own.inertia_kg_m2, column.turning);
            let sum = G::inertia_push(moment_n_m, &swing, efforts[column.coordinate]);
            efforts[column.coordinate] = force_n.inner_plus(column.at(arm_m), sum);
        }
    }
}
