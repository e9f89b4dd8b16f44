//! From friction paths to volumes and depths after all cycles.

use super::joint::WearingJoint;
use super::jumps::Life;
use super::profile::WearProfile;
use super::recorder::WearRecorder;
use crate::failure::RunFailure;
use crate::recording::report::RunReport;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{JointId, WearMeasure};
use loosepin_result::simulation::{JointWearRecord, SurfaceWear, WearChecks, WornSurface};
use std::fmt::Write;

/// The surfaces, in the order of all pairs.
const SURFACES: [WornSurface; 2] = [WornSurface::Bearing, WornSurface::Journal];

impl WearingJoint {
    /// Friction path of a cycle, J: integrated with the motion, or that of the profile where an ideal joint has no such integral.
    pub fn friction_path_j(&self, report: &RunReport, profile: Option<&WearProfile>) -> f64 {
        let path_j = match self.play {
            Some(play) => report.friction_paths.iter().find(|path| path.play == play).map(|path| path.path_j),
            None => profile.map(|profile| profile.total_j),
        };
        path_j.unwrap_or(f64::NAN)
    }

    /// Worn volume N k W of bearing (0) or journal (1) after all cycles, m³; zero where it does not wear.
    pub fn volume_m3(&self, side: usize, friction_path_j: f64) -> f64 {
        self.cycles * self.coefficients_m2_n[side].unwrap_or(0.0) * friction_path_j
    }

    /// Mean depths of the sectors of bearing (0) or journal (1) after all cycles, m: V_s/(R Δ L_b).
    pub fn depths_m(&self, side: usize, profile: &WearProfile) -> Vec<f64> {
        let area_m2 = self.sector_area_m2(side);
        profile.path_j[side].iter().map(|path_j| self.volume_m3(side, *path_j) / area_m2).collect()
    }

    fn surface(&self, side: usize, friction_path_j: f64, profile: &WearProfile) -> Option<SurfaceWear> {
        let coefficient_m2_n = self.coefficients_m2_n[side]?;
        let paths_j = [friction_path_j, profile.total_j];
        Some(self.surface_of(side, coefficient_m2_n, self.depths_m(side, profile), paths_j))
    }

    /// A surface with its depths; of the two friction paths of a cycle the first gives the volume, the second was distributed.
    fn surface_of(
        &self,
        side: usize,
        coefficient_m2_n: f64,
        depth_m: Vec<f64>,
        [friction_path_j, distributed_j]: [f64; 2],
    ) -> SurfaceWear {
        let volume_m3 = self.volume_m3(side, friction_path_j);
        let distributed_m3 = self.volume_m3(side, distributed_j);
        let sum_m3 = depth_m.iter().sum::<f64>() * self.sector_area_m2(side);
        let deepest = depth_m.iter().copied().enumerate();
        let (deepest_sector, greatest_depth_m) =
            deepest.fold((0, 0.0), |most, own| if own.1 > most.1 { own } else { most });
        let (pairs, odd) = depth_m.as_chunks::<2>();
        let coarse = pairs.iter().map(|[one, other]| 0.5 * (one + other)).fold(0.0, f64::max);
        SurfaceWear {
            surface: SURFACES[side],
            coefficient_m2_n,
            volume_m3,
            greatest_depth_m,
            deepest_sector,
            sum_of_sectors_error: if distributed_m3 > 0.0 { sum_m3 / distributed_m3 - 1.0 } else { 0.0 },
            coarse_greatest_depth_m: odd.is_empty().then_some(coarse),
            depth_m,
        }
    }

    /// The wear after all cycles of a joint whose worn shape acts back, the one at `index` of `life`.
    fn worn_record(&self, name: &str, index: usize, life: &Life) -> JointWearRecord {
        let end = life.last();
        let path_j = life.paths_j[index] / end.cycles;
        let surfaces = [0, 1].into_iter().filter_map(|side| {
            let depths_m = end.depths_m[index][side].clone();
            Some(self.surface_of(side, self.coefficients_m2_n[side]?, depths_m, [path_j; 2]))
        });
        let surfaces: Vec<SurfaceWear> = surfaces.collect();
        let clearance_m = self.radii_m[0] - self.radii_m[1];
        let checks = WearChecks {
            path_error: None,
            widest_patch_sectors: life.narrowest_patch_sectors(index),
            capped_share: 0.0,
            depth_over_clearance: surfaces.iter().map(|surface| surface.greatest_depth_m).sum::<f64>() / clearance_m,
        };
        JointWearRecord {
            joint: name.to_owned(),
            cycles: end.cycles,
            friction_path_j: path_j,
            radial_clearance_m: clearance_m,
            surfaces,
            checks,
        }
    }

    /// The wear after all cycles, with the checks of it.
    fn record(&self, name: &str, report: &RunReport, profile: &WearProfile) -> JointWearRecord {
        let friction_path_j = self.friction_path_j(report, Some(profile));
        let surfaces: Vec<SurfaceWear> =
            [0, 1].into_iter().filter_map(|side| self.surface(side, friction_path_j, profile)).collect();
        let clearance_m = self.radii_m[0] - self.radii_m[1];
        let is_worn = friction_path_j > 0.0;
        let sector_m = self.radii_m[0] * std::f64::consts::TAU / self.sectors as f64;
        let checks = WearChecks {
            path_error: self
                .play
                .map(|_| if is_worn { profile.total_j / friction_path_j - 1.0 } else { profile.total_j }),
            widest_patch_sectors: 2.0 * profile.widest_m / sector_m,
            capped_share: if profile.total_j > 0.0 { profile.capped_j / profile.total_j } else { 0.0 },
            depth_over_clearance: surfaces.iter().map(|surface| surface.greatest_depth_m).sum::<f64>() / clearance_m,
        };
        let joint = name.to_owned();
        JointWearRecord {
            joint,
            cycles: self.cycles,
            friction_path_j,
            radial_clearance_m: clearance_m,
            surfaces,
            checks,
        }
    }
}

impl WearRecorder {
    /// The wear of all joints after all cycles.
    ///
    /// # Errors
    /// [`RunFailure::WearNotFinite`].
    pub fn records(&self, mechanism: &Mechanism, report: &RunReport) -> Result<Vec<JointWearRecord>, RunFailure> {
        let name = |joint: JointId| mechanism.model.joints[joint.0].name.as_str();
        let joints = self.joints.iter().zip(&self.profiles).enumerate();
        let records = joints.map(|(index, (joint, profile))| {
            let name = name(joint.joint);
            let record = match &self.life {
                Some(life) => joint.worn_record(name, index, life),
                None => joint.record(name, report, profile),
            };
            let surfaces = record.surfaces.iter();
            let is_finite = surfaces
                .clone()
                .all(|own| own.volume_m3.is_finite() && own.depth_m.iter().all(|depth| depth.is_finite()));
            if is_finite { Ok(record) } else { Err(RunFailure::WearNotFinite { joint: name.to_owned() }) }
        });
        records.collect()
    }

    /// A measure of the wear of a joint after all cycles, SI; NaN if it is not known.
    pub fn value(&self, joint: JointId, measure: WearMeasure, report: &RunReport) -> f64 {
        let Some(place) = self.joints.iter().position(|own| own.joint == joint) else { return f64::NAN };
        match &self.life {
            Some(life) => self.worn_value(life, place, measure),
            None => unworn_value(&self.joints[place], measure, report, &self.profiles[place]),
        }
    }

    fn worn_value(&self, life: &Life, place: usize, measure: WearMeasure) -> f64 {
        let joint = &self.joints[place];
        let end = life.last();
        let path_j = life.paths_j[place] / end.cycles;
        let greatest_m = |side: usize| end.depths_m[place][side].iter().copied().fold(0.0, f64::max);
        match measure {
            WearMeasure::FrictionPath => path_j,
            WearMeasure::BearingVolume => joint.volume_m3(0, path_j),
            WearMeasure::JournalVolume => joint.volume_m3(1, path_j),
            WearMeasure::BearingDepth => greatest_m(0),
            WearMeasure::JournalDepth => greatest_m(1),
            WearMeasure::Clearance => end.cycle.clearances_m[place][1],
            WearMeasure::Life => {
                let (column, limit_si) = self.limit.unwrap_or((0, f64::NAN));
                // A life that does not end counts as all cycles: it is at least that.
                life.until(column, limit_si).map_or(end.cycles, |(cycles, _)| cycles)
            }
        }
    }
}

/// A measure with the unworn geometry.
fn unworn_value(joint: &WearingJoint, measure: WearMeasure, report: &RunReport, profile: &WearProfile) -> f64 {
    let path_j = || joint.friction_path_j(report, Some(profile));
    let greatest_m = |side: usize| joint.depths_m(side, profile).into_iter().fold(0.0, f64::max);
    match measure {
        WearMeasure::FrictionPath => path_j(),
        WearMeasure::BearingVolume => joint.volume_m3(0, path_j()),
        WearMeasure::JournalVolume => joint.volume_m3(1, path_j()),
        WearMeasure::BearingDepth => greatest_m(0),
        WearMeasure::JournalDepth => greatest_m(1),
        // Refused where the model is read.
        WearMeasure::Clearance | WearMeasure::Life => f64::NAN,
    }
}

/// `wear.csv`: depths of all sectors of all surfaces, one sector a row; absent where no joint wears.
pub fn wear_csv(records: &[JointWearRecord]) -> Option<String> {
    if records.is_empty() {
        return None;
    }
    let mut text = String::from("joint,surface,sector,from_rad,to_rad,depth_m\n");
    for (record, surface) in records.iter().flat_map(|record| record.surfaces.iter().map(move |own| (record, own))) {
        let width_rad = std::f64::consts::TAU / surface.depth_m.len() as f64;
        for (sector, depth_m) in surface.depth_m.iter().enumerate() {
            let [from_rad, to_rad] = [sector, sector + 1].map(|edge| edge as f64 * width_rad);
            let (joint, word) = (&record.joint, surface.surface.word());
            let _ = writeln!(text, "{joint},{word},{sector},{from_rad:?},{to_rad:?},{depth_m:?}");
        }
    }
    Some(text)
}
