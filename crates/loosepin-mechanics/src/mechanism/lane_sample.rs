//! The numbers of several samples side by side, one a lane; and all numbers of a sample in a row.

use super::sample::Sample;
use loosepin_math::{Numbers, Real};

impl<T: Real> Numbers<T> for Sample<T> {
    type Plain = Sample<f64>;

    fn broadcast(plain: &Sample<f64>) -> Self {
        Self {
            ideal: Numbers::<T>::broadcast(&plain.ideal),
            real: Numbers::<T>::broadcast(&plain.real),
            plays: Numbers::<T>::broadcast(&plain.plays),
            contacts: plain.contacts.clone(),
            frictions: Numbers::<T>::broadcast(&plain.frictions),
            springs: Numbers::<T>::broadcast(&plain.springs),
            loads: Numbers::<T>::broadcast(&plain.loads),
            drives: Numbers::<T>::broadcast(&plain.drives),
            controls: Numbers::<T>::broadcast(&plain.controls),
            references: Numbers::<T>::broadcast(&plain.references),
            initial: plain.initial.clone(),
            offsets: plain.offsets.clone(),
            sections: plain.sections.clone(),
        }
    }

    /// Shows every number that the equations of motion use, those of the real tree, plays, springs, loads and drives, in an order that
    /// depends on the mechanism alone.
    ///
    /// The laws and the exponent of a contact are no numbers: they belong to the mechanism and are the same in all runs.
    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.real.visit(visit);
        self.plays.visit(visit);
        self.frictions.visit(visit);
        self.springs.visit(visit);
        self.loads.visit(visit);
        self.drives.visit(visit);
        self.controls.visit(visit);
        self.references.visit(visit);
    }
}

impl Sample<f64> {
    /// Every number that the equations of motion use, in the order of [`Numbers::visit`].
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.clone().visit(&mut |number| numbers.push(*number));
        numbers
    }
}
