//! The equations of motion of this one mechanism, with the root of the penetration as an unknown.
//!
//! The time is the angle of the crank; A = r (cos θ, sin θ) is its pin and B = l (cos φ, sin φ) the rod. The journal stands at
//! (x, 0), the bearing at A + B, so e = (x - A_x - B_x, -(A_y + B_y)). With u = √δ, dt = u dσ and p = 1/(c + u²) = 1/|e|:
//!
//!     G = K u³ (1 + χ δ̇/v0) p             force over |e|, over J Ω²
//!     ω̇ = c1 ((A_y - γ) B_x - A_x B_y) - G (n B_x + e_x B_y),   n = A_y + B_y
//!     v̇ = -(J/m) G e_x
//!     δ̇ = e·ė p,   du/dσ = δ̇/2
//!
//! and everything else times u. In flight K = 0, u = 1 and stays: no branch.
//!
//! Written for few operations: A and B are unknowns themselves, which costs their sums over the stages and spares sines, cosines and
//! angles. |e| is c + u², which the equations keep as exactly as the integration is, so that no root and one reciprocal are needed.

use crate::model::SliderCrank;
use crate::vector::Lanes;

/// Places in a state: crank pin and rod vector, m.
pub const CRANK: [usize; 2] = [0, 1];
/// Rod vector, m.
pub const ROD: [usize; 2] = [2, 3];
/// Position of the slider, m.
pub const SLIDER: usize = 4;
/// Angular velocity of the rod over the crank's.
pub const TURNING: usize = 5;
/// Velocity of the slider, m/rad.
pub const SPEED: usize = 6;
/// √δ in contact, 1 in flight.
pub const ROOT: usize = 7;
/// Unknowns of the equations.
pub const UNKNOWNS: usize = 8;
/// Angle of the crank, rad: an integral, since the equations have A.
pub const TIME: usize = 8;
/// Work of the drive.
pub const SUPPLIED: usize = 9;
/// Energy lost in contact.
pub const LOST: usize = 10;
/// Unknowns and integrals.
pub const LENGTH: usize = 11;

/// Unknowns and integrals of each run, or their derivatives.
pub type State<const G: usize> = [Lanes<G>; LENGTH];

/// An array with an entry for each unknown.
macro_rules! each_unknown {
    ($index:ident => $entry:expr) => {
        [
            {
                const $index: usize = 0;
                $entry
            },
            {
                const $index: usize = 1;
                $entry
            },
            {
                const $index: usize = 2;
                $entry
            },
            {
                const $index: usize = 3;
                $entry
            },
            {
                const $index: usize = 4;
                $entry
            },
            {
                const $index: usize = 5;
                $entry
            },
            {
                const $index: usize = 6;
                $entry
            },
            {
                const $index: usize = 7;
                $entry
            },
        ]
    };
}
pub(crate) use each_unknown;

/// Contact of each run.
#[derive(Clone, Copy)]
pub struct Contact<const G: usize> {
    /// Radial clearance, m.
    pub clearance_m: Lanes<G>,
    /// K over J Ω²; 0 in flight.
    pub stiffness: Lanes<G>,
    /// χ/v0, rad/m.
    pub damping: Lanes<G>,
    /// ½ in contact, 0 in flight.
    pub half: Lanes<G>,
}

/// Eccentricity (e_x, -n) and its velocity (v_x, -v_n).
#[derive(Clone, Copy)]
pub struct Eccentricity<const G: usize> {
    /// e_x, m.
    pub x: Lanes<G>,
    /// n, m.
    pub n: Lanes<G>,
    /// Its rate, m/rad.
    pub vx: Lanes<G>,
    /// Its rate, m/rad.
    pub vn: Lanes<G>,
    /// e·ė, m²/rad.
    pub product: Lanes<G>,
}

/// Eccentricity in a state.
#[target_feature(enable = "avx512f")]
#[inline]
pub fn eccentricity<const G: usize>(y: &[Lanes<G>; UNKNOWNS]) -> Eccentricity<G> {
    let [ax, ay, bx, by, slider, turning, speed, _] = *y;
    let x = slider.minus(ax).minus(bx);
    let n = ay.plus(by);
    let vx = turning.times_plus(by, speed.plus(ay));
    let vn = turning.times_plus(bx, ax);
    Eccentricity { x, n, vx, vn, product: x.times_plus(vx, n.times(vn)) }
}

/// Derivatives over σ times `step`, which `contact` has in its stiffness and its half.
#[target_feature(enable = "avx512f")]
#[inline]
pub fn derivative<const G: usize, const ACCOUNT: bool>(
    model: &SliderCrank,
    contact: &Contact<G>,
    step: Lanes<G>,
    y: &[Lanes<G>; UNKNOWNS],
    e: &Eccentricity<G>,
    slope: &mut State<G>,
) {
    let [ax, ay, bx, by, _, turning, speed, root] = *y;
    let pace = step.times(root);
    let depth_m = root.times(root);
    let inverse_1_m = contact.clearance_m.plus(depth_m).one_over();
    let rate = e.product.times(inverse_1_m);
    let elastic = contact.stiffness.times(depth_m.times(depth_m));
    let damped = contact.damping.times(rate);
    let force = elastic.times_plus(damped, elastic).times(inverse_1_m);

    let cross = ay.times(bx).minus_product(ax, by);
    let moment = Lanes::all(model.rod_over_inertia_1_m2).times(bx.times_from(Lanes::all(model.gravity_m), cross));
    let arm = e.n.times_plus(bx, e.x.times(by));
    let turning_rate = force.times_from(arm, pace.times(moment));
    let speed_rate = force.times(Lanes::all(-1.0 / model.slider_over_inertia_1_m2)).times(e.x);

    let turned = pace.times(turning);
    slope[TIME] = pace;
    slope[CRANK[0]] = pace.negated_times(ay);
    slope[CRANK[1]] = pace.times(ax);
    slope[ROD[0]] = turned.negated_times(by);
    slope[ROD[1]] = turned.times(bx);
    slope[SLIDER] = pace.times(speed);
    slope[TURNING] = turning_rate;
    slope[SPEED] = speed_rate;
    slope[ROOT] = contact.half.times(rate);
    if ACCOUNT {
        // The force of the crank on the rod times its pin's velocity (-A_y, A_x), and the crank's weight.
        let inner = ax.times_plus(bx, ay.times(by));
        let bent = turning_rate.times_plus(inner, turned.times(turning).times(cross));
        let weight = pace.times(ax).times(Lanes::all(model.weight_at_pin_1_m2 * model.gravity_m));
        let pushed = e.x.times_plus(ay, e.n.times(ax));
        let inertial = bent.times_plus(Lanes::all(model.rod_over_inertia_1_m2), weight);
        slope[SUPPLIED] = force.times_plus(pushed, inertial);
        slope[LOST] = elastic.times(damped).times(rate);
    }
}

/// Half of |e|² - c² and its first two derivatives over the time, in flight.
#[target_feature(enable = "avx512f")]
#[inline]
pub fn gap_m2<const G: usize>(
    contact: &Contact<G>,
    y: &[Lanes<G>; UNKNOWNS],
    e: &Eccentricity<G>,
    turning_rate: Lanes<G>,
) -> [Lanes<G>; 3] {
    let [ax, ay, bx, by, _, turning, _, _] = *y;
    let squared = e.x.times_plus(e.x, e.n.times(e.n));
    let clear = contact.clearance_m.times_from(contact.clearance_m, squared);
    let square = turning.times(turning);
    let bent_x = square.times_plus(bx, turning_rate.times_plus(by, ax));
    let bent_n = square.times_from(by, turning_rate.times_plus(bx, ay.times(Lanes::all(-1.0))));
    let moving = e.vx.times_plus(e.vx, e.vn.times(e.vn));
    let second = e.x.times_plus(bent_x, e.n.times_plus(bent_n, moving));
    [clear.times(Lanes::all(0.5)), e.product, second]
}

/// Kinetic energy of rod and slider, and all of the mechanism but the crank's kinetic energy, over J Ω².
#[target_feature(enable = "avx512f")]
#[inline]
pub fn energy<const G: usize>(model: &SliderCrank, contact: &Contact<G>, y: &[Lanes<G>; UNKNOWNS]) -> [Lanes<G>; 2] {
    let [ax, ay, bx, by, _, turning, speed, root] = *y;
    let crank_m = model.crank_m;
    let inner = ax.times_plus(bx, ay.times(by));
    let share = Lanes::all(model.rod_over_inertia_1_m2);
    let rod = turning.times(inner.times_plus(share, turning.times(Lanes::all(0.5))));
    let slider = speed.times(speed).times(Lanes::all(0.5 * model.slider_over_inertia_1_m2));
    let pin = Lanes::all(0.5 * model.rod_1_m2 * crank_m * crank_m);
    let kinetic = rod.plus(slider).plus(pin);
    let pin_height = ay.times(Lanes::all(model.weight_at_pin_1_m2));
    let height = by.times_plus(share, pin_height);
    let depth_m = root.times(root);
    let stored = contact.stiffness.times(depth_m.times(depth_m)).times(root).times(Lanes::all(0.4));
    [kinetic, height.times_plus(Lanes::all(model.gravity_m), kinetic.plus(stored))]
}
