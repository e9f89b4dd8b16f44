//! From the wear of single cycles to that of thousands, by Heun's method (`docs/theory/wear.md`, equations 17 to 19).

use crate::failure::RunFailure;
use loosepin_mechanics::model::MAX_JUMPS;

/// Depths of the sectors of bearing and journal of each joint, m.
pub type Depths = Vec<[Vec<f64>; 2]>;

/// A cycle on a shape that is held meanwhile.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// Growth of the depths of all sectors in a cycle, m.
    pub growth_m: Depths,
    /// Friction path of each joint, J.
    pub paths_j: Vec<f64>,
    /// N_s: cycles beyond twice of which an explicit jump makes a saw-tooth of the shape; infinite where nothing wears.
    pub stable_cycles: f64,
    /// Standard error of the friction path from turn to turn, as a share of it; zero of a single turn.
    pub noise: f64,
    /// Largest deviations of the columns of the model from the ideal motion, SI.
    pub deviations_si: Vec<f64>,
    /// Smallest and largest effective clearance of each joint, m.
    pub clearances_m: Vec<[f64; 2]>,
    /// Widest patch of each joint in sectors.
    pub patch_sectors: Vec<f64>,
}

/// How long jumps are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JumpLength {
    /// This many of equal length.
    Equal(usize),
    /// By the error of a jump in any depth, m, and never beyond N_s.
    Controlled {
        /// The error.
        tolerance_m: f64,
    },
}

/// The state between two jumps.
#[derive(Debug, Clone, PartialEq)]
pub struct LifePoint {
    /// Cycles so far.
    pub cycles: f64,
    /// Depths so far, m.
    pub depths_m: Depths,
    /// The cycle there.
    pub cycle: Cycle,
}

/// The wear of a life.
#[derive(Debug, Clone, PartialEq)]
pub struct Life {
    /// The states between jumps, the first and the last one included.
    pub points: Vec<LifePoint>,
    /// Friction path of each joint over all cycles, J, by the weights of the jumps.
    pub paths_j: Vec<f64>,
    /// Largest error of a jump in a depth, m: half the jump times the change of the growth.
    pub largest_error_m: f64,
    /// Largest standard error of a jump from turn to turn, m.
    pub largest_noise_m: f64,
    /// The longest jump over N_s there.
    pub longest_over_stable: f64,
    /// Cycles that were run.
    pub runs: usize,
}

/// Share of the step that the error allows which the next jump takes.
const SAFETY: f64 = 0.9;
/// Largest growth and shrinkage from one jump to the next.
const CHANGES: [f64; 2] = [0.2, 3.0];
/// Share of all cycles that the first jump tries.
const FIRST_SHARE: f64 = 1.0 / 16.0;

/// Jumps from the unworn shape, with the sectors of `start`, over `cycles`; `run` makes a cycle on a shape.
///
/// # Errors
/// What `run` refuses; [`RunFailure::JumpsTooShort`] after the first cycle, [`RunFailure::TooManyJumps`].
pub fn life(
    cycles: f64,
    length: JumpLength,
    start: Depths,
    run: &mut dyn FnMut(&Depths) -> Result<Cycle, RunFailure>,
) -> Result<Life, RunFailure> {
    let first = run(&start)?;
    let stable_cycles = first.stable_cycles;
    if matches!(length, JumpLength::Controlled { .. }) && cycles > MAX_JUMPS as f64 * stable_cycles {
        return Err(RunFailure::JumpsTooShort { cycles, stable_cycles, most: MAX_JUMPS });
    }
    let mut life = Life {
        paths_j: vec![0.0; first.paths_j.len()],
        points: vec![LifePoint { cycles: 0.0, depths_m: start, cycle: first }],
        largest_error_m: 0.0,
        largest_noise_m: 0.0,
        longest_over_stable: 0.0,
        runs: 1,
    };
    let mut next = FIRST_SHARE * cycles;
    while let Some(from) = life.points.last().filter(|from| from.cycles < cycles) {
        // The number of this jump; what was tried in vain does not count.
        let number = life.points.len();
        if number > MAX_JUMPS {
            return Err(RunFailure::TooManyJumps { reached: from.cycles, cycles, most: MAX_JUMPS });
        }
        let left = cycles - from.cycles;
        let (jump, is_last) = match length {
            JumpLength::Equal(count) => (cycles * number as f64 / count as f64 - from.cycles, number >= count),
            JumpLength::Controlled { .. } => {
                let jump = next.min(from.cycle.stable_cycles);
                // The last two are equally long.
                let is_one_but_last = jump < left && 2.0 * jump > left;
                (if is_one_but_last { 0.5 * left } else { jump.min(left) }, jump >= left)
            }
        };
        let predicted = moved(&from.depths_m, &[(jump, &from.cycle)]);
        let there = run(&predicted)?;
        life.runs += 1;
        let error_m = 0.5 * jump * largest_difference(&from.cycle.growth_m, &there.growth_m);
        let noise_m = jump * from.cycle.noise * largest(&from.cycle.growth_m);
        if let JumpLength::Controlled { tolerance_m } = length {
            // What turns differ by is no error of a jump: it would not become smaller with shorter ones.
            let allowed_m = tolerance_m.max(noise_m);
            let change = SAFETY * (allowed_m / error_m).sqrt();
            next = jump * change.clamp(CHANGES[0], CHANGES[1]);
            if error_m > allowed_m {
                continue;
            }
        }
        let depths_m = moved(&from.depths_m, &[(0.5 * jump, &from.cycle), (0.5 * jump, &there)]);
        let reached = if is_last { cycles } else { from.cycles + jump };
        for (sum, paths_j) in life.paths_j.iter_mut().zip(from.cycle.paths_j.iter().zip(&there.paths_j)) {
            *sum += 0.5 * jump * (paths_j.0 + paths_j.1);
        }
        life.largest_error_m = life.largest_error_m.max(error_m);
        life.largest_noise_m = life.largest_noise_m.max(noise_m);
        life.longest_over_stable = life.longest_over_stable.max(jump / from.cycle.stable_cycles);
        let cycle = run(&depths_m)?;
        life.runs += 1;
        life.points.push(LifePoint { cycles: reached, depths_m, cycle });
    }
    Ok(life)
}

/// `depths_m` plus multiples of the growth of each cycle.
fn moved(depths_m: &Depths, by: &[(f64, &Cycle)]) -> Depths {
    let mut moved = depths_m.clone();
    for (cycles, cycle) in by {
        let growths = cycle.growth_m.iter().flatten().flatten();
        for (depth_m, growth_m) in moved.iter_mut().flatten().flatten().zip(growths) {
            *depth_m += cycles * growth_m;
        }
    }
    moved
}

fn largest(depths_m: &Depths) -> f64 {
    depths_m.iter().flatten().flatten().copied().fold(0.0, f64::max)
}

fn largest_difference(one: &Depths, other: &Depths) -> f64 {
    let pairs = one.iter().flatten().flatten().zip(other.iter().flatten().flatten());
    pairs.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

impl Life {
    /// The end of the life.
    pub fn last(&self) -> &LifePoint {
        &self.points[self.points.len() - 1]
    }

    /// Width of the widest patch of joint `index` in sectors, in the cycle in which it is narrowest.
    pub fn narrowest_patch_sectors(&self, index: usize) -> f64 {
        self.points.iter().map(|point| point.cycle.patch_sectors[index]).fold(f64::INFINITY, f64::min)
    }

    /// Cycles until the largest deviation of `column` passes `limit_si`, between two jumps on a straight line, with the two; `None` if
    /// it never does.
    pub fn until(&self, column: usize, limit_si: f64) -> Option<(f64, [f64; 2])> {
        let value = |point: &LifePoint| point.cycle.deviations_si[column];
        let first = &self.points[0];
        if !(value(first) <= limit_si) {
            return Some((0.0, [0.0; 2]));
        }
        let pair = self.points.windows(2).find(|pair| !(value(&pair[1]) <= limit_si))?;
        let (before, behind) = (value(&pair[0]), value(&pair[1]));
        let share = ((limit_si - before) / (behind - before)).clamp(0.0, 1.0);
        let bracket = [pair[0].cycles, pair[1].cycles];
        Some((bracket[0] + share * (bracket[1] - bracket[0]), bracket))
    }
}

#[cfg(test)]
mod tests {
    use super::{Cycle, Depths, JumpLength, Life, life};
    use crate::failure::RunFailure;

    /// Growth over h where the pressure falls with the depth: dh/dN = r_s (d_s - h), h = d_s (1 - exp(-r_s N)).
    const RATES: [f64; 3] = [1e-3, 4e-4, 2.5e-3];
    const ENDS_M: [f64; 3] = [8e-6, 5e-6, 3e-6];
    const CYCLES: f64 = 900.0;

    fn relaxing(depths_m: &Depths) -> Result<Cycle, RunFailure> {
        let growth_m: Vec<f64> = (0..3).map(|k| RATES[k] * (ENDS_M[k] - depths_m[0][0][k])).collect();
        Ok(Cycle {
            paths_j: vec![growth_m.iter().sum::<f64>() / 1e-14],
            growth_m: vec![[growth_m, vec![0.0; 3]]],
            stable_cycles: 1.0 / RATES[2],
            noise: 0.0,
            deviations_si: vec![1e-4 + depths_m[0][0][0]],
            clearances_m: vec![[1e-4; 2]],
            patch_sectors: vec![3.0],
        })
    }

    fn run(length: JumpLength) -> Life {
        life(CYCLES, length, vec![[vec![0.0; 3], vec![0.0; 3]]], &mut relaxing).unwrap_or_else(|e| panic!("{e}"))
    }

    fn error_m(life: &Life) -> f64 {
        let exact_m = |k: usize| ENDS_M[k] * (1.0 - (-RATES[k] * CYCLES).exp());
        (0..3).map(|k| (life.last().depths_m[0][0][k] - exact_m(k)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn analytic_equal_jumps_are_of_second_order_and_their_weights_give_the_path() {
        let errors_m = [8, 16, 32, 64].map(|count| {
            let life = run(JumpLength::Equal(count));
            assert_eq!((life.points.len(), life.runs, life.last().cycles), (count + 1, 2 * count + 1, CYCLES));
            let sum_m: f64 = life.last().depths_m[0][0].iter().sum();
            assert!((1e-14 * life.paths_j[0] / sum_m - 1.0).abs() < 1e-13);
            error_m(&life)
        });
        for pair in errors_m.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((1.95..2.4).contains(&order), "{order} {errors_m:?}");
        }
    }

    #[test]
    fn analytic_controlled_jumps_keep_their_error_and_converge() {
        let mut before_m = f64::INFINITY;
        for tolerance_m in [1e-7, 1e-8, 1e-9] {
            let life = run(JumpLength::Controlled { tolerance_m });
            assert!(life.largest_error_m <= tolerance_m && life.longest_over_stable <= 1.0, "{life:?}");
            assert_eq!(life.last().cycles, CYCLES);
            // Heun's error is far below the estimate, which is that of Euler's method.
            assert!(error_m(&life) < tolerance_m && error_m(&life) < 0.3 * before_m, "{}", error_m(&life));
            before_m = error_m(&life);
        }
    }

    #[test]
    fn identity_noise_does_not_shorten_jumps() {
        let mut sign = 1.0;
        let mut noisy = |depths_m: &Depths| {
            sign = -sign;
            let mut cycle = relaxing(depths_m)?;
            cycle.growth_m[0][0].iter_mut().for_each(|growth_m| *growth_m *= 1.0 + 0.02 * sign);
            cycle.noise = 0.05;
            Ok(cycle)
        };
        let start = vec![[vec![0.0; 3], vec![0.0; 3]]];
        let length = JumpLength::Controlled { tolerance_m: 1e-11 };
        let life = life(CYCLES, length, start, &mut noisy).unwrap_or_else(|e| panic!("{e}"));
        assert!(life.points.len() < 40 && life.largest_noise_m > 1e-8, "{}", life.points.len());
    }

    #[test]
    fn identity_a_life_of_more_jumps_than_are_made_is_refused_after_its_first_cycle() {
        let (mut runs, stable_cycles) = (0, 1.0 / RATES[2]);
        let mut counted = |depths_m: &Depths| {
            runs += 1;
            relaxing(depths_m)
        };
        let start = vec![[vec![0.0; 3], vec![0.0; 3]]];
        let length = JumpLength::Controlled { tolerance_m: 1e-9 };
        let refused = life(4097.0 * stable_cycles, length, start.clone(), &mut counted).err();
        let expected = RunFailure::JumpsTooShort { cycles: 4097.0 * stable_cycles, stable_cycles, most: 4096 };
        assert_eq!((refused, runs), (Some(expected), 1));
        // Wear that grows ever faster is seen later: N_s falls with it.
        let hastening = |depths_m: &Depths| Ok(Cycle { stable_cycles: 1e-3, ..relaxing(depths_m)? });
        let mut first = true;
        let mut later = |depths_m: &Depths| {
            let cycle = if first { relaxing(depths_m) } else { hastening(depths_m) };
            first = false;
            cycle
        };
        let refused = life(CYCLES, length, start, &mut later).err();
        let Some(RunFailure::TooManyJumps { reached, cycles, most: 4096 }) = refused else { panic!("{refused:?}") };
        assert!(cycles == CYCLES && reached > 4.0 && reached < 0.1 * CYCLES, "{reached}");
    }

    #[test]
    fn analytic_a_life_ends_between_two_jumps() {
        let life = run(JumpLength::Equal(64));
        // 1e-4 + h_0 passes 1.02e-4 where exp(-N/1000) = 3/4.
        let (cycles, [from, to]) = life.until(0, 1.02e-4).expect("it ends");
        assert!((cycles - 1000.0 * (4.0_f64 / 3.0).ln()).abs() < 0.1, "{cycles}");
        assert!(from < cycles && cycles < to && (to - from - CYCLES / 64.0).abs() < 1e-9);
        assert_eq!(life.until(0, 2e-4), None);
        assert_eq!(life.until(0, 0.9e-4), Some((0.0, [0.0; 2])));
    }
}
