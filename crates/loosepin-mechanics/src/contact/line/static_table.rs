//! The static forces of the line-contact laws against inversions that know nothing of theirs.

use super::{LINE_LAWS, LineLaw, LinePair};
use crate::contact::{NormalContact, NormalLaw, PlayState, PointContact, compliance_1_pa, cylinder_stiffness_n_m1_5};

const GIGAPASCAL: f64 = 1e9;

/// The steel pin of the table below: R_i = 10 mm, R_j = 9.5 mm, L = 20 mm.
fn steel_pair() -> LinePair {
    let h = compliance_1_pa(207.0 * GIGAPASCAL, 0.3);
    LinePair { bearing_radius_m: 10e-3, clearance_m: 0.5e-3, length_m: 20e-3, compliances_1_pa: [h, h] }
}

/// Other pairs, with other materials, radii, clearances and lengths.
fn other_pairs() -> [LinePair; 3] {
    let pair = |radius_mm: f64, clearance_mm: f64, length_mm: f64, moduli: [f64; 2]| LinePair {
        bearing_radius_m: radius_mm * 1e-3,
        clearance_m: clearance_mm * 1e-3,
        length_m: length_mm * 1e-3,
        compliances_1_pa: [
            compliance_1_pa(moduli[0] * GIGAPASCAL, 0.34),
            compliance_1_pa(moduli[1] * GIGAPASCAL, 0.27),
        ],
    };
    [pair(25.0, 0.02, 41.0, [110.0, 207.0]), pair(6.3, 0.31, 7.9, [71.0, 198.0]), pair(41.0, 0.9, 33.0, [3.1, 210.0])]
}

fn elastic_n(law: &NormalLaw<f64>, depth_m: f64) -> f64 {
    law.force(depth_m, 0.0, &PlayState::flight()).elastic_n
}

/// The larger root of the two numbers between `low` and `high` where the rising `f` reaches `value`, to the last place.
pub(in crate::contact) fn bisected(value: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, high);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if f(middle) < value { low = middle } else { high = middle }
    }
}

/// Asserts the force of `law` in kN at δ = 1, 10 and 50 µm for the steel pair, and for the other pairs that `penetration_m`, the
/// law as printed in its paper as a function δ of F, gives back the δ that the force was asked at.
pub(super) fn assert_static_forces(
    law: &LineLaw,
    expected_kn: [f64; 3],
    penetration_m: impl Fn(&LinePair, f64) -> f64,
) {
    /// The table has four or five digits.
    const TABLE_DIGIT: f64 = 6e-5;
    /// Round-off of both directions: forwards δ(F) loses digits in its logarithms where F is small.
    const ROUND_OFF: f64 = 2e-14;
    let contact = (law.contact)(&steel_pair(), 0.3);
    for (depth_m, expected_kn) in [1e-6, 10e-6, 50e-6].into_iter().zip(expected_kn) {
        let force_kn = elastic_n(&contact, depth_m) / 1e3;
        let off = (force_kn / expected_kn - 1.0).abs();
        // The first column is printed with four digits.
        assert!(off < TABLE_DIGIT * if depth_m < 2e-6 { 10.0 } else { 1.0 }, "{}: {force_kn} kN", law.name);
    }
    for pair in other_pairs() {
        let contact = (law.contact)(&pair, 0.3);
        let limit_m = contact.limit_m().unwrap_or(pair.bearing_radius_m);
        let mut depth_m = 1e-12;
        while depth_m < 0.9999 * limit_m {
            let back_m = penetration_m(&pair, elastic_n(&contact, depth_m));
            assert!((back_m / depth_m - 1.0).abs() < ROUND_OFF, "{}: {depth_m} {back_m}", law.name);
            depth_m *= 1.7;
        }
    }
}

#[test]
fn analytic_lankarani_and_nikravesh_in_the_same_table() {
    let pair = steel_pair();
    let stiffness_n_m_n = cylinder_stiffness_n_m1_5(pair.compliances_1_pa, pair.bearing_radius_m, pair.clearance_m);
    let contact = NormalLaw::from(PointContact { stiffness_n_m_n, exponent: 1.5, damping_factor: 0.3 });
    for (depth_m, expected_kn) in [(1e-6, 0.0661), (10e-6, 2.0903), (50e-6, 23.371)] {
        assert!((elastic_n(&contact, depth_m) / 1e3 / expected_kn - 1.0).abs() < 5e-4);
    }
}

#[test]
fn identity_forces_of_line_laws_grow_from_zero_and_are_finite_beyond_their_limits() {
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.0, effective_mass_kg: 0.3 };
    for law in LINE_LAWS {
        for pair in other_pairs() {
            let contact = (law.contact)(&pair, 0.3);
            for depth_m in [-1e-3, -1e-9, -0.0, 0.0] {
                let force = contact.force(depth_m, 0.7, &state);
                assert_eq!((force.total_n, force.elastic_n), (0.0, 0.0), "{} at {depth_m} m", law.name);
                assert_eq!(contact.stored_energy_j(depth_m), 0.0, "{}", law.name);
            }
            let (mut depth_m, mut before_n) = (1e-15, 0.0);
            while depth_m < 10.0 * pair.bearing_radius_m {
                let force = contact.force(depth_m, 0.7, &state);
                assert!(force.elastic_n > before_n && force.total_n.is_finite(), "{} at {depth_m} m", law.name);
                // One rounding each.
                assert!((force.total_n / (force.elastic_n * (1.0 + 0.3 * 0.7 * 2.0)) - 1.0).abs() < 1e-15);
                assert!(contact.largest_force_n(depth_m, 0.7, &state) >= force.total_n * (1.0 - 1e-15));
                assert_eq!(contact.force(depth_m, -9.0, &state).total_n, 0.0, "a law that would pull is cut");
                (before_n, depth_m) = (force.elastic_n, depth_m * 1.3);
            }
        }
    }
}

#[test]
fn identity_the_elastic_force_of_line_laws_is_the_slope_of_the_stored_energy() {
    for law in LINE_LAWS {
        for pair in other_pairs() {
            let contact = (law.contact)(&pair, 0.3);
            let limit_m = contact.limit_m().unwrap_or(pair.bearing_radius_m);
            for share in [1e-5, 1e-3, 0.02, 0.2, 0.5, 0.9] {
                let depth_m = share * limit_m;
                // Differences of two steps, whose error is of the fourth order in the step.
                let slope = |step_m: f64| {
                    (contact.stored_energy_j(depth_m + step_m) - contact.stored_energy_j(depth_m - step_m))
                        / (2.0 * step_m)
                };
                let (fine_n, coarse_n) = (slope(1e-3 * depth_m), slope(2e-3 * depth_m));
                let slope_n = (4.0 * fine_n - coarse_n) / 3.0;
                let force_n = elastic_n(&contact, depth_m);
                // The error of the differences grows where the slope of a logarithmic law grows, at its limit.
                assert!((slope_n / force_n - 1.0).abs() < 1e-9, "{} at {depth_m} m: {slope_n} {force_n}", law.name);
            }
        }
    }
}

#[test]
fn identity_force_at_a_root_is_the_force() {
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.0, effective_mass_kg: 0.3 };
    for law in LINE_LAWS {
        let contact = (law.contact)(&steel_pair(), 0.3);
        let (force, at_root) =
            (contact.force(4e-6, -0.1, &state).total_n, contact.force_at_root(2e-3, -0.1, &state).total_n);
        // Two or three roundings.
        assert!((force / at_root - 1.0).abs() < 1e-15, "{}: {force} {at_root}", law.name);
    }
}
