//! The foundation against closed forms and against its own energy.

use super::{Foundation, FoundationMotion, liu_foundation_pa_m, point_law_foundation_pa_m};
use crate::contact::{FrictionLaw, compliance_1_pa, cylinder_stiffness_n_m1_5};
use loosepin_math::Vec2;
use std::f64::consts::TAU;

const RADIUS_M: f64 = 0.01;
const CLEARANCE_M: f64 = 1e-4;
const LENGTH_M: f64 = 0.02;

fn steel(sectors: usize, damping_factor: f64) -> Foundation {
    let h = compliance_1_pa(207e9, 0.3);
    let stiffness_pa_m = liu_foundation_pa_m([h, h], RADIUS_M);
    Foundation::unworn([RADIUS_M, CLEARANCE_M, LENGTH_M], stiffness_pa_m, damping_factor, FrictionLaw::None, sectors)
}

impl Foundation {
    /// Resultant of the unworn joint at a penetration, without loss, N: the closed form over a continuous foundation.
    fn unworn_force_n(&self, penetration_m: f64) -> f64 {
        if !(penetration_m > 0.0) {
            return 0.0;
        }
        let eccentricity_m = self.clearance_m + penetration_m;
        let cosine = self.clearance_m / eccentricity_m;
        let sine = (penetration_m * (eccentricity_m + self.clearance_m)).sqrt() / eccentricity_m;
        let reach_rad = sine.atan2(cosine);
        let depth_m = eccentricity_m * (reach_rad + sine * cosine) - 2.0 * self.clearance_m * sine;
        self.stiffness_pa_m * self.bearing_radius_m * self.length_m * depth_m
    }
}

/// At rest, the journal off by `eccentricity_m` in the direction `angle_rad`.
fn at_rest(eccentricity_m: f64, angle_rad: f64) -> FoundationMotion {
    let (sine, cosine) = angle_rad.sin_cos();
    FoundationMotion {
        eccentricity_m: Vec2::new(eccentricity_m * cosine, eccentricity_m * sine),
        rate_m_s: Vec2::zero(),
        turn_rad: 0.3,
        spins_rad_s: [0.0; 2],
    }
}

/// A groove beside which the journal still touches, and a worn pin.
fn worn(foundation: &Foundation) -> Foundation {
    let sectors = foundation.sectors();
    let depth_m = |sector: usize, middle: f64, depth_m: f64| {
        let angle_rad = (sector as f64 + 0.5) * std::f64::consts::TAU / sectors as f64 - middle;
        depth_m * (-(angle_rad.sin() * angle_rad.sin()) / 0.08).exp()
    };
    let bearing: Vec<f64> = (0..sectors).map(|sector| depth_m(sector, 0.4, 3e-6)).collect();
    let journal: Vec<f64> = (0..sectors).map(|sector| depth_m(sector, 1.1, 2e-6)).collect();
    foundation.worn([&bearing, &journal])
}

#[test]
fn analytic_the_unworn_foundation() {
    let foundation = steel(720, 0.0);
    assert!((foundation.stiffness_pa_m / 6.699_618_949e12 - 1.0).abs() < 1e-9);
    // Penetration, resultant and sum of the sectors of a continuous foundation, in another program's digits; relative errors of sums
    // over 720 sectors.
    for (depth_m, resultant_n, sum_n, tolerance) in [
        (1e-6, 251.030_853, 251.529_213, 4e-4),
        (1e-5, 7_513.199_545, 7_653.082_815, 2e-5),
        (5e-5, 69_173.165_458, 74_222.483_754, 6e-6),
    ] {
        assert!((foundation.unworn_force_n(depth_m) / resultant_n - 1.0).abs() < 1e-9);
        let load = foundation.load(&at_rest(CLEARANCE_M + depth_m, 0.7), 0.0, &mut |_| {});
        assert!((load.on_journal_n.length() / resultant_n - 1.0).abs() < tolerance, "{depth_m}: {load:?}");
        assert!((load.sum_n / sum_n - 1.0).abs() < tolerance, "{depth_m}: {load:?}");
    }
    assert_eq!(foundation.load(&at_rest(CLEARANCE_M, 0.7), 0.0, &mut |_| {}).carrying, 0);
}

#[test]
fn identity_sums_over_sectors_converge_and_a_worn_joint_without_depth_is_the_unworn_one() {
    // The largest error over the directions: sums of midpoints of a function with a kink at both ends are of second order.
    let error = |sectors: usize| {
        let foundation = steel(sectors, 0.0);
        let of = |k: usize| {
            let own = at_rest(CLEARANCE_M + 2e-5, 0.01 * k as f64);
            foundation.load(&own, 0.0, &mut |_| {}).on_journal_n.length() / foundation.unworn_force_n(2e-5) - 1.0
        };
        (0..97).map(|k| of(k).abs()).fold(0.0, f64::max)
    };
    let errors = [45, 90, 180, 360].map(error);
    // Where the edge of the patch lies in its sector moves the error by a bounded factor: over a fourfold refinement second order
    // gives 16, first order 4.
    for k in [0, 1] {
        assert!(errors[k] > 8.0 * errors[k + 2], "{errors:?}");
    }
    let (foundation, none) = (steel(180, 0.0), [0.0; 180]);
    let again = foundation.worn([&none, &none]);
    let own = at_rest(CLEARANCE_M + 2e-5, 1.234);
    let [one, other] = [&foundation, &again].map(|of| of.load(&own, 0.0, &mut |_| {}).on_journal_n);
    assert_eq!(one, other);
}

#[test]
fn analytic_a_point_law_is_met_to_leading_order() {
    let h = compliance_1_pa(207e9, 0.3);
    let stiffness = cylinder_stiffness_n_m1_5([h, h], RADIUS_M, CLEARANCE_M);
    let stiffness_pa_m = point_law_foundation_pa_m(stiffness, CLEARANCE_M, RADIUS_M, LENGTH_M);
    let sizes_m = [RADIUS_M, CLEARANCE_M, LENGTH_M];
    let foundation = Foundation::unworn(sizes_m, stiffness_pa_m, 0.0, FrictionLaw::None, 360);
    // The next order is a share of δ/c.
    for depth_m in [1e-8, 1e-9] {
        let share = foundation.unworn_force_n(depth_m) / (stiffness * depth_m * depth_m.sqrt());
        assert!((share - 1.0).abs() < depth_m / CLEARANCE_M, "{depth_m}: {share}");
    }
}

#[test]
fn identity_force_and_couples_are_the_gradient_of_the_stored_energy() {
    let foundation = worn(&steel(360, 0.0));
    let own = at_rest(CLEARANCE_M + 9e-6, 0.45);
    let load = foundation.load(&own, 0.0, &mut |_| {});
    assert!(load.carrying > 20 && load.moments_n_m[1].abs() > 1e-4, "{load:?}");
    let stored_j = |dx: f64, dy: f64, turn: f64| {
        let mut moved = own;
        moved.eccentricity_m = own.eccentricity_m + Vec2::new(dx, dy);
        moved.turn_rad += turn;
        foundation.load(&moved, 0.0, &mut |_| {}).stored_j
    };
    let (step_m, step_rad) = (1e-10, 1e-7);
    let slopes = [
        (stored_j(step_m, 0.0, 0.0) - stored_j(-step_m, 0.0, 0.0)) / (2.0 * step_m),
        (stored_j(0.0, step_m, 0.0) - stored_j(0.0, -step_m, 0.0)) / (2.0 * step_m),
        // The journal turns against the bearing.
        (stored_j(0.0, 0.0, -step_rad) - stored_j(0.0, 0.0, step_rad)) / (2.0 * step_rad),
    ];
    let forces = [-load.on_journal_n.x, -load.on_journal_n.y, -load.moments_n_m[1]];
    for (slope, force) in slopes.iter().zip(forces) {
        assert!((slope / force - 1.0).abs() < 1e-6, "{slopes:?} {forces:?}");
    }
    // Angular momentum about P_i: the moments of both bodies and the force at P_j.
    let total = load.moments_n_m[0] + load.moments_n_m[1] + own.eccentricity_m.cross(load.on_journal_n);
    assert!(total.abs() < 1e-12 * own.eccentricity_m.length() * load.sum_n, "{total}");
}

#[test]
fn identity_rates_of_the_deepest_sector_are_its_differences() {
    let foundation = worn(&steel(360, 0.0));
    // A body frame that turns: e(t) in the ground's frame, angles by constant accelerations.
    let at = |time_s: f64| {
        let [theta_i, theta_j] = [0.2 + 31.0 * time_s + 900.0 * time_s * time_s, 0.5 - 17.0 * time_s];
        let e = Vec2::new(6e-5 + 0.11 * time_s, 8.6e-5 + 0.07 * time_s - 3.0 * time_s * time_s);
        let (rate, bent) = (Vec2::new(0.11, 0.07 - 6.0 * time_s), Vec2::new(0.0, -6.0));
        let (sine, cosine) = f64::sin_cos(theta_i);
        let own = FoundationMotion {
            eccentricity_m: e.rotated(-sine, cosine),
            rate_m_s: rate.rotated(-sine, cosine),
            turn_rad: theta_i - theta_j,
            spins_rad_s: [31.0 + 1800.0 * time_s, -17.0],
        };
        (own, bent.rotated(-sine, cosine))
    };
    let step_s = 1e-8;
    let deepest = |time_s: f64| foundation.deepest(&at(time_s).0);
    let [before, now, after] = [-step_s, 0.0, step_s].map(deepest);
    assert_eq!([before.normal, after.normal], [now.normal; 2]);
    let rate_m_s = (after.penetration_m - before.penetration_m) / (2.0 * step_s);
    assert!((rate_m_s / now.rate_m_s - 1.0).abs() < 1e-7, "{rate_m_s} {}", now.rate_m_s);
    let (own, acceleration) = at(0.0);
    let bent_m_s2 = foundation.penetration_acceleration_m_s2(&own, &now, acceleration, [1800.0, 0.0]);
    let difference_m_s2 = (after.rate_m_s - before.rate_m_s) / (2.0 * step_s);
    assert!((difference_m_s2 / bent_m_s2 - 1.0).abs() < 1e-5, "{difference_m_s2} {bent_m_s2}");
}

#[test]
fn identity_the_deepest_sector_and_the_load_are_those_of_all_sectors_one_by_one() {
    for sectors in [4, 7, 72, 360] {
        for foundation in [steel(sectors, 0.0), worn(&steel(sectors, 0.0))] {
            for k in 0..300 {
                // In flight and pressed, in all directions, turned by up to some turns to both sides.
                let mut own = at_rest(CLEARANCE_M * (0.9 + 0.0007 * k as f64), 0.31 * k as f64);
                own.turn_rad = 0.17 * (k as f64 - 150.0);
                let normal = |sector: usize| {
                    let (sine, cosine) = ((sector as f64 + 0.5) * TAU / sectors as f64).sin_cos();
                    Vec2::new(cosine, sine)
                };
                let gaps_m = foundation.gaps_m(own.turn_rad);
                let depth_m = |sector: usize| own.eccentricity_m.dot(normal(sector)) - gaps_m[sector];
                let stiffness_n_m = foundation.stiffness_pa_m * RADIUS_M * TAU / sectors as f64 * LENGTH_M;
                let (mut deepest_m, mut sum_n) = (f64::NEG_INFINITY, 0.0);
                for sector in 0..sectors {
                    deepest_m = deepest_m.max(depth_m(sector));
                    sum_n += stiffness_n_m * depth_m(sector).max(0.0);
                }
                let deepest = foundation.deepest(&own);
                assert!((deepest.penetration_m - deepest_m).abs() < 1e-18, "{sectors} {k}: {deepest:?} {deepest_m}");
                let place = deepest.normal.y.atan2(deepest.normal.x).rem_euclid(TAU) * sectors as f64 / TAU;
                assert!((depth_m(place as usize) - deepest_m).abs() < 1e-18, "{sectors} {k}: {deepest:?}");
                let whole = (own.turn_rad * sectors as f64 / TAU).floor() as i64;
                for sector in [0, sectors / 2, sectors - 1] {
                    let beside = [-1, 0, 1, 2].map(|m| (sector as i64 + whole + m).rem_euclid(sectors as i64) as usize);
                    assert_eq!(foundation.journal_weights(own.turn_rad).sectors(sector, sectors), beside);
                }
                let found_n = foundation.load(&own, 0.0, &mut |_| {}).sum_n;
                let round_off_n = 1e-18 * sectors as f64 * stiffness_n_m + 1e-12 * sum_n;
                assert!((found_n - sum_n).abs() < round_off_n, "{sectors} {k}: {found_n} {sum_n}");
            }
        }
    }
}

#[test]
fn identity_the_power_of_the_load_is_what_it_stores_and_loses() {
    let foundation = worn(&steel(360, 0.1425));
    let mut own = at_rest(CLEARANCE_M + 9e-6, 0.45);
    own.rate_m_s = Vec2::new(0.02, -0.013);
    own.spins_rad_s = [-11.0, 3.0];
    let load = foundation.load(&own, 8.0, &mut |_| {});
    // Stored energy after a moment: e moves in the axes of the bearing by ė - ω_i × e.
    let stored_j = |step_s: f64| {
        let mut moved = own;
        let carried = own.eccentricity_m.turned() * own.spins_rad_s[0];
        moved.eccentricity_m = own.eccentricity_m + (own.rate_m_s - carried) * step_s;
        moved.turn_rad += (own.spins_rad_s[0] - own.spins_rad_s[1]) * step_s;
        foundation.load(&moved, 0.0, &mut |_| {}).stored_j
    };
    let step_s = 1e-9;
    let stored_w = (stored_j(step_s) - stored_j(-step_s)) / (2.0 * step_s);
    let power_w = load.on_journal_n.dot(own.rate_m_s)
        + load.moments_n_m[0] * own.spins_rad_s[0]
        + load.moments_n_m[1] * own.spins_rad_s[1];
    let rest_w = power_w + stored_w + load.contact_loss_w;
    assert!(rest_w.abs() < 1e-6 * stored_w.abs().max(load.contact_loss_w), "{power_w} {stored_w} {load:?}");
}

#[test]
fn analytic_a_convexified_clearance() {
    let foundation = steel(360, 0.0);
    let [least_m, most_m] = foundation.effective_clearances_m(0.0);
    assert!((least_m / CLEARANCE_M - 1.0).abs() < 1e-12 && (most_m / CLEARANCE_M - 1.0).abs() < 1e-12);
    // A groove of 1° cannot be entered: the corners of the polygon beside it hold the pin, at c/cos 0.5°.
    let mut groove = vec![0.0; 360];
    groove[90] = 5e-6;
    let none = vec![0.0; 360];
    let [least_m, most_m] = foundation.worn([&groove, &none]).effective_clearances_m(0.0);
    assert!((least_m / CLEARANCE_M - 1.0).abs() < 1e-12, "{least_m}");
    assert!(most_m < CLEARANCE_M * 1.002 && most_m > CLEARANCE_M * 1.000_1, "{most_m}");
}

#[test]
fn analytic_two_narrow_worn_arcs_meet_at_one_angle_of_the_bearing() {
    // 20° of each surface, 0.7 µm deep: wide enough for the pin, since c/cos 9° is above c + 1.4 µm. They meet 22° apart.
    let depth_m = 0.7e-6;
    let arc = |middle: usize| {
        let mut depths_m = vec![0.0; 360];
        depths_m[middle - 10..middle + 10].fill(depth_m);
        depths_m
    };
    let foundation = steel(360, 0.0).worn([&arc(100), &arc(122)]);
    let met_rad = 22_f64.to_radians();
    let whole = [-7.0, 7.0];
    for (turns_rad, depths) in [
        (whole, 2.0),
        ([0.0, 0.4], 2.0),
        ([0.1 + TAU, 0.5 + TAU], 2.0),
        ([0.0, 0.01], 1.0),
        ([met_rad, met_rad], 2.0),
        ([f64::INFINITY, f64::NEG_INFINITY], 1.0),
    ] {
        let [least_m, most_m] = foundation.clearances_within_m(turns_rad);
        let expected_m = CLEARANCE_M + depths * depth_m;
        assert!((most_m - expected_m).abs() < 1e-14, "{turns_rad:?}: {most_m} {expected_m}");
        assert!((least_m - CLEARANCE_M).abs() < 1e-14, "{turns_rad:?}: {least_m}");
    }
}
