//! Parts in a position and a view, the farthest first. `scripts/space-scene.ts` does the same.

use super::parts::{Part, PartKind, RIM_POINTS, round};
use super::projection::Projection;
use crate::mechanism::shapes::{MM_PER_M, convex_hull};
use loosepin_result::spatial_picture::PicturePose;

/// Levels of depth, in which lines differ in width and colour.
const LEVELS: usize = 8;
/// Depths over the radius of the view, from the first to the last level.
const DEPTH_SHARE: f64 = 0.75;

/// A part as it lies on the sheet, mm, y down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placed<'p> {
    pub part: &'p Part,
    /// Its points; of a cylinder the outline, of a hull its corners.
    pub points: Vec<[f64; 2]>,
    /// Of a cylinder the end that faces the reader.
    pub rim: Vec<[f64; 2]>,
    /// How near it is.
    pub depth: f64,
}

/// Depths that differ by less than this share of the radius are equal.
const SAME_DEPTH: f64 = 1e-4;
/// Positions that are looked at for the frame of a picture, at most.
const FRAME_POSITIONS: usize = 48;
/// Of the points of a rim, one in so many.
const RIM_STRIDE: usize = 5;
/// Directions in which the outermost points of all that is drawn are taken.
const OUTER_DIRECTIONS: usize = 120;

/// The middle and the radius of a ball about all that is drawn, mm, and the outermost points, whose views are about as large as those of all.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surroundings {
    pub centre: [f64; 3],
    pub radius: f64,
    pub outer: Vec<[f64; 3]>,
}

impl Surroundings {
    /// About all parts in positions of the turn.
    pub fn of(parts: &[Part], poses: &[Vec<PicturePose>]) -> Self {
        let step = poses.len().div_ceil(FRAME_POSITIONS).max(1);
        let (still, moving): (Vec<&Part>, Vec<&Part>) = parts.iter().partition(|part| part.body == 0);
        let mut points = Vec::new();
        let ground = [PicturePose::GROUND];
        let all = poses.iter().step_by(step).map(|poses| (&moving, &poses[..])).chain([(&still, &ground[..])]);
        for (parts, poses) in all {
            for part in parts {
                let radius = part.radius.unwrap_or(0.0);
                // Rims are small: a few of their points show how far they go.
                let stride = if part.kind == PartKind::Solid { RIM_STRIDE } else { 1 };
                for point in part.points.iter().step_by(stride) {
                    let [x, y, z] = in_ground(part, *point, poses);
                    points.push([x, y, z]);
                    if radius > 0.0 {
                        let offsets = [-radius, radius];
                        points.extend(offsets.iter().flat_map(|r| [[x + r, y, z], [x, y + r, z], [x, y, z + r]]));
                    }
                }
            }
        }
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in &points {
            for (k, own) in point.iter().enumerate() {
                (low[k], high[k]) = (low[k].min(*own), high[k].max(*own));
            }
        }
        let centre: [f64; 3] = std::array::from_fn(|k| round(0.5 * (low[k] + high[k])));
        if !centre.iter().all(|own| own.is_finite()) {
            return Self { centre: [0.0; 3], radius: 1.0, outer: Vec::new() };
        }
        let away = |point: &[f64; 3]| point.iter().zip(centre).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        let radius = points.iter().map(away).fold(0.0, f64::max);
        let mut outer: Vec<[f64; 3]> = Vec::new();
        for direction in 0..OUTER_DIRECTIONS {
            let [a, b, c] = spread(direction);
            let (mut farthest, mut farthest_at) = (f64::NEG_INFINITY, None);
            // Without an iterator: of so many points each call would cost more than its sum.
            for point in &points {
                let along = a * point[0] + b * point[1] + c * point[2];
                if along > farthest {
                    (farthest, farthest_at) = (along, Some(*point));
                }
            }
            outer.extend(farthest_at.filter(|point| !outer.contains(point)));
        }
        Self { centre, radius: if radius > 0.0 { round(radius) } else { 1.0 }, outer }
    }

    /// Half the width and half the height that a view of all needs, about its middle.
    pub fn half_sides(&self, projection: &Projection) -> [f64; 2] {
        let middle = projection.project(self.centre);
        self.outer.iter().map(|point| projection.project(*point)).fold([0.0; 2], |[width, height], [x, y, _]| {
            [f64::max(width, (x - middle[0]).abs()), f64::max(height, (y - middle[1]).abs())]
        })
    }

    /// The level of a depth: 0 is far.
    pub fn level(&self, depth: f64, projection: &Projection) -> usize {
        let own = (depth - projection.project(self.centre)[2]) / (DEPTH_SHARE * self.radius);
        ((0.5 * (own + 1.0) * LEVELS as f64).floor().max(0.0) as usize).min(LEVELS - 1)
    }
}

/// Directions spread over the sphere: a spiral with the golden angle, (3 - √5) π.
fn spread(number: usize) -> [f64; 3] {
    let height = 1.0 - (2.0 * number as f64 + 1.0) / OUTER_DIRECTIONS as f64;
    let angle = 2.399_963_229_728_653 * number as f64;
    let across = (1.0 - height * height).sqrt();
    [across * libm::cos(angle), across * libm::sin(angle), height]
}

/// A point of a part in the frame of the ground, mm.
fn in_ground(part: &Part, point: [f64; 3], poses: &[PicturePose]) -> [f64; 3] {
    let pose = poses.get(part.body).copied().unwrap_or(PicturePose::GROUND);
    let pose = PicturePose { at_m: pose.at_m.map(|own| own * MM_PER_M), ..pose };
    pose.point_m(point)
}

/// A point of the ground on the sheet, mm, y down; and its depth.
pub(crate) fn on_sheet(projection: &Projection, point: [f64; 3]) -> ([f64; 2], f64) {
    let [right, up, depth] = projection.project(point);
    ([right, -up], depth)
}

/// All parts on the sheet, the farthest first; of depths that are equal but for round-off in their order.
pub(crate) fn placed<'p>(
    parts: &'p [Part],
    poses: &[PicturePose],
    projection: &Projection,
    around: &Surroundings,
) -> Vec<Placed<'p>> {
    let mut placed: Vec<Placed<'p>> = parts.iter().map(|part| place(part, poses, projection)).collect();
    let step = |own: &Placed<'_>| (own.depth / (SAME_DEPTH * around.radius) + 0.5).floor();
    placed.sort_by(|a, b| step(a).total_cmp(&step(b)));
    placed
}

fn place<'p>(part: &'p Part, poses: &[PicturePose], projection: &Projection) -> Placed<'p> {
    let seen: Vec<([f64; 2], f64)> =
        part.points.iter().map(|point| on_sheet(projection, in_ground(part, *point, poses))).collect();
    let mean =
        |points: &[([f64; 2], f64)]| points.iter().map(|(_, depth)| depth).sum::<f64>() / points.len().max(1) as f64;
    let flat = |points: &[([f64; 2], f64)]| points.iter().map(|(point, _)| *point).collect::<Vec<[f64; 2]>>();
    let hull = || {
        let tuples: Vec<(f64, f64)> = seen.iter().map(|([x, y], _)| (*x, *y)).collect();
        convex_hull(&tuples).into_iter().map(|(x, y)| [x, y]).collect::<Vec<[f64; 2]>>()
    };
    let (points, rim) = match part.kind {
        PartKind::Line | PartKind::Face | PartKind::Ball => (flat(&seen), Vec::new()),
        PartKind::Hull => (hull(), Vec::new()),
        PartKind::Solid => {
            let (first, second) = seen.split_at(RIM_POINTS.min(seen.len()));
            (hull(), flat(if mean(second) > mean(first) { second } else { first }))
        }
    };
    Placed { part, points, rim, depth: mean(&seen) + part.lift }
}

#[cfg(test)]
mod tests {
    use super::{Placed, Surroundings, placed};
    use crate::spatial::parts::{Part, PartKind};
    use crate::spatial::projection::Projection;
    use loosepin_result::spatial_picture::PicturePose;

    fn line(class: &str, body: usize, points: [[f64; 3]; 2]) -> Part {
        let (class, of) = (class.to_owned(), String::new());
        Part { kind: PartKind::Line, class, body, points: points.to_vec(), radius: None, lift: 0.0, of }
    }

    fn classes(placed: &[Placed<'_>]) -> Vec<String> {
        placed.iter().map(|own| own.part.class.clone()).collect()
    }

    #[test]
    fn analytic_what_is_nearer_is_drawn_later_and_the_other_side_shows_the_reverse() {
        // Two rods across each other, one 30 mm behind the other along y.
        let rods = [
            line("behind", 0, [[-50.0, 30.0, 0.0], [50.0, 30.0, 0.0]]),
            line("before", 0, [[0.0, 0.0, -50.0], [0.0, 0.0, 50.0]]),
        ];
        let ground = [PicturePose::GROUND];
        let view = Surroundings::of(&rods, &[ground.to_vec()]);
        assert_eq!(classes(&placed(&rods, &ground, &Projection::FRONT, &view)), ["behind", "before"]);
        let from_behind = Projection { azimuth_rad: std::f64::consts::PI, ..Projection::FRONT };
        assert_eq!(classes(&placed(&rods, &ground, &from_behind, &view)), ["before", "behind"]);
        assert_eq!(view.centre, [0.0, 15.0, 0.0]);
        assert!((view.radius - 15.0_f64.hypot(50.0)).abs() < 1e-5, "{view:?}");
        assert!(view.level(30.0, &Projection::FRONT) > view.level(-60.0, &Projection::FRONT));
    }

    #[test]
    fn analytic_a_part_moves_with_its_body() {
        // A quarter of a turn about z takes (10, 0, 0) to (0, 10, 0), then 5 mm along x.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let pose = PicturePose { at_m: [0.005, 0.0, 0.0], turn: [half, 0.0, 0.0, half] };
        let arm = [line("arm", 1, [[0.0, 0.0, 0.0], [10.0, 0.0, 2.0]])];
        let poses = [PicturePose::GROUND, pose];
        let found = placed(&arm, &poses, &Projection::TOP, &Surroundings::of(&arm, &[poses.to_vec()]));
        let [[x0, y0], [x1, y1]] = found[0].points[..] else { panic!("a line has two ends") };
        for (own, due) in [(x0, 5.0), (y0, 0.0), (x1, 5.0), (y1, -10.0), (found[0].depth, 1.0)] {
            assert!((own - due).abs() < 1e-12, "{found:?}");
        }
    }
}
