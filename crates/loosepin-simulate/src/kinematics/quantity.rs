//! Quantities of a state with their exact rates.

use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::IdealMotion;

/// A number that follows from poses, with its time derivative.
pub trait Quantity {
    /// Its value, SI.
    fn value(&self, state: &IdealMotion<'_>) -> f64;
    /// Its time derivative, SI.
    fn rate(&self, state: &IdealMotion<'_>) -> f64;
}

/// Angle from one body to another, rad.
pub struct Angle {
    /// Slot of the body that it is measured from.
    pub first: usize,
    /// Slot of the other.
    pub second: usize,
    /// Added to it.
    pub offset_rad: f64,
}

impl Quantity for Angle {
    fn value(&self, state: &IdealMotion<'_>) -> f64 {
        let poses = &state.kinematics().poses;
        poses[self.second].angle_rad() - poses[self.first].angle_rad() + self.offset_rad
    }

    fn rate(&self, state: &IdealMotion<'_>) -> f64 {
        let twists = &state.kinematics().twists;
        twists[self.second].angular - twists[self.first].angular
    }
}

/// Travel of a slider along its guide, m.
pub struct Travel {
    /// Slot of the guide's body.
    pub guide: usize,
    /// Slot of the slider.
    pub slider: usize,
    /// Point of the guide in its body.
    pub guide_m: Vec2<f64>,
    /// Point of the slider in its body.
    pub slider_m: Vec2<f64>,
    /// Direction of the guide in its body.
    pub angle_rad: f64,
}

impl Travel {
    fn direction(&self, state: &IdealMotion<'_>) -> Vec2<f64> {
        let angle_rad = state.kinematics().poses[self.guide].angle_rad() + self.angle_rad;
        Vec2::new(angle_rad.cos(), angle_rad.sin())
    }
}

impl Quantity for Travel {
    fn value(&self, state: &IdealMotion<'_>) -> f64 {
        let poses = &state.kinematics().poses;
        let apart_m = poses[self.slider].point_m(self.slider_m) - poses[self.guide].point_m(self.guide_m);
        apart_m.dot(self.direction(state))
    }

    fn rate(&self, state: &IdealMotion<'_>) -> f64 {
        let (poses, twists) = (&state.kinematics().poses, &state.kinematics().twists);
        let at_m = poses[self.slider].point_m(self.slider_m);
        // Velocity against the point of the guide's body that lies at the same place.
        let [slider, guide] = [self.slider, self.guide].map(|slot| twists[slot].at(at_m - poses[slot].position_m));
        (slider - guide).dot(self.direction(state))
    }
}
