//! A step of DOP853 in all lanes: Hairer, Nørsett and Wanner, "Solving Ordinary Differential Equations I", 2nd edition, section II.5.
//!
//! The derivatives of the stages are kept times the step, so that a sum over them begins with the state and needs no product more. A sum
//! goes through the stages in their order, all unknowns of one stage after the other: chains that do not wait for each other, and the
//! newest stage comes last.

use crate::equations::{
    Contact, LENGTH, ROOT, SLIDER, SPEED, State, TURNING, UNKNOWNS, derivative, each_unknown, eccentricity, energy,
    gap_m2,
};
use crate::model::SliderCrank;
use crate::vector::Lanes;
use loosepin::integrate::{DOP853, ErrorEstimate, TableauRow};

/// Stages of a step.
pub const STAGES: usize = 12;

/// A row of the tableau with its zeros.
const fn dense(row: TableauRow) -> [f64; STAGES] {
    let mut all = [0.0; STAGES];
    let mut place = 0;
    while place < row.len() {
        all[row[place].0] = row[place].1;
        place += 1;
    }
    all
}

/// a of each stage.
const A: [[f64; STAGES]; STAGES] = {
    let mut rows = [[0.0; STAGES]; STAGES];
    let mut stage = 0;
    while stage < STAGES {
        rows[stage] = dense(DOP853.stages[stage]);
        stage += 1;
    }
    rows
};
/// b: the step.
const B: [f64; STAGES] = dense(DOP853.weights);
/// The error estimate of order 5.
const FIFTH: [f64; STAGES] = match DOP853.error {
    ErrorEstimate::Combined { fifth, .. } => dense(fifth),
    ErrorEstimate::Single(_) => panic!("DOP853 has two error estimates"),
};
/// The error estimate of order 3 less the step: three stages are left of it.
const THIRD_LESS_STEP: [f64; STAGES] = {
    let mut row = match DOP853.error {
        ErrorEstimate::Combined { third, .. } => dense(third),
        ErrorEstimate::Single(_) => panic!("DOP853 has two error estimates"),
    };
    let mut stage = 0;
    while stage < STAGES {
        row[stage] -= B[stage];
        stage += 1;
    }
    row
};

/// The end of a step that was tried.
#[derive(Clone, Copy)]
pub struct End<const G: usize> {
    /// Unknowns and integrals.
    pub state: State<G>,
    /// Their derivatives.
    pub slope: State<G>,
    /// [`gap_m2`].
    pub gap_m2: [Lanes<G>; 3],
    /// [`energy`].
    pub energy: [Lanes<G>; 2],
    /// Square of the estimated error over the allowed one.
    pub error: Lanes<G>,
    /// How much longer a step may be for that error: 0.9 · error^(-1/8) of the error itself.
    pub growth: Lanes<G>,
}

impl<const G: usize> End<G> {
    /// Of nothing yet.
    #[target_feature(enable = "avx512f")]
    pub fn zero() -> Self {
        let zero = Lanes::all(0.0);
        let state = [zero; LENGTH];
        Self { state, slope: state, gap_m2: [zero; 3], energy: [zero; 2], error: zero, growth: zero }
    }
}

/// The next step is this share of the longest one that the error allows: with the usual 0.9 a fifth of all steps is tried in vain.
const SAFETY: f64 = 0.765;

/// What steps need apart from the runs.
pub struct Stepper<'m, const G: usize> {
    /// The mechanism.
    pub model: &'m SliderCrank,
    /// Local error allowed in lengths, m, and in speeds, m/rad.
    pub local_m: f64,
    /// Derivatives of the stages times the step.
    pub stages: [State<G>; STAGES],
}

/// Sums over stages, one after the other: `sums` plus the coefficients of `row` times the stages listed.
macro_rules! add_stages {
    ($sums:ident, $stages:ident, $row:expr; $($stage:literal)*) => {$(
        {
            let coefficient = Lanes::all($row[$stage]);
            $sums = each_unknown!(I => $stages[$stage][I].times_plus(coefficient, $sums[I]));
        }
    )*};
}

/// Tries the step `step` from `start`, where the derivatives are `slope`.
#[target_feature(enable = "avx512f")]
pub fn attempt<const G: usize, const ACCOUNT: bool>(
    stepper: &mut Stepper<'_, G>,
    contact: &Contact<G>,
    start: &State<G>,
    slope: &State<G>,
    step: Lanes<G>,
    end: &mut End<G>,
) {
    let Stepper { model, local_m, stages } = stepper;
    let scaled = Contact { stiffness: contact.stiffness.times(step), half: contact.half.times(step), ..*contact };
    for unknown in 0..LENGTH {
        stages[0][unknown] = slope[unknown].times(step);
    }
    macro_rules! stage {
        ($stage:literal: $($from:literal)*) => {{
            let mut point = each_unknown!(I => start[I]);
            add_stages!(point, stages, A[$stage]; $($from)*);
            derivative::<G, ACCOUNT>(model, &scaled, step, &point, &eccentricity(&point), &mut stages[$stage]);
        }};
    }
    stage!(1: 0);
    stage!(2: 0 1);
    stage!(3: 0 2);
    stage!(4: 0 2 3);
    stage!(5: 0 3 4);
    stage!(6: 0 3 4 5);
    stage!(7: 0 3 4 5 6);
    stage!(8: 0 3 4 5 6 7);
    stage!(9: 0 3 4 5 6 7 8);
    stage!(10: 0 3 4 5 6 7 8 9);
    stage!(11: 0 3 4 5 6 7 8 9 10);

    let weight = Lanes::all(B[0]);
    let mut change = each_unknown!(I => stages[0][I].times(weight));
    add_stages!(change, stages, B; 5 6 7 8 9 10 11);
    let unknowns = each_unknown!(I => start[I].plus(change[I]));
    end.state[..UNKNOWNS].copy_from_slice(&unknowns);
    for integral in UNKNOWNS..(if ACCOUNT { LENGTH } else { UNKNOWNS + 1 }) {
        let mut sum = start[integral];
        for stage in [0, 5, 6, 7, 8, 9, 10, 11] {
            sum = stages[stage][integral].times_plus(Lanes::all(B[stage]), sum);
        }
        end.state[integral] = sum;
    }
    let e = eccentricity(&unknowns);
    derivative::<G, ACCOUNT>(model, contact, Lanes::all(1.0), &unknowns, &e, &mut end.slope);
    end.gap_m2 = gap_m2(contact, &unknowns, &e, end.slope[TURNING]);
    if ACCOUNT {
        end.energy = energy(model, contact, &unknowns);
    }

    let root_size = start[ROOT].abs().plus(start[ROOT].plus(stages[0][ROOT]).abs());
    let least_root_size = Lanes::all(2.0 * local_m.sqrt());
    let one_over_local = 1.0 / *local_m;
    let mut fifth = Lanes::all(0.0);
    let mut third = Lanes::all(f64::MIN_POSITIVE);
    for (unknown, scale) in [
        (SLIDER, Lanes::all(one_over_local)),
        (TURNING, Lanes::all(one_over_local * model.rod_m)),
        (SPEED, Lanes::all(one_over_local)),
        (ROOT, root_size.max(least_root_size).times(Lanes::all(one_over_local))),
    ] {
        let [mut estimate, mut coarse] = [stages[0][unknown].times(Lanes::all(FIFTH[0])), change[unknown]];
        for stage in [5, 6, 7, 8, 9, 10, 11] {
            estimate = stages[stage][unknown].times_plus(Lanes::all(FIFTH[stage]), estimate);
        }
        for stage in [0, 8, 11] {
            coarse = stages[stage][unknown].times_plus(Lanes::all(THIRD_LESS_STEP[stage]), coarse);
        }
        let [estimate, coarse] = [estimate.times(scale), coarse.times(scale)];
        fifth = estimate.times_plus(estimate, fifth);
        third = coarse.times_plus(coarse, third);
    }
    // err = e5²/√(n (e5² + 0.01 e3²)); its square, and the eighth root of its reciprocal by four roots of that.
    let mixed = third.times_plus(Lanes::all(0.01), fifth).times(Lanes::all(4.0));
    end.error = fifth.times(fifth).times(mixed.about_one_over());
    let growth = end.error.about_one_over().about_one_over_root().about_one_over_root();
    end.growth = growth.about_one_over_root().about_one_over_root().times(Lanes::all(SAFETY));
}
