//! The columns of a study's response: every number that one run must deliver.

use crate::file::{Ask, Deviation, Reduction, Requirement, Study, Where};
use crate::response::outputs::StudyOutput;
use std::collections::HashMap;

use loosepin_bounds::{Request, Statistic};

/// Probabilities of the ends of the band that curves and treatments show.
pub const BAND: [f64; 2] = [0.025, 0.975];

/// Both ends of the central band with this share at a single point.
pub fn pointwise_ends(share: f64) -> [Statistic; 2] {
    [0.5 - 0.5 * share, 0.5 + 0.5 * share].map(Statistic::quantile_at)
}

/// Place of a column in the recorded turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Location {
    /// At this many turns of the drive after the start of the recorded part.
    Pose {
        /// Turns since the start of the recorded part.
        turns: f64,
        /// Angle of the drive as it is shown, rad: the one asked for, or counted from the first recorded turn.
        angle_rad: f64,
    },
    /// The recorded part reduced to one number.
    Reduced(Reduction),
}

/// One number that every run delivers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudyColumn {
    /// Index in [`ColumnPlan::outputs`].
    pub output: usize,
    /// Which deviation.
    pub deviation: Deviation,
    /// Place.
    pub spot: Location,
}

/// All columns of a study, and which ask uses which.
#[derive(Debug, Clone, Default)]
pub struct ColumnPlan {
    /// Outputs of the model.
    pub outputs: Vec<StudyOutput>,
    /// The numbers of a run.
    pub columns: Vec<StudyColumn>,
    /// The asks, with their columns.
    pub asks: Vec<Ask>,
    /// The requirements, with their columns.
    pub requirements: Vec<Requirement>,
    /// Columns of the largest deviations that limit those at poses.
    pub largest: Vec<usize>,
    /// Index of each of the columns.
    places: HashMap<ColumnKey, usize>,
}

/// Key of a column: output, deviation, and the bits of a pose or the reduction.
type ColumnKey = (usize, Deviation, Result<[u64; 2], Reduction>);

impl StudyColumn {
    fn key(&self) -> ColumnKey {
        let spot = match self.spot {
            // Adding zero leaves one of the two zeros.
            Location::Pose { turns, angle_rad } => Ok([turns, angle_rad].map(|number| (number + 0.0).to_bits())),
            Location::Reduced(reduction) => Err(reduction),
        };
        (self.output, self.deviation, spot)
    }
}

impl ColumnPlan {
    /// Whether any column is of an output.
    pub fn is_used(&self, output: usize) -> bool {
        self.columns.iter().any(|column| column.output == output)
    }

    /// Lays out what `study` asks for.
    pub fn new(study: &Study, drive_start_rad: f64, drive_sign: f64) -> Self {
        let mut plan = Self { outputs: study.outputs.clone(), ..Self::default() };
        let angle =
            |turns: f64| drive_start_rad + drive_sign * std::f64::consts::TAU * (study.cycle.transient_turns + turns);
        // People count the recorded turns, not those before them.
        let whole_turns_rad = drive_sign * std::f64::consts::TAU * study.cycle.transient_turns.floor();
        let spots = |location: &Where| -> Vec<Location> {
            match location {
                Where::Cycle => {
                    let rows = (study.cycle.recorded_turns * study.cycle.samples_per_turn as f64).round().max(1.0);
                    // A whole number of turns ends where it began: the last row would repeat the first.
                    let is_closed = study.cycle.recorded_turns.fract() == 0.0;
                    (0..rows as usize + usize::from(!is_closed))
                        .map(|row| study.cycle.recorded_turns * row as f64 / rows)
                        .map(|turns| Location::Pose { turns, angle_rad: angle(turns) - whole_turns_rad })
                        .collect()
                }
                Where::Poses { angles_rad, .. } => angles_rad
                    .iter()
                    .map(|asked_rad| {
                        // Counted as the angles of a whole curve are. One that lies before the recorded part is where the drive comes by first.
                        let ahead = drive_sign * (asked_rad - (angle(0.0) - whole_turns_rad)) / std::f64::consts::TAU;
                        let mut turns = if ahead < 0.0 { ahead - ahead.floor() } else { ahead };
                        // An angle at the very start comes out as a whole turn by round-off.
                        if ahead < 0.0 && turns > 1.0 - 1e-12 {
                            turns = 0.0;
                        }
                        Location::Pose { turns, angle_rad: *asked_rad }
                    })
                    .collect(),
                Where::Reduced(reduction) => vec![Location::Reduced(*reduction)],
            }
        };
        for ask in &study.asks {
            let columns = plan.add(ask.output, ask.deviation, &spots(&ask.location));
            plan.asks.push(Ask { columns, ..ask.clone() });
        }
        // No pose departs further than the largest deviation of the whole recorded part: its bounds narrow those of curves.
        let whole = [Location::Reduced(Reduction::largest_magnitude())];
        for k in 0..plan.asks.len() {
            let Ask { output, deviation, ref location, .. } = plan.asks[k];
            let is_at_poses = !matches!(location, Where::Reduced(_));
            if is_at_poses && !deviation.is_value() {
                let columns = plan.add(output, deviation, &whole);
                plan.largest.extend(columns);
            }
        }
        for requirement in &study.requirements {
            let spots = match &requirement.location {
                Where::Cycle => vec![Location::Reduced(requirement.limit.reduction())],
                other => spots(other),
            };
            let columns = plan.add(requirement.output, requirement.deviation, &spots);
            plan.requirements.push(Requirement { columns, ..requirement.clone() });
        }
        plan
    }

    fn add(&mut self, output: usize, deviation: Deviation, spots: &[Location]) -> Vec<usize> {
        spots
            .iter()
            .map(|&spot| {
                let column = StudyColumn { output, deviation, spot };
                *self.places.entry(column.key()).or_insert_with(|| {
                    self.columns.push(column);
                    self.columns.len() - 1
                })
            })
            .collect()
    }

    /// Each requirement with each of its columns, in the order of their outcomes: one for the whole cycle, or for each pose.
    pub fn required(&self) -> impl Iterator<Item = (&Requirement, usize)> {
        self.requirements.iter().flat_map(|required| required.columns.iter().map(move |&column| (required, column)))
    }

    /// Every statistic that is needed: those asked for, those that the charts show, those of the requirements.
    pub fn requests(&self) -> Vec<Request> {
        let mut requests: Vec<Request> = Vec::new();
        let mut of_column: Vec<Vec<Statistic>> = vec![Vec::new(); self.columns.len()];
        let mut push = |column: usize, statistic: Statistic| {
            if !of_column[column].contains(&statistic) {
                of_column[column].push(statistic);
                requests.push(Request { column, statistic });
            }
        };
        let [middle, lower, upper] = Statistic::of_curve_point(BAND);
        for ask in &self.asks {
            let is_curve = ask.location == Where::Cycle;
            for &column in &ask.columns {
                ask.statistics().for_each(|statistic| push(column, statistic));
                if is_curve {
                    push(column, middle);
                }
                // A band for whole curves has the form of the band for each point.
                ask.bands().flat_map(pointwise_ends).for_each(|statistic| push(column, statistic));
                if is_curve || ask.is_for_contributors() {
                    push(column, lower);
                    push(column, upper);
                }
                if !is_curve {
                    push(column, Statistic::of_single_number());
                }
            }
        }
        for &column in &self.largest {
            [middle, lower, upper].into_iter().for_each(|statistic| push(column, statistic));
        }
        for required in &self.requirements {
            required.columns.iter().for_each(|&column| push(column, required.limit.broken()));
        }
        requests
    }

    /// Columns for which the three treatments are shown: the single numbers that were asked for.
    pub fn compared_columns(&self) -> Vec<usize> {
        let mut compared: Vec<usize> = Vec::new();
        let mut is_compared = vec![false; self.columns.len()];
        for ask in self.asks.iter().filter(|ask| ask.location != Where::Cycle) {
            for &column in &ask.columns {
                if !std::mem::replace(&mut is_compared[column], true) {
                    compared.push(column);
                }
            }
        }
        compared
    }
}
