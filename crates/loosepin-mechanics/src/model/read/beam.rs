//! Flexible links.

use super::beam_mass::Line;
use super::reader::ModelReader;
use crate::model::beam::{Beam, Formulation};
use crate::model::beam_problem::BeamProblem;
use crate::model::ids::{BodyId, JointId, PointId};
use crate::model::joint::AtBeam;
use crate::model::keys::beam::{BEAM_KEYS, SECTION_KEYS};
use crate::model::load::ActsOn;
use crate::model::quantity::{QuantityId, UNREAD};
use crate::model::topology::Body;
use loosepin_flexible::{Frame, Rule as IntegrationRule};
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, Table, describe_path};
use loosepin_text::units::{Dimension, Op, Rule};
use std::f64::consts::PI;

/// Shapes of each kind where the file says nothing: forces below the first fixed-fixed axial frequency need no more.
const DEFAULT_SHAPES: u64 = 2;

/// Elements where the file says nothing.
const DEFAULT_ELEMENTS: u64 = 8;

/// Keys that one formulation has and the other has not.
const OF_FLOATING_FRAME: [&str; 8] = [
    "lumps",
    "damping_ratio",
    "frame",
    "lateral_shapes",
    "axial_shapes",
    "static_shapes",
    "condense_above",
    "foreshortening",
];
const OF_ABSOLUTE_NODAL: [&str; 3] = ["elements", "integration", "retardation_time"];

/// A number that follows from others: its operations, and the quantities that they read.
type Derived = (Vec<Op>, Vec<QuantityId>);

/// The section of a beam.
struct Section {
    area_m2: QuantityId,
    second_moment_m4: QuantityId,
    height_m: Option<QuantityId>,
}

impl ModelReader {
    /// Reads the beam of a body, which then gets its mass, its inertia and its centre of mass. The body stays rigid after a complaint.
    pub(super) fn beam(&mut self, entry: &Entry<'_>, body: &mut Body) {
        self.remember(entry);
        let Some(table) = self.reader.table(entry, &BEAM_KEYS) else { return };
        let ends = ["from", "to"].map(|key| table.get(key).and_then(|entry| self.end(&entry, body)));
        let section = table.get("section").and_then(|entry| self.section(&entry, &table));
        let lumps = table.get("lumps").map(|entry| self.lumps(&entry, body)).unwrap_or_default();
        let modulus_pa = self.quantity(&table, "youngs_modulus");
        let density_kg_m3 = self.quantity(&table, "density");
        let damping_ratio = self.quantity(&table, "damping_ratio");
        let frames = [("secant", Frame::Secant), ("tangent", Frame::Tangent)];
        let frame = self.reader.choice_or(&table, "frame", &frames, Frame::Secant);
        let [lateral, axial] = ["lateral_shapes", "axial_shapes"].map(|key| match table.has(key) {
            true => self.reader.count(&table, key),
            false => Some(DEFAULT_SHAPES),
        });
        let statics = [("at-points", true), ("none", false)];
        let has_static_shapes = self.reader.choice_or(&table, "static_shapes", &statics, true);
        let condense_above_hz = self.quantity(&table, "condense_above");
        let forms = [("second-order", true), ("none", false)];
        let foreshortening = self.reader.choice_or(&table, "foreshortening", &forms, true);
        let starts = [("undeformed", false), ("settled", true)];
        let starts_settled = self.reader.choice_or(&table, "start", &starts, false);
        let retardation_s = self.quantity(&table, "retardation_time");
        let formulation = self.formulation(&table);
        let ([Some(from), Some(to)], Some(Section { area_m2, second_moment_m4, height_m })) = (ends, section) else {
            return;
        };
        let (Some(modulus_pa), Some(density_kg_m3)) = (modulus_pa, density_kg_m3) else { return };
        let (Some(frame), Some(lateral), Some(axial)) = (frame, lateral, axial) else { return };
        let (Some(foreshortening), Some(starts_settled)) = (foreshortening, starts_settled) else { return };
        let Some(formulation) = formulation else { return };
        let Some(has_static_shapes) = has_static_shapes else { return };
        let words = table.path.describe();
        if from == to {
            let span = table.get("to").map_or(entry.span, |entry| entry.span);
            self.reader.complain(&BeamProblem::SamePoint { entry: words }, span);
            return;
        }
        if lateral + axial == 0 {
            self.reader.complain(&BeamProblem::NoShapes { entry: words }, entry.key_span);
            return;
        }

        let path = |key: &str| table.path.join(key).dotted();
        let [start, end] = [from, to].map(|end| body.points[end].position_m);
        let of_lumps = lumps.iter().flat_map(|lump| body.points[lump.point].position_m);
        if [start, end].into_iter().flatten().chain(of_lumps).any(|id| id == UNREAD) {
            return;
        }
        let across = |axis: usize| [Op::Load(end[axis].0), Op::Load(start[axis].0), Op::Subtract];
        let square = |axis: usize| [across(axis).to_vec(), across(axis).to_vec(), vec![Op::Multiply]].concat();
        let ops = [square(0), square(1), vec![Op::Add, Op::SquareRoot]].concat();
        let length_m = self.derived(path("length"), Dimension::LENGTH, Rule::Positive, ops, &[start, end].concat());
        if let Err(problem) = self.quantities[length_m].check(self.quantities.nominal_value(length_m)) {
            self.reader.complain(&problem, table.get("to").map_or(entry.span, |entry| entry.span));
            return;
        }
        let load = |id: QuantityId| Op::Load(id.0);
        let over_length =
            |what: QuantityId| vec![load(modulus_pa), load(what), Op::Multiply, load(length_m), Op::Divide];
        let axial_stiffness_n_m = self.derived(
            path("axial_stiffness"),
            Dimension::SPRING_STIFFNESS,
            Rule::Positive,
            over_length(area_m2),
            &[modulus_pa, area_m2, length_m],
        );
        let bending_stiffness_n_m = self.derived(
            path("bending_stiffness"),
            Dimension::TORQUE,
            Rule::Positive,
            over_length(second_moment_m4),
            &[modulus_pa, second_moment_m4, length_m],
        );
        let ops = vec![load(density_kg_m3), load(area_m2), Op::Multiply, load(length_m), Op::Multiply];
        let reads = [density_kg_m3, area_m2, length_m];
        let own_mass = if lumps.is_empty() { format!("body.{}.mass", body.name) } else { path("mass") };
        let mass_kg = self.derived(own_mass, Dimension::MASS, Rule::Positive, ops, &reads);
        // Sizes that are allowed one by one may have products that no number holds.
        for id in [area_m2, second_moment_m4, axial_stiffness_n_m, bending_stiffness_n_m, mass_kg] {
            if let Err(problem) = self.quantities[id].check(self.quantities.nominal_value(id)) {
                let span = self.quantities[id].span.unwrap_or(entry.span);
                self.reader.complain(&problem, span);
                return;
            }
        }
        self.set_rigid_numbers(body, &Line { mass_kg, length_m, ends: [start, end] }, &lumps);
        body.beam = Some(Beam {
            ends: [from, to],
            mass_kg,
            lumps,
            length_m,
            area_m2,
            second_moment_m4,
            height_m,
            axial_stiffness_n_m,
            bending_stiffness_n_m,
            damping_ratio,
            frame,
            axial_shapes: axial as usize,
            lateral_shapes: lateral as usize,
            has_static_shapes,
            condense_above_hz,
            foreshortening,
            formulation,
            retardation_s,
            starts_settled,
        });
    }

    /// The formulation of a beam; nothing after a complaint about a key that it has not.
    fn formulation(&mut self, table: &Table<'_>) -> Option<Formulation> {
        let forms = [("floating-frame", false), ("absolute-nodal", true)];
        let is_nodal = self.reader.choice_or(table, "formulation", &forms, false)?;
        let rules = [("full", IntegrationRule::Full), ("reduced", IntegrationRule::Reduced)];
        let rule = self.reader.choice_or(table, "integration", &rules, IntegrationRule::Full)?;
        let elements = if table.has("elements") { self.reader.count(table, "elements")? } else { DEFAULT_ELEMENTS };
        let (others, formulation) = match is_nodal {
            true => (&OF_FLOATING_FRAME[..], "floating-frame"),
            false => (&OF_ABSOLUTE_NODAL[..], "absolute-nodal"),
        };
        let mut fits = true;
        for &key in others.iter().filter(|key| table.has(key)) {
            let problem = BeamProblem::OfOtherFormulation { entry: table.path.describe(), key, formulation };
            let span = table.get(key).map_or(table.span, |entry| entry.key_span);
            self.reader.complain(&problem, span);
            fits = false;
        }
        let nodal = Formulation::AbsoluteNodal { elements: elements as usize, rule };
        fits.then_some(if is_nodal { nodal } else { Formulation::FloatingFrame })
    }

    /// Index of the point that an entry names.
    pub(super) fn end(&mut self, entry: &Entry<'_>, body: &Body) -> Option<usize> {
        let name = self.reader.text(entry)?;
        if let Some(index) = body.points.iter().position(|point| point.name == name) {
            return Some(index);
        }
        let problem = BeamProblem::NoSuchPoint {
            entry: entry.path.describe(),
            body: body.name.clone(),
            point: name.to_owned(),
            known: body.points.iter().map(|point| format!("'{}'", point.name)).collect(),
        };
        self.reader.refuse(&problem, entry.span)
    }

    /// Area, second moment and height of the section.
    fn section(&mut self, entry: &Entry<'_>, beam: &Table<'_>) -> Option<Section> {
        let table = self.reader.table(entry, &SECTION_KEYS)?;
        let pairs = [("width", "height"), ("outer_diameter", "inner_diameter"), ("area", "second_moment")];
        for (first, second) in pairs {
            for (given, needs) in [(first, second), (second, first)] {
                if table.has(given) && !table.has(needs) && !table.has_unknown() {
                    let problem = BeamProblem::HalfSection { entry: table.path.describe(), given, needs };
                    let span = table.get(given).map_or(table.span, |entry| entry.key_span);
                    return self.reader.refuse(&problem, span);
                }
            }
        }
        let mut numbers = |first: &str, second: &str| {
            let [first, second] = [first, second].map(|key| self.quantity(&table, key));
            Some([first?, second?])
        };
        let power = |id: QuantityId, exponent: usize| {
            let mut ops = vec![Op::Load(id.0)];
            (1..exponent).for_each(|_| ops.extend([Op::Load(id.0), Op::Multiply]));
            ops
        };
        let times = |mut ops: Vec<Op>, factor: f64| {
            ops.extend([Op::Number(factor), Op::Multiply]);
            ops
        };
        let ([area, second_moment], height_m): ([Derived; 2], QuantityId) = if table.has("width") {
            let [width, height] = numbers("width", "height")?;
            let on = |exponent: usize| [vec![Op::Load(width.0)], power(height, exponent), vec![Op::Multiply]].concat();
            ([(on(1), vec![width, height]), (times(on(3), 1.0 / 12.0), vec![width, height])], height)
        } else if table.has("diameter") {
            let diameter = self.quantity(&table, "diameter")?;
            let of = |exponent: usize, factor: f64| (times(power(diameter, exponent), factor), vec![diameter]);
            ([of(2, PI / 4.0), of(4, PI / 64.0)], diameter)
        } else if table.has("outer_diameter") {
            let [outer, inner] = numbers("outer_diameter", "inner_diameter")?;
            let span = table.get("inner_diameter").map_or(table.span, |entry| entry.span);
            if !self.demand_order(inner, outer, span) {
                return None;
            }
            let of = |exponent: usize, factor: f64| {
                let difference = [power(outer, exponent), power(inner, exponent), vec![Op::Subtract]].concat();
                (times(difference, factor), vec![outer, inner])
            };
            ([of(2, PI / 4.0), of(4, PI / 64.0)], outer)
        } else {
            let [area_m2, second_moment_m4] = numbers("area", "second_moment")?;
            return Some(Section { area_m2, second_moment_m4, height_m: None });
        };
        let mut derived = |key: &str, dimension: Dimension, (ops, reads): Derived| {
            self.derived(beam.path.join(key).dotted(), dimension, Rule::Positive, ops, &reads)
        };
        Some(Section {
            area_m2: derived("area", Dimension::AREA, area),
            second_moment_m4: derived("second_moment", Dimension::SECOND_MOMENT, second_moment),
            height_m: Some(height_m),
        })
    }

    /// Complains about what a mechanism with flexible bodies cannot have.
    pub(super) fn refuse_beside_beams(&mut self) {
        let flexible: Vec<BodyId> =
            (1..self.bodies.len()).map(BodyId).filter(|body| self.bodies[body.0].beam.is_some()).collect();
        let Some(first) = flexible.first().map(|body| self.bodies[body.0].name.clone()) else { return };
        let mut found: Vec<(String, BeamProblem)> = Vec::new();
        for body in flexible {
            self.refuse_of_beam(body, &mut found);
        }
        let beside = |path: String| {
            let entry = describe_path(&path);
            (path, BeamProblem::Beside { entry, body: first.clone() })
        };
        let with_friction = self.joints.iter().filter(|joint| joint.friction.is_some());
        found.extend(with_friction.map(|joint| beside(format!("joint.{}", joint.name))));
        found.extend(self.couplings.iter().map(|coupling| beside(coupling.path.clone())));
        found.extend(self.controls.iter().map(|control| beside(format!("control.{}", control.name))));
        for (path, problem) in found {
            let span = self.span_of(&path);
            self.reader.complain(&problem, span);
        }
    }

    fn refuse_of_beam(&self, id: BodyId, found: &mut Vec<(String, BeamProblem)>) {
        let Body { name, points, beam: Some(beam), .. } = &self.bodies[id.0] else { return };
        let body = name.clone();
        let is_between = |index: &usize| beam.is_nodal() && !beam.ends.contains(index);
        for index in (0..points.len()).filter(is_between) {
            let path = format!("body.{name}.points.{}", points[index].name);
            found.push((path.clone(), BeamProblem::NodalPointBetween { entry: describe_path(&path) }));
        }
        let mut is_held = false;
        for (index, joint) in self.joints.iter().enumerate() {
            let Some(PointId { point, .. }) = joint.kind.points().into_iter().find(|point| point.body == id) else {
                continue;
            };
            let (path, body) = (format!("joint.{}", joint.name), body.clone());
            let entry = describe_path(&path);
            let is_driven = self.drives.iter().any(|drive| drive.joint == JointId(index));
            let holds = match joint.kind.at_beam() {
                AtBeam::Refused(kind) => {
                    found.push((path, BeamProblem::WrongJoint { entry, body, kind }));
                    continue;
                }
                AtBeam::Section => true,
                AtBeam::Point => is_driven,
            };
            if beam.is_nodal() {
                // Its sections have angles of their own at both ends.
                continue;
            }
            let is_at_from = point == beam.ends[0];
            match (holds, is_at_from, beam.frame) {
                (true, false, _) if point != beam.ends[1] => {
                    found.push((path, BeamProblem::HeldInside { entry, body }))
                }
                (true, false, _) => found.push((path, BeamProblem::HeldAtTo { entry, body })),
                (true, true, Frame::Secant) => found.push((path, BeamProblem::NeedsTangent { entry, body })),
                (true, true, Frame::Tangent) => is_held = true,
                (false, true, Frame::Tangent) => found.push((path, BeamProblem::NeedsSecant { entry, body })),
                (false, ..) => {}
            }
        }
        if beam.frame == Frame::Tangent && !is_held && found.is_empty() {
            let path = format!("body.{name}.beam");
            found.push((path.clone(), BeamProblem::NotHeld { entry: describe_path(&path) }));
        }
        let turn_of = |path: String| {
            let entry = describe_path(&path);
            (path, BeamProblem::TurnOf { entry, body: body.clone() })
        };
        for spring in &self.springs {
            if spring.kind.points().is_none() && spring.kind.bodies().contains(&id) {
                found.push(turn_of(format!("spring.{}", spring.name)));
            }
        }
        for load in &self.loads {
            let is_torque = load.kind.acts_on() == ActsOn::Body(id);
            let reads = load.joint.is_some_and(|joint| self.joints[joint.0].kind.bodies().contains(&id));
            if is_torque || reads {
                found.push(turn_of(format!("load.{}", load.name)));
            }
        }
    }

    /// Where something stands, or the table above it.
    fn span_of(&self, path: &str) -> Span {
        let mut path = path;
        loop {
            if let Some(span) = self.places.get(path) {
                return *span;
            }
            match path.rsplit_once('.') {
                Some((table, _)) => path = table,
                None => return Span::default(),
            }
        }
    }
}
