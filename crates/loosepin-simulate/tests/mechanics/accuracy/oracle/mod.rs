//! Worst cases of random mechanisms against an optimiser that shares nothing with the library: mechanisms as lists of constraints, closed in
//! the coordinates of all bodies, sampled and climbed from many starts.

mod mechanism;
mod optimiser;
pub(super) mod random;

use super::build_text;
use super::worst_case_of_cycle::worst_of;
use mechanism::Rig;
use optimiser::Poised;
use random::Random;

/// How far the found worst case may lie below that of the optimiser, as a share of it.
const SHORT: f64 = 1e-6;

/// What came of one mechanism.
#[derive(Default)]
struct Compared {
    looks: usize,
    /// How far the found extremes lie below those of the optimiser at most, as a share.
    shortest: f64,
    /// Looks at which they lie below by more than [`SHORT`].
    short: usize,
    /// The same where the record says that nothing is proven.
    short_unproven: usize,
    /// How far the optimiser lies above the proven ends at most, as a share.
    beyond: f64,
    beyond_count: usize,
    /// Proven ends over what the optimiser found, minus 1.
    excesses: Vec<f64>,
    /// The same for the largest magnitude over the cycle that the library found.
    of_cycle: Vec<f64>,
    unproven: usize,
    blocked: usize,
}

/// Compares at `looks` of `positions` angles of a turn: that of the largest deviation, and others.
fn compare(rig: &Rig, seed: u64, positions: usize, looks: usize, sums: &mut Compared) {
    let built = build_text(&rig.text());
    let record = worst_of(&built, positions);
    let random = &mut Random::new(seed + 77);
    let answer = &record.outputs[0].clearance;
    let rows = answer.worst_case_si.len();
    let worst = (0..rows).max_by(|a, b| answer.worst_case_si[*a].total_cmp(&answer.worst_case_si[*b])).unwrap_or(0);
    let largest = answer.worst_case_si[worst];
    let end = answer
        .proven_highest_si
        .iter()
        .copied()
        .chain(answer.proven_lowest_si.iter().map(|low| -low))
        .fold(0.0, f64::max);
    sums.of_cycle.push(end / largest - 1.0);
    let half = 0.5 * std::f64::consts::TAU / positions as f64;
    for look in 0..looks {
        let row = if look == 0 { worst } else { random.index(rows) };
        let angle_rad = record.drive_angle_rad[row];
        // At the angle itself, and somewhere between it and its neighbours, where only the proven ends are asked for.
        for away in [0.0, random.between(-half, half)] {
            let Some(poised) = Poised::new(rig, angle_rad + away) else {
                sums.blocked += 1;
                continue;
            };
            sums.looks += 1;
            let ends = [
                (-1.0, answer.lowest_si[row], answer.proven_lowest_si[row]),
                (1.0, answer.highest_si[row], answer.proven_highest_si[row]),
            ];
            for (sign, found, proven) in ends {
                let due = poised.extreme(sign, random) * sign;
                let (found, proven) = (sign * found, sign * proven);
                if due < 1e-9 {
                    continue;
                }
                if away == 0.0 {
                    let short = 1.0 - found / due;
                    sums.shortest = sums.shortest.max(short);
                    if short > SHORT {
                        // Where the play reaches a second way of assembly the record proves nothing, and says so.
                        sums.short += usize::from(proven.is_finite());
                        sums.short_unproven += usize::from(!proven.is_finite());
                        println!(
                            "seed {seed} {} at {:.3}°: found {found:e}, optimiser {due:e}, short by {short:e}, first order {:e}",
                            rig.family,
                            angle_rad.to_degrees(),
                            answer.first_order_si[row]
                        );
                    }
                }
                if !proven.is_finite() {
                    sums.unproven += 1;
                    continue;
                }
                if away == 0.0 {
                    sums.excesses.push(proven / due - 1.0);
                }
                sums.beyond = sums.beyond.max(due / proven - 1.0);
                if due > proven {
                    sums.beyond_count += 1;
                    println!(
                        "seed {seed} {} at {:.3}°: optimiser {due:e} beyond the proven end {proven:e}",
                        rig.family,
                        (angle_rad + away).to_degrees()
                    );
                }
            }
        }
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

#[test]
fn peer_worst_cases_hold_against_an_independent_optimiser() {
    let mut sums = Compared::default();
    for seed in 0..12 {
        compare(&Rig::random(seed), seed, 36, 1, &mut sums);
    }
    for seed in 12..16 {
        compare(&Rig::of_family("circular slot", seed), seed, 36, 1, &mut sums);
    }
    assert!(sums.looks >= 28, "{}", sums.looks);
    assert_eq!((sums.short, sums.beyond_count), (0, 0), "{} {}", sums.shortest, sums.beyond);
    assert!(median(&mut sums.excesses) < 0.05, "{:?}", sums.excesses);
}

/// `just campaign worst-cases`.
#[test]
#[ignore = "a quarter of an hour"]
fn peer_campaign_of_worst_cases() {
    let number =
        |name: &str, default: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default);
    let (count, first) = (number("LOOSEPIN_MECHANISMS", 200), number("LOOSEPIN_FIRST", 0));
    let (positions, looks) = (number("LOOSEPIN_POSITIONS", 360), number("LOOSEPIN_LOOKS", 3));
    let mut sums = Compared::default();
    for seed in first..first + count {
        compare(&Rig::random(seed), seed, positions as usize, looks as usize, &mut sums);
    }
    let proven = sums.excesses.len();
    println!("{count} mechanisms, {} looks, {} of them blocked", sums.looks, sums.blocked);
    println!(
        "found below the optimiser by more than {SHORT:e}: {}, and {} where nothing is proven; by {:.2e} at most",
        sums.short, sums.short_unproven, sums.shortest
    );
    println!("optimiser beyond a proven end: {}; {proven} proven ends, {} without", sums.beyond_count, sums.unproven);
    let finite = sums.of_cycle.iter().filter(|excess| excess.is_finite()).count();
    println!(
        "proven over optimiser at an angle, median excess {:.2e}; over a cycle {:.2e} ({finite} of {count} proven)",
        median(&mut sums.excesses),
        median(&mut sums.of_cycle)
    );
    assert_eq!((sums.short, sums.beyond_count), (0, 0));
}
