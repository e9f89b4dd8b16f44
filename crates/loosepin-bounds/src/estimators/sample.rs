//! One column at one u: the finished values, replicate by replicate.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use super::estimate::PowerSums;
use super::known::SampleCache;
use super::polynomials::known_fits::FitCache;
use super::polynomials::smooth::Smooth;
use super::stratification;
use super::unsampled_events::UnsampledEvents;
use crate::data::scratch::{FileRange, Numbers};
use loosepin_math::in_order;

/// The values of one column that belong together, in the order of the plan.
#[derive(Debug, Clone)]
pub(crate) struct Sample {
    values: Numbers,
    replicate_ends: Arc<[usize]>,
    failed: usize,
    /// Beside the sample, since most have none.
    smooth: Option<Box<Smooth>>,
    /// Rare events that it does not show.
    unseen: Option<UnsampledEvents>,
    known: SampleCache,
    fits: FitCache<Self>,
    ends: OnceLock<Option<(f64, f64)>>,
    sums: OnceLock<PowerSums>,
    is_even: OnceLock<bool>,
}

/// A sample whose values are still being put in.
#[derive(Debug, Clone, Default)]
pub(crate) struct SampleBuilder {
    values: Vec<f64>,
    replicate_ends: Vec<usize>,
    failed: usize,
}

impl SampleBuilder {
    /// Takes the next value of the present replicate; one that is not finite counts as failed.
    pub fn push(&mut self, value: f64) {
        if value.is_finite() {
            self.values.push(value);
        } else {
            self.failed += 1;
        }
    }

    /// Ends the present replicate.
    pub fn end_replicate(&mut self) {
        self.replicate_ends.push(self.values.len());
    }

    /// Returns the sample; values put in afterwards belong to the next one.
    pub fn finish(&mut self) -> Sample {
        let sample = Sample::of(Numbers::InMemory(self.values[..].into()), self.replicate_ends[..].into(), self.failed);
        self.values.clear();
        self.replicate_ends.clear();
        self.failed = 0;
        sample
    }
}

impl Sample {
    /// Takes values replicate by replicate; those that are not finite count as failed.
    pub fn new(replicates: impl Iterator<Item = impl Iterator<Item = f64>>) -> Self {
        let mut gathering = SampleBuilder::default();
        for replicate in replicates {
            replicate.for_each(|value| gathering.push(value));
            gathering.end_replicate();
        }
        gathering.finish()
    }

    fn of(values: Numbers, replicate_ends: Arc<[usize]>, failed: usize) -> Self {
        Self {
            values,
            replicate_ends,
            failed,
            smooth: None,
            unseen: None,
            known: SampleCache::default(),
            fits: FitCache::default(),
            ends: OnceLock::new(),
            sums: OnceLock::new(),
            is_even: OnceLock::new(),
        }
    }

    /// A sample of these runs with another value each, a smooth function of the old one; finished ones stay finished where `change` is finite.
    pub fn mapped(&self, change: impl Fn(f64) -> f64) -> Self {
        let values: Arc<[f64]> = self.values.iter().map(|&value| change(value)).collect();
        let smooth = self.smooth.as_ref().map(|smooth| Box::new(smooth.refitted(&values)));
        let unseen = self.unseen.zip(self.ends()).map(|(unseen, (low, high))| unseen.changed([low, high], &change));
        Self { smooth, unseen, ..Self::of(Numbers::InMemory(values), self.replicate_ends.clone(), self.failed) }
    }

    /// The magnitudes of these runs, counted: they have a kink, which no polynomial follows.
    pub fn magnitudes(&self) -> Self {
        let values: Arc<[f64]> = self.values.iter().map(|value| value.abs()).collect();
        let unseen = self.unseen.map(|unseen| UnsampledEvents { below: unseen.largest(), above: unseen.largest() });
        Self { unseen, ..Self::of(Numbers::InMemory(values), self.replicate_ends.clone(), self.failed) }
    }

    /// A value from each pair of this and `other`, which belong to the same runs and have failed in the same ones.
    pub fn joined(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        debug_assert_eq!(self.replicate_ends, other.replicate_ends, "the same runs");
        let pairs = self.values.iter().zip(&*other.values);
        let values = pairs.map(|(&a, &b)| of(a, b)).collect();
        Self::of(Numbers::InMemory(values), self.replicate_ends.clone(), self.failed)
    }

    /// Whether `other` has the same values, to the last bit, from the same runs, and neither has polynomials: then all that is said of one
    /// is true of the other.
    pub fn is_same(&self, other: &Self) -> bool {
        let mut pairs = self.values.iter().zip(&*other.values);
        self.values.len() == other.values.len()
            && pairs.all(|(a, b)| a.to_bits() == b.to_bits())
            && (&self.replicate_ends, self.failed) == (&other.replicate_ends, other.failed)
            && self.unseen == other.unseen
            && self.smooth.is_none()
            && other.smooth.is_none()
    }

    /// This sample, without cached results, with its values at `away`, where they have been written.
    pub fn moved(self, away: FileRange) -> Self {
        debug_assert_eq!(*away, *self.values, "the same values");
        Self { values: Numbers::InFile(away), ..self }
    }

    /// Takes over the ends of the replicates of `other` where they are the same.
    pub fn share_replicates(&mut self, other: &Self) {
        if self.replicate_ends == other.replicate_ends {
            self.replicate_ends = Arc::clone(&other.replicate_ends);
        }
    }

    /// The cached results of the sample.
    pub fn known(&self) -> &SampleCache {
        &self.known
    }

    /// Polynomials that have been fitted to it so far.
    pub(super) fn fits(&self) -> &FitCache<Self> {
        &self.fits
    }

    /// Its polynomials where the response is smooth in the random inputs.
    pub fn smooth(&self) -> Option<&Smooth> {
        self.smooth.as_deref()
    }

    /// The same values, known to be smooth in the random inputs.
    pub fn with_polynomials(&self, smooth: Smooth) -> Self {
        let plain = Self::of(self.values.clone(), self.replicate_ends.clone(), self.failed);
        Self { smooth: Some(Box::new(smooth)), ends: self.ends.clone(), sums: self.sums.clone(), ..plain }
    }

    /// The same values beside rare events that single runs have shown. The polynomials stay where the events are small, and leave these too.
    pub fn contradicted(&self, unseen: UnsampledEvents, are_small: bool) -> Self {
        let plain = Self::of(self.values.clone(), self.replicate_ends.clone(), self.failed);
        let kept = self.smooth.as_ref().filter(|_| are_small);
        let smooth = kept.map(|smooth| Box::new(smooth.with_residual(unseen.largest())));
        Self { unseen: Some(unseen), smooth, ends: self.ends.clone(), sums: self.sums.clone(), ..plain }
    }

    /// Rare events that it does not show, but single runs do.
    pub fn unseen(&self) -> Option<UnsampledEvents> {
        self.unseen
    }

    /// Finished values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Number of failed runs.
    pub fn failed(&self) -> usize {
        self.failed
    }

    /// Finished and failed runs.
    pub fn runs(&self) -> usize {
        self.values.len() + self.failed
    }

    /// Finished values in increasing order. Sorted anew each time: a second copy of every column is not kept, but what is said of it.
    pub fn sorted(&self) -> Vec<f64> {
        in_order(self.values.iter().copied())
    }

    /// The least and the greatest finished value.
    pub fn ends(&self) -> Option<(f64, f64)> {
        let find = || {
            let first = *self.values.first()?;
            Some(self.values.iter().fold((first, first), |(low, high), &value| (low.min(value), high.max(value))))
        };
        *self.ends.get_or_init(find)
    }

    /// Sums of powers of the finished values.
    pub fn sums(&self) -> &PowerSums {
        self.sums.get_or_init(|| PowerSums::of(&self.values))
    }

    /// Whether its replicates fill its distribution clearly more evenly than independent runs would.
    pub fn is_even(&self) -> bool {
        *self.is_even.get_or_init(|| stratification::is_even(&self.sorted(), &self.replicates().collect::<Vec<_>>()))
    }

    /// The finished values of each replicate that has any.
    pub fn replicates(&self) -> impl Iterator<Item = &[f64]> {
        let values = self.values();
        self.replicate_ranges().map(move |own| &values[own])
    }

    /// Range of the finished values of each non-empty replicate among all values.
    pub fn replicate_ranges(&self) -> impl Iterator<Item = Range<usize>> {
        let begins = std::iter::once(0).chain(self.replicate_ends.iter().copied());
        begins.zip(self.replicate_ends.iter().copied()).map(|(begin, end)| begin..end).filter(|own| !own.is_empty())
    }

    /// Number of replicates in the plan, those without a finished value included.
    pub fn planned_replicates(&self) -> usize {
        self.replicate_ends.len()
    }

    /// How many of the finished values do not exceed `limit`.
    pub fn count_up_to(&self, limit: f64) -> usize {
        self.values.iter().filter(|&&value| value <= limit).count()
    }
}
