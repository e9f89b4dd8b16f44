//! The mechanism on the rig: which inputs are its plays, and what else is not known of it.

use super::error::IdentifyProblem;
use loosepin_mechanics::mechanism::{Mechanism, Sample, SampleError};
use loosepin_mechanics::model::{QuantityId, Values};
use loosepin_simulate::accuracy::{AccuracyError, dimension_direction};
use loosepin_study::{EpistemicSubject, RandomInput, Study};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use loosepin_text::document::parse_toml;
use loosepin_text::units::SiUnit;
use loosepin_uncertainty::EpistemicVariable;

/// Share by which clearances may miss a straight line: round-off of their expressions.
const STRAIGHT: f64 = 1e-9;

/// Inputs that are no play of which all corners are looked at, at most.
pub(crate) const ALL_CORNERS: usize = 6;

/// An input that clearances follow from.
#[derive(Debug, Clone)]
pub(crate) struct PlayInput {
    pub path: String,
    /// The joint, where only one has its clearance from it; else the path.
    pub name: String,
    pub quantity: QuantityId,
    /// Interval of the study; of a random input the one that holds it with its share of the confidence.
    pub interval_si: [f64; 2],
    pub unit: SiUnit,
    /// Whether it is a plain interval of the study.
    pub is_interval: bool,
}

/// An input that is no play: a length, a stiffness, a coefficient of friction.
#[derive(Debug, Clone)]
pub(crate) struct OtherInput {
    pub path: String,
    pub quantity: QuantityId,
    pub interval_si: [f64; 2],
    pub unit: SiUnit,
    pub is_random: bool,
}

/// The mechanism with its inputs and their bounds.
#[derive(Debug)]
pub(crate) struct Rig<'s> {
    pub study: &'s Study,
    pub mechanism: Mechanism,
    /// All inputs in the middle.
    middle: Vec<(QuantityId, f64)>,
    pub values: Values,
    pub plays: Vec<PlayInput>,
    pub others: Vec<OtherInput>,
    /// Clearance of each joint with play where all play inputs are zero, m, and its slopes over them.
    pub clearances: Vec<Clearance>,
    /// The same mechanism with the other contact laws that are possible.
    pub other_laws: Vec<Mechanism>,
}

/// The clearance of a joint with play: offset + Σ slope · play input, and what other inputs may add or take.
#[derive(Debug, Clone)]
pub(crate) struct Clearance {
    pub offset_m: f64,
    pub slopes: Vec<f64>,
    pub spread_m: f64,
}

impl<'s> Rig<'s> {
    /// Lays out a study; `random_share` is the probability with which a random input may lie outside its interval.
    ///
    /// # Errors
    /// No play among the inputs, or one that is a dimension as well; a mechanism that drives do not move alone.
    pub fn new(study: &'s Study, random_share: f64) -> Result<Self, Diagnostics> {
        let model = study.model.demand_planar()?;
        let (mut plays, mut others, mut middle) = (Vec::new(), Vec::new(), Vec::new());
        for input in &study.epistemic {
            let Some(quantity) = input.quantity() else { continue };
            let interval_si = input.variable.ends();
            middle.push((quantity, 0.5 * (interval_si[0] + interval_si[1])));
            let is_interval = matches!(input.variable, EpistemicVariable::Interval(_));
            push_input(study, &input.path, quantity, interval_si, is_interval, false, (&mut plays, &mut others));
        }
        for input in &study.random {
            let Some(quantity) = input.quantity() else { continue };
            let interval_si = holding(input, study, random_share);
            middle.push((quantity, 0.5 * (interval_si[0] + interval_si[1])));
            push_input(study, &input.path, quantity, interval_si, false, true, (&mut plays, &mut others));
        }
        if plays.is_empty() {
            let place = Place::new(study.source(), place_of_table(study, "epistemic"));
            return Err(Diagnostic::error(&IdentifyProblem::NoPlay, Some(place)).into());
        }
        let at = |error| Diagnostics::one(&IdentifyProblem::Values { error }, None);
        let values = model.quantities.evaluate(&middle).map_err(at)?;
        let mechanism = Mechanism::new(model, &values).map_err(|error| error.diagnostic(model))?;
        if let Some(body) = mechanism.real.flexible_bodies().next() {
            let body = model.bodies[body.0].name.clone();
            let place = model.place(&format!("body.{body}"));
            return Err(Diagnostic::error(&IdentifyProblem::Flexible { body }, place).into());
        }
        if !mechanism.is_driven() {
            return Err(AccuracyError::NotDriven.diagnostic(model).into());
        }
        let mut rig =
            Self { study, mechanism, middle, values, plays, others, clearances: Vec::new(), other_laws: Vec::new() };
        rig.refuse_what_is_not_covered()?;
        rig.clearances = rig.clearances()?;
        rig.other_laws = rig.other_laws()?;
        Ok(rig)
    }

    /// The values of the model with some inputs elsewhere than in the middle.
    pub fn values_with(&self, changes: &[(QuantityId, f64)]) -> Result<Values, AccuracyError> {
        let mut set = self.middle.clone();
        for &(quantity, value_si) in changes {
            match set.iter_mut().find(|(known, _)| *known == quantity) {
                Some(known) => known.1 = value_si,
                None => set.push((quantity, value_si)),
            }
        }
        Ok(self.mechanism.model.quantities.evaluate(&set)?)
    }

    /// Values at which a quantity that does not depend on the pose is evaluated: each input that is no play alone at both ends, then all
    /// corners of up to six of them.
    pub fn other_values(&self) -> Result<(Vec<[Values; 2]>, Vec<Values>), AccuracyError> {
        let end = |other: &OtherInput, which: usize| (other.quantity, other.interval_si[which]);
        let mut alone = Vec::new();
        for other in &self.others {
            alone.push([self.values_with(&[end(other, 0)])?, self.values_with(&[end(other, 1)])?]);
        }
        let mut together = Vec::new();
        if self.others.len() <= ALL_CORNERS {
            for bits in 0..1_usize << self.others.len() {
                let changes = self.others.iter().enumerate().map(|(input, other)| end(other, (bits >> input) & 1));
                together.push(self.values_with(&changes.collect::<Vec<_>>())?);
            }
        }
        Ok((alone, together))
    }

    /// Clearances of the joints with play at values of the play inputs, m.
    pub fn clearances_m(&self, plays_si: &[f64]) -> Vec<f64> {
        let of = |clearance: &Clearance| {
            clearance.offset_m + clearance.slopes.iter().zip(plays_si).map(|(slope, play)| slope * play).sum::<f64>()
        };
        self.clearances.iter().map(of).collect()
    }

    /// The intervals of the play inputs as the study has them, SI.
    pub fn intervals_si(&self) -> Vec<[f64; 2]> {
        self.plays.iter().map(|play| play.interval_si).collect()
    }

    /// Least and largest clearance of each joint with play in a box of the play inputs, m.
    pub fn clearance_ends_m(&self, plays_si: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let of = |clearance: &Clearance| {
            let products = || clearance.slopes.iter().zip(plays_si).map(|(slope, ends)| ends.map(|end| slope * end));
            [
                clearance.offset_m - clearance.spread_m + products().map(|[a, b]| a.min(b)).sum::<f64>(),
                clearance.offset_m + clearance.spread_m + products().map(|[a, b]| a.max(b)).sum::<f64>(),
            ]
        };
        self.clearances.iter().map(of).collect()
    }

    /// All corners of a box of the play inputs; of many inputs those in which all but one are at the same end.
    pub fn corners(ends: &[[f64; 2]]) -> Vec<Vec<f64>> {
        let at = |pick: &dyn Fn(usize) -> usize| (0..ends.len()).map(|input| ends[input][pick(input)]).collect();
        const ALL: usize = 5;
        if ends.len() <= ALL {
            return (0..1_usize << ends.len()).map(|bits| at(&|input| (bits >> input) & 1)).collect();
        }
        let mut corners: Vec<Vec<f64>> = vec![at(&|_| 0), at(&|_| 1)];
        for odd in 0..ends.len() {
            corners.push(at(&|input| usize::from(input == odd)));
            corners.push(at(&|input| usize::from(input != odd)));
        }
        corners
    }

    fn refuse_what_is_not_covered(&self) -> Result<(), Diagnostics> {
        let model = &self.mechanism.model;
        let sample = Sample::<f64>::new(&self.mechanism, &self.values).map_err(|error| error.diagnostic(model))?;
        for (play, id) in sample.plays.iter().zip(&self.mechanism.plays) {
            if play.shape.may_lift() {
                let problem = IdentifyProblem::LiftOff { play: model.play_words(*id) };
                return Err(Diagnostics::one(&problem, None));
            }
        }
        for play in &self.plays {
            let direction = dimension_direction(&self.mechanism, &self.values, play.quantity)
                .map_err(|error| error.diagnostic(model))?;
            if !direction.leaves_motion_alone(&self.mechanism) {
                return Err(
                    self.diagnostic(&play.path, &IdentifyProblem::PlayMovesGeometry { path: play.path.clone() })
                );
            }
        }
        Ok(())
    }

    fn clearances(&self) -> Result<Vec<Clearance>, Diagnostics> {
        let model = &self.mechanism.model;
        let at = |changes: &[(QuantityId, f64)]| -> Result<Vec<f64>, Diagnostics> {
            let values = self.values_with(changes).map_err(|error| error.diagnostic(model))?;
            clearances_of(&self.mechanism, &values).map_err(|error| error.diagnostic(model).into())
        };
        let end = |which: usize| -> Vec<(QuantityId, f64)> {
            self.plays.iter().map(|play| (play.quantity, play.interval_si[which])).collect()
        };
        let (lowest, highest) = (at(&end(0))?, at(&end(1))?);
        let mut clearances: Vec<Clearance> =
            lowest.iter().map(|&offset_m| Clearance { offset_m, slopes: Vec::new(), spread_m: 0.0 }).collect();
        for play in &self.plays {
            let mut changes = end(0);
            changes.push((play.quantity, play.interval_si[1]));
            let width = play.interval_si[1] - play.interval_si[0];
            let raised = at(&changes)?;
            for ((clearance, raised), lowest) in clearances.iter_mut().zip(raised).zip(&lowest) {
                let slope = (raised - lowest) / width;
                clearance.offset_m -= slope * play.interval_si[0];
                clearance.slopes.push(slope);
            }
            // Half-way up, and at the far corner, they must lie on the straight line.
            changes.push((play.quantity, 0.5 * (play.interval_si[0] + play.interval_si[1])));
            let half = at(&changes)?;
            let is_straight = (0..half.len()).all(|k| {
                let expected = lowest[k] + 0.5 * width * clearances[k].slopes.last().copied().unwrap_or(0.0);
                (half[k] - expected).abs() <= STRAIGHT * highest[k].max(lowest[k])
            });
            if !is_straight {
                return Err(self.diagnostic(&play.path, &IdentifyProblem::PlayNotLinear { path: play.path.clone() }));
            }
        }
        let tops: Vec<f64> = self.plays.iter().map(|play| play.interval_si[1]).collect();
        for (k, clearance) in clearances.iter().enumerate() {
            let top_m = clearance.offset_m + clearance.slopes.iter().zip(&tops).map(|(s, top)| s * top).sum::<f64>();
            if (top_m - highest[k]).abs() > STRAIGHT * highest[k]
                && let Some(play) = self.plays.first()
            {
                return Err(self.diagnostic(&play.path, &IdentifyProblem::PlayNotLinear { path: play.path.clone() }));
            }
        }
        let middle = at(&[])?;
        for other in &self.others {
            for end_si in other.interval_si {
                let moved = at(&[(other.quantity, end_si)])?;
                for ((clearance, moved), middle) in clearances.iter_mut().zip(moved).zip(&middle) {
                    // Both ends are added: twice what one-sided inputs need, and clearances rarely follow any.
                    clearance.spread_m += (moved - middle).abs();
                }
            }
        }
        Ok(clearances)
    }

    /// The mechanism with each other law that the study lists for a contact.
    fn other_laws(&self) -> Result<Vec<Mechanism>, Diagnostics> {
        let model = self.study.model.demand_planar()?;
        let mut all = Vec::new();
        for input in &self.study.epistemic {
            let EpistemicSubject::Law { contact, laws } = &input.subject else { continue };
            for law in laws {
                let changed = model.with_law(*contact, *law).map_err(|error| Diagnostics::one(&error, None))?;
                let values = changed
                    .quantities
                    .evaluate(&self.middle)
                    .map_err(|error| Diagnostics::one(&IdentifyProblem::Values { error }, None))?;
                let mechanism = Mechanism::new(&changed, &values).map_err(|error| error.diagnostic(model))?;
                all.push(mechanism);
            }
        }
        Ok(all)
    }

    /// A diagnostic about an input, at its place in the study.
    fn diagnostic(&self, path: &str, problem: &IdentifyProblem) -> Diagnostics {
        let span = ["epistemic", "random"].into_iter().find_map(|table| {
            let toml = parse_toml(self.study.source()).ok()?;
            let inputs = toml.get_ref().get(table)?.get_ref().as_table()?;
            inputs.iter().find(|(key, _)| key.get_ref() == path).map(|(key, _)| key.span())
        });
        Diagnostics::one(problem, span.map(|span| Place::new(self.study.source(), span)))
    }
}

/// Clearances of the joints with play, m: half the backlash of a coupling.
fn clearances_of(mechanism: &Mechanism, values: &Values) -> Result<Vec<f64>, SampleError> {
    Ok(Sample::<f64>::new(mechanism, values)?.plays.iter().map(|play| play.clearance_m).collect())
}

/// Start of a table of the study.
pub(crate) fn place_of_table(study: &Study, table: &str) -> std::ops::Range<usize> {
    let toml = parse_toml(study.source()).ok();
    let found =
        toml.and_then(|toml| toml.get_ref().iter().find(|(key, _)| key.get_ref() == table).map(|(k, _)| k.span()));
    found.unwrap_or(0..0)
}

/// The interval that holds a random input but for `share`, whatever the uncertain parameters of its distribution are.
fn holding(input: &RandomInput, study: &Study, share: f64) -> [f64; 2] {
    let variables = input.variables(&study.epistemic, |known| known.ends().to_vec());
    let quantiles = variables.iter().map(|variable| [0.5 * share, 1.0 - 0.5 * share].map(|p| variable.quantile(p)));
    quantiles.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [l, h]| [low.min(l), high.max(h)])
}

fn push_input(
    study: &Study,
    path: &str,
    quantity: QuantityId,
    interval_si: [f64; 2],
    is_interval: bool,
    is_random: bool,
    (plays, others): (&mut Vec<PlayInput>, &mut Vec<OtherInput>),
) {
    let unit = SiUnit::of_dimension(study.model.quantities()[quantity].dimension);
    let path = path.to_owned();
    let mut owners = study.model.play_from(quantity).into_iter().map(|play| play.name);
    match (owners.next(), owners.next()) {
        (None, _) => others.push(OtherInput { path, quantity, interval_si, unit, is_random }),
        (Some(owner), second) => {
            let name = if second.is_none() { owner } else { path.clone() };
            plays.push(PlayInput { path, name, quantity, interval_si, unit, is_interval });
        }
    }
}
