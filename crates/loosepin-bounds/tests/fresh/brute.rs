//! Extremes of functions of one or two numbers in the unit box by brute force: a grid, then smaller and smaller grids around its best
//! local extremes and around every place that is known to matter.

/// Points of the grid on an axis.
const ALONG_ONE: usize = 20_001;
const ALONG_TWO: usize = 201;
/// From so many of the best local extremes of the grid the search goes on.
const STARTS: usize = 12;
/// Each grid around a start is this share as wide as the one before; the last is narrower than round-off.
const SHRINK: f64 = 0.6;
const GRIDS: usize = 66;
/// Points of such a grid on either side of its centre.
const AROUND: i32 = 2;

/// A line in the unit box, along which goes a number in \[0, 1\].
pub type Curve = Box<dyn Fn(f64) -> Vec<f64>>;

/// An extreme and where it is.
#[derive(Debug, Clone)]
pub struct Extreme {
    pub value: f64,
    /// Its place in the unit box.
    pub at: Vec<f64>,
}

/// The least and the greatest value of `f`; `known` are places, and `curves` lines, where it may have a sharp extreme.
pub fn extremes(f: &dyn Fn(&[f64]) -> f64, dimensions: usize, known: &[Vec<f64>], curves: &[Curve]) -> [Extreme; 2] {
    let mut ends = of_box(f, dimensions, known);
    for curve in curves {
        for (end, along) in ends.iter_mut().zip(of_box(&|s| f(&curve(s[0])), 1, &[])) {
            let is_further = if along.sign < 0.0 {
                along.extreme.value < end.extreme.value
            } else {
                along.extreme.value > end.extreme.value
            };
            if is_further {
                end.extreme = Extreme { at: curve(along.extreme.at[0]), ..along.extreme };
            }
        }
    }
    ends.map(|end| end.extreme)
}

/// An extreme on one side: the least value, sign -1, or the greatest, sign 1.
struct End {
    sign: f64,
    extreme: Extreme,
}

fn of_box(f: &dyn Fn(&[f64]) -> f64, dimensions: usize, known: &[Vec<f64>]) -> [End; 2] {
    let per_axis = if dimensions == 1 { ALONG_ONE } else { ALONG_TWO };
    let step = 1.0 / (per_axis - 1) as f64;
    let place = |index: usize| -> Vec<f64> {
        (0..dimensions).map(|axis| (index / per_axis.pow(axis as u32) % per_axis) as f64 * step).collect()
    };
    let values: Vec<f64> = (0..per_axis.pow(dimensions as u32)).map(|index| f(&place(index))).collect();
    [-1.0, 1.0].map(|sign| {
        let is_local = |index: usize| {
            (0..dimensions).all(|axis| {
                let stride = per_axis.pow(axis as u32);
                let at = index / stride % per_axis;
                (at == 0 || sign * values[index - stride] <= sign * values[index])
                    && (at + 1 == per_axis || sign * values[index + stride] <= sign * values[index])
            })
        };
        let mut starts: Vec<usize> = (0..values.len()).filter(|&index| is_local(index)).collect();
        starts.sort_by(|&a, &b| (sign * values[b]).total_cmp(&(sign * values[a])));
        starts.truncate(STARTS);
        let starts = starts.into_iter().map(place).chain(known.iter().cloned());
        let climbed = starts.map(|start| climb(&|at| sign * f(at), start, 2.0 * step));
        let best = climbed.reduce(|best, other| if other.value > best.value { other } else { best });
        let best = best.expect("a grid has points");
        End { sign, extreme: Extreme { value: sign * best.value, ..best } }
    })
}

fn climb(f: &dyn Fn(&[f64]) -> f64, start: Vec<f64>, width: f64) -> Extreme {
    let mut best = Extreme { value: f(&start), at: start };
    let mut width = width;
    let across = 2 * AROUND + 1;
    for _ in 0..GRIDS {
        let centre = best.at.clone();
        for index in 0..across.pow(centre.len() as u32) {
            let along = |(axis, centre): (usize, &f64)| {
                let step = index / across.pow(axis as u32) % across - AROUND;
                (centre + 0.5 * width * f64::from(step)).clamp(0.0, 1.0)
            };
            let at: Vec<f64> = centre.iter().enumerate().map(along).collect();
            let value = f(&at);
            if value > best.value {
                best = Extreme { value, at };
            }
        }
        width *= SHRINK;
    }
    best
}
