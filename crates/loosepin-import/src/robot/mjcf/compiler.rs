//! `<compiler>`: how the numbers of a file are meant.

use crate::robot::problem::RobotProblem;
use crate::robot::xml::{Attribute, Element};
use loosepin_text::diagnostics::Diagnostics;

/// A turn of an Euler sequence: its axis, 0 for x, and whether the axis is that of the frame as the turns before left it.
pub(super) type EulerTurn = (usize, bool);

/// How the numbers of a file are meant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Compiler {
    /// Radians in the unit of angles.
    pub radians: f64,
    /// Turns of Euler angles, in their order.
    pub euler: [EulerTurn; 3],
    /// Where masses come from.
    pub masses: Masses,
}

/// Where masses come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Masses {
    /// `<inertial>` where there is one, else geoms.
    Either,
    /// Geoms alone.
    Geoms,
    /// `<inertial>` alone.
    Inertial,
}

impl Compiler {
    /// Reads all elements `<compiler>`: later ones add to the first.
    pub fn read(root: Element<'_>, notes: &mut Vec<String>) -> Result<Compiler, Diagnostics> {
        let degree = 1.0_f64.to_radians();
        let mut own = Compiler { radians: degree, euler: [(0, true), (1, true), (2, true)], masses: Masses::Either };
        for element in root.all("compiler") {
            if let Some(angle) = element.attribute("angle") {
                own.radians = chosen(&angle, "angle", &[("degree", degree), ("radian", 1.0)])?;
            }
            if let Some(sequence) = element.attribute("eulerseq") {
                own.euler = euler(&sequence)?;
            }
            if let Some(source) = element.attribute("inertiafromgeom") {
                let choices = [("auto", Masses::Either), ("true", Masses::Geoms), ("false", Masses::Inertial)];
                own.masses = chosen(&source, "inertiafromgeom", &choices)?;
            }
            if let Some(coordinate) = element.attribute("coordinate") {
                chosen(&coordinate, "coordinate", &[("local", ())])?;
            }
            if element.attribute("settotalmass").is_some() {
                notes.push("masses are as written: settotalmass is ignored".to_owned());
            }
        }
        Ok(own)
    }
}

/// What a word of an attribute stands for.
pub(super) fn chosen<T: Copy>(
    attribute: &Attribute<'_>,
    name: &'static str,
    choices: &[(&str, T)],
) -> Result<T, Diagnostics> {
    let found = choices.iter().find(|(word, _)| *word == attribute.text);
    found.map(|(_, value)| *value).ok_or_else(|| {
        attribute.error(&RobotProblem::Choice {
            element: attribute.of(),
            attribute: name,
            found: attribute.shown(),
            choices: choices.iter().map(|(word, _)| (*word).to_owned()).collect(),
        })
    })
}

fn euler(attribute: &Attribute<'_>) -> Result<[EulerTurn; 3], Diagnostics> {
    let turns: Option<Vec<EulerTurn>> = attribute
        .text
        .chars()
        .map(|letter| {
            let axis = "xyz".find(letter.to_ascii_lowercase())?;
            Some((axis, letter.is_ascii_lowercase()))
        })
        .collect();
    turns.and_then(|turns| <[EulerTurn; 3]>::try_from(turns).ok()).ok_or_else(|| {
        attribute.error(&RobotProblem::Choice {
            element: attribute.of(),
            attribute: "eulerseq",
            found: attribute.shown(),
            choices: vec![
                "three letters of xyz, which turn with the frame".to_owned(),
                "of XYZ, which stay".to_owned(),
            ],
        })
    })
}
