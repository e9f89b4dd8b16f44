//! The numbers of several samples side by side, one a lane; and all numbers of a sample in a row.

use super::contact_place::{PlayShape, SliderBlock, SlotShape};
use super::control::ControlGeometry;
use super::coupling_geometry::CouplingGeometry;
use super::drive::Drives;
use super::geometry::{CutGeometry, Geometry, LinkGeometry};
use super::joint_friction::JointFriction;
use super::load::LoadGeometry;
use super::sample::{PlayGeometry, Sample};
use super::spring::SpringGeometry;
use crate::contact::{Film, FrictionLaw, NormalContact, NormalLaw};
use loosepin_math::{Real, Vec2};

impl<T: Real> Sample<T> {
    /// The numbers of `sample` as constants of `T`.
    pub fn broadcast(sample: &Sample<f64>) -> Self {
        Self {
            ideal: Geometry::broadcast(&sample.ideal),
            real: Geometry::broadcast(&sample.real),
            plays: sample.plays.iter().map(play).collect(),
            contacts: sample.contacts.clone(),
            frictions: sample.frictions.iter().map(JointFriction::broadcast).collect(),
            springs: sample.springs.iter().map(SpringGeometry::broadcast).collect(),
            loads: sample.loads.iter().map(LoadGeometry::broadcast).collect(),
            drives: Drives::broadcast(&sample.drives),
            controls: sample.controls.iter().map(ControlGeometry::broadcast).collect(),
            references: Drives::broadcast(&sample.references),
            initial: sample.initial.clone(),
        }
    }

    /// Shows every number that the equations of motion use, those of the real tree, plays, springs, loads and drives, in an order that
    /// depends on the mechanism alone.
    ///
    /// The laws and the exponent of a contact are no numbers: they belong to the mechanism and are the same in all runs.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.real.gravity_m_s2.visit(visit);
        for link in &mut self.real.links {
            for vector in [
                &mut link.parent_arm_m,
                &mut link.own_arm_m,
                &mut link.parent_direction,
                &mut link.turn_from_parent,
                &mut link.eccentricity_m,
                &mut link.centre_of_mass_m,
            ] {
                vector.visit(visit);
            }
            visit(&mut link.parent_angle_rad);
            visit(&mut link.own_angle_rad);
            visit(&mut link.mass_kg);
            visit(&mut link.inertia_kg_m2);
        }
        for cut in &mut self.real.cuts {
            for side in 0..2 {
                cut.arms_m[side].visit(visit);
                visit(&mut cut.angles_rad[side]);
            }
            cut.eccentricity_m.visit(visit);
        }
        self.real.couplings.iter_mut().for_each(|coupling| coupling.visit(visit));
        for play in &mut self.plays {
            play.bearing_arm_m.visit(visit);
            play.journal_arm_m.visit(visit);
            match &mut play.shape {
                PlayShape::Pin { bearing_radius_m } => visit(bearing_radius_m),
                PlayShape::Slider(block) => block.visit(visit),
                PlayShape::Slot(slot) => slot.visit(visit),
            }
            visit(&mut play.clearance_m);
            play.normal.visit(visit);
            play.friction.visit(visit);
            if let Some(film) = &mut play.film {
                film.visit(visit);
            }
            visit(&mut play.minimum_impact_speed_m_s);
        }
        self.frictions.iter_mut().for_each(|friction| friction.visit(visit));
        self.springs.iter_mut().for_each(|spring| spring.visit(visit));
        self.loads.iter_mut().for_each(|load| load.visit(visit));
        self.drives.visit(visit);
        self.controls.iter_mut().for_each(|control| control.visit(visit));
        self.references.visit(visit);
    }
}

impl Sample<f64> {
    /// Every number that the equations of motion use, in the order of [`Sample::visit`].
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.clone().visit(&mut |number| numbers.push(*number));
        numbers
    }
}

impl<T: Real> Geometry<T> {
    /// The numbers of `from` as constants of `T`.
    pub fn broadcast(from: &Geometry<f64>) -> Self {
        let (number, vector) = (T::from_f64, Vec2::from_f64);
        Self {
            links: from
                .links
                .iter()
                .map(|link| LinkGeometry {
                    parent_arm_m: vector(link.parent_arm_m),
                    own_arm_m: vector(link.own_arm_m),
                    parent_angle_rad: number(link.parent_angle_rad),
                    own_angle_rad: number(link.own_angle_rad),
                    parent_direction: vector(link.parent_direction),
                    turn_from_parent: vector(link.turn_from_parent),
                    eccentricity_m: vector(link.eccentricity_m),
                    centre_of_mass_m: vector(link.centre_of_mass_m),
                    mass_kg: number(link.mass_kg),
                    inertia_kg_m2: number(link.inertia_kg_m2),
                })
                .collect(),
            cuts: from
                .cuts
                .iter()
                .map(|cut| CutGeometry {
                    arms_m: cut.arms_m.map(vector),
                    angles_rad: cut.angles_rad.map(number),
                    eccentricity_m: vector(cut.eccentricity_m),
                })
                .collect(),
            couplings: from.couplings.iter().map(CouplingGeometry::broadcast).collect(),
            gravity_m_s2: vector(from.gravity_m_s2),
        }
    }
}

fn play<T: Real>(from: &PlayGeometry<f64>) -> PlayGeometry<T> {
    let (number, vector) = (T::from_f64, Vec2::from_f64);
    PlayGeometry {
        bearing_arm_m: vector(from.bearing_arm_m),
        journal_arm_m: vector(from.journal_arm_m),
        shape: match from.shape {
            PlayShape::Pin { bearing_radius_m } => PlayShape::Pin { bearing_radius_m: number(bearing_radius_m) },
            PlayShape::Slider(block) => PlayShape::Slider(SliderBlock::broadcast(&block)),
            PlayShape::Slot(slot) => PlayShape::Slot(SlotShape::broadcast(&slot)),
        },
        clearance_m: number(from.clearance_m),
        normal: NormalLaw::broadcast(&from.normal),
        friction: FrictionLaw::broadcast(&from.friction),
        film: from.film.as_ref().map(Film::broadcast),
        sliding_velocity: from.sliding_velocity,
        minimum_impact_speed_m_s: number(from.minimum_impact_speed_m_s),
        largest_valid_impact_speed_m_s: from.largest_valid_impact_speed_m_s,
        delivered_restitution: from.delivered_restitution,
    }
}
