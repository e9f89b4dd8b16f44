//! Sections of flexible links.

use crate::model::part_reader::PartReader;
use crate::model::parts::beam_problem::BeamProblem;
use crate::model::read::reader::ModelReader;
use loosepin_text::document::{Entry, EntryPath, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Op, Rule};
use std::f64::consts::PI;

record! {
    /// the cross-section of a beam: width and height, diameter, outer and inner diameter, or area and second moment
    pub(in crate::model) struct SectionTable for PartReader,
        exactly one of [width, diameter, outer_diameter, area],
        exactly one of [height, diameter, inner_diameter, second_moment];
    /// width across the plane of motion
    optional width: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"8 mm\"";
    /// height in the plane of motion
    optional height: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"8 mm\"";
    /// diameter of a round rod
    optional diameter: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"8 mm\"";
    /// outer diameter of a tube
    optional outer_diameter: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// inner diameter of a tube
    optional inner_diameter: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"7 mm\"";
    /// area A
    optional area: Entry<'t> = quantity(D::AREA, Rule::Positive), "\"64 mm^2\"";
    /// second moment of area I about the axis across the plane of motion
    optional second_moment: Entry<'t> = quantity(D::SECOND_MOMENT, Rule::Positive), "\"341 mm^4\"";
}

/// A number that follows from others: its operations, and the quantities that they read.
type Derived = (Vec<Op>, Vec<QuantityId>);

/// The section of a beam.
pub(in crate::model) struct Section {
    pub(in crate::model) area_m2: QuantityId,
    pub(in crate::model) second_moment_m4: QuantityId,
    pub(in crate::model) height_m: Option<QuantityId>,
}

impl ModelReader {
    /// Area, second moment and height of the section of the beam at `beam`.
    pub(in crate::model) fn section(&mut self, own: &SectionTable<'_>, beam: &EntryPath) -> Option<Section> {
        let pairs = [
            (("width", &own.width), ("height", &own.height)),
            (("outer_diameter", &own.outer_diameter), ("inner_diameter", &own.inner_diameter)),
            (("area", &own.area), ("second_moment", &own.second_moment)),
        ];
        for (first, second) in pairs {
            for ((given, entry), (needs, needed)) in [(first, second), (second, first)] {
                if let (Some(entry), None, false) = (entry, needed, own.table.has_unknown()) {
                    let problem = BeamProblem::HalfSection { entry: own.table.path.describe(), given, needs };
                    return self.numbers.reader.refuse(&problem, entry.key_span);
                }
            }
        }
        let mut numbers = |first: &Entry<'_>, second: &Option<Entry<'_>>| {
            let (first, second) = (self.numbers.quantity_at(first), self.numbers.quantity_at(second.as_ref()?));
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
        let ([area, second_moment], height_m): ([Derived; 2], QuantityId) = if let Some(width) = &own.width {
            let [width, height] = numbers(width, &own.height)?;
            let on = |exponent: usize| [vec![Op::Load(width.0)], power(height, exponent), vec![Op::Multiply]].concat();
            ([(on(1), vec![width, height]), (times(on(3), 1.0 / 12.0), vec![width, height])], height)
        } else if let Some(diameter) = &own.diameter {
            let diameter = self.numbers.quantity_at(diameter)?;
            let of = |exponent: usize, factor: f64| (times(power(diameter, exponent), factor), vec![diameter]);
            ([of(2, PI / 4.0), of(4, PI / 64.0)], diameter)
        } else if let Some(outer) = &own.outer_diameter {
            let [outer, inner] = numbers(outer, &own.inner_diameter)?;
            let span = own.inner_diameter.as_ref().map_or(own.table.span, |entry| entry.span);
            if !self.numbers.demand_order(inner, outer, span) {
                return None;
            }
            let of = |exponent: usize, factor: f64| {
                let difference = [power(outer, exponent), power(inner, exponent), vec![Op::Subtract]].concat();
                (times(difference, factor), vec![outer, inner])
            };
            ([of(2, PI / 4.0), of(4, PI / 64.0)], outer)
        } else {
            let [area_m2, second_moment_m4] = numbers(own.area.as_ref()?, &own.second_moment)?;
            return Some(Section { area_m2, second_moment_m4, height_m: None });
        };
        let mut derived = |key: &str, dimension: Dimension, (ops, reads): Derived| {
            self.numbers.derived(beam.join(key).dotted(), dimension, Rule::Positive, ops, &reads)
        };
        Some(Section {
            area_m2: derived("area", Dimension::AREA, area),
            second_moment_m4: derived("second_moment", Dimension::SECOND_MOMENT, second_moment),
            height_m: Some(height_m),
        })
    }
}
