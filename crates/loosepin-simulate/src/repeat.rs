//! The command by which a run is made again.

use super::history::Plan;
use super::settings::Settings;
use loosepin_mechanics::model::Model;
use loosepin_result::repeat::Repeat;

/// What `plan` asks of `model`: what differs from the file is in the command.
pub(super) fn repeat(model: &Model, plan: &Plan) -> Repeat {
    let mut arguments: Vec<String> = Vec::new();
    let mut add = |name: &str, value: String| arguments.extend([name.to_owned(), value]);
    for change in &plan.overrides {
        add("--set", format!("{}={}", change.path, change.written));
    }
    let (cycle, own) = (&model.cycle, &plan.cycle);
    if own.recorded_turns != cycle.recorded_turns {
        add("--turns", own.recorded_turns.to_string());
    }
    if own.transient_turns != cycle.transient_turns {
        add("--transient", own.transient_turns.to_string());
    }
    if own.samples_per_turn != cycle.samples_per_turn {
        add("--samples", own.samples_per_turn.to_string());
    }
    if plan.settings.tolerance_m != Settings::for_simulation().tolerance_m {
        add("--tolerance", format!("{:e} m", plan.settings.tolerance_m));
    }
    if let Some(turns) = plan.lyapunov_turns {
        add("--lyapunov", turns.to_string());
    }
    if plan.with_states {
        arguments.push("--states".to_owned());
    }
    let sources = std::iter::once(model.source()).chain(model.tables());
    Repeat::new("simulate", &arguments, sources.map(|source| &**source))
}
