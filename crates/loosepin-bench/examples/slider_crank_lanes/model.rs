//! The numbers of `cases/slider_crank_5000` that the kernel needs, with the angle of the crank as time.
//!
//! Lengths in m, times in rad of the crank, so its speed is 1; forces and energies over J Ω², J the inertia of the rod about the crank
//! pin.

use loosepin_bench::compiled;
use std::f64::consts::TAU;

/// A clearance of run `index` of `runs` lies evenly within this share around the nominal one.
const VARIATION: f64 = 0.1;

/// The mechanism.
#[derive(Debug, Clone, Copy)]
pub struct SliderCrank {
    /// Length of the crank, m.
    pub crank_m: f64,
    /// Length of the rod, m.
    pub rod_m: f64,
    /// Gravity over Ω², m.
    pub gravity_m: f64,
    /// Mass of the rod times the share of its length at which its centre lies, over J, 1/m².
    pub rod_over_inertia_1_m2: f64,
    /// Mass of the rod over J, 1/m².
    pub rod_1_m2: f64,
    /// Mass of the rod and half the crank's, over J, 1/m²: the weight at the crank pin.
    pub weight_at_pin_1_m2: f64,
    /// Mass of the slider over J, 1/m².
    pub slider_over_inertia_1_m2: f64,
    /// Lankarani and Nikravesh's χ = 3 (1 - c_e²)/4.
    pub damping_factor: f64,
    /// Floor of the impact speed, m/rad.
    pub smallest_impact_m_rad: f64,
    /// Nominal radial clearance, m.
    pub clearance_m: f64,
    /// Duration of a turn, s.
    pub turn_s: f64,
    /// 4/(3 (h_i + h_j)) of eq. (9) over J Ω².
    contact_stiffness: f64,
    bearing_radius_m: f64,
}

impl SliderCrank {
    /// Reads the model of the case.
    ///
    /// # Panics
    /// If it is not there or another mechanism.
    pub fn read() -> Self {
        let (mechanism, values, turn_s) = compiled("slider_crank_5000");
        let quantities = &mechanism.model.quantities;
        let number = |path: &str| {
            let id = quantities.id(path).unwrap_or_else(|| panic!("the model has no {path}"));
            values[id]
        };
        let speed_rad_s = TAU / turn_s;
        let [crank_m, rod_m] = ["parameter.crank_length", "parameter.rod_length"].map(number);
        let [crank_kg, rod_kg, slider_kg] = ["body.crank.mass", "body.rod.mass", "body.slider.mass"].map(number);
        let [crank_centre_m, rod_centre_m] = ["body.crank.centre_of_mass.x", "body.rod.centre_of_mass.x"].map(number);
        let inertia_kg_m2 = number("body.rod.inertia") + rod_kg * rod_centre_m * rod_centre_m;
        let poisson = number("contact.steel_pin.poisson_ratio");
        let compliance_1_pa = (1.0 - poisson * poisson) / number("contact.steel_pin.youngs_modulus");
        let restitution = number("contact.steel_pin.restitution");
        Self {
            crank_m,
            rod_m,
            gravity_m: number("gravity") / (speed_rad_s * speed_rad_s),
            rod_over_inertia_1_m2: rod_kg * rod_centre_m / (rod_m * inertia_kg_m2),
            rod_1_m2: rod_kg / inertia_kg_m2,
            weight_at_pin_1_m2: (rod_kg + crank_kg * crank_centre_m / crank_m) / inertia_kg_m2,
            slider_over_inertia_1_m2: slider_kg / inertia_kg_m2,
            damping_factor: 0.75 * (1.0 - restitution * restitution),
            smallest_impact_m_rad: number("contact.steel_pin.minimum_impact_speed") / speed_rad_s,
            clearance_m: number("joint.gudgeon.radial_clearance"),
            turn_s,
            contact_stiffness: 4.0 / (3.0 * 2.0 * compliance_1_pa) / (inertia_kg_m2 * speed_rad_s * speed_rad_s),
            bearing_radius_m: number("joint.gudgeon.bearing_radius"),
        }
    }

    /// K of the contact law over J Ω²: two spheres, the bearing's radius held.
    pub fn stiffness(&self, clearance_m: f64) -> f64 {
        let journal_radius_m = self.bearing_radius_m - clearance_m;
        self.contact_stiffness * (self.bearing_radius_m * journal_radius_m / clearance_m).sqrt()
    }

    /// Clearance of run `index` of `runs`, m. One run alone has the nominal one.
    pub fn clearance_of_m(&self, index: usize, runs: usize) -> f64 {
        self.clearance_m * (1.0 + VARIATION * ((2 * index + 1) as f64 / runs as f64 - 1.0))
    }
}
