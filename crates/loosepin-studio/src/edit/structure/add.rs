//! Additions to the model: links, points, joints, blocks, outputs. First guesses are marked so.

use std::collections::{BTreeMap, BTreeSet, HashSet};

use loosepin::model::{Model, PointId, Values};
use loosepin::units::format_number;

use super::edit::{End, Joined, Watched};
use super::watch::output;
use crate::drawing::still::{NamedPoses, Pose, in_body_m};
use crate::edit::toml::lines::{EditedText, owned};
use crate::network::refusal::Refusal;

const MM_PER_M: f64 = 1e3;
const GROUND: &str = "ground";
/// Two points nearer to each other are one, mm.
const NEAREST_MM: f64 = 1e-3;
/// Largest coordinate of a drawing, mm.
const FURTHEST_MM: f64 = 1e7;
/// Steel bar of 20 mm x 8 mm: 7850 kg/m^3 times its section.
const BAR_KG_PER_M: &str = "1.256 kg/m";
const BLOCK_MASS: &str = "\"0.2 kg\"";
/// Inertia of a block, as of a body of a few centimetres.
const BLOCK_INERTIA: &str = "\"5e-5 kg m^2\"";
const FIRST_BAR: &str = "first guess: a steel bar of 20 mm x 8 mm";
const FIRST_GUESS: &str = "first guess";
/// Speed of a motor that nobody has described.
const FIRST_SPEED: &str = "\"60 rpm\"  # first guess";
const MOTOR: &str = "motor";
const ORIGIN: &str = "[\"0 mm\", \"0 mm\"]";

/// A model to which something is added.
pub struct Draft<'m> {
    model: &'m Model,
    values: Values,
    poses: BTreeMap<String, Pose>,
    lines: EditedText,
    /// Paths of the added and set entries, with dots between their steps.
    added: BTreeSet<String>,
    /// Paths of what has a name in the model.
    named: HashSet<String>,
    new_poses: NamedPoses,
}

/// Outcome of a draft.
pub struct DraftOutcome {
    /// Text of the model.
    pub lines: EditedText,
    /// Paths of the added and set entries.
    pub added: BTreeSet<String>,
    /// Poses of new bodies.
    pub new_poses: NamedPoses,
}

/// An end with its place.
struct Attached {
    /// `body.point`; `None` for a free place.
    point: Option<String>,
    body: Option<String>,
    at_m: [f64; 2],
}

impl<'m> Draft<'m> {
    /// A model with its bodies at these poses, in their order.
    pub fn new(model: &'m Model, poses: &[Pose], text: &str) -> Self {
        let named = model.bodies.iter().zip(poses).map(|(body, pose)| (body.name.clone(), *pose));
        Self {
            model,
            values: model.quantities.nominal(),
            poses: named.collect(),
            lines: EditedText::new(text),
            added: BTreeSet::new(),
            named: named_in(model),
            new_poses: NamedPoses::new(),
        }
    }

    /// The outcome of the draft.
    pub fn finished(self) -> DraftOutcome {
        DraftOutcome { lines: self.lines, added: self.added, new_poses: self.new_poses }
    }

    /// A link between two places. Where it begins or ends at something, a pin joins both. The first link of a mechanism is its crank: a motor
    /// turns it at its pin on the ground.
    ///
    /// # Errors
    /// Why there is no such link, in words.
    pub fn add_link(&mut self, from: &End, to: &End) -> Result<String, Refusal> {
        let ends = [self.attach(from)?, self.attach(to)?];
        let same = ends[0].body.is_some() && ends[0].body == ends[1].body;
        if same {
            return Err(Refusal::bad("both ends are on the same body, so nothing can move")
                .with_hint("end the link on another body, or at a free place"));
        }
        let [x, y] = [0, 1].map(|axis| ends[1].at_m[axis] - ends[0].at_m[axis]);
        let length_mm = x.hypot(y) * MM_PER_M;
        if length_mm < NEAREST_MM {
            return Err(Refusal::bad("the link would have no length").with_hint("end it at another place"));
        }
        let name = self.free("body", "link");
        let length = format!("{name}_length");
        let length = if self.has("parameter", &length) { self.free("parameter", &length) } else { length };
        self.entry(&["parameter"], &length, &format!("\"{} mm\"", mm(length_mm)))?;
        self.table(
            "body",
            &name,
            FIRST_BAR,
            &[
                ("mass", format!("\"{BAR_KG_PER_M} * {length}\"")),
                ("inertia", format!("\"{BAR_KG_PER_M} * {length}^3 / 12\"")),
                ("centre_of_mass", format!("[\"{length} / 2\", \"0 mm\"]")),
                ("points", format!("{{ a = {ORIGIN}, b = [\"{length}\", \"0 mm\"] }}")),
            ],
        )?;
        let pose = Pose { origin_m: ends[0].at_m, angle_rad: y.atan2(x) };
        let is_first = self.model.bodies.len() == 1 && self.model.drives.is_empty();
        let is_crank = is_first && ends[0].body.as_deref() == Some(GROUND);
        if is_crank {
            // The motor says how it lies at the start.
            self.place(&name, pose);
        } else {
            self.guess(&name, pose)?;
        }
        for (end, own) in ends.iter().zip(["a", "b"]) {
            if let Some(point) = &end.point {
                let joint = self.free_named("joint", &format!("{name}_{own}"));
                self.revolute(&joint, point, &format!("{name}.{own}"))?;
                if is_crank && own == "a" {
                    self.add_motor(&joint, pose.angle_rad)?;
                }
            }
        }
        Ok(name)
    }

    /// A further point of a body, joined to what is at its place.
    ///
    /// # Errors
    /// Why there is no such point, in words.
    pub fn add_point(&mut self, body: &str, to: &End) -> Result<String, Refusal> {
        if let End::On { body: other, is_own: true, .. } = to
            && other == body
        {
            let point = self.attach(to)?.point;
            return point.ok_or_else(|| Refusal::bad("there is no such place"));
        }
        let end = match to {
            // A place of another body is a free place here: the new point belongs to `body` alone.
            End::On { x, y, is_own: false, .. } | End::Free { x, y } => {
                let on = End::On { body: body.to_owned(), x: *x, y: *y, is_own: false };
                return self.attach(&on)?.point.ok_or_else(|| Refusal::bad("there is no such place"));
            }
            _ => self.attach(to)?,
        };
        if end.body.as_deref() == Some(body) {
            return Err(Refusal::bad(format!("'{body}' already has this point")));
        }
        let [x, y] = end.at_m.map(|m| m * MM_PER_M);
        let on = End::On { body: body.to_owned(), x, y, is_own: false };
        let point = self.attach(&on)?.point.unwrap_or_default();
        let joint = self.free("joint", "pin");
        self.revolute(&joint, &end.point.unwrap_or_default(), &point)?;
        Ok(point)
    }

    /// A joint of two points.
    ///
    /// # Errors
    /// Why there is no such joint, in words.
    pub fn join(&mut self, first: &End, second: &End, by: &Joined) -> Result<String, Refusal> {
        let [first, second] = [self.attach(first)?, self.attach(second)?];
        if first.body == second.body {
            return Err(Refusal::bad("both points are on the same body, so they are already joined"));
        }
        let (Some(one), Some(other)) = (&first.point, &second.point) else {
            return Err(
                Refusal::bad("a joint is between two points of bodies").with_hint("choose a point for each end")
            );
        };
        let known = self.model.joints.iter().find(|joint| {
            let [a, b] = joint.kind.points().map(|point| self.name_of(point));
            (&a, &b) == (one, other) || (&b, &a) == (one, other)
        });
        if let Some(known) = known {
            return Err(Refusal::bad(format!("joint '{}' already joins these points", known.name)));
        }
        // Direction of a line in the frame of a body.
        let own_deg = |end: &Attached, angle_deg: f64| {
            let pose = end.body.as_ref().and_then(|body| self.poses.get(body)).copied().unwrap_or_default();
            degrees(angle_deg - pose.angle_rad.to_degrees())
        };
        match by {
            Joined::Pin { .. } => {
                let name = self.free("joint", "pin");
                self.revolute(&name, one, other)?;
                Ok(name)
            }
            Joined::Slider { angle_deg } => {
                is_angle(*angle_deg)?;
                let (guide, slider) = (own_deg(&first, *angle_deg), own_deg(&second, *angle_deg));
                let name = self.free("joint", "guide");
                let slider = match slider.as_str() {
                    "0" => format!("\"{other}\""),
                    angle => format!("{{ point = \"{other}\", angle = \"{angle} deg\" }}"),
                };
                let guide = format!("{{ point = \"{one}\", angle = \"{guide} deg\" }}");
                let kind = "\"prismatic\"".to_owned();
                self.table("joint", &name, "", &[("kind", kind), ("guide", guide), ("slider", slider)])?;
                Ok(name)
            }
            Joined::Slot { angle_deg } => {
                is_angle(*angle_deg)?;
                let slot = format!("{{ point = \"{one}\", angle = \"{} deg\" }}", own_deg(&first, *angle_deg));
                let name = self.free("joint", "slot");
                let (kind, pin) = ("\"slot\"".to_owned(), format!("\"{other}\""));
                self.table("joint", &name, "", &[("kind", kind), ("slot", slot), ("pin", pin)])?;
                Ok(name)
            }
            Joined::Rigid => {
                let turn_rad = |end: &Attached| {
                    end.body.as_ref().and_then(|body| self.poses.get(body)).map_or(0.0, |pose| pose.angle_rad)
                };
                let angle = degrees((turn_rad(&second) - turn_rad(&first)).to_degrees());
                let name = self.free("joint", "rigid");
                self.table(
                    "joint",
                    &name,
                    "",
                    &[
                        ("kind", "\"rigid\"".to_owned()),
                        ("first", format!("\"{one}\"")),
                        ("second", format!("\"{other}\"")),
                        ("angle", format!("\"{angle} deg\"")),
                    ],
                )?;
                Ok(name)
            }
        }
    }

    /// A block in a guide of the ground, at a point of a body, with a pin in it.
    ///
    /// # Errors
    /// Why there is no such block, in words.
    pub fn add_block(&mut self, on: &End, angle_deg: f64) -> Result<String, Refusal> {
        is_angle(angle_deg)?;
        let end = self.attach(on)?;
        if end.body.as_deref() == Some(GROUND) {
            return Err(Refusal::bad("a block moves against the ground").with_hint("choose a point of a link"));
        }
        let point = end
            .point
            .ok_or_else(|| Refusal::bad("a block needs a point of a link").with_hint("choose a point of a link"))?;
        let [x, y] = end.at_m.map(|m| m * MM_PER_M);
        let ground = self.attach(&End::On { body: GROUND.to_owned(), x, y, is_own: false })?.point.unwrap_or_default();
        let name = self.free("body", "block");
        self.table(
            "body",
            &name,
            FIRST_GUESS,
            &[
                ("mass", BLOCK_MASS.to_owned()),
                ("inertia", BLOCK_INERTIA.to_owned()),
                ("centre_of_mass", ORIGIN.to_owned()),
                ("points", format!("{{ pin = {ORIGIN} }}")),
            ],
        )?;
        let pose = Pose { origin_m: end.at_m, angle_rad: angle_deg.to_radians() };
        self.place(&name, pose);
        let guide = self.free("joint", "guide");
        self.table(
            "joint",
            &guide,
            "",
            &[
                ("kind", "\"prismatic\"".to_owned()),
                ("guide", format!("{{ point = \"{ground}\", angle = \"{} deg\" }}", degrees(angle_deg))),
                ("slider", format!("\"{name}.pin\"")),
            ],
        )?;
        let pin = self.free_named("joint", &format!("{name}_pin"));
        self.revolute(&pin, &point, &format!("{name}.pin"))?;
        Ok(name)
    }

    /// The drive turns another pin from now on, from where it is.
    ///
    /// # Errors
    /// There is no such pin, or not one drive.
    pub fn drive(&mut self, joint: &str) -> Result<String, Refusal> {
        let found = self.model.joints.iter().find(|one| one.name == joint);
        let found = found.ok_or_else(|| Refusal::bad(format!("joint '{joint}' no longer exists")))?;
        if !found.kind.turns() {
            return Err(Refusal::bad("a motor turns a pin").with_hint("write other drives in the text"));
        }
        let [bearing, journal] = found.kind.points();
        if found.kind.play().is_some() {
            return Err(Refusal::bad(format!("'{joint}' has play: a motor turns a pin without play")));
        }
        let angle =
            |point: PointId| self.poses.get(&self.model.bodies[point.body.0].name).map_or(0.0, |pose| pose.angle_rad);
        let start_rad = angle(journal) - angle(bearing);
        let start = start_angle(start_rad);
        let [drive] = &self.model.drives[..] else {
            if !self.model.drives.is_empty() {
                return Err(Refusal::bad("there are several drives").with_hint("choose their joints in the text"));
            }
            return self.add_motor(joint, start_rad);
        };
        self.set(&["drive", &drive.name, "joint"], &format!("\"{joint}\""))?;
        if self.model.quantities.id(&format!("drive.{}.start_angle", drive.name)).is_some() {
            self.set(&["drive", &drive.name, "start_angle"], &start)?;
        }
        self.added.insert(format!("drive.{}", drive.name));
        Ok(drive.name.clone())
    }

    /// A motor at a joint. A cycle of a mechanism that nothing has moved until now counts its turns.
    fn add_motor(&mut self, joint: &str, start_rad: f64) -> Result<String, Refusal> {
        let name = self.free_named("drive", MOTOR);
        let entries = [
            ("joint", format!("\"{joint}\"")),
            ("speed", FIRST_SPEED.to_owned()),
            ("start_angle", start_angle(start_rad)),
        ];
        self.table("drive", &name, "", &entries)?;
        let duration = ["cycle", "duration"];
        if self.model.controls.is_empty() && self.lines.value_span(&duration)?.is_some() {
            self.lines.remove(&[owned(&duration)])?;
            self.added.insert(duration.join("."));
            for (key, value) in [("drive", &*format!("\"{name}\"")), ("transient_turns", "1"), ("recorded_turns", "1")]
            {
                // The cycle of a motor that was taken out may still say how many turns.
                if self.lines.value_span(&["cycle", key])?.is_none() {
                    self.lines.add_entry(&["cycle"], key, value)?;
                }
            }
        }
        Ok(name)
    }

    /// An output.
    ///
    /// # Errors
    /// The text has no place for it, in words.
    pub fn watch(&mut self, what: &Watched) -> Result<String, Refusal> {
        let (name, entries) = output(what);
        let name = self.free_named("output", &name);
        self.table("output", &name, "", &entries)?;
        Ok(name)
    }

    fn set(&mut self, path: &[&str], value: &str) -> Result<(), Refusal> {
        let span = self.lines.value_span(path)?;
        let span = span.ok_or_else(|| Refusal::bad("this drive can be changed only in the text"))?;
        self.lines.replace([(span, value.to_owned())])
    }

    /// The point at an end, made where it is new.
    fn attach(&mut self, end: &End) -> Result<Attached, Refusal> {
        let is_near = |x: f64, y: f64| {
            let is_near = [x, y].iter().all(|mm| mm.is_finite() && mm.abs() <= FURTHEST_MM);
            if is_near { Ok(()) } else { Err(Refusal::bad("the place is further away than 10 km")) }
        };
        match end {
            End::Point { body, point } => {
                let id = self.point_id(body, point)?;
                let pose = self.poses.get(body).copied().unwrap_or_default();
                let at_m = pose.world_m(in_body_m(self.model, &self.values, id));
                Ok(Attached { point: Some(format!("{body}.{point}")), body: Some(body.clone()), at_m })
            }
            End::On { body, x, y, is_own } => {
                is_near(*x, *y)?;
                let pose = self.poses.get(body).copied();
                let pose = pose.ok_or_else(|| Refusal::bad(format!("body '{body}' no longer exists")))?;
                let given_m = [x / MM_PER_M, y / MM_PER_M];
                let (own_m, at_m) =
                    if *is_own { (given_m, pose.world_m(given_m)) } else { (pose.local_m(given_m), given_m) };
                let name = self.free_point(body);
                let [own_x, own_y] = own_m.map(|m| mm(m * MM_PER_M));
                let value = format!("[\"{own_x} mm\", \"{own_y} mm\"]");
                self.lines.add_entry(&["body", body, "points"], &name, &value)?;
                self.added.insert(format!("body.{body}.points.{name}"));
                Ok(Attached { point: Some(format!("{body}.{name}")), body: Some(body.clone()), at_m })
            }
            End::Free { x, y } => {
                is_near(*x, *y)?;
                Ok(Attached { point: None, body: None, at_m: [x / MM_PER_M, y / MM_PER_M] })
            }
        }
    }

    fn point_id(&self, body: &str, point: &str) -> Result<PointId, Refusal> {
        let bodies = &self.model.bodies;
        let found = bodies.iter().position(|one| one.name == body).and_then(|index| {
            let point = bodies[index].points.iter().position(|one| one.name == point)?;
            Some(PointId { body: loosepin::model::BodyId(index), point })
        });
        found.ok_or_else(|| Refusal::bad(format!("point '{body}.{point}' no longer exists")))
    }

    fn name_of(&self, point: PointId) -> String {
        let body = &self.model.bodies[point.body.0];
        format!("{}.{}", body.name, body.points[point.point].name)
    }

    fn revolute(&mut self, name: &str, bearing: &str, journal: &str) -> Result<(), Refusal> {
        let entries = [
            ("kind", "\"revolute\"".to_owned()),
            ("bearing", format!("\"{bearing}\"")),
            ("journal", format!("\"{journal}\"")),
        ];
        self.table("joint", name, "", &entries)
    }

    /// A new link lies as it was drawn: its loop may close in another way too.
    fn guess(&mut self, body: &str, pose: Pose) -> Result<(), Refusal> {
        self.place(body, pose);
        self.added.insert(format!("assembly.guess.{body}"));
        let value = format!("\"{} deg\"", degrees(pose.angle_rad.to_degrees()));
        self.lines.add_entry(&["assembly", "guess"], body, &value)
    }

    /// Where a new body lies.
    fn place(&mut self, body: &str, pose: Pose) {
        self.new_poses.insert(body.to_owned(), pose.for_page());
        self.poses.insert(body.to_owned(), pose);
    }

    fn entry(&mut self, table: &[&str], key: &str, value: &str) -> Result<(), Refusal> {
        self.added.insert(format!("{}.{key}", table.join(".")));
        self.lines.add_entry(table, key, value)
    }

    fn table(&mut self, group: &str, name: &str, comment: &str, entries: &[(&str, String)]) -> Result<(), Refusal> {
        self.added.insert(format!("{group}.{name}"));
        self.lines.add_table(group, name, comment, entries)
    }

    fn has(&self, group: &str, name: &str) -> bool {
        let path = format!("{group}.{name}");
        self.named.contains(&path) || self.model.quantities.id(&path).is_some() || self.added.contains(&path)
    }

    /// The first name with a number that is free.
    fn free(&self, group: &str, stem: &str) -> String {
        (1..).map(|number| format!("{stem}_{number}")).find(|name| !self.has(group, name)).unwrap_or_default()
    }

    fn free_named(&self, group: &str, name: &str) -> String {
        if self.has(group, name) { self.free(group, name) } else { name.to_owned() }
    }

    fn free_point(&self, body: &str) -> String {
        let points = self.model.bodies.iter().find(|one| one.name == body).map(|one| &one.points);
        let names: HashSet<&str> = points.into_iter().flatten().map(|point| point.name.as_str()).collect();
        let is_known = |name: &str| names.contains(name) || self.added.contains(&format!("body.{body}.points.{name}"));
        (1..).map(|number| format!("p{number}")).find(|name| !is_known(name)).unwrap_or_default()
    }
}

/// Paths of bodies, joints, outputs and drives.
fn named_in(model: &Model) -> HashSet<String> {
    let bodies = model.bodies.iter().map(|one| format!("body.{}", one.name));
    let joints = model.joints.iter().map(|one| format!("joint.{}", one.name));
    let outputs = model.outputs.iter().map(|one| format!("output.{}", one.name));
    let drives = model.drives.iter().map(|one| format!("drive.{}", one.name));
    bodies.chain(joints).chain(outputs).chain(drives).collect()
}

fn is_angle(degrees: f64) -> Result<(), Refusal> {
    if degrees.is_finite() && degrees.abs() <= 3600.0 {
        Ok(())
    } else {
        Err(Refusal::bad("the direction of a line is an angle of at most ten turns"))
    }
}

/// Thousandths of a millimetre are finer than any drawing.
fn mm(value: f64) -> String {
    format_number((value * 1e3).round() / 1e3 + 0.0)
}

fn start_angle(radians: f64) -> String {
    format!("\"{} deg\"", degrees(radians.to_degrees()))
}

/// From -180 to 180, in tenths of a millidegree.
fn degrees(angle: f64) -> String {
    let turned = angle - 360.0 * (angle / 360.0).round();
    format_number((turned * 1e4).round() / 1e4 + 0.0)
}
