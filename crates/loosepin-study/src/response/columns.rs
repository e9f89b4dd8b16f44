//! The columns of a study's response: every number that one run must deliver.

use crate::file::{Ask, Deviation, Reduction, Requirement, Study};
use crate::model::outputs::StudyOutput;
use crate::places::{Location, LocationKey, RecordedPart};
use std::collections::HashMap;

use loosepin_bounds::{Request, Statistic};

/// Probabilities of the ends of the band that curves and treatments show.
pub const BAND: [f64; 2] = [0.025, 0.975];

/// Both ends of the central band with this share at a single point.
pub fn pointwise_ends(share: f64) -> [Statistic; 2] {
    [0.5 - 0.5 * share, 0.5 + 0.5 * share].map(Statistic::quantile_at)
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

/// Key of a column: output, deviation and place.
type ColumnKey = (usize, Deviation, LocationKey);

impl StudyColumn {
    fn key(&self) -> ColumnKey {
        (self.output, self.deviation, self.spot.key())
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
        let recorded = RecordedPart { cycle: &study.cycle, start_rad: drive_start_rad, sign: drive_sign };
        for ask in &study.asks {
            let columns = plan.add(ask.output, ask.deviation, &ask.location.locations(&recorded));
            plan.asks.push(Ask { columns, ..ask.clone() });
        }
        // No pose departs further than the largest deviation of the whole recorded part: its bounds narrow those of curves.
        let whole = [Location::reduced(Reduction::largest_magnitude())];
        for k in 0..plan.asks.len() {
            let Ask { output, deviation, ref location, .. } = plan.asks[k];
            let is_at_poses = location.reduction().is_none();
            if is_at_poses && !deviation.is_value() {
                let columns = plan.add(output, deviation, &whole);
                plan.largest.extend(columns);
            }
        }
        for requirement in &study.requirements {
            let spots = if requirement.location.is_cycle() {
                vec![Location::reduced(requirement.limit.reduction())]
            } else {
                requirement.location.locations(&recorded)
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
            let is_curve = ask.location.is_cycle();
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
        for ask in self.asks.iter().filter(|ask| !ask.location.is_cycle()) {
            for &column in &ask.columns {
                if !std::mem::replace(&mut is_compared[column], true) {
                    compared.push(column);
                }
            }
        }
        compared
    }
}
