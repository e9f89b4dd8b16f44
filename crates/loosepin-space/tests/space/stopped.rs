//! Work that is stopped, and ways of the drives that are too long to be followed.

use loosepin_space::{SpatialModel, SpatialScatterPlan};
use loosepin_text::diagnostics::Diagnostics;
use std::cell::Cell;

const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");
const ARM: &str = include_str!("../../../loosepin-import/templates/six-axis-arm/model.toml");
const DURATION: &str = "duration = \"1 s\"";

fn read(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// Each work of a model, until it is stopped.
type Work = (&'static str, fn(&SpatialModel, &dyn Fn() -> bool) -> Result<(), Diagnostics>);

const WORKS: [Work; 5] = [
    ("motion", |model, stop| model.motion_with_paths_until(&model.quantities.nominal(), &[], false, stop).map(|_| ())),
    ("proof", |model, stop| model.motion_with_paths_until(&model.quantities.nominal(), &[], true, stop).map(|_| ())),
    ("picture", |model, stop| model.drawn_motion_until(&model.quantities.nominal(), stop).map(|_| ())),
    ("assembly", |model, stop| model.assembly_until(&model.quantities.nominal(), stop).map(|_| ())),
    ("scatter", |model, stop| {
        let length =
            model.quantities.id("body.coupler.points.rocker.x").or(model.quantities.id("parameter.upper_length"));
        let quantities = vec![(length.expect("a length"), 1e-5)];
        model.scatter_until(&SpatialScatterPlan { quantities, ..SpatialScatterPlan::default() }, stop).map(|_| ())
    }),
];

#[test]
fn each_work_ends_at_the_question_that_stops_it() {
    for model in [read(FOUR_BAR), read(ARM)] {
        for (name, work) in WORKS {
            let asked = Cell::new(0_u32);
            let count = |stop_at: u32| {
                asked.set(0);
                work(&model, &|| {
                    asked.set(asked.get() + 1);
                    asked.get() >= stop_at
                })
            };
            count(u32::MAX).unwrap_or_else(|diagnostics| panic!("{}, {name}: {diagnostics}", model.name));
            let all = asked.get();
            // At each position of a turn at least.
            assert!(all > 36, "{}, {name}: asked {all} times", model.name);
            for stop_at in [1, all / 2, all] {
                let found = count(stop_at).expect_err("it is stopped");
                assert_eq!(asked.get(), stop_at, "{}, {name}: nothing goes on", model.name);
                assert!(found.to_string().contains("the motion was stopped before its end"), "{found}");
            }
        }
    }
}

#[test]
fn analytic_a_way_that_is_too_long_is_refused_at_its_key_before_it_is_begun() {
    assert!(ARM.contains(DURATION));
    let long = read(&ARM.replace(DURATION, "duration = \"1e6 s\""));
    // The fastest axis turns by 90° a second, in steps of 0.3 rad.
    let steps = (1e6 * 90_f64.to_radians() / 0.3).round();
    for (name, work) in WORKS {
        let asked = Cell::new(0_u32);
        let found = work(&long, &|| {
            asked.set(asked.get() + 1);
            false
        });
        assert_eq!(
            found.expect_err(name).to_string(),
            format!(
                "model.toml:125:12: error[E0501]: to follow the drive of joint 'flange' over the cycle takes about {steps} steps along the \
                 motion; at most 21000 are made\nhint: give a shorter duration, or slower drives: fewer samples_per_turn do not change it"
            ),
            "{name}"
        );
        assert_eq!(asked.get(), 0, "{name}");
    }
    // A thousand turns are followed.
    let turns =
        read(&ARM.replace(DURATION, "duration = \"4000 s\"").replace("samples_per_turn = 50", "samples_per_turn = 2"));
    turns.drawn_motion_until(&turns.quantities.nominal(), &|| false).unwrap();
}
