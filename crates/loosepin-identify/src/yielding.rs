//! How far contacts give way under a push: δ with F_el(δ) = N, the elastic part of the contact law at rest.

use super::error::Failure;
use super::locked::Test;
use super::rig::Rig;
use super::states::{State, States};
use loosepin_math::Vec2;
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{PlayFreedom, PlayGeometry, Sample};
use loosepin_simulate::accuracy::AccuracyError;
use loosepin_study::Push;

/// Halvings after which a penetration is known to round-off.
const HALVINGS: usize = 200;
/// The deepest penetration that is looked for, m; deeper ones mean that the model has no stiffness.
const DEEPEST_M: f64 = 1.0;
/// Teeth give way along the normal of their flanks, and the backlash is counted along the pitch line: 1/cos of a pressure angle
/// below 45°.
const MAX_ALONG_PITCH_LINE: f64 = std::f64::consts::SQRT_2;

/// Least and largest yield of each joint with play under the push of a test, m: over the clearances in the box `plays_si`, what the other
/// inputs may be together, the contact laws of the study, and what friction does to the loads.
pub(crate) fn yields_m(
    rig: &Rig<'_>,
    states: &States,
    test: &Test,
    plays_si: &[[f64; 2]],
) -> Result<Vec<[f64; 2]>, Failure> {
    let size = match test.push {
        Push::Force { force_n, .. } => force_n,
        Push::Moment { moment_n_m, .. } => moment_n_m,
    };
    let joints = rig.mechanism.plays.len();
    let mut found = vec![[f64::INFINITY, 0.0]; joints];
    for mechanism in std::iter::once(&rig.mechanism).chain(&rig.other_laws) {
        // Least and most at a state, over the ends and the middle of the plays.
        let at = |state: &State, which: usize| -> Result<Vec<f64>, Failure> {
            let wider = |a: f64, b: f64| if which == 0 { a.min(b) } else { a.max(b) };
            let mut all: Option<Vec<f64>> = None;
            for share in [0.0, 0.5, 1.0] {
                let mut changes = state.changes.clone();
                let plays = rig.plays.iter().zip(plays_si);
                changes.extend(plays.map(|(play, [low, high])| (play.quantity, low + share * (high - low))));
                let sample = Sample::new(mechanism, &rig.values_with(&changes)?).map_err(AccuracyError::from)?;
                let mut own = Vec::with_capacity(joints);
                for (joint, play) in sample.plays.iter().enumerate() {
                    let (load, friction) = (state.nominal.loads[joint], &state.friction);
                    let changes = (friction.load_changes[joint], friction.component_changes[joint]);
                    let ends = of_joint(play, load * size, changes.0 * size, changes.1 * size);
                    let name = || rig.mechanism.model.play_name(rig.mechanism.plays[joint]).to_owned();
                    own.push(ends.ok_or_else(|| Failure::TooLoaded { joint: name() })?[which]);
                }
                all = Some(match all {
                    Some(known) => known.into_iter().zip(own).map(|(a, b)| wider(a, b)).collect(),
                    None => own,
                });
            }
            Ok(all.unwrap_or_default())
        };
        let least = states.furthest_by_ratio(-1.0, |state| at(state, 0))?;
        let most = states.furthest_by_ratio(1.0, |state| at(state, 1))?;
        for (found, (least, most)) in found.iter_mut().zip(least.into_iter().zip(most)) {
            *found = [found[0].min(least), found[1].max(most)];
        }
    }
    Ok(found)
}

/// Least and largest yield of a joint, m, under a load that friction changes by at most `change`, and each component by `components`;
/// `None` if the contact law does not carry it.
fn of_joint(play: &PlayGeometry<f64>, load: Vec2<f64>, change: f64, components: Vec2<f64>) -> Option<[f64; 2]> {
    let ends = |size: f64, change: f64| [(size - change).max(0.0), size + change];
    // In a hole the load may have any direction, in a slot it is across its line.
    let [least_n, most_n] = match play.shape.freedom() {
        PlayFreedom::InCircle => ends(load.length(), change),
        PlayFreedom::BetweenFaces => ends(load.x.abs(), components.x),
        PlayFreedom::Tilting { half_length_m, .. } => {
            // One corner carries all of it, or two share it.
            let force_n = f64::max(load.x.abs() + components.x, (load.y.abs() + components.y) / half_length_m);
            return Some([0.0, penetration_m(play, force_n)?]);
        }
        PlayFreedom::AlongPitchLine => {
            let force_n = (load.x.abs() + components.x) * MAX_ALONG_PITCH_LINE;
            return Some([0.0, MAX_ALONG_PITCH_LINE * penetration_m(play, force_n)?]);
        }
    };
    Some([penetration_m(play, least_n)?, penetration_m(play, most_n)?])
}

/// δ with F_el(δ) = N, m; `None` if the law ends before.
fn penetration_m(play: &PlayGeometry<f64>, force_n: f64) -> Option<f64> {
    if force_n == 0.0 {
        return Some(0.0);
    }
    // The limit itself is no value of the law.
    let deepest_m = play.normal.limit_m().map_or(DEEPEST_M, |limit_m| (limit_m * (1.0 - 1e-9)).min(DEEPEST_M));
    if play.normal.elastic_n(deepest_m).is_nan() || play.normal.elastic_n(deepest_m) < force_n {
        return None;
    }
    let (mut low_m, mut high_m) = (0.0, deepest_m);
    for _ in 0..HALVINGS {
        // By ratio where it can be: penetrations are many powers of ten below a metre.
        let middle_m = if low_m > 0.0 { f64::sqrt(low_m * high_m) } else { 1e-3 * high_m };
        if middle_m <= low_m || middle_m >= high_m || middle_m < f64::MIN_POSITIVE {
            break;
        }
        if play.normal.elastic_n(middle_m) < force_n { low_m = middle_m } else { high_m = middle_m }
    }
    Some(high_m)
}
