//! A film of oil between pin and hole.

use crate::contact::{FILM_LAWS, FilmDescription};
use crate::model::entry_reader::EntryReader;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Entry, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

/// The film where the file names none: the one that measured and computed bearings come nearest to.
const DEFAULT_FILM_LAW: &str = "reynolds";

/// A film of oil between pin and hole.
#[derive(Debug, Clone)]
pub struct Lubrication {
    /// The film.
    pub law: &'static FilmDescription,
    /// Viscosity of the oil, Pa s, > 0.
    pub viscosity_pa_s: QuantityId,
    /// The thinnest film, m, > 0.
    pub roughness_m: QuantityId,
}

impl Lubrication {
    /// Reads it; `None` after a complaint.
    pub(super) fn read(entry: &Entry<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        let table = reader.document().table(entry, &FILM_KEYS)?;
        let laws: Vec<_> = FILM_LAWS.iter().map(|law| (law.name, law)).collect();
        let default = FILM_LAWS.iter().find(|law| law.name == DEFAULT_FILM_LAW)?;
        let law = reader.document().choice_or(&table, "law", &laws, default);
        let viscosity_pa_s = reader.quantity(&table, "viscosity");
        let roughness_m = reader.quantity(&table, "roughness");
        Some(Self { law: law?, viscosity_pa_s: viscosity_pa_s?, roughness_m: roughness_m? })
    }
}

fn film_law_names() -> Vec<&'static str> {
    FILM_LAWS.iter().map(|law| law.name).collect()
}

pub(super) static FILM_KEYS: Keys = Keys::new(
    "a film of oil between pin and hole",
    &[
        optional(
            "law",
            Kind::ChoiceOf(film_law_names),
            "\"reynolds\"",
            "how the pressure follows from the motion; reynolds if left out",
        ),
        required("viscosity", quantity(D::VISCOSITY, Rule::Positive), "\"0.04 Pa s\"", "dynamic viscosity of the oil"),
        required(
            "roughness",
            quantity(D::LENGTH, Rule::Positive),
            "\"2 um\"",
            "thickness below which the film no longer stiffens; beyond the clearance it fades over as much",
        ),
    ],
);
