//! The numbers of one sample, laid out for a tree: arms, angles, masses.

use crate::mechanism::loops::coupling_geometry::CouplingGeometry;
use crate::mechanism::parts::nodal_geometry::NodalGeometry;
use crate::mechanism::row::displace;
use crate::mechanism::tree::beam::{BeamPlace, TreeBeam};
use crate::mechanism::tree::cut_numbers::{CutNumbers, line_angles_rad};
use crate::mechanism::tree::points::numbered_point_m;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{BodyId, JointId, LumpedMass as BeamLump, Model, PlayId, PointId, QuantityId, Values};
use loosepin_flexible::{Beam, HeldBeam, LumpedMass};
use loosepin_math::{Geometry, Plane, PlaneMount, Real, Vec2, numbers};

/// Numbers of a link of the tree.
#[derive(Debug, Clone, Copy)]
pub struct LinkNumbers<T: Real, G: Geometry = Plane> {
    /// Joint point in the parent's frame, m.
    pub parent_arm_m: G::Vector<T>,
    /// Joint point in the link's own frame, m.
    pub own_arm_m: G::Vector<T>,
    /// How the axes of the joint lie in the frames of parent and link.
    pub mount: G::Mount<T>,
    /// Revolute: the link's point minus the parent's point, in the ground's frame, m. Zero unless a clearance joint is
    /// treated as ideal with a displaced journal.
    pub eccentricity_m: G::Vector<T>,
    /// Centre of mass in the link's frame, m.
    pub centre_of_mass_m: G::Vector<T>,
    /// Mass, kg.
    pub mass_kg: T,
    /// Moments of inertia about the centre of mass, kg m².
    pub inertia_kg_m2: G::Inertia<T>,
}

numbers!(struct LinkNumbers { parent_arm_m, own_arm_m, mount, eccentricity_m, centre_of_mass_m, mass_kg, inertia_kg_m2 });

impl<T: Real> LinkNumbers<T> {
    /// Gives the link mass, inertia and centre of mass of lumps of a body that it carries.
    fn set_lumps(&mut self, model: &Model, body: BodyId, lumps: &[&BeamLump], number: &dyn Fn(QuantityId) -> T) {
        let at = |lump: &BeamLump| numbered_point_m(model, number, PointId { body, point: lump.point });
        self.mass_kg = lumps.iter().fold(T::zero(), |sum, lump| sum + number(lump.mass_kg));
        self.centre_of_mass_m = match lumps {
            [lump] => at(lump),
            _ => {
                let moment =
                    lumps.iter().fold(Vec2::zero(), |sum: Vec2<T>, lump| sum.plus(at(lump), number(lump.mass_kg)));
                // Lumps without mass have their centre anywhere.
                let mass_kg = T::select(T::zero().less_than(self.mass_kg), self.mass_kg, T::one());
                moment * (T::one() / mass_kg)
            }
        };
        for lump in lumps {
            let away = at(lump) - self.centre_of_mass_m;
            let own = lump.inertia_kg_m2.map_or(T::zero(), number);
            self.inertia_kg_m2 = number(lump.mass_kg).mul_add(away.length_squared(), self.inertia_kg_m2 + own);
        }
    }
}

/// The numbers of one sample for one tree.
#[derive(Debug, Clone)]
pub struct TreeNumbers<T: Real, G: Geometry = Plane> {
    /// One for each link.
    pub links: Vec<LinkNumbers<T, G>>,
    /// One for each cut joint.
    pub cuts: Vec<CutNumbers<T, G>>,
    /// One for each ideal coupling.
    pub couplings: Vec<CouplingGeometry<T>>,
    /// One for each flexible body of the tree.
    pub beams: Vec<BeamGeometry<T>>,
    /// One for each flexible body in absolute nodal coordinates.
    pub nodal_beams: Vec<NodalGeometry<T>>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: G::Vector<T>,
}

numbers!(struct TreeNumbers { gravity_m_s2, links, cuts, couplings, beams, nodal_beams });

/// Numbers of a flexible body.
#[derive(Debug, Clone)]
pub struct BeamGeometry<T> {
    /// The beam.
    pub beam: Beam<T>,
    /// Its root in the frame of the body, m.
    pub root_m: Vec2<T>,
    /// Its tip in the frame of the body, undeformed, m.
    pub tip_m: Vec2<T>,
    /// Direction from root to tip in the frame of the body.
    pub axis: Vec2<T>,
    /// Damping matrix over all shapes of a beam with damping and lumps or condensed shapes, row by row; empty where it follows from
    /// [`Beam::damping_ratio`] alone.
    pub damping: Vec<T>,
    /// Contribution of condensed shapes to the mass matrix of the shapes, row by row; empty if none may be condensed.
    pub added_mass: Vec<T>,
    /// Which shapes are condensed; absent where none may be.
    pub condensed: Option<Condensed>,
}

numbers!(struct BeamGeometry { beam, root_m, tip_m, axis, damping, added_mass; condensed });

/// Shapes of a flexible body that are condensed.
#[derive(Debug, Clone, PartialEq)]
pub struct Condensed {
    /// The frequency that they have with the frame held, Hz.
    pub above_hz: f64,
    /// The frequencies that they had, Hz, ascending.
    pub were_hz: Vec<f64>,
}

impl<T: Real> BeamGeometry<T> {
    /// A place on the axis of `beam` in the frame of the body, undeformed, m.
    pub fn axis_point_m(&self, beam: &TreeBeam, at: BeamPlace) -> Vec2<T> {
        match at {
            BeamPlace::Root => self.root_m,
            BeamPlace::Tip => self.tip_m,
            BeamPlace::Inside(index) => {
                let share = beam.shapes.inside[index].share;
                self.root_m.plus(self.axis, self.beam.length_m * T::from_f64(share))
            }
        }
    }

    fn new(model: &Model, beam: &TreeBeam, number: &dyn Fn(QuantityId) -> T) -> Option<Self> {
        let description = model.bodies[beam.body.0].beam.as_ref()?;
        let point = |point: usize| numbered_point_m(model, number, PointId { body: beam.body, point });
        let [root_m, tip_m] = beam.points().map(point);
        let length_m = number(description.length_m);
        Some(Self {
            beam: Beam {
                length_m,
                mass_kg: number(description.mass_kg),
                axial_stiffness_n_m: number(description.axial_stiffness_n_m),
                bending_stiffness_n_m: number(description.bending_stiffness_n_m),
                damping_ratio: description.damping_ratio.map_or(T::zero(), number),
                foreshortening: description.foreshortening,
            },
            root_m,
            tip_m,
            axis: (tip_m - root_m) * (T::one() / length_m),
            damping: Vec::new(),
            added_mass: Vec::new(),
            condensed: None,
        })
    }
}

impl<T: Real> TreeNumbers<T> {
    /// Lays out `values` for `tree`, all eccentricities zero.
    pub fn new(model: &Model, tree: &Tree, values: &Values) -> Self {
        Self::from_numbers(model, tree, &|id| T::from_f64(values[id]))
    }

    /// Lays out the numbers that `number` gives for each quantity, all eccentricities zero. With dual numbers the
    /// geometry moves along a direction in the space of the quantities.
    pub fn from_numbers(model: &Model, tree: &Tree, number: &dyn Fn(QuantityId) -> T) -> Self {
        let links = tree
            .links
            .iter()
            .map(|link| {
                let body = &model.bodies[link.body.0];
                let mut geometry = LinkNumbers {
                    parent_arm_m: Vec2::zero(),
                    own_arm_m: Vec2::zero(),
                    mount: PlaneMount::new(T::zero(), T::zero()),
                    eccentricity_m: Vec2::zero(),
                    centre_of_mass_m: body
                        .centre_of_mass_m
                        .map_or(Vec2::zero(), |c| Vec2::new(number(c[0]), number(c[1]))),
                    mass_kg: body.mass_kg.map_or(T::zero(), number),
                    inertia_kg_m2: body.inertia_kg_m2.map_or(T::zero(), number),
                };
                if link.attachment.is_section() {
                    // All of the mass but that of lumps belongs to the frame.
                    (geometry.mass_kg, geometry.inertia_kg_m2) = (T::zero(), T::zero());
                }
                if let Some(section) = link.attachment.section().filter(|_| link.has_own_mass) {
                    let held = tree.beams[section.beam].lumps_at(model, section.place);
                    geometry.set_lumps(model, link.body, &held, number);
                }
                if let (Some(_), Some(beam)) = (link.beam, &body.beam) {
                    geometry.mass_kg = number(beam.mass_kg);
                }
                if let Some((joint, forward)) = link.joint() {
                    let kind = &model.joints[joint.0].kind;
                    let (parent, own) = if forward { (0, 1) } else { (1, 0) };
                    let arms = kind.points().map(|point| numbered_point_m(model, number, point));
                    let angles = line_angles_rad(kind, number);
                    geometry.parent_arm_m = arms[parent];
                    geometry.own_arm_m = arms[own];
                    geometry.mount = PlaneMount::new(angles[parent], angles[own]);
                }
                geometry
            })
            .collect();
        let cuts = tree.cuts.iter().map(|cut| CutNumbers::new(model, cut.joint, number)).collect();
        let gravity_m_s2 = Vec2::new(T::zero(), -number(model.gravity_m_s2));
        let coupling = |&index: &usize| CouplingGeometry::new(model, &model.couplings[index], number);
        let couplings = tree.coupling_indices.iter().map(coupling).collect();
        let beams = tree.beams.iter().filter_map(|beam| BeamGeometry::new(model, beam, number)).collect();
        let nodal_beams = tree.nodal_beams.iter().filter_map(|beam| NodalGeometry::new(model, beam, number)).collect();
        let mut geometry = Self { links, cuts, couplings, beams, nodal_beams, gravity_m_s2 };
        for (index, place) in tree.beams.iter().enumerate() {
            let above_hz = model.bodies[place.body.0].beam.as_ref().and_then(|beam| beam.condense_above_hz);
            if above_hz.is_none() && !(place.is_damped && place.has_lumps) {
                continue;
            }
            let mut held = geometry.held_beam(tree, index);
            let numbers = &mut geometry.beams[index];
            if let Some(above_hz) = above_hz {
                let above_hz = number(above_hz).to_f64();
                let (added, were_hz) = held.condense(above_hz);
                numbers.condensed = Some(Condensed { above_hz, were_hz });
                numbers.added_mass = added.into_iter().map(T::from_f64).collect();
            }
            if place.is_damped {
                let damping = held.damping(numbers.beam.damping_ratio.to_f64());
                numbers.damping = damping.into_iter().map(T::from_f64).collect();
            }
        }
        geometry
    }

    /// The shapes of the flexible body `index` with its frame held, its lumps included, in plain numbers.
    pub fn held_beam(&self, tree: &Tree, index: usize) -> HeldBeam {
        let (place, numbers) = (&tree.beams[index], &self.beams[index]);
        let axis = numbers.axis;
        let lumps: Vec<LumpedMass<'_>> = tree
            .links
            .iter()
            .zip(&self.links)
            .filter_map(|(link, of_link)| {
                let section = link.attachment.section().filter(|section| section.beam == index && link.has_own_mass)?;
                let at = section.place;
                let arm = (of_link.centre_of_mass_m - numbers.axis_point_m(place, at)).rotated(-axis.y, axis.x);
                Some(LumpedMass {
                    station: place.station(at),
                    arm_m: Vec2::new(arm.x.to_f64(), arm.y.to_f64()),
                    mass_kg: of_link.mass_kg.to_f64(),
                    inertia_kg_m2: of_link.inertia_kg_m2.to_f64(),
                })
            })
            .collect();
        HeldBeam::new(&numbers.beam.plain(), &place.shapes, &lumps)
    }

    /// Displaces a joint or coupling with play from where it is in `centred`, the same numbers without displacements: the second
    /// joint of a coupling by the first part of the displacement, m.
    pub fn set_displacement(&mut self, tree: &Tree, play: PlayId, displacement: Vec2<T>, centred: &TreeNumbers<T>) {
        match play {
            PlayId::Joint(joint) => self.set_joint_displacement(tree, joint, displacement, centred),
            PlayId::Coupling(index) => {
                if let Some(place) = tree.coupling_indices.iter().position(|held| *held == index) {
                    self.couplings[place].set_displacement(displacement.x, &centred.couplings[place]);
                }
            }
        }
    }

    /// Displaces the second body of `joint` from where it is in `centred`, the same numbers without displacements: by an
    /// eccentricity in the ground's frame for a revolute joint; for a prismatic one by an ordinate across the guide's line, m,
    /// and an angle, rad; for a slot by an ordinate alone, for a circular one by a length outwards. A joint that the tree treats as a force element is left alone.
    fn set_joint_displacement(&mut self, tree: &Tree, joint: JointId, displacement: Vec2<T>, centred: &TreeNumbers<T>) {
        for ((link, numbers), centred) in tree.links.iter().zip(&mut self.links).zip(&centred.links) {
            if link.joint().is_some_and(|(own, _)| own == joint) {
                link.attachment.displace(numbers, displacement, centred);
            }
        }
        for ((cut, geometry), centred) in tree.cuts.iter().zip(&mut self.cuts).zip(&centred.cuts) {
            if cut.joint == joint {
                displace(cut.rows, geometry, displacement, centred);
            }
        }
    }
}
