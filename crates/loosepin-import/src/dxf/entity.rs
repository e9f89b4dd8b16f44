//! Lines, polylines and circles; everything else is one thing.

use super::error::{DxfError, DxfProblem};
use super::group::Group;
use super::groups::Groups;

/// x, y, z in the unit of the drawing. x and y are not numbers until they are read, z is 0 where it is left out.
pub(crate) type Vertex = [f64; 3];

const UNREAD: Vertex = [f64::NAN, f64::NAN, 0.0];

/// Flag of a polyline whose last vertex is joined to the first.
const CLOSED: i64 = 1;
/// Flags of polylines and meshes in space.
const SPATIAL: i64 = 8 | 16 | 64;
/// Sine of the angle between the planes of an entity and of the drawing, at most: round-off of the program that drew it.
const MAX_TILT: f64 = 1e-9;

/// An entity of a drawing.
#[derive(Debug)]
pub(crate) struct Entity {
    pub layer: String,
    pub shape: Shape,
    /// Normal of the plane in whose frame circles and flat polylines are written: the z axis, or against it where the entity
    /// was mirrored.
    extrusion: Vertex,
}

/// Kind and numbers of an entity.
#[derive(Debug)]
pub(crate) enum Shape {
    /// LINE, and 3DLINE of R10.
    Line([Vertex; 2]),
    /// POLYLINE with its VERTEX entities. Arcs between vertices (bulges) are taken as their chords.
    Polyline {
        vertices: Vec<Vertex>,
        is_closed: bool,
        /// Whether the vertices are written in the frame of the drawing.
        is_spatial: bool,
    },
    /// LWPOLYLINE, whose vertices have no height.
    FlatPolyline { vertices: Vec<Vertex>, is_closed: bool },
    /// CIRCLE.
    Circle { centre: Vertex, radius: f64 },
    /// Anything else.
    Other,
}

impl Entity {
    fn new(name: &str) -> Self {
        let shape = match name {
            "LINE" | "3DLINE" => Shape::Line([UNREAD; 2]),
            "POLYLINE" => Shape::Polyline { vertices: Vec::new(), is_closed: false, is_spatial: false },
            "LWPOLYLINE" => Shape::FlatPolyline { vertices: Vec::new(), is_closed: false },
            "CIRCLE" => Shape::Circle { centre: UNREAD, radius: f64::NAN },
            _ => Shape::Other,
        };
        // Files of R10 leave out the layer where it is this one.
        Entity { layer: "0".to_owned(), shape, extrusion: [0.0, 0.0, 1.0] }
    }

    /// A vertex of the entity in the frame of the drawing; `None` if the plane of the entity is tilted.
    ///
    /// Source: DXF Reference, "Object Coordinate Systems": of the plane with the normal -z, the x axis is the -x axis of the
    /// drawing.
    pub fn in_drawing(&self, vertex: Vertex) -> Option<Vertex> {
        let [x, y, z] = vertex;
        match (&self.shape, self.extrusion) {
            (Shape::Line(_) | Shape::Polyline { is_spatial: true, .. }, _) => Some(vertex),
            (_, [nx, ny, nz]) if nx.abs() + ny.abs() <= MAX_TILT * nz.abs() => {
                Some(if nz > 0.0 { vertex } else { [-x, y, -z] })
            }
            _ => None,
        }
    }

    /// Takes over a group of the entity itself.
    fn take(&mut self, group: &Group) -> Result<(), DxfError> {
        let code = group.code;
        match &mut self.shape {
            _ if code == 8 => self.layer = group.text().to_owned(),
            _ if matches!(code, 210 | 220 | 230) => self.extrusion[code as usize / 10 - 21] = group.real()?,
            Shape::Line(ends) => match code {
                10 | 20 | 30 => take_coordinate(&mut ends[0], group)?,
                11 | 21 | 31 => take_coordinate(&mut ends[1], group)?,
                _ => {}
            },
            Shape::Circle { centre, radius } => match code {
                10 | 20 | 30 => take_coordinate(centre, group)?,
                40 => *radius = group.real()?,
                _ => {}
            },
            Shape::Polyline { is_closed, is_spatial, .. } if code == 70 => {
                *is_closed = group.integer()? & CLOSED != 0;
                *is_spatial = group.integer()? & SPATIAL != 0;
            }
            Shape::FlatPolyline { vertices, is_closed } => match code {
                10 => vertices.push([group.real()?, f64::NAN, 0.0]),
                20 => take_coordinate(last_vertex(vertices, group)?, group)?,
                70 => *is_closed = group.integer()? & CLOSED != 0,
                _ => {}
            },
            Shape::Polyline { .. } | Shape::Other => {}
        }
        Ok(())
    }
}

/// 10, 20, 30 are x, y, z of a first point; 11, 21, 31 of a second one.
fn take_coordinate(vertex: &mut Vertex, group: &Group) -> Result<(), DxfError> {
    vertex[group.code as usize / 10 - 1] = group.real()?;
    Ok(())
}

fn last_vertex<'v>(vertices: &'v mut [Vertex], group: &Group) -> Result<&'v mut Vertex, DxfError> {
    vertices.last_mut().ok_or_else(|| group.place.error(DxfProblem::NoVertex { code: group.code }))
}

/// To what the groups that come next belong.
enum Owner {
    Entity,
    /// A vertex of the last entity, a POLYLINE.
    Vertex,
    /// A part of the last entity that nothing is asked of: SEQEND, or an attribute of a block.
    Part,
}

/// Reads the section of entities to its end.
pub(super) fn read(groups: &mut Groups, section: &str) -> Result<Vec<Entity>, DxfError> {
    let mut entities: Vec<Entity> = Vec::new();
    let mut owner = Owner::Entity;
    // Between 102 {NAME and 102 } stand groups of other programs, with codes that mean something to them.
    let mut is_foreign = false;
    while let Some(group) = groups.next_in_section(section)? {
        if group.code == 102 {
            is_foreign = group.text().starts_with('{');
        } else if group.code == 0 {
            is_foreign = false;
            owner = match (group.text(), entities.last_mut().map(|entity| &mut entity.shape)) {
                ("VERTEX", Some(Shape::Polyline { vertices, .. })) => {
                    vertices.push(UNREAD);
                    Owner::Vertex
                }
                ("SEQEND" | "ATTRIB", Some(_)) => Owner::Part,
                (name, _) => {
                    entities.push(Entity::new(name));
                    Owner::Entity
                }
            };
        } else if !is_foreign {
            let Some(entity) = entities.last_mut() else {
                return Err(group.place.error(DxfProblem::NoEntity { code: group.code }));
            };
            match (&owner, &mut entity.shape) {
                (Owner::Entity, _) => entity.take(&group)?,
                (Owner::Vertex, Shape::Polyline { vertices, .. }) if matches!(group.code, 10 | 20 | 30) => {
                    take_coordinate(last_vertex(vertices, &group)?, &group)?;
                }
                (Owner::Vertex | Owner::Part, _) => {}
            }
        }
    }
    Ok(entities)
}
