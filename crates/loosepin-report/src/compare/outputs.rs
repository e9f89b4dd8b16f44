//! Which outputs of two studies are the same.

use loosepin_result::study::{OutputDescription, StudyResult};

/// The outputs that both studies have.
pub struct SharedOutputs {
    names: Vec<String>,
    /// Outputs that are not compared, with the reasons.
    pub left_out: Vec<String>,
}

impl SharedOutputs {
    /// Whether numbers of this output may be compared.
    pub fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }
}

/// The outputs of one name that are one number in one unit.
pub fn shared([before, after]: [&StudyResult; 2]) -> SharedOutputs {
    let mut shared = SharedOutputs { names: Vec::new(), left_out: Vec::new() };
    for output in &before.outputs {
        let name = &output.name;
        match after.outputs.iter().find(|other| other.name == *name) {
            None => shared.left_out.push(format!("Output '{name}' is only in A.")),
            Some(other) if is_same(output, other) => shared.names.push(name.clone()),
            Some(other) => shared.left_out.push(format!(
                "Output '{name}' is not the same in both: {} in A, {} in B.",
                meaning(output),
                meaning(other)
            )),
        }
    }
    let is_new = |output: &&OutputDescription| before.outputs.iter().all(|own| own.name != output.name);
    let only_after = after.outputs.iter().filter(is_new);
    shared.left_out.extend(only_after.map(|output| format!("Output '{}' is only in B.", output.name)));
    shared
}

fn is_same(before: &OutputDescription, after: &OutputDescription) -> bool {
    before.words == after.words && before.unit == after.unit && before.path == after.path
}

fn meaning(output: &OutputDescription) -> String {
    format!("{} [{}]", output.words, output.unit.symbol())
}
