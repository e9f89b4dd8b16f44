//! Stress along a bar that turns about its end in a study, against the closed form of its root: σ = ρ ω² L²/2.

use super::efforts::conducted;

/// Of the bound: the rule over the points of the bar, the search of a response that is linear in the density.
const SHARE: f64 = 1e-6;
const SPEED_RAD_S: f64 = 100.0;
const LENGTH_M: f64 = 0.3;
const DENSITIES_KG_M3: [f64; 2] = [7000.0, 9000.0];

const MODEL: &str = r#"
name = "turning bar"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.bar]
points = { root = ["0 mm", "0 mm"], tip = ["300 mm", "0 mm"] }
[body.bar.beam]
from = "root"
to = "tip"
section = { width = "8 mm", height = "8 mm" }
youngs_modulus = "200 GPa"
density = "8000 kg/m^3"
frame = "tangent"
lateral_shapes = 1
axial_shapes = 0
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "bar.root"
[drive.motor]
joint = "main"
speed = "100 rad/s"
start_angle = "0 deg"
[cycle]
drive = "motor"
[output.stress]
stress_in = "bar"
unit = "MPa"
"#;

const STUDY: &str = r#"
name = "turning bar"
model = "model.toml"
[cycle]
transient_turns = 0
recorded_turns = 0.1
[sampling]
outer = 16
inner = 16
replicates = 4
[epistemic]
"body.bar.beam.density" = { interval = ["7000 kg/m^3", "9000 kg/m^3"] }
[[ask]]
output = "stress"
of = "value"
reduce = "maximum"
statistics = ["mean"]
[[ask]]
output = "stress"
of = "value"
reduce = "mean"
statistics = ["mean"]
"#;

#[test]
fn analytic_the_stress_of_each_run_is_that_of_its_own_bar() {
    let result = conducted(MODEL, STUDY);
    assert_eq!(result.bounds.len(), 2);
    for bound in &result.bounds {
        let found = [(bound.lower.value_si, DENSITIES_KG_M3[0]), (bound.upper.value_si, DENSITIES_KG_M3[1])];
        for (value_pa, density_kg_m3) in found {
            let stress_pa = 0.5 * density_kg_m3 * (SPEED_RAD_S * LENGTH_M).powi(2);
            assert!((value_pa / stress_pa - 1.0).abs() < SHARE, "{value_pa}, not {stress_pa}: {bound:?}");
        }
    }
}
