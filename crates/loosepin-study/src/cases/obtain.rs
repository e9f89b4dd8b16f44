//! How each number is obtained.

use std::rc::Rc;

use super::case::{Case, CheckInstant, ExpectedNumber, History, ImpactNumber, Quantity, QuantityKind, Reduce};
use super::ideal::{ideal_output, quasi_static};
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::Values;
use loosepin_result::simulation::{ImpactRecord, JointSummary};
use loosepin_simulate::{Observer, Plan, Settings, Simulation, Step, Window, input, run, simulate};
use loosepin_text::diagnostics::{Diagnostics, Place};

/// The runs of a case, each made once.
pub(super) struct Runs<'c> {
    case: &'c Case,
    done: Vec<(RunKey, Rc<Simulation>)>,
}

/// Key of a run of a case.
#[derive(Debug, Clone, PartialEq)]
struct RunKey {
    settings: Vec<String>,
    span_s: f64,
    /// Rows of a history with the states of all bodies; 1 where only the end counts.
    rows: usize,
}

impl<'c> Runs<'c> {
    /// No run made yet.
    pub fn new(case: &'c Case) -> Self {
        Self { case, done: Vec::new() }
    }

    /// The number as the program has it, SI; NaN if the run has none.
    ///
    /// # Errors
    /// A run or the ideal motion fails.
    pub fn obtain(
        &mut self,
        quantity: &Quantity,
        number: &ExpectedNumber,
        index: usize,
        place: &Place,
    ) -> NumberResult {
        let case = self.case;
        match quantity.kind {
            QuantityKind::ContactOnset => self.of_impact(quantity, number, index, ImpactNumber::Onset),
            QuantityKind::ImpactSpeed => self.of_impact(quantity, number, index, ImpactNumber::Speed),
            QuantityKind::SeparationSpeed => self.of_impact(quantity, number, index, ImpactNumber::SeparationSpeed),
            QuantityKind::ImpactDuration => self.of_impact(quantity, number, index, ImpactNumber::Duration),
            QuantityKind::Contacts => self.of_joint(quantity, number, |joint| joint.contacts as f64),
            QuantityKind::PeakForce => self.of_joint(quantity, number, |joint| joint.peak_force_n),
            QuantityKind::LargestPenetration => self.of_joint(quantity, number, |joint| joint.largest_penetration_m),
            QuantityKind::ContactStiffness | QuantityKind::DeliveredRestitution => {
                let (mechanism, values) = self.compiled(&number.settings)?;
                let sample = Sample::<f64>::new(&mechanism, &values).map_err(|error| error.diagnostic(&case.model))?;
                let play = &sample.plays[quantity.play.unwrap_or(0)];
                let number = match quantity.kind {
                    QuantityKind::DeliveredRestitution => play.delivered_restitution,
                    _ => play.normal.stiffness().map(|(stiffness, _)| stiffness),
                };
                Ok(number.unwrap_or(f64::NAN))
            }
            QuantityKind::StaticForce => {
                let (mechanism, values) = self.compiled(&number.settings)?;
                let sample = Sample::<f64>::new(&mechanism, &values).map_err(|error| error.diagnostic(&case.model))?;
                let normal = &sample.plays[quantity.play.unwrap_or(0)].normal;
                let Some(CheckInstant::Penetration(penetration_m)) = number.at else { return Ok(f64::NAN) };
                Ok(normal.elastic_n(penetration_m))
            }
            QuantityKind::Output => self.output(quantity, number),
            QuantityKind::IdealOutput => {
                let (mechanism, values) = self.compiled(&number.settings)?;
                ideal_output(&mechanism, &values, quantity, number)
                    .map_err(|failure| failure.diagnostic(&case.model).into())
            }
            QuantityKind::WorstCase | QuantityKind::FirstOrderPlay | QuantityKind::DimensionalStandardDeviation => {
                let (mechanism, values) = self.compiled(&number.settings)?;
                Ok(quasi_static(case, &values, &mechanism, quantity, number, place)?)
            }
            QuantityKind::EnergyResidual => {
                Ok(self.run(&number.settings, quantity.span_s, 1)?.record.energy.relative_residual)
            }
            QuantityKind::ContactLoss | QuantityKind::FrictionLoss | QuantityKind::DriveWork => {
                let simulation = self.run(&number.settings, quantity.span_s, 1)?;
                let energy = &simulation.record.energy;
                let history = match quantity.kind {
                    QuantityKind::ContactLoss => &energy.contact_loss_j,
                    QuantityKind::FrictionLoss => &energy.friction_loss_j,
                    _ => &energy.supplied_j,
                };
                Ok(history.last().copied().unwrap_or(f64::NAN))
            }
            QuantityKind::LoopDrift => self.loop_drift(quantity, number),
        }
    }

    /// Numbers of the impacts of a joint in a run, of all its contacts, in the order of time.
    pub fn impacts(&self, simulation: &Simulation, play: usize, of: ImpactNumber) -> Vec<f64> {
        let mechanism = &self.case.mechanism;
        let names: Vec<String> = mechanism.contacts_of(play).map(|contact| mechanism.contact_name(contact)).collect();
        let number = |impact: &ImpactRecord| match of {
            ImpactNumber::Onset => impact.time_s,
            ImpactNumber::Speed => impact.speed_m_s,
            ImpactNumber::PeakForce => impact.peak_force_n,
            ImpactNumber::SeparationSpeed => impact.separation_speed_m_s.unwrap_or(f64::NAN),
            ImpactNumber::Duration => impact.duration_s,
        };
        simulation.record.impacts.iter().filter(|impact| names.contains(&impact.joint)).map(number).collect()
    }

    /// The run that a history is held against, with a row at each of its times.
    pub fn beside(&mut self, history: &History) -> Result<Rc<Simulation>, Diagnostics> {
        self.run(&[], history.reference.span_s(), history.reference.rows.len() - 1)
    }

    /// The run of the nominal mechanism over a span: one that was made already, whatever its rows.
    pub fn over(&mut self, span_s: f64) -> Result<Rc<Simulation>, Diagnostics> {
        self.run(&[], span_s, 1)
    }

    fn compiled(&self, settings: &[String]) -> Result<(Mechanism, Values), Diagnostics> {
        let model = &self.case.model;
        if settings.is_empty() {
            return Ok((self.case.mechanism.clone(), self.case.values.clone()));
        }
        let set = model.set_values(settings)?;
        let mechanism = Mechanism::new(model, &set.values).map_err(|error| error.diagnostic(model))?;
        Ok((mechanism, set.values))
    }

    /// A run from time zero. Where only its end counts, a run with more rows serves as well: rows do not change it.
    fn run(&mut self, settings: &[String], span_s: f64, rows: usize) -> Result<Rc<Simulation>, Diagnostics> {
        let key = RunKey { settings: settings.to_vec(), span_s, rows };
        let serves = |known: &RunKey| {
            known.settings == key.settings && known.span_s == span_s && (rows == 1 || known.rows == rows)
        };
        if let Some((_, simulation)) = self.done.iter().find(|(known, _)| serves(known)) {
            return Ok(Rc::clone(simulation));
        }
        let (mechanism, values) = self.compiled(settings)?;
        let model = &mechanism.model;
        let mut cycle = model.cycle.clone();
        let turn_s = input(&mechanism, &values, cycle.span).map_err(|failure| failure.diagnostic(model))?.turn_s();
        cycle.transient_turns = 0.0;
        cycle.recorded_turns = span_s / turn_s;
        cycle.samples_per_turn = ((rows as f64 / cycle.recorded_turns).round() as usize).max(1);
        let settings = Settings::for_simulation();
        let plan = Plan {
            cycle,
            settings,
            with_states: rows > 1,
            lyapunov_turns: None,
            second_run: false,
            overrides: Vec::new(),
        };
        let simulation = simulate(&mechanism, &values, &plan).map_err(|failure| failure.diagnostic(model))?;
        let simulation = Rc::new(simulation);
        self.done.push((key, Rc::clone(&simulation)));
        Ok(simulation)
    }

    /// A number of the impact of a joint at `index` in the list, or of the first one in a run with settings of its own.
    fn of_impact(
        &mut self,
        quantity: &Quantity,
        number: &ExpectedNumber,
        index: usize,
        of: ImpactNumber,
    ) -> NumberResult {
        let simulation = self.run(&number.settings, quantity.span_s, 1)?;
        let numbers = self.impacts(&simulation, quantity.play.unwrap_or(0), of);
        let index = if number.settings.is_empty() { index } else { 0 };
        Ok(numbers.get(index).copied().unwrap_or(f64::NAN))
    }

    fn of_joint(
        &mut self,
        quantity: &Quantity,
        number: &ExpectedNumber,
        read: impl Fn(&JointSummary) -> f64,
    ) -> NumberResult {
        let simulation = self.run(&number.settings, quantity.span_s, 1)?;
        Ok(simulation.record.joints.get(quantity.play.unwrap_or(0)).map_or(f64::NAN, read))
    }

    fn output(&mut self, quantity: &Quantity, number: &ExpectedNumber) -> NumberResult {
        let name = quantity.column.as_ref().map(|column| column.name.clone()).unwrap_or_default();
        let span_s = match number.at {
            Some(CheckInstant::Time(time_s)) => time_s,
            _ => quantity.span_s,
        };
        let simulation = self.run(&number.settings, span_s, 1)?;
        let record = &simulation.record;
        let Some(reduce) = quantity.reduce else {
            let history = record.outputs.iter().find(|output| output.name == name);
            return Ok(history.and_then(|history| history.value_si.last()).copied().unwrap_or(f64::NAN));
        };
        let Some(extreme) = record.extremes.iter().find(|extreme| extreme.name == name && extreme.of.is_value()) else {
            return Ok(f64::NAN);
        };
        Ok(match reduce {
            Reduce::Minimum => extreme.minimum.value_si,
            Reduce::Maximum => extreme.maximum.value_si,
            Reduce::AngleOfMinimum => extreme.minimum.drive_angle_rad,
            Reduce::AngleOfMaximum => extreme.maximum.drive_angle_rad,
        })
    }

    fn loop_drift(&mut self, quantity: &Quantity, number: &ExpectedNumber) -> NumberResult {
        let (mechanism, values) = self.compiled(&number.settings)?;
        let sample = Sample::new(&mechanism, &values).map_err(|error| error.diagnostic(&mechanism.model))?;
        let window = Window { start_s: 0.0, end_s: quantity.span_s };
        let mut drift = Drift { largest: 0.0 };
        run(&mechanism, &sample, &window, &Settings::for_simulation(), &mut drift)
            .map_err(|failure| failure.diagnostic(&mechanism.model))?;
        Ok(drift.largest)
    }
}

/// A number, or why there is none.
pub(super) type NumberResult = Result<f64, Diagnostics>;

/// Largest residual of the loops of ideal joints at the ends of all steps and between them.
struct Drift {
    largest: f64,
}

impl Observer for Drift {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        for share in [0.0, 0.3, 0.7, 1.0] {
            let dynamics = step.set_state(step.start_s + share * (step.end_s - step.start_s));
            let mut residuals = vec![0.0; dynamics.mechanism().real.constraint_rows()];
            dynamics.constraint_residuals(&mut residuals);
            self.largest = residuals.iter().fold(self.largest, |largest, residual| largest.max(residual.abs()));
        }
    }
}
