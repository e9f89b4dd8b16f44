//! Smoothers of parts of the box, where there are more points than one smoother factorises.
//!
//! Up to [`MAX_TOGETHER`] points are seen by one smoother. More of them are divided, always in half along the longest side of a
//! part, until no part holds more than [`MAX_OWN`]. The smoother of a part sees the nearest points of other parts as well,
//! [`MAX_SEEN`] in all, so that it does not end at the border. A place is predicted by the smoother of the part that it lies in.
//! Each part chooses its own process: work and memory grow with the number of points, and a response may be rough in one part and
//! smooth in another. Local processes: R. B. Gramacy and D. W. Apley, "Local Gaussian process approximation for large computer
//! experiments", Journal of Computational and Graphical Statistics 24 (2015) 561-578; there each place has its own.

use std::sync::Arc;

use crate::search::models::grid::Grid;
use crate::search::models::noise::Noise;
use crate::search::models::prediction::{Allowance, Prediction};
use crate::search::models::smoother::{Fit, Smoother};
use crate::search::search_box::{Axes, Region};
use loosepin_math::{sort_ascending, sort_by_number};

/// Points that one smoother sees, at most: it factorises matrices of this order.
const MAX_TOGETHER: usize = 512;

/// Points of a part's own, at most, where there are several parts.
const MAX_OWN: usize = 256;

/// Points that the smoother of a part sees: two of them take no longer than one of [`MAX_TOGETHER`] points.
const MAX_SEEN: usize = 384;

/// The models of one set of points, shared by all statistics that are known there.
pub(crate) struct LocalSmoothers {
    axes: Axes,
    parts: Vec<SmoothedRegion>,
    /// Candidates, then points, and by which part each is predicted; empty where there is one part alone.
    places: Vec<Vec<f64>>,
    owners: Vec<Owner>,
}

/// A part of the box with its smoother.
struct SmoothedRegion {
    region: Region,
    /// The points that its smoother sees.
    seen: Vec<usize>,
    smoother: Smoother,
}

impl SmoothedRegion {
    /// Fits those of `values` that its smoother sees.
    fn fit(&self, values: &[f64], noise: &Noise) -> Fit<'_> {
        let seen: Vec<f64> = self.seen.iter().map(|&point| values[point]).collect();
        self.smoother.fit(&seen, &noise.at_points(&self.seen))
    }

    /// [`Self::fit`] of each of several lists of values.
    fn fit_all(&self, all: &[(&[f64], &Noise)]) -> Vec<Fit<'_>> {
        let among = |&(values, noise): &(&[f64], &Noise)| -> (Vec<f64>, Noise) {
            (self.seen.iter().map(|&point| values[point]).collect(), noise.at_points(&self.seen))
        };
        let seen: Vec<(Vec<f64>, Noise)> = all.iter().map(among).collect();
        self.smoother.fit_all(&seen.iter().map(|(values, noise)| (&values[..], noise)).collect::<Vec<_>>())
    }
}

/// The part that predicts a place, and the index of the place in its smoother.
#[derive(Debug, Clone, Copy)]
struct Owner {
    part: usize,
    place: usize,
}

/// A statistic fitted on the points of [`LocalSmoothers`].
pub(crate) struct LocalFits<'a> {
    smoothers: &'a LocalSmoothers,
    /// One of each part.
    fits: Vec<Fit<'a>>,
}

impl LocalSmoothers {
    /// Smoothers with grids of their own; models that pass beside the values take part where it `may_pass_beside`. `None` if there are
    /// too few `points` for any model.
    pub fn try_new(points: Vec<Vec<f64>>, candidates: &[Vec<f64>], may_pass_beside: bool, axes: &Axes) -> Option<Self> {
        Self::with(points, candidates, axes, |_, points| {
            Grid::try_new(points, may_pass_beside, axes, &[]).map(Arc::new)
        })
    }

    /// Smoothers for any number of `points`; `grid` gives that of the points of each part.
    pub fn with(
        points: Vec<Vec<f64>>,
        candidates: &[Vec<f64>],
        axes: &Axes,
        grid: impl Fn(usize, &[Vec<f64>]) -> Option<Arc<Grid>>,
    ) -> Option<Self> {
        if points.len() <= MAX_TOGETHER {
            let (region, seen) = (Region::whole(points.first()?.len()), (0..points.len()).collect());
            let grid = grid(0, &points)?;
            let smoother = Smoother::new(grid, points, candidates, axes);
            let parts = vec![SmoothedRegion { region, seen, smoother }];
            return Some(Self { axes: axes.clone(), parts, places: Vec::new(), owners: Vec::new() });
        }
        let mut divided = Vec::new();
        divide(&points, (0..points.len()).collect(), Region::whole(points[0].len()), &mut divided);
        let part_of = |at: &[f64]| divided.iter().position(|(region, _)| region.holds(at)).unwrap_or(0);
        let mut own_candidates: Vec<Vec<Vec<f64>>> = vec![Vec::new(); divided.len()];
        let mut owners = Vec::with_capacity(candidates.len() + points.len());
        for candidate in candidates {
            let part = part_of(candidate);
            owners.push(Owner { part, place: own_candidates[part].len() });
            own_candidates[part].push(candidate.clone());
        }
        let seen: Vec<Vec<usize>> =
            divided.iter().map(|(region, own)| with_neighbours(&points, own, region, axes)).collect();
        let mut of_points = vec![Owner { part: 0, place: 0 }; points.len()];
        for (part, (_, own)) in divided.iter().enumerate() {
            for (place, point) in seen[part].iter().enumerate() {
                if own.binary_search(point).is_ok() {
                    of_points[*point] = Owner { part, place: own_candidates[part].len() + place };
                }
            }
        }
        owners.extend(of_points);
        let places = candidates.iter().cloned().chain(points.iter().cloned()).collect();
        let mut parts = Vec::with_capacity(divided.len());
        for (part, ((region, _), seen)) in divided.into_iter().zip(seen).enumerate() {
            let known: Vec<Vec<f64>> = seen.iter().map(|&point| points[point].clone()).collect();
            let grid = grid(part, &known)?;
            let smoother = Smoother::new(grid, known, &own_candidates[part], axes);
            parts.push(SmoothedRegion { region, seen, smoother });
        }
        Some(Self { axes: axes.clone(), parts, places, owners })
    }

    /// Fits `values` (one for each point) with their sampling noise.
    pub fn fit(&self, values: &[f64], noise: &Noise) -> LocalFits<'_> {
        let fits = match &self.parts[..] {
            [whole] => vec![whole.smoother.fit(values, noise)],
            parts => parts.iter().map(|part| part.fit(values, noise)).collect(),
        };
        LocalFits { smoothers: self, fits }
    }

    /// [`Self::fit`] of each of several lists of values, as [`Smoother::fit_all`].
    pub fn fit_all(&self, all: &[(&[f64], &Noise)]) -> Vec<LocalFits<'_>> {
        let mut fits: Vec<LocalFits<'_>> =
            all.iter().map(|_| LocalFits { smoothers: self, fits: Vec::with_capacity(self.parts.len()) }).collect();
        for part in &self.parts {
            let own: Vec<Fit<'_>> = match &self.parts[..] {
                [_] => part.smoother.fit_all(all),
                _ => part.fit_all(all),
            };
            for (fits, own) in fits.iter_mut().zip(own) {
                fits.fits.push(own);
            }
        }
        fits
    }
}

impl<'a> LocalFits<'a> {
    /// Whether it smooths the values anywhere instead of interpolating them.
    pub fn is_regressing(&self) -> bool {
        self.fits.iter().any(Fit::is_regressing)
    }

    /// Variance of the sampling noise between the points, where it is greatest; 0 where all fits pass through the estimates.
    pub fn noise_variance(&self) -> f64 {
        self.fits.iter().map(Fit::noise_variance).fold(0.0, f64::max)
    }

    /// The share of sampling noise in what the values differ by from one point to the next, where it is least.
    pub fn noise_share(&self) -> f64 {
        self.fits.iter().map(Fit::noise_share).fold(1.0, f64::min)
    }

    /// Whether the values are those of something as smooth as the smoothest processes everywhere.
    pub fn is_smoothest(&self) -> bool {
        self.fits.iter().all(Fit::is_smoothest)
    }

    /// Whether the values have a rough part anywhere.
    pub fn is_rough(&self) -> bool {
        self.fits.iter().any(Fit::is_rough)
    }

    /// -2 ln likelihood for each degree of freedom, the mean of all parts.
    pub fn misfit(&self) -> f64 {
        self.fits.iter().map(Fit::misfit).sum::<f64>() / self.fits.len() as f64
    }

    /// The fits, one of each part.
    pub fn parts(&self) -> &[Fit<'a>] {
        &self.fits
    }

    /// The fit of all points together; `None` if they are divided.
    pub fn whole(&self) -> Option<&Fit<'a>> {
        match &self.fits[..] {
            [whole] => Some(whole),
            _ => None,
        }
    }

    /// Whether all of [`Self::places`] lie in `region`, as far as a test without a look at each shows.
    pub fn are_all_in(&self, region: &Region) -> bool {
        self.fits.iter().all(|fit| fit.are_all_in(region))
    }

    /// Places of [`Self::at_places`]: the candidates, then the points.
    pub fn places(&self) -> &[Vec<f64>] {
        match &self.fits[..] {
            [whole] => whole.places(),
            _ => &self.smoothers.places,
        }
    }

    /// As [`Fit::at_places`].
    pub fn at_places(&self, allowance: Allowance) -> impl Iterator<Item = Prediction> {
        self.gathered(move |fit| fit.at_places(allowance))
    }

    /// As [`Fit::smooth_at_places`].
    pub fn smooth_at_places(&self) -> impl Iterator<Item = Prediction> {
        self.gathered(Fit::smooth_at_places)
    }

    /// What `of` gives at all places, each by the part that it lies in.
    fn gathered<'f, I: Iterator<Item = Prediction>>(
        &'f self,
        of: impl Fn(&'f Fit<'a>) -> I,
    ) -> impl Iterator<Item = Prediction> {
        let (whole, parts) = match &self.fits[..] {
            [whole] => (Some(of(whole)), Vec::new()),
            parts => (None, parts.iter().map(|fit| of(fit).collect::<Vec<_>>()).collect()),
        };
        let at = move |owner: &Owner| parts[owner.part][owner.place];
        whole.into_iter().flatten().chain(self.smoothers.owners.iter().map(at))
    }

    /// Prediction of S at `place`, with what an allowance asks for.
    pub fn at(&self, place: &[f64], allowance: Allowance) -> Prediction {
        self.fit_of(place).at(place, allowance)
    }

    /// [`Self::at`] each of `places`.
    pub fn at_each(&self, places: &[Vec<f64>], allowance: Allowance) -> Vec<Prediction> {
        match &self.fits[..] {
            [whole] => whole.at_each(places, allowance),
            _ => places.iter().map(|place| self.at(place, allowance)).collect(),
        }
    }

    /// As [`Fit::moved_and_slopes`].
    pub fn moved_and_slopes(&self, place: &[f64], allowance: Allowance, sign: f64) -> (f64, Vec<f64>) {
        self.fit_of(place).moved_and_slopes(place, allowance, sign)
    }

    /// The fit of the part that `place` lies in.
    fn fit_of(&self, place: &[f64]) -> &Fit<'a> {
        let own = match &self.smoothers.parts[..] {
            [_] => 0,
            parts => {
                let distance = |part: &SmoothedRegion| part.region.distance(&self.smoothers.axes, place);
                (1..parts.len()).fold(
                    0,
                    |best, part| {
                        if distance(&parts[part]) < distance(&parts[best]) { part } else { best }
                    },
                )
            }
        };
        &self.fits[own]
    }
}

/// Appends `own` points in `region`, in increasing order, or the parts that they are divided into.
fn divide(points: &[Vec<f64>], own: Vec<usize>, region: Region, parts: &mut Vec<(Region, Vec<usize>)>) {
    if own.len() <= MAX_OWN {
        return parts.push((region, own));
    }
    let Some((axis, border)) = division(points, &own, &region) else { return parts.push((region, own)) };
    let (below, above): (Vec<usize>, Vec<usize>) = own.into_iter().partition(|&point| points[point][axis] < border);
    let (mut lower, mut upper) = (region.clone(), region);
    lower.upper[axis] = border;
    upper.lower[axis] = border;
    divide(points, below, lower, parts);
    divide(points, above, upper, parts);
}

/// The axis of the longest side of `region` along which `own` points differ, and the middle between those in their middle; `None`
/// if all lie in one place.
fn division(points: &[Vec<f64>], own: &[usize], region: &Region) -> Option<(usize, f64)> {
    let mut axes: Vec<usize> = (0..region.lower.len()).collect();
    let side = |axis: usize| region.upper[axis] - region.lower[axis];
    sort_by_number(&mut axes, |&axis| -side(axis));
    axes.into_iter().find_map(|axis| {
        let mut along: Vec<f64> = own.iter().map(|&point| points[point][axis]).collect();
        sort_ascending(&mut along);
        // Many points may share a face: the border is the step nearest to the middle that is one.
        let middle = along.len() / 2;
        let steps = (1..along.len()).filter(|&i| along[i - 1] < along[i]);
        let i = steps.min_by_key(|&i| i.abs_diff(middle))?;
        let border = 0.5 * (along[i - 1] + along[i]);
        // Neighbouring numbers have none between them.
        (border > along[i - 1]).then_some((axis, border)).or(Some((axis, along[i])))
    })
}

/// `own` points and the nearest others of `region`, in increasing order.
fn with_neighbours(points: &[Vec<f64>], own: &[usize], region: &Region, axes: &Axes) -> Vec<usize> {
    let others = (0..points.len()).filter(|point| own.binary_search(point).is_err());
    let mut others: Vec<(f64, usize)> = others.map(|point| (region.distance(axes, &points[point]), point)).collect();
    sort_by_number(&mut others, |other| other.0);
    let near = others.into_iter().take(MAX_SEEN.saturating_sub(own.len())).map(|(_, point)| point);
    let mut seen: Vec<usize> = own.iter().copied().chain(near).collect();
    seen.sort_unstable();
    seen
}

#[cfg(test)]
mod tests {
    use super::{LocalSmoothers, MAX_OWN, MAX_SEEN, MAX_TOGETHER, divide};
    use crate::search::design::{candidates, first_points};
    use crate::search::models::noise::Noise;
    use crate::search::models::prediction::Allowance;
    use crate::search::search_box::{Axes, Region};

    const POINTS: usize = 1100;

    fn points() -> Vec<Vec<f64>> {
        first_points(11, 2, POINTS).unwrap()
    }

    /// A ripple that bends too often for 500 points far apart, with a range of 3.2.
    fn ripple(u: &[f64]) -> f64 {
        (23.0 * u[0]).sin() + 0.6 * (31.0 * u[1] + 3.0 * u[0]).cos()
    }

    #[test]
    fn identity_every_place_is_predicted_by_the_part_that_it_lies_in() {
        let axes = Axes::open(2);
        let points = points();
        let smoothers = LocalSmoothers::try_new(points.clone(), &candidates(2).unwrap(), true, &axes).unwrap();
        assert!(smoothers.parts.len() >= POINTS.div_ceil(MAX_OWN), "{}", smoothers.parts.len());
        assert!(smoothers.parts.iter().all(|part| part.seen.len() == MAX_SEEN));
        let values: Vec<f64> = points.iter().map(|u| ripple(u)).collect();
        let fits = smoothers.fit(&values, &Noise::NONE);
        assert_eq!(fits.places().len(), candidates(2).unwrap().len() + POINTS);
        for (place, listed) in fits.places().iter().zip(fits.at_places(Allowance::ONE)) {
            let at = fits.at(place, Allowance::ONE);
            assert!((at.mean - listed.mean).abs() < 1e-9, "{place:?}: {} {}", at.mean, listed.mean);
            assert!((at.deviation - listed.deviation).abs() < 1e-6, "{place:?}: {} {}", at.deviation, listed.deviation);
        }
        // The points are met to the round-off of the process: their own part predicts them. That of others would be off by about 1.
        const TOLERANCE: f64 = 1e-3;
        let points_alone = fits.at_places(Allowance::NONE).skip(fits.places().len() - POINTS);
        for (value, at) in values.iter().zip(points_alone) {
            assert!((value - at.mean).abs() < TOLERANCE, "{value} {}", at.mean);
        }
    }

    #[test]
    fn identity_a_ripple_lies_within_the_stated_deviation_across_the_borders() {
        // Share of places within two deviations; a Gaussian process would have 0.95, chosen grid and all.
        const MIN_SHARE: f64 = 0.9;
        let points = points();
        let values: Vec<f64> = points.iter().map(|u| ripple(u)).collect();
        let deviation = |count: usize| {
            let (points, values) = (points[..count].to_vec(), &values[..count]);
            let smoothers = LocalSmoothers::try_new(points, &candidates(2).unwrap(), true, &Axes::open(2)).unwrap();
            let fits = smoothers.fit(values, &Noise::NONE);
            let mut largest = 0.0_f64;
            let (mut within, mut places) = (0, 0);
            for step in 0..2000 {
                let x = (f64::from(step) + 0.5) / 2000.0;
                let place = [x, (0.618_034 * f64::from(step)).fract()];
                let at = fits.at(&place, Allowance::ONE);
                within += usize::from((at.mean - ripple(&place)).abs() <= 2.0 * at.deviation + 1e-9);
                places += 1;
                largest = largest.max(at.deviation);
            }
            assert!(within as f64 / f64::from(places) > MIN_SHARE, "{within} of {places}");
            largest
        };
        // More points than one smoother sees say more.
        let (few, many) = (deviation(MAX_TOGETHER), deviation(POINTS));
        assert!(many < 0.5 * few, "{many} {few}");
    }

    #[test]
    fn identity_many_points_in_one_place_are_not_divided_for_ever() {
        let mut points = points();
        for point in points.iter_mut().skip(300) {
            *point = vec![0.3, 0.7];
        }
        let mut parts = Vec::new();
        divide(&points, (0..POINTS).collect(), Region::whole(2), &mut parts);
        let mut members: Vec<usize> = parts.iter().flat_map(|(_, own)| own.iter().copied()).collect();
        members.sort_unstable();
        assert_eq!(members, (0..POINTS).collect::<Vec<_>>());
        assert!(parts.iter().filter(|(_, own)| own.len() > MAX_OWN).count() == 1, "{}", parts.len());
    }
}
