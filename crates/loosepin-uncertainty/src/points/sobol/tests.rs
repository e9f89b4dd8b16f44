use super::{MAXIMUM_DIMENSIONS, ScrambledSobol, SobolError};

const SEED: u64 = 20_261_120;

#[test]
fn published_first_points_of_joe_and_kuo() {
    // Their example program prints these for three dimensions, in the order of the Gray code, which is 0 1 3 2 6 7 5 4.
    let points = ScrambledSobol::try_new(SEED, 3).unwrap();
    let expected = [
        [0.0, 0.0, 0.0],
        [0.5, 0.5, 0.5],
        [0.75, 0.25, 0.25],
        [0.25, 0.75, 0.75],
        [0.375, 0.375, 0.625],
        [0.875, 0.875, 0.125],
        [0.625, 0.125, 0.875],
        [0.125, 0.625, 0.375],
    ];
    for (natural, coordinates) in [0, 1, 3, 2, 6, 7, 5, 4].into_iter().zip(expected) {
        for (dimension, coordinate) in coordinates.into_iter().enumerate() {
            assert_eq!(f64::from(points.digits(natural, dimension)) / 4_294_967_296.0, coordinate);
        }
    }
}

#[test]
fn identity_every_dimension_is_stratified_after_scrambling() {
    const LOG2_COUNT: u32 = 9;
    let count = 1_usize << LOG2_COUNT;
    let points = ScrambledSobol::try_new(SEED, MAXIMUM_DIMENSIONS).unwrap();
    for replicate in 0..2 {
        for dimension in 0..MAXIMUM_DIMENSIONS {
            let mut seen = vec![false; count];
            for index in 0..count as u32 {
                let cell = (points.point(replicate, index, dimension) * count as f64) as usize;
                assert!(!std::mem::replace(&mut seen[cell], true), "dimension {dimension}: cell {cell} twice");
            }
        }
    }
}

#[test]
fn identity_the_first_pair_is_a_net() {
    const LOG2_COUNT: u32 = 10;
    let count = 1_u32 << LOG2_COUNT;
    let points = ScrambledSobol::try_new(SEED, 2).unwrap();
    for replicate in 0..3 {
        for columns_log2 in 0..=LOG2_COUNT {
            let (columns, rows) = (1_usize << columns_log2, 1_usize << (LOG2_COUNT - columns_log2));
            let mut seen = vec![false; count as usize];
            for index in 0..count {
                let column = (points.point(replicate, index, 0) * columns as f64) as usize;
                let row = (points.point(replicate, index, 1) * rows as f64) as usize;
                assert!(!std::mem::replace(&mut seen[column * rows + row], true));
            }
        }
    }
}

#[test]
fn identity_a_scrambled_point_is_uniform_over_the_replicates() {
    // Mean and variance of 4096 uniform numbers: standard deviations 0.0045 and 0.0012; four of them for 40 checks.
    const MEAN_TOLERANCE: f64 = 0.018;
    const VARIANCE_TOLERANCE: f64 = 0.005;
    let points = ScrambledSobol::try_new(SEED, 20).unwrap();
    for dimension in 0..20 {
        for index in [0, 77] {
            let (mut sum, mut squares) = (0.0, 0.0);
            for replicate in 0..4096 {
                let coordinate = points.point(replicate, index, dimension);
                assert!(coordinate > 0.0 && coordinate < 1.0);
                sum += coordinate / 4096.0;
                squares += coordinate * coordinate / 4096.0;
            }
            assert!((sum - 0.5).abs() < MEAN_TOLERANCE, "{dimension} {index} {sum}");
            assert!((squares - sum * sum - 1.0 / 12.0).abs() < VARIANCE_TOLERANCE, "{dimension} {index}");
        }
    }
}

#[test]
fn identity_the_variance_of_a_smooth_integral_falls_faster_than_with_independent_points() {
    // Independent points: 64 times as many give 1/64 of the variance. Nets of smooth functions: about 64^-3.
    const MAX_OF_INDEPENDENT: f64 = 0.01;
    let points = ScrambledSobol::try_new(SEED, 4).unwrap();
    let variance = |count: u32| {
        let means: Vec<f64> = (0..64)
            .map(|replicate| {
                let sum: f64 = (0..count)
                    .map(|index| (0..4).map(|j| (points.point(replicate, index, j) - 0.3).exp()).product::<f64>())
                    .sum();
                sum / f64::from(count)
            })
            .collect();
        let mean = means.iter().sum::<f64>() / 64.0;
        means.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / 63.0
    };
    let ratio = variance(1024) / variance(16);
    assert!(ratio < MAX_OF_INDEPENDENT / 64.0, "{ratio}");
}

#[test]
fn identity_points_do_not_depend_on_the_number_of_dimensions() {
    let (few, many) = (ScrambledSobol::try_new(SEED, 3).unwrap(), ScrambledSobol::try_new(SEED, 30).unwrap());
    for index in [0, 5, 4_000_000_000] {
        assert_eq!(few.point(7, index, 2).to_bits(), many.point(7, index, 2).to_bits());
    }
}

#[test]
fn too_many_dimensions_are_refused() {
    let error = ScrambledSobol::try_new(SEED, 257).unwrap_err();
    assert_eq!(error, SobolError::TooManyDimensions { dimensions: 257 });
    assert_eq!(
        error.to_string(),
        "257 dimensions; Sobol' points have at most 256\nhint: fix the inputs that matter least"
    );
}
