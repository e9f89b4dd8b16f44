//! A film of oil between pin and hole.

use crate::contact::{FILM_LAWS, FilmDescription};
use crate::model::entry_reader::EntryReader;
use loosepin_text::document::{Choice, Entry, choice, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

impl Choice for &'static FilmDescription {
    fn choices() -> Vec<(&'static str, Self)> {
        FILM_LAWS.iter().map(|law| (law.name, law)).collect()
    }
}

record! {
    /// a film of oil between pin and hole
    pub(super) struct FilmTable for EntryReader;
    /// how the film pressure is calculated from the motion
    // Measured and computed bearings come nearest to that of Reynolds' equation.
    optional law: &'static FilmDescription = choice::<&'static FilmDescription>(), "\"reynolds\"", or "reynolds";
    /// dynamic viscosity of the oil
    required viscosity: QuantityId = quantity(D::VISCOSITY, Rule::Positive), "\"0.04 Pa s\"";
    /// film thickness below which the film does not become stiffer; outside the clearance, its force decreases to zero over the same
    /// distance
    required roughness: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"2 um\"";
}

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
    /// Reads it; `None` after a diagnostic.
    pub(super) fn read(entry: &Entry<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        let FilmTable { law, viscosity, roughness, .. } = FilmTable::read(reader, entry)?;
        Some(Self { law, viscosity_pa_s: viscosity, roughness_m: roughness })
    }
}
