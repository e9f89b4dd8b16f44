//! Contacts between pin and hole.

use super::reader::{ModelReader, UNREAD};
use crate::contact::{FILM_LAWS, FRICTION_LAWS, LinearLaw, NormalDescription, POINT_LAWS, PointLaw};
use crate::contact::{friction_law, point_law};
use crate::model::ids::ContactId;
use crate::model::keys::friction::FRICTION_KEYS;
use crate::model::keys::{CONTACT_KEYS, FILM_KEYS, POISSON_RATIO, YOUNGS_MODULUS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::{Origin, QuantityId};
use crate::model::topology::{Contact, Friction, Lubrication, SlidingVelocity, Stiffness};
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::units::{Dimension, Rule};

/// The law where the file names none: that of the source paper. Long pins have another one (`default_law.rs`).
pub(super) const DEFAULT_LAW: &str = "lankarani-nikravesh";
/// v_min where the file gives none (our choice), m/s.
const MINIMUM_IMPACT_SPEED_M_S: f64 = 1e-3;
/// The friction law where the file names none.
const DEFAULT_FRICTION_LAW: &str = "ambrosio";
/// The film where the file names none: the one that measured and computed bearings come nearest to.
const DEFAULT_FILM_LAW: &str = "reynolds";

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
        if let Some(law) = law {
            self.refuse_keys_of_other_laws(table, law);
        }
        let has_given_damping = matches!(law, Some(NormalDescription::Linear(law)) if law.has_given_damping());
        let restitution = if has_given_damping || !self.reader.demand(table, "restitution") {
            None
        } else {
            Some(self.quantity(table, "restitution").unwrap_or(UNREAD))
        };
        let damping_coefficient_n_s_m = if has_given_damping && self.reader.demand(table, "damping_coefficient") {
            Some(self.quantity(table, "damping_coefficient").unwrap_or(UNREAD))
        } else {
            None
        };
        let stiffness = match law {
            Some(NormalDescription::Linear(law)) => self.linear_stiffness(table, law),
            Some(NormalDescription::Line(_)) => self.material_stiffness(table),
            _ => self.stiffness(table),
        };
        let damping = self.damping(table, law);
        let line_damping = damping.flatten().filter(|_| table.has("damping"));
        let minimum_impact_speed_m_s = self.quantity_or(table, "minimum_impact_speed", MINIMUM_IMPACT_SPEED_M_S);
        let density_kg_m3 = self.quantity(table, "density");
        let friction = table.get("friction").and_then(|entry| self.friction(&entry, &FRICTION_KEYS));
        let film = table.get("film").map(|entry| self.film(&entry));
        Some(Contact {
            name: name.to_owned(),
            law: law?,
            is_law_named: table.has("law"),
            damping: damping?,
            line_damping,
            restitution,
            stiffness: stiffness?,
            damping_coefficient_n_s_m,
            minimum_impact_speed_m_s: minimum_impact_speed_m_s?,
            density_kg_m3,
            friction,
            film: film.map_or(Some(None), |film| film.map(Some))?,
            is_missing: false,
        })
    }

    fn law(&mut self, table: &Table<'_>) -> Option<NormalDescription> {
        let laws: Vec<_> = NormalDescription::all().map(|law| (law.name(), law)).collect();
        self.choice_or(table, "law", &laws, NormalDescription::Point(point_law(DEFAULT_LAW)?))
    }

    /// The law whose χ is the energy loss; the outer option is absent after a complaint.
    fn damping(&mut self, table: &Table<'_>, law: Option<NormalDescription>) -> Option<Option<&'static PointLaw>> {
        match law? {
            NormalDescription::Point(law) => Some(Some(law)),
            NormalDescription::Linear(_) => Some(None),
            NormalDescription::Line(law) => {
                let laws: Vec<_> = POINT_LAWS.iter().map(|law| (law.name, law)).collect();
                self.choice_or(table, "damping", &laws, point_law(law.default_damping)?).map(Some)
            }
        }
    }

    /// Complains about keys that mean nothing beside the law.
    fn refuse_keys_of_other_laws(&mut self, table: &Table<'_>, law: NormalDescription) {
        let materials = YOUNGS_MODULUS.into_iter().chain(POISSON_RATIO);
        let refused: Vec<&'static str> = match law {
            NormalDescription::Point(_) => vec!["damping", "damping_coefficient"],
            NormalDescription::Line(_) => vec!["stiffness", "exponent", "damping_coefficient"],
            NormalDescription::Linear(law) => {
                let damping = if law.has_given_damping() { "restitution" } else { "damping_coefficient" };
                materials.chain(["exponent", "density", "damping", damping]).collect()
            }
        };
        for key in refused {
            self.refuse_beside(table, key, law.name());
        }
    }

    /// K of a linear law.
    fn linear_stiffness(&mut self, table: &Table<'_>, law: &'static LinearLaw) -> Option<Stiffness> {
        self.reader.demand(table, "stiffness").then_some(())?;
        let stiffness_n_m =
            self.quantity_of(&table.get("stiffness")?, Dimension::contact_stiffness(1.0), Rule::Positive)?;
        Some(Stiffness::Linear { law, stiffness_n_m })
    }

    /// The materials of a line contact.
    fn material_stiffness(&mut self, table: &Table<'_>) -> Option<Stiffness> {
        if !YOUNGS_MODULUS.iter().chain(&POISSON_RATIO).any(|key| table.has(key)) {
            self.reader.demand(table, YOUNGS_MODULUS[0]);
            self.reader.demand(table, POISSON_RATIO[0]);
            return None;
        }
        let youngs_modulus_pa = self.of_both_parts(table, YOUNGS_MODULUS);
        let poisson_ratio = self.of_both_parts(table, POISSON_RATIO);
        Some(Stiffness::Material { youngs_modulus_pa: youngs_modulus_pa?, poisson_ratio: poisson_ratio? })
    }

    fn stiffness(&mut self, table: &Table<'_>) -> Option<Stiffness> {
        let material = YOUNGS_MODULUS.iter().chain(&POISSON_RATIO).find(|key| table.has(key));
        let given = ["stiffness", "exponent"].into_iter().find(|key| table.has(key));
        match (material, given) {
            (Some(&material), Some(given)) => {
                let problem = ModelProblem::StiffnessTwice { entry: table.path.describe(), material, given };
                let span = table.get(given).map_or(table.span, |entry| entry.key_span);
                self.reader.refuse(&problem, span)
            }
            (None, None) => self.reader.refuse(&ModelProblem::NoStiffness { entry: table.path.describe() }, table.span),
            (Some(_), None) => self.material_stiffness(table),
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
                self.reader.refuse(&ModelProblem::MaterialTwice { entry, both, one }, span)
            }
            (true, None) => for_both.map(|id| [id, id]),
            (false, Some(one)) => {
                let missing: Vec<&'static str> = [bearing, journal].into_iter().filter(|key| !table.has(key)).collect();
                if missing.is_empty() {
                    return of_bearing.zip(of_journal).map(|(bearing, journal)| [bearing, journal]);
                }
                self.complain_of_missing(table, one, missing);
                None
            }
            (false, None) => {
                // The other material value is there, or we would not be here.
                let [key, missing] =
                    if both == YOUNGS_MODULUS[0] { [POISSON_RATIO, keys] } else { [YOUNGS_MODULUS, keys] };
                let key = key.into_iter().find(|key| table.has(key)).unwrap_or(key[0]);
                self.complain_of_missing(table, key, vec![missing[0]]);
                None
            }
        }
    }

    fn given_stiffness(&mut self, table: &Table<'_>) -> Option<Stiffness> {
        for (key, needs) in [("stiffness", "exponent"), ("exponent", "stiffness")] {
            if !table.has(needs) {
                let problem = ModelProblem::NeedsKeys { entry: table.path.describe(), key, needs: vec![needs] };
                return self.reader.refuse(&problem, table.span);
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

    /// Reads a friction law with its numbers.
    pub(super) fn friction(&mut self, entry: &Entry<'_>, keys: &'static Keys) -> Option<Friction> {
        let table = self.reader.table(entry, keys)?;
        let laws: Vec<_> = FRICTION_LAWS.iter().map(|law| (law.name, law)).collect();
        let law = self.choice_or(&table, "law", &laws, friction_law(DEFAULT_FRICTION_LAW)?);
        let has_readings = keys.find("sliding_velocity").is_some();
        let sliding_velocity = if has_readings {
            let readings = [("material", SlidingVelocity::Material), ("literal", SlidingVelocity::Literal)];
            self.choice_or(&table, "sliding_velocity", &readings, SlidingVelocity::Material)
        } else {
            Some(SlidingVelocity::Material)
        };
        let Some(law) = law else {
            // What is wrong with the numbers is said nevertheless.
            for key in keys.keys {
                self.quantity(&table, key.name);
            }
            return None;
        };
        for key in keys.keys.iter().filter(|key| table.due_quantity(key.name).is_some()) {
            if law.numbers.iter().all(|number| number.name() != key.name) {
                self.refuse_beside(&table, key.name, law.name);
            }
        }
        let numbers = law.numbers.iter().map(|number| match number.default_si {
            Some(default_si) => self.quantity_or(&table, number.name(), default_si),
            None => {
                let key = number.name();
                self.reader.demand(&table, key).then(|| self.quantity(&table, key)).flatten()
            }
        });
        // All of them are read, so that all complaints come together.
        let numbers: Vec<Option<QuantityId>> = numbers.collect();
        if let Some(keys) = law.below {
            let place = |key: &str| law.numbers.iter().position(|number| number.name() == key);
            let [smaller, larger] = keys.map(|key| place(key).and_then(|place| numbers[place]));
            let written = keys.into_iter().find_map(|key| table.get(key));
            let span = written.map_or(table.span, |entry| entry.span);
            self.demand_order(smaller?, larger?, span).then_some(())?;
        }
        let numbers = numbers.into_iter().collect::<Option<Vec<QuantityId>>>()?;
        Some(Friction { law, numbers, sliding_velocity: sliding_velocity? })
    }

    fn film(&mut self, entry: &Entry<'_>) -> Option<Lubrication> {
        let table = self.reader.table(entry, &FILM_KEYS)?;
        let laws: Vec<_> = FILM_LAWS.iter().map(|law| (law.name, law)).collect();
        let default = FILM_LAWS.iter().find(|law| law.name == DEFAULT_FILM_LAW)?;
        let law = self.choice_or(&table, "law", &laws, default);
        let viscosity_pa_s = self.quantity(&table, "viscosity");
        let roughness_m = self.quantity(&table, "roughness");
        Some(Lubrication { law: law?, viscosity_pa_s: viscosity_pa_s?, roughness_m: roughness_m? })
    }
}
