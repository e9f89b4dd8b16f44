//! Extras of a run: the numbers that follow its columns in the sample table, for the report and `runs.parquet`.

/// Extras of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunExtras {
    /// Relative energy residual; NaN if the motion was not integrated.
    pub energy_residual: f64,
    /// Evaluations of the equations of motion.
    pub evaluations: f64,
    /// Accepted steps.
    pub steps: f64,
    /// Largest relative change of a pose over the last turn; NaN if no whole turn was recorded.
    pub change_over_last_turn: f64,
    /// One for each joint with play.
    pub joints: Vec<JointExtras>,
}

/// Extras of one joint with play.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointExtras {
    /// Contacts that began in the recorded turns.
    pub contacts: f64,
    /// Contacts that began slower than the floor of the law.
    pub floored: f64,
    /// Impacts faster than the law is meant for; NaN if its limit is unknown.
    pub beyond_validity: f64,
    /// Largest penetration, m.
    pub largest_penetration_m: f64,
    /// Largest normal force, N.
    pub peak_force_n: f64,
    /// Restitution as stated; NaN for a law without one.
    pub nominal_restitution: f64,
    /// Restitution that a free impact delivers; NaN if it depends on the masses that meet.
    pub delivered_restitution: f64,
    /// Largest penetration over the radial clearance of the run.
    pub largest_penetration_share: f64,
}

impl RunExtras {
    /// Numbers that are not of a joint.
    const COMMON: usize = 4;

    /// Numbers of a run with `joints` joints with play.
    pub fn count(joints: usize) -> usize {
        Self::COMMON + JointExtras::COUNT * joints
    }

    /// Appends the numbers to the columns in `row`.
    pub fn write(&self, row: &mut Vec<f64>) {
        row.reserve_exact(Self::count(self.joints.len()));
        row.extend([self.energy_residual, self.evaluations, self.steps, self.change_over_last_turn]);
        self.joints.iter().for_each(|joint| row.extend(joint.to_numbers()));
    }

    /// Extras at the end of `row`, of a run with `joints` joints with play.
    pub fn read(row: &[f64], joints: usize) -> Self {
        let (common, of_joints) = row[row.len() - Self::count(joints)..].split_at(Self::COMMON);
        Self {
            energy_residual: common[0],
            evaluations: common[1],
            steps: common[2],
            change_over_last_turn: common[3],
            joints: of_joints.as_chunks().0.iter().copied().map(JointExtras::from_numbers).collect(),
        }
    }
}

impl JointExtras {
    const COUNT: usize = 8;

    fn numbers(&mut self) -> [&mut f64; Self::COUNT] {
        [
            &mut self.contacts,
            &mut self.floored,
            &mut self.beyond_validity,
            &mut self.largest_penetration_m,
            &mut self.peak_force_n,
            &mut self.nominal_restitution,
            &mut self.delivered_restitution,
            &mut self.largest_penetration_share,
        ]
    }

    fn to_numbers(mut self) -> [f64; Self::COUNT] {
        self.numbers().map(|number| *number)
    }

    fn from_numbers(numbers: [f64; Self::COUNT]) -> Self {
        let mut joint = Self::default();
        joint.numbers().into_iter().zip(numbers).for_each(|(place, number)| *place = number);
        joint
    }
}

#[cfg(test)]
mod tests {
    use super::{JointExtras, RunExtras};

    #[test]
    fn identity_extras_are_read_back_behind_any_columns() {
        let joint = |first: f64| JointExtras {
            contacts: first,
            floored: first + 0.125,
            beyond_validity: first + 0.25,
            largest_penetration_m: first + 0.375,
            peak_force_n: first + 0.5,
            nominal_restitution: first + 0.625,
            delivered_restitution: first + 0.75,
            largest_penetration_share: first + 0.875,
        };
        let extras = RunExtras {
            energy_residual: 2.5,
            evaluations: 17.0,
            steps: 5.0,
            change_over_last_turn: 0.25,
            joints: vec![joint(7.0), joint(11.0)],
        };
        let mut row = vec![-1.0, f64::NAN, -3.0];
        extras.write(&mut row);
        assert_eq!(row.len(), 3 + RunExtras::count(2));
        assert_eq!(RunExtras::read(&row, 2), extras);
    }
}
