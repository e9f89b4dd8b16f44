//! Which number of the text gives a coordinate, and what it must become for the coordinate to have a certain value.

use std::collections::HashSet;

use loosepin::model::{Model, Origin, QuantityId};

/// Relative steps of a parameter at which an expression is tried for a straight line.
const TRIAL: f64 = 1e-3;
/// A curve bends more than this share of its rise.
const STRAIGHT: f64 = 1e-9;

/// A number of the file and the value that it is to have, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// The number, which stands in the file as it is.
    pub quantity: QuantityId,
    /// Its value, SI.
    pub value_si: f64,
}

/// Why a coordinate cannot be changed by one number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LockedCoordinate {
    /// Path of the coordinate.
    pub path: String,
    /// Names of what its expression uses.
    pub by: Vec<String>,
}

/// The number behind a quantity: itself, or the one parameter on which it depends along a straight line, however many steps away.
pub fn behind(model: &Model, quantity: QuantityId, value_si: f64) -> Result<Setting, LockedCoordinate> {
    let written = &model.quantities[quantity];
    match &written.origin {
        Origin::Literal => Ok(Setting { quantity, value_si }),
        Origin::Expression { depends_on } => {
            let locked = || LockedCoordinate {
                path: written.path.clone(),
                by: depends_on.iter().map(|id| name(&model.quantities[*id].path)).collect(),
            };
            let sources = literals(model, quantity);
            let [source] = sources[..] else { return Err(locked()) };
            let [value, slope] = line(model, quantity, source).ok_or_else(locked)?;
            let moved_si = model.quantities.nominal()[source] + (value_si - value) / slope;
            Ok(Setting { quantity: source, value_si: moved_si })
        }
        Origin::Default | Origin::Fixed => Err(LockedCoordinate { path: written.path.clone(), by: Vec::new() }),
    }
}

/// Path of the number behind a quantity, where there is one.
pub fn number_behind(model: &Model, quantity: QuantityId) -> Option<String> {
    let setting = behind(model, quantity, model.quantities.nominal()[quantity]).ok()?;
    Some(model.quantities[setting.quantity].path.clone())
}

fn name(path: &str) -> String {
    path.strip_prefix("parameter.").unwrap_or(path).to_owned()
}

/// The numbers of the file on which a quantity depends.
fn literals(model: &Model, quantity: QuantityId) -> Vec<QuantityId> {
    let mut found = Vec::new();
    let mut open = vec![quantity];
    // Two expressions may use the same ones in many ways: each is looked at once.
    let mut seen = HashSet::from([quantity]);
    while let Some(next) = open.pop() {
        match &model.quantities[next].origin {
            Origin::Expression { depends_on } => open.extend(depends_on.iter().filter(|id| seen.insert(**id))),
            _ => found.push(next),
        }
    }
    found
}

/// Value and slope of a quantity over a number, where that is a straight line.
fn line(model: &Model, quantity: QuantityId, source: QuantityId) -> Option<[f64; 2]> {
    let table = &model.quantities;
    let start_si = table.nominal()[source];
    let step_si = if start_si == 0.0 { TRIAL } else { TRIAL * start_si };
    let at = |steps: f64| Some(table.evaluate(&[(source, start_si + steps * step_si)]).ok()?[quantity]);
    let (first, second, third) = (at(0.0)?, at(1.0)?, at(2.0)?);
    let rise = third - first;
    let is_straight = (second - 0.5 * (first + third)).abs() <= STRAIGHT * rise.abs().max(f64::MIN_POSITIVE);
    (rise != 0.0 && rise.is_finite() && is_straight).then(|| [first, rise / (2.0 * step_si)])
}
