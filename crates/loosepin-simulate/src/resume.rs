//! State at the end of a run, from which another one can resume.

use crate::stepping::motion::Layout;
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample, SampleError};
use loosepin_mechanics::model::{Values, WearGeometry};
use loosepin_result::simulation::EndState;
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::format_apart;

/// Beginnings of the paths of quantities that no position follows from: they may differ from those of the run that is continued.
const FREE_PATHS: [&str; 4] = ["contact.", "gravity", "load.", "spring."];
/// Ends of such paths.
const FREE_KEYS: [&str; 2] = [".mass", ".inertia"];

problems! {
    /// Why a run cannot continue from the end of another one.
    #[derive(Debug, Clone, PartialEq)]
    pub enum StartProblem | Sample(SampleError) {
        /// The run has no state at its end.
        NoEndState { model: String } => Code::StartNotPossible,
            says("the run of '{model}' holds no state at its end"),
            hint("a run that failed, or that an older version made, cannot be continued: run it again");
        /// The quantities are those of another model.
        OtherModel { path: String, is_here: bool } => Code::StartNotPossible,
            says("the run is that of another model: only {} has '{path}'", if *is_here { "this one" } else { "that one" }),
            hint("a run can be continued with the model that it was made with");
        /// A quantity that positions follow from has another value.
        OtherValue { path: String, then: String, now: String } => Code::StartNotPossible,
            says("'{path}' is {now}, but {then} in the run that is continued"),
            hint("values of contacts, loads, springs, masses and gravity may differ; all others must be those of that run");
        /// The state has other numbers than the mechanism.
        OtherSize { what: &'static str, found: usize, needed: usize } => Code::StartNotPossible,
            says("the state has {found} {what}, the mechanism {needed}"),
            hint("a run can be continued with the model that it was made with");
        /// A contact has another name.
        OtherContact { found: String, needed: String } => Code::StartNotPossible,
            says("the state has a contact '{found}' where the mechanism has '{needed}'"),
            hint("a run can be continued with the model that it was made with");
        /// A number of the state is not finite.
        NotFinite { what: &'static str } => Code::StartNotPossible,
            says("the state holds a number that is not finite among its {what}"),
            hint("the file was changed: run the model again");
        /// The worn shape acts back.
        WornShape => Code::StartNotPossible,
            says("a run whose worn shape acts back starts from the initial state of its model"),
            hint("omit start, or use geometry = \"fixed\" in [wear]");
    }
}

/// Positions, velocities, deflections of bristles, integrals of the errors of controls and contact states at one instant: all that the motion after it depends on.
///
/// The speed at which a contact began belongs to it, since contact laws remember that speed. The root of a penetration does not:
/// a run that goes on reads the penetration off the positions until the next contact begins.
#[derive(Debug, Clone)]
pub struct MotionState {
    /// As [`Layout`] has it; roots of penetrations and the energy account are zero.
    pub(super) state: Vec<f64>,
    /// By contact.
    pub(super) contacts: Vec<PlayState<f64>>,
}

impl MotionState {
    /// Takes what the motion depends on out of `state`, which is that at `time_s`.
    pub(super) fn new(layout: &Layout, state: &[f64], time_s: f64, contacts: Vec<PlayState<f64>>) -> Self {
        let mut kept = vec![0.0; layout.length()];
        for place in Self::places(layout) {
            kept[place] = state[place];
        }
        kept[layout.time()] = time_s;
        Self { state: kept, contacts }
    }

    /// The state at the end of the run whose record holds `end`, for a run of `mechanism` with `values`.
    ///
    /// # Errors
    /// It does not fit: another model, other values, other numbers, or numbers that are not finite.
    pub fn of_record(mechanism: &Mechanism, values: &Values, end: &EndState) -> Result<Self, StartProblem> {
        if matches!(mechanism.model.wear.map(|life| life.geometry), Some(WearGeometry::Worn(_))) {
            return Err(StartProblem::WornShape);
        }
        check_values(mechanism, values, end)?;
        let sample = Sample::<f64>::new(mechanism, values)?;
        let layout = Layout::new(mechanism, &sample);
        let is_solved = mechanism.is_ideal();
        let freedoms = if is_solved { 0 } else { layout.freedoms };
        let bristles: Vec<usize> = layout.bristles.iter().chain(&layout.joint_bristles).flatten().copied().collect();
        let integrals: Vec<usize> = layout.error_integrals.iter().flatten().copied().collect();
        let numbers = [
            ("coordinates", &end.coordinates_si, freedoms),
            ("rates", &end.rates_si, freedoms),
            ("bristles", &end.bristles_si, if is_solved { 0 } else { bristles.len() }),
            ("integrals of controls", &end.error_integrals_si, if is_solved { 0 } else { integrals.len() }),
            ("speeds of contacts", &end.inverse_impact_speeds_s_m, end.contacts.len()),
            ("masses of contacts", &end.effective_masses_kg, end.contacts.len()),
        ];
        for (what, found, needed) in numbers {
            if found.len() != needed {
                return Err(StartProblem::OtherSize { what, found: found.len(), needed });
            }
            if !found.iter().all(|number| number.is_finite()) {
                return Err(StartProblem::NotFinite { what });
            }
        }
        if !(end.time_s.is_finite() && end.time_s >= 0.0) {
            return Err(StartProblem::NotFinite { what: "times" });
        }
        let names: Vec<String> = (0..mechanism.contacts.len()).map(|contact| mechanism.contact_name(contact)).collect();
        for (what, found) in [("contacts", end.contacts.len()), ("states of contacts", end.is_closed.len())] {
            if found != names.len() {
                return Err(StartProblem::OtherSize { what, found, needed: names.len() });
            }
        }
        if let Some((found, needed)) = end.contacts.iter().zip(names).find(|(found, needed)| *found != needed) {
            return Err(StartProblem::OtherContact { found: found.clone(), needed });
        }
        let mut state = vec![0.0; layout.length()];
        state[..freedoms].copy_from_slice(&end.coordinates_si);
        state[freedoms..2 * freedoms].copy_from_slice(&end.rates_si);
        state[layout.time()] = end.time_s;
        for (place, number) in
            bristles.iter().zip(&end.bristles_si).chain(integrals.iter().zip(&end.error_integrals_si))
        {
            state[*place] = *number;
        }
        let contact = |contact: usize| PlayState {
            contact: f64::from(u8::from(end.is_closed[contact])),
            inverse_impact_speed_s_m: end.inverse_impact_speeds_s_m[contact],
            effective_mass_kg: end.effective_masses_kg[contact],
        };
        Ok(Self { state, contacts: (0..end.contacts.len()).map(contact).collect() })
    }

    /// The record of the state `end` at `time_s`, which is `None` where the motion was solved, of a run of `mechanism` with `values`.
    pub(super) fn record(
        mechanism: &Mechanism,
        sample: &Sample<f64>,
        values: &Values,
        (end, time_s): (Option<&Self>, f64),
    ) -> EndState {
        let layout = Layout::new(mechanism, sample);
        let of = |places: &mut dyn Iterator<Item = usize>| -> Vec<f64> {
            end.map_or_else(Vec::new, |end| places.map(|place| end.state[place]).collect())
        };
        let open = vec![PlayState::flight(); mechanism.contacts.len()];
        let contacts = end.map_or(&open, |end| &end.contacts);
        let closed = |number: fn(&PlayState<f64>) -> f64| -> Vec<f64> {
            contacts.iter().map(|state| if state.contact > 0.0 { number(state) } else { 0.0 }).collect()
        };
        let n = layout.freedoms;
        let quantities = &mechanism.model.quantities;
        EndState {
            time_s,
            coordinates_si: of(&mut (0..n)),
            rates_si: of(&mut (n..2 * n)),
            bristles_si: of(&mut layout.bristles.iter().chain(&layout.joint_bristles).flatten().copied()),
            error_integrals_si: of(&mut layout.error_integrals.iter().flatten().copied()),
            contacts: (0..contacts.len()).map(|contact| mechanism.contact_name(contact)).collect(),
            is_closed: contacts.iter().map(|state| state.contact > 0.0).collect(),
            inverse_impact_speeds_s_m: closed(|state| state.inverse_impact_speed_s_m),
            effective_masses_kg: closed(|state| state.effective_mass_kg),
            paths: quantities.iter().map(|(_, quantity)| quantity.path.clone()).collect(),
            values_si: quantities.iter().map(|(id, _)| values[id]).collect(),
        }
    }

    /// When it is in a run of `sample`, s.
    pub(super) fn at_s(&self, mechanism: &Mechanism, sample: &Sample<f64>) -> f64 {
        self.time_s(&Layout::new(mechanism, sample))
    }

    /// When it is in a state of this layout, s.
    pub(super) fn time_s(&self, layout: &Layout) -> f64 {
        self.state[layout.time()]
    }

    /// Places of coordinates, rates, deflections of bristles and integrals of the errors of controls.
    pub(super) fn places(layout: &Layout) -> impl Iterator<Item = usize> + '_ {
        let further = layout.bristles.iter().chain(&layout.joint_bristles).chain(&layout.error_integrals);
        (0..layout.time()).chain(further.flatten().copied())
    }
}

/// Refuses a state of other quantities, or of other values of those that positions follow from.
fn check_values(mechanism: &Mechanism, values: &Values, end: &EndState) -> Result<(), StartProblem> {
    let quantities = &mechanism.model.quantities;
    if end.paths.len() != end.values_si.len() {
        let (found, needed) = (end.values_si.len(), end.paths.len());
        return Err(StartProblem::OtherSize { what: "values of quantities", found, needed });
    }
    let own: Vec<&str> = quantities.iter().map(|(_, quantity)| quantity.path.as_str()).collect();
    let other = |path: &str, is_here| StartProblem::OtherModel { path: path.to_owned(), is_here };
    if let Some(path) = own.iter().find(|path| !end.paths.iter().any(|known| known == *path)) {
        return Err(other(path, true));
    }
    for (path, &then_si) in end.paths.iter().zip(&end.values_si) {
        let Some((id, quantity)) = quantities.iter().find(|(_, quantity)| quantity.path == *path) else {
            return Err(other(path, false));
        };
        let is_free =
            FREE_PATHS.iter().any(|free| path.starts_with(free)) || FREE_KEYS.iter().any(|free| path.ends_with(free));
        if !is_free && values[id].to_bits() != then_si.to_bits() {
            let [then, now] = format_apart([then_si, values[id]], quantity.dimension);
            return Err(StartProblem::OtherValue { path: path.clone(), then, now });
        }
    }
    Ok(())
}
