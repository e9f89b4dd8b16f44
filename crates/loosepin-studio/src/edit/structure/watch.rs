//! Recording of a mechanism: the output that the page asks for, as entries of the model and a question of the study.

use super::edit::Watched;

/// A name for an output that people would give it, and its entries.
pub fn output(what: &Watched) -> (String, Vec<(&'static str, String)>) {
    let quoted = |text: &str| format!("\"{text}\"");
    match what {
        Watched::Path { body, point } => (point.clone(), vec![("path_of", quoted(&format!("{body}.{point}")))]),
        Watched::Position { body, point, along } => {
            let along = along.name();
            let entries = vec![("position_of", quoted(&format!("{body}.{point}"))), ("along", quoted(along))];
            (format!("{body}_{along}"), entries)
        }
        Watched::Angle { body } => (format!("{body}_angle"), vec![("angle_of", quoted(body))]),
        Watched::AngularVelocity { body } => (format!("{body}_speed"), vec![("angular_velocity_of", quoted(body))]),
        Watched::Force { joint } => {
            let entries = vec![("force_in", quoted(&format!("joint.{joint}"))), ("component", quoted("magnitude"))];
            (format!("{joint}_force"), entries)
        }
    }
}

/// A first question about an output, for a study that asks nothing yet: the band of its deviation over the cycle.
pub fn question(what: &Watched, output: &str) -> String {
    let component = match what {
        Watched::Path { .. } => "component = \"normal\"  # across the path\n",
        _ => "",
    };
    format!(
        "\n[[ask]]\noutput = \"{output}\"\n{component}of = \"total\"\nat = \"cycle\"\n\
         statistics = [\"mean\", {{ quantile = 0.025 }}, {{ quantile = 0.975 }}]\n"
    )
}
