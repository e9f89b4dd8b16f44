//! The numbers of several samples side by side, one a lane.

use super::geometry::{CutGeometry, Geometry, LinkGeometry};
use super::sample::{DriveMotion, PlayGeometry, Sample};
use crate::contact::{AmbrosioFriction, NormalContact};
use crate::math::{Lanes, Real, Vec2};

impl<T: Lanes> Sample<T> {
    /// The same sample in every lane.
    pub fn broadcast(sample: &Sample<f64>) -> Self {
        let number = T::from_f64;
        Self {
            ideal: geometry(&sample.ideal),
            real: geometry(&sample.real),
            plays: sample.plays.iter().map(play).collect(),
            drives: sample
                .drives
                .iter()
                .map(|drive| DriveMotion { start: number(drive.start), speed: number(drive.speed) })
                .collect(),
        }
    }

    /// Replaces the numbers of one lane that the equations of motion use: those of the real tree, plays and drives.
    ///
    /// What is no number (which contacts have friction, which exponent) belongs to the mechanism and is the same in all lanes.
    pub fn set_lane(&mut self, lane: usize, sample: &Sample<f64>) {
        let number = |to: &mut T, from: f64| to.set_lane(lane, from);
        let vector = |to: &mut Vec2<T>, from: Vec2<f64>| {
            to.x.set_lane(lane, from.x);
            to.y.set_lane(lane, from.y);
        };
        vector(&mut self.real.gravity_m_s2, sample.real.gravity_m_s2);
        for (to, from) in self.real.links.iter_mut().zip(&sample.real.links) {
            vector(&mut to.parent_arm_m, from.parent_arm_m);
            vector(&mut to.own_arm_m, from.own_arm_m);
            number(&mut to.parent_angle_rad, from.parent_angle_rad);
            number(&mut to.own_angle_rad, from.own_angle_rad);
            vector(&mut to.parent_direction, from.parent_direction);
            vector(&mut to.turn_from_parent, from.turn_from_parent);
            vector(&mut to.eccentricity_m, from.eccentricity_m);
            vector(&mut to.centre_of_mass_m, from.centre_of_mass_m);
            number(&mut to.mass_kg, from.mass_kg);
            number(&mut to.inertia_kg_m2, from.inertia_kg_m2);
        }
        for (to, from) in self.real.cuts.iter_mut().zip(&sample.real.cuts) {
            for side in 0..2 {
                vector(&mut to.arms_m[side], from.arms_m[side]);
                number(&mut to.angles_rad[side], from.angles_rad[side]);
            }
            vector(&mut to.eccentricity_m, from.eccentricity_m);
        }
        for (to, from) in self.plays.iter_mut().zip(&sample.plays) {
            vector(&mut to.bearing_arm_m, from.bearing_arm_m);
            vector(&mut to.journal_arm_m, from.journal_arm_m);
            number(&mut to.bearing_radius_m, from.bearing_radius_m);
            number(&mut to.clearance_m, from.clearance_m);
            number(&mut to.normal.stiffness_n_m_n, from.normal.stiffness_n_m_n);
            number(&mut to.normal.damping_factor, from.normal.damping_factor);
            number(&mut to.friction.coefficient, from.friction.coefficient);
            number(&mut to.friction.lower_speed_m_s, from.friction.lower_speed_m_s);
            number(&mut to.friction.upper_speed_m_s, from.friction.upper_speed_m_s);
            number(&mut to.minimum_impact_speed_m_s, from.minimum_impact_speed_m_s);
        }
        for (to, from) in self.drives.iter_mut().zip(&sample.drives) {
            number(&mut to.start, from.start);
            number(&mut to.speed, from.speed);
        }
    }
}

fn geometry<T: Real>(from: &Geometry<f64>) -> Geometry<T> {
    let (number, vector) = (T::from_f64, Vec2::from_f64);
    Geometry {
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
        gravity_m_s2: vector(from.gravity_m_s2),
    }
}

fn play<T: Real>(from: &PlayGeometry<f64>) -> PlayGeometry<T> {
    let (number, vector) = (T::from_f64, Vec2::from_f64);
    PlayGeometry {
        bearing_arm_m: vector(from.bearing_arm_m),
        journal_arm_m: vector(from.journal_arm_m),
        bearing_radius_m: number(from.bearing_radius_m),
        clearance_m: number(from.clearance_m),
        normal: NormalContact {
            stiffness_n_m_n: number(from.normal.stiffness_n_m_n),
            exponent: from.normal.exponent,
            damping_factor: number(from.normal.damping_factor),
        },
        friction: AmbrosioFriction {
            coefficient: number(from.friction.coefficient),
            lower_speed_m_s: number(from.friction.lower_speed_m_s),
            upper_speed_m_s: number(from.friction.upper_speed_m_s),
        },
        has_friction: from.has_friction,
        sliding_velocity: from.sliding_velocity,
        minimum_impact_speed_m_s: number(from.minimum_impact_speed_m_s),
        largest_valid_impact_speed_m_s: from.largest_valid_impact_speed_m_s,
        delivered_restitution: from.delivered_restitution,
    }
}
