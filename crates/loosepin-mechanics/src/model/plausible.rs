//! Numbers of a planar model that are allowed and hardly possible together: bodies that no matter could make, clearances beside their
//! bearings, gears that do not touch. Numbers by themselves: `loosepin-text`, `plausible`.

use super::contact::Contact;
use crate::contact::delivered_restitution;
use crate::model::ids::{BodyId, PlayId};
use crate::model::joint::TreeAttachment;
use crate::model::output::{Output, Position, Relative};
use crate::model::parts::topology::{Body, Model};
use loosepin_text::diagnostics::{Place, Source};
use loosepin_text::document::describe_path;
use loosepin_text::numbers::{QuantityId, QuantityTable, Values};
use loosepin_text::plausible::{Implausible, ImplausibleNumber, JudgedModel, JudgedNumbers};
use loosepin_text::units::{Dimension, format_apart, format_number, format_value};

/// Ratio of two masses of one mechanism above which one of them looks wrong.
const MAX_MASS_RATIO: f64 = 1000.0;
/// Radius of gyration over the extent of the body: a slender rod has 0.29.
const GYRATION_PER_EXTENT: [f64; 2] = [0.02, 5.0];
/// Radius of gyration over the extent of the largest body, at most: flywheels are larger than the crank they sit on.
const MAX_GYRATION_PER_LARGEST: f64 = 2.0;
/// Distance of the centre of mass from the points of its body, over their extent, at most.
const MAX_CENTRE_PER_EXTENT: f64 = 10.0;
/// Difference of delivered and nominal restitution, at most: what laws for nearly elastic impacts have at a quarter.
const MAX_RESTITUTION_GAINED: f64 = 0.45;
const MM_PER_M: f64 = 1e3;

impl JudgedModel for Model {
    fn quantities(&self) -> &QuantityTable {
        &self.quantities
    }

    fn source(&self) -> &Source {
        &self.source
    }

    fn place(&self, path: &str) -> Option<Place> {
        self.place(path)
    }

    fn implausible_at(&self, judged: &JudgedNumbers<'_>) -> Vec<Implausible> {
        let mut found = judged.by_key();
        let is_unusual = |body: &Body| body.mass_kg.is_some_and(|mass| !judged.is_usual(mass));
        let beside_others = if self.bodies.iter().any(is_unusual) { None } else { self.judge_masses(judged) };
        let wrong = beside_others.map(|(body, problem)| {
            found.push((format!("body.{}.mass", body.name), problem));
            &body.name
        });
        // An inertia is judged by the mass.
        for body in self.bodies.iter().skip(1).filter(|body| !is_unusual(body) && wrong != Some(&body.name)) {
            self.judge_body(body, judged, &mut found);
        }
        for contact in &self.contacts {
            self.judge_restitution(contact, judged.values, &mut found);
        }
        self.judge_clearances(judged, &mut found);
        self.judge_gears(judged.values, &mut found);
        found
    }

    fn bodies_of_outputs(&self) -> Vec<(&str, usize)> {
        let seen = |output: &Output| seen_from_ground(output).map(|BodyId(body)| body);
        self.outputs.iter().filter_map(|output| Some((output.name.as_str(), seen(output)?))).collect()
    }

    fn rigid_pairs(&self) -> Vec<[usize; 2]> {
        let rigid = self.joints.iter().filter(|joint| joint.kind.tree_attachment() == TreeAttachment::Fixed);
        rigid.map(|joint| joint.kind.points().map(|point| point.body.0)).collect()
    }
}

/// The body whose position or angle from the ground an output is.
fn seen_from_ground(output: &Output) -> Option<BodyId> {
    if let Some(Relative { of, to: None }) = output.kind.path() {
        return Some(of.body);
    }
    match output.kind.reading()?.position()? {
        Position::Point(Relative { of, to: None }, _) => Some(of.body),
        Position::Angle(Relative { of, to: None }) => Some(of),
        _ => None,
    }
}

impl Model {
    /// The extent of the points of the largest body, ground included, m: the scale of the mechanism.
    pub fn largest_extent_m(&self, values: &Values) -> f64 {
        self.bodies.iter().map(|body| extent_m(body, values)).fold(0.0, f64::max)
    }

    /// The heaviest or the lightest body, if they are too far apart: the one that is likely to be wrong.
    fn judge_masses(&self, judged: &JudgedNumbers<'_>) -> Option<(&Body, ImplausibleNumber)> {
        let values = judged.values;
        let mut masses: Vec<(&Body, QuantityId, f64)> =
            self.bodies.iter().filter_map(|body| body.mass_kg.map(|id| (body, id, values[id]))).collect();
        masses.sort_by(|a, b| a.2.total_cmp(&b.2));
        let (&lightest, &heaviest) = (masses.first()?, masses.last()?);
        let ratio = heaviest.2 / lightest.2;
        if !(ratio > MAX_MASS_RATIO) {
            return None;
        }
        // The one that is further from the middle of all is more likely to be wrong.
        let middle = masses[masses.len() / 2].2.ln() + masses[(masses.len() - 1) / 2].2.ln();
        let heavy_is_wrong = heaviest.2.ln() + lightest.2.ln() >= middle;
        let (wrong, other) = if heavy_is_wrong { (heaviest, lightest) } else { (lightest, heaviest) };
        let is_plausible = |mass: f64| (1.0 / MAX_MASS_RATIO..=MAX_MASS_RATIO).contains(&(mass / other.2));
        let slip = judged.slip(wrong.1, &[("kg", "g"), ("t", "kg"), ("g", "kg"), ("mg", "g")], is_plausible);
        let shown = |mass: f64| format_value(mass, Dimension::MASS);
        let problem = ImplausibleNumber::Masses {
            entry: describe_path(&format!("body.{}.mass", wrong.0.name)),
            found: shown(wrong.2),
            other: other.0.name.clone(),
            other_found: shown(other.2),
            ratio: rounded(ratio),
            slip,
        };
        Some((wrong.0, problem))
    }

    /// Inertia and centre of mass of a body against the extent of its points.
    fn judge_body(&self, body: &Body, judged: &JudgedNumbers<'_>, found: &mut Vec<Implausible>) {
        let values = judged.values;
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
            slip: judged.slip(inertia, &pairs, is_plausible),
        };
        found.push((path, problem));
    }

    /// What a contact law makes of the restitution.
    fn judge_restitution(&self, contact: &Contact, values: &Values, found: &mut Vec<Implausible>) {
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

    /// Clearances against the radius of the hole or the ends of the slot, or against the largest body.
    fn judge_clearances(&self, judged: &JudgedNumbers<'_>, found: &mut Vec<Implausible>) {
        let extent_m = self.largest_extent_m(judged.values);
        for (play, clearance) in self.play_clearances() {
            let (path, radius) = match play {
                PlayId::Joint(joint) => {
                    let joint = &self.joints[joint.0];
                    let path = format!("joint.{}.{}", joint.name, joint.kind.clearance_key());
                    (path, joint.kind.play().and_then(|play| play.radius_m))
                }
                PlayId::Coupling(_) => (self.quantities[clearance].path.clone(), None),
            };
            found.extend(judged.clearance(path, clearance, radius, extent_m));
        }
    }

    /// Gears on a common carrier whose pitch circles do not touch. Where their joints carry the force of the teeth, that is refused later.
    fn judge_gears(&self, values: &Values, found: &mut Vec<Implausible>) {
        for coupling in self.couplings.iter().filter(|coupling| coupling.teeth.is_none()) {
            let Some(gears) = coupling.kind.pitch_circles() else { continue };
            let joints = [coupling.first, coupling.second].map(|joint| self.joints[joint.0].kind.points());
            let bodies = joints.map(|points| points.map(|point| point.body));
            let Some(carrier) = bodies[0].into_iter().find(|body| bodies[1].contains(body)) else { continue };
            let centres = joints.map(|points| points.into_iter().find(|point| point.body == carrier));
            let [Some(first), Some(second)] = centres else { continue };
            let position = |point: usize, BodyId(body): BodyId| self.bodies[body].points[point].position_m;
            let [first, second] = [first, second].map(|at| position(at.point, at.body).map(|id| values[id]));
            let distance_m = (second[0] - first[0]).hypot(second[1] - first[1]);
            let Some(due_m) = gears.mesh.distance_m(gears.radii_m.map(|id| values[id])) else { continue };
            if !gears.mesh.fits(distance_m, due_m) {
                let [distance, due] = format_apart([distance_m, due_m], Dimension::LENGTH);
                let entry = describe_path(&coupling.path);
                let problem = ImplausibleNumber::PitchCirclesApart { entry, found: distance, due };
                found.push((coupling.path.clone(), problem));
            }
        }
    }
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
