//! Measures the prototypes: `counts`, `check`, `time` or `space`.

mod case;
mod counts;
mod journal;
mod spatial_checks;
mod time;

use case::{CASES, Case, Generic, Random, Spatial, State, Today, Way, relative};
use generic::{Plane, Space};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_tape::native::Program;

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    match wanted.as_str() {
        "counts" => {
            CASES.into_iter().for_each(|name| count(&Case::read(name)));
            let (counts, time_ns) = spatial_checks::count_balls();
            println!("four-bar with balls: {counts}; {time_ns:.0} ns on plain numbers");
            for (sections, is_planar) in [(1, true), (2, true), (2, false)] {
                let place = if is_planar { "in a plane" } else { "in space" };
                println!("journal {place}, {sections} sections: {}", journal::operations(sections, is_planar));
            }
        }
        "check" => CASES.into_iter().for_each(|name| check(&Case::read(name))),
        "time" => CASES.into_iter().for_each(|name| time::measure(&Case::read(name))),
        "space" => {
            spatial_checks::all();
            journal::one_pose();
        }
        _ => eprintln!("counts, check, time or space"),
    }
}

type Tracing = fn(&Case, bool) -> (Program, Program);

/// What writes down an evaluation, in contact or in flight, by name.
fn tracings() -> [(&'static str, Tracing); 5] {
    [
        ("today", |case, contact| {
            counts::of(case, contact, |sample| Today(Dynamics::new(&case.mechanism, sample), today::traced))
        }),
        ("(a) space", |case, contact| {
            counts::of(case, contact, |sample| Spatial::new(case, sample, false, spatial::traced))
        }),
        ("(a) angles from parents", |case, contact| {
            counts::of(case, contact, |sample| Spatial::new(case, sample, true, spatial::traced))
        }),
        ("(b) plane", |case, contact| {
            counts::of(case, contact, |sample| {
                Generic::<_, Plane>::new(case, &case.plane, sample, generic::plane_traced)
            })
        }),
        ("(b) space", |case, contact| {
            counts::of(case, contact, |sample| {
                Generic::<_, Space>::new(case, &case.space, sample, generic::space_traced)
            })
        }),
    ]
}

/// Programs of all ways, by name.
fn programs(case: &Case, in_contact: bool) -> Vec<(&'static str, (Program, Program))> {
    tracings().into_iter().map(|(name, make)| (name, make(case, in_contact))).collect()
}

fn count(case: &Case) {
    println!("{}", case.name);
    let per_pair = counts::choices_of_sin_cos();
    for ((name, program), (_, flight)) in programs(case, true).iter().zip(programs(case, false)) {
        // Some more choices belong to the rows of closed loops.
        let pairs = flight.0.counts().choices / per_pair;
        println!("  {name}: {pairs} sines with cosines; {}", program.0.counts());
    }
}

/// Largest differences of the accelerations from today's, over the largest of them, and whether the bits are the same.
fn check(case: &Case) {
    println!("{}", case.name);
    let mut random = Random(1);
    let sample = &case.sample;
    let mut today = Today(Dynamics::new(&case.mechanism, sample), today::plain);
    let mut spatial = Spatial::new(case, sample, false, spatial::plain);
    let mut from_parents = Spatial::new(case, sample, true, spatial::plain);
    let mut plane = Generic::<_, Plane>::new(case, &case.plane, sample, generic::plane_plain);
    let mut space = Generic::<_, Space>::new(case, &case.space, sample, generic::space_plain);
    let mut driven = case::Driven::new(case);
    let (mut worst, mut same, mut traced) = ([0.0_f64; 4], [0; 4], [0.0_f64; 5]);
    let programs = programs(case, true);
    const STATES: usize = 1000;
    for _ in 0..STATES {
        let state = case.state(&mut random);
        let expected = today.evaluate(&state).to_vec();
        let size = expected.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        driven.fill(case, sample, &state);
        let [at, rate, acceleration] = driven.of_drives(state.coordinates.len());
        let tree = &case.relative;
        let turned = State {
            coordinates: relative(tree, &state.coordinates, at, false),
            rates: relative(tree, &state.rates, rate, false),
            ..state.clone()
        };
        let of_parents = relative(tree, from_parents.evaluate(&turned), acceleration, true);
        let found = [
            spatial.evaluate(&state).to_vec(),
            plane.evaluate(&state).to_vec(),
            space.evaluate(&state).to_vec(),
            of_parents,
        ];
        for (way, found) in found.iter().enumerate() {
            let differences = found.iter().zip(&expected).map(|(found, expected)| (found - expected).abs() / size);
            worst[way] = differences.fold(worst[way], f64::max);
            same[way] += usize::from(*found == expected);
        }
        for (way, (name, program)) in programs.iter().enumerate().filter(|(_, (name, _))| !name.contains("parents")) {
            let found = time::run(case, program, &state);
            let differences = found.iter().zip(&expected).map(|(found, expected)| (found - expected).abs() / size);
            traced[way] = differences.fold(traced[way], f64::max);
            assert!(traced[way].is_finite(), "{name}");
        }
    }
    for (way, name) in ["(a) space", "(b) plane", "(b) space", "(a) angles from parents"].into_iter().enumerate() {
        println!("  {name}: {:.1e} of the largest; the same bits in {} of {STATES} states", worst[way], same[way]);
    }
    for ((name, _), worst) in programs.iter().zip(traced).filter(|((name, _), _)| !name.contains("parents")) {
        println!("  {name}, as traced: {worst:.1e} of the largest");
    }
    assert_eq!(same[..3], [STATES; 3], "the same bits");
    assert!(worst[..3].iter().all(|worst| *worst < 1e-12) && worst[3] < 1e-11, "{worst:?}");
}
