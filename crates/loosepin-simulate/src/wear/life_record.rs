//! A life of wear as a record and as tables.

use super::jumps::{Life, LifePoint};
use super::recorder::WearRecorder;
use crate::ideal::column::columns;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_result::simulation::{
    JointLifeRecord, LifeLimitRecord, OutputLifeRecord, SurfaceLifeRecord, WearLifeRecord, WornSurface,
};
use std::fmt::Write;

/// The surfaces, in the order of all pairs.
const SURFACES: [WornSurface; 2] = [WornSurface::Bearing, WornSurface::Journal];

impl WearRecorder {
    /// The life; `None` if the model holds the unworn shape.
    pub fn life_record(&self, mechanism: &Mechanism) -> Option<WearLifeRecord> {
        let life = self.life.as_ref()?;
        let columns = columns(&mechanism.model);
        let outputs = columns.iter().enumerate().map(|(index, column)| OutputLifeRecord {
            name: column.name.clone(),
            unit: column.unit.clone(),
            deviation_si: of_points(life, &|point| point.cycle.deviations_si[index]),
        });
        let limit = self.limit.map(|(index, limit_si)| {
            let until = life.until(index, limit_si);
            LifeLimitRecord {
                output: columns[index].name.clone(),
                unit: columns[index].unit.clone(),
                limit_si,
                cycles: until.map(|(cycles, _)| cycles),
                between: until.map(|(_, between)| between),
            }
        });
        Some(WearLifeRecord {
            cycles: of_points(life, &|point| point.cycles),
            joints: (0..self.joints.len()).map(|index| self.joint_life(mechanism, life, index)).collect(),
            outputs: outputs.collect(),
            limit,
            runs: life.runs,
            largest_error_m: life.largest_error_m,
            largest_noise_m: life.largest_noise_m,
            longest_over_stable: life.longest_over_stable,
        })
    }

    fn joint_life(&self, mechanism: &Mechanism, life: &Life, index: usize) -> JointLifeRecord {
        let joint = &self.joints[index];
        let greatest = |depths_m: &[f64]| depths_m.iter().copied().fold(0.0, f64::max);
        let first = &life.points[0].cycle;
        let surfaces = [0, 1].into_iter().filter(|side| joint.coefficients_m2_n[*side].is_some()).map(|side| {
            let area_m2 = joint.sector_area_m2(side);
            let volume = |point: &LifePoint| point.depths_m[index][side].iter().sum::<f64>() * area_m2;
            SurfaceLifeRecord {
                surface: SURFACES[side],
                volume_m3: of_points(life, &volume),
                greatest_depth_m: of_points(life, &|point| greatest(&point.depths_m[index][side])),
                depth_m: life.points.iter().map(|point| point.depths_m[index][side].clone()).collect(),
                first_order_volume_m3: joint.volume_m3(side, first.paths_j[index]),
                first_order_depth_m: joint.cycles * greatest(&first.growth_m[index][side]),
            }
        });
        JointLifeRecord {
            joint: mechanism.model.joints[joint.joint.0].name.clone(),
            friction_path_j: of_points(life, &|point| point.cycle.paths_j[index]),
            least_clearance_m: of_points(life, &|point| point.cycle.clearances_m[index][0]),
            largest_clearance_m: of_points(life, &|point| point.cycle.clearances_m[index][1]),
            surfaces: surfaces.collect(),
        }
    }
}

fn of_points(life: &Life, value: &dyn Fn(&LifePoint) -> f64) -> Vec<f64> {
    life.points.iter().map(value).collect()
}

/// `wear_life.csv`: friction paths, volumes, depths, clearances and deviations, one end of a jump a row.
pub fn wear_life_csv(record: &WearLifeRecord) -> String {
    let mut heads = vec!["cycles".to_owned()];
    let mut columns: Vec<&[f64]> = vec![&record.cycles];
    for joint in &record.joints {
        let name = &joint.joint;
        for (word, values) in [
            ("friction_path_j", &joint.friction_path_j),
            ("least_clearance_m", &joint.least_clearance_m),
            ("largest_clearance_m", &joint.largest_clearance_m),
        ] {
            heads.push(format!("{name}.{word}"));
            columns.push(values);
        }
        for surface in &joint.surfaces {
            for (word, values) in [("volume_m3", &surface.volume_m3), ("depth_m", &surface.greatest_depth_m)] {
                heads.push(format!("{name}.{}_{word}", surface.surface.word()));
                columns.push(values);
            }
        }
    }
    for output in &record.outputs {
        heads.push(format!("{} deviation [{}]", output.name, output.unit.symbol()));
        columns.push(&output.deviation_si);
    }
    let mut text = heads.join(",") + "\n";
    for row in 0..record.cycles.len() {
        let cells: Vec<String> = columns.iter().map(|column| format!("{:?}", column[row])).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// `wear_profiles.csv`: depths of all sectors over the cycles, one sector of one surface a row.
pub fn wear_profiles_csv(record: &WearLifeRecord) -> String {
    let cycles: Vec<String> = record.cycles.iter().map(|cycles| format!("depth_m after {cycles:?}")).collect();
    let mut text = format!("joint,surface,sector,{}\n", cycles.join(","));
    for joint in &record.joints {
        for surface in &joint.surfaces {
            let sectors = surface.depth_m.first().map_or(0, Vec::len);
            for sector in 0..sectors {
                let depths: Vec<String> =
                    surface.depth_m.iter().map(|depths_m| format!("{:?}", depths_m[sector])).collect();
                let _ = writeln!(text, "{},{},{sector},{}", joint.joint, surface.surface.word(), depths.join(","));
            }
        }
    }
    text
}
