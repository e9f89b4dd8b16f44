//! The numbers of a mechanism.

use crate::geometry::Geometry;
use crate::plane::{Plane, PlaneMount};
use crate::space::{Space, SpaceMount};
use loosepin_math::{Real, Vec2};
use loosepin_mechanics::contact::NormalLaw;
use loosepin_mechanics::mechanism::{Geometry as PlanarNumbers, LinkGeometry, Sample};
use parts::{Matrix3, Vector3};

/// Numbers of a body and of the joint by which it hangs.
#[derive(Debug, Clone)]
pub struct LinkNumbers<T: Real, G: Geometry<T>> {
    pub parent_arm: G::Vector,
    pub own_arm: G::Vector,
    pub mount: G::Mount,
    pub centre_of_mass: G::Vector,
    pub mass: T,
    pub inertia: G::Inertia,
}

/// Numbers of a joint with play: a pin in the plane, a ball in space.
#[derive(Debug, Clone)]
pub struct PlayNumbers<T: Real, G: Geometry<T>> {
    pub arms: [G::Vector; 2],
    pub clearance: T,
    pub law: NormalLaw<T>,
}

/// Numbers of a mechanism.
#[derive(Debug, Clone)]
pub struct Numbers<T: Real, G: Geometry<T>> {
    pub links: Vec<LinkNumbers<T, G>>,
    pub cuts: Vec<([G::Vector; 2], G::Mount)>,
    pub plays: Vec<PlayNumbers<T, G>>,
    pub gravity: G::Vector,
}

/// A geometry in which a planar mechanism lies.
pub trait Embeds<T: Real>: Geometry<T> {
    fn vector(vector: Vec2<T>) -> Self::Vector;
    fn mount(link: &LinkGeometry<T>) -> Self::Mount;
    fn parallel() -> Self::Mount;
    fn inertia(inertia: T) -> Self::Inertia;
}

impl<T: Real + 'static> Embeds<T> for Plane {
    fn vector(vector: Vec2<T>) -> Vec2<T> {
        vector
    }
    fn mount(link: &LinkGeometry<T>) -> PlaneMount<T> {
        let angle = link.parent_angle_rad - link.own_angle_rad;
        PlaneMount { line: link.parent_direction, turn: link.turn_from_parent, angle }
    }
    fn parallel() -> PlaneMount<T> {
        let x = Vec2::new(T::one(), T::zero());
        PlaneMount { line: x, turn: x, angle: T::zero() }
    }
    fn inertia(inertia: T) -> T {
        inertia
    }
}

impl<T: Real + 'static> Embeds<T> for Space {
    fn vector(vector: Vec2<T>) -> Vector3<T> {
        Vector3([vector.x, vector.y, T::zero()])
    }
    fn mount(link: &LinkGeometry<T>) -> SpaceMount<T> {
        let marker = |direction: Vec2<T>| Matrix3::about_z(direction.y, direction.x);
        let parent = marker(link.parent_direction);
        SpaceMount { own: marker(link.turn_from_parent).transposed().times(&parent), parent }
    }
    fn parallel() -> SpaceMount<T> {
        SpaceMount { parent: Matrix3::identity(), own: Matrix3::identity() }
    }
    /// A lamina's, as far as the plane feels it.
    fn inertia(inertia: T) -> Matrix3<T> {
        let mut matrix = Matrix3([Vector3::zero(); 3]);
        for k in 0..3 {
            matrix.0[k].0[k] = inertia;
        }
        matrix
    }
}

impl<T: Real, G: Embeds<T>> Numbers<T, G> {
    /// The numbers of a planar mechanism.
    pub fn of(sample: &Sample<T>) -> Self {
        let PlanarNumbers { links, cuts, gravity_m_s2, .. } = &sample.real;
        let link = |link: &LinkGeometry<T>| LinkNumbers {
            parent_arm: G::vector(link.parent_arm_m),
            own_arm: G::vector(link.own_arm_m),
            mount: G::mount(link),
            centre_of_mass: G::vector(link.centre_of_mass_m),
            mass: link.mass_kg,
            inertia: G::inertia(link.inertia_kg_m2),
        };
        let plays = sample.plays.iter().map(|play| PlayNumbers {
            arms: [play.bearing_arm_m, play.journal_arm_m].map(G::vector),
            clearance: play.clearance_m,
            law: play.normal,
        });
        Self {
            links: links.iter().map(link).collect(),
            cuts: cuts.iter().map(|cut| (cut.arms_m.map(G::vector), G::parallel())).collect(),
            plays: plays.collect(),
            gravity: G::vector(*gravity_m_s2),
        }
    }
}
