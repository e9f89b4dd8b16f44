//! The texts of a mechanism of which nothing is drawn yet: a ground, a cycle, and a study that asks nothing.

/// The model. The first link that is drawn brings a motor, and the cycle then counts its turns.
pub const BLANK_MODEL: &str = "\
# Drawn in the studio. Values that the drawing does not give are marked as first guesses.
name = \"Drawn mechanism\"
gravity = \"9.81 m/s^2\"  # along -y; \"0 m/s^2\" for none

[body.ground.points]

[cycle]
duration = \"1 s\"
samples_per_turn = 180
";

/// The study of it.
pub const BLANK_STUDY: &str = "\
# Accuracy with scattered lengths and with play in the joints. In the studio, click a length or a pin, and
# write ±0.1 mm or 0.05..0.2 mm.
name = \"Drawn mechanism\"
model = \"model.toml\"
seed = 1

[sampling]
outer = 16
inner = 256
";
