//! Time of an exact pose of an arm with six axes and play in all of them: `cargo run --release -p loosepin-space --example arm_samples`; behind
//! `--` how many samples, and on how many threads: `-- 100000 2`.

use loosepin_space::{
    Body, Drive, Joint, JointCoordinate, Marker, OpenChain, Pose, Revolute, RevolutePlay, SpatialMechanism, Vec3,
};
use std::time::Instant;

const SAMPLES: usize = 20_000;
const POSES: usize = 180;

fn main() {
    let mut numbers = std::env::args().skip(1).map(|word| word.parse().expect("a whole number"));
    let (samples, threads) = (numbers.next().unwrap_or(SAMPLES), numbers.next().unwrap_or(1));
    let arm = arm().expect("the arm is a mechanism");
    let chain = OpenChain::new(&arm, 6).expect("the arm is a chain");
    let poses: Vec<_> = (0..POSES)
        .map(|k| {
            let phase = k as f64 / POSES as f64 * std::f64::consts::TAU;
            chain.pose(&std::array::from_fn::<f64, 6, _>(|axis| 0.8 * (phase + axis as f64).sin()))
        })
        .collect();
    let variables = chain.play_set().variables();
    let of_thread = &|thread: usize| {
        let mut sum = Vec3::ZERO;
        for sample in (thread..samples).step_by(threads) {
            let at = |k: usize| 1e-5 * ((sample * variables + k) as f64).sin();
            let sample = chain.sample(&(0..variables).map(at).collect::<Vec<_>>(), None);
            for pose in &poses {
                sum += sample.end(pose).point_m(Vec3::new(0.0, 0.0, 0.1));
            }
        }
        sum
    };
    let started = Instant::now();
    let sum = std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|thread| scope.spawn(move || of_thread(thread))).collect();
        running.into_iter().fold(Vec3::ZERO, |sum, thread| sum + thread.join().expect("a thread that ends"))
    });
    let seconds = started.elapsed().as_secs_f64();
    let nanoseconds = seconds * 1e9 * threads as f64 / (samples * POSES) as f64;
    let mean = sum / (samples * POSES) as f64;
    println!(
        "{samples} samples x {POSES} poses, {threads} threads: {seconds:.3} s, {nanoseconds:.0} ns a pose (mean {mean:?})"
    );
}

/// An arm with six axes, its bearings with play.
fn arm() -> Option<SpatialMechanism> {
    let axes = [Vec3::Z, Vec3::Y, Vec3::Y, Vec3::X, Vec3::Y, Vec3::X];
    let points = [
        Vec3::ZERO,
        Vec3::new(0.05, 0.0, 0.33),
        Vec3::new(0.05, 0.0, 0.77),
        Vec3::new(0.3, 0.0, 0.81),
        Vec3::new(0.47, 0.0, 0.81),
        Vec3::new(0.55, 0.0, 0.81),
    ];
    let bodies = std::iter::once(Body::ground()).chain((1..=6).map(|k| Body::new(format!("link {k}"), Pose::GROUND)));
    let play = RevolutePlay { bearing_length_m: 0.04, radial_clearance_m: 1e-5, axial_clearance_m: 1e-5 };
    let joint = |k: usize| {
        let marker = |body| Marker::along(body, points[k], axes[k]);
        Some(Joint::new(format!("axis {}", k + 1), Revolute, marker(k)?, marker(k + 1)?).with_play(play))
    };
    let joints: Option<Vec<Joint>> = (0..6).map(joint).collect();
    let drives = (0..6).map(|joint| Drive { joint, coordinate: JointCoordinate::Angle }).collect();
    SpatialMechanism::new(bodies.collect(), joints?, drives).ok()
}
