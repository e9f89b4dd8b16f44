//! Which lines are one link, and where links are joined.

use std::collections::BTreeSet;

use super::error::ImportError;
use super::sketch::{Point, Shape, Sketch, distance};

/// The links and joints of a sketch.
#[derive(Debug)]
pub(super) struct Links {
    /// The links that move.
    pub links: Vec<Link>,
    /// Meaning of each circle, in the order of the drawing.
    pub meetings: Vec<Meeting>,
}

/// A link: a body of the model.
#[derive(Debug)]
pub(super) struct Link {
    /// All vertices of its lines.
    pub vertices: Vec<Point>,
    /// The circles that it meets, in the order of the drawing.
    pub circles: Vec<usize>,
}

/// Links that meet in a circle.
#[derive(Debug)]
pub(super) struct Meeting {
    /// Whether the circle stands in the ground.
    pub on_ground: bool,
    /// The links, in the order of the drawing.
    pub links: Vec<usize>,
}

impl Meeting {
    /// Whether it is a joint, and not a mere point of a link.
    pub fn is_joint(&self) -> bool {
        self.on_ground || self.links.len() > 1
    }
}

impl Links {
    /// Finds links and joints.
    pub fn new(sketch: &Sketch) -> Result<Self, ImportError> {
        for (index, circle) in sketch.circles.iter().enumerate() {
            if sketch.circles[..index].iter().any(|other| sketch.is_same(other.centre, circle.centre)) {
                return Err(ImportError::TwoCircles { place: sketch.place(circle.centre) });
            }
        }
        let link_of = link_of_shapes(sketch);
        let count = link_of.iter().flatten().map(|link| link + 1).max().unwrap_or(0);
        let mut links: Vec<Link> = (0..count).map(|_| Link { vertices: Vec::new(), circles: Vec::new() }).collect();
        for (shape, link) in sketch.shapes.iter().zip(&link_of) {
            if let Some(link) = link {
                links[*link].vertices.extend(&shape.vertices);
            }
        }
        let mut meetings = Vec::with_capacity(sketch.circles.len());
        for (index, circle) in sketch.circles.iter().enumerate() {
            let met = || {
                let shapes = sketch.shapes.iter().zip(&link_of);
                shapes.filter(|(shape, _)| meets(shape, circle.centre, sketch.tolerance)).map(|(_, link)| *link)
            };
            let of_links: BTreeSet<usize> = met().flatten().collect();
            if of_links.is_empty() {
                return Err(ImportError::LooseCircle { place: sketch.place(circle.centre) });
            }
            for &link in &of_links {
                links[link].circles.push(index);
            }
            let on_ground = circle.on_ground || met().any(|link| link.is_none());
            meetings.push(Meeting { on_ground, links: of_links.into_iter().collect() });
        }
        if let Some(loose) = links.iter().find(|link| link.circles.is_empty()) {
            return Err(ImportError::LooseLink { place: sketch.place(loose.vertices[0]) });
        }
        if !meetings.iter().any(|meeting| meeting.on_ground) {
            return Err(ImportError::NoGround);
        }
        Ok(Self { links, meetings })
    }
}

/// The link of each shape, numbered in the order of the drawing; `None` for shapes of the ground.
fn link_of_shapes(sketch: &Sketch) -> Vec<Option<usize>> {
    let count = sketch.shapes.len();
    // Each shape knows an earlier one of its link, the first of them itself.
    let mut earlier: Vec<usize> = (0..count).collect();
    let first = |earlier: &[usize], mut shape: usize| {
        while earlier[shape] != shape {
            shape = earlier[shape];
        }
        shape
    };
    let is_joined = |point: Point| sketch.circles.iter().any(|circle| sketch.is_same(circle.centre, point));
    for a in 0..count {
        for b in 0..a {
            let (one, other) = (&sketch.shapes[a], &sketch.shapes[b]);
            if one.on_ground || other.on_ground {
                continue;
            }
            let shared = ends(one)
                .into_iter()
                .find(|end| ends(other).iter().any(|other| sketch.is_same(*end, *other)) && !is_joined(*end));
            if shared.is_some() {
                let (one, other) = (first(&earlier, a), first(&earlier, b));
                earlier[one.max(other)] = one.min(other);
            }
        }
    }
    let mut numbers = vec![None; count];
    let mut next = 0;
    for shape in 0..count {
        if sketch.shapes[shape].on_ground {
            continue;
        }
        let root = first(&earlier, shape);
        if numbers[root].is_none() {
            numbers[root] = Some(next);
            next += 1;
        }
        numbers[shape] = numbers[root];
    }
    numbers
}

fn ends(shape: &Shape) -> [Point; 2] {
    [shape.vertices[0], shape.vertices[shape.vertices.len() - 1]]
}

/// Whether a point lies on a shape.
fn meets(shape: &Shape, point: Point, tolerance: f64) -> bool {
    shape.vertices.windows(2).any(|pair| {
        let [from, to] = [pair[0], pair[1]];
        let length = distance(from, to);
        let along = if length > 0.0 {
            ((point[0] - from[0]) * (to[0] - from[0]) + (point[1] - from[1]) * (to[1] - from[1])) / (length * length)
        } else {
            0.0
        };
        let along = along.clamp(0.0, 1.0);
        let foot = [from[0] + along * (to[0] - from[0]), from[1] + along * (to[1] - from[1])];
        distance(foot, point) <= tolerance
    })
}
