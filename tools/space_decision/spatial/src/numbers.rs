//! The numbers of a mechanism.

use loosepin_math::{Real, Vec2};
use loosepin_mechanics::contact::NormalLaw;
use loosepin_mechanics::mechanism::{Geometry as PlanarNumbers, LinkGeometry, Sample};
use parts::{Matrix3, Vector3};

/// Axes of the markers of a joint in their bodies: a revolute joint turns about z, a prismatic one slides along x.
#[derive(Debug, Clone, Copy)]
pub struct Mount<T> {
    pub parent: Matrix3<T>,
    pub own: Matrix3<T>,
}

/// Numbers of a body and of the joint by which it hangs.
#[derive(Debug, Clone)]
pub struct LinkNumbers<T> {
    pub parent_arm: Vector3<T>,
    pub own_arm: Vector3<T>,
    pub mount: Mount<T>,
    pub centre_of_mass: Vector3<T>,
    pub mass: T,
    pub inertia: Matrix3<T>,
}

/// Numbers of a joint with play: a ball.
#[derive(Debug, Clone)]
pub struct PlayNumbers<T> {
    pub arms: [Vector3<T>; 2],
    pub clearance: T,
    pub law: NormalLaw<T>,
}

/// Numbers of a mechanism.
#[derive(Debug, Clone)]
pub struct Numbers<T> {
    pub links: Vec<LinkNumbers<T>>,
    pub cuts: Vec<([Vector3<T>; 2], Mount<T>)>,
    pub plays: Vec<PlayNumbers<T>>,
    pub gravity: Vector3<T>,
}

/// A vector of the plane.
fn vector<T: Real>(vector: Vec2<T>) -> Vector3<T> {
    Vector3([vector.x, vector.y, T::zero()])
}

fn mount<T: Real>(link: &LinkGeometry<T>) -> Mount<T> {
    let marker = |direction: Vec2<T>| Matrix3::about_z(direction.y, direction.x);
    let parent = marker(link.parent_direction);
    Mount { own: marker(link.turn_from_parent).transposed().times(&parent), parent }
}

fn inertia<T: Real>(inertia: T) -> Matrix3<T> {
    let mut matrix = Matrix3([Vector3::zero(); 3]);
    for k in 0..3 {
        matrix.0[k].0[k] = inertia;
    }
    matrix
}

impl<T: Real> Numbers<T> {
    /// The numbers of a planar mechanism.
    pub fn of(sample: &Sample<T>) -> Self {
        let PlanarNumbers { links, cuts, gravity_m_s2, .. } = &sample.real;
        let link = |link: &LinkGeometry<T>| LinkNumbers {
            parent_arm: vector(link.parent_arm_m),
            own_arm: vector(link.own_arm_m),
            mount: mount(link),
            centre_of_mass: vector(link.centre_of_mass_m),
            mass: link.mass_kg,
            inertia: inertia(link.inertia_kg_m2),
        };
        let plays = sample.plays.iter().map(|play| PlayNumbers {
            arms: [play.bearing_arm_m, play.journal_arm_m].map(vector),
            clearance: play.clearance_m,
            law: play.normal,
        });
        Self {
            links: links.iter().map(link).collect(),
            cuts: cuts
                .iter()
                .map(|cut| (cut.arms_m.map(vector), Mount { parent: Matrix3::identity(), own: Matrix3::identity() }))
                .collect(),
            plays: plays.collect(),
            gravity: vector(*gravity_m_s2),
        }
    }
}
