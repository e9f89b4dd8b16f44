//! The numbers of a joint that wears.

use loosepin_mechanics::contact::LinePatch;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{JointId, PlayId, Values, WearPressure};

/// The numbers of a joint that wears.
#[derive(Debug, Clone, PartialEq)]
pub struct WearingJoint {
    /// The joint.
    pub joint: JointId,
    /// Its index in [`Mechanism::plays`]; `None` if its clearance is zero.
    pub play: Option<usize>,
    /// Radii R_i of the bearing and R_j of the journal, m.
    pub radii_m: [f64; 2],
    /// Length L_b of the bearing, m.
    pub length_m: f64,
    /// Wear coefficients of bearing and journal, m²/N; `None` if a surface does not wear.
    pub coefficients_m2_n: [Option<f64>; 2],
    /// Cycles after which wear is stated.
    pub cycles: f64,
    /// Sectors of each surface.
    pub sectors: usize,
    /// The patch over which the pressure is distributed; `None` if all of it is in one sector.
    pub patch: Option<LinePatch>,
}

impl WearingJoint {
    /// The joints of `mechanism` that wear, in file order.
    pub fn all(mechanism: &Mechanism, values: &Values) -> Vec<Self> {
        let joints = (0..mechanism.model.joints.len()).map(JointId);
        joints.filter_map(|joint| Self::new(mechanism, values, joint)).collect()
    }

    fn new(mechanism: &Mechanism, values: &Values, joint: JointId) -> Option<Self> {
        let model = &mechanism.model;
        let wear = model.joints[joint.0].wear.as_ref()?;
        let clearance = model.joints[joint.0].kind.pin_clearance()?;
        let bearing_radius_m = values[clearance.bearing_radius_m];
        let radii_m = [bearing_radius_m, bearing_radius_m - values[clearance.radial_clearance_m]];
        let length_m = values[wear.bearing_length_m];
        let patch = match (model.contacts[clearance.contact.0].law.materials(), wear.pressure) {
            (Some(materials), WearPressure::HertzLine) => {
                Some(LinePatch::new(radii_m, length_m, materials.compliances_1_pa(values)))
            }
            _ => None,
        };
        Some(Self {
            joint,
            play: mechanism.plays.iter().position(|play| *play == PlayId::Joint(joint)),
            radii_m,
            length_m,
            coefficients_m2_n: wear.coefficients_m2_n.map(|id| id.map(|id| values[id])),
            cycles: model.wear.map_or(1.0, |life| values[life.cycles]),
            sectors: wear.sectors,
            patch,
        })
    }

    /// Area R Δ L_b of a sector of the bearing (0) or of the journal (1), m².
    pub fn sector_area_m2(&self, side: usize) -> f64 {
        self.radii_m[side] * std::f64::consts::TAU / self.sectors as f64 * self.length_m
    }
}
