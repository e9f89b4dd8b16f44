//! The texts of a mechanism of which nothing is drawn yet: a ground, a cycle, and a study that asks nothing.

/// Text of the model. The first link that is drawn brings a motor, and the cycle then counts its turns.
pub fn blank_model(name: &str) -> String {
    let name = quoted(name);
    format!(
        "# Drawn in the studio. Values that the drawing does not give are marked as first guesses.\n\
         name = {name}\ngravity = \"9.81 m/s^2\"  # along -y; \"0 m/s^2\" for none\n\n[body.ground.points]\n\n\
         [cycle]\nduration = \"1 s\"\nsamples_per_turn = 180\n"
    )
}

/// Text of the study of it.
pub fn blank_study(name: &str) -> String {
    let name = quoted(name);
    format!(
        "# Accuracy with scattered lengths and with play in the joints. In the studio, click a length or a pin, and\n\
         # write ±0.1 mm or 0.05..0.2 mm.\n\
         name = {name}\nmodel = \"model.toml\"\nseed = 1\n\n[sampling]\nouter = 16\ninner = 256\n"
    )
}

fn quoted(name: &str) -> String {
    // A string of JSON is one of TOML.
    serde_json::to_string(name.trim()).unwrap_or_default()
}
