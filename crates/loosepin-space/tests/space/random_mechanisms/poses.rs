//! Which poses a mechanism with play can have, with the poses as unknowns: ideal joints and drives are equations, each play is a bound on what
//! is measured between the poses of its two bodies. Nothing here is taken from the loop equations of the product, only its numbers.
//!
//! In axes A of the bearing d = Aᵀ(P_j - P_i), b = Aᵀz_j: slope w = b_12/b_3, e = d_12 - d_3 w, u = e ± w l/2, α = d_3; balls have |d| <= c.

use super::linear::{Columns, Jacobi, add, times};
use loosepin_space::{JointCoordinate, Rotation, SpatialMechanism, SpatialOutput, SpatialPlay, Vec3};

/// Singular values below this relative to the largest are zero: central differences leave 1e-10.
const ZERO: f64 = 1e-7;
/// Step of the central differences of poses, lengths over L and rad.
const STEP: f64 = 1e-5;

/// What is measured between the poses.
#[derive(Default, Clone)]
pub struct Measured {
    /// Equations of ideal joints and drives, lengths over L.
    pub equations: Vec<f64>,
    /// Places of the journals over their radii, block after block.
    pub places: Vec<f64>,
}

/// A mechanism that is closed with all bodies as they are drawn, with coordinates t of its motions within the play.
///
/// x = T t + (what meets the equations), and the places are Q t to first order, Q with orthonormal columns.
pub struct PoseSet<'a> {
    mechanism: &'a SpatialMechanism,
    output: &'a SpatialOutput,
    length_m: f64,
    /// First place and size of each block.
    pub blocks: Vec<(usize, usize)>,
    equations: Jacobi,
    directions: Columns,
    /// Q, by its columns.
    pub first_order: Columns,
}

/// A reached state: value of the output and places.
pub struct Reached {
    pub output: f64,
    pub places: Vec<f64>,
}

impl<'a> PoseSet<'a> {
    pub fn new(mechanism: &'a SpatialMechanism, output: &'a SpatialOutput) -> Self {
        let points = mechanism.joints().iter().map(|joint| joint.bearing.point_m.length());
        let length_m = points.fold(0.05, f64::max);
        let unknowns = 6 * (mechanism.bodies().len() - 1);
        let empty = Jacobi { images: Vec::new(), right: Vec::new() };
        let mut set = Self {
            mechanism,
            output,
            length_m,
            blocks: Vec::new(),
            equations: empty,
            directions: Vec::new(),
            first_order: Vec::new(),
        };
        set.blocks = set.block_list();
        let mut columns = (Vec::new(), Vec::new());
        for unknown in 0..unknowns {
            let at = |sign: f64| {
                let mut x = vec![0.0; unknowns];
                x[unknown] = sign * STEP;
                set.measure(&x)
            };
            let (plus, minus) = (at(1.0), at(-1.0));
            let difference = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b) / (2.0 * STEP)).collect();
            columns.0.push(difference(&plus.equations, &minus.equations));
            columns.1.push(difference(&plus.places, &minus.places));
        }
        set.equations = Jacobi::new(&columns.0);
        let free = set.equations.null_space(ZERO);
        // Motions of single parts that no play notices, such as the spin of a rod between two balls, have no image and are left out.
        let images: Columns = free.iter().map(|direction| times(&columns.1, direction)).collect();
        let seen = Jacobi::new(&images);
        let least = ZERO * seen.largest();
        for (image, right) in seen.images.iter().zip(&seen.right) {
            let size = super::linear::length(image);
            if size > least {
                set.directions.push(times(&free, right).iter().map(|entry| entry / size).collect());
                set.first_order.push(image.iter().map(|entry| entry / size).collect());
            }
        }
        set
    }

    /// Number of coordinates.
    pub fn dimensions(&self) -> usize {
        self.directions.len()
    }

    fn block_list(&self) -> Vec<(usize, usize)> {
        let sizes =
            self.mechanism.joints().iter().filter_map(|joint| joint.play.as_ref()).flat_map(|play| match play {
                SpatialPlay::Spherical(_) => vec![3],
                SpatialPlay::Revolute(_) => vec![2, 2, 1],
                SpatialPlay::Upright(_) => vec![2, 1],
                SpatialPlay::Cylindrical(_) => vec![2, 2],
            });
        let mut first = 0;
        sizes
            .map(|size| {
                first += size;
                (first - size, size)
            })
            .collect()
    }

    /// The output and the places at t; `None` where the equations cannot be met.
    pub fn reach(&self, t: &[f64]) -> Option<Reached> {
        let mut x = times(&self.directions, t);
        let mut before = f64::INFINITY;
        for _ in 0..60 {
            let measured = self.measure(&x);
            let size = measured.equations.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
            if size < 1e-15 || (size < 1e-12 && size > 0.5 * before) {
                return Some(Reached { output: self.output_at(&x), places: measured.places });
            }
            if !(size < 1.0) {
                return None;
            }
            before = size;
            add(&mut x, &self.equations.solve(&measured.equations, ZERO), -1.0);
        }
        None
    }

    /// t at which the journals are at given places, for mechanisms without redundant rows: there are as many coordinates as places.
    pub fn at_places(&self, places: &[f64]) -> Option<Reached> {
        let mut t: Vec<f64> = self.first_order.iter().map(|column| super::linear::dot(column, places)).collect();
        for _ in 0..60 {
            let reached = self.reach(&t)?;
            let miss: Vec<f64> = places.iter().zip(&reached.places).map(|(due, at)| due - at).collect();
            if super::linear::length(&miss) < 1e-11 {
                return Some(reached);
            }
            let step: Vec<f64> = self.first_order.iter().map(|column| super::linear::dot(column, &miss)).collect();
            add(&mut t, &step, 1.0);
        }
        None
    }

    /// Displacement and turn of a body in the unknowns.
    fn body(&self, x: &[f64], body: usize) -> (Vec3, Vec3) {
        let Some(own) = body.checked_sub(1).map(|moving| &x[6 * moving..6 * moving + 6]) else {
            return (Vec3::ZERO, Vec3::ZERO);
        };
        (Vec3::new(own[0], own[1], own[2]) * self.length_m, Vec3::new(own[3], own[4], own[5]))
    }

    fn output_at(&self, x: &[f64]) -> f64 {
        match self.output {
            SpatialOutput::Point(own) => {
                let (displacement, turn) = self.body(x, own.body);
                (displacement + turned(turn, own.point_m) - own.point_m).dot(own.direction)
            }
            SpatialOutput::Rotation(own) => self.body(x, own.body).1.dot(own.axis),
            _ => panic!("no such output is drawn"),
        }
    }

    fn measure(&self, x: &[f64]) -> Measured {
        let mut found = Measured::default();
        let bodies: Vec<(Vec3, Rotation)> = (0..self.mechanism.bodies().len())
            .map(|body| {
                let (displacement, turn) = self.body(x, body);
                let [x, y, z] = Vec3::AXES.map(|axis| turned(turn, axis));
                (displacement, Rotation { x, y, z })
            })
            .collect();
        for (number, joint) in self.mechanism.joints().iter().enumerate() {
            let [(r_i, bearing), (r_j, other)] = [bodies[joint.bearing.body], bodies[joint.journal.body]];
            let apart = r_j + other.apply(joint.journal.point_m) - r_i - bearing.apply(joint.bearing.point_m);
            let own = joint.bearing.axes;
            let axes = [own.x, own.y, own.z].map(|axis| bearing.apply(axis));
            let d = axes.map(|axis| axis.dot(apart));
            let b_z = axes.map(|axis| axis.dot(other.apply(joint.journal.axes.z)));
            let w = [b_z[0] / b_z[2], b_z[1] / b_z[2]];
            let over = |value: f64| value / self.length_m;
            let ends = |length: f64, radius: f64| {
                [-0.5 * length, 0.5 * length].map(|z| [0, 1].map(|k| (d[k] - d[2] * w[k] + z * w[k]) / radius))
            };
            match (&joint.play, joint.kind.word()) {
                (Some(SpatialPlay::Spherical(own)), _) => {
                    found.places.extend(d.map(|own_d| own_d / own.radial_clearance_m))
                }
                (Some(SpatialPlay::Revolute(own)), _) => {
                    found.places.extend(ends(own.bearing_length_m, own.radial_clearance_m).as_flattened());
                    found.places.push(d[2] / own.axial_clearance_m);
                }
                (Some(SpatialPlay::Cylindrical(own)), _) => {
                    found.places.extend(ends(own.bearing_length_m, own.radial_clearance_m).as_flattened());
                }
                (Some(SpatialPlay::Upright(own)), _) => {
                    found.equations.extend([b_z[0], b_z[1]]);
                    found.places.extend([d[0] / own.radial_clearance_m, d[1] / own.radial_clearance_m]);
                    found.places.push(d[2] / own.axial_clearance_m);
                }
                (None, "spherical") => found.equations.extend(d.map(over)),
                (None, "universal") => {
                    found.equations.extend(d.map(over));
                    found.equations.push(b_z[2]);
                }
                (None, "revolute") => {
                    found.equations.extend(d.map(over));
                    found.equations.extend([b_z[0], b_z[1]]);
                }
                (None, "cylindrical") => found.equations.extend([over(d[0]), over(d[1]), b_z[0], b_z[1]]),
                (None, "prismatic") => {
                    found.equations.extend([over(d[0]), over(d[1]), b_z[0], b_z[1]]);
                    found.equations.push(axes[0].dot(other.apply(joint.journal.axes.y)));
                }
                (None, other) => panic!("no {other} joint is drawn"),
            }
            // Drives hold the coordinate that is drawn: the angle 0 and the place 0.
            for drive in self.mechanism.drives().iter().filter(|drive| drive.joint == number) {
                found.equations.push(match drive.coordinate {
                    JointCoordinate::Angle => axes[1].dot(other.apply(joint.journal.axes.x)),
                    JointCoordinate::Slide => over(d[2]),
                });
            }
        }
        found
    }
}

/// exp(ω) v by Rodrigues' formula.
fn turned(rotation: Vec3, vector: Vec3) -> Vec3 {
    let angle = rotation.length();
    let (sine, versine) = if angle > 1e-4 {
        (angle.sin() / angle, 2.0 * (0.5 * angle).sin().powi(2) / (angle * angle))
    } else {
        (1.0 - angle * angle / 6.0, 0.5 - angle * angle / 24.0)
    };
    let across = rotation.cross(vector);
    vector + across * sine + rotation.cross(across) * versine
}
