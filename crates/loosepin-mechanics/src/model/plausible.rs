//! Numbers that are allowed and hardly possible: units a thousand times off, bodies that no matter could make. They are warned of.

use super::contact::Contact;
use crate::contact::delivered_restitution;
use crate::model::parts::topology::{Body, Model};
use loosepin_text::diagnostics::{Code, Diagnostic, problems};
use loosepin_text::document::describe_path;
use loosepin_text::numbers::{Origin, QuantityId, Values};
use loosepin_text::units::{Dimension, format_number, format_value, parse_quantity};

mod usual;

use usual::{USUAL_RANGES, UsualRange};

/// Ratio of two masses of one mechanism above which one of them looks wrong.
const MAX_MASS_RATIO: f64 = 1000.0;
/// Radius of gyration over the extent of the body: a slender rod has 0.29.
const GYRATION_PER_EXTENT: [f64; 2] = [0.02, 5.0];
/// Radius of gyration over the extent of the largest body, at most: flywheels are larger than the crank they sit on.
const MAX_GYRATION_PER_LARGEST: f64 = 2.0;
/// Distance of the centre of mass from the points of its body, over their extent, at most.
const MAX_CENTRE_PER_EXTENT: f64 = 10.0;
/// Clearance over the radius of the bearing, at most.
const MAX_CLEARANCE_PER_RADIUS: f64 = 0.1;
/// Difference of delivered and nominal restitution, at most: what laws for nearly elastic impacts have at a quarter.
const MAX_RESTITUTION_GAINED: f64 = 0.45;
/// From the temperature of drawings, 20 °C (ISO 1), down to absolute zero, K.
const MIN_RISE_K: f64 = -293.15;
const MM_PER_M: f64 = 1e3;
/// Words in the names of parameters that are never below zero.
const POSITIVE_NAMES: [&str; 5] = ["length", "radius", "diameter", "thickness", "width"];

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
        Clearance { entry: String, found: String, radius: String } => Code::ImplausibleNumber,
            says("{entry} {found}; usual values are up to a tenth of the radius, {radius}"),
            hint("the clearance is radius of the hole minus radius of the pin, not the radius of the pin");
        Restitution { entry: String, found: String, law: &'static str, delivered: String } => Code::ImplausibleNumber,
            says("{entry} {found}; with the law {law} impacts have {delivered}"),
            hint("this law is for nearly elastic impacts; flores and exact-restitution deliver the given restitution");
    }
}

/// The likely meaning, or that the number may stay.
fn or_meant(slip: &Option<String>) -> String {
    slip.clone().unwrap_or_else(|| "correct it, or ignore this warning if the value is intended".to_owned())
}

impl Model {
    /// Warnings of numbers that are hardly possible, at the values of the file.
    pub(super) fn implausible_numbers(&self) -> Vec<Diagnostic> {
        let values = self.quantities.nominal();
        let mut found: Vec<(String, ImplausibleNumber)> = Vec::new();
        self.judge_quantities(&values, &mut found);
        self.judge_masses(&values, &mut found);
        let has_wrong_mass = |body: &Body| found.iter().any(|(path, _)| *path == mass_path(body));
        // An inertia is judged by the mass.
        let bodies: Vec<&Body> = self.bodies.iter().skip(1).filter(|body| !has_wrong_mass(body)).collect();
        for body in bodies {
            self.judge_body(body, &values, &mut found);
        }
        for contact in &self.contacts {
            self.judge_restitution(contact, &values, &mut found);
        }
        self.judge_clearances(&values, &mut found);
        found.iter().map(|(path, problem)| Diagnostic::warning(problem, self.place(path))).collect()
    }

    /// The extent of the points of the largest body, ground included, m: the scale of the mechanism.
    pub fn largest_extent_m(&self, values: &Values) -> f64 {
        self.bodies.iter().map(|body| extent_m(body, values)).fold(0.0, f64::max)
    }

    /// Numbers whose usual range depends on their key alone.
    fn judge_quantities(&self, values: &Values, found: &mut Vec<(String, ImplausibleNumber)>) {
        for (id, quantity) in self.quantities.iter() {
            let (value, entry) = (values[id], describe_path(&quantity.path));
            let shown = |value: f64| format_value(value, quantity.dimension);
            if quantity.path == "gravity" && value < 0.0 {
                let problem = ImplausibleNumber::Upwards { found: shown(value), turned: shown(-value) };
                found.push((quantity.path.clone(), problem));
            } else if quantity.path.ends_with("temperature_rise") && value < MIN_RISE_K {
                found
                    .push((quantity.path.clone(), ImplausibleNumber::BelowAbsoluteZero { entry, found: shown(value) }));
            } else if let Some(name) = quantity.path.strip_prefix("parameter.") {
                let is_length = quantity.dimension == Dimension::LENGTH;
                if is_length && value < 0.0 && POSITIVE_NAMES.iter().any(|word| name.contains(word)) {
                    let (found_text, turned) = (shown(value), shown(-value));
                    let problem = ImplausibleNumber::NegativeLength { entry, found: found_text, turned };
                    found.push((quantity.path.clone(), problem));
                }
            } else if let Some(usual) =
                USUAL_RANGES.iter().find(|usual| usual.is_of(&quantity.path, quantity.dimension))
                && !usual.holds(value)
            {
                let slip =
                    self.slip(id, usual.units, |meant| usual.holds(meant)).or_else(|| by_factor(usual, value, shown));
                let problem = ImplausibleNumber::Unusual { entry, found: shown(value), usual: usual.words, slip };
                found.push((quantity.path.clone(), problem));
            }
        }
    }

    /// The likely meaning of a number by another unit: the first of `units` (written, meant) with which it is plausible.
    fn slip(&self, id: QuantityId, units: &[(&str, &str)], is_plausible: impl Fn(f64) -> bool) -> Option<String> {
        let quantity = &self.quantities[id];
        let span = quantity.span.filter(|_| quantity.origin == Origin::Literal)?;
        let text = self.source.text().get(self.source.clamp(span))?.trim_matches(['"', '\'']);
        let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE ".contains(c));
        let number = text.strip_suffix(unit)?;
        units.iter().filter(|(written, _)| *written == unit).find_map(|(_, meant)| {
            let meant = format!("{number}{meant}");
            let measured = parse_quantity(&meant).ok()?;
            (measured.dimension == quantity.dimension && is_plausible(measured.value_si))
                .then(|| format!("did you mean \"{meant}\" instead of \"{text}\"?"))
        })
    }

    /// The heaviest and the lightest body.
    fn judge_masses(&self, values: &Values, found: &mut Vec<(String, ImplausibleNumber)>) {
        let mut masses: Vec<(&Body, QuantityId, f64)> =
            self.bodies.iter().filter_map(|body| body.mass_kg.map(|id| (body, id, values[id]))).collect();
        masses.sort_by(|a, b| a.2.total_cmp(&b.2));
        let (Some(&lightest), Some(&heaviest)) = (masses.first(), masses.last()) else { return };
        let ratio = heaviest.2 / lightest.2;
        if !(ratio > MAX_MASS_RATIO) {
            return;
        }
        // The one that is further from the middle of all is more likely to be wrong.
        let middle = masses[masses.len() / 2].2.ln() + masses[(masses.len() - 1) / 2].2.ln();
        let heavy_is_wrong = heaviest.2.ln() + lightest.2.ln() >= middle;
        let (wrong, other) = if heavy_is_wrong { (heaviest, lightest) } else { (lightest, heaviest) };
        let is_plausible = |mass: f64| (1.0 / MAX_MASS_RATIO..=MAX_MASS_RATIO).contains(&(mass / other.2));
        let slip = self.slip(wrong.1, &[("kg", "g"), ("t", "kg"), ("g", "kg"), ("mg", "g")], is_plausible);
        let shown = |mass: f64| format_value(mass, Dimension::MASS);
        let path = mass_path(wrong.0);
        let problem = ImplausibleNumber::Masses {
            entry: describe_path(&path),
            found: shown(wrong.2),
            other: other.0.name.clone(),
            other_found: shown(other.2),
            ratio: rounded(ratio),
            slip,
        };
        found.push((path, problem));
    }

    /// Inertia and centre of mass of a body against the extent of its points.
    fn judge_body(&self, body: &Body, values: &Values, found: &mut Vec<(String, ImplausibleNumber)>) {
        let (Some(mass), Some(inertia), Some(centre)) = (body.mass_kg, body.inertia_kg_m2, body.centre_of_mass_m)
        else {
            return;
        };
        let (extent_m, largest_m) = (extent_m(body, values), self.largest_extent_m(values));
        let length = |value_m: f64| format!("{} mm", rounded(MM_PER_M * value_m));
        let centre_m = centre.map(|id| values[id]);
        let to_point =
            |position: [QuantityId; 2]| (values[position[0]] - centre_m[0]).hypot(values[position[1]] - centre_m[1]);
        let distance_m = body.points.iter().map(|point| to_point(point.position_m)).fold(f64::INFINITY, f64::min);
        let is_far = distance_m.is_finite()
            && distance_m > MAX_CENTRE_PER_EXTENT * extent_m
            && distance_m > MAX_GYRATION_PER_LARGEST * largest_m;
        if largest_m > 0.0 && is_far {
            let path = format!("body.{}.centre_of_mass", body.name);
            let entry = describe_path(&path);
            let problem =
                ImplausibleNumber::CentreOfMass { entry, distance: length(distance_m), extent: length(extent_m) };
            found.push((format!("{path}.x"), problem));
            return;
        }
        let reach_m = if distance_m.is_finite() { extent_m.max(distance_m) } else { extent_m };
        let is_plausible = |inertia: f64| {
            let gyration_m = (inertia / values[mass]).sqrt();
            let [least, most] = GYRATION_PER_EXTENT.map(|share| share * reach_m);
            gyration_m >= least && (gyration_m <= most || gyration_m <= MAX_GYRATION_PER_LARGEST * largest_m)
        };
        if largest_m == 0.0 || is_plausible(values[inertia]) {
            return;
        }
        let units = ["kg m^2", "kg cm^2", "kg mm^2", "g m^2", "g cm^2", "g mm^2"];
        let pairs: Vec<(&str, &str)> = units.iter().flat_map(|w| units.iter().map(move |m| (*w, *m))).collect();
        let show_inertia = |value: f64| format_value(value, Dimension::INERTIA);
        let path = format!("body.{}.inertia", body.name);
        let problem = ImplausibleNumber::Inertia {
            entry: describe_path(&path),
            found: show_inertia(values[inertia]),
            gyration: length((values[inertia] / values[mass]).sqrt()),
            extent: length(extent_m),
            of_rod: format!(
                "about {}",
                show_inertia(two_digits(values[mass] * reach_m.max(1e-3 * largest_m).powi(2) / 12.0))
            ),
            slip: self.slip(inertia, &pairs, is_plausible),
        };
        found.push((path, problem));
    }

    /// What a contact law makes of the restitution.
    fn judge_restitution(&self, contact: &Contact, values: &Values, found: &mut Vec<(String, ImplausibleNumber)>) {
        let (Some(restitution), Some(law)) = (contact.law.restitution(), contact.law.loss()) else { return };
        let damping_factor = (law.damping_factor)(values[restitution]);
        let delivered = delivered_restitution(damping_factor);
        // A law without loss says so by its name.
        if damping_factor > 0.0 && delivered - values[restitution] > MAX_RESTITUTION_GAINED {
            let path = format!("contact.{}.restitution", contact.name);
            let problem = ImplausibleNumber::Restitution {
                entry: describe_path(&path),
                found: format_number(values[restitution]),
                law: law.name,
                delivered: rounded(delivered),
            };
            found.push((path, problem));
        }
    }

    /// Clearances against the radius of the hole or the ends of the slot.
    fn judge_clearances(&self, values: &Values, found: &mut Vec<(String, ImplausibleNumber)>) {
        for joint in &self.joints {
            let Some(play) = joint.kind.play() else { continue };
            let (key, clearance, Some(radius)) = (joint.kind.clearance_key(), play.clearance_m, play.radius_m) else {
                continue;
            };
            if values[clearance] > MAX_CLEARANCE_PER_RADIUS * values[radius] {
                let path = format!("joint.{}.{key}", joint.name);
                let [found_text, radius] = [clearance, radius].map(|id| format_value(values[id], Dimension::LENGTH));
                let problem = ImplausibleNumber::Clearance { entry: describe_path(&path), found: found_text, radius };
                found.push((path, problem));
            }
        }
    }
}

/// The likely meaning of a number by a factor.
fn by_factor(usual: &UsualRange, value: f64, shown: impl Fn(f64) -> String) -> Option<String> {
    let meant = usual.factors.iter().map(|factor| factor * value).find(|meant| usual.holds(*meant))?;
    Some(format!("did you mean {}?", shown(meant)))
}

fn mass_path(body: &Body) -> String {
    format!("body.{}.mass", body.name)
}

/// Diagonal of the box around the points of a body, m.
fn extent_m(body: &Body, values: &Values) -> f64 {
    let side = |axis: usize| {
        let all = body.points.iter().map(|point| values[point.position_m[axis]]);
        let (least, most) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        (most - least).max(0.0)
    };
    side(0).hypot(side(1))
}

/// A number with two significant digits.
fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// A number with three significant digits, as text.
fn rounded(value: f64) -> String {
    format_number(format!("{value:.2e}").parse().unwrap_or(value))
}
