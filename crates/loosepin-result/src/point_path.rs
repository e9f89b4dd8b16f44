//! Record of the path of a point with the zone in which the point can be: plain data in SI, and numbers that follow from it alone.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// Directions in which the reach of a zone is recorded: half a turn, since a zone by play reaches as far in the opposite direction.
pub const REACH_DIRECTIONS: usize = 16;
/// Corners of the polygon about a zone.
pub const ZONE_CORNERS: usize = 2 * REACH_DIRECTIONS;
/// Share of mechanisms whose point lies in the ellipse of the scatter, if displacements are normally distributed.
pub const ELLIPSE_SHARE: f64 = 0.95;

/// The ideal path of a point over the cycle, and at each angle of the drive the zone in which the point can be, quasi-statically and to
/// first order.
///
/// With the gradients g_k of joints with play and the displacements e_k that their clearances allow, play takes the point by
/// d = Σ g_k·e_k. The set of all d is a sum of ellipses, segments and parallelograms; it is recorded by its support function, the reach
/// h(n) = max n·d. The scatter of dimensions has the covariance C = Σ σ_i σ_j ρ_ij ∂r/∂p_i (∂r/∂p_j)ᵀ; its ellipse holds 95 % of a normal
/// distribution in the plane: dᵀ C⁻¹ d ≤ -2 ln 0.05.
///
/// In space the zone has no recorded outline here, and no ellipse: it is known by its reach along and across the motion and by the longest d.
/// Pictures have its hull.
///
/// The reaches of play are not numbers where nothing is known of it.
///
/// All lists have one entry per angle of the drive, unless said otherwise.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct PointPath {
    /// Name: of the output that it is, or of the point, for example `coupler.tip`.
    pub name: String,
    /// The point in words: `coupler.tip`, or `coupler.tip relative to crank.pin`.
    pub point: String,
    /// The output that is this path, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    /// Positions on the ideal path, m.
    #[serde(with = "extended")]
    pub x_m: Vec<f64>,
    /// Positions on the ideal path, m.
    #[serde(with = "extended")]
    pub y_m: Vec<f64>,
    /// Positions on the ideal path, m; empty in the plane.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub z_m: Vec<f64>,
    /// Velocities at the speed of the drive, m/s; empty in records of older versions.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub velocity_x_m_s: Vec<f64>,
    /// Velocities, m/s.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub velocity_y_m_s: Vec<f64>,
    /// Velocities, m/s; empty in the plane.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub velocity_z_m_s: Vec<f64>,
    /// Accelerations at the speed of the drive, m/s²; empty in records of older versions.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub acceleration_x_m_s2: Vec<f64>,
    /// Accelerations, m/s².
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub acceleration_y_m_s2: Vec<f64>,
    /// Accelerations, m/s²; empty in the plane.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub acceleration_z_m_s2: Vec<f64>,
    /// Unit vectors along the motion; zero where the point stands still.
    #[serde(with = "extended")]
    pub tangent_x: Vec<f64>,
    /// Unit vectors along the motion.
    #[serde(with = "extended")]
    pub tangent_y: Vec<f64>,
    /// Unit vectors along the motion; empty in the plane.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub tangent_z: Vec<f64>,
    /// Reach h of the play, m: for each angle of the drive [`REACH_DIRECTIONS`] numbers, for the directions 0°, 11.25°, ... 168.75° from the
    /// x axis. Empty in space.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub play_reach_m: Vec<f64>,
    /// Reach of the play along the motion, to either side, m; where the point stands still the largest |d|, which older versions give as 0.
    #[serde(with = "extended")]
    pub play_along_m: Vec<f64>,
    /// Reach of the play across the motion, to either side, m, in space the longest displacement across it; where the point stands still as
    /// along it.
    #[serde(with = "extended")]
    pub play_across_m: Vec<f64>,
    /// The largest |d| by play in whatever direction, m; empty in the plane.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub play_longest_m: Vec<f64>,
    /// Larger semi-axis of the 95 % ellipse of the scatter, m; empty where nothing scatters.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub scatter_major_m: Vec<f64>,
    /// Smaller semi-axis, m; empty where nothing scatters.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub scatter_minor_m: Vec<f64>,
    /// Angle of the larger semi-axis from the x axis, rad; empty where nothing scatters.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub scatter_angle_rad: Vec<f64>,
}

/// Paths over one cycle with the angle of the drive that they belong to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CyclePaths {
    /// Name of the drive, or `cycle`.
    pub drive: String,
    /// Angle of the drive, increasing.
    #[serde(with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// The paths.
    pub paths: Vec<PointPath>,
}

impl PointPath {
    /// Number of positions.
    pub fn positions(&self) -> usize {
        self.x_m.len()
    }

    /// Whether the point moves in space.
    pub fn is_in_space(&self) -> bool {
        !self.z_m.is_empty()
    }

    /// Whether each list has the length that it must have.
    pub fn is_complete(&self) -> bool {
        let positions = self.positions();
        let lists = [&self.y_m, &self.tangent_x, &self.tangent_y, &self.play_along_m, &self.play_across_m];
        let in_space =
            [&self.z_m, &self.tangent_z, &self.play_longest_m, &self.velocity_z_m_s, &self.acceleration_z_m_s2];
        let reaches = if self.is_in_space() { 0 } else { REACH_DIRECTIONS * positions };
        let are_whole_or_absent = |lists: &[&Vec<f64>]| {
            lists.iter().all(|list| list.len() == positions) || lists.iter().all(|list| list.is_empty())
        };
        let rates = [&self.velocity_x_m_s, &self.velocity_y_m_s, &self.acceleration_x_m_s2, &self.acceleration_y_m_s2];
        lists.iter().all(|list| list.len() == positions)
            && self.play_reach_m.len() == reaches
            && are_whole_or_absent(&in_space)
            && are_whole_or_absent(&rates)
            && are_whole_or_absent(&[&self.scatter_major_m, &self.scatter_minor_m, &self.scatter_angle_rad])
    }

    /// Speeds, m/s; empty in records of older versions.
    pub fn speeds_m_s(&self) -> Vec<f64> {
        magnitudes([&self.velocity_x_m_s, &self.velocity_y_m_s, &self.velocity_z_m_s])
    }

    /// Magnitudes of the acceleration, m/s²; empty in records of older versions.
    pub fn acceleration_magnitudes_m_s2(&self) -> Vec<f64> {
        magnitudes([&self.acceleration_x_m_s2, &self.acceleration_y_m_s2, &self.acceleration_z_m_s2])
    }

    /// Whether it is known how far play takes the point.
    pub fn is_play_known(&self) -> bool {
        !self.play_along_m.iter().chain(&self.play_across_m).chain(&self.play_reach_m).any(|reach_m| reach_m.is_nan())
    }

    /// Whether play takes the point off its path.
    pub fn has_play(&self) -> bool {
        self.play_reach_m.iter().chain(&self.play_longest_m).any(|reach_m| *reach_m > 0.0)
    }

    /// Whether scatter does.
    pub fn has_scatter(&self) -> bool {
        self.scatter_major_m.iter().any(|major_m| *major_m > 0.0)
    }

    /// Whether anything takes the point off its path, and it is known how far.
    pub fn has_zone(&self) -> bool {
        self.is_play_known() && (self.has_play() || self.has_scatter())
    }

    /// Reach of play and of the ellipse of the scatter together in recorded direction `direction`, m.
    pub fn reach_m(&self, position: usize, direction: usize) -> f64 {
        let direction = direction % REACH_DIRECTIONS;
        self.play_reach_m[position * REACH_DIRECTIONS + direction]
            + self.scatter_reach_m(position, direction_rad(direction))
    }

    /// Reach of the ellipse of the scatter in the direction of an angle from the x axis, m: √(a² cos² φ + b² sin² φ).
    pub fn scatter_reach_m(&self, position: usize, angle_rad: f64) -> f64 {
        let Some(major_m) = self.scatter_major_m.get(position) else { return 0.0 };
        let (sine, cosine) = (angle_rad - self.scatter_angle_rad[position]).sin_cos();
        (major_m * cosine).hypot(self.scatter_minor_m[position] * sine)
    }

    /// Whether the point is too slow at a position for its motion to have a direction.
    pub fn stands_still(&self, position: usize) -> bool {
        let along_z = self.tangent_z.get(position).copied().unwrap_or(0.0);
        self.tangent_x[position] == 0.0 && self.tangent_y[position] == 0.0 && along_z == 0.0
    }

    /// Whether it does so at each position: it has no path.
    pub fn always_stands_still(&self) -> bool {
        (0..self.positions()).all(|position| self.stands_still(position))
    }

    /// Reach of play and scatter along and across the motion, m. Where the point stands still there are no such directions: both are the
    /// distance |d| that it does not exceed.
    pub fn along_and_across_m(&self, position: usize) -> [f64; 2] {
        if self.stands_still(position) {
            return [self.furthest_m(position); 2];
        }
        if self.is_in_space() {
            return [self.play_along_m[position], self.play_across_m[position]];
        }
        let angle_rad = self.tangent_y[position].atan2(self.tangent_x[position]);
        [
            self.play_along_m[position] + self.scatter_reach_m(position, angle_rad),
            self.play_across_m[position] + self.scatter_reach_m(position, angle_rad + std::f64::consts::FRAC_PI_2),
        ]
    }

    /// Largest |d| by play, and in the plane by the larger semi-axis of the scatter together, m.
    fn furthest_m(&self, position: usize) -> f64 {
        if let Some(longest_m) = self.play_longest_m.get(position) {
            return *longest_m;
        }
        let recorded_m = &self.play_reach_m[position * REACH_DIRECTIONS..][..REACH_DIRECTIONS];
        let play_m = recorded_m.iter().copied().fold(self.play_along_m[position], f64::max);
        play_m + self.scatter_major_m.get(position).copied().unwrap_or(0.0)
    }

    /// Corners of the polygon about the zone of the play, relative to the position on the path, m, against the clock: the least polygon
    /// with sides in the recorded directions that holds the zone. Each side touches it; between them its corners lie beyond the zone by at
    /// most 10 % of the largest reach (R tan 5.6°, for a segment), by 0.5 % for a disc. Empty in space.
    pub fn play_zone_m(&self, position: usize) -> Vec<[f64; 2]> {
        if self.is_in_space() {
            return Vec::new();
        }
        let start = position * REACH_DIRECTIONS;
        zone_corners(|direction| self.play_reach_m[start + direction % REACH_DIRECTIONS])
    }

    /// Corners of the polygon about the zone of play and scatter together: wherever the parts in the ellipse of the scatter lie,
    /// whatever the play does. As [`Self::play_zone_m`].
    pub fn zone_m(&self, position: usize) -> Vec<[f64; 2]> {
        if self.is_in_space() {
            return Vec::new();
        }
        zone_corners(|direction| self.reach_m(position, direction))
    }
}

/// Angle of a recorded direction from the x axis, rad.
pub fn direction_rad(direction: usize) -> f64 {
    std::f64::consts::PI * direction as f64 / REACH_DIRECTIONS as f64
}

/// Magnitudes of vectors by their components; those of z are empty in the plane.
fn magnitudes([x, y, z]: [&[f64]; 3]) -> Vec<f64> {
    let in_plane = x.iter().zip(y).map(|(x, y)| x.hypot(*y));
    in_plane.enumerate().map(|(k, length)| z.get(k).map_or(length, |z| length.hypot(*z))).collect()
}

/// Corners of the polygon whose sides have these directions as normals and these distances from the middle.
///
/// Two lines n·d = h and n'·d = h' whose normals are turned by δ meet in (h n'⊥ - h' n⊥)/sin δ with n⊥ = (-n_y, n_x), rotated by
/// -90°: d = (h sin φ' - h' sin φ, h' cos φ - h cos φ')/sin δ.
fn zone_corners(reach_m: impl Fn(usize) -> f64) -> Vec<[f64; 2]> {
    let sine_of_step = direction_rad(1).sin();
    (0..ZONE_CORNERS)
        .map(|side| {
            let [own_m, next_m] = [reach_m(side), reach_m(side + 1)];
            let [(sine, cosine), (next_sine, next_cosine)] = [side, side + 1].map(|side| direction_rad(side).sin_cos());
            [(own_m * next_sine - next_m * sine) / sine_of_step, (next_m * cosine - own_m * next_cosine) / sine_of_step]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_reach(reach_m: impl Fn(f64) -> f64) -> PointPath {
        PointPath {
            x_m: vec![0.0],
            y_m: vec![0.0],
            tangent_x: vec![1.0],
            tangent_y: vec![0.0],
            play_reach_m: (0..REACH_DIRECTIONS).map(|direction| reach_m(direction_rad(direction))).collect(),
            play_along_m: vec![reach_m(0.0)],
            play_across_m: vec![reach_m(std::f64::consts::FRAC_PI_2)],
            ..PointPath::default()
        }
    }

    #[test]
    fn analytic_the_polygon_about_a_disc_is_regular_and_touches_it() {
        let path = of_reach(|_| 2.0);
        let corners = path.play_zone_m(0);
        assert_eq!(corners.len(), ZONE_CORNERS);
        let due = 2.0 / (std::f64::consts::PI / ZONE_CORNERS as f64).cos();
        for (corner, next) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            assert!((corner[0].hypot(corner[1]) - due).abs() < 1e-14, "{corner:?}");
            let middle = [0.5 * (corner[0] + next[0]), 0.5 * (corner[1] + next[1])];
            assert!((middle[0].hypot(middle[1]) - 2.0).abs() < 1e-14, "{middle:?}");
            assert!(corner[0] * next[1] - corner[1] * next[0] > 0.0, "against the clock");
        }
    }

    #[test]
    fn analytic_the_polygon_about_a_segment_along_a_recorded_direction_is_thin_and_exact() {
        // Along 45°, from -3 to 3: reach 3 |cos(φ - 45°)|.
        let path = of_reach(|angle_rad| 3.0 * (angle_rad - std::f64::consts::FRAC_PI_4).cos().abs());
        let half = 3.0 / 2.0_f64.sqrt();
        for [x, y] in path.play_zone_m(0) {
            assert!((x - y).abs() < 1e-14 && x.abs() <= half + 1e-14, "{x} {y}");
        }
        assert!(path.play_zone_m(0).iter().any(|[x, _]| (x - half).abs() < 1e-14));
    }

    #[test]
    fn analytic_scatter_adds_its_reach_in_each_direction() {
        let mut path = of_reach(|_| 1.0);
        path.scatter_major_m = vec![4.0];
        path.scatter_minor_m = vec![3.0];
        path.scatter_angle_rad = vec![std::f64::consts::FRAC_PI_2];
        assert!(path.is_complete());
        assert!((path.reach_m(0, 0) - 4.0).abs() < 1e-14 && (path.reach_m(0, 8) - 5.0).abs() < 1e-14);
        let [along, across] = path.along_and_across_m(0);
        assert!((along - 4.0).abs() < 1e-14 && (across - 5.0).abs() < 1e-14);
        let top = path.zone_m(0).iter().fold(0.0, |most: f64, [_, y]| most.max(*y));
        assert!((top - 5.0).abs() < 1e-14, "{top}");
    }
}
