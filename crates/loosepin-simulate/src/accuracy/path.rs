//! Paths of points, with the zones in which play and scatter let them be, to first order: `loosepin_result::point_path`.

use super::accuracy_output::speed_of_no_direction_m_s;
use super::play_reach::PlayReach;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Axis, PointId, Position, Relative, relative_words};
use loosepin_result::point_path::{ELLIPSE_SHARE, PointPath, REACH_DIRECTIONS, direction_rad};

/// Fills the paths, position by position.
pub(super) struct PathRecorder {
    paths: Vec<RecordedPath>,
    /// Unit vectors in the directions of the reach.
    directions: Vec<Vec2<f64>>,
    /// Unit vectors among which the furthest reach of a point without direction is sought.
    all_round: Vec<Vec2<f64>>,
    /// Standard deviations over semi-axes of the ellipse of the scatter: √(-2 ln(1 - share)).
    semi_axes: f64,
}

/// Directions over half a turn among which the furthest reach is sought: it is found to 1 - cos(90°/512), 5e-6.
const ALL_ROUND: usize = 32 * REACH_DIRECTIONS;

struct RecordedPath {
    /// Places of x and y among the readings.
    places: [usize; 2],
    path: PointPath,
    /// Displacement by a standard deviation of each dimension at the present position, m.
    scatter_m: Vec<Vec2<f64>>,
}

/// The paths of outputs in file order, then of `points` that are none; their readings are added to `readings` where they are not there.
pub(super) fn points_of_paths(mechanism: &Mechanism, points: &[PointId], readings: &mut Vec<Position>) -> PathRecorder {
    let model = &mechanism.model;
    let of_output = model.outputs.iter().filter_map(|output| Some((Some(output.name.clone()), output.kind.path()?)));
    let mut asked: Vec<(Option<String>, Relative<PointId>)> = of_output.collect();
    for point in points.iter().map(|point| Relative::to_ground(*point)) {
        if asked.iter().all(|(_, known)| *known != point) {
            asked.push((None, point));
        }
    }
    let mut place = |reading: Position| {
        readings.iter().position(|known| *known == reading).unwrap_or_else(|| {
            readings.push(reading);
            readings.len() - 1
        })
    };
    let of_point = |(output, point): (Option<String>, Relative<PointId>)| {
        let words = relative_words(model, point);
        let name = output.clone().unwrap_or_else(|| words.clone());
        RecordedPath {
            places: [Axis::X, Axis::Y].map(|axis| place(Position::Point(point, axis))),
            path: PointPath { name, point: words, output, ..PointPath::default() },
            scatter_m: Vec::new(),
        }
    };
    PathRecorder {
        paths: asked.into_iter().map(of_point).collect(),
        directions: (0..REACH_DIRECTIONS).map(|direction| unit_vector(direction_rad(direction))).collect(),
        all_round: (0..ALL_ROUND)
            .map(|direction| unit_vector(std::f64::consts::PI * direction as f64 / ALL_ROUND as f64))
            .collect(),
        semi_axes: (-2.0 * (1.0 - ELLIPSE_SHARE).ln()).sqrt(),
    }
}

fn unit_vector(angle_rad: f64) -> Vec2<f64> {
    let (sine, cosine) = angle_rad.sin_cos();
    Vec2::new(cosine, sine)
}

/// How far plays take a point along a unit vector, m, from the gradients of each reading by each play.
pub(super) fn reach_by_gradients_m(
    gradients: &[Vec<Vec2<f64>>],
    reaches: &[PlayReach],
    [x, y]: [usize; 2],
    direction: Vec2<f64>,
) -> f64 {
    let gradients = gradients[x].iter().zip(&gradients[y]);
    let effects = gradients
        .zip(reaches)
        .map(|((of_x, of_y), reach)| reach.worst_case_si(*of_x * direction.x + *of_y * direction.y));
    effects.sum()
}

impl PathRecorder {
    /// Takes the directions of motion at all positions from value, velocity and acceleration of each reading. Where a point is slower than a
    /// hundredth of its mean speed, or as slow as round-off, its motion has none.
    pub fn take_directions(&mut self, jets: &[Vec<[f64; 3]>], round_off_m_s: f64) {
        for RecordedPath { places: [x, y], path, .. } in &mut self.paths {
            let velocities_m_s: Vec<Vec2<f64>> =
                jets.iter().map(|readings| Vec2::new(readings[*x][1], readings[*y][1])).collect();
            let speeds_m_s: Vec<f64> = velocities_m_s.iter().map(|velocity| velocity.length()).collect();
            let least_m_s = speed_of_no_direction_m_s(&speeds_m_s, round_off_m_s);
            for (velocity, speed_m_s) in velocities_m_s.iter().zip(speeds_m_s) {
                let tangent = if speed_m_s > least_m_s { *velocity * (1.0 / speed_m_s) } else { Vec2::zero() };
                path.tangent_x.push(tangent.x);
                path.tangent_y.push(tangent.y);
            }
        }
    }

    /// Name of each path, and the places of its coordinates among the readings.
    pub fn places(&self) -> impl Iterator<Item = (&str, [usize; 2])> {
        self.paths.iter().map(|recorded| (recorded.path.name.as_str(), recorded.places))
    }

    /// Takes a position: value, velocity and acceleration of each reading, and how far play takes the point whose coordinates are at two places of
    /// the readings along each of some unit vectors, m; not a number where that is not known.
    pub fn record(&mut self, readings: &[[f64; 3]], reaches_m: impl Fn([usize; 2], &[Vec2<f64>]) -> Vec<f64>) {
        for RecordedPath { places: [x, y], path, .. } in &mut self.paths {
            for (list, value) in
                [&mut path.x_m, &mut path.velocity_x_m_s, &mut path.acceleration_x_m_s2].into_iter().zip(readings[*x])
            {
                list.push(value);
            }
            for (list, value) in
                [&mut path.y_m, &mut path.velocity_y_m_s, &mut path.acceleration_y_m_s2].into_iter().zip(readings[*y])
            {
                list.push(value);
            }
            let reaches_m = |directions: &[Vec2<f64>]| reaches_m([*x, *y], directions);
            path.play_reach_m.extend(reaches_m(&self.directions));
            let position = path.play_along_m.len();
            let [along_m, across_m] = if path.stands_still(position) {
                // In this order what is not a number is the largest.
                [reaches_m(&self.all_round).into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN); 2]
            } else {
                let tangent = Vec2::new(path.tangent_x[position], path.tangent_y[position]);
                let reaches_m = reaches_m(&[tangent, Vec2::new(-tangent.y, tangent.x)]);
                [reaches_m[0], reaches_m[1]]
            };
            path.play_along_m.push(along_m);
            path.play_across_m.push(across_m);
        }
    }

    /// Nothing is known of play, nor was it in the positions so far.
    pub fn forget_play(&mut self) {
        for RecordedPath { path, .. } in &mut self.paths {
            path.play_reach_m
                .iter_mut()
                .chain(&mut path.play_along_m)
                .chain(&mut path.play_across_m)
                .for_each(|reach_m| *reach_m = f64::NAN);
        }
    }

    /// Adds the effect of a dimension at the present position: derivative of each reading.
    pub fn add_scatter(&mut self, standard_deviation_si: f64, derivatives: &[f64]) {
        for RecordedPath { places: [x, y], scatter_m, .. } in &mut self.paths {
            scatter_m.push(Vec2::new(derivatives[*x], derivatives[*y]) * standard_deviation_si);
        }
    }

    /// Takes the ellipse of the dimensions of the present position; `correlated` holds two of them and twice their correlation.
    pub fn end_scatter(&mut self, correlated: &[(usize, usize, f64)]) {
        for RecordedPath { path, scatter_m, .. } in &mut self.paths {
            let [mut xx, mut xy, mut yy] = [0.0; 3];
            for each in scatter_m.iter() {
                xx += each.x * each.x;
                xy += each.x * each.y;
                yy += each.y * each.y;
            }
            for &(first, second, twice) in correlated {
                let [a, b] = [scatter_m[first], scatter_m[second]];
                xx += twice * a.x * b.x;
                xy += 0.5 * twice * (a.x * b.y + a.y * b.x);
                yy += twice * a.y * b.y;
            }
            scatter_m.clear();
            // Eigenvalues of the covariance: (xx + yy)/2 ± √(((xx - yy)/2)² + xy²).
            let [middle, half] = [0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy)];
            path.scatter_major_m.push(self.semi_axes * (middle + half).max(0.0).sqrt());
            // What cancels in full leaves round-off, of either sign.
            path.scatter_minor_m.push(self.semi_axes * (middle - half).max(0.0).sqrt());
            path.scatter_angle_rad.push(0.5 * (2.0 * xy).atan2(xx - yy));
        }
    }

    /// The finished paths.
    pub fn into_paths(self) -> Vec<PointPath> {
        self.paths.into_iter().map(|recorded| recorded.path).collect()
    }
}
