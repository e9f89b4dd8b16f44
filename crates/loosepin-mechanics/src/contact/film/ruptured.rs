//! The Reynolds equation of a film that ruptures, solved: what the table of [`super::ReynoldsFilm`] is made from and held against.

use super::motion::FilmForce;
use std::f64::consts::TAU;

/// Cells around the bearing and along half of it, of the coarser of two grids.
const PLACES: usize = 96;
const STATIONS: usize = 12;

/// The film of a bearing with the length ratio Λ at the eccentricity ratio ε under the Reynolds condition: with h = 1 + ε cos θ and the
/// pressure p in units of 6 μ (R/c)²
///
/// p >= 0,   r = 2ε̇ cos θ - wε sin θ - (h³ p')' - h³ p_ζζ/Λ² >= 0,   p r = 0,   p = 0 at ζ = ±1.
///
/// Pressure and slope vanish where the film ruptures. The pressure is the one that maximises the power that the film takes up at a given
/// drag, so that film and motion have a convex potential: twice that is the power lost, which is never negative.
///
/// From two grids by Richardson's extrapolation.
pub(super) struct RupturedFilm {
    grids: [Grid; 2],
}

impl RupturedFilm {
    /// For Λ and ε < 1.
    pub fn new(length_ratio: f64, ratio: f64) -> Self {
        Self { grids: [1, 2].map(|factor| Grid::new(length_ratio, ratio, factor * PLACES, factor * STATIONS)) }
    }

    /// The same with a film that begins so far behind the widest gap, in the sense in which θ grows: at zero as for a bearing whose groove
    /// lies there, later where oil is short.
    pub fn beginning_at(mut self, theta: f64) -> Self {
        self.grids.iter_mut().for_each(|grid| grid.begin = Some(theta));
        self
    }

    /// The force for ε̇ and wε, in units of μ L R³/c². Fast where the motion is near to that of the last call.
    pub fn force(&mut self, squeeze_1_s: f64, wedge_1_s: f64) -> FilmForce<f64> {
        let [coarse, fine] = &mut self.grids;
        let coarse_force = coarse.force([squeeze_1_s, wedge_1_s]);
        fine.begin_with(coarse);
        let (coarse, fine) = (coarse_force, fine.force([squeeze_1_s, wedge_1_s]));
        let extrapolated = |part: usize| (4.0 * fine[part] - coarse[part]) / 3.0;
        FilmForce { radial_n: extrapolated(0), tangential_n: extrapolated(1) }
    }
}

/// Finite volumes: cells that are small where the film is thin and where it is thick, and small at the end of the bearing.
struct Grid {
    /// cos θ and sin θ of each place.
    directions: Vec<[f64; 2]>,
    widths: Vec<f64>,
    heights: Vec<f64>,
    /// Conductance for a height of one through the face before each place.
    around: Vec<f64>,
    /// h³ times the width of each place.
    cubes: Vec<f64>,
    /// Conductance through the face before each station and behind the last one, for h³ times width.
    along: Vec<f64>,
    pressures: Vec<f64>,
    /// Whether the film is unruptured, for each node.
    is_whole: Vec<bool>,
    /// θ from which on there is a film, if not everywhere.
    begin: Option<f64>,
}

impl Grid {
    fn new(length_ratio: f64, ratio: f64, places: usize, stations: usize) -> Self {
        let step = TAU / places as f64;
        let theta: Vec<f64> = (0..places).map(|k| angle((k as f64 + 0.5) * step, ratio)).collect();
        let film_cubed = |theta: f64| (1.0 + ratio * theta.cos()).powi(3);
        let widths: Vec<f64> = theta.iter().map(|&theta| step / density(theta, ratio)).collect();
        let around = (0..places)
            .map(|k| {
                let face = if k == 0 { 0.0 } else { angle(k as f64 * step, ratio) };
                film_cubed(face) * density(face, ratio) / step
            })
            .collect();
        let bend = 0.8 + 0.9 * (1.0 + length_ratio).ln();
        let place = |station: f64| (bend * station / stations as f64).tanh() / bend.tanh();
        let inverse_square = 1.0 / (length_ratio * length_ratio);
        let mut along: Vec<f64> =
            (0..=stations).map(|face| inverse_square / (place(face as f64 + 0.5) - place(face as f64 - 0.5))).collect();
        // No flow through the middle; no pressure at the end, half a station away.
        along[0] = 0.0;
        along[stations] = inverse_square / (1.0 - place(stations as f64 - 0.5));
        Self {
            directions: theta.iter().map(|theta| [theta.cos(), theta.sin()]).collect(),
            heights: (0..stations).map(|m| place(m as f64 + 1.0) - place(m as f64)).collect(),
            cubes: theta.iter().zip(&widths).map(|(&theta, width)| film_cubed(theta) * width).collect(),
            widths,
            around,
            along,
            pressures: vec![0.0; places * stations],
            is_whole: vec![true; places * stations],
            begin: None,
        }
    }

    /// Takes the film of a grid with cells twice as large.
    fn begin_with(&mut self, coarse: &Self) {
        let (stations, half) = (self.heights.len(), coarse.heights.len());
        for (cell, is_whole) in self.is_whole.iter_mut().enumerate() {
            *is_whole = coarse.is_whole[cell / stations / 2 * half + cell % stations / 2];
        }
    }

    /// F_r and F_t by the active set method: cells leave the film where the pressure is negative, and come back where the film would grow.
    fn force(&mut self, rates: [f64; 2]) -> [f64; 2] {
        let stations = self.heights.len();
        let has_oil = |place: usize| {
            let [cosine, sine] = self.directions[place];
            self.begin.is_none_or(|begin| sine.atan2(cosine).rem_euclid(TAU) >= begin)
        };
        let has_oil: Vec<bool> = (0..self.pressures.len()).map(|cell| has_oil(cell / stations)).collect();
        self.is_whole.iter_mut().zip(&has_oil).for_each(|(is_whole, has_oil)| *is_whole &= has_oil);
        // From a whole film the rupture moves by a cell in an iteration.
        for _ in 0..4 * self.widths.len() {
            self.solve(rates);
            let next: Vec<bool> = (0..self.pressures.len())
                .map(|cell| match self.is_whole[cell] {
                    true => self.pressures[cell] > 0.0,
                    false => has_oil[cell] && self.growth(cell, rates) > 1e-14,
                })
                .collect();
            if next == self.is_whole {
                return self.sums();
            }
            self.is_whole = next;
        }
        panic!("the rupture of a film does not settle: {rates:?}");
    }

    fn sums(&self) -> [f64; 2] {
        let stations = self.heights.len();
        let mut sums = [0.0; 2];
        for (pressures, (width, direction)) in
            self.pressures.chunks(stations).zip(self.widths.iter().zip(&self.directions))
        {
            let mean: f64 = pressures.iter().zip(&self.heights).map(|(pressure, height)| pressure * height).sum();
            for part in 0..2 {
                sums[part] += 6.0 * mean * width * direction[part];
            }
        }
        sums
    }

    /// What the motion squeezes into a cell.
    fn source(&self, cell: usize, [squeeze, wedge]: [f64; 2]) -> f64 {
        let (place, station) = (cell / self.heights.len(), cell % self.heights.len());
        let [cosine, sine] = self.directions[place];
        (wedge * sine - 2.0 * squeeze * cosine) * self.widths[place] * self.heights[station]
    }

    /// The neighbours of a cell, with the conductance to each. None beyond the middle; where the pressure is
    /// zero, at the end and at the beginning of the film, the neighbour is `usize::MAX`.
    fn neighbours(&self, cell: usize) -> [(usize, f64); 4] {
        let (places, stations) = (self.widths.len(), self.heights.len());
        let (place, station) = (cell / stations, cell % stations);
        let (before, after) = ((place + places - 1) % places, (place + 1) % places);
        let around = |face: usize, other: usize| {
            let conductance = self.around[face] * self.heights[station];
            // Half a place away from the widest gap.
            let is_begin = self.begin.is_some() && face == 0;
            if is_begin { (usize::MAX, 2.0 * conductance) } else { (other * stations + station, conductance) }
        };
        let along = |face: usize| self.along[face] * self.cubes[place];
        let beyond = if station + 1 < stations { cell + 1 } else { usize::MAX };
        [
            around(place, before),
            around(after, after),
            (cell.saturating_sub(1), along(station)),
            (beyond, along(station + 1)),
        ]
    }

    /// How fast oil would gather in a cell without pressure.
    fn growth(&self, cell: usize, rates: [f64; 2]) -> f64 {
        let inflow = |(other, conductance): (usize, f64)| conductance * self.pressures.get(other).unwrap_or(&0.0);
        self.source(cell, rates) + self.neighbours(cell).into_iter().map(inflow).sum::<f64>()
    }

    /// The whole cells, one place after the other from a ruptured one on, so that the circle is open; from both sides where none is.
    fn order(&self) -> Vec<usize> {
        let (places, stations) = (self.widths.len(), self.heights.len());
        let is_open = |place: usize| self.is_whole[place * stations..][..stations].iter().all(|is_whole| !is_whole);
        let open = (0..places).find(|&place| is_open(place));
        (0..places)
            .map(|k| match open {
                Some(open) => (open + k) % places,
                None if k % 2 == 0 => k / 2,
                None => places - 1 - k / 2,
            })
            .flat_map(|place| place * stations..(place + 1) * stations)
            .filter(|&cell| self.is_whole[cell])
            .collect()
    }

    /// The pressures of the whole cells: the factors of Cholesky within the envelope, row by row.
    fn solve(&mut self, rates: [f64; 2]) {
        let order = self.order();
        let mut numbers = vec![usize::MAX; self.pressures.len()];
        for (number, &cell) in order.iter().enumerate() {
            numbers[cell] = number;
        }
        let mut first = Vec::with_capacity(order.len());
        let mut starts = vec![0];
        let mut entries: Vec<f64> = Vec::new();
        let mut values: Vec<f64> = Vec::with_capacity(order.len());
        for (row, &cell) in order.iter().enumerate() {
            let neighbours = self.neighbours(cell);
            let number = |other: usize| numbers.get(other).copied().filter(|&number| number < row);
            let begin = neighbours.iter().filter_map(|&(other, _)| number(other)).min().unwrap_or(row);
            let start = entries.len();
            entries.resize(start + row - begin + 1, 0.0);
            let (done, entries) = entries.split_at_mut(start);
            for (other, conductance) in neighbours {
                entries[row - begin] += conductance;
                if let Some(column) = number(other).filter(|_| conductance > 0.0) {
                    entries[column - begin] -= conductance;
                }
            }
            for column in begin..row {
                let other = &done[starts[column]..starts[column + 1]];
                let common = begin.max(first[column]);
                let sum = dot(&entries[common - begin..column - begin], &other[common - first[column]..]);
                // The diagonal holds the inverse.
                entries[column - begin] = (entries[column - begin] - sum) * other[column - first[column]];
            }
            let (factors, pivot) = entries.split_at_mut(row - begin);
            pivot[0] = 1.0 / (pivot[0] - dot(factors, factors)).sqrt();
            values.push((self.source(cell, rates) - dot(factors, &values[begin..])) * pivot[0]);
            first.push(begin);
            starts.push(start + row - begin + 1);
        }
        self.pressures.fill(0.0);
        for row in (0..order.len()).rev() {
            let entries = &entries[starts[row]..starts[row + 1]];
            let value = values[row] * entries[row - first[row]];
            for (before, factor) in values[first[row]..row].iter_mut().zip(entries) {
                *before -= factor * value;
            }
            self.pressures[order[row]] = value;
        }
    }
}

/// Σ a_i b_i over the shorter of the two, in eight partial sums.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let length = a.len().min(b.len());
    let whole = length - length % 8;
    for (a, b) in a[..whole].chunks_exact(8).zip(b[..whole].chunks_exact(8)) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    let rest: f64 = a[whole..length].iter().zip(&b[whole..length]).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// ds/dθ of [`angle`]: half evenly over θ, half evenly over Sommerfeld's variable ψ, h = (1 - ε²)/(1 - ε cos ψ).
fn density(theta: f64, ratio: f64) -> f64 {
    0.5 + 0.5 * (1.0 - ratio * ratio).sqrt() / (1.0 + ratio * theta.cos())
}

/// θ at s = ½ (θ + ψ), from 0 to 2π.
fn angle(s: f64, ratio: f64) -> f64 {
    let psi = |theta: f64| {
        let (sine, cosine) = (0.5 * theta).sin_cos();
        2.0 * ((1.0 - ratio).sqrt() * sine).atan2((1.0 + ratio).sqrt() * cosine)
    };
    // By halves: Newton's method runs in circles where the film is thin.
    let (mut low, mut high) = (0.0, TAU);
    for _ in 0..54 {
        let middle = 0.5 * (low + high);
        if 0.5 * (middle + psi(middle)) > s {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peer_forces_of_films_that_rupture() {
        /// Relative tolerance of the force: the difference between two grids after extrapolation, in the peer and here.
        const RELATIVE: f64 = 1e-4;
        // ε, Λ, ε̇, wε, then F_r and F_t: tools/film/ruptured.py.
        for [ratio, length_ratio, squeeze_1_s, wedge_1_s, radial, tangential] in [
            [0.3, 0.5, 0.8, 0.9, -2.713_235_14, 0.960_606_23],
            [0.6, 1.0, 0.0, 1.1, -2.960_618_78, 3.786_490_24],
            [0.6, 1.3, -0.4, 0.7, 0.932_804_81, 1.752_639_46],
            [0.85, 0.4, 0.3, -1.2, -22.607_582_61, -4.528_080_84],
            [0.85, 2.5, 0.6, 0.5, -131.735_497_97, 9.461_538_59],
        ] {
            let found = RupturedFilm::new(length_ratio, ratio).force(squeeze_1_s, wedge_1_s);
            let error =
                (found.radial_n - radial).hypot(found.tangential_n - tangential) / f64::hypot(radial, tangential);
            assert!(error < RELATIVE, "ε = {ratio}, L/D = {length_ratio}: {found:?}, off by {error}");
        }
    }
}
