//! Elastic forces of one element.

use super::mesh::{Mesh, Nodal, Point};
use loosepin_math::{Real, Vec2};

/// Numbers of an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section<T> {
    /// l, m.
    pub(super) length_m: T,
    /// EA, N.
    pub(super) axial_n: T,
    /// EI, N m².
    pub(super) bending_n_m2: T,
    /// τ, s.
    pub(super) retardation_s: T,
}

/// ∂U/∂ of the chord (r1 - r0)/l and of the slopes at both nodes, N m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loads<T> {
    pub(super) chord_n_m: Vec2<T>,
    pub(super) first_n_m: Vec2<T>,
    pub(super) last_n_m: Vec2<T>,
}

/// Chord and slopes of an element, or their rates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends<T> {
    chord: Vec2<T>,
    first: Vec2<T>,
    last: Vec2<T>,
}

impl<T: Real> Ends<T> {
    pub(super) fn new(length_m: T, ends: &[Nodal<T>]) -> Self {
        let chord = (ends[1].position - ends[0].position) * (T::one() / length_m);
        Self { chord, first: ends[0].slope, last: ends[1].slope }
    }

    /// r' at a point.
    pub(super) fn slope(&self, at: &Point) -> Vec2<T> {
        let of_slopes = (self.first * T::from_f64(at.first)).plus(self.last, T::from_f64(at.last));
        of_slopes.plus(self.chord, T::from_f64(at.chord))
    }

    /// l r'' at a point.
    pub(super) fn bend(&self, at: &Point) -> Vec2<T> {
        let of_slopes = (self.first * T::from_f64(at.bend_first)).plus(self.last, T::from_f64(at.bend_last));
        of_slopes.plus(self.chord, T::from_f64(at.bend_chord))
    }
}

/// The stretch at a point.
pub(super) struct Stretch<T> {
    /// |r'|.
    pub(super) length: T,
    /// r'/|r'|: ∂ε/∂r'.
    pub(super) direction: Vec2<T>,
}

impl<T: Real> Stretch<T> {
    pub(super) fn of(slope: Vec2<T>) -> Self {
        let length = slope.length();
        Self { length, direction: slope * (T::one() / length) }
    }

    /// ε.
    pub(super) fn strain(&self) -> T {
        self.length - T::one()
    }
}

/// The bending at a point, κ l.
pub(super) struct Bend<T> {
    /// κ l = (r' × l r'')/|r'|².
    pub(super) turn: T,
    /// ∂(κ l)/∂r'.
    pub(super) by_slope: Vec2<T>,
    /// ∂(κ l)/∂(l r'').
    pub(super) by_bend: Vec2<T>,
}

impl<T: Real> Bend<T> {
    pub(super) fn of(slope: Vec2<T>, bend: Vec2<T>) -> Self {
        let inverse = T::one() / slope.length_squared();
        let turn = slope.cross(bend) * inverse;
        let by_slope = (-bend.turned()).plus(slope, -(turn + turn)) * inverse;
        Self { turn, by_slope, by_bend: slope.turned() * inverse }
    }
}

impl<T: Real> Loads<T> {
    fn zero() -> Self {
        Self { chord_n_m: Vec2::zero(), first_n_m: Vec2::zero(), last_n_m: Vec2::zero() }
    }

    /// Adds what is conjugate to r' at a point.
    fn add_on_slope(&mut self, at: &Point, on_slope: Vec2<T>) {
        self.chord_n_m = self.chord_n_m.plus(on_slope, T::from_f64(at.chord));
        self.first_n_m = self.first_n_m.plus(on_slope, T::from_f64(at.first));
        self.last_n_m = self.last_n_m.plus(on_slope, T::from_f64(at.last));
    }

    /// Adds what is conjugate to l r'' at a point.
    fn add_on_bend(&mut self, at: &Point, on_bend: Vec2<T>) {
        self.chord_n_m = self.chord_n_m.plus(on_bend, T::from_f64(at.bend_chord));
        self.first_n_m = self.first_n_m.plus(on_bend, T::from_f64(at.bend_first));
        self.last_n_m = self.last_n_m.plus(on_bend, T::from_f64(at.bend_last));
    }
}

impl<T: Real> Section<T> {
    /// EA l and EI/l, N m: of the energies ½ ∫ EA ε² and ½ ∫ EI κ² over an element, in terms of ε and κ l.
    pub(super) fn stiffnesses_n_m(&self) -> [T; 2] {
        [self.axial_n * self.length_m, self.bending_n_m2 / self.length_m]
    }

    /// Elastic forces.
    pub(super) fn elastic(&self, mesh: &Mesh, ends: &[Nodal<T>]) -> Loads<T> {
        let ends = Ends::new(self.length_m, ends);
        let [axial_n_m, bending_n_m] = self.stiffnesses_n_m();
        let mut loads = Loads::zero();
        for at in &mesh.axial {
            let stretch = Stretch::of(ends.slope(at));
            let effort_n_m = axial_n_m * T::from_f64(at.weight) * stretch.strain();
            loads.add_on_slope(at, stretch.direction * effort_n_m);
        }
        for at in &mesh.bending {
            let bend = Bend::of(ends.slope(at), ends.bend(at));
            let effort_n_m = bending_n_m * T::from_f64(at.weight) * bend.turn;
            loads.add_on_slope(at, bend.by_slope * effort_n_m);
            loads.add_on_bend(at, bend.by_bend * effort_n_m);
        }
        loads
    }

    /// Elastic forces and damping, and the power that the damping turns into heat, W.
    pub(super) fn viscoelastic(&self, mesh: &Mesh, ends: &[Nodal<T>], rates: &[Nodal<T>]) -> (Loads<T>, T) {
        let (ends, rates) = (Ends::new(self.length_m, ends), Ends::new(self.length_m, rates));
        let [axial_n_m, bending_n_m] = self.stiffnesses_n_m();
        let (mut loads, mut loss_w) = (Loads::zero(), T::zero());
        for at in &mesh.axial {
            let stretch = Stretch::of(ends.slope(at));
            let rate_1_s = stretch.direction.dot(rates.slope(at));
            let stiffness_n_m = axial_n_m * T::from_f64(at.weight);
            let drag = self.retardation_s * rate_1_s;
            loads.add_on_slope(at, stretch.direction * (stiffness_n_m * (stretch.strain() + drag)));
            loss_w += stiffness_n_m * drag * rate_1_s;
        }
        for at in &mesh.bending {
            let bend = Bend::of(ends.slope(at), ends.bend(at));
            let rate_1_s = bend.by_slope.dot(rates.slope(at)) + bend.by_bend.dot(rates.bend(at));
            let stiffness_n_m = bending_n_m * T::from_f64(at.weight);
            let drag = self.retardation_s * rate_1_s;
            let effort_n_m = stiffness_n_m * (bend.turn + drag);
            loads.add_on_slope(at, bend.by_slope * effort_n_m);
            loads.add_on_bend(at, bend.by_bend * effort_n_m);
            loss_w += stiffness_n_m * drag * rate_1_s;
        }
        (loads, loss_w)
    }

    /// Strain energy, J.
    pub(super) fn strain_j(&self, mesh: &Mesh, ends: &[Nodal<T>]) -> T {
        let ends = Ends::new(self.length_m, ends);
        let [axial_n_m, bending_n_m] = self.stiffnesses_n_m();
        let mut twice_j = T::zero();
        for at in &mesh.axial {
            let strain = Stretch::of(ends.slope(at)).strain();
            twice_j += axial_n_m * T::from_f64(at.weight) * strain.squared();
        }
        for at in &mesh.bending {
            let turn = Bend::of(ends.slope(at), ends.bend(at)).turn;
            twice_j += bending_n_m * T::from_f64(at.weight) * turn.squared();
        }
        twice_j * T::from_f64(0.5)
    }
}
