//! Mass of flexible links: that of the straight beam, and lumps.

use crate::model::part_reader::PartReader;
use crate::model::parts::beam::LumpedMass;
use crate::model::parts::topology::Body;
use crate::model::read::reader::ModelReader;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Op, Rule};

record! {
    /// a mass at a point of a flexible body
    pub(in crate::model) struct LumpTable for PartReader;
    /// point of the body at the centre of mass of the lump; the lump turns with the section there
    required at: Option<Entry<'t>> = Kind::Text, "\"small_end\"";
    /// mass of the lump
    required mass: Option<QuantityId> = quantity(Dimension::MASS, Rule::NonNegative), "\"50 g\"";
    /// moment of inertia of the lump about its centre of mass; none if omitted
    optional inertia: Option<QuantityId> = quantity(Dimension::INERTIA, Rule::NonNegative), "\"2e-6 kg m^2\"";
}

/// A straight line of mass.
pub(in crate::model) struct Line {
    pub(in crate::model) mass_kg: QuantityId,
    pub(in crate::model) length_m: QuantityId,
    pub(in crate::model) ends: [[QuantityId; 2]; 2],
}

impl ModelReader {
    /// Mass, inertia and centre of mass of the body while it is straight: of a line of mass and its lumps.
    pub(in crate::model) fn set_rigid_numbers(&mut self, body: &mut Body, line: &Line, lumps: &[LumpedMass]) {
        let of_body = |key: &str| format!("body.{}.{key}", body.name);
        let load = |id: QuantityId| Op::Load(id.0);
        let Line { mass_kg: own_kg, length_m, ends: [start, end] } = *line;
        let middle = |axis: usize| [load(start[axis]), load(end[axis]), Op::Add, Op::Number(0.5), Op::Multiply];
        let about_middle = [load(own_kg), load(length_m), Op::Multiply, load(length_m), Op::Multiply]
            .into_iter()
            .chain([Op::Number(12.0), Op::Divide]);
        let mut mass_kg = own_kg;
        let mut reads = vec![own_kg, length_m];
        if !lumps.is_empty() {
            let mut ops = vec![load(own_kg)];
            ops.extend(lumps.iter().flat_map(|lump| [load(lump.mass_kg), Op::Add]));
            reads = [&[own_kg][..], &lumps.iter().map(|lump| lump.mass_kg).collect::<Vec<_>>()].concat();
            mass_kg = self.numbers.derived(of_body("mass"), Dimension::MASS, Rule::Positive, ops, &reads);
        }
        let points = lumps.iter().map(|lump| body.points[lump.point].position_m).collect::<Vec<_>>();
        let centre = [("x", 0), ("y", 1)].map(|(name, axis)| {
            let mut ops = middle(axis).to_vec();
            let mut reads = vec![start[axis], end[axis]];
            if !lumps.is_empty() {
                // Σ m r / Σ m.
                ops.extend([load(own_kg), Op::Multiply]);
                for (lump, point) in lumps.iter().zip(&points) {
                    ops.extend([load(lump.mass_kg), load(point[axis]), Op::Multiply, Op::Add]);
                    reads.extend([lump.mass_kg, point[axis]]);
                }
                ops.extend([load(mass_kg), Op::Divide]);
                reads.extend([own_kg, mass_kg]);
            }
            let path = of_body(&format!("centre_of_mass.{name}"));
            self.numbers.derived(path, Dimension::LENGTH, Rule::Finite, ops, &reads)
        });
        // J + m |r - c|² of each.
        let mut ops: Vec<Op> = about_middle.collect();
        if !lumps.is_empty() {
            reads.extend([length_m, start[0], start[1], end[0], end[1], centre[0], centre[1]]);
            let mut add = |inertia_kg_m2: Option<QuantityId>, mass_kg: QuantityId, at: [Vec<Op>; 2]| {
                ops.extend(inertia_kg_m2.into_iter().flat_map(|inertia| [load(inertia), Op::Add]));
                for (place, centre) in at.into_iter().zip(centre) {
                    let away = [place, vec![load(centre), Op::Subtract]].concat();
                    ops.extend(away.iter().chain(&away).copied());
                    ops.extend([Op::Multiply, load(mass_kg), Op::Multiply, Op::Add]);
                }
            };
            add(None, own_kg, [0, 1].map(|axis| middle(axis).to_vec()));
            for (lump, point) in lumps.iter().zip(&points) {
                add(lump.inertia_kg_m2, lump.mass_kg, point.map(|axis| vec![load(axis)]));
                reads.extend(lump.inertia_kg_m2.into_iter().chain(*point));
            }
        }
        let inertia = self.numbers.derived(of_body("inertia"), Dimension::INERTIA, Rule::Positive, ops, &reads);
        body.mass_kg = Some(mass_kg);
        body.inertia_kg_m2 = Some(inertia);
        body.centre_of_mass_m = Some(centre);
    }

    /// The lumps of a beam; those with a diagnostic are left out.
    pub(in crate::model) fn lumps(&mut self, entry: &Entry<'_>, body: &Body) -> Vec<LumpedMass> {
        let mut lumps = Vec::new();
        for entry in self.numbers.reader.named(entry, "a lump") {
            self.numbers.remember(&entry);
            let Some(LumpTable { at, mass, inertia, .. }) = LumpTable::read(self, &entry) else { continue };
            if let (Some(point), Some(mass_kg)) = (at.and_then(|entry| self.end(&entry, body)), mass) {
                lumps.push(LumpedMass {
                    name: entry.name.to_owned(),
                    point,
                    mass_kg,
                    inertia_kg_m2: inertia.flatten(),
                });
            }
        }
        lumps
    }
}
