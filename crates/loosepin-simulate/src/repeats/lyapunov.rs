//! The largest Lyapunov exponent of a run, from a neighbouring run.

use crate::engine::run_from;
use crate::failure::RunFailure;
use crate::lanes::batch::CompiledCodeCache;
use crate::observer::{Observer, Step};
use crate::resume::MotionState;
use crate::settings::{STEP_SHARE, Settings, Window};
use crate::start::resting;
use crate::stepping::motion::{Motion, tolerances};
use crate::stepping::pace::{fastest_drive_rad_s, pace_of_start_rad_s};
use crate::stoppable_observer::StoppableObserver;
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_result::simulation::{LyapunovRecord, NeighbourKind};
use std::ops::RangeInclusive;
use std::sync::atomic::AtomicBool;

/// Plan of a Lyapunov exponent.
#[derive(Debug, Clone, Copy)]
pub struct ExponentPlan {
    /// Turns before anything is measured, as for every run.
    pub transient_turns: f64,
    /// Turns over which the exponent is the mean; at least 20, one for each batch.
    pub turns: u32,
    /// Duration of a turn, s.
    pub turn_s: f64,
    /// Accuracy.
    pub settings: Settings,
}

/// Turns over which an exponent can be measured: one for each batch at least.
pub const EXPONENT_TURNS: RangeInclusive<i64> = BATCHES as i64..=1_000_000;
/// Batches of turns whose means give the standard error.
pub const BATCHES: usize = 20;
/// t with P(|T| <= t) = 95 % for Student's distribution with 19 degrees of freedom.
const STUDENT_95: f64 = 2.093;
/// Separation that is set up again and again, as a share of the natural scales: an angle of a radian, the size of the mechanism.
const SEPARATION: f64 = 1e-7;
/// Distance as a share of the smallest clearance, where that is less: the neighbour must see the same hole.
const SHARE_OF_CLEARANCE: f64 = 1e-4;
/// The separation is at least as many times the local error of a step.
const OVER_LOCAL_ERROR: f64 = 200.0;
/// Pieces of a turn after which the separation is set up again.
const PIECES: u32 = 8;
/// A piece over which the separation changes by more than this factor, either way, is halved.
const MAX_CHANGE: f64 = 100.0;
/// A piece is halved so often at most.
const MAX_HALVINGS: u32 = 12;
/// Growth over all turns below which the exponent counts as zero: a thousandfold. Neighbours that part evenly, as those of a
/// frictionless pendulum, reach elevenfold at most.
const MIN_GROWTH: f64 = 6.9;

/// The largest Lyapunov exponent λ = lim ln(d(t)/d(0))/t of the motion of `sample` (Benettin, Galgani, Giorgilli and Strelcyn
/// 1980).
///
/// A neighbouring run is started at a small separation d0 from the run; eight times a turn, and more often where they part or
/// meet quickly, it is put back to d0 along the direction in which it is then. λ is the mean of ln(d1/d0) over the turns, its
/// standard error that of the means of 20 batches of turns. Coordinates, rates and deflections of bristles count, each over its
/// natural scale (a radian or the size of the mechanism, times the rate of the fastest drive); the speed at which a contact began
/// goes along. The run begins from `start`, the end of another one, or from the initial state. Turns in which the direction settles are not counted: a tenth of those that are, at least five.
///
/// # Errors
/// A mechanism that follows its drives alone has no neighbours; a run that failed, or was stopped by `stop`.
pub fn largest_exponent(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    plan: &ExponentPlan,
    start: Option<&MotionState>,
    stop: &AtomicBool,
) -> Result<LyapunovRecord, RunFailure> {
    if mechanism.is_ideal() {
        return Err(RunFailure::NothingIsFree);
    }
    let aligning = (plan.turns / 10).max(5);
    let start_s = start.map_or(0.0, |start| start.at_s(mechanism, sample)) + plan.transient_turns * plan.turn_s;
    let at_s = |turn: u32| start_s + f64::from(turn) * plan.turn_s;
    let mut pair = Pair::new((mechanism, sample), plan, start, [start_s, at_s(aligning + plan.turns)], stop)?;
    for turn in 0..aligning {
        pair.follow_turn(at_s(turn), at_s(turn + 1))?;
    }
    let mut growth = Vec::with_capacity(plan.turns as usize);
    for turn in aligning..aligning + plan.turns {
        growth.push(pair.follow_turn(at_s(turn), at_s(turn + 1))?);
    }
    let (mean, error) = mean_and_error(&growth);
    let half = STUDENT_95 * error;
    let total = mean * growth.len() as f64;
    let kind = if mean - half > 0.0 && total > MIN_GROWTH {
        NeighbourKind::Part
    } else if mean + half < 0.0 && total < -MIN_GROWTH {
        NeighbourKind::Meet
    } else {
        NeighbourKind::Undecided
    };
    Ok(LyapunovRecord {
        exponent_1_s: mean / plan.turn_s,
        standard_error_1_s: error / plan.turn_s,
        lower_1_s: (mean - half) / plan.turn_s,
        upper_1_s: (mean + half) / plan.turn_s,
        kind,
        turn_s: plan.turn_s,
        transient_turns: plan.transient_turns,
        aligning_turns: aligning,
        separation: pair.separation,
        growth,
    })
}

/// Mean of the growth a turn, and its standard error from the means of [`BATCHES`] batches of turns in a row: n_b turns with the
/// sum S_b give Σ (S_b - mean n_b)² B/(B - 1)/N².
fn mean_and_error(growth: &[f64]) -> (f64, f64) {
    let turns = growth.len();
    let mean = growth.iter().sum::<f64>() / turns as f64;
    let batches = BATCHES.min(turns);
    let squares: f64 = (0..batches)
        .map(|batch| {
            let part = &growth[batch * turns / batches..(batch + 1) * turns / batches];
            (part.iter().sum::<f64>() - mean * part.len() as f64).powi(2)
        })
        .sum();
    let count = batches as f64;
    (mean, (squares * count / (count - 1.0)).sqrt() / turns as f64)
}

/// A run and its neighbour.
struct Pair<'a> {
    mechanism: &'a Mechanism,
    sample: &'a Sample<f64>,
    settings: Settings,
    stop: &'a AtomicBool,
    /// Natural scales of the places that count, with the places.
    scales: Vec<(usize, f64)>,
    separation: f64,
    run: MotionState,
    neighbour: MotionState,
    /// Pieces of turns are short: their machine code is kept from one to the next.
    kept: CompiledCodeCache<'a>,
}

impl<'a> Pair<'a> {
    fn new(
        (mechanism, sample): (&'a Mechanism, &'a Sample<f64>),
        plan: &ExponentPlan,
        start: Option<&MotionState>,
        [start_s, end_s]: [f64; 2],
        stop: &'a AtomicBool,
    ) -> Result<Self, RunFailure> {
        let mut motion = Motion::new(mechanism, sample);
        let (coordinates, rates) = resting::start(mechanism, sample)?;
        let n = motion.freedoms();
        let mut rate_1_s = fastest_drive_rad_s(mechanism, sample, end_s).max(std::f64::consts::TAU / plan.turn_s);
        let mut first = vec![0.0; motion.layout.length()];
        first[..n].copy_from_slice(&coordinates[..n]);
        first[n..2 * n].copy_from_slice(&rates[..n]);
        motion.evaluate(0.0, &first);
        if !mechanism.is_driven() {
            rate_1_s = rate_1_s.max(pace_of_start_rad_s(&motion));
        }
        // The scales of errors, with the size of the mechanism as the error.
        let sizes = tolerances(mechanism, &motion.layout, sample, mechanism.size_m, rate_1_s, 1.0);
        let scales: Vec<(usize, f64)> =
            MotionState::places(&motion.layout).map(|place| (place, sizes[place])).collect();
        let smallest_m = sample.plays.iter().map(|play| play.clearance_m).fold(f64::INFINITY, f64::min);
        let local = plan.settings.tolerance_m * STEP_SHARE * plan.settings.lasting_share(mechanism) / mechanism.size_m;
        let separation =
            SEPARATION.min(SHARE_OF_CLEARANCE * smallest_m / mechanism.size_m).max(OVER_LOCAL_ERROR * local);
        let flight = vec![PlayState::flight(); mechanism.contacts.len()];
        let mut run = MotionState::new(&motion.layout, &first, 0.0, flight);
        let mut kept = CompiledCodeCache::default();
        if let Some(start) = start {
            run = start.clone();
        }
        if start_s > run.time_s(&motion.layout) {
            run = go_on((mechanism, sample), &plan.settings, start, start_s, &mut kept, stop)?;
        }
        let mut neighbour = run.clone();
        // Any direction does that is not at right angles to the one that grows fastest: shares of the golden ratio.
        let length = (scales.len() as f64).sqrt();
        for (k, (place, size)) in scales.iter().enumerate() {
            let share = 0.5 + ((k + 1) as f64 * 0.618_033_988_749_894_9).fract();
            neighbour.state[*place] += separation * share / length * size;
        }
        Ok(Self { mechanism, sample, settings: plan.settings, stop, scales, separation, run, neighbour, kept })
    }

    /// Follows both over a turn: ln of the growth of their separation.
    fn follow_turn(&mut self, from_s: f64, to_s: f64) -> Result<f64, RunFailure> {
        let mut growth = 0.0;
        for piece in 0..PIECES {
            let at_s = |piece: u32| from_s + (to_s - from_s) * f64::from(piece) / f64::from(PIECES);
            let end_s = if piece + 1 == PIECES { to_s } else { at_s(piece + 1) };
            growth += self.follow(at_s(piece), end_s, 0)?;
        }
        Ok(growth)
    }

    fn follow(&mut self, from_s: f64, to_s: f64, halvings: u32) -> Result<f64, RunFailure> {
        let before = self.distance(&self.run, &self.neighbour);
        let (of, settings, kept, stop) = ((self.mechanism, self.sample), &self.settings, &mut self.kept, self.stop);
        let mut advance = |state: &MotionState| go_on(of, settings, Some(state), to_s, kept, stop);
        let (run, neighbour) = (advance(&self.run)?, advance(&self.neighbour)?);
        let factor = self.distance(&run, &neighbour) / before;
        if !(factor < MAX_CHANGE && factor * MAX_CHANGE > 1.0) && halvings < MAX_HALVINGS {
            let middle_s = 0.5 * (from_s + to_s);
            return Ok(self.follow(from_s, middle_s, halvings + 1)? + self.follow(middle_s, to_s, halvings + 1)?);
        }
        (self.run, self.neighbour) = (run, neighbour);
        self.bring_back();
        // Two runs that meet to the last bit would give no number at all.
        Ok(factor.max(f64::MIN_POSITIVE).ln())
    }

    fn distance(&self, run: &MotionState, neighbour: &MotionState) -> f64 {
        let squares =
            self.scales.iter().map(|(place, size)| ((neighbour.state[*place] - run.state[*place]) / size).powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// Puts the neighbour back to the separation along the present direction.
    fn bring_back(&mut self) {
        let distance = self.distance(&self.run, &self.neighbour);
        let factor = if distance > 0.0 { self.separation / distance } else { 0.0 };
        for (place, size) in &self.scales {
            let from = self.run.state[*place];
            let step = if distance > 0.0 {
                factor * (self.neighbour.state[*place] - from)
            } else {
                self.separation * size / (self.scales.len() as f64).sqrt()
            };
            self.neighbour.state[*place] = from + step;
        }
        for (contact, from) in self.neighbour.contacts.iter_mut().zip(&self.run.contacts) {
            if contact.contact == from.contact {
                // What a contact remembers of its beginning is a part of the state.
                let towards = |value: f64, from: f64| from + factor * (value - from);
                contact.inverse_impact_speed_s_m =
                    towards(contact.inverse_impact_speed_s_m, from.inverse_impact_speed_s_m);
                contact.effective_mass_kg = towards(contact.effective_mass_kg, from.effective_mass_kg);
            } else {
                // One of the two is in a contact that begins or ends just now: at the separation it does so at once.
                *contact = *from;
            }
        }
    }
}

/// The state at `to_s` of the run resumed from `from`, or from its start; an error once `stop` is set.
fn go_on<'m>(
    (mechanism, sample): (&'m Mechanism, &Sample<f64>),
    settings: &Settings,
    from: Option<&MotionState>,
    to_s: f64,
    kept: &mut CompiledCodeCache<'m>,
    stop: &AtomicBool,
) -> Result<MotionState, RunFailure> {
    let mut last = LastState { end_s: to_s, state: None };
    // Only the last step is looked at.
    let window = Window { start_s: to_s * (1.0 - f64::EPSILON), end_s: to_s };
    let mut watched = StoppableObserver { observer: &mut last, stop };
    run_from(mechanism, sample, (&window, settings), from.cloned(), kept, &mut watched)?;
    last.state.ok_or(RunFailure::NotFinite { time_s: to_s, element: None })
}

/// Keeps the state at the end of a run.
struct LastState {
    end_s: f64,
    state: Option<MotionState>,
}

impl Observer for LastState {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        if step.end_s >= self.end_s {
            self.state = step.last_state();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{go_on, mean_and_error};
    use crate::lanes::batch::CompiledCodeCache;
    use crate::lanes::execution::Execution;
    use crate::resume::MotionState;
    use crate::settings::Settings;
    use loosepin_mechanics::mechanism::{Mechanism, Sample};
    use loosepin_mechanics::model::Model;
    use std::sync::atomic::AtomicBool;

    /// Bits of the states after a long piece and eleven short ones, with the machine code of the pieces before each, or without.
    fn bits_of_pieces<'m>(
        mechanism: &'m Mechanism,
        sample: &Sample<f64>,
        kept: &mut CompiledCodeCache<'m>,
        is_kept: bool,
    ) -> Vec<Vec<u64>> {
        let turn_s = 60.0 / 5000.0;
        let (mut bits, never) = (Vec::new(), AtomicBool::new(false));
        let mut state: Option<MotionState> = None;
        for piece in 0..12 {
            let to_s = turn_s * (2.0 + f64::from(piece) / 8.0);
            if !is_kept {
                *kept = CompiledCodeCache::default();
            }
            let found = go_on((mechanism, sample), &Settings::for_simulation(), state.as_ref(), to_s, kept, &never)
                .expect("a run");
            let of_contacts = found.contacts.iter().flat_map(|contact| {
                [contact.contact, contact.inverse_impact_speed_s_m, contact.effective_mass_kg].map(f64::to_bits)
            });
            bits.push(found.state.iter().copied().map(f64::to_bits).chain(of_contacts).collect());
            state = Some(found);
        }
        bits
    }

    #[test]
    fn identity_pieces_by_kept_machine_code_are_those_without() {
        let text = include_str!("../../../../cases/slider_crank_5000/model.toml");
        let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
        let sample = Sample::<f64>::new(&mechanism, &values).unwrap_or_else(|error| panic!("{error}"));
        let (mut kept, mut not_kept) = (CompiledCodeCache::default(), CompiledCodeCache::default());
        let found = bits_of_pieces(&mechanism, &sample, &mut kept, true);
        assert_eq!(kept.has_machine_code(), matches!(Execution::best(), Execution::MachineCode(_)));
        assert_eq!(found, bits_of_pieces(&mechanism, &sample, &mut not_kept, false));
        // The pieces themselves are short: without the long one before them they would have none.
        assert!(!not_kept.has_machine_code());
    }

    /// Round-off of sums of a few hundred numbers of order one.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn analytic_mean_and_error_of_batches() {
        // Growth that is constant within a batch of three turns and alternates by ±d from batch to batch.
        let growth: Vec<f64> = (0..60).map(|turn| 0.7 + if (turn / 3) % 2 == 0 { 0.3 } else { -0.3 }).collect();
        let (mean, error) = mean_and_error(&growth);
        assert!((mean - 0.7).abs() < ROUND_OFF);
        // Batch means 0.7 ± 0.3: their standard deviation over the root of 20.
        let expected = (20.0 * 0.09 / 19.0_f64).sqrt() / 20.0_f64.sqrt();
        assert!((error - expected).abs() < ROUND_OFF, "{error} against {expected}");
    }

    #[test]
    fn analytic_the_same_growth_every_turn_has_no_error() {
        let (mean, error) = mean_and_error(&[-1.3; 47]);
        assert!((mean + 1.3).abs() < ROUND_OFF && error < ROUND_OFF);
    }
}
