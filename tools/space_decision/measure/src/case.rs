//! The reference cases, their states, and the four ways to evaluate them on any number.

use generic::{Embeds, Numbers};
use loosepin_math::{Dual, Real};
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Mechanism, Sample, TimeDual, room};
use loosepin_mechanics::model::Model;
use parts::{Attachment, Counts, Tree};
use std::path::Path;

/// The mechanisms that are measured.
pub const CASES: [&str; 3] = ["slider_crank_5000", "four_bar_600", "six_bar"];

/// A mechanism with its trees.
pub struct Case {
    pub name: &'static str,
    pub mechanism: Mechanism,
    pub sample: Sample<f64>,
    pub start: Vec<f64>,
    pub plane: Tree,
    pub space: Tree,
    /// With angles from the parents.
    pub relative: Tree,
}

impl Case {
    pub fn read(name: &'static str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../cases").join(name).join("model.toml");
        let model = Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let nominal = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &nominal).expect("it is a reference case");
        let sample = Sample::new(&mechanism, &nominal).expect("it is a reference case");
        let (start, _) = mechanism.start(&sample).expect("it closes");
        let tree = |counts, absolute| Tree::of(&mechanism, counts, absolute);
        let (plane, space) = (tree(Counts::PLANE, true), tree(Counts::SPACE, true));
        Self { name, plane, space, relative: tree(Counts::SPACE, false), start, mechanism, sample }
    }

    /// A state far from the start: coordinates, rates of the free ones, in contact.
    pub fn state(&self, random: &mut Random) -> State<f64> {
        let free = self.mechanism.real.free;
        let states = self.sample.contacts.iter().map(|_| PlayState {
            contact: 1.0,
            inverse_impact_speed_s_m: 1.0 + random.between_minus_one_and_one().abs(),
            effective_mass_kg: 0.0,
        });
        State {
            states: states.collect(),
            time_s: 1e-3 * random.between_minus_one_and_one().abs(),
            coordinates: self.start[..free].iter().map(|at| at + 0.3 * random.between_minus_one_and_one()).collect(),
            rates: (0..free).map(|_| 30.0 * random.between_minus_one_and_one()).collect(),
        }
    }
}

/// What an evaluation starts from.
#[derive(Debug, Clone)]
pub struct State<T> {
    pub time_s: T,
    pub coordinates: Vec<T>,
    pub rates: Vec<T>,
    pub states: Vec<PlayState<T>>,
}

/// Numbers that do not depend on the machine.
pub struct Random(pub u64);

impl Random {
    pub fn between_minus_one_and_one(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The driven coordinates behind the free ones, as the program fills them in.
pub struct Driven<T> {
    coordinates: Vec<T>,
    rates: Vec<T>,
    accelerations: Vec<T>,
    room: Vec<TimeDual<T>>,
}

impl<T: Real> Driven<T> {
    pub fn new(case: &Case) -> Self {
        let real = &case.mechanism.real;
        Self {
            coordinates: vec![T::zero(); real.coordinates()],
            rates: vec![T::zero(); real.coordinates()],
            accelerations: vec![T::zero(); real.drives.len()],
            room: vec![Dual::constant(Dual::constant(T::zero())); room(&case.mechanism.model)],
        }
    }

    #[inline(always)]
    pub fn fill(&mut self, case: &Case, sample: &Sample<T>, state: &State<T>) {
        let free = state.coordinates.len();
        self.coordinates[..free].copy_from_slice(&state.coordinates);
        self.rates[..free].copy_from_slice(&state.rates);
        for (k, drive) in case.mechanism.real.drives.iter().enumerate() {
            let motion = sample.drives.motion(*drive, state.time_s, &mut self.room);
            [self.coordinates[free + k], self.rates[free + k], self.accelerations[k]] = motion;
        }
    }
}

impl Driven<f64> {
    /// Coordinates, rates and accelerations of the driven ones.
    pub fn of_drives(&self, free: usize) -> [&[f64]; 3] {
        [&self.coordinates[free..], &self.rates[free..], &self.accelerations]
    }
}

/// A way to evaluate a case.
pub trait Way<T: Real> {
    fn evaluate(&mut self, state: &State<T>) -> &[T];
}

type TodayEvaluate<T> = fn(&mut Dynamics<'_, T>, T, &[T], &[T], &[PlayState<T>]);

/// As the program does it.
pub struct Today<'c, T>(pub Dynamics<'c, T>, pub TodayEvaluate<T>);

impl<T: Real> Way<T> for Today<'_, T> {
    fn evaluate(&mut self, state: &State<T>) -> &[T] {
        (self.1)(&mut self.0, state.time_s, &state.coordinates, &state.rates, &state.states);
        self.0.accelerations()
    }
}

type SpatialEvaluate<T> = fn(&mut spatial::Kernel<'_, T>, &[T], &[T], &[T], &[PlayState<T>]);

/// Way (a).
pub struct Spatial<'c, T: Real> {
    pub case: &'c Case,
    pub sample: Sample<T>,
    pub driven: Driven<T>,
    pub kernel: spatial::Kernel<'c, T>,
    pub compiled: SpatialEvaluate<T>,
}

impl<'c, T: Real> Spatial<'c, T> {
    pub fn new(case: &'c Case, sample: &Sample<T>, is_relative: bool, compiled: SpatialEvaluate<T>) -> Self {
        let tree = if is_relative { &case.relative } else { &case.space };
        let kernel = spatial::Kernel::new(tree, spatial::Numbers::of(sample));
        Self { case, sample: sample.clone(), driven: Driven::new(case), kernel, compiled }
    }
}

impl<T: Real> Way<T> for Spatial<'_, T> {
    fn evaluate(&mut self, state: &State<T>) -> &[T] {
        self.driven.fill(self.case, &self.sample, state);
        let Driven { coordinates, rates, accelerations, .. } = &self.driven;
        (self.compiled)(&mut self.kernel, coordinates, rates, accelerations, &state.states);
        &self.kernel.accelerations
    }
}

type GenericEvaluate<T, G> = fn(&mut generic::Kernel<'_, T, G>, &[T], &[T], &[T], &[PlayState<T>]);

/// Way (b).
pub struct Generic<'c, T: Real, G: Embeds<T>> {
    case: &'c Case,
    sample: Sample<T>,
    driven: Driven<T>,
    pub kernel: generic::Kernel<'c, T, G>,
    compiled: GenericEvaluate<T, G>,
}

impl<'c, T: Real, G: Embeds<T>> Generic<'c, T, G> {
    pub fn new(case: &'c Case, tree: &'c Tree, sample: &Sample<T>, compiled: GenericEvaluate<T, G>) -> Self {
        let kernel = generic::Kernel::new(tree, Numbers::of(sample));
        Self { case, sample: sample.clone(), driven: Driven::new(case), kernel, compiled }
    }
}

impl<T: Real, G: Embeds<T>> Way<T> for Generic<'_, T, G> {
    fn evaluate(&mut self, state: &State<T>) -> &[T] {
        self.driven.fill(self.case, &self.sample, state);
        let Driven { coordinates, rates, accelerations, .. } = &self.driven;
        (self.compiled)(&mut self.kernel, coordinates, rates, accelerations, &state.states);
        &self.kernel.accelerations
    }
}

/// Numbers of the coordinates of `tree` (angles from the parents) for numbers of angles from the ground, and back.
pub fn relative<T: Real>(tree: &Tree, absolute: &[T], driven: &[T], back: bool) -> Vec<T> {
    let free = tree.free_speeds;
    let mut angles = vec![T::zero(); tree.links.len() + 1];
    let mut out = absolute[..free].to_vec();
    for (index, link) in tree.links.iter().enumerate() {
        angles[index + 1] = angles[link.parent];
        if let Attachment::Revolute { forward, .. } = link.attachment {
            let sign = if forward { T::one() } else { -T::one() };
            let given =
                if link.speeds.start >= free { driven[link.speeds.start - free] } else { absolute[link.speeds.start] };
            if link.is_driven || back {
                angles[index + 1] += sign * given;
            } else {
                angles[index + 1] = given;
            }
            if !link.is_driven {
                let turn = sign * (angles[index + 1] - angles[link.parent]);
                out[link.speeds.start] = if back { angles[index + 1] } else { turn };
            }
        }
    }
    out
}
