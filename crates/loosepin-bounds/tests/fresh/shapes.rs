//! Which functions are drawn, and how often.

use super::draw::Draw;
use super::group::{HALF_HEIGHT, Hill, Profile, Shape};
use super::term::Term;

/// What a problem is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Character {
    /// Trends, wide bumps, slow waves, kinks.
    Smooth,
    /// Bumps, ridges, steps, twins.
    Featured,
    /// Ripples, many waves, cells, chaotic noise.
    Rough,
}

/// A function of `dimensions` coordinates.
pub fn draw_shape(draw: &mut Draw, dimensions: usize, character: Character) -> Shape {
    if character == Character::Rough && draw.chance(0.3) {
        // 30 to 10,000 cells.
        let count = draw.of_size(30.0, 1e4);
        let per_axis = (libm::pow(count, 1.0 / dimensions as f64) as usize).max(2);
        return Shape::Cells { key: draw.key(), per_axis, height: draw.between(0.05, 0.3) };
    }
    match dimensions {
        1 => Shape::Terms(draw_terms(draw, 1, character)),
        2 if character == Character::Featured && draw.chance(0.15) => sheet(draw, 2, character),
        2 => Shape::Terms(draw_terms(draw, 2, character)),
        _ => of_many(draw, dimensions, character),
    }
}

/// A sum of functions of one or two coordinates.
pub fn draw_terms(draw: &mut Draw, dimensions: usize, character: Character) -> Vec<Term> {
    if dimensions == 1 { of_one(draw, character) } else { of_two(draw, character) }
}

/// A direction of length 1.
fn direction(draw: &mut Draw, dimensions: usize) -> Vec<f64> {
    let mut along: Vec<f64> = (0..dimensions).map(|_| draw.normal()).collect();
    let length = along.iter().map(|a| a * a).sum::<f64>().sqrt();
    along.iter_mut().for_each(|a| *a /= length);
    along
}

/// A function along one direction, with what it has through a place inside.
fn sheet(draw: &mut Draw, dimensions: usize, character: Character) -> Shape {
    let along = direction(draw, dimensions);
    let at: f64 = along.iter().map(|a| a * draw.between(0.1, 0.9)).sum();
    let extent: f64 = along.iter().map(|a| a.abs()).sum();
    let profile = match character {
        Character::Smooth => Profile::Kink { at },
        Character::Featured if draw.chance(0.5) => Profile::Step { at },
        Character::Featured => Profile::Ridge { at, width: draw.of_size(0.02, 0.4) },
        Character::Rough => {
            Profile::Wave { turns: draw.of_size(1.2, 25.0) / extent, phase: draw.between(0.0, std::f64::consts::TAU) }
        }
    };
    Shape::Sheet { along, height: draw.sign() * draw.between(0.3, 2.0), profile }
}

fn trend(draw: &mut Draw, axis: usize) -> Term {
    let size = draw.sign() * draw.of_size(0.05, 1.0);
    match draw.below(3) {
        0 => Term::Linear { axis, slope: size },
        1 => Term::Square { axis, centre: draw.between(-0.2, 1.2), height: size },
        _ => Term::Linear { axis, slope: 0.3 * size },
    }
}

fn slow_wave(draw: &mut Draw, dimensions: usize) -> Term {
    let along = if dimensions == 1 { vec![1.0] } else { direction(draw, 2) };
    let (turns, phase) = (draw.between(0.3, 3.0), draw.between(0.0, std::f64::consts::TAU));
    Term::Wave { along, height: draw.of_size(0.1, 0.7), turns, phase }
}

/// One to three bumps of widths between `widths`, centred `at` places.
fn bumps(draw: &mut Draw, at: impl Fn(&mut Draw) -> Vec<f64>, [least, most]: [f64; 2], terms: &mut Vec<Term>) {
    for _ in 0..1 + draw.below(3) {
        let width = draw.of_size(least, most);
        terms.push(Term::Bump { centre: at(draw), width, height: draw.sign() * draw.between(0.2, 1.5) });
    }
}

fn of_one(draw: &mut Draw, character: Character) -> Vec<Term> {
    let mut terms = vec![trend(draw, 0)];
    let at = |draw: &mut Draw| vec![draw.between(0.02, 0.98)];
    match character {
        Character::Smooth => match draw.below(4) {
            0 => terms.push(slow_wave(draw, 1)),
            1 => terms.push(Term::Bump {
                centre: at(draw),
                width: draw.between(0.15, 0.5),
                height: draw.sign() * draw.between(0.2, 1.0),
            }),
            2 => {
                let edge = draw.between(0.05, 0.95);
                terms.push(Term::Kink { along: vec![1.0], edge, height: draw.sign() * draw.between(0.3, 2.0) });
            }
            _ => {}
        },
        Character::Featured => match draw.below(6) {
            0 => twins(draw, 1, &mut terms),
            1 => {
                let edge = draw.between(0.02, 0.98);
                terms.push(Term::Step { along: vec![1.0], edge, height: draw.sign() * draw.between(0.2, 2.0) });
            }
            2 => {
                let from = draw.between(0.0, 0.9);
                let to = from + draw.of_size(0.004, 0.1);
                terms.push(Term::Strip { axis: 0, from, to, height: draw.sign() * draw.between(0.2, 2.0) });
            }
            3 => terms.push(Term::Tent {
                centre: at(draw),
                width: draw.of_size(0.005, 0.2),
                height: draw.sign() * draw.between(0.2, 1.5),
            }),
            _ => {
                bumps(draw, at, [0.003, 0.2], &mut terms);
                if draw.chance(0.3) {
                    terms.push(slow_wave(draw, 1));
                }
            }
        },
        Character::Rough => {
            if draw.chance(0.5) {
                terms.push(slow_wave(draw, 1));
            }
            if draw.chance(0.5) {
                let turns = draw.of_size(5.0, 300.0);
                let (height, phase) = (draw.of_size(0.02, 0.3), draw.between(0.0, std::f64::consts::TAU));
                terms.push(Term::Wave { along: vec![1.0], height, turns, phase });
            } else {
                let (count, height) = (20 + draw.below(30), draw.of_size(0.02, 0.3));
                let fastest = draw.of_size(40.0, 1500.0);
                let wave = |draw: &mut Draw| {
                    let height = height * (2.0 / count as f64).sqrt() * draw.between(0.5, 1.5);
                    [height, draw.of_size(3.0, fastest), draw.between(0.0, std::f64::consts::TAU)]
                };
                terms.push(Term::Rough { waves: (0..count).map(|_| wave(draw)).collect() });
            }
        }
    }
    terms
}

/// Two maxima, or minima, far apart and nearly equal, one wider than the other.
fn twins(draw: &mut Draw, dimensions: usize, terms: &mut Vec<Term>) {
    let narrowest: f64 = if dimensions == 1 { 0.01 } else { 0.05 };
    let sign = draw.sign();
    let one: Vec<f64> = (0..dimensions).map(|_| draw.between(0.05, 0.45)).collect();
    let other: Vec<f64> = (0..dimensions)
        .map(|axis| if axis == 0 { draw.between(0.6, 0.95) } else { draw.between(0.05, 0.95) })
        .collect();
    for (centre, excess) in [(one, 0.0), (other, draw.between(0.0, 0.03))] {
        let width = draw.of_size(narrowest, 0.2);
        terms.push(Term::Bump { centre, width, height: sign * (1.0 + excess) });
    }
}

fn of_two(draw: &mut Draw, character: Character) -> Vec<Term> {
    let mut terms = vec![trend(draw, 0), trend(draw, 1)];
    let at = |draw: &mut Draw| vec![draw.between(0.03, 0.97), draw.between(0.03, 0.97)];
    match character {
        Character::Smooth => match draw.below(4) {
            0 => terms.push(slow_wave(draw, 2)),
            1 => terms.push(Term::Saddle { height: draw.sign() * draw.of_size(0.1, 0.7) }),
            2 => {
                let along = direction(draw, 2);
                let edge = 0.5 * (along[0] + along[1]) + draw.between(-0.3, 0.3);
                terms.push(Term::Kink { along, edge, height: draw.sign() * draw.between(0.3, 2.0) });
            }
            _ => terms.push(Term::Bump {
                centre: at(draw),
                width: draw.between(0.2, 0.6),
                height: draw.sign() * draw.between(0.2, 1.0),
            }),
        },
        Character::Featured => match draw.below(5) {
            0 => twins(draw, 2, &mut terms),
            1 | 2 => {
                let bend = if draw.chance(0.7) { draw.between(-2.0, 2.0) } else { 0.0 };
                // Through a place inside.
                let (through, slope) = (at(draw), draw.between(-1.0, 1.0));
                let start = through[1] - slope * through[0] - bend * through[0] * through[0];
                terms.push(Term::Ridge {
                    line: [start, slope, bend],
                    width: draw.of_size(0.01, 0.3),
                    height: draw.sign() * draw.between(0.3, 1.5),
                    top: draw.between(0.0, 1.0),
                    fall: draw.between(0.0, 0.8),
                });
            }
            3 => terms.push(Term::Tent {
                centre: at(draw),
                width: draw.of_size(0.05, 0.4),
                height: draw.sign() * draw.between(0.2, 1.5),
            }),
            _ => bumps(draw, at, [0.035, 0.3], &mut terms),
        },
        Character::Rough => {
            let (height, phase) = (draw.of_size(0.02, 0.3), draw.between(0.0, std::f64::consts::TAU));
            terms.push(Term::Wave { along: direction(draw, 2), height, turns: draw.between(4.0, 20.0), phase });
        }
    }
    terms
}

fn of_many(draw: &mut Draw, dimensions: usize, character: Character) -> Shape {
    let centre = |draw: &mut Draw| -> Vec<f64> { (0..dimensions).map(|_| draw.between(0.1, 0.9)).collect() };
    match character {
        Character::Smooth if draw.chance(0.7) => {
            let widths = (0..dimensions).map(|_| draw.between(0.6, 2.0)).collect();
            return Shape::Hill { centre: centre(draw), widths, height: draw.sign() * draw.between(0.5, 2.0) };
        }
        Character::Smooth | Character::Rough => return sheet(draw, dimensions, character),
        Character::Featured if draw.chance(0.4) => return sheet(draw, dimensions, character),
        Character::Featured => {}
    }
    // Of a hill of radius 1 the ball that is above half of the height has this volume.
    let unit_ball = [1.0, 2.0, std::f64::consts::PI, 4.188_79, 4.934_8, 5.263_79, 5.167_71][dimensions]
        * HALF_HEIGHT.powi(dimensions as i32);
    let wanted = 1 + draw.below(3);
    let mut hills: Vec<Hill> = Vec::new();
    for attempt in 0..60 {
        if hills.len() == wanted {
            break;
        }
        let volume = draw.of_size(0.003, 0.05) * if attempt > 30 { 0.3 } else { 1.0 };
        let radius = libm::pow(volume / unit_ball, 1.0 / dimensions as f64);
        let hill = Hill { centre: centre(draw), radius, height: draw.sign() * draw.between(0.5, 1.5) };
        let apart = |other: &Hill| {
            let square: f64 = other.centre.iter().zip(&hill.centre).map(|(a, b)| (a - b) * (a - b)).sum();
            square.sqrt() > other.radius + hill.radius
        };
        if hills.iter().all(apart) {
            hills.push(hill);
        }
    }
    Shape::Hills(hills)
}
