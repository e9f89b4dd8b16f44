//! Ideal motions, each found once: mechanisms that differ only in what an ideal joint has not, as play and contacts, share one.

use loosepin_math::Numbers;
use loosepin_mechanics::mechanism::Sample;
use loosepin_simulate::{Arms, FreeMotion, IdealCurve, Window};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Numbers of all of them together, at most: 64 MiB. Where a study has more mechanisms, those behind are made for each run.
const MAX_NUMBERS: usize = 8 << 20;

/// All numbers on which an ideal motion depends, bit by bit.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct IdealKey(Vec<u64>);

impl IdealKey {
    /// Key of `sample`, which has no play and whose points are `arms`, over `window`; nothing is changed. Where drives move everything,
    /// forces and initial states do not matter.
    pub fn new(sample: &mut Sample<f64>, is_driven: bool, arms: &Arms, window: &Window) -> Self {
        let tables = sample.drives.table_points().chain(sample.references.table_points());
        let given = [window.start_s, window.end_s].into_iter().chain(arms.numbers()).chain(tables);
        let mut bits: Vec<u64> = given.map(f64::to_bits).collect();
        let mut take = |number: &mut f64| bits.push(number.to_bits());
        if is_driven {
            sample.real.visit(&mut take);
            sample.drives.visit(&mut take);
        } else {
            sample.visit(&mut take);
            sample.initial.visit(&mut take);
        }
        Self(bits)
    }
}

/// Cached ideal motion of a mechanism whose loops close.
#[derive(Debug, Clone, Default)]
pub struct CachedIdealMotion {
    /// Its table, where deviations from it are asked for.
    pub curve: Option<Arc<IdealCurve>>,
    /// The motion itself, if forces decide it and outputs without a table are requested.
    pub motion: Option<Arc<FreeMotion>>,
}

impl CachedIdealMotion {
    /// Numbers that it is kept in.
    fn numbers(&self) -> usize {
        let of_curve = self.curve.as_ref().map_or(0, |curve| curve.numbers());
        of_curve + self.motion.as_ref().map_or(0, |motion| motion.numbers())
    }
}

/// The ideal motions that are known. Each has the same bits whoever finds it.
#[derive(Debug, Default)]
pub struct IdealTables {
    known: Mutex<Cache>,
}

#[derive(Debug, Default)]
struct Cache {
    motions: HashMap<IdealKey, CachedIdealMotion>,
    numbers: usize,
}

impl IdealTables {
    /// The cached motion of a mechanism.
    pub fn find(&self, key: &IdealKey) -> Option<CachedIdealMotion> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).motions.get(key).cloned()
    }

    /// Keeps what has been found, while there is room.
    pub fn keep(&self, key: IdealKey, ideal: CachedIdealMotion) {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let numbers = key.0.len() + ideal.numbers();
        if known.numbers + numbers <= MAX_NUMBERS {
            // Another thread may have found the same.
            if known.motions.insert(key, ideal).is_none() {
                known.numbers += numbers;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::IdealKey;
    use crate::response::planar_response::PlanarResponse;
    use crate::written::texts::study_with;
    use loosepin_mechanics::mechanism::Sample;
    use loosepin_simulate::Arms;

    const WORN_PIN: &str = "cases/slider_crank_worn_pin/study.toml";
    const ARM: &str = "crates/loosepin-import/templates/three-link-arm/study.toml";

    /// The study at `path`, with texts of its files replaced.
    fn response(path: &str, replaced: &[(&str, &str)]) -> PlanarResponse {
        PlanarResponse::new(&study_with(path, replaced)).unwrap()
    }

    /// The bits of a run's row.
    fn row(response: &PlanarResponse, random: &[f64], epistemic: &[f64]) -> Vec<u64> {
        let mut row = vec![0.0; response.row_length()];
        response.run(random, epistemic, &mut row).unwrap();
        row.into_iter().map(f64::to_bits).collect()
    }

    /// Runs of one response after the other have the bits of those of a response each; so many ideal motions are known after each of them.
    fn same_bits(response: impl Fn() -> PlanarResponse, runs: &[(&[f64], &[f64], usize)]) {
        let shared = response();
        for &(random, epistemic, known) in runs {
            assert_eq!(row(&shared, random, epistemic), row(&response(), random, epistemic));
            assert_eq!(shared.ideal_tables.known.lock().unwrap().motions.len(), known);
        }
    }

    #[test]
    fn identity_a_run_has_the_same_bits_whether_its_ideal_motion_is_known_or_not() {
        let (lengths, others) = ([0.05, 0.12], [0.050_01, 0.12]);
        // Neither the play nor the restitution is a number of the ideal mechanism; a length is.
        let runs: [(&[f64], &[f64], usize); 4] = [
            (&lengths, &[1e-4, 0.8], 1),
            (&lengths, &[4e-4, 0.75], 1),
            (&others, &[4e-4, 0.75], 2),
            (&lengths, &[1e-4, 0.9], 2),
        ];
        same_bits(|| response(WORN_PIN, &[]), &runs);
    }

    #[test]
    fn identity_an_ideal_motion_that_forces_decide_is_the_same_for_every_play() {
        let (lengths, others) = ([0.6, 0.55, 0.25], [0.6, 0.55, 0.250_05]);
        let runs: [(&[f64], &[f64], usize); 3] =
            [(&lengths, &[5e-5], 1), (&lengths, &[4e-5], 1), (&others, &[4e-5], 2)];
        // A position is compared with the table of the run's own ideal motion, an angular rate with this motion itself.
        let of_own = [
            ("of = \"total\"\nat", "of = \"clearance\"\nat"),
            ("output = \"across\"\nof = \"total\"\nreduce", "output = \"turning\"\nof = \"clearance\"\nreduce"),
            ("0.3 mm", "1 rad/s"),
            ("[output.torch_angle]", "[output.turning]\nangular_velocity_of = \"torch\"\n\n[output.torch_angle]"),
        ];
        same_bits(|| response(ARM, &of_own), &runs);
    }

    #[test]
    fn identity_an_ideal_motion_is_known_by_all_that_it_depends_on_and_by_nothing_else() {
        let key = |path: &str, replaced: &[(&str, &str)]| {
            let response = response(path, replaced);
            let (mechanism, values) = (response.mechanism(), &response.nominal);
            let mut sample = Sample::new(mechanism, values).unwrap().without_play();
            IdealKey::new(&mut sample, mechanism.is_driven(), &Arms::new(mechanism, values), &response.nominal_window)
        };
        let arm = key(ARM, &[]);
        for (what, old, new) in [
            ("gravity", "9.81 m/s^2", "9.82 m/s^2"),
            ("mass", "40 kg", "41 kg"),
            ("gain", "13200 N m/rad", "13201 N m/rad"),
            ("last point of a table", "-8.64631 deg", "-8.64630 deg"),
            ("duration", "duration = \"0.6 s\"", "duration = \"0.5 s\""),
        ] {
            assert_ne!(key(ARM, &[(old, new)]), arm, "{what}");
        }
        for (what, old, new) in [("play", "0.06 mm", "0.05 mm"), ("law", "restitution = 0.5", "restitution = 0.6")] {
            assert_eq!(key(ARM, &[(old, new)]), arm, "{what}");
        }
        let driven = key(WORN_PIN, &[]);
        assert_ne!(key(WORN_PIN, &[("5000 rpm", "5001 rpm")]), driven);
    }
}
