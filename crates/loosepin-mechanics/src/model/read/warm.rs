//! Parts that are warmer than their drawing: every length of a body with a coefficient of expansion α grows by the share
//! ε = α ΔT, holes and pins too.

use super::reader::ModelReader;
use crate::model::ids::BodyId;
use crate::model::part_reader::PartReader;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Op, Rule};

/// Times a clearance above zero it is above 1.
const LARGE_1_M: f64 = 1e300;

record! {
    /// thermal expansion of a part
    pub(super) struct ThermalTable for PartReader;
    /// coefficient of thermal expansion, for all lengths of the part; needs temperature_rise, here or at the top level
    optional thermal_expansion: Entry<'t> = quantity(Dimension::THERMAL_EXPANSION, Rule::Finite), "\"11.7e-6 1/K\"";
    /// temperature of the part above the temperature of its drawing; the value at the top level if omitted
    optional temperature_rise: Entry<'t> = quantity(Dimension::TEMPERATURE, Rule::Finite), "\"60 K\"";
}

impl ModelReader {
    /// The elongation ε = α ΔT of a body that states α; ΔT is its own `temperature_rise`, or that of the model.
    pub(super) fn elongation(&mut self, own: &ThermalTable<'_>) -> Option<QuantityId> {
        const EXPANSION: &str = "thermal_expansion";
        const RISE: &str = "temperature_rise";
        let has_own_rise = own.temperature_rise.is_some();
        let [expansion, own_rise] = [&own.thermal_expansion, &own.temperature_rise]
            .map(|entry| entry.as_ref().and_then(|entry| self.numbers.quantity_at(entry)));
        let needs = match (own.thermal_expansion.is_some(), has_own_rise || self.has_temperature_rise) {
            (true, false) => Some([EXPANSION, RISE]),
            (false, _) if has_own_rise => Some([RISE, EXPANSION]),
            _ => None,
        };
        if let Some([key, needed]) = needs {
            self.numbers.report_missing(&own.table, key, vec![needed]);
            return None;
        }
        let (expansion, rise_k) = (expansion?, own_rise.or(self.temperature_rise_k)?);
        let ops = vec![Op::Load(expansion.0), Op::Load(rise_k.0), Op::Multiply];
        self.uses_temperature_rise |= !has_own_rise;
        let path = own.table.path.join("elongation").dotted();
        let elongation = self.numbers.derived(path, Dimension::NUMBER, Rule::Finite, ops, &[expansion, rise_k]);
        self.numbers.quantities.add_elongation(elongation);
        Some(elongation)
    }

    /// A length of a part with the elongation ε: L (1 + ε).
    pub(super) fn thermally_expanded(&mut self, length: QuantityId, elongation: Option<QuantityId>) -> QuantityId {
        self.thermally_scaled(length, elongation, 1)
    }

    /// Quantities that scale with the `power`-th power of a length: L (1 + ε), J (1 + ε)².
    pub(super) fn thermally_scaled(
        &mut self,
        own: QuantityId,
        elongation: Option<QuantityId>,
        power: usize,
    ) -> QuantityId {
        let Some(elongation) = elongation else { return own };
        let mut ops = vec![Op::Load(own.0)];
        for _ in 0..power {
            ops.extend([Op::Number(1.0), Op::Load(elongation.0), Op::Add, Op::Multiply]);
        }
        let quantity = &self.numbers.quantities[own];
        let (path, dimension, rule) = (format!("{}_when_warm", quantity.path), quantity.dimension, quantity.rule);
        let span = quantity.span;
        let id = self.numbers.derived(path, dimension, rule, ops, &[own, elongation]);
        if let (Err(problem), Some(span)) =
            (self.numbers.quantities[id].check(self.numbers.quantities.nominal_value(id)), span)
        {
            self.numbers.reader.report(&problem, span);
        }
        id
    }

    /// The clearance of a pin joint, slot or guide whose outer part has the size `outer` at the drawing's temperature, and both
    /// parts in it. With R the radius (or half the height) of the hole and c the clearance, R (1 + ε_i) - (R - c)(1 + ε_j) is
    ///
    /// ```text
    /// c (1 + ε_j) + R (ε_i - ε_j)
    /// ```
    ///
    /// A clearance that is stated as zero makes the joint ideal, warm or cold.
    pub(super) fn warm_clearance(
        &mut self,
        clearance: QuantityId,
        outer: &[QuantityId],
        [bearing, journal]: [BodyId; 2],
        span: Span,
    ) -> Option<QuantityId> {
        let elongations = [bearing, journal].map(|body| self.elongations.get(&body).copied());
        if elongations == [None; 2] {
            return Some(clearance);
        }
        let load = |elongation: Option<QuantityId>| elongation.map_or(Op::Number(0.0), |id| Op::Load(id.0));
        let [of_bearing, of_journal] = elongations.map(load);
        let mut ops = vec![Op::Load(clearance.0), Op::Number(1.0), of_journal, Op::Add, Op::Multiply];
        ops.push(Op::Number(0.0));
        for size in outer {
            ops.extend([Op::Load(size.0), Op::Add]);
        }
        ops.extend([of_bearing, of_journal, Op::Subtract, Op::Multiply]);
        // 0 where c is zero, 1 where it is above.
        ops.extend([Op::Load(clearance.0), Op::Number(LARGE_1_M), Op::Multiply, Op::Number(1.0), Op::Minimum]);
        ops.extend([Op::Multiply, Op::Add]);
        let path = format!("{}_when_warm", self.numbers.quantities[clearance].path);
        let reads: Vec<QuantityId> =
            outer.iter().copied().chain([clearance]).chain(elongations.into_iter().flatten()).collect();
        let id = self.numbers.derived(path, Dimension::LENGTH, Rule::NonNegative, ops, &reads);
        self.numbers.quantities.add_warm(id, clearance);
        match self.numbers.quantities[id].check(self.numbers.quantities.nominal_value(id)) {
            Ok(()) => Some(id),
            Err(problem) => self.numbers.reader.refuse(&problem, span),
        }
    }
}
