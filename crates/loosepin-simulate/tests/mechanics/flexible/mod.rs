//! Mechanisms with flexible links: against histories of another program, energy, momenta, and other trees of the same mechanism.

mod histories;
mod laws;
mod refusals;
mod trees;

/// The text of the model of a folder of `cases`.
fn case_text(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join("model.toml");
    std::fs::read_to_string(path).expect("the case is there")
}
