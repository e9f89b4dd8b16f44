//! A beam in its floating frame: where its points are, its inertia and its elastic forces.

use super::shapes::{MassPoint, Shapes};
use super::station::Station;
use loosepin_math::{Real, Vec2, numbers};
use std::ops::Range;

/// The numbers of a straight uniform beam.
///
/// In the frame of the beam, x from the root along the undeformed axis, the point of the axis at x goes to
///
/// ```text
/// d(x) = [ x + ψ·a - ½ f bᵀ H(x) b,  φ·b ],   H_ij(x) = ∫₀ˣ φ_i' φ_j' dξ                     (F1)
/// ```
///
/// with q = (a, b) as [`Shapes`] counts them. f = 1: ψ·a is the stretch of the axis and the foreshortening stands in the kinematics, so
/// that centrifugal stiffening, softening under compression and the Euler load come out of the inertia and the external forces; no geometric
/// stiffness is to be added. Exact to second order in the slope w': the relative error is about w'²/2. f = 0: the linear form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam<T> {
    /// Length L, m, > 0.
    pub length_m: T,
    /// Mass ρAL, kg, > 0.
    pub mass_kg: T,
    /// EA/L, N/m, > 0.
    pub axial_stiffness_n_m: T,
    /// EI/L, N m/rad, > 0.
    pub bending_stiffness_n_m: T,
    /// Damping ratio ζ of every shape with the frame held, >= 0.
    pub damping_ratio: T,
    /// f = 1; else 0.
    pub foreshortening: bool,
}

numbers!(struct Beam { length_m, mass_kg, axial_stiffness_n_m, bending_stiffness_n_m, damping_ratio; foreshortening });

/// Mass matrix and bias forces of a beam over the speeds (V, ω, q̇): V of the root in the axes of the frame, ω of the frame.
///
/// `M (AᵀR̈, ω̇, q̈) + h` are the generalised forces that the motion needs (F3); weight goes in as R̈ - g.
#[derive(Debug, Clone)]
pub struct Inertia<T> {
    /// 3 and the number of shapes.
    pub size: usize,
    /// M, both triangles, row by row.
    pub mass: Vec<T>,
    /// h.
    pub bias: Vec<T>,
    /// ∂d/∂q at the current point.
    partials: Vec<Vec2<T>>,
}

/// The shapes of one kind.
struct ShapeGroup<'s, T> {
    /// Range of their coordinates.
    range: Range<usize>,
    /// K without dimension, row by row.
    stiffness: &'s [f64],
    /// What it is to be multiplied with.
    stiffness_unit: T,
}

impl<T: Real> Inertia<T> {
    /// Room for the shapes.
    pub fn new(shapes: &Shapes) -> Self {
        let size = 3 + shapes.count();
        Self {
            size,
            mass: vec![T::zero(); size * size],
            bias: vec![T::zero(); size],
            partials: vec![Vec2::zero(); shapes.count()],
        }
    }

    /// Adds a matrix over the shapes, row by row, to that part of M; an empty one adds nothing.
    pub fn add_to_shapes(&mut self, added: &[T]) {
        let count = self.size - 3;
        for (row, of_row) in added.chunks_exact(count.max(1)).enumerate() {
            let first = (3 + row) * self.size + 3;
            self.mass[first..first + count].iter_mut().zip(of_row).for_each(|(mass, added)| *mass += *added);
        }
    }
}

impl<T: Real> Beam<T> {
    /// d, m: the point of the axis at `station`.
    pub fn point_m(&self, station: &Station, q: &[T]) -> Vec2<T> {
        let (a, b) = q.split_at(station.axial.len());
        let mut along = dot(&station.axial, a);
        if self.foreshortening {
            along += self.length_m * T::from_f64(-0.5) * form(&station.shortening, b, b);
        }
        Vec2::new(self.length_m.mul_add(T::from_f64(station.share), along), self.length_m * dot(&station.lateral, b))
    }

    /// α, rad: angle of the section at `station` from the frame.
    pub fn angle_rad(&self, station: &Station, q: &[T]) -> T {
        dot(&station.slopes, &q[station.axial.len()..])
    }

    /// D = ∂d/∂q at `station`, one vector for each coordinate.
    pub fn partials(&self, station: &Station, q: &[T], out: &mut [Vec2<T>]) {
        let (axial, count) = (station.axial.len(), station.lateral.len());
        for (out, value) in out.iter_mut().zip(&station.axial) {
            *out = Vec2::new(T::from_f64(*value), T::zero());
        }
        for i in 0..count {
            let along = if self.foreshortening {
                -(self.length_m * dot(&station.shortening[i * count..(i + 1) * count], &q[axial..]))
            } else {
                T::zero()
            };
            out[axial + i] = Vec2::new(along, self.length_m * T::from_f64(station.lateral[i]));
        }
    }

    /// D q̇, m/s: velocity of the point at `station` in the frame.
    pub fn rate_m_s(&self, station: &Station, q: &[T], rates: &[T]) -> Vec2<T> {
        let (a, b) = rates.split_at(station.axial.len());
        let mut along = dot(&station.axial, a);
        if self.foreshortening {
            along += -(self.length_m * form(&station.shortening, &q[station.axial.len()..], b));
        }
        Vec2::new(along, self.length_m * dot(&station.lateral, b))
    }

    /// Acceleration of the point at `station` along the axis by foreshortening where q̈ = 0, -f ḃᵀHḃ, m/s².
    pub fn shortening_m_s2(&self, station: &Station, rates: &[T]) -> T {
        if !self.foreshortening {
            return T::zero();
        }
        let b = &rates[station.axial.len()..];
        -(self.length_m * form(&station.shortening, b, b))
    }

    /// Relative acceleration, m/s², that (F2) adds to the acceleration of the frame and -ω² d where q̈ = 0: 2ω k×(D q̇) + (-f ḃᵀHḃ, 0), for
    /// D q̇ = `rate_m_s`.
    pub fn relative_acceleration_m_s2(
        &self,
        station: &Station,
        rate_m_s: Vec2<T>,
        rates: &[T],
        spin_rad_s: T,
    ) -> Vec2<T> {
        let mut acceleration = rate_m_s.turned() * (spin_rad_s + spin_rad_s);
        if self.foreshortening {
            acceleration.x += self.shortening_m_s2(station, rates);
        }
        acceleration
    }

    /// M and h (F3) at q and its `rates`, as sums over the points of the mass.
    pub fn inertia(&self, shapes: &Shapes, q: &[T], rates: &[T], spin_rad_s: T, out: &mut Inertia<T>) {
        let Inertia { size, mass, bias, partials } = out;
        let n = *size;
        mass.fill(T::zero());
        bias.fill(T::zero());
        for MassPoint { station, weight } in &shapes.points {
            let at_kg = self.mass_kg * T::from_f64(*weight);
            let d = self.point_m(station, q);
            self.partials(station, q, partials);
            let rate = self.rate_m_s(station, q, rates);
            let relative = self.relative_acceleration_m_s2(station, rate, rates, spin_rad_s);
            let push = relative.plus(d, -spin_rad_s.squared()) * at_kg;
            let turned = d.turned();
            bias[0] += push.x;
            bias[1] += push.y;
            bias[2] += turned.dot(push);
            mass[2 * n] = at_kg.mul_add(turned.x, mass[2 * n]);
            mass[2 * n + 1] = at_kg.mul_add(turned.y, mass[2 * n + 1]);
            mass[2 * n + 2] = at_kg.mul_add(turned.length_squared(), mass[2 * n + 2]);
            for k in 0..n - 3 {
                let heavy = partials[k] * at_kg;
                let row = &mut mass[(3 + k) * n..(4 + k) * n];
                row[0] += heavy.x;
                row[1] += heavy.y;
                row[2] += heavy.dot(turned);
                for l in 0..=k {
                    row[3 + l] += heavy.dot(partials[l]);
                }
                bias[3 + k] += partials[k].dot(push);
            }
        }
        mass[0] = self.mass_kg;
        mass[n + 1] = self.mass_kg;
        for row in 0..n {
            for column in row + 1..n {
                mass[row * n + column] = mass[column * n + row];
            }
        }
    }

    /// Kinetic energy, J, of the points of the mass for the velocity of the root, in the axes of the frame, and the frame's spin.
    pub fn kinetic_j(&self, shapes: &Shapes, q: &[T], rates: &[T], velocity_m_s: Vec2<T>, spin_rad_s: T) -> T {
        let mut energy = T::zero();
        for MassPoint { station, weight } in &shapes.points {
            let of_point = velocity_m_s.plus(self.point_m(station, q).turned(), spin_rad_s);
            let velocity = of_point + self.rate_m_s(station, q, rates);
            energy = velocity.length_squared().mul_add(T::from_f64(0.5 * weight), energy);
        }
        self.mass_kg * energy
    }

    /// Centre of mass in the frame, m.
    pub fn centre_of_mass_m(&self, shapes: &Shapes, q: &[T]) -> Vec2<T> {
        shapes.points.iter().fold(Vec2::zero(), |sum: Vec2<T>, MassPoint { station, weight }| {
            sum.plus(self.point_m(station, q), T::from_f64(*weight))
        })
    }

    /// Strain energy ½ qᵀ K q, J.
    pub fn strain_j(&self, shapes: &Shapes, q: &[T]) -> T {
        let (a, b) = q.split_at(shapes.axial());
        let axial = self.axial_stiffness_n_m * form(&shapes.axial_stiffness, a, a);
        let bending = self.bending_stiffness_n_m * form(&shapes.bending_stiffness, b, b);
        T::from_f64(0.5) * (axial + bending)
    }

    /// Adds the elastic forces -K q to `forces`, one for each coordinate.
    pub fn add_stiffness(&self, shapes: &Shapes, q: &[T], forces: &mut [T]) {
        for part in self.parts(shapes) {
            let count = part.range.len();
            for k in 0..count {
                let pull = dot(&part.stiffness[k * count..(k + 1) * count], &q[part.range.clone()]);
                let force = &mut forces[part.range.start + k];
                *force += -(part.stiffness_unit * pull);
            }
        }
    }

    /// Adds the elastic forces -K q and the damping -C q̇ of all shapes of a beam without lumped masses to `forces`, one for each coordinate.
    /// The damping acts on q̇ alone.
    pub fn add_elastic(&self, shapes: &Shapes, q: &[T], rates: &[T], forces: &mut [T]) {
        let damping = [&shapes.axial_damping, &shapes.bending_damping];
        for ((part, damping), damping_unit) in self.parts(shapes).into_iter().zip(damping).zip(self.damping()) {
            let count = part.range.len();
            for k in 0..count {
                let row = k * count..(k + 1) * count;
                let pull = dot(&part.stiffness[row.clone()], &q[part.range.clone()]);
                let drag = dot(&damping[row], &rates[part.range.clone()]);
                let force = &mut forces[part.range.start + k];
                *force += -(part.stiffness_unit * pull) - damping_unit * drag;
            }
        }
    }

    /// The axial shapes, then the lateral ones.
    fn parts<'s>(&self, shapes: &'s Shapes) -> [ShapeGroup<'s, T>; 2] {
        let (axial, count) = (shapes.axial(), shapes.count());
        [
            ShapeGroup {
                range: 0..axial,
                stiffness: &shapes.axial_stiffness,
                stiffness_unit: self.axial_stiffness_n_m,
            },
            ShapeGroup {
                range: axial..count,
                stiffness: &shapes.bending_stiffness,
                stiffness_unit: self.bending_stiffness_n_m,
            },
        ]
    }

    /// Power q̇ᵀ C q̇ that the damping of a beam without lumped masses turns into heat, W.
    pub fn damping_loss_w(&self, shapes: &Shapes, rates: &[T]) -> T {
        let [axial, bending] = self.damping();
        let (a, b) = rates.split_at(shapes.axial());
        axial * form(&shapes.axial_damping, a, a) + bending * form(&shapes.bending_damping, b, b)
    }

    /// Its values as plain numbers.
    pub fn plain(&self) -> Beam<f64> {
        Beam {
            length_m: self.length_m.to_f64(),
            mass_kg: self.mass_kg.to_f64(),
            axial_stiffness_n_m: self.axial_stiffness_n_m.to_f64(),
            bending_stiffness_n_m: self.bending_stiffness_n_m.to_f64(),
            damping_ratio: self.damping_ratio.to_f64(),
            foreshortening: self.foreshortening,
        }
    }

    /// 2ζ √(EA m/L), N s/m, and 2ζ √(EI m L), N m s.
    fn damping(&self) -> [T; 2] {
        let twice = self.damping_ratio + self.damping_ratio;
        let axial = (self.axial_stiffness_n_m * self.mass_kg).sqrt();
        let bending = (self.bending_stiffness_n_m * self.mass_kg).sqrt() * self.length_m;
        [twice * axial, twice * bending]
    }
}

impl Beam<f64> {
    /// Natural frequencies of the beam without lumped masses with the frame held, Hz, ascending in each list: axial ones, then lateral ones.
    pub fn frequencies_hz(&self, shapes: &Shapes) -> [Vec<f64>; 2] {
        let [axial, lateral] = shapes.squared_frequencies();
        let axial_unit = self.axial_stiffness_n_m / self.mass_kg;
        let lateral_unit = self.bending_stiffness_n_m / (self.mass_kg * self.length_m * self.length_m);
        let hz = |squares: Vec<f64>, unit: f64| {
            squares.iter().map(|square| (square * unit).sqrt() / std::f64::consts::TAU).collect()
        };
        [hz(axial, axial_unit), hz(lateral, lateral_unit)]
    }

    /// Euler load of the beam between two pins, π² EI/L², N.
    pub fn euler_load_n(&self) -> f64 {
        std::f64::consts::PI.powi(2) * self.bending_stiffness_n_m / self.length_m
    }
}

/// Σ coefficient · number, without the terms that are zero.
fn dot<T: Real>(coefficients: &[f64], numbers: &[T]) -> T {
    let terms = coefficients.iter().zip(numbers).filter(|(coefficient, _)| **coefficient != 0.0);
    terms.fold(T::zero(), |sum, (coefficient, number)| number.mul_add(T::from_f64(*coefficient), sum))
}

/// xᵀ A y.
fn form<T: Real>(matrix: &[f64], x: &[T], y: &[T]) -> T {
    let rows = matrix.chunks_exact(y.len().max(1)).zip(x);
    rows.fold(T::zero(), |sum, (row, number)| number.mul_add(dot(row, y), sum))
}
