//! Natural frequencies against closed forms and published roots.

use super::rectangular;
use crate::{Beam, Frame, Shapes};
use std::f64::consts::{PI, TAU};

/// The steel rods of three known mechanisms: their beam, Euler load, and lateral frequencies between two pins.
fn rods() -> [(Beam<f64>, f64, [f64; 3]); 3] {
    let (area, second_moment) = (PI * 4e-3_f64.powi(2), PI * 4e-3_f64.powi(4) / 4.0);
    let round = Beam {
        length_m: 0.12,
        mass_kg: 7800.0 * area * 0.12,
        axial_stiffness_n_m: 207e9 * area / 0.12,
        bending_stiffness_n_m: 207e9 * second_moment / 0.12,
        damping_ratio: 0.0,
        foreshortening: true,
    };
    [
        (round, 28525.8, [1123.894, 4495.575, 10115.04]),
        (rectangular([200e9, 7870.0, 0.3, 8e-3, 8e-3]), 7486.28, [203.1910, 812.7638, 1828.719]),
        (rectangular([207e9, 7800.0, 0.26, 20e-3, 5e-3]), 6296.25, [172.7788, 691.1152, 1555.009]),
    ]
}

#[test]
fn analytic_rods_between_two_pins() {
    for (beam, euler_n, known_hz) in rods() {
        assert!((beam.euler_load_n() / euler_n - 1.0).abs() < 2e-6, "{}", beam.euler_load_n());
        let [_, lateral] = beam.frequencies_hz(&Shapes::new(Frame::Secant, 2, 3));
        for (i, (found, known)) in lateral.iter().zip(known_hz).enumerate() {
            assert!((found / known - 1.0).abs() < 1e-6, "{found} for {known}");
            let exact = (i as f64 + 1.0).powi(2) * PI / 2.0
                * (beam.bending_stiffness_n_m / (beam.mass_kg * beam.length_m.powi(2))).sqrt();
            assert!((found / exact - 1.0).abs() < 1e-12, "{found} for {exact}");
        }
        // Axial: one end free, √(E/ρ)/(4 L), from above.
        let exact = (beam.axial_stiffness_n_m / beam.mass_kg).sqrt() / 4.0;
        let [axial, _] = beam.frequencies_hz(&Shapes::new(Frame::Secant, 8, 1));
        assert!((0.0..2e-4).contains(&(axial[0] / exact - 1.0)), "{} for {exact}", axial[0]);
    }
}

#[test]
fn published_frequencies_of_two_and_two_shapes() {
    // A run of another program with these shapes; exact axial frequencies are 4200.939 and 12602.8 Hz.
    let (beam, ..) = rods()[1];
    let [axial, lateral] = beam.frequencies_hz(&Shapes::new(Frame::Secant, 2, 2));
    let found = [lateral[0], lateral[1], axial[0], axial[1]];
    for (found, known) in found.iter().zip([203.190951, 812.763804, 4219.697902, 14729.864297]) {
        assert!((found - known).abs() < 1e-6, "{found} for {known}");
    }
}

#[test]
fn published_frequencies_of_a_clamped_and_free_beam() {
    let (beam, ..) = rods()[1];
    let [_, lateral] = beam.frequencies_hz(&Shapes::new(Frame::Tangent, 0, 4));
    let unit = (beam.bending_stiffness_n_m / beam.mass_kg).sqrt() / beam.length_m / TAU;
    for (found, root) in lateral.iter().zip([1.875104069, 4.694091133, 7.854757438, 10.995540735_f64]) {
        assert!((found / (root * root * unit) - 1.0).abs() < 1e-9, "{found} for root {root}");
    }
}
