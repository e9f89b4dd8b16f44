//! Whether play takes a mechanism to a dead centre: a position where the loop equations are singular, so that they can go over to their other
//! assembly.
//!
//! Where the loops stay closed, the determinant d of their equations changes with the play. Near a dead centre d² is linear in it (the normal
//! form of a fold: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.2). So the search goes to the place within
//! the play that makes d smallest to first order, again and again, and follows the loops exactly; past a dead centre they do not close. Across
//! from it, a step along the direction in which they give way takes them to the other assembly, where d has the other sign.

use super::loops::{DisplacedLoops, LoopsPlace};
use super::play_reach::PlayReach;
use super::worst_case::starts_on_borders;
use loosepin_math::Vec2;

/// Most steps of a descent; three are usual.
const MAX_STEPS: usize = 40;
/// Share of the determinant that a step must gain to be followed by another.
const LEAST_GAIN: f64 = 1e-3;
/// Share of the determinant of the ideal position that is none.
const NEARLY_NONE: f64 = 1e-2;
/// The shortest part of a step before the loops count as not closing any more.
const LAST_PART: f64 = 2.328_306_436_538_696_3e-10; // 2⁻³²
/// Most parts of a walk, closed or not: to halve the last one away takes 32, and as many may close between. Where many short parts close one
/// after another and longer ones do not, round-off decides.
const MOST_PARTS: usize = 128;
/// Share of the last step that is gone back from a dead centre: both assemblies are then apart by the root of it.
const BACK: f64 = 1e-3;
/// Step of the derivatives, in units of the play.
const DIFFERENCE: f64 = 1e-3;

/// A dead centre that the play reaches.
pub(super) struct DeadCentre {
    /// The other assembly next to it, if it was found.
    pub other: Option<LoopsPlace>,
}

/// The dead centre that play takes the position to that `loops` was set to; `None` if none was found, which is no proof.
pub(super) fn dead_centre(loops: &mut DisplacedLoops<'_>, reaches: &[PlayReach]) -> Option<DeadCentre> {
    loops.centre();
    let none = NEARLY_NONE * loops.determinant();
    let middle = vec![Vec2::zero(); reaches.len()];
    let borders = starts_on_borders(reaches);
    let is_reached = std::iter::once(&middle).chain(&borders).any(|start| {
        loops.centre();
        match walk(loops, start, none) {
            Walk::ToItsEnd => descend(loops, reaches, none),
            Walk::ToADeadCentre => true,
            Walk::Lost => false,
        }
    });
    let found = is_reached.then(|| DeadCentre { other: loops.cross().ok().map(|()| loops.place()) });
    loops.centre();
    found
}

/// How a walk ended.
enum Walk {
    ToItsEnd,
    /// Just before the loops do not close any more.
    ToADeadCentre,
    Lost,
}

/// Walks straight to a place within the play as long as the loops close.
fn walk(loops: &mut DisplacedLoops<'_>, to: &[Vec2<f64>], none: f64) -> Walk {
    let from = loops.displacements().to_vec();
    if loops.advance(to, LAST_PART, MOST_PARTS).is_ok() {
        return Walk::ToItsEnd;
    }
    if loops.determinant() >= none {
        return Walk::Lost;
    }
    // A little back: in the dead centre itself both assemblies are one within the round-off of closed loops.
    let back: Vec<Vec2<f64>> =
        loops.displacements().iter().zip(&from).map(|(last, from)| *last + (*from - *last) * BACK).collect();
    // Where that fails the joints stay where they are.
    let _ = loops.displace(&back);
    Walk::ToADeadCentre
}

/// Goes along the steepest descent of the determinant; whether it ends in a dead centre.
fn descend(loops: &mut DisplacedLoops<'_>, reaches: &[PlayReach], none: f64) -> bool {
    for _ in 0..MAX_STEPS {
        let before = loops.determinant();
        if before < none {
            return true;
        }
        let present = loops.displacements().to_vec();
        let gradients = gradients(loops, reaches);
        let joints = reaches.iter().zip(&gradients).zip(&present);
        let target: Vec<Vec2<f64>> =
            joints.map(|((reach, gradient), at)| reach.furthest(-*gradient).unwrap_or(*at)).collect();
        match walk(loops, &target, none) {
            Walk::ToADeadCentre => return true,
            Walk::Lost => return false,
            Walk::ToItsEnd => {}
        }
        if !(loops.determinant() < before * (1.0 - LEAST_GAIN)) {
            return false;
        }
    }
    false
}

/// The derivatives of the determinant by the displacement of each joint, the loops closed: differences, to one side where the other is past a
/// dead centre.
fn gradients(loops: &mut DisplacedLoops<'_>, reaches: &[PlayReach]) -> Vec<Vec2<f64>> {
    let here = loops.place();
    let present = loops.displacements().to_vec();
    let at_rest = loops.determinant();
    let mut along = |joint: usize, unit: Vec2<f64>| {
        let Some(border) = reaches[joint].furthest(unit) else { return 0.0 };
        let step = border * DIFFERENCE;
        let mut at = |sign: f64| {
            let mut moved = present.clone();
            moved[joint] += step * sign;
            let found = loops.displace(&moved).is_ok().then(|| loops.determinant());
            loops.put(&here);
            found
        };
        let change = match [at(-1.0), at(1.0)] {
            [Some(before), Some(after)] => 0.5 * (after - before),
            [Some(before), None] => at_rest - before,
            [None, Some(after)] => after - at_rest,
            [None, None] => 0.0,
        };
        change / step.length()
    };
    let axes = [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)];
    (0..reaches.len())
        .map(|joint| {
            let [x, y] = axes.map(|unit| along(joint, unit));
            Vec2::new(x, y)
        })
        .collect()
}
