//! The lines and circles of a drawing, in its own unit.

use super::ImportOptions;
use super::dxf::{Drawing, Entity, Shape as Drawn, Vertex};
use super::error::ImportError;
use loosepin_text::units::{Dimension, format_number, parse_unit};

/// Layer of the parts that do not move.
const GROUND_LAYER: &str = "ground";

/// A point of the drawing, in its unit.
pub(super) type Point = [f64; 2];

/// A line or polyline.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    /// Its vertices; the first again at the end of a closed one.
    pub vertices: Vec<Point>,
    pub on_ground: bool,
}

/// A circle.
#[derive(Debug, Clone)]
pub(super) struct Circle {
    pub centre: Point,
    pub radius: f64,
    pub on_ground: bool,
}

/// Lines and circles of a drawing.
#[derive(Debug)]
pub(super) struct Sketch {
    /// Symbol of the unit.
    pub unit: String,
    /// Within this distance points coincide, in the unit of the drawing.
    pub tolerance: f64,
    pub shapes: Vec<Shape>,
    pub circles: Vec<Circle>,
    /// Entities of other kinds.
    pub ignored: usize,
}

impl Sketch {
    /// Reads a drawing.
    pub fn read(bytes: &[u8], options: &ImportOptions) -> Result<Self, ImportError> {
        let drawing = Drawing::read(bytes).map_err(|error| ImportError::NoDrawing { reason: error.to_string() })?;
        // A file without any section is read as a drawing without anything in it.
        if drawing.entities.is_empty() {
            return Err(ImportError::Nothing { what: "line, polyline or circle" });
        }
        let unit = match &options.unit {
            Some(text) => text.trim().to_owned(),
            None => unit_of(drawing.insertion_unit)?.to_owned(),
        };
        let metres = match parse_unit(&unit) {
            Ok(measured) if measured.dimension == Dimension::LENGTH => measured.value_si,
            _ => return Err(ImportError::NotAUnit { text: unit }),
        };
        let mut sketch = Sketch {
            unit,
            tolerance: options.tolerance_m / metres,
            shapes: Vec::new(),
            circles: Vec::new(),
            ignored: 0,
        };
        let mut height = None;
        for entity in &drawing.entities {
            let on_ground = entity.layer.eq_ignore_ascii_case(GROUND_LAYER);
            match &entity.shape {
                Drawn::Line(ends) => sketch.add_shape("line", ends, false, on_ground, &mut height)?,
                Drawn::Polyline { vertices, is_closed, .. } => {
                    let vertices = sketch.in_drawing("the polyline", entity, vertices)?;
                    sketch.add_shape("polyline", &vertices, *is_closed, on_ground, &mut height)?;
                }
                // Such a polyline lies in a plane of its own height, which is no part of its vertices.
                Drawn::FlatPolyline { vertices, is_closed } => {
                    let vertices = sketch.in_drawing("the polyline", entity, vertices)?;
                    sketch.add_shape("polyline", &vertices, *is_closed, on_ground, &mut None)?;
                }
                Drawn::Circle { centre, radius } => {
                    let centre = sketch.in_drawing("the circle", entity, &[*centre])?[0];
                    let centre = sketch.in_plane("the circle", centre, &mut height)?;
                    if !(*radius > 0.0 && radius.is_finite()) {
                        let place = sketch.place(centre);
                        return Err(ImportError::NoSize { what: "circle", place, size: "radius" });
                    }
                    sketch.circles.push(Circle { centre, radius: *radius, on_ground });
                }
                Drawn::Other => sketch.ignored += 1,
            }
        }
        if sketch.shapes.iter().all(|shape| shape.on_ground) {
            return Err(ImportError::Nothing { what: "line or polyline beside the ground" });
        }
        if sketch.circles.is_empty() {
            return Err(ImportError::Nothing { what: "circle" });
        }
        Ok(sketch)
    }

    /// Vertices of an entity, which may be written in a frame of its own, in the frame of the drawing.
    fn in_drawing(&self, what: &'static str, entity: &Entity, vertices: &[Vertex]) -> Result<Vec<Vertex>, ImportError> {
        let in_drawing = |vertex: &Vertex| {
            entity.in_drawing(*vertex).ok_or_else(|| {
                let place = self.place([vertex[0], vertex[1]]);
                ImportError::NotPlanar { what, place, why: "lies in a plane that is inclined to that of the drawing" }
            })
        };
        vertices.iter().map(in_drawing).collect()
    }

    fn add_shape(
        &mut self,
        what: &'static str,
        vertices: &[Vertex],
        is_closed: bool,
        on_ground: bool,
        height: &mut Option<f64>,
    ) -> Result<(), ImportError> {
        let flat = vertices.iter().map(|&vertex| self.in_plane("the vertex", vertex, height));
        let mut vertices = flat.collect::<Result<Vec<Point>, ImportError>>()?;
        let Some(&first) = vertices.first() else {
            self.ignored += 1;
            return Ok(());
        };
        if vertices.iter().all(|&vertex| distance(vertex, first) <= self.tolerance) {
            return Err(ImportError::NoSize { what, place: self.place(first), size: "length" });
        }
        if is_closed {
            vertices.push(first);
        }
        self.shapes.push(Shape { vertices, on_ground });
        Ok(())
    }

    /// The point in the plane of the sketch, which is that of its first point.
    fn in_plane(&self, what: &'static str, vertex: Vertex, height: &mut Option<f64>) -> Result<Point, ImportError> {
        let [x, y, z] = vertex;
        let place = || self.place([x, y]);
        if !vertex.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(ImportError::NotPlanar { what, place: place(), why: "has a coordinate that is not a number" });
        }
        let level = *height.get_or_insert(z);
        if (z - level).abs() > self.tolerance {
            let why = "does not lie in the plane of the others: its z differs";
            return Err(ImportError::NotPlanar { what, place: place(), why });
        }
        Ok([x, y])
    }

    /// A point in words: `(12, 30.5) mm`.
    pub fn place(&self, [x, y]: Point) -> String {
        format!("({}, {}) {}", format_number(x), format_number(y), self.unit)
    }

    /// Whether two points are the same within the tolerance.
    pub fn is_same(&self, a: Point, b: Point) -> bool {
        distance(a, b) <= self.tolerance
    }
}

/// Distance of two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// The units that $INSUNITS numbers from 0 (DXF Reference, "HEADER Section Group Codes"): the name, and the symbol where models
/// know the unit.
const INSERTION_UNITS: [(&str, Option<&str>); 25] = [
    ("Unitless", None),
    ("Inches", Some("in")),
    ("Feet", Some("ft")),
    ("Miles", None),
    ("Millimeters", Some("mm")),
    ("Centimeters", Some("cm")),
    ("Meters", Some("m")),
    ("Kilometers", Some("km")),
    ("Microinches", None),
    ("Mils", Some("mil")),
    ("Yards", None),
    ("Angstroms", None),
    ("Nanometers", Some("nm")),
    ("Microns", Some("um")),
    ("Decimeters", Some("dm")),
    ("Decameters", None),
    ("Hectometers", None),
    ("Gigameters", None),
    ("AstronomicalUnits", None),
    ("LightYears", None),
    ("Parsecs", None),
    ("USSurveyFeet", None),
    ("USSurveyInch", None),
    ("USSurveyYard", None),
    ("USSurveyMile", None),
];

fn unit_of(number: i64) -> Result<&'static str, ImportError> {
    if number == 0 {
        return Err(ImportError::NoUnit);
    }
    match usize::try_from(number).ok().and_then(|number| INSERTION_UNITS.get(number)) {
        Some((_, Some(symbol))) => Ok(symbol),
        Some((name, None)) => Err(ImportError::ForeignUnit { unit: (*name).to_owned() }),
        None => Err(ImportError::ForeignUnit { unit: format!("unit {number} of $INSUNITS") }),
    }
}
