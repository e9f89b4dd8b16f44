//! Numbers that are allowed and hardly possible: units a thousand times off, bodies that no matter could make. They are warned of. What depends on
//! the key of a number alone is judged here, for every kind of model; what depends on how numbers belong together is judged where they do.

mod judged_model;
mod usual;

pub use judged_model::JudgedModel;

use crate::diagnostics::{Code, problems};
use crate::document::describe_path;
use crate::numbers::{Origin, Quantity, QuantityId, QuantityTable, Values};
use crate::units::{Dimension, format_value, parse_quantity};
use usual::{USUAL_RANGES, UsualRange};

/// From the temperature of drawings, 20 °C (ISO 1), down to absolute zero, K.
const MIN_RISE_K: f64 = -293.15;
/// Words in the names of parameters that are never below zero.
const POSITIVE_NAMES: [&str; 5] = ["length", "radius", "diameter", "thickness", "width"];
/// Clearance over the radius of the bearing, at most.
const MAX_CLEARANCE_PER_RADIUS: f64 = 0.1;
/// Clearance over the size of the mechanism, at most, where no radius is known.
const MAX_CLEARANCE_PER_EXTENT: f64 = 0.05;
/// Least clearance above zero, m: polished surfaces are as rough.
const MIN_CLEARANCE_M: f64 = 1e-7;

problems! {
    /// A number that is allowed and hardly possible. `entry` is a path in words; `slip` is the likely meaning.
    #[derive(Debug, Clone, PartialEq)]
    pub enum ImplausibleNumber {
        Unusual { entry: String, found: String, usual: &'static str, slip: Option<String> } => Code::ImplausibleNumber,
            says("{entry} {found}; usual values are {usual}"),
            hint_of(Some(or_meant(slip)));
        Upwards { found: String, turned: String } => Code::ImplausibleNumber,
            says("gravity {found} acts upwards: gravity is the acceleration along -y"),
            hint("did you mean \"{turned}\"?");
        BelowAbsoluteZero { entry: String, found: String } => Code::ImplausibleNumber,
            says("{entry} {found}; from 20 °C this is below absolute zero"),
            hint("give the difference from the temperature of the drawing, in K");
        NegativeLength { entry: String, found: String, turned: String } => Code::ImplausibleNumber,
            says("{entry} is {found}; a length is usually above 0"),
            hint("did you mean \"{turned}\"?");
        Masses { entry: String, found: String, other: String, other_found: String, ratio: String, slip: Option<String> } =>
            Code::ImplausibleNumber,
            says("{entry} {found}; body '{other}' has {other_found}, a ratio of {ratio}"),
            hint_of(Some(or_meant(slip)));
        Inertia {
            entry: String,
            found: String,
            /// Radius of gyration, √(inertia/mass).
            gyration: String,
            extent: String,
            /// Inertia of a slender rod of the same mass and extent.
            of_rod: String,
            slip: Option<String>,
        } => Code::ImplausibleNumber,
            says("{entry} {found}; its radius of gyration is then {gyration}, with points {extent} apart"),
            hint_of(Some(match slip {
                Some(slip) => slip.clone(),
                None => format!("a slender rod of that mass and length has {of_rod}"),
            }));
        CentreOfMass { entry: String, distance: String, extent: String } => Code::ImplausibleNumber,
            says("{entry} lies {distance} from the points of the body, which are {extent} apart"),
            hint("give it in the frame of the body, like the points");
        /// `share` says of what a clearance is a small part.
        Clearance { entry: String, found: String, share: &'static str, size: String } => Code::ImplausibleNumber,
            says("{entry} {found}; usual values are up to {share}, {size}"),
            hint("the clearance is radius of the hole minus radius of the pin, not the radius of the pin");
        /// Above zero, and less than any surface is smooth.
        TinyClearance { entry: String, found: String, slip: Option<String> } => Code::ImplausibleNumber,
            says("{entry} {found}; usual values are above 0.1 µm, or 0"),
            hint_of(Some(or_meant(slip)));
        NeverMoves { entry: String } => Code::ImplausibleNumber,
            says("{entry} never moves: its body stands still over the whole cycle"),
            hint("the loops may be closed in another way than meant: choose it by guess under [assembly], `loosepin check` shows the ways");
        /// `found` and `due` are distances of the centres: in the model, and of pitch circles that touch.
        PitchCirclesApart { entry: String, found: String, due: String } => Code::ImplausibleNumber,
            says("{entry}: the pitch circles do not touch: the centres are {found} apart; with these radii {due} are expected"),
            hint("radii are those of the pitch circles in mesh: the distance is their sum, or for an internal mesh their difference");
        Restitution { entry: String, found: String, law: &'static str, delivered: String } => Code::ImplausibleNumber,
            says("{entry} {found}; with the law {law} impacts have {delivered}"),
            hint("this law is for nearly elastic impacts; flores and exact-restitution deliver the given restitution");
    }
}

/// The likely meaning, or that the number may stay.
fn or_meant(slip: &Option<String>) -> String {
    slip.clone().unwrap_or_else(|| "correct it, or ignore this warning if the value is intended".to_owned())
}

/// An implausible number: its path, and what is said of it.
pub type Implausible = (String, ImplausibleNumber);

/// The numbers of a model that are judged.
pub struct JudgedNumbers<'a> {
    /// The quantities.
    pub quantities: &'a QuantityTable,
    /// Their values.
    pub values: &'a Values,
    /// How a number is written, where it is written as it is.
    pub written: &'a dyn Fn(QuantityId) -> Option<String>,
}

impl JudgedNumbers<'_> {
    /// Numbers whose usual range depends on their key alone.
    pub fn by_key(&self) -> Vec<Implausible> {
        let judged = self.quantities.iter().map(|(id, quantity)| (&quantity.path, self.judge(id, quantity)));
        judged.filter_map(|(path, problem)| Some((path.clone(), problem?))).collect()
    }

    /// Whether a number lies in the usual range of its key.
    pub fn is_usual(&self, id: QuantityId) -> bool {
        self.judge(id, &self.quantities[id]).is_none()
    }

    fn judge(&self, id: QuantityId, quantity: &Quantity) -> Option<ImplausibleNumber> {
        let (value, entry) = (self.values[id], describe_path(&quantity.path));
        let shown = |value: f64| format_value(value, quantity.dimension);
        if quantity.path == "gravity" && value < 0.0 {
            return Some(ImplausibleNumber::Upwards { found: shown(value), turned: shown(-value) });
        }
        if quantity.path.ends_with("temperature_rise") && value < MIN_RISE_K {
            return Some(ImplausibleNumber::BelowAbsoluteZero { entry, found: shown(value) });
        }
        if let Some(name) = quantity.path.strip_prefix("parameter.") {
            let is_length = quantity.dimension == Dimension::LENGTH;
            let is_turned = is_length && value < 0.0 && POSITIVE_NAMES.iter().any(|word| name.contains(word));
            let (found, turned) = (shown(value), shown(-value));
            return is_turned.then_some(ImplausibleNumber::NegativeLength { entry, found, turned });
        }
        let usual = USUAL_RANGES.iter().find(|usual| usual.is_of(&quantity.path, quantity.dimension))?;
        if usual.holds(value) {
            return None;
        }
        let slip = self.slip(id, usual.units, |meant| usual.holds(meant)).or_else(|| by_factor(usual, value, shown));
        Some(ImplausibleNumber::Unusual { entry, found: shown(value), usual: usual.words, slip })
    }

    /// The likely meaning of a number by another unit: the first of `units` (written, meant) with which it is plausible.
    pub fn slip(&self, id: QuantityId, units: &[(&str, &str)], is_plausible: impl Fn(f64) -> bool) -> Option<String> {
        let quantity = &self.quantities[id];
        let text = (self.written)(id).filter(|_| quantity.origin == Origin::Literal)?;
        let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE ".contains(c));
        let number = text.strip_suffix(unit)?;
        units.iter().filter(|(written, _)| *written == unit).find_map(|(_, meant)| {
            let meant = format!("{number}{meant}");
            let measured = parse_quantity(&meant).ok()?;
            (measured.dimension == quantity.dimension && is_plausible(measured.value_si))
                .then(|| format!("did you mean \"{meant}\" instead of \"{text}\"?"))
        })
    }

    /// A clearance against the radius of its bearing, or, where it has none, against the size of the mechanism; `path` is that of the entry.
    pub fn clearance(
        &self,
        path: String,
        clearance: QuantityId,
        radius: Option<QuantityId>,
        extent_m: f64,
    ) -> Option<Implausible> {
        let clearance_m = self.values[clearance];
        let length = |value_m: f64| format_value(value_m, Dimension::LENGTH);
        let (entry, found) = (describe_path(&path), length(clearance_m));
        if clearance_m > 0.0 && clearance_m < MIN_CLEARANCE_M {
            let slip = self.slip(clearance, &[("um", "mm"), ("µm", "mm"), ("nm", "µm"), ("mm", "m")], |meant_m| {
                meant_m >= MIN_CLEARANCE_M
            });
            return Some((path, ImplausibleNumber::TinyClearance { entry, found, slip }));
        }
        let (limit, share, size_m) = match radius.map(|id| self.values[id]) {
            Some(radius_m) => (MAX_CLEARANCE_PER_RADIUS, "a tenth of the radius", radius_m),
            None => (MAX_CLEARANCE_PER_EXTENT, "a twentieth of the largest body", extent_m),
        };
        let is_wide = size_m > 0.0 && clearance_m > limit * size_m;
        is_wide.then(|| (path, ImplausibleNumber::Clearance { entry, found, share, size: length(size_m) }))
    }
}

/// The likely meaning of a number by a factor.
fn by_factor(usual: &UsualRange, value: f64, shown: impl Fn(f64) -> String) -> Option<String> {
    let meant = usual.factors.iter().map(|factor| factor * value).find(|meant| usual.holds(*meant))?;
    Some(format!("did you mean {}?", shown(meant)))
}
