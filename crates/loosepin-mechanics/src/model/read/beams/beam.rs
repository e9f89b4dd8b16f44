//! Flexible links.

use crate::model::part_reader::PartReader;
use crate::model::parts::beam::{Beam, Formulation};
use crate::model::parts::beam_problem::BeamProblem;
use crate::model::parts::topology::Body;
use crate::model::read::beams::beam_mass::{Line, LumpTable};
use crate::model::read::beams::section::{Section, SectionTable};
use crate::model::read::reader::ModelReader;
use loosepin_flexible::{Frame, Rule as IntegrationRule};
use loosepin_text::document::{Entry, Kind, choice, count, quantity};
use loosepin_text::numbers::{QuantityId, UNREAD};
use loosepin_text::units::{Dimension, Dimension as D, Op, Rule};
use loosepin_text::{choices, record};

/// Elements at most: their mass matrix is kept whole.
const MAX_ELEMENTS: u64 = 64;
/// Shapes of one kind, at most: 35 kHz of a rod of 0.3 m need four.
const MAX_SHAPES: u64 = 8;

choices!(
    /// The definition of the frame of a beam.
    pub(in crate::model) struct FrameChoice(Frame): "secant" => Frame::Secant, "tangent" => Frame::Tangent
);
choices!(
    /// How an element is integrated.
    pub(in crate::model) struct Integration(IntegrationRule):
        "full" => IntegrationRule::Full, "reduced" => IntegrationRule::Reduced
);
choices!(
    /// Whether a beam is in absolute nodal coordinates.
    pub(in crate::model) struct IsNodal(bool): "floating-frame" => false, "absolute-nodal" => true
);
choices!(
    /// Whether points inside of a beam have static shapes.
    pub(in crate::model) struct HasStaticShapes(bool): "at-points" => true, "none" => false
);
choices!(
    /// Whether a beam that bends becomes shorter.
    pub(in crate::model) struct Shortens(bool): "second-order" => true, "none" => false
);
choices!(
    /// Whether a beam starts bent as the forces hold it.
    pub(in crate::model) struct StartsSettled(bool): "undeformed" => false, "settled" => true
);

record! {
    /// a straight uniform beam between two points of the body, instead of mass, inertia and centre of mass
    pub(in crate::model) struct BeamTable for PartReader;
    /// point of the body at which the beam begins
    required from: Option<Entry<'t>> = Kind::Text, "\"big_end\"";
    /// point of the body at which it ends
    required to: Option<Entry<'t>> = Kind::Text, "\"small_end\"";
    /// cross-section of the beam; the height lies in the plane of motion
    required section: Option<SectionTable<'t>> =
        Kind::Table(&SectionTable::KEYS), "{ width = \"8 mm\", height = \"8 mm\" }";
    /// Young's modulus E
    required youngs_modulus: Option<Entry<'t>> = quantity(D::PRESSURE, Rule::Positive), "\"207 GPa\"";
    /// density
    required density: Option<Entry<'t>> = quantity(D::DENSITY, Rule::Positive), "\"7800 kg/m^3\"";
    /// floating frame: additional masses at points of the body, each under [body.NAME.beam.lumps.NAME]
    optional lumps: Entry<'t> = Kind::Tables { keys: &LumpTable::KEYS, except: &[] }, "";
    /// floating-frame: few mode shapes in a frame that moves with the body, for sections that rotate by less than 0.1 rad against it;
    /// absolute-nodal: elements whose nodes have position and slope as coordinates, for large bending
    optional formulation: Option<IsNodal> = choice::<IsNodal>(), "\"floating-frame\"", or "floating-frame";
    /// floating frame: damping ratio of every shape; none if omitted
    optional damping_ratio: Entry<'t> = quantity(D::NUMBER, Rule::NonNegative), "0.005";
    /// absolute nodal coordinates: number of elements
    optional elements: Option<usize> = count(1, MAX_ELEMENTS), "16", or 8;
    /// absolute nodal coordinates: integration points of each element for stretching and bending; full: 5 and 3; reduced: 3 and 2, so
    /// that a coarse mesh is less stiff
    optional integration: Option<Integration> = choice::<Integration>(), "\"full\"", or "full";
    /// absolute nodal coordinates: retardation time τ of the material; the damping ratio at ω is ωτ/2; no damping if omitted
    optional retardation_time: Entry<'t> = quantity(D::TIME, Rule::NonNegative), "\"1 us\"";
    /// floating frame: secant: the x axis of the frame goes through both ends; tangent: the frame turns with the section at from, which
    /// a drive or a rigid joint holds
    optional frame: Option<FrameChoice> = choice::<FrameChoice>(), "\"secant\"", or "secant";
    /// floating frame: number of bending shapes
    optional lateral_shapes: Option<usize> = count(0, MAX_SHAPES), "2", or 2;
    /// floating frame: number of stretching shapes, 0 for none
    optional axial_shapes: Option<usize> = count(0, MAX_SHAPES), "2", or 2;
    /// floating frame: at-points: one more shape of each kind for every inner point on which a joint, a spring, a load or a lump acts;
    /// none: only the shapes of the beam without such points
    optional static_shapes: Option<HasStaticShapes> = choice::<HasStaticShapes>(), "\"at-points\"", or "at-points";
    /// floating frame: frequency above which a shape is condensed. A condensed shape keeps its static flexibility, and its inertia is
    /// raised until it has this frequency, so that it needs no shorter steps; if omitted, no shape is condensed
    optional condense_above: Entry<'t> = quantity(D::FREQUENCY, Rule::Positive), "\"50 kHz\"";
    /// floating frame: second-order: bending shortens the beam, so that it stiffens when it rotates and can buckle; none: linear theory
    optional foreshortening: Option<Shortens> = choice::<Shortens>(), "\"second-order\"", or "second-order";
    /// state at the start: undeformed: straight and at rest in its frame, so that it vibrates afterwards; settled: deformed in equilibrium
    /// with inertia forces, weight and loads at the start
    optional start: Option<StartsSettled> = choice::<StartsSettled>(), "\"undeformed\"", or "undeformed";
}

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

impl ModelReader {
    /// Reads the beam of a body, which then gets its mass, its inertia and its centre of mass. The body stays rigid after a diagnostic.
    pub(in crate::model) fn beam(&mut self, entry: &Entry<'_>, body: &mut Body) {
        self.numbers.remember(entry);
        body.beam = BeamTable::read(self, entry).and_then(|own| self.beam_of(entry, &own, body));
    }

    fn beam_of(&mut self, entry: &Entry<'_>, own: &BeamTable<'_>, body: &mut Body) -> Option<Beam> {
        let table = &own.table;
        let [from, to] = [&own.from, &own.to].map(|entry| self.end(entry.as_ref()?, body));
        let section = own.section.as_ref().and_then(|section| self.section(section, &table.path));
        let lumps = own.lumps.as_ref().map(|entry| self.lumps(entry, body)).unwrap_or_default();
        let numbers =
            [&own.youngs_modulus, &own.density, &own.damping_ratio, &own.condense_above, &own.retardation_time];
        let [modulus_pa, density_kg_m3, damping_ratio, condense_above_hz, retardation_s] =
            numbers.map(|entry| self.numbers.quantity_at(entry.as_ref()?));
        let formulation = self.formulation(own);
        let (from, to, Section { area_m2, second_moment_m4, height_m }) = (from?, to?, section?);
        let (modulus_pa, density_kg_m3, formulation) = (modulus_pa?, density_kg_m3?, formulation?);
        let (lateral_shapes, axial_shapes, frame) = (own.lateral_shapes?, own.axial_shapes?, own.frame?);
        let (static_shapes, foreshortening, at_start) = (own.static_shapes?, own.foreshortening?, own.start?);
        let span_of_to = own.to.as_ref().map_or(entry.span, |entry| entry.span);
        let words = table.path.describe();
        if from == to {
            return self.numbers.reader.refuse(&BeamProblem::SamePoint { entry: words }, span_of_to);
        }
        if lateral_shapes + axial_shapes == 0 {
            return self.numbers.reader.refuse(&BeamProblem::NoShapes { entry: words }, entry.key_span);
        }

        let path = |key: &str| table.path.join(key).dotted();
        let [start, end] = [from, to].map(|end| body.points[end].position_m);
        let of_lumps = lumps.iter().flat_map(|lump| body.points[lump.point].position_m);
        if [start, end].into_iter().flatten().chain(of_lumps).any(|id| id == UNREAD) {
            return None;
        }
        let across = |axis: usize| [Op::Load(end[axis].0), Op::Load(start[axis].0), Op::Subtract];
        let square = |axis: usize| [across(axis).to_vec(), across(axis).to_vec(), vec![Op::Multiply]].concat();
        let ops = [square(0), square(1), vec![Op::Add, Op::SquareRoot]].concat();
        let length_m =
            self.numbers.derived(path("length"), Dimension::LENGTH, Rule::Positive, ops, &[start, end].concat());
        if let Err(problem) = self.numbers.quantities[length_m].check(self.numbers.quantities.nominal_value(length_m)) {
            return self.numbers.reader.refuse(&problem, span_of_to);
        }
        let load = |id: QuantityId| Op::Load(id.0);
        let over_length =
            |what: QuantityId| vec![load(modulus_pa), load(what), Op::Multiply, load(length_m), Op::Divide];
        let axial_stiffness_n_m = self.numbers.derived(
            path("axial_stiffness"),
            Dimension::SPRING_STIFFNESS,
            Rule::Positive,
            over_length(area_m2),
            &[modulus_pa, area_m2, length_m],
        );
        let bending_stiffness_n_m = self.numbers.derived(
            path("bending_stiffness"),
            Dimension::TORQUE,
            Rule::Positive,
            over_length(second_moment_m4),
            &[modulus_pa, second_moment_m4, length_m],
        );
        let ops = vec![load(density_kg_m3), load(area_m2), Op::Multiply, load(length_m), Op::Multiply];
        let reads = [density_kg_m3, area_m2, length_m];
        let own_mass = if lumps.is_empty() { format!("body.{}.mass", body.name) } else { path("mass") };
        let mass_kg = self.numbers.derived(own_mass, Dimension::MASS, Rule::Positive, ops, &reads);
        // Sizes that are allowed one by one may have products that no number holds.
        for id in [area_m2, second_moment_m4, axial_stiffness_n_m, bending_stiffness_n_m, mass_kg] {
            if let Err(problem) = self.numbers.quantities[id].check(self.numbers.quantities.nominal_value(id)) {
                let span = self.numbers.quantities[id].span.unwrap_or(entry.span);
                return self.numbers.reader.refuse(&problem, span);
            }
        }
        self.set_rigid_numbers(body, &Line { mass_kg, length_m, ends: [start, end] }, &lumps);
        Some(Beam {
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
            frame: frame.0,
            axial_shapes,
            lateral_shapes,
            has_static_shapes: static_shapes.0,
            condense_above_hz,
            foreshortening: foreshortening.0,
            formulation,
            retardation_s,
            starts_settled: at_start.0,
        })
    }

    /// The formulation of a beam; `None` after a diagnostic about a key that it does not have.
    fn formulation(&mut self, own: &BeamTable<'_>) -> Option<Formulation> {
        let (formulation, integration, elements) = (own.formulation?, own.integration?, own.elements?);
        let (others, word) = match formulation {
            IsNodal(true) => (&OF_FLOATING_FRAME[..], "floating-frame"),
            IsNodal(false) => (&OF_ABSOLUTE_NODAL[..], "absolute-nodal"),
        };
        let mut fits = true;
        for (key, found) in others.iter().filter_map(|key| Some((*key, own.table.get(key)?))) {
            let problem = BeamProblem::OfOtherFormulation { entry: own.table.path.describe(), key, formulation: word };
            self.numbers.reader.report(&problem, found.key_span);
            fits = false;
        }
        let nodal = Formulation::AbsoluteNodal { elements, rule: integration.0 };
        fits.then_some(if formulation.0 { nodal } else { Formulation::FloatingFrame })
    }

    /// Index of the point that an entry names.
    pub(in crate::model) fn end(&mut self, entry: &Entry<'_>, body: &Body) -> Option<usize> {
        let name = self.numbers.reader.text(entry)?;
        if let Some(index) = body.points.iter().position(|point| point.name == name) {
            return Some(index);
        }
        let problem = BeamProblem::NoSuchPoint {
            entry: entry.path.describe(),
            body: body.name.clone(),
            point: name.to_owned(),
            known: body.points.iter().map(|point| format!("'{}'", point.name)).collect(),
        };
        self.numbers.reader.refuse(&problem, entry.span)
    }
}
