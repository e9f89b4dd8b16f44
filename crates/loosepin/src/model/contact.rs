//! Contacts between pin and hole.

use super::file::{ModelReader, UNREAD};
use super::keys::{CONTACT_KEYS, FRICTION_KEYS, POISSON_RATIO, YOUNGS_MODULUS};
use super::problem::ModelProblem;
use super::quantity::{Origin, QuantityId};
use super::topology::{Contact, ContactId, Friction, SlidingVelocity, Stiffness};
use crate::contact::{FRICTION_LAWS, FrictionDescription, POINT_LAWS, PointLaw, friction_law};
use crate::document::{Entry, Table};
use crate::units::{Dimension, Rule};

/// The law where the file names none: that of the source paper.
const DEFAULT_LAW: &str = "lankarani-nikravesh";
/// v_min where the file gives none (method, section 2), m/s.
const MINIMUM_IMPACT_SPEED_M_S: f64 = 1e-3;
/// The friction law where the file names none.
const DEFAULT_FRICTION_LAW: &str = "ambrosio";

impl ModelReader {
    /// Reads the table of contacts.
    pub fn read_contacts(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a contact") {
            self.remember(&entry);
            let contact = self.reader.table(&entry, &CONTACT_KEYS).and_then(|table| self.contact(entry.name, &table));
            let id = contact.map(|contact| {
                self.contacts.push(contact);
                ContactId(self.contacts.len() - 1)
            });
            self.contact_names.push((entry.name.to_owned(), id));
        }
    }

    fn contact(&mut self, name: &str, table: &Table<'_>) -> Option<Contact> {
        let law = self.law(table);
        let restitution = self.quantity(table, "restitution").unwrap_or(UNREAD);
        let stiffness = self.stiffness(table);
        let minimum_impact_speed_m_s = self.quantity_or(table, "minimum_impact_speed", MINIMUM_IMPACT_SPEED_M_S);
        let density_kg_m3 = self.quantity(table, "density");
        let friction = table.get("friction").and_then(|entry| self.friction(&entry));
        Some(Contact {
            name: name.to_owned(),
            law: law?,
            restitution,
            stiffness: stiffness?,
            minimum_impact_speed_m_s: minimum_impact_speed_m_s?,
            density_kg_m3,
            friction,
        })
    }

    fn law(&mut self, table: &Table<'_>) -> Option<&'static dyn PointLaw> {
        match table.get("law") {
            Some(entry) => {
                let choices: Vec<(&'static str, &'static dyn PointLaw)> =
                    POINT_LAWS.iter().map(|law| (law.name(), *law)).collect();
                self.reader.choice(&entry, &choices)
            }
            None => crate::contact::point_law(DEFAULT_LAW),
        }
    }

    fn stiffness(&mut self, table: &Table<'_>) -> Option<Stiffness> {
        let material = YOUNGS_MODULUS.iter().chain(&POISSON_RATIO).find(|key| table.has(key));
        let given = ["stiffness", "exponent"].into_iter().find(|key| table.has(key));
        match (material, given) {
            (Some(&material), Some(given)) => {
                let problem = ModelProblem::StiffnessTwice { entry: table.path.describe(), material, given };
                let span = table.get(given).map_or(table.span, |entry| entry.key_span);
                self.reader.complain(&problem, span);
                None
            }
            (None, None) => {
                self.reader.complain(&ModelProblem::NoStiffness { entry: table.path.describe() }, table.span);
                None
            }
            (Some(_), None) => {
                let youngs_modulus_pa = self.of_both_parts(table, YOUNGS_MODULUS);
                let poisson_ratio = self.of_both_parts(table, POISSON_RATIO);
                Some(Stiffness::Material { youngs_modulus_pa: youngs_modulus_pa?, poisson_ratio: poisson_ratio? })
            }
            (None, Some(_)) => self.given_stiffness(table),
        }
    }

    /// A material value for bearing and journal: one key for both, or one each.
    fn of_both_parts(&mut self, table: &Table<'_>, keys: [&'static str; 3]) -> Option<[QuantityId; 2]> {
        let [both, bearing, journal] = keys;
        let [for_both, of_bearing, of_journal] = keys.map(|key| self.quantity(table, key));
        let entry = table.path.describe();
        let one = [bearing, journal].into_iter().find(|key| table.has(key));
        match (table.has(both), one) {
            (true, Some(one)) => {
                let span = table.get(one).map_or(table.span, |entry| entry.key_span);
                self.reader.complain(&ModelProblem::MaterialTwice { entry, both, one }, span);
                None
            }
            (true, None) => for_both.map(|id| [id, id]),
            (false, Some(one)) => {
                let missing: Vec<&'static str> = [bearing, journal].into_iter().filter(|key| !table.has(key)).collect();
                if missing.is_empty() {
                    return of_bearing.zip(of_journal).map(|(bearing, journal)| [bearing, journal]);
                }
                self.reader.complain(&ModelProblem::NeedsKeys { entry, key: one, needs: missing }, table.span);
                None
            }
            (false, None) => {
                // The other material value is there, or we would not be here.
                let [key, missing] =
                    if both == YOUNGS_MODULUS[0] { [POISSON_RATIO, keys] } else { [YOUNGS_MODULUS, keys] };
                let key = key.into_iter().find(|key| table.has(key)).unwrap_or(key[0]);
                self.reader.complain(&ModelProblem::NeedsKeys { entry, key, needs: vec![missing[0]] }, table.span);
                None
            }
        }
    }

    fn given_stiffness(&mut self, table: &Table<'_>) -> Option<Stiffness> {
        for (key, needs) in [("stiffness", "exponent"), ("exponent", "stiffness")] {
            if !table.has(needs) {
                let problem = ModelProblem::NeedsKeys { entry: table.path.describe(), key, needs: vec![needs] };
                self.reader.complain(&problem, table.span);
                return None;
            }
        }
        let entry = table.get("exponent")?;
        let written = self.expression(&entry)?;
        if !self.reader.measures(&entry, written.dimension, Dimension::NUMBER) {
            return None;
        }
        // The exponent fixes the unit of the stiffness, so that neither a study nor a setting may move it.
        let exponent = self.add_with_origin(&entry, &written, Rule::AtLeastOne, Origin::Fixed)?;
        let dimension = Dimension::contact_stiffness(self.quantities.nominal_value(exponent));
        let stiffness_n_m_n = self.quantity_of(&table.get("stiffness")?, dimension, Rule::Positive)?;
        Some(Stiffness::Given { stiffness_n_m_n, exponent })
    }

    fn friction(&mut self, entry: &Entry<'_>) -> Option<Friction> {
        let table = self.reader.table(entry, &FRICTION_KEYS)?;
        let law = match table.get("law") {
            Some(entry) => {
                let choices: Vec<(&'static str, &'static FrictionDescription)> =
                    FRICTION_LAWS.iter().map(|law| (law.name, law)).collect();
                self.reader.choice(&entry, &choices)
            }
            None => friction_law(DEFAULT_FRICTION_LAW),
        };
        let sliding_velocity = match table.get("sliding_velocity") {
            Some(entry) => {
                let readings = [("material", SlidingVelocity::Material), ("literal", SlidingVelocity::Literal)];
                self.reader.choice(&entry, &readings)
            }
            None => Some(SlidingVelocity::Material),
        };
        let Some(law) = law else {
            // What is wrong with the numbers is said nevertheless.
            for key in FRICTION_KEYS.keys {
                self.quantity(&table, key.name);
            }
            return None;
        };
        let numbers = law.numbers.iter().map(|number| match number.default_si {
            Some(default_si) => self.quantity_or(&table, number.key, default_si),
            None => self.quantity(&table, number.key),
        });
        // All of them are read, so that all complaints come together.
        let numbers: Vec<Option<QuantityId>> = numbers.collect();
        if let Some(keys) = law.below {
            let place = |key: &str| law.numbers.iter().position(|number| number.key == key);
            let [smaller, larger] = keys.map(|key| place(key).and_then(|place| numbers[place]));
            let written = keys.into_iter().find_map(|key| table.get(key));
            let span = written.map_or(table.span, |entry| entry.span);
            self.demand_order(smaller?, larger?, span).then_some(())?;
        }
        let numbers = numbers.into_iter().collect::<Option<Vec<QuantityId>>>()?;
        Some(Friction { law, numbers, sliding_velocity: sliding_velocity? })
    }
}
