//! Reads of a DXF file what a sketch needs: the unit, and lines, polylines and circles with their layers.
//!
//! A DXF file, as text or binary, is a sequence of groups: a code, and a value whose type the code tells. Groups of code 0
//! begin sections and entities. Everything else that a file holds (tables, blocks, objects, text in any code page) is passed
//! over, so versions differ in nothing that is read here but in the width of binary codes.
//!
//! Source: Autodesk, AutoCAD DXF Reference 2024; of the text of R12, "Drawing Interchange and File Formats, Release 12".

mod binary;
mod entity;
mod error;
mod group;
mod groups;
mod text;

pub(super) use entity::{Entity, Shape, Vertex};
pub(super) use error::DxfError;

use error::DxfProblem;
use groups::Groups;

/// The entities of a DXF file that a sketch needs.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// $INSUNITS: the number of the unit; 0 where it is not set.
    pub insertion_unit: i64,
    /// The entities of the section ENTITIES, in the order of the file. Those inside of blocks are not among them.
    pub entities: Vec<Entity>,
}

impl Drawing {
    /// Reads a file.
    pub fn read(bytes: &[u8]) -> Result<Self, DxfError> {
        let mut groups = Groups::of(bytes);
        let mut drawing = Drawing::default();
        while let Some(group) = groups.next()? {
            match (group.code, group.text()) {
                (0, "EOF") => break,
                (0, "SECTION") => {
                    let place = group.place;
                    match groups.next()?.filter(|name| name.code == 2) {
                        Some(name) => drawing.read_section(name.text(), &mut groups)?,
                        None => return Err(place.error(DxfProblem::NamelessSection)),
                    }
                }
                _ => return Err(group.place.error(DxfProblem::NoSection { code: group.code })),
            }
        }
        Ok(drawing)
    }

    fn read_section(&mut self, name: &str, groups: &mut Groups) -> Result<(), DxfError> {
        match name {
            "HEADER" => {
                let mut variable = String::new();
                while let Some(group) = groups.next_in_section(name)? {
                    match group.code {
                        9 => variable = group.text().to_owned(),
                        70 if variable == "$INSUNITS" => self.insertion_unit = group.integer()?,
                        _ => {}
                    }
                }
            }
            "ENTITIES" => self.entities.extend(entity::read(groups, name)?),
            _ => while groups.next_in_section(name)?.is_some() {},
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
