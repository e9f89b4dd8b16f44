//! How far contacts give way under a push: δ with F_el(δ) = N, the elastic part of the contact law at rest.

use super::friction::Friction;
use super::locked::Test;
use super::rig::Rig;
use loosepin_math::Vec2;
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{Mechanism, PlayGeometry, PlayShape, Sample};
use loosepin_mechanics::model::Values;
use loosepin_simulate::accuracy::AccuracyError;
use loosepin_study::Push;

/// Halvings after which a penetration is known to round-off.
const HALVINGS: usize = 200;
/// The deepest penetration that is looked for, m; deeper ones mean that the model has no stiffness.
const DEEPEST_M: f64 = 1.0;
/// Teeth give way along the normal of their flanks, and the backlash is counted along the pitch line: 1/cos of a pressure angle
/// below 45°.
const MOST_ALONG_PITCH_LINE: f64 = std::f64::consts::SQRT_2;

/// Least and largest yield of each joint with play under the push of a test, m: over the clearances in the box `plays_si`, the other inputs and the contact
/// laws of the study, each by itself, and over what friction does to the loads. `loads` are those of a unit push.
pub(crate) fn yields_m(
    rig: &Rig<'_>,
    loads: &[Vec2<f64>],
    friction: &Friction,
    test: &Test,
    plays_si: &[[f64; 2]],
) -> Result<Vec<[f64; 2]>, AccuracyError> {
    let size = match test.push {
        Push::Force { force_n, .. } => force_n,
        Push::Moment { moment_n_m, .. } => moment_n_m,
    };
    let middle: Vec<_> =
        rig.plays.iter().zip(plays_si).map(|(play, [low, high])| (play.quantity, 0.5 * (low + high))).collect();
    let mut all = vec![rig.values_with(&middle)?];
    for which in [0, 1] {
        let ends: Vec<_> = rig.plays.iter().zip(plays_si).map(|(play, ends)| (play.quantity, ends[which])).collect();
        all.push(rig.values_with(&ends)?);
        for other in &rig.others {
            let mut changes = middle.clone();
            changes.push((other.quantity, other.interval_si[which]));
            all.push(rig.values_with(&changes)?);
        }
    }
    let of_values = |mechanism: &Mechanism, values: &Values| -> Result<Vec<[f64; 2]>, AccuracyError> {
        let sample = Sample::new(mechanism, values)?;
        let joints = sample.plays.iter().zip(loads).zip(&friction.load_shares);
        Ok(joints
            .map(|((play, load), share)| {
                let [least, _] = of_joint(play, *load * (size * (1.0 - share).max(0.0)));
                let [_, most] = of_joint(play, *load * (size * (1.0 + share)));
                [least, most]
            })
            .collect())
    };
    let mut found = vec![[f64::INFINITY, 0.0]; loads.len()];
    let own = all.iter().map(|values| (&rig.mechanism, values));
    for (mechanism, values) in own.chain(rig.other_laws.iter().map(|(mechanism, values)| (mechanism, values))) {
        for ([least, most], [own_least, own_most]) in found.iter_mut().zip(of_values(mechanism, values)?) {
            *least = least.min(own_least);
            *most = most.max(own_most);
        }
    }
    Ok(found)
}

/// Least and largest yield of a joint under its load, m.
fn of_joint(play: &PlayGeometry<f64>, load: Vec2<f64>) -> [f64; 2] {
    match &play.shape {
        PlayShape::Pin { .. } => [penetration_m(play, load.length()); 2],
        PlayShape::Slot(_) => [penetration_m(play, load.x.abs()); 2],
        // One corner carries all of it, or two share it.
        PlayShape::Slider(block) => {
            let force_n = f64::max(load.x.abs(), load.y.abs() / block.half_length_m);
            [0.0, penetration_m(play, force_n)]
        }
        PlayShape::Flanks(_) => {
            [0.0, MOST_ALONG_PITCH_LINE * penetration_m(play, load.x.abs() * MOST_ALONG_PITCH_LINE)]
        }
    }
}

/// δ with F_el(δ) = N, m.
fn penetration_m(play: &PlayGeometry<f64>, force_n: f64) -> f64 {
    if force_n == 0.0 {
        return 0.0;
    }
    let deepest_m = play.normal.limit_m().map_or(DEEPEST_M, |limit_m| limit_m.min(DEEPEST_M));
    let (mut low_m, mut high_m) = (0.0, deepest_m);
    for _ in 0..HALVINGS {
        // By ratio where it can be: penetrations are many powers of ten below a metre.
        let middle_m = if low_m > 0.0 { (low_m * high_m).sqrt() } else { 1e-3 * high_m };
        if middle_m <= low_m || middle_m >= high_m || middle_m < f64::MIN_POSITIVE {
            break;
        }
        if play.normal.elastic_n(middle_m) < force_n { low_m = middle_m } else { high_m = middle_m }
    }
    high_m
}
