//! The numbers of springs with their dampers.

use crate::mechanism::tree::points::point_m;
use crate::model::{Elasticity, Model, Spring, TableCurve, Values};
use loosepin_math::{
    Numbers, Pieces, Real, Vec2, cubic_piece, cubic_with_slopes, monotone_slopes, natural_spline, numbers,
};

/// Numbers of a spring: it pulls with F(x) + d ẋ, x its length, m, or the angle of the second body from the first, rad.
#[derive(Debug, Clone)]
pub struct SpringGeometry<T> {
    /// End points in the frames of the first and second body, m; zero for a torsional spring.
    pub arms_m: [Vec2<T>; 2],
    /// F.
    pub elastic: ElasticNumbers<T>,
    /// Damping d, N s/m or N m s/rad.
    pub damping: T,
    /// Length below which it has no direction although it pushes, m; zero for one that pulls with nothing at length zero.
    pub shortest_m: T,
}

numbers!(struct SpringGeometry { arms_m, elastic, damping, shortest_m });

/// Share of the length over which the force changes by itself below which a spring counts as pressed to length zero.
const SHORTEST_SHARE: f64 = 1e-6;

/// Numbers of the elastic pull.
#[derive(Debug, Clone)]
pub enum ElasticNumbers<T> {
    /// P + k (x - x0).
    Linear {
        /// Stiffness k, N/m or N m/rad.
        stiffness: T,
        /// Free length or angle x0, m or rad.
        free: T,
        /// Pull or torque P at the free length or angle, N or N m.
        preload: T,
    },
    /// A curve of cubic pieces, straight beyond its ends: origin, coefficients c_0 to c_3, and energy at the origin of each piece.
    Table(Pieces<T, 6>),
}

numbers!(enum ElasticNumbers { Linear { stiffness, free, preload }, Table(pieces) });

impl<T: Real> ElasticNumbers<T> {
    fn new(elasticity: &Elasticity, values: &Values) -> Self {
        let number = |id| T::from_f64(values[id]);
        match elasticity {
            Elasticity::Linear { stiffness, free, preload } => {
                Self::Linear { stiffness: number(*stiffness), free: number(*free), preload: number(*preload) }
            }
            Elasticity::Table { points, curve } => {
                let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(|id| values[id])).collect();
                Self::Table(Pieces::broadcast(&pieces(&points, *curve)))
            }
        }
    }
}

/// Straight before the first point, the curve between the points, straight behind the last one; with the energy since the first
/// point.
fn pieces(points: &[[f64; 2]], curve: TableCurve) -> Pieces<f64, 6> {
    let last = points.len() - 1;
    let cubics: Vec<[f64; 4]> = match curve {
        TableCurve::Spline => {
            let moments = natural_spline(points);
            (0..last).map(|k| cubic_piece(points[k], points[k + 1], [moments[k], moments[k + 1]])).collect()
        }
        TableCurve::Monotone => {
            let slopes = monotone_slopes(points);
            (0..last).map(|k| cubic_with_slopes(points[k], points[k + 1], [slopes[k], slopes[k + 1]])).collect()
        }
    };
    let mut energy_j = 0.0;
    let mut numbers = vec![[points[0][0], points[0][1], cubics[0][1], 0.0, 0.0, 0.0]];
    let mut end_slope = 0.0;
    for (k, [c0, c1, c2, c3]) in cubics.into_iter().enumerate() {
        let h = points[k + 1][0] - points[k][0];
        numbers.push([points[k][0], c0, c1, c2, c3, energy_j]);
        energy_j += h * (c0 + h * (c1 / 2.0 + h * (c2 / 3.0 + h * c3 / 4.0)));
        end_slope = c1 + h * (2.0 * c2 + h * 3.0 * c3);
    }
    numbers.push([points[last][0], points[last][1], end_slope, 0.0, 0.0, energy_j]);
    Pieces::new(points.iter().map(|point| point[0]).collect(), numbers)
}

/// Length below which a spring along a line has no direction, m: a share of its free length, or of the longest one of its table. Zero where it
/// pulls with nothing at length zero: then its force goes through zero smoothly.
fn shortest_m(elasticity: &Elasticity, values: &Values) -> f64 {
    let pulls = SpringGeometry::<f64> {
        arms_m: [Vec2::zero(); 2],
        elastic: ElasticNumbers::new(elasticity, values),
        damping: 0.0,
        shortest_m: 0.0,
    };
    let scale_m = match elasticity {
        Elasticity::Linear { free, .. } => values[*free],
        Elasticity::Table { points, .. } => points.iter().map(|point| values[point[0]].abs()).fold(0.0, f64::max),
    };
    if pulls.pull(0.0, 0.0) == 0.0 { 0.0 } else { SHORTEST_SHARE * scale_m }
}

impl<T: Real> SpringGeometry<T> {
    /// Lays out `values` for a spring of `model`.
    pub fn new(model: &Model, spring: &Spring, values: &Values) -> Self {
        let points = spring.kind.points();
        Self {
            arms_m: points.map_or([Vec2::zero(); 2], |points| points.map(|point| point_m(model, values, point))),
            elastic: ElasticNumbers::new(&spring.elasticity, values),
            damping: spring.damping.map_or(T::zero(), |id| T::from_f64(values[id])),
            shortest_m: T::from_f64(points.map_or(0.0, |_| shortest_m(&spring.elasticity, values))),
        }
    }

    /// The pull F(x) + d ẋ, N or N m, at `extent` x and its `rate` ẋ.
    #[inline(always)]
    pub fn pull(&self, extent: T, rate: T) -> T {
        let elastic = match &self.elastic {
            ElasticNumbers::Linear { stiffness, free, preload } => stiffness.mul_add(extent - *free, *preload),
            ElasticNumbers::Table(pieces) => {
                let [origin, c0, c1, c2, c3, _] = pieces.at(extent);
                let u = extent - origin;
                c3.mul_add(u, c2).mul_add(u, c1).mul_add(u, c0)
            }
        };
        self.damping.mul_add(rate, elastic)
    }

    /// Stored energy at `extent`, J: k (x - x0)²/2 + P (x - x0), or ∫ F dx from the first point of a table.
    #[inline(always)]
    pub fn stored_energy_j(&self, extent: T) -> T {
        match &self.elastic {
            ElasticNumbers::Linear { stiffness, free, preload } => {
                let stretch = extent - *free;
                stretch * (T::from_f64(0.5) * *stiffness).mul_add(stretch, *preload)
            }
            ElasticNumbers::Table(pieces) => {
                let [origin, c0, c1, c2, c3, before] = pieces.at(extent);
                let (u, share) = (extent - origin, |part: f64| T::from_f64(1.0 / part));
                let over = (c3 * share(4.0)).mul_add(u, c2 * share(3.0)).mul_add(u, c1 * share(2.0)).mul_add(u, c0);
                over.mul_add(u, before)
            }
        }
    }

    /// Power that the damper turns into heat, W: d ẋ².
    #[inline(always)]
    pub fn damping_loss_w(&self, rate: T) -> T {
        self.damping * rate.squared()
    }
}
