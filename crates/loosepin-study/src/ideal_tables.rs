//! Tables of ideal motions, each made once: mechanisms that differ only in what an ideal joint has not, as play and contacts, share one.

use super::ideal_curve::IdealCurve;
use loosepin_math::Numbers;
use loosepin_mechanics::mechanism::Sample;
use loosepin_simulate::{Arms, Window};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Numbers in all tables together, at most: 64 MiB. Where a study has more mechanisms, those behind are made for each run.
const MOST_NUMBERS: usize = 8 << 20;

/// All numbers on which an ideal motion depends, bit by bit.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct IdealKey(Vec<u64>);

impl IdealKey {
    /// That of the ideal mechanism of `sample`, whose points are `arms`, over `window`; nothing is changed.
    pub fn new(sample: &mut Sample<f64>, arms: &Arms, window: &Window) -> Self {
        let mut bits = vec![window.start_s.to_bits(), window.end_s.to_bits()];
        let mut take = |number: &mut f64| bits.push(number.to_bits());
        sample.ideal.visit(&mut take);
        sample.drives.visit(&mut take);
        arms.numbers().iter_mut().for_each(take);
        Self(bits)
    }
}

/// The tables that are known. A table has the same bits whoever makes it.
#[derive(Debug, Default)]
pub struct IdealTables {
    known: Mutex<Known>,
}

#[derive(Debug, Default)]
struct Known {
    /// A mechanism whose loops close, and its table where deviations from it are asked for.
    tables: HashMap<IdealKey, Option<Arc<IdealCurve>>>,
    numbers: usize,
}

impl IdealTables {
    /// What is known of a mechanism: that its loops close, and its table.
    pub fn find(&self, key: &IdealKey) -> Option<Option<Arc<IdealCurve>>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).tables.get(key).cloned()
    }

    /// Keeps what has been found, while there is room.
    pub fn keep(&self, key: IdealKey, table: Option<Arc<IdealCurve>>) {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let numbers = key.0.len() + table.as_ref().map_or(0, |table| table.numbers());
        if known.numbers + numbers <= MOST_NUMBERS {
            known.numbers += numbers;
            known.tables.insert(key, table);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::file::Study;
    use crate::response::StudyResponse;
    use std::path::Path;

    fn worn_pin() -> StudyResponse {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin/study.toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let study = Study::from_text_at(&path.display().to_string(), &text).unwrap_or_else(|found| panic!("{found}"));
        StudyResponse::new(&study).unwrap()
    }

    /// The bits of a run's row.
    fn row(response: &StudyResponse, random: [f64; 2], epistemic: [f64; 2]) -> Vec<u64> {
        let mut row = vec![0.0; response.row_length()];
        response.run(&random, &epistemic, &mut row).unwrap();
        row.into_iter().map(f64::to_bits).collect()
    }

    #[test]
    fn identity_a_run_has_the_same_bits_whether_its_table_is_known_or_not() {
        let response = worn_pin();
        let known = || response.ideal_tables.known.lock().unwrap().tables.len();
        let (lengths, others) = ([0.05, 0.12], [0.050_01, 0.12]);
        for (random, epistemic, tables) in [
            (lengths, [1e-4, 0.8], 1),
            (lengths, [4e-4, 0.75], 1),
            (others, [4e-4, 0.75], 2),
            (lengths, [1e-4, 0.9], 2),
        ] {
            assert_eq!(row(&response, random, epistemic), row(&worn_pin(), random, epistemic));
            // Neither the play nor the restitution is a number of the ideal mechanism; a length is.
            assert_eq!(known(), tables);
        }
    }
}
