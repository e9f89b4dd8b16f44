use super::{Class, Fit, FitError};

/// Limits of a hole or a shaft, µm.
fn limits_um(class: &str, diameter_mm: f64) -> [f64; 2] {
    let is_hole = class.starts_with(|letter: char| letter.is_ascii_uppercase());
    let class = Class::parse(class, is_hole).unwrap();
    if is_hole { class.hole_um(diameter_mm).unwrap() } else { class.shaft_um(diameter_mm) }
}

#[test]
fn published_limits_of_iso_286_2() {
    // ISO 286-2:1988/2010, tables of limit deviations, at sizes within and at the ends of the ranges; E8, f9 and h9 at 100 to 300
    // mm as put right by Technical Corrigendum 1 (2006).
    for (class, diameter_mm, [lower, upper]) in [
        ("H7", 20.0, [0.0, 21.0]),
        ("g6", 20.0, [-20.0, -7.0]),
        ("H8", 25.0, [0.0, 33.0]),
        ("f7", 25.0, [-41.0, -20.0]),
        ("H7", 50.0, [0.0, 25.0]),
        ("k6", 50.0, [2.0, 18.0]),
        ("p6", 50.0, [26.0, 42.0]),
        ("n6", 50.0, [17.0, 33.0]),
        ("s6", 100.0, [71.0, 93.0]),
        ("s6", 60.0, [53.0, 72.0]),
        ("s6", 70.0, [59.0, 78.0]),
        ("r6", 25.0, [28.0, 41.0]),
        ("F8", 40.0, [25.0, 64.0]),
        ("G7", 20.0, [7.0, 28.0]),
        ("E9", 30.0, [40.0, 92.0]),
        ("D10", 20.0, [65.0, 149.0]),
        ("d9", 60.0, [-174.0, -100.0]),
        ("e8", 40.0, [-89.0, -50.0]),
        ("h9", 10.0, [-36.0, 0.0]),
        ("H11", 100.0, [0.0, 220.0]),
        ("js6", 30.0, [-6.5, 6.5]),
        ("JS7", 50.0, [-12.5, 12.5]),
        ("K7", 20.0, [-15.0, 6.0]),
        ("K6", 20.0, [-11.0, 2.0]),
        ("M7", 30.0, [-21.0, 0.0]),
        ("M6", 280.0, [-41.0, -9.0]),
        ("N7", 25.0, [-28.0, -7.0]),
        ("N9", 25.0, [-52.0, 0.0]),
        ("N9", 3.0, [-29.0, -4.0]),
        ("P7", 50.0, [-42.0, -17.0]),
        ("P9", 10.0, [-51.0, -15.0]),
        ("E8", 100.0, [72.0, 126.0]),
        ("f9", 300.0, [-186.0, -56.0]),
    ] {
        assert_eq!(limits_um(class, diameter_mm), [lower, upper], "{class} at {diameter_mm} mm");
    }
}

#[test]
fn identity_a_hole_in_the_basic_hole_system_fits_as_in_the_basic_shaft_system() {
    // The rule behind Δ: H7/p6 and P7/h6 have the same limits of clearance, above 3 mm (M at 250 to 315 mm is an exception).
    for diameter_mm in [5.0, 8.0, 14.0, 22.0, 45.0, 66.0, 110.0, 170.0, 240.0, 330.0, 480.0] {
        for (hole_letter, shaft_letter, grade) in
            [("K", "k", 7), ("M", "m", 7), ("N", "n", 8), ("P", "p", 7), ("K", "k", 6)]
        {
            let finer = grade - 1;
            let shaft_based = [
                limits_um(&format!("{hole_letter}{grade}"), diameter_mm),
                limits_um(&format!("h{finer}"), diameter_mm),
            ];
            let hole_based = [
                limits_um(&format!("H{grade}"), diameter_mm),
                limits_um(&format!("{shaft_letter}{finer}"), diameter_mm),
            ];
            let clearance = |[hole, shaft]: [[f64; 2]; 2]| [hole[0] - shaft[1], hole[1] - shaft[0]];
            assert_eq!(clearance(shaft_based), clearance(hole_based), "{hole_letter}{grade} at {diameter_mm} mm");
        }
    }
}

#[test]
fn analytic_tolerances_follow_the_formula_of_the_standard() {
    // i = 0.45 D^(1/3) + 0.001 D µm, D the geometric mean of the range in mm; IT6 = 10 i, IT7 = 16 i, ...; the table is rounded by
    // rules of its own: to whole micrometres, 9 % of the 7 µm of IT6 at 6 mm.
    const ROUNDING: f64 = 0.1;
    let ends = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0_f64];
    for (range, pair) in ends.windows(2).enumerate() {
        let mean = (pair[0] * pair[1]).sqrt();
        let unit = 0.45 * mean.cbrt() + 0.001 * mean;
        for (grade, factor) in
            [(6, 10.0), (7, 16.0), (8, 25.0), (9, 40.0), (10, 64.0), (11, 100.0), (12, 160.0), (13, 250.0)]
        {
            let found = super::tolerance_um(grade, range + 1);
            assert!((found / (factor * unit) - 1.0).abs() < ROUNDING, "IT{grade} at {} mm: {found}", pair[1]);
        }
    }
}

#[test]
fn published_radial_clearance_of_a_running_fit() {
    const ROUND_OFF: f64 = 1e-18; // m
    let limits = Fit::parse("H7/g6").unwrap().limits(0.02).unwrap();
    let [least, most] = limits.radial_clearance_m();
    assert!((least - 3.5e-6).abs() < ROUND_OFF && (most - 20.5e-6).abs() < ROUND_OFF, "{least} {most}");
    assert!(Fit::parse("H7/s6").unwrap().limits(0.02).unwrap().radial_clearance_m()[1] < 0.0);
}

#[test]
fn what_is_no_fit_is_refused() {
    let text = |fit: &str| Fit::parse(fit).unwrap_err().to_string();
    for fit in ["H7", "g6/H7", "H/g6", "H7/g", "h7/g6", "/", "H7/g6/h5", "7H/g6", "Ä7/g6"] {
        assert_eq!(text(fit), format!("'{fit}' is no fit"));
    }
    assert_eq!(text("C11/h11"), "'C11': the hole letters known here are D E F G H JS K M N P");
    assert_eq!(text("H7/z6"), "'z6': the shaft letters known here are d e f g h js k m n p r s");
    assert_eq!(text("H14/h9"), "'H14': the grade must be 3 to 13");
    assert_eq!(text("H7/g2"), "'g2': the grade must be 3 to 13");
    let limits = |fit: &str, diameter_m| Fit::parse(fit).unwrap().limits(diameter_m).unwrap_err();
    assert_eq!(limits("H7/g6", 0.6), FitError::Size { diameter_mm: 600.0 });
    assert_eq!(limits("H7/g6", 0.0), FitError::Size { diameter_mm: 0.0 });
    assert_eq!(limits("K9/h8", 0.02).to_string(), "'K9': the standard has K for grades up to 8 only");
}
